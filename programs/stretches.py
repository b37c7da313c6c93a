"""Curves split into stretches along which X and Y each go in one direction, each with its band.

    line       from a point to a point              band: within E of it, at right angles
    oval       a whole ellipse or circle            band: between two ellipses
    arc        of a circle, either way round        band: radius +- E, split at 0, 90, 180 and 270 degrees
    graph      y = f(x), its values at each .001    band: f(x) +- E, split at its turning points (Chapter 6)

    a stretch           the turning point   .-->--.   last_x: here the stretch ends, within a cut along X
    of a graph                            .'   |   '.          that continues in the next stretch
                                         /     |     \\
                                     rising  last_x  falling

Lengths are thousandths of an inch; a stop of the cutter is a whole number of them.

Sources: thesis, Chapter 3, Figures 3.3 to 3.5, and Chapter 6.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from enum import IntEnum
from itertools import pairwise
from math import ceil, cos, floor, radians, sin, sqrt
from typing import Any, Literal, NamedTuple

from tapes.errors import WorkError

Axis = Literal["X", "Y"]
Limits = tuple[float, float]


class Point(NamedTuple):
    """A place of the cutter's centre on the table."""

    x: int
    y: int


class Side(IntEnum):
    """The side of a band that a point is on."""

    BELOW = -2
    LOWER_LIMIT = -1
    INSIDE = 0
    UPPER_LIMIT = 1
    ABOVE = 2


@dataclass(frozen=True)
class Stretch:
    """A piece of a curve along which X has one direction (`dx`: 1 or -1) and Y has one (`dy`).

    `side` returns the side of the band that a point is on; cuts along the axis `upward` lead to the upper
    limit, those along the other axis to the lower one. The stretch ends where a cut along X reaches `last_x`,
    or one along Y reaches `last_y`.
    """

    dx: int
    dy: int
    side: Callable[[float, float], Side]
    upward: Axis
    last_x: int | None = None
    last_y: int | None = None

    def ends(self, axis: Axis, x: int, y: int) -> bool:
        """Whether the stretch ends where a cut along `axis` has reached `x`, `y`."""
        return x == self.last_x if axis == "X" else y == self.last_y

    def inside(self, x: float, y: float) -> bool:
        """Whether a point is in the band, its limits included."""
        return -2 < self.side(x, y) < 2

    def reached(self, axis: Axis, x: int, y: int) -> bool:
        """Whether a cut along `axis` has reached its limit at `x`, `y`, or passed it."""
        side = self.side(x, y)
        return side >= Side.UPPER_LIMIT if axis == self.upward else side <= Side.LOWER_LIMIT

    def leaves(self, axis: Axis, x: int, y: int) -> bool:
        """Whether the next thousandth of a cut along `axis` from `x`, `y` is outside the band."""
        if axis == "X":
            return not self.inside(x + self.dx, y)
        return not self.inside(x, y + self.dy)


class Curve(NamedTuple):
    """A curve for a technique: its start, its stretches in order, its end."""

    start: Point
    stretches: tuple[Stretch, ...]
    end: Point


def line(start: Point, end: Point, tolerance: float) -> Curve:
    """Return the straight line between two points. Raises WorkError for a tolerance out of range."""
    across, up = end.x - start.x, end.y - start.y
    length = sqrt(across * across + up * up)
    check_tolerance(tolerance, length)
    limit = tolerance * length

    def side(x: float, y: float) -> Side:
        off = across * (y - start.y) - up * (x - start.x)
        return side_of(off, -limit, limit)

    upward: Axis = "Y" if across * up > 0 else "X"
    return Curve(start, (Stretch(sign(across), sign(up), side, upward, end.x, end.y),), end)


def arc(centre: Point, radius: float, start: float, sweep: float, tolerance: float) -> Curve:
    """The arc about `centre` through `sweep` degrees counterclockwise. Raises WorkError for the tolerance."""
    check_tolerance(tolerance, radius)
    inner, outer = (radius - tolerance) ** 2, (radius + tolerance) ** 2

    def side(x: float, y: float) -> Side:
        return side_of((x - centre.x) ** 2 + (y - centre.y) ** 2, inner, outer)

    def at(angle: float) -> Point:
        return Point(
            round(centre.x + radius * cos(radians(angle))), round(centre.y + radius * sin(radians(angle)))
        )

    def stretch(angle: float, until: float) -> Stretch:
        middle = radians((angle + until) / 2)
        way = sign(sweep)
        dx, dy = -sign(sin(middle)) * way, sign(cos(middle)) * way
        upward: Axis = "X" if dx * cos(middle) > 0 else "Y"
        if until == last:
            return Stretch(dx, dy, side, upward, *at(until))
        if until % 180:
            return Stretch(dx, dy, side, upward, last_x=centre.x)
        return Stretch(dx, dy, side, upward, last_y=centre.y)

    last = start + sweep
    low, high = min(start, last), max(start, last)
    between = [90.0 * turn for turn in range(floor(low / 90) + 1, ceil(high / 90))]
    angles = [start, *(between if sweep >= 0 else reversed(between)), last]
    stretches = tuple(stretch(*pair) for pair in pairwise(angles))
    return Curve(at(start), stretches, at(last))


