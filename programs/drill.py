"""Holes by position alone: what the machine is made for, and Chapter 3's complete little example.

    001 0 00000 00000 0 35 88     spindle 3100 rpm
    002 9 03000 03500 0 01 89     Z feed point 3.000, final depth 3.500, Z feed 1 in/min
    003 5 01000 01000 0 01 89     drill A
    004 5 01000 02000 0 01 89     B
    005 5 04000 02000 0 01 89     C
    006 5 04000 01000 0 01 89     D

Typed on a Flexowriter, all 19 digits of a block were; so they are here.

Source: thesis, Chapter 3.
"""

from typing import Annotated

from programs.contour import thousandths
from programs.errors import PartError
from programs.header import Header
from programs.printout import Printout
from tapes.hydrapoint import Block

Holes = tuple[tuple[float, float], ...]

THE_FOUR: Holes = ((1.0, 1.0), (1.0, 2.0), (4.0, 2.0), (4.0, 1.0))
_DRILL = 5


def part(
    *,
    holes: Annotated[Holes, "X,Y of each hole in inches"] = THE_FOUR,
    spindle: Annotated[int, "spindle speed code of Table 2.4"] = 35,
    z_feed_point: Annotated[float, "Z where the feed begins, inches"] = 3.0,
    z_depth: Annotated[float, "final depth of Z"] = 3.5,
    z_feed: Annotated[int, "Z feed code of Table 2.4"] = 1,
) -> str:
    """Return the printout of a drilling tape. Raises PartError for what the machine does not have."""
    if not holes:
        raise PartError("there are no holes to drill")
    feed_point, depth = thousandths("Z feed point", z_feed_point), thousandths("final Z depth", z_depth)
    Header(spindle=spindle, z_feed_point=feed_point, z_depth=depth, z_feed=z_feed)
    printout = Printout()
    printout.digits(Block(1, 0, 0, 0, 0, spindle, 88))
    printout.digits(Block(2, 9, feed_point, depth, 0, z_feed, 89))
    for number, (x, y) in enumerate(holes, 3):
        place = thousandths("X", x), thousandths("Y", y)
        printout.digits(Block(number, _DRILL, *place, 0, z_feed, 89))
    return printout.text
