"""Every figure of docs/parts.md and docs/errata.md is what comes out."""

import re
import shlex
from collections.abc import Iterator
from functools import cache
from itertools import product
from math import atan2, degrees, sqrt
from pathlib import Path

import pytest
from click.testing import CliRunner

import nc
import pal
import pdp8
from nc.inspection import inspect
from pdp8.replay.implied import machined
from programs import arithmetic, circle
from programs.arithmetic import ARITHMETICS, FloatingPoint
from programs.cli import part
from programs.ellipse import part as ellipse
from tapes import ascii
from tapes.hydrapoint import XY_FEED

DOCS = Path(__file__).parents[2] / "docs"
PAGE = (DOCS / "parts.md").read_text()
ERRATA = (DOCS / "errata.md").read_text()


def rows(heading: str, columns: int | None = None) -> Iterator[list[str]]:
    """Yield the cells of each row, under `heading`, that has a command."""
    section = PAGE.split(f"## {heading}")[1].split("\n## ")[0]
    for line in section.split("\n"):
        cells = [cell.strip() for cell in line.strip("|").split("|")]
        if "`pdp8 part" in line and line.startswith("|") and columns in (None, len(cells)):
            yield cells


@cache
def printout(command: str) -> str:
    """Return the printout of a command of the page."""
    done = CliRunner().invoke(part, shlex.split(command.strip("`"))[2:])
    assert done.exit_code == 0, done.output
    return ascii.decode(done.stdout_bytes)


def count(command: str, *more: str) -> int:
    """Return the blocks that a command of the page makes, with more options."""
    return printout(" ".join([command.strip("`"), *more])).count("\n")


@pytest.mark.parametrize("row", list(rows("Blocks, the thesis's and ours", 7)), ids=lambda row: row[0])
def test_the_blocks_and_minutes_of_a_part(row: list[str]) -> None:
    _, command, _, blocks, _, minutes, _ = row
    assert count(command) == int(blocks)
    if minutes != "–":
        assert f"{machined(printout(command.strip('`'))).contour.total / 60:.1f}" == minutes


@pytest.mark.parametrize("row", list(rows("Blocks, the thesis's and ours", 3)), ids=lambda row: row[0])
def test_the_blocks_of_the_rule_to_stop_inside(row: list[str]) -> None:
    assert count(row[1]) == int(row[2])


def test_the_minutes_of_the_ellipse_at_the_slowest_feed() -> None:
    path = machined(printout("pdp8 part ellipse"), 1)
    assert f"code 01 gives {path.contour.total / 60:.1f}" in PAGE


def test_the_die_s_blocks_if_the_hole_is_6_by_3() -> None:
    assert count("pdp8 part die", "--major", "2.75", "--minor", "1.25") == 674
    assert "674 blocks" in PAGE


@pytest.mark.slow("the piece-wise technique tries every pair of feeds, three times a part")
@pytest.mark.parametrize("row", list(rows("The piece-wise technique")), ids=lambda row: row[0])
def test_the_blocks_and_minutes_of_the_piece_wise_technique(row: list[str]) -> None:
    counts = [count(row[1], "--feed-error", error) for error in ("20", "10", "0")]
    assert counts == [int(cell) for cell in row[3:6]]
    if row[7] != "–":
        path = machined(printout(f"{row[1].strip('`')} --feed-error 20"))
        assert f"{path.contour.total / 60:.1f}" == row[7]


def test_the_slowest_feed_alone() -> None:
    said = re.search(r"--fastest 1` makes (\d+) blocks", PAGE)
    assert said
    assert count("pdp8 part circle --technique piece", "--fastest", "1") == int(said[1])


class Thirty(FloatingPoint):
    """The GE-235's 30 bits and sign."""

    word = register = quotient = 30

    def cut(self, mantissa: int, bits: int) -> tuple[int, int]:
        return arithmetic._chopped(mantissa, bits)


class ThirtyRounded(Thirty):
    """The same, rounded."""

    def cut(self, mantissa: int, bits: int) -> tuple[int, int]:
        return arithmetic._nearest(mantissa, bits)


