"""Drilled holes, the machine's normal use; by default the complete example of Chapter 3.

    001 0 00000 00000 0 35 88     spindle 3100 rpm
    002 9 03000 03500 0 01 89     Z feed point 3.000, final depth 3.500, Z feed 1 in/min
    003 5 01000 01000 0 01 89     drill A
    004 5 01000 02000 0 01 89     B
    005 5 04000 02000 0 01 89     C
    006 5 04000 01000 0 01 89     D

All 19 digits of a block are given, as typed on a Flexowriter.

Source: thesis, Chapter 3.
"""

from typing import Annotated

from programs.header import Header
from programs.printout import Printout
from programs.units import CODE, INCHES, UnitError, thousandths
from tapes.errors import WorkError
from tapes.hydrapoint import Block, Miscellaneous, Preparatory

Holes = tuple[tuple[float, float], ...]

THE_FOUR: Holes = ((1.0, 1.0), (1.0, 2.0), (4.0, 2.0), (4.0, 1.0))


def places(text: str) -> Holes:
    """Return the places that "1,1 2.5,1" says. Raises UnitError."""
    pairs = [place.split(",") for place in text.split()]
    if any(len(pair) != 2 for pair in pairs):
        raise UnitError(f"{text!r} is not a list of places such as '1,1 1,2 4,2'")
    return tuple((INCHES.keep(x), INCHES.keep(y)) for x, y in pairs)


def part(
    *,
    holes: Annotated[Holes, "X,Y of each hole in inches"] = THE_FOUR,
    spindle: Annotated[int, "spindle speed code of Table 2.4", CODE] = 35,
    z_feed_point: Annotated[float, "Z where the feed begins", INCHES] = 3.0,
    z_depth: Annotated[float, "final depth of Z", INCHES] = 3.5,
    z_feed: Annotated[int, "Z feed code of Table 2.4", CODE] = 1,
) -> str:
    """Return the printout of a drilling tape. Raises WorkError for an impossible code or place."""
    if not holes:
        raise WorkError("no holes are given; at least one is needed")
    feed_point, depth = thousandths("Z feed point", z_feed_point), thousandths("final Z depth", z_depth)
    Header(spindle=spindle, z_feed_point=feed_point, z_depth=depth, z_feed=z_feed)
    printout = Printout()
    printout.digits(Block(1, Preparatory.POSITION, 0, 0, 0, spindle, Miscellaneous.SPINDLE_SPEED))
    printout.digits(Block(2, Preparatory.READ_Z, feed_point, depth, 0, z_feed, Miscellaneous.Z_FEED))
    for number, (x, y) in enumerate(holes, 3):
        place = thousandths("X", x), thousandths("Y", y)
        printout.digits(Block(number % 1000, Preparatory.DRILL, *place, 0, z_feed, Miscellaneous.Z_FEED))
    return printout.text
