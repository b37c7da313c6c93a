"""A curve drawn by hand: its height on the table at each .04 in of X from 2.000, straight between.

Not of the thesis: its technique, on a curve drawn by a finger. The pages have the frame to draw it in;
Chapter 6 reduces such "design curves" to a polynomial first, as `pdp8 part fit` does.
"""

from itertools import pairwise
from typing import Annotated

from programs.format import Overflow
from programs.header import THESIS, Header
from programs.milling import SLOWEST, Milling
from programs.stretches import Curve, graph
from programs.units import INCHES, tolerance_units
from tapes.errors import WorkError

_FIRST, _STEP = 2000, 40


def part(
    heights: Annotated[str, "height of the curve at each .04 in of X from 2.000, inches"],
    *,
    tolerance: Annotated[float, "half the height of the band", INCHES.below(1)] = 0.005,
    milling: Milling = SLOWEST,
    header: Header = THESIS,
    overflow: Overflow = "low-digits",
) -> str:
    """Return the printout of the curve through `heights`, blank-separated, inches. Raises WorkError."""
    units = [1000 * INCHES.keep(height) for height in heights.split()]
    return milling.printout(drawn(units, tolerance_units(tolerance)), header, overflow)


def drawn(heights: list[float], tolerance: float) -> Curve:
    """Return the curve through `heights`, thousandths. Raises WorkError for too few, and as `graph`."""
    if len(heights) < 2:
        raise WorkError("a curve has two heights or more")
    every = [heights[0]]
    for here, there in pairwise(heights):
        every += [here + (there - here) * part / _STEP for part in range(1, _STEP + 1)]
    return graph(_FIRST, [y - tolerance for y in every], [y + tolerance for y in every])
