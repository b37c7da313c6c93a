"""docs/implied.md shows what pdp8.replay.implied computes."""

import re
from pathlib import Path

import pytest

from pdp8.replay.implied import LINE_SECONDS, TABLES
from programs import circle
from programs.thesis import TABLE_10_1
from tapes import ascii

PAGE = (Path(__file__).parents[3] / "docs" / "implied.md").read_text()


def shown(name: str) -> list[list[str]]:
    """Return the cells of the table of that name, its two heading lines left out."""
    table = PAGE.split(f"<!-- {name} -->\n")[1].split("\n\n")[0].rstrip("\n")
    return [[cell.strip() for cell in line.strip("|").split("|")] for line in table.split("\n")[2:]]


SLOW = (pytest.mark.slow("the piece-wise technique tries every pair of feeds"),)
_PIECEWISE = ("rivals", "range", "feeds")


@pytest.mark.parametrize("name", [pytest.param(name, marks=SLOW * (name in _PIECEWISE)) for name in TABLES])
def test_a_table_is_what_is_computed(name: str) -> None:
    assert shown(name) == list(TABLES[name]())


def test_a_line_of_the_tape_takes_what_chapter_7_says_of_670() -> None:
    """30 minutes to punch 670 lines and 30 to translate them: 2.69 s; 27 frames of our tape are 2.7 s."""
    frames = ascii.encode(circle.part())
    assert len(frames) / frames.count(ascii.encode("\n")[:1]) / 10 == LINE_SECONDS
    assert round(670 * LINE_SECONDS / 60) == 30


def test_tape_times_explain_four_cells_and_estimates_two() -> None:
    """Table 10.1's own figures alone: minutes over blocks."""
    cells = [
        (said.blocks, said.minutes) for row in TABLE_10_1.values() for said in (row.step, row.piece) if said
    ]
    tape = [minutes for blocks, minutes in cells if round(blocks * LINE_SECONDS / 60) == minutes]
    guess = [minutes for blocks, minutes in cells if blocks * 3 == minutes * 60]
    assert tape == [30, 9, 18, 16]
    assert guess == [50, 40]


def test_two_ranges_are_within_2_percent() -> None:
    near = [x for x, _, off in shown("range") if abs(float(off.rstrip("%"))) <= 2]
    assert near == ["-0.5 to 6.5", "-0.75 to 6.25"]
    assert re.search(r"Two of the twelve are within 2 %", PAGE)
