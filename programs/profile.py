"""A closed profile r(x) about a centre, x the angle: a cam, milled all round.

               .-'''-.        r is the part's edge, or without a cutter the path of its centre. A cutter has
             .'   |   '.      its centre on the normal, outside the part or inside a hole. The path is cut
    start > |     +--r--|     clockwise from the side of least X, split where it turns along X or along Y;
             '.       .'      the band is E wide to each side of it, square to it.
               '-...-'

An edge that bends closer than the cutter, on its side, cannot be cut.

Not of the thesis: its technique, on a curve of ours. Source: thesis, Chapter 3, for the band of a curve.
"""

from bisect import bisect_left
from collections.abc import Sequence
from itertools import pairwise
from math import cos, radians, sin, sqrt
from typing import Annotated, Literal

from programs.format import Overflow
from programs.function import CutterOfSurface
from programs.header import THESIS, Header
from programs.milling import SLOWEST, Milling
from programs.stretches import Axis, Curve, Point, Side, Stretch, check_tolerance
from programs.units import INCHES, thousandths, tolerance_units
from tapes.errors import WorkError
from tapes.expression import LANGUAGE, function

_PLACES = 1440
_FURTHEST = 100
"""Thousandths of an inch from place to place."""

_Place = tuple[float, float]


def part(
    expression: Annotated[
        str, f"the radius as a function of the angle x, in inches and radians, x from 0 to 2 pi: {LANGUAGE}"
    ],
    *,
    tolerance: Annotated[float, "half the width of the band", INCHES.below(1)] = 0.005,
    centre_x: Annotated[float, "X of the centre", INCHES] = 4.0,
    centre_y: Annotated[float, "Y of the centre", INCHES] = 4.0,
    cutter: CutterOfSurface = None,
    side: Annotated[
        Literal["outside", "inside"], "side of the profile that the cutter is on", "cutter"
    ] = "outside",
    milling: Milling = SLOWEST,
    header: Header = THESIS,
    overflow: Overflow = "low-digits",
) -> str:
    """Return the printout of the profile r = `expression`; lengths are inches. Raises WorkError."""
    radius = function(expression)
    centre = thousandths("centre X", centre_x), thousandths("centre Y", centre_y)
    edge = []
    for place in range(_PLACES):
        angle = radians(360 * place / _PLACES)
        if not 0 < (r := radius(angle)) < 100:
            raise WorkError(f"at x = {angle:.3f} the radius is {r:g}: it has to be above 0 and on the table")
        edge.append((centre[0] + 1000 * r * cos(angle), centre[1] + 1000 * r * sin(angle)))
        if place and _length(edge[-1][0] - edge[-2][0], edge[-1][1] - edge[-2][1]) > _FURTHEST:
            raise WorkError(f"at x = {angle:.3f} the radius jumps to {r:g}")
    if abs(radius(radians(360)) - radius(0)) * 1000 > _FURTHEST:
        raise WorkError(
            f"the profile is not closed: the radius is {radius(0):g} at 0, {radius(radians(360)):g} at 2 pi"
        )
    edge.reverse()  # clockwise
    beside = 500 * (cutter or 0) * (1 if side == "outside" else -1)
    return milling.printout(closed(_offset(edge, beside), tolerance_units(tolerance)), header, overflow)


def _offset(edge: Sequence[_Place], beside: float) -> list[_Place]:
    """Return the path to the left of a closed line, `beside` it. Raises WorkError where it goes back."""
    if not beside:
        return [*edge]
    path = []
    for before, (x, y), after in zip([edge[-1], *edge], edge, [*edge[1:], edge[0]], strict=False):
        across, up = after[0] - before[0], after[1] - before[1]
        length = _length(across, up)
        path.append((x - beside * up / length, y + beside * across / length))
    ways = zip(pairwise([*edge, edge[0]]), pairwise([*path, path[0]]), strict=True)
    for (here, there), (one, other) in ways:
        if (there[0] - here[0]) * (other[0] - one[0]) + (there[1] - here[1]) * (other[1] - one[1]) <= 0:
            raise WorkError(
                f"cutter of {abs(beside) / 500:g} in is too big: the profile bends closer at "
                f"X {here[0] / 1000:.3f} Y {here[1] / 1000:.3f}"
            )
    return path


