"""Appendix C: the circle, ported from circle.for with its order of statements and its quirks.

    quadrant    1         2         3         4             1 | 2       clockwise from 9 o'clock;
    X        4000-AX   4000+AX   4000+AX   4000-AX         ---+---      AX and AY are distances
    Y        4000+AY   4000+AY   4000-AY   4000-AY          4 | 3       from the centre
    climbs      AY        AX        AY        AX
    statements 20-45     50-65     70-85    90-105

In each quadrant one of AX, AY climbs by .001 until the outer limit is reached and the point is printed; then
the other comes down by .001 until the inner limit is reached and the point is printed. The quadrant ends when
the one that comes down reaches 0, and the next starts where it stopped. The tests against RAD (390, 475, 560,
645) never end a quadrant with the thesis's values, and the contour ends .156 in short of its start.

The numbering is the listing's: AS starts at 7; quadrant 1 prints its Y-points with AS as it is and steps it
before and after each X-point; the other quadrants step it before each print.

Chapter 7 gives a centre diameter of 3.75 in, and Chapter 6 its rule: the radius less half the radius of the
tool, 2 - .125. A cutter of radius .25 in a 4 in circle needs 2 - .25. The header positions to X 2.250 and the
inner limit is 1745: a radius of 1.750 about 4.000. The listing is followed. RAD itself, line 295, is a
conjecture: the output is the same for any RAD of 1745 or more.

`close` prints one block more, the point at which quadrant 4 ends, where AY is 0: 6676 2251 4000  185. The
listing does not print it.

Sources: thesis, Appendix C; lines 235 to 315, damaged in the scan, as circle.for restores them.
"""

from typing import Annotated, Any

from programs.arithmetic import EXACT, Arithmetic
from programs.format import Overflow
from programs.function import CutterOfSurface
from programs.header import THESIS, Header
from programs.milling import AS_LISTED, NO_CUTTER, OF_CENTRE, SLOWEST, Milling
from programs.printout import Printout, check_band, check_codes, check_start
from programs.profile import RoundSide, beside_oval
from programs.stretches import Point, oval
from programs.units import CODE, NUMBER, THOUSANDTHS
from tapes.hydrapoint import Miscellaneous, Preparatory

_QUADRANTS = ((-1, +1, "AY", "AX"), (+1, +1, "AX", "AY"), (+1, -1, "AY", "AX"), (-1, -1, "AX", "AY"))
"""Signs of AX and AY, which of them climbs, which comes down."""


def part(
    *,
    radius: Annotated[int, "RAD: radius of the cutter's path", THOUSANDTHS] = 1750,
    tolerance: Annotated[float, "half the width of the band", THOUSANDTHS.below(1)] = 5,
    outer: Annotated[float | None, "ARL: outer limit, else radius + tolerance", *OF_CENTRE] = None,
    inner: Annotated[float | None, "ARS: inner limit, else radius - tolerance", *OF_CENTRE] = None,
    centre_x: Annotated[int, "X of the centre, 4000. in line 320", THOUSANDTHS] = 4000,
    centre_y: Annotated[int, "Y of the centre, 4000. in line 325", THOUSANDTHS] = 4000,
    start_x: Annotated[
        int | None, "AX: first distance from the centre in X, else the radius", *OF_CENTRE
    ] = None,
    start_y: Annotated[int, "AY: first distance from the centre in Y", *OF_CENTRE] = 0,
    sequence: Annotated[int, "", NUMBER] = 7,
    preparatory: Annotated[int, "", CODE] = Preparatory.MILL,
    x_feed: Annotated[int, "", CODE] = Miscellaneous.X_FEED,
    y_feed: Annotated[int, "", CODE] = Miscellaneous.Y_FEED,
    close: Annotated[
        bool, "print the last point too, where the contour comes back to its start", *AS_LISTED, NO_CUTTER
    ] = False,
    cutter: CutterOfSurface = None,
    side: RoundSide = "outside",
    milling: Milling = SLOWEST,
    header: Header = THESIS,
    arithmetic: Annotated[Arithmetic, ""] = EXACT,
    overflow: Overflow = "low-digits",
) -> str:
    r"""Return the printout: a block is a line of 19 characters and "\n". Lengths are thousandths of an inch.

    `sequence` (AS) is the first sequence number, `preparatory` (AP) the contour's function, `x_feed`
    (AMX) and `y_feed` (AMY) the miscellaneous function of a cut in X and in Y. A path beside the surface is
    not of the listing.

    Raises WorkError for parameters of no possible circle, and for a block that leaves the table.
    """
    outer = radius + tolerance if outer is None else outer
    inner = radius - tolerance if inner is None else inner
    start_x = radius if start_x is None else start_x
    check_band("radius", radius, inner, outer)
    if cutter is not None:
        path = beside_oval(centre_x, centre_y, radius, radius, cutter, side, tolerance)
        return milling.printout(path, header, overflow)
    check_start(start_x, start_y, outer, outer)
    check_codes(sequence, preparatory, x_feed, y_feed)
    printout = Printout(overflow)
    printout.header(header, centre_x - start_x, centre_y + start_y)

    if not milling.is_of_the_listings:
        curve = oval(Point(centre_x, centre_y), radius, (inner, inner), (outer, outer))
        milling.print(printout, curve)
        return printout.text
    real, store, sqrt = arithmetic.real, arithmetic.store, arithmetic.sqrt
    at = {"AX": real(start_x), "AY": real(start_y)}
    rad, arl, ars = real(radius), real(outer), real(inner)

    def ar() -> Any:
        return store(sqrt(at["AX"] ** 2 + at["AY"] ** 2))

    def cut_to_here(sequence: int, east: int, north: int, function: int) -> None:
        x, y = centre_x + east * int(at["AX"]), centre_y + north * int(at["AY"])
        printout.print_30(sequence, preparatory, x, y, milling.feed_code, function)

    function = {"AX": x_feed, "AY": y_feed}
    for east, north, up, down in _QUADRANTS:
        first = (east, north) == (-1, +1)
        while True:
            at[up] = store(at[up] + 1)  # 20 50 70 90
            while arl - ar() > 0:
                at[up] = store(at[up] + 1)
            sequence += 0 if first else 1  # 25 55 75 95
            cut_to_here(sequence, east, north, function[up])
            at[down] = store(at[down] - 1)  # 40 60 80 100
            while at[down] > 0 and ar() - ars > 0:  # 41 61 81 101
                at[down] = store(at[down] - 1)
            if at[down] <= 0:
                break
            sequence += 1  # 42 62 82 102
            cut_to_here(sequence, east, north, function[down])
            sequence += 1 if first else 0
            if rad - at[up] <= 0:
                break
    if close:
        cut_to_here(sequence + 1, east, north, function[down])
    return printout.text
