"""Curves cut into stretches along which X and Y each go one way, every one inside its band.

    line       from a point to a point              band: within E of it, at right angles
    oval       an ellipse or circle, whole          band: between two ellipses
    arc        of a circle, either way round        band: radius +- E, split at 12, 3, 6 and 9 o'clock
    graph      y = f(x), its values at each .001    band: f(x) +- E, split at its turning points (Chapter 6)

    a stretch           the turning point   .-->--.   last_x: there the stretch ends, in the middle of a cut
    of a graph                            .'   |   '.          along X that the next stretch goes on with
                                         /     |     \\
                                     rising  last_x  falling

Lengths are thousandths of an inch; the cutter's stops are whole ones, a band may be asked about any point.

Sources: thesis, Chapter 3, Figures 3.3 to 3.5, and Chapter 6.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from itertools import pairwise
from math import ceil, cos, dist, floor, hypot, radians, sin
from typing import Any, Literal, NamedTuple

from programs.errors import PartError

Axis = Literal["X", "Y"]
Limits = tuple[float, float]


class Point(NamedTuple):
    """A place of the cutter's centre on the table."""

    x: int
    y: int


@dataclass(frozen=True)
class Stretch:
    """A piece of a curve along which X goes one way (`dx`: 1, -1 or 0) and Y one way (`dy`).

    It ends where a cut along X comes to `last_x`, or one along Y to `last_y`.
    """

    dx: int
    dy: int
    inside: Callable[[float, float], bool]
    last_x: int | None = None
    last_y: int | None = None

    at_least = 0
    """Thousandths that a cut takes before it is asked whether it is over."""

    def ends(self, axis: Axis, x: int, y: int) -> bool:
        """Whether the stretch ends where a cut along `axis` has come to `x`, `y`."""
        return x == self.last_x if axis == "X" else y == self.last_y

    def over(self, axis: Axis, x: int, y: int) -> bool:
        """Whether a cut along `axis` stops at `x`, `y`: the next thousandth is outside."""
        if axis == "X":
            return not self.dx or not self.inside(x + self.dx, y)
        return not self.dy or not self.inside(x, y + self.dy)


class Curve(NamedTuple):
    """What a technique interpolates: where it starts, its stretches in order, where it ends."""

    start: Point
    stretches: tuple[Stretch, ...]
    end: Point


def line(start: Point, end: Point, tolerance: float) -> Curve:
    """Return the straight line between two points. Raises PartError for too small a tolerance."""
    check_tolerance(tolerance, dist(start, end))
    across, up = end.x - start.x, end.y - start.y
    if not across or not up:
        return Curve(start, (), end)
    limit = tolerance * hypot(across, up)

    def inside(x: float, y: float) -> bool:
        return -limit <= across * (y - start.y) - up * (x - start.x) <= limit

    return Curve(start, (Stretch(_sign(across), _sign(up), inside, end.x, end.y),), end)


def arc(centre: Point, radius: float, start: float, sweep: float, tolerance: float) -> Curve:
    """Return the arc about `centre` from angle `start` through `sweep`, degrees counterclockwise.

    Raises PartError for a radius or tolerance that makes none.
    """
    if radius <= 0:
        raise PartError(f"radius {radius:g} is no size of an arc: it must be greater than 0")
    check_tolerance(tolerance, radius)
    inner, outer = (radius - tolerance) ** 2, (radius + tolerance) ** 2

    def inside(x: float, y: float) -> bool:
        return inner <= (x - centre.x) ** 2 + (y - centre.y) ** 2 <= outer

    def at(angle: float) -> Point:
        return Point(
            round(centre.x + radius * cos(radians(angle))), round(centre.y + radius * sin(radians(angle)))
        )

    def stretch(angle: float, until: float) -> Stretch:
        middle = radians((angle + until) / 2)
        way = _sign(sweep)
        dx, dy = -_sign(sin(middle)) * way, _sign(cos(middle)) * way
        if until == last:
            return Stretch(dx, dy, inside, *at(until))
        if until % 180:
            return Stretch(dx, dy, inside, last_x=centre.x)
        return Stretch(dx, dy, inside, last_y=centre.y)

    last = start + sweep
    angles = [start, *_right_angles_between(start, last), last]
    stretches = tuple(stretch(*pair) for pair in pairwise(angles))
    return Curve(at(start), stretches, at(last))


