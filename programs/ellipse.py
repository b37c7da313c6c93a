"""Appendix D: the ellipse, ported from ellipse.for with its order of statements and its quirks.

    quadrant    1         2         3         4             1 | 2       clockwise from 9 o'clock;
    X         CX-AX     CX+AX     CX+AX     CX-AX          ---+---      AX and AY are distances
    Y         CY+AY     CY+AY     CY-AY     CY-AY           4 | 3       from the centre
    climbs      AY        AX        AY        AX
    statements 20-45     50-65     70-85    90-105

The steps are the circle's; a point is outside where ONE = AX**2/AA**2+AY**2/BB**2 reaches 1, inside where the
same with A and B comes down to it. AS starts at 6 and is stepped before every print.

The arithmetic shows. (2404, 1353) lies exactly on the outer ellipse, being 4/5 and 3/5 of 3005 and 2255, so
that ONE is 0.64 + 0.36. Neither quotient ends in binary; cut off instead of rounded, they add up to less than
1, quadrant 3 takes one step more, and blocks 587 to 595 are .001 off.

Sources: thesis, Appendix D.
"""

from typing import Annotated, Any, Final

from programs.arithmetic import EXACT, WHICH, Arithmetic
from programs.format import Overflow
from programs.function import CutterOfSurface
from programs.header import THESIS, Header
from programs.milling import AS_LISTED, NO_CUTTER, OF_CENTRE, Milling
from programs.printout import Printout, check_band, check_codes, check_start
from programs.profile import RoundSide, beside_oval
from programs.stretches import Point, oval
from programs.units import CODE, NUMBER, THOUSANDTHS
from tapes.hydrapoint import Miscellaneous, Preparatory

MILLING: Final = Milling(feed_code=5)
"""AT = 5."""

_QUADRANTS = ((-1, +1, "AY", "AX"), (+1, +1, "AX", "AY"), (+1, -1, "AY", "AX"), (-1, -1, "AX", "AY"))
"""Signs of AX and AY, which of them climbs, which comes down."""


def part(
    *,
    major: Annotated[int, "AC: semi-major axis, along X", THOUSANDTHS] = 3000,
    minor: Annotated[int, "BC: semi-minor axis, along Y", THOUSANDTHS] = 2250,
    tolerance: Annotated[float, "half the width of the band", THOUSANDTHS.below(1)] = 5,
    outer_major: Annotated[float | None, "AA: outer major limit, else major + tolerance", *OF_CENTRE] = None,
    outer_minor: Annotated[float | None, "BB: outer minor limit, else minor + tolerance", *OF_CENTRE] = None,
    inner_major: Annotated[float | None, "A: inner major limit, else major - tolerance", *OF_CENTRE] = None,
    inner_minor: Annotated[float | None, "B: inner minor limit, else minor - tolerance", *OF_CENTRE] = None,
    centre_x: Annotated[int, "CX: X of the centre", THOUSANDTHS] = 4000,
    centre_y: Annotated[int, "CY: Y of the centre", THOUSANDTHS] = 4000,
    start_x: Annotated[
        int | None, "AX: first distance from the centre in X, else the major axis", *OF_CENTRE
    ] = None,
    start_y: Annotated[int, "AY: first distance from the centre in Y", *OF_CENTRE] = 0,
    sequence: Annotated[int, "", NUMBER] = 6,
    preparatory: Annotated[int, "", CODE] = Preparatory.MILL,
    x_feed: Annotated[int, "", CODE] = Miscellaneous.X_FEED,
    y_feed: Annotated[int, "", CODE] = Miscellaneous.Y_FEED,
    close: Annotated[
        bool, "print the last point too, where the contour comes back to its start", *AS_LISTED, NO_CUTTER
    ] = False,
    cutter: CutterOfSurface = None,
    side: RoundSide = "outside",
    milling: Milling = MILLING,
    header: Header = THESIS,
    arithmetic: Annotated[Arithmetic, WHICH, *AS_LISTED, NO_CUTTER] = EXACT,
    overflow: Overflow = "low-digits",
) -> str:
    r"""Return the printout: a block is a line of 19 characters and "\n". Lengths are thousandths of an inch.

    `sequence` (AS) is the number before the first, `preparatory` (AP) the contour's function, `x_feed`
    (AMX) and `y_feed` (AMY) the miscellaneous function of a cut in X and in Y. A path beside the surface is
    not of the listing.

    Raises WorkError for parameters of no possible ellipse, and for a block that leaves the table.
    """
    outer_major = major + tolerance if outer_major is None else outer_major
    outer_minor = minor + tolerance if outer_minor is None else outer_minor
    inner_major = major - tolerance if inner_major is None else inner_major
    inner_minor = minor - tolerance if inner_minor is None else inner_minor
    start_x = major if start_x is None else start_x
    check_band("semi-major axis", major, inner_major, outer_major)
    check_band("semi-minor axis", minor, inner_minor, outer_minor)
    if cutter is not None:
        path = beside_oval(centre_x, centre_y, major, minor, cutter, side, tolerance)
        return milling.printout(path, header, overflow)
    check_start(start_x, start_y, outer_major, outer_minor)
    check_codes(sequence, preparatory, x_feed, y_feed)
    printout = Printout(overflow)
    printout.header(header, centre_x - start_x, centre_y + start_y)

    if not milling.is_of_the_listings:
        limits = (inner_major, inner_minor), (outer_major, outer_minor)
        milling.print(printout, oval(Point(centre_x, centre_y), major, *limits))
        return printout.text
    real, store = arithmetic.real, arithmetic.store
    at = {"AX": real(start_x), "AY": real(start_y)}
    last = {"AX": real(major), "AY": real(minor)}
    aa, bb = real(outer_major) ** 2, real(outer_minor) ** 2
    a, b = real(inner_major) ** 2, real(inner_minor) ** 2

    def one(a: Any, b: Any) -> Any:
        return store(at["AX"] ** 2 / a + at["AY"] ** 2 / b)

    def cut_to_here(sequence: int, east: int, north: int, function: int) -> None:
        x, y = centre_x + east * int(at["AX"]), centre_y + north * int(at["AY"])
        printout.print_30(sequence, preparatory, x, y, milling.feed_code, function)

    function = {"AX": x_feed, "AY": y_feed}
    for east, north, up, down in _QUADRANTS:
        while True:
            at[up] = store(at[up] + 1)  # 20 50 70 90
            while one(aa, bb) - 1 < 0:
                at[up] = store(at[up] + 1)
            sequence += 1  # 25 55 75 95
            cut_to_here(sequence, east, north, function[up])
            at[down] = store(at[down] - 1)  # 40 60 80 100
            while at[down] > 0 and one(a, b) - 1 > 0:  # 41 61 81 101
                at[down] = store(at[down] - 1)
            if at[down] <= 0:
                break
            sequence += 1  # 42 62 82 102
            cut_to_here(sequence, east, north, function[down])
            if last[up] - at[up] <= 0:
                break
    if close:
        cut_to_here(sequence + 1, east, north, function[down])
    return printout.text
