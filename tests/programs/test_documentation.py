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

from nc.inspection import Inspection, inspect
from pdp8.cli.part import part
from pdp8.replay.implied import machined
from programs import circle
from programs.ellipse import part as ellipse
from tapes import ascii
from tapes.hydrapoint import XY_FEED
from tapes.quantities import inches
from tests.pdp8.thesis import scanned

DOCS = Path(__file__).parents[2] / "docs"
PAGE = (DOCS / "parts.md").read_text()
ERRATA = (DOCS / "errata.md").read_text()


def rows(heading: str) -> Iterator[list[str]]:
    """Yield the cells of each row, under `heading`, that has a command."""
    section = PAGE.split(f"## {heading}")[1].split("\n## ")[0]
    for line in section.split("\n"):
        if "`pdp8 part" in line and line.startswith("|"):
            yield [cell.strip() for cell in line.strip("|").split("|")]


@cache
def printout(command: str, more: str = "") -> str:
    """Return the printout of a command of the page, with more options."""
    words = shlex.split(command.strip("`"))[2:] + more.split()
    done = CliRunner().invoke(part, words)
    assert done.exit_code == 0, done.output
    return ascii.decode(done.stdout_bytes)


def minutes(printout: str, feed_code: int | None = None) -> str:
    return f"{machined(printout, feed_code).contour.total / 60:.1f}"


@pytest.mark.parametrize("row", list(rows("Blocks, the thesis's and ours")), ids=lambda row: row[0])
def test_the_blocks_and_minutes_of_a_part(row: list[str]) -> None:
    """The rule to stop inside has a table of its own, without minutes."""
    blocks, took = (row[3], row[5]) if len(row) == 7 else (row[2], "–")
    assert printout(row[1]).count("\n") == int(blocks)
    assert took in ("–", minutes(printout(row[1])))


@pytest.mark.slow("the piece-wise technique tries every pair of feeds, three times a part")
@pytest.mark.parametrize("row", list(rows("The piece-wise technique")), ids=lambda row: row[0])
def test_the_blocks_and_minutes_of_the_piece_wise_technique(row: list[str]) -> None:
    made = [printout(row[1], f"--feed-error {error}") for error in (20, 10, 0)]
    assert [text.count("\n") for text in made] == [int(cell) for cell in row[3:6]]
    assert row[7] in ("–", minutes(made[0]))


def test_the_counts_and_minutes_in_the_text() -> None:
    die = printout("pdp8 part die", "--major 2.75 --minor 1.25").count("\n")
    slowest = printout("pdp8 part circle", "--technique piece --fastest 1").count("\n")
    assert f"with 6 × 3 for the hole, not the path, {die} blocks" in PAGE
    assert f"`pdp8 part circle --technique piece --fastest 1` makes {slowest} blocks" in PAGE
    assert f"the listing has feed code 05; code 01 gives {minutes(ellipse(), 1)}" in PAGE
    assert f"code 05 takes {minutes(ellipse())}, code 01 takes {minutes(ellipse(), 1)}: the 50" in ERRATA
    assert f"At 1 in/min the tape takes {minutes(circle.part())}" in ERRATA
    blocks = circle.part(radius=1875).count("\n")
    assert f"2 - .125 = 1.875 is the 3.75, and makes {blocks} blocks | Appendix C, 666 blocks" in ERRATA


def test_the_ratios_and_angles_in_the_errata() -> None:
    ratios = {one / two for one, two in product(XY_FEED.values(), repeat=2)}
    closest, *closer = sorted(
        abs(ratio - sqrt(3)) for ratio in ratios if abs(ratio - sqrt(3)) < 1.9 - sqrt(3)
    )
    assert closest == abs(XY_FEED[14] / XY_FEED[10] - sqrt(3))
    more = f"codes 14 and 10; {len(closer)} ratios more are closer than 1.9"
    assert f"{XY_FEED[14]}/{XY_FEED[10]:.1f} = {XY_FEED[14] / XY_FEED[10]:.3f}, {more}" in ERRATA
    angle = degrees(atan2(1.2, 0.8))
    off = f"{angle - 45:.1f}° or {100 * angle / 45 - 100:.0f} % off"
    assert f"{angle:.1f}° or {90 - angle:.1f}°, which is {off}" in ERRATA


def test_what_the_errata_add_up_to() -> None:
    fast, polynomial = printout("pdp8 part circle", "--feed-code 18"), printout("pdp8 part polynomial")
    slow, next_feed = minutes(circle.part()), minutes(circle.part(), 2)
    less = 100 - 100 * float(next_feed) / float(slow)
    assert f"{XY_FEED[2]} in/min, code 02, takes {next_feed} minutes, {less:.0f} % less" in ERRATA
    at_18 = f"at feed code 18, {XY_FEED[18]:.0f} in/min, the tape takes {minutes(fast)} of {slow}"
    assert at_18 in ERRATA
    lines = polynomial.count("\n")
    assert f"{lines * 2.7 / 60:.1f} for our {lines} lines" in ERRATA
    assert f"code 05 of Table 2.4 is {XY_FEED[5]} in/min; no code is 5" in ERRATA
    assert 5 not in XY_FEED.values()


def test_the_errata_quote_the_scan() -> None:
    """What stands in quotation marks, a ± misread as a fraction apart; and the listing's note."""
    scan = " ".join(scanned(name) for name in ("numbers", "mentions", "appendix-d")).replace("Ø", "0")
    scan = scan.replace("$\\frac{1}{2}$", "±").replace("[°]", "°")
    cells = [
        line.split("|")[2] for line in ERRATA.splitlines() if line.startswith("| ") and line.count("|") > 3
    ]
    quoted = [words for cell in cells for words in re.findall(r'"([^"]{6,})"', cell)]
    pieces = [piece for words in quoted for piece in words.split(" ... ")]
    assert [piece for piece in pieces if piece not in scan] == []
    assert len(pieces) > 12
    for code in ("AT=5.", "FEEDRATE= 5 IN/MIN."):
        assert code in scan


def test_the_walls_and_ends_in_the_errata() -> None:
    def at_minus_x(found: Inspection) -> str:
        (reading,) = (r for r in found.readings if (r.place, r.wall) == ("-X apex", "outer"))
        return inches(reading.trough_to_peak)

    parts = (circle.part(), circle.part(close=True), ellipse())
    printed, closed, oval = (inspect(machined(part)) for part in parts)
    ends, _, short = (f"contour ends .{machined(part).gap:03.0f} in short" for part in parts)
    worst, of_the_ellipse = (inches(found.worst.trough_to_peak) for found in (closed, oval))
    last = parts[1].splitlines()[-1]
    for said in (
        f"errors span {worst} on the circle, {of_the_ellipse} on the ellipse",
        f"one more, `{last}`. It takes the trough to peak at -X to {at_minus_x(closed)}, and the wall's "
        f"maximum to {worst}, at +Y and -Y",
        f"which {ends.removeprefix('contour ')} of its start and leaves {at_minus_x(printed)} at -X",
        f"the listing's {short} of its start",
    ):
        assert said in ERRATA
