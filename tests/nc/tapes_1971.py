"""Tapes to cut, from the thesis's figures; the circle and its like are those of the part program."""

import nc
from programs import circle
from tests.programs import printouts

EIA = dict(zip("0123456789\r", (0o040, 1, 2, 0o023, 4, 0o025, 0o026, 7, 0o010, 0o031, 0o200), strict=True))

HEADER = (
    "001 0 19000 00000 0 00 02",
    "002 0 00000 00000 0 01 86",
    "003 0 00000 00000 0 00 08",
    "004 0 00000 00000 0 31 88",
    "005 0 02250 04000 0 00 80",
    "006 9 03000 03500 0 01 89",
)
"""The six header blocks of the circle, Appendix C."""

FOUR_HOLES = (
    "001 0 00000 00000 0 35 88",
    "002 9 03000 03500 0 01 89",
    "003 5 01000 01000 0 01 89",
    "004 5 01000 02000 0 01 89",
    "005 5 04000 02000 0 01 89",
    "006 5 04000 01000 0 01 89",
)
"""The drilling program of Chapter 3; spaces for clarity only, as there."""


def tape(*blocks: str) -> bytes:
    """Return EIA frames with parity, an end of block after each block, and one blank frame before them."""
    return bytes([0, *(EIA[character] for block in blocks for character in block.replace(" ", "") + "\r")])


def staircase(radius: int, band: int) -> list[tuple[int, int]]:
    """Return the corners of the staircase about X 4.000 Y 4.000, clockwise from the side of least X."""
    return [(block.x, block.y) for block in printouts.milled(circle.part(radius=radius, tolerance=band))[1:]]


def milling(corners: list[tuple[int, int]], start: tuple[int, int], feed: int = 1) -> list[str]:
    """Return a milling block for each corner, numbered from 7, with the feed of the axis that moves."""
    blocks = []
    before = start
    for number, (x, y) in enumerate(corners, len(HEADER) + 1):
        axis = 84 if x != before[0] else 85
        blocks.append(f"{number % 1000:03} 6 {x:05} {y:05} 0 {feed:02} {axis}")
        before = (x, y)
    return blocks


def milled(*corners: tuple[int, int]) -> nc.Path:
    """Return the path that mills to these places from X 2.250 Y 4.000, cut."""
    return nc.cut(tape(*HEADER, *milling([*corners], (2250, 4000))))


def milled_from(corners: list[tuple[int, int]]) -> nc.Path:
    """Return the path that mills from the first of these places to the others, cut."""
    (x, y), *others = corners
    start = f"005 0 {x:05} {y:05} 0 00 80"
    return nc.cut(tape(*HEADER[:4], start, HEADER[5], *milling(others, (x, y))))


CIRCLE_BLOCKS = (*HEADER, *milling(staircase(1750, 5), (2250, 4000)))
"""The circle of Appendix C: 4 in, 1/2 in cutter, +-.005."""

CIRCLE = tape(*CIRCLE_BLOCKS)
