"""The other hand of a part: its printout mirrored.

"Make mirror image of parts (left-hand or right-hand parts) with minimal effort" (Appendix A): the blocks
stay, one of their two coordinates is reflected.

        .--.   |   .--.        across X: X becomes 2 x middle - X
        '---   |   ---'        across Y: Y becomes 2 x middle - Y

Blocks of the header stay as they are, except the one that positions to the start of the contour.

Source: thesis, Appendix A, Flexibility.
"""

from typing import Literal

from programs.printout import check_on_table
from tapes.errors import WorkError
from tapes.hydrapoint import DIGITS, HOLE_MAKING, Block, Miscellaneous, Preparatory, block
from tapes.text import lines_of


def mirrored(printout: str, across: Literal["x", "y"], middle: float | None = None) -> str:
    """Return the printout reflected about `middle`, by default the part's. Raises WorkError."""
    lines = lines_of(printout)
    blocks = [_block(line, number) for number, line in enumerate(lines, 1)]
    places = [found.x if across == "x" else found.y for found in blocks if _is_of_the_part(found)]
    if not places:
        raise WorkError("no block mills or makes a hole: there is no part to mirror")
    twice = min(places) + max(places) if middle is None else 2 * middle
    if twice != round(twice):
        raise WorkError(f"mirror about {twice / 2000!r} in: must be a whole number of half thousandths")
    start, stop = (4, 9) if across == "x" else (9, 14)
    for number, (line, found) in enumerate(zip(lines, blocks, strict=True), 1):
        if _is_of_the_part(found):
            place = round(twice) - (found.x if across == "x" else found.y)
            check_on_table(str(number), across.upper(), place)
            lines[number - 1] = f"{line[:start]}{place:05}{line[stop:]}"
    return "".join(f"{line}\n" for line in lines)


def _block(line: str, number: int) -> Block:
    digits = line.replace(" ", "0")
    if len(digits) != DIGITS or not digits.isdecimal():
        raise WorkError(f"line {number}: {line!r} is not a block of {DIGITS} digits")
    return block(digits)


def _is_of_the_part(found: Block) -> bool:
    if found.preparatory == Preparatory.POSITION:
        return found.miscellaneous == Miscellaneous.NO_CHANGE
    return found.preparatory == Preparatory.MILL or found.preparatory in HOLE_MAKING