@pytest.mark.parametrize(("machine", "differing"), [(Thirty(), 9), (ThirtyRounded(), 0)])
def test_thirty_bits_change_no_count(machine: FloatingPoint, differing: int) -> None:
    exact, other = ellipse().splitlines(), ellipse(arithmetic=machine).splitlines()
    assert len(exact) == len(other) == 976
    assert sum(one != two for one, two in zip(exact, other, strict=True)) == differing
    if differing:
        assert other == ellipse(arithmetic=ARITHMETICS["ge635"]).splitlines()


def test_errata_the_centre_diameter() -> None:
    assert circle.part(radius=1875).count("\n") == 706
    assert "makes 706 blocks" in ERRATA


def test_errata_the_closest_ratio() -> None:
    ratios = {one / two for one, two in product(XY_FEED.values(), repeat=2)}
    closer = sorted(
        (ratio for ratio in ratios if abs(ratio - sqrt(3)) < 1.9 - sqrt(3)), key=lambda r: abs(r - sqrt(3))
    )
    assert closer[0] == XY_FEED[14] / XY_FEED[10] == 27.9 / 16.0
    assert "27.9/16.0 = 1.744, codes 14 and 10" in ERRATA
    assert f"{len(closer) - 1} ratios more are closer than 1.9" in ERRATA


def test_errata_the_deviation_at_45_degrees() -> None:
    angle = degrees(atan2(1.2, 0.8))
    assert (f"{angle:.1f}", f"{90 - angle:.1f}", f"{angle - 45:.1f}", f"{angle / 45 - 1:.0%}") == (
        "56.3",
        "33.7",
        "11.3",
        "25%",
    )
    assert "56.3° or 33.7°, which is 11.3° or 25 % off" in ERRATA


def test_errata_the_circle_does_not_close() -> None:
    def worst(path: nc.Path, place: str) -> float:
        found = [r.trough_to_peak for r in inspect(path).readings if r.place == place and r.wall == "outer"]
        return round(found[0] / 1000, 4)

    printed, closed = machined(circle.part()), machined(circle.part(close=True))
    assert round(printed.gap) == 156
    assert circle.part(close=True).splitlines()[-1] == "6676 2251 4000  185"
    assert (worst(printed, "-X apex"), worst(closed, "-X apex")) == (0.0173, 0.0068)
    assert round(inspect(closed).worst.trough_to_peak / 1000, 4) == 0.0106

    assert "ends .156 in short" in ERRATA


def test_errata_the_listings_overshoot() -> None:
    """The theory is .010: the limits lie .010 apart, and a cut stops at the first thousandth past one."""
    for printout, span in ((circle.part(close=True), "0.0106"), (ellipse(), "0.0110")):
        found = inspect(machined(printout))
        assert f"{found.worst.trough_to_peak / 1000:.4f}" == span
        assert span[1:] in ERRATA
        low, high = found.centre
        assert -6 < low < -5
        assert 5 < high < 6


def test_errata_the_ellipse_ends_short() -> None:
    """Its last block is at X .997 Y 3.900, its first cut starts at X 1.000 Y 4.000."""
    assert ellipse().splitlines()[-1] == "9766  997 3900  584"
    assert round(machined(ellipse()).gap) == 100
    assert "ends .100 in short" in ERRATA


def test_errata_the_minutes_of_circle_and_ellipse() -> None:
    times = ((circle.part(), None, 35.9), (ellipse(), None, 36.1), (ellipse(), 1, 53.2))
    for printout, code, minutes in times:
        assert round(machined(printout, code).contour.total / 60, 1) == minutes
        assert str(minutes) in ERRATA


def test_all_of_core_is_within_three_octal_digits() -> None:
    """Not an erratum: the nine bits after the operation hold the indirect bit."""
    words = pal.assemble("*200\n\tTAD I 177\n*177\n\t7777\n$\n").words
    assert (words[0o200] & 0o7000, words[0o200] & 0o777) == (0o1000, 0o577)
    machine = pdp8.Machine()
    machine.load(words | {0o201: 0o7402, 0o7777: 0o1234})
    machine.start(0o200)
    machine.run()
    assert machine.ac == 0o1234
