r"""The third degree polynomial y = Ax(x-B)(x-C), the path of the cutter's centre (Chapters 6 and 7).

    y  1.328                       /      A = 0.2, B = 2, C = 6, +-.01; its turning points, X .903 and 4.431,
       1.010   .-.                /       are found first, on a table of it
         0 ---/---\-------------/--
             / 0    2         6    x
      -2.784/        '.     .'
      -3.380           '-.-'

The thesis gives neither the range nor its place on the table. The curve "will pass through the X-axis three
times", at 0, B and C; a range from 0 to 6 only touches the axis at its ends and makes 819 blocks of the
thesis's 1200. Ours, -.75 to 6.25, is a choice: it is one of two ranges in quarter inches that cross the axis
three times and come within 2 % of 1200 blocks (docs/implied.md).

Source: thesis, Chapters 6 and 7.
"""

from typing import Annotated, Any

from programs.arithmetic import EXACT, WHICH, Arithmetic
from programs.format import Overflow
from programs.function import CutterOfSurface, Range, Side, centre_path, offset_path
from programs.header import THESIS, Header
from programs.milling import SLOWEST, Milling
from programs.units import INCHES, PER_SQUARE_INCH


def part(
    *,
    a: Annotated[float, "A", PER_SQUARE_INCH] = 0.2,
    b: Annotated[float, "B, second crossing of the X axis", INCHES] = 2.0,
    c: Annotated[float, "C, third crossing", INCHES] = 6.0,
    tolerance: Annotated[float, "E, half the height of the band", INCHES.below(1)] = 0.01,
    from_: Annotated[float, "X where it starts", INCHES] = -0.75,
    to: Annotated[float, "X where it ends", INCHES] = 6.25,
    origin_x: Annotated[float, "X of the table where x is 0", INCHES] = 4.0,
    origin_y: Annotated[float, "Y of the table where y is 0", INCHES] = 6.0,
    cutter: CutterOfSurface = None,
    side: Side = "above",
    milling: Milling = SLOWEST,
    header: Header = THESIS,
    arithmetic: Annotated[Arithmetic, WHICH, "not cutter"] = EXACT,
    overflow: Overflow = "low-digits",
) -> str:
    """Return the printout of the polynomial; lengths are inches. Raises WorkError."""
    where = Range(from_, to, origin_x, origin_y)
    if cutter is None:
        ra, rb, rc = arithmetic.real(a), arithmetic.real(b), arithmetic.real(c)

        def polynomial(x: Any) -> Any:
            return ra * x * (x - rb) * (x - rc)

        curve = centre_path(polynomial, where, tolerance, arithmetic)
    else:
        curve = offset_path(lambda x: a * x * (x - b) * (x - c), where, tolerance, cutter, side)
    return milling.printout(curve, header, overflow)
