"""What the tests of parts read in a printout, worked out without the code that printed it."""

from itertools import pairwise
from typing import NamedTuple

TRAVEL_X, TRAVEL_Y = 20000, 10000


class Read(NamedTuple):
    """One line's columns, blanks read as zeros, as the Hydra-Point does."""

    sequence: int
    preparatory: int
    x: int
    y: int
    tool: int
    function: int


def blocks(printout: str) -> list[Read]:
    """Return the blocks of a printout, each line checked to be 19 characters, digits and blanks alone."""
    assert printout.endswith("\n")
    return [_block(line) for line in printout[:-1].split("\n")]


def _block(line: str) -> Read:
    assert len(line) == 19, line
    digits = line.replace(" ", "0")
    assert digits.isdigit(), line
    assert digits[14] == "0", line
    columns = (digits[0:3], digits[3], digits[4:9], digits[9:14], digits[15:17], digits[17:19])
    return Read(*map(int, columns))


def milled(printout: str) -> list[Read]:
    """Return the blocks from the one that goes to the start of the contour, that of the Z feed left out."""
    return [blocks(printout)[4], *blocks(printout)[6:]]


def assert_fit_for_the_machine(printout: str) -> None:
    """Check travel, sequence, and that a cut moves along the axis that its function names and no other."""
    for number, block in enumerate(blocks(printout), 1):
        assert 0 <= block.x <= TRAVEL_X, f"block {number}"
        assert 0 <= block.y <= TRAVEL_Y, f"block {number}"
        assert block.sequence == number % 1000, f"block {number}"
    path = milled(printout)
    for before, block in pairwise(path):
        if block.preparatory == 6:
            moved = {84: block.y == before.y, 85: block.x == before.x}[block.function]
            assert moved, f"block {block.sequence:03} moves in both axes"
            assert (block.x, block.y) != (before.x, before.y), f"block {block.sequence:03} does not move"
        else:
            assert (block.preparatory, block.tool, block.function) == (0, 0, 80), f"block {block.sequence:03}"
