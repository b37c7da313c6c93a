"""What the tests of parts read in a printout, worked out without the code that printed it."""

from typing import NamedTuple


class Read(NamedTuple):
    """One line's columns, blanks read as zeros, as the Hydra-Point does."""

    sequence: int
    preparatory: int
    x: int
    y: int
    reserved: int
    tool: int
    function: int


def blocks(printout: str) -> list[Read]:
    """Return the blocks of a printout, each line checked to be 19 characters, digits and blanks alone."""
    assert printout.endswith("\n")
    lines = printout[:-1].replace(" ", "0").split("\n")
    assert [line for line in lines if len(line) != 19 or not line.isdigit()] == []
    columns = ((0, 3), (3, 4), (4, 9), (9, 14), (14, 15), (15, 17), (17, 19))
    return [Read(*(int(line[first:last]) for first, last in columns)) for line in lines]


def milled(printout: str) -> list[Read]:
    """Return the blocks from the one that goes to the start of the contour, that of the Z feed left out."""
    return [blocks(printout)[4], *blocks(printout)[6:]]