def oval(centre: Point, major: int, inner: Limits, outer: Limits) -> Curve:
    """Return the ellipse about `centre` between two of these semi-axes, clockwise from 9 o'clock and back."""
    (a, b), (c, d) = (inner[0] ** 2, inner[1] ** 2), (outer[0] ** 2, outer[1] ** 2)
    middle_x, middle_y, smaller, larger = centre.x, centre.y, a * b, c * d

    def side(x: float, y: float) -> Side:
        across, up = (x - middle_x) * (x - middle_x), (y - middle_y) * (y - middle_y)
        if (within := across * b + up * a - smaller) <= 0:
            return Side.BELOW if within else Side.LOWER_LIMIT
        if (without := across * d + up * c - larger) >= 0:
            return Side.ABOVE if without else Side.UPPER_LIMIT
        return Side.INSIDE

    start = Point(centre.x - major, centre.y)
    quadrants = (
        Stretch(+1, +1, side, "Y", last_x=centre.x),
        Stretch(+1, -1, side, "X", last_y=centre.y),
        Stretch(-1, -1, side, "Y", last_x=centre.x),
        Stretch(-1, +1, side, "X", start.x, start.y),
    )
    return Curve(start, quadrants, start)


def graph(first_x: int, lower: Sequence[Any], upper: Sequence[Any]) -> Curve:
    """Return the curve between limits, their Y at each thousandth from `first_x` on. Raises WorkError."""
    limits = [(float(low), float(high)) for low, high in zip(lower, upper, strict=True)]
    middle = [(low + high) / 2 for low, high in limits]
    tolerance = round((limits[0][1] - limits[0][0]) / 2, 6)
    check_tolerance(tolerance, max(len(middle) - 1, max(middle) - min(middle)))
    _check_steepness(first_x, middle, tolerance)

    def side(x: float, y: float) -> Side:
        place = int(x) - first_x
        part = x - int(x)
        if not 0 <= place < len(limits) - (part > 0):
            return Side.BELOW
        low, high = limits[place]
        if part:
            low = low + (limits[place + 1][0] - low) * part
            high = high + (limits[place + 1][1] - high) * part
        return side_of(y, low, high)

    places = [0, *turning_points(middle), len(middle) - 1]
    stretches = []
    for here, there in pairwise(places):
        dy = sign(middle[there] - middle[here])
        stretches.append(Stretch(1, dy, side, "Y" if dy > 0 else "X", last_x=first_x + there))
    start, end = Point(first_x, round(middle[0])), Point(first_x + len(middle) - 1, round(middle[-1]))
    return Curve(start, tuple(stretches) if max(middle) > min(middle) else (), end)


def turning_points(heights: Sequence[float]) -> list[int]:
    """Return the indices where a table of heights changes from rising to falling or back."""
    turns = []
    way = 0
    for place, (here, there) in enumerate(pairwise(heights)):
        step = sign(there - here)
        if step and way and step != way:
            turns.append(place)
        way = step or way
    return turns


def check_tolerance(tolerance: float, size: float) -> None:
    """Raise WorkError for a tolerance finer than the machine's resolution, or as large as the curve."""
    said = f"tolerance {tolerance / 1000:g} in: must be"
    if not tolerance >= 1:
        raise WorkError(f"{said} .001 in, the machine's resolution, or more")
    if tolerance >= size:
        raise WorkError(f"{said} smaller than the curve, {size / 1000:g} in")


def _check_steepness(first_x: int, heights: Sequence[float], tolerance: float) -> None:
    """Raise WorkError if the band passes a point within .001 in of X, the shortest cut."""
    for x, (here, there) in enumerate(pairwise(heights), first_x):
        if abs(there - here) > 2 * tolerance - 1:
            raise WorkError(
                f"the curve is too steep for a tolerance of {tolerance / 1000:g} in: at X {x / 1000:.3f} "
                f"of the table it moves {abs(there - here) / 1000:.3g} in along Y in a thousandth of X"
            )


def side_of(value: float, low: float, high: float) -> Side:
    """Return the side of a band that `value` is on, `low` and `high` its limits."""
    if value <= low:
        return Side.BELOW if value < low else Side.LOWER_LIMIT
    if value >= high:
        return Side.ABOVE if value > high else Side.UPPER_LIMIT
    return Side.INSIDE


def sign(number: float) -> int:
    """Return 1, 0 or -1."""
    return (number > 0) - (number < 0)
