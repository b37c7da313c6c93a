"""A slope of any angle, which the machine cannot mill in one cut (Chapter 3, Figures 3.1 to 3.3).

The default is that of the chapter: 30 degrees to the X axis, 5 inches long, +-.005. Its place on the table is
our choice.

Source: thesis, Chapter 3.
"""

from typing import Annotated

from programs.format import Overflow
from programs.header import THESIS, Header
from programs.milling import SLOWEST, Milling, mill
from programs.printout import Printout
from programs.stretches import Point, line
from programs.units import INCHES, thousandths, tolerance_units
from tapes.errors import WorkError


def part(
    *,
    from_x: Annotated[float, "X where it starts", INCHES] = 4.0,
    from_y: Annotated[float, "Y where it starts", INCHES] = 4.0,
    to_x: Annotated[float, "X where it ends", INCHES] = 8.33,
    to_y: Annotated[float, "Y where it ends", INCHES] = 6.5,
    tolerance: Annotated[
        float, "half the width of the band, at right angles to the slope", INCHES.below(1)
    ] = 0.005,
    milling: Milling = SLOWEST,
    header: Header = THESIS,
    overflow: Overflow = "low-digits",
) -> str:
    """Return the printout of a slope between two points; lengths are inches. Raises WorkError."""
    start = Point(thousandths("X", from_x), thousandths("Y", from_y))
    end = Point(thousandths("X", to_x), thousandths("Y", to_y))
    if start == end:
        raise WorkError(
            f"slope from X {from_x:g} Y {from_y:g} to the same point: it needs two different ends"
        )
    curve = line(start, end, tolerance_units(tolerance))
    return milling.printout(curve, header, overflow)


def pieces(start: Point, end: Point, count: int, x_code: int, y_code: int) -> str:
    """The printout of a slope in `count` pieces at two tool codes' feeds (Figure 3.1). Raises WorkError."""
    printout = Printout()
    printout.header(THESIS, *start)
    mill(printout, start, x_code, "X")
    mill(printout, start, y_code, "Y")
    for piece in range(1, count + 1):
        x, y = (round(a + (b - a) * piece / count) for a, b in zip(start, end, strict=True))
        mill(printout, Point(x, y), y_code, "Y")
    return printout.text