def _right_angles_between(start: float, last: float) -> list[float]:
    low, high = min(start, last), max(start, last)
    between = [90.0 * turn for turn in range(ceil(low / 90), ceil(high / 90)) if low < 90 * turn < high]
    return between if start <= last else between[::-1]


def oval(centre: Point, major: int, inner: Limits, outer: Limits) -> Curve:
    """Return the ellipse (or circle) about `centre` between two others, clockwise from 9 o'clock and back.

    Each limit is an ellipse's semi-axes along X and Y.
    """

    def inside(x: float, y: float) -> bool:
        across, up = (x - centre.x) ** 2, (y - centre.y) ** 2
        return across / inner[0] ** 2 + up / inner[1] ** 2 >= 1 >= across / outer[0] ** 2 + up / outer[1] ** 2

    start = Point(centre.x - major, centre.y)
    quadrants = (
        Stretch(+1, +1, inside, last_x=centre.x),
        Stretch(+1, -1, inside, last_y=centre.y),
        Stretch(-1, -1, inside, last_x=centre.x),
        Stretch(-1, +1, inside, start.x, start.y),
    )
    return Curve(start, quadrants, start)


def graph(first_x: int, lower: Sequence[Any], upper: Sequence[Any]) -> Curve:
    """Return the curve between two limits, given by their Y at `first_x` and at each thousandth after it.

    Its turning points are found first, as Chapter 6 has it. Raises PartError where it is too steep for its
    band.
    """
    middle = [(float(low) + float(high)) / 2 for low, high in zip(lower, upper, strict=True)]
    tolerance = round((float(upper[0]) - float(lower[0])) / 2, 6)
    check_tolerance(tolerance, max(len(middle) - 1, max(middle) - min(middle)))
    _check_steepness(first_x, middle, tolerance)
    bottom: list[int] = [ceil(low) for low in lower]
    top: list[int] = [floor(high) for high in upper]

    def inside(x: float, y: float) -> bool:
        place = int(x) - first_x
        if not 0 <= place < len(middle):
            return False
        part = x - int(x)
        if not part:
            return bottom[place] <= y <= top[place]
        if place + 1 == len(middle):
            return False
        low = float(lower[place]) * (1 - part) + float(lower[place + 1]) * part
        high = float(upper[place]) * (1 - part) + float(upper[place + 1]) * part
        return bool(low <= y <= high)

    places = [0, *turning_points(middle), len(middle) - 1]
    stretches = tuple(
        Stretch(1, _sign(middle[there] - middle[here]), inside, last_x=first_x + there)
        for here, there in pairwise(places)
    )
    last_x = first_x + len(middle) - 1
    return Curve(Point(first_x, round(middle[0])), stretches, Point(last_x, round(middle[-1])))


def turning_points(heights: Sequence[float]) -> list[int]:
    """Return the indices where a table of heights stops rising and falls, or the other way round."""
    turns = []
    way = 0
    for place, (here, there) in enumerate(pairwise(heights)):
        step = _sign(there - here)
        if step and way and step != way:
            turns.append(place)
        way = step or way
    return turns


def check_tolerance(tolerance: float, size: float) -> None:
    """Raise PartError for a tolerance finer than the machine's resolution, or as large as the curve."""
    if not tolerance >= 1:
        raise PartError(
            f"a tolerance of {tolerance / 1000:g} in is finer than the machine's resolution, .001 in"
        )
    if tolerance >= size:
        raise PartError(
            f"a tolerance of {tolerance / 1000:g} in is larger than the curve, {size / 1000:g} in"
        )


def _check_steepness(first_x: int, heights: Sequence[float], tolerance: float) -> None:
    """A cut along X takes a thousandth at least, and must find the band still there."""
    for x, (here, there) in enumerate(pairwise(heights), first_x):
        if abs(there - here) > 2 * tolerance - 1:
            raise PartError(
                f"the curve is too steep for a tolerance of {tolerance / 1000:g} in: at X {x / 1000:.3f} "
                f"of the table it moves {abs(there - here) / 1000:.3g} in along Y in a thousandth of X"
            )


def _sign(number: float) -> int:
    return (number > 0) - (number < 0)
