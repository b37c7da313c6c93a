"""The tables of the thesis, computed: 2.3, 2.4, 10.1 and those without a number in Chapters 2, 3 and 4."""

from collections.abc import Iterator
from itertools import pairwise
from typing import Final

import nc
import pal
from pdp8 import shelf
from pdp8.thesis import chain
from pdp8.thesis.supplied import bracketed, marked
from pdp8.thesis.table import Table
from programs.thesis import TABLE_10_1, Timed
from tapes import hydrapoint
from tapes.hydrapoint import SPINDLE, TOOL_FUNCTION, XY_FEED, Z_FEED
from tapes.text import lines_of


def specifications() -> Table:
    """Chapter 2: what the machine can do, and how much of it is emulated."""
    travel = f'{hydrapoint.X_TRAVEL // 1000}" by {hydrapoint.Y_TRAVEL // 1000}"'
    error = f"±{hydrapoint.FEED_TOLERANCE:.0%}"
    xy, z = XY_FEED.values(), Z_FEED.values()
    return Table(
        ("", "thesis", "here"),
        (
            ("absolute positioning accuracy", '±.001"', "not emulated"),
            ("precision", '±.0003"', "not emulated"),
            ("resolution", '.001"', f'{hydrapoint.RESOLUTION:.3f}"'.lstrip("0")),
            ("X-Y travel", '20" by 10"', travel),
            ("positioning speed", '300"/min', f'{hydrapoint.POSITIONING_SPEED:.0f}"/min'),
            ("X-Y feed rates", '1 to 40"/min ±20%', f'{min(xy):g} to {max(xy):g}"/min, {error} if asked'),
            ("Z feed rates", '1 to 64"/min ±20%', f'{min(z):g} to {max(z):g}"/min, {error} if asked'),
            ("zero adjustment", '±.02"', "not emulated"),
        ),
    )


def block_format() -> Table:
    """Chapter 2: the 20 digits of a block, in the thesis's words."""
    lines = [line.split(": ", 1) for line in _in_its_words("ch2-block")]
    return Table(("digits", "what"), tuple((digits, what) for digits, what in lines))


def functions() -> Table:
    """Table 2.3, in the thesis's words."""
    lines = [("", line) if line[0].isalpha() else line.split(" ", 1) for line in _in_its_words("2.3")]
    return Table(("code", "what"), tuple((code, what) for code, what in lines))


def _in_its_words(artefact: str) -> Iterator[str]:
    return (bracketed(row.ours, lost) for row, lost in marked(artefact))


def rates() -> Table:
    """Table 2.4: two halves side by side, as the thesis has them."""
    left = [
        (f"{code:02}", f"{row.xy_feed:.1f}", f"{row.z_feed:g}", str(row.spindle))
        for code, row in TOOL_FUNCTION.items()
    ]
    right = [(str(code), str(speed)) for code, speed in SPINDLE.items() if code not in TOOL_FUNCTION]
    return Table(
        ("code", "X, Y feed in/min", "Z feed in/min", "spindle rpm", "code", "spindle rpm"),
        tuple((*one, *other) for one, other in zip(left, right, strict=True)),
    )


def drilling() -> Table:
    """Chapter 3: the program for four holes, from its part program."""
    blocks = [line.replace(" ", "0") for line in lines_of(chain.printout("drill"))]
    cuts = (0, 3, 4, 9, 14, 15, 17, 19)
    rows = tuple(tuple(block[at:end] for at, end in pairwise(cuts)) for block in blocks)
    return Table(("seq", "P", "X", "Y", "res", "tool", "misc"), rows)


def instructions(artefact: str) -> Table:
    """Chapter 4: instructions, in the thesis's words."""
    rows = (tuple(line.rsplit(" ", 2)) for line in _in_its_words(artefact))
    return Table(("instruction", "mnemonic", "octal value"), tuple(rows))


def word(statement: str) -> int:
    """Return the word of a statement at 0200."""
    return pal.assemble(f"*200\n\t{statement}\n$\n").words[0o200]


PASSES: Final = {"die": 5}
"""Passes that the die's 2 in of steel take: 200 minutes in all, 40 each."""


def fewest(part: str) -> int:
    """Return the least number of blocks of a part's tape with feed codes 01 to 05, proved by fewest.c."""
    return len(nc.cut(shelf.read_bundled(f"{part}-fewest.eia")))


def comparison() -> Table:
    """Table 10.1: the thesis's figures, those of our tapes as programmed, and the proved least."""
    rows: list[tuple[str, ...]] = []
    for part, row in TABLE_10_1.items():
        passes = PASSES.get(part, 1)
        rows.append((row.part, "step-wise", *_compared(row.step, chain.path(part), passes, "")))
        if row.piece:
            ours = _compared(row.piece, chain.pieces(part), passes, str(fewest(part)))
            rows.append(("", "piece-wise", *ours))
    measures = ("minutes a pass", "[minutes in all]")
    figures = (f"{measure}, {whose}" for measure in measures for whose in ("thesis", "ours"))
    blocks = ("blocks, thesis", "blocks, ours", "fewest possible, codes 01 to 05")
    return Table(("part", "technique", *blocks, *figures, "seconds a block, thesis"), tuple(rows))


def _compared(thesis: Timed, ours: nc.Path, passes: int, least: str) -> Iterator[str]:
    """Yield the cells of a row: thesis and ours for each measure; then the thesis's minutes by its blocks."""
    minutes = ours.contour.total / 60
    yield from (str(thesis.blocks), str(len(ours)), least)
    yield from (str(thesis.minutes), f"{minutes:.1f}")
    yield from (str(thesis.total), f"{passes * minutes:.0f}")
    yield f"{60 * thesis.minutes / thesis.blocks:.2f}"
