"""Any function of x as a part: "almost any curve which can be defined mathematically" (Chapter 6).

Source: thesis, Chapters 3 and 6.
"""

from typing import Annotated

from programs.format import Overflow
from programs.function import CutterOfSurface, Range, Side, centre_path, offset_path
from programs.header import THESIS, Header
from programs.milling import SLOWEST, Milling
from programs.units import INCHES
from tapes.expression import LANGUAGE, function


def part(
    expression: Annotated[str, f"y as a function of x, inches: {LANGUAGE}; capitals are the same"],
    *,
    from_: Annotated[float, "X where it starts", INCHES] = 0.0,
    to: Annotated[float, "X where it ends", INCHES] = 4.0,
    tolerance: Annotated[float, "half the height of the band", INCHES.below(1)] = 0.005,
    origin_x: Annotated[float, "X of the table where x is 0", INCHES] = 4.0,
    origin_y: Annotated[float, "Y of the table where y is 0", INCHES] = 5.0,
    cutter: CutterOfSurface = None,
    side: Side = "above",
    milling: Milling = SLOWEST,
    header: Header = THESIS,
    overflow: Overflow = "low-digits",
) -> str:
    """Return the printout of y = `expression`; lengths are inches. Raises WorkError."""
    y = function(expression)
    where = Range(from_, to, origin_x, origin_y)
    if cutter is None:
        curve = centre_path(lambda x: y(float(x)), where, tolerance)
    else:
        curve = offset_path(y, where, tolerance, cutter, side)
    return milling.printout(curve, header, overflow)
