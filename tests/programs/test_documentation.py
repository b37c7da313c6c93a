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


@pytest.mark.parametrize(
    ("command", "blocks"),
    [
        ("pdp8 part polynomial", 1200),
        ("pdp8 part fluidic --program main", 2050),
        ("pdp8 part fluidic --program control", 600),
        ("pdp8 part fluidic", 2650),
        ("pdp8 part fluidic --program both --control 0.8", 2650),
    ],
)
def test_the_inferred_parts_have_the_thesiss_blocks_within_2_percent(command: str, blocks: int) -> None:
    assert abs(count(command) / blocks - 1) <= 0.02


@pytest.mark.parametrize(
    ("command", "code", "error", "minutes"),
    [
        ("circle", 2, 0.0, "29.3"),
        ("ellipse", 1, 0.2, "49.7"),
        ("die", 1, 0.2, "40.6"),
        ("polynomial", 1, 0.2, "55.8"),
        ("fluidic", 1, -0.2, "182.5"),
    ],
)
def test_the_minutes_at_another_feed(command: str, code: int, error: float, minutes: str) -> None:
    path = machined(printout(f"pdp8 part {command}"), code, error)
    assert f"{path.contour.total / 60:.1f}" == minutes
    assert any(
        minutes in row[-1] for row in rows("Blocks, the thesis's and ours", 7) if f"part {command}`" in row[1]
    )


@pytest.mark.slow("the piece-wise technique tries every pair of feeds, three times a part")
@pytest.mark.parametrize("row", list(rows("The piece-wise technique")), ids=lambda row: row[0])
def test_the_blocks_and_minutes_of_the_piece_wise_technique(row: list[str]) -> None:
    counts = [count(row[1], "--feed-error", error) for error in ("20", "10", "0")]
    assert counts == [int(cell) for cell in row[3:6]]
    if row[7] != "–":
        path = machined(printout(f"{row[1].strip('`')} --feed-error 20"))
        assert f"{path.contour.total / 60:.1f}" == row[7]


@pytest.mark.slow("the piece-wise technique tries every pair of feeds")
@pytest.mark.parametrize(("name", "blocks"), [("ellipse", 406), ("die", 345)])
def test_an_allowance_of_15_percent(name: str, blocks: int) -> None:
    options = ["--technique", "piece", "--feed-error", "15", "--fastest", "4"]
    assert count(f"pdp8 part {name}", *options) == blocks
    assert f"{blocks} blocks for the {name}" in PAGE or f"{blocks} for the {name}" in PAGE


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


@pytest.mark.parametrize("rad", [1745, 1746, 2000])
def test_errata_rad_does_not_show(rad: int) -> None:
    """RAD is only compared with AX and AY at the end of a step: it ends no quadrant from 1745 on."""
    limits = {"outer": 1755.0, "inner": 1745.0, "start_x": 1750}
    assert circle.part(radius=rad, **limits) == circle.part()  # type: ignore[arg-type]


def test_errata_rad_would_show_below() -> None:
    assert circle.part(radius=1744, outer=1755, inner=1745, start_x=1750) != circle.part()
