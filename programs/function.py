"""y = f(x) on the table: its limits at each thousandth of X, for the cutter's centre or its edge.

        .--(x2,y2)--.        The part's surface is f. A cutter of radius C beside it has its centre on the
      .'    |C       '.      normal (equation 3), at the angle theta whose tangent is dy/dx:
     '   (x1,y1)       '         x2 = x1 - C sin(theta)
       .--'   '--.               y2 = y1 + C cos(theta)       + above the curve, - below it
     f             f

Where the radius of the surface on the cutter's side is less than the cutter's, x2 decreases: such a surface
cannot be cut.

Source: thesis, Chapter 6, equations 2 and 3; 1, lost in the scan, follows from them.
"""

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from itertools import pairwise
from math import atan, ceil, cos, floor, sin
from typing import Annotated, Any, Literal

from programs.arithmetic import EXACT, Arithmetic
from programs.stretches import Curve, graph
from programs.units import INCHES, thousandths, tolerance_units
from tapes.errors import WorkError
from tapes.hydrapoint import X_TRAVEL

_BEYOND = 1e9
"""Thousandths of an inch; nothing larger is computed."""

CutterOfSurface = Annotated[
    float | None, "diameter of the cutter, if the curve is the surface and not the path of its centre", INCHES
]
Side = Annotated[Literal["above", "below"], "side of the curve that the cutter is on", "cutter"]


@dataclass(frozen=True)
class Range:
    """The range of x, and the origin of the curve on the table; inches."""

    first: float
    last: float
    origin_x: float
    origin_y: float

    def __post_init__(self) -> None:
        """Raise WorkError for a range of length 0."""
        if self.units[0] >= self.units[1]:
            raise WorkError(f"X from {self.first:g} to {self.last:g}: must go from less to more")

    @property
    def units(self) -> tuple[int, int]:
        """First and last X of the curve, in thousandths."""
        return thousandths("X from", self.first), thousandths("X to", self.last)

    @property
    def tabulated(self) -> range:
        """Each X to compute, in thousandths; of a range beyond the table only enough to be refused."""
        first, last = self.units
        left, right = -1 - self.origin[0], X_TRAVEL + 1 - self.origin[0]
        nearest = max(first, min(left, last - X_TRAVEL))
        return range(nearest, min(last, max(right, nearest + X_TRAVEL)) + 1)

    @property
    def origin(self) -> tuple[int, int]:
        """X and Y of the origin on the table, in thousandths."""
        return thousandths("origin X", self.origin_x), thousandths("origin Y", self.origin_y)


def centre_path(
    function: Callable[[Any], Any], where: Range, tolerance: float, arithmetic: Arithmetic = EXACT
) -> Curve:
    """Return the band of `function`, in inches, as the path of the cutter's centre. Raises WorkError."""
    across, up = where.origin
    real, store = arithmetic.real, arithmetic.store
    thousand, above, error = real(1000), real(up), real(tolerance_units(tolerance))
    heights = [store(function(store(real(x) / thousand)) * thousand + above) for x in where.tabulated]
    for x, height in zip(where.tabulated, heights, strict=True):
        if abs(floor(height)) > _BEYOND:
            raise WorkError(f"at x = {x / 1000:g} the curve is off the table")
    return graph(
        where.tabulated[0] + across,
        [store(height - error) for height in heights],
        [store(height + error) for height in heights],
    )


def check_cutter(diameter: float) -> None:
    """Raise WorkError for a cutter, in inches, that the machine does not have."""
    if not 0 < diameter <= 10:
        raise WorkError(f"cutter of diameter {diameter:g} in: must be greater than 0, and 10 at most")


def offset_path(
    function: Callable[[float], float], where: Range, tolerance: float, cutter: float, side: str
) -> Curve:
    """Return the band of the cutter's path beside the surface `function`. Raises WorkError."""
    check_cutter(cutter)
    across, up = where.origin
    radius = cutter * 500 * (1 if side == "above" else -1)
    x1 = where.tabulated
    y1 = [float(function(x / 1000)) * 1000 for x in x1]
    if len(y1) < 3:
        raise WorkError(f"X from {where.first:g} to {where.last:g} is too short: at least .002 in is needed")
    for x, y in zip(x1, y1, strict=True):
        if not abs(y) < _BEYOND:
            raise WorkError(f"at x = {x / 1000:g} the curve is off the table")
    angles = [atan(slope) for slope in _slopes(y1)]
    x2 = [x - radius * sin(angle) for x, angle in zip(x1, angles, strict=True)]
    y2 = [y + radius * cos(angle) for y, angle in zip(y1, angles, strict=True)]
    for x, (here, there) in zip(x1, pairwise(x2), strict=False):
        if there <= here:
            raise WorkError(
                f"cutter of {cutter:g} in is too big: at x = {x / 1000:.3f} the radius of the "
                "surface is less than the cutter's"
            )
    first, middle = ceil(x2[0]), [y + up for y in _at_each_thousandth(x2, y2)]
    error = tolerance_units(tolerance)
    return graph(first + across, [y - error for y in middle], [y + error for y in middle])


def _slopes(heights: list[float]) -> list[float]:
    """The slope at each of three or more heights, by its neighbours; at both ends by the last three."""
    a, b, c = heights[:3]
    x, y, z = heights[-3:]
    inner = [(there - here) / 2 for here, there in zip(heights, heights[2:], strict=False)]
    return [(4 * b - 3 * a - c) / 2, *inner, (x - 4 * y + 3 * z) / 2]


def _at_each_thousandth(across: list[float], up: list[float]) -> Iterator[float]:
    """Yield the heights of a line through places at each thousandth of X between its ends."""
    place = 0
    for x in range(ceil(across[0]), floor(across[-1]) + 1):
        while across[place + 1] < x:
            place += 1
        slope = (up[place + 1] - up[place]) / (across[place + 1] - across[place])
        yield up[place] + slope * (x - across[place])