def closed(path: Sequence[_Place], tolerance: float) -> Curve:
    """Return the closed curve through places, near each other, from the one of least X and back.

    Raises WorkError for a tolerance out of range.
    """
    xs, ys = [x for x, _ in path], [y for _, y in path]
    check_tolerance(tolerance, min(max(xs) - min(xs), max(ys) - min(ys)) / 2)
    first = xs.index(min(xs))
    path = [*path[first:], *path[: first + 1]]
    start = Point(round(path[0][0]), round(path[0][1]))
    ways = [(_way(other[0] - one[0]), _way(other[1] - one[1])) for one, other in pairwise(path)]
    turns = [at for at, (one, other) in enumerate(pairwise(ways), 1) if one != other]
    stretches = []
    for begin, end in pairwise([0, *turns, len(path) - 1]):
        dx, dy = ways[begin]
        last = Point(round(path[end][0]), round(path[end][1]))
        turns_x = end < len(ways) and ways[end][0] != dx
        last_x = None if turns_x else last.x
        last_y = last.y if turns_x else None
        if end == len(path) - 1:
            last_x, last_y = start
        stretches.append(_stretch(path[begin : end + 1], (dx, dy), tolerance, (last_x, last_y)))
    return Curve(start, tuple(stretches), start)


def _stretch(
    path: Sequence[_Place], way: tuple[int, int], tolerance: float, last: tuple[int | None, int | None]
) -> Stretch:
    dx, dy = way
    band = _Band(path, dx, dy, tolerance)
    upward: Axis = "Y" if dx * dy > 0 else "X"
    return Stretch(dx, dy, band.side, upward, *last)


def _length(x: float, y: float) -> float:
    return sqrt(x * x + y * y)


def _way(length: float) -> int:
    return -1 if length < 0 else 1


class _Band:
    """The band of a piece of a path along which X and Y each go one way."""

    def __init__(self, path: Sequence[_Place], dx: int, dy: int, tolerance: float) -> None:
        self._path, self._dx, self._dy, self._tolerance = path, dx, dy, tolerance
        self._along = [dx * x + dy * y for x, y in path]

    def side(self, x: float, y: float) -> Side:
        """Return the side of the band that a point is on; left of the path is above."""
        off = self._left(x, y)
        if abs(off) < self._tolerance:
            return Side.INSIDE
        if abs(off) == self._tolerance:
            return Side.UPPER_LIMIT if off > 0 else Side.LOWER_LIMIT
        return Side.ABOVE if off > 0 else Side.BELOW

    def _left(self, x: float, y: float) -> float:
        """Return how far to the left of the path a point is."""
        along, reach = self._dx * x + self._dy * y, 2 * self._tolerance + 2
        end = len(self._path) - 1
        first = min(end, max(1, bisect_left(self._along, along - reach)))
        last = max(first, min(end, bisect_left(self._along, along + reach)))
        nearest = _from_line(x, y, self._path[first - 1], self._path[first])
        for at in range(first + 1, last + 1):
            off = _from_line(x, y, self._path[at - 1], self._path[at])
            nearest = off if abs(off) < abs(nearest) else nearest
        return nearest


def _from_line(x: float, y: float, start: _Place, end: _Place) -> float:
    """Return the distance of a point from a line, - to the right of it."""
    across, up = end[0] - start[0], end[1] - start[1]
    aside = across * (y - start[1]) - up * (x - start[0])
    part = (across * (x - start[0]) + up * (y - start[1])) / (across * across + up * up)
    nearest = min(1.0, max(0.0, part))
    away = _length(x - start[0] - nearest * across, y - start[1] - nearest * up)
    return away if aside >= 0 else -away
