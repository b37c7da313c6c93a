"""Claims of docs and pages that no other test holds, each computed again."""

import re
from collections.abc import Callable
from pathlib import Path

import pytest

import pal
import pdp8
from pdp8 import shelf
from pdp8.thesis import codes, tables, work
from pdp8.thesis.catalogue import catalogue, find
from pdp8.thesis.inputs import FITTED
from pdp8.thesis.numbers import numbers
from tapes import ascii, eia, frames

ROOT = Path(__file__).parents[3]


def test_the_page_s_rule_of_the_eia_digits_is_the_code_s() -> None:
    """A digit from 1 to 9 is its binary holes, channel 5 makes them odd; a zero is 040, a space 020."""
    for digit in range(1, 10):
        holes = {channel for channel in range(1, 5) if digit >> (channel - 1) & 1}
        assert set(frames.channels(eia.CODES[str(digit)])) == holes | ({5} if len(holes) % 2 == 0 else set())
    assert frames.channels(eia.CODES["0"]) == (6,)
    assert frames.channels(eia.CODES[" "]) == (5,)
    page = (ROOT / "pdp8/web/curve.html").read_text()
    assert (
        "with a hole in channel 5 where their number\nwould be even; a zero is one hole in channel 6." in page
    )


def test_the_instructions_between_two_characters_take_167_4_microseconds_at_most() -> None:
    """From a KRB, 0217, to the next KSF, 0215; the loop that waits for the punch counts once."""
    machine = pdp8.Machine()
    machine.load(pal.assemble(shelf.read_bundled("eia.pal")).words)
    machine.start(0o200)
    machine.teletype.reader.load(ascii.encode("0 1A\n", fill=0))
    times: list[int] = []
    spent, waits = None, False
    while len(times) < 5:
        place, before = machine.pc, machine.ticks
        machine.run(instructions=1)
        if place == 0o217:
            spent, waits = 0, False
        if spent is not None and place == 0o215:
            times.append(spent)
            spent = None
        elif spent is not None and place != 0o223 and not (place == 0o222 and waits):
            spent += machine.ticks - before
        waits = waits or place == 0o222
    assert max(times) / 20 == pytest.approx(167.4)
    assert "167.4 at most from a KRB to the next KSF" in (ROOT / "docs/errata.md").read_text()


def test_figures_whose_listing_gives_the_curve_do_not_guess_it() -> None:
    for sheet in (*work.polar_graphs(), *(work.part(**find(number).given) for number in ("7.1", "7.3"))):
        assert "</svg>" in sheet
        assert "guessed" not in sheet


@pytest.mark.parametrize("figure", [codes.digits, codes.drilled_block, codes.before_and_after])
def test_words_beside_a_tape_can_be_read_in_print(figure: Callable[[], str | list[str]]) -> None:
    """True in size: at least 6 points, .083 in, and less than the .1 in from row to row."""
    (size,) = set(re.findall(r"font: (\d+)px", "".join(figure())))
    assert 83 <= int(size) < 100


def test_an_item_that_shows_a_fitted_number_is_fitted() -> None:
    fitted = {one.by for one in numbers() if one.measure and one.state == FITTED}
    shown = [item for item in catalogue() if item.number in fitted]
    assert shown
    assert {item.state for item in shown} == {FITTED}


@pytest.mark.slow("cuts all parts of the table, by both techniques")
def test_the_headings_of_table_10_1_that_the_scan_has_lost_are_in_brackets() -> None:
    assert "[minutes in all], thesis" in tables.comparison().headings
