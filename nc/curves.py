"""The nominal curve: the path that the cutter's centre should follow, sampled at stations.

    station ── a point of the curve, with the normal there (outward, or left of the direction of travel)

The curves are those of the thesis: circle, ellipse, straight line, and a function of x. `fitted` finds the
line, circle or ellipse that a path follows, by least squares; a function must be named.

Lengths are thousandths of an inch, angles degrees counterclockwise from +X.
"""

from abc import ABC, abstractmethod
from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from typing import ClassVar

import numpy as np
from numpy.typing import NDArray

from tapes.errors import WorkError
from tapes.expression import function

Floats = NDArray[np.float64]

_STEP = 1e-6
"""Inches to each side of a point at which a slope is measured."""

_FINE = 7_200
_ROUND = 5
"""What a nominal is a multiple of, in thousandths, if nothing speaks against it."""
_GUESSED = ", guessed from the path"


@dataclass(frozen=True, eq=False)
class Stations:
    """Points of a curve, (n, 2), with unit `normals`, (n, 2); `along`, the distance from the first, (n,)."""

    points: Floats
    normals: Floats
    along: Floats

    def __len__(self) -> int:
        return len(self.points)

    @property
    def angles(self) -> Floats:
        """The direction of each normal in degrees, 0 up to 360."""
        return np.degrees(np.arctan2(self.normals[:, 1], self.normals[:, 0])) % 360

    @property
    def bend(self) -> Floats:
        """The curve's bend, (n,): 1 over its radius, + where the centre lies against the normal."""
        ways = np.gradient(self.points, axis=0)
        return np.asarray((np.gradient(self.normals, axis=0) * ways).sum(axis=1) / (ways * ways).sum(axis=1))

    def part(self, chosen: slice | NDArray[np.intp]) -> "Stations":
        """Return some of the stations."""
        return Stations(self.points[chosen], self.normals[chosen], self.along[chosen])


class Curve(ABC):
    """A curve that can be sampled; `closed`: its end is its start, and `guessed`: nobody named it."""

    closed: ClassVar[bool] = False
    guessed: bool = False

    @abstractmethod
    def stations(self, count: int) -> Stations:
        """Return `count` stations, evenly spread over the parameter: the eccentric angle from +X, or x."""

    @abstractmethod
    def deviations(self, points: Floats) -> Floats:
        """Return how far outside (left of) the curve each of the points (n, 2) lies, to first order."""

    def limit(self, stations: Stations, tolerance: float) -> Floats:
        """Return the limit of a band at the stations, (n, 2), outside of (left of) the curve for +."""
        return stations.points + tolerance * stations.normals


@dataclass(frozen=True)
class Ellipse(Curve):
    """An ellipse with its axes along X and Y; a circle where they are equal."""

    closed = True

    x: float
    y: float
    a: float
    b: float
    guessed: bool = field(default=False, compare=False, kw_only=True)

    def __post_init__(self) -> None:
        """Raise WorkError for axes that are not positive."""
        if not (self.a > 0 and self.b > 0):
            raise WorkError(
                f"semi-axes {self.a / 1000:g} and {self.b / 1000:g} in: each must be greater than 0"
            )

    def stations(self, count: int) -> Stations:
        """Return `count` stations counterclockwise from +X, evenly spread over the eccentric angle."""
        turn = np.linspace(0, 2 * np.pi, count, endpoint=False)
        cos, sin = np.cos(turn), np.sin(turn)
        points = np.column_stack([self.x + self.a * cos, self.y + self.b * sin])
        normals = np.column_stack([self.b * cos, self.a * sin])
        normals /= np.hypot(normals[:, 0], normals[:, 1])[:, None]
        return Stations(points, normals, _along(points))

    def deviations(self, points: Floats) -> Floats:
        """Return the distance outside the ellipse: exact for a circle, else to first order near the curve."""
        dx, dy = points[:, 0] - self.x, points[:, 1] - self.y
        if self.a == self.b:
            return np.asarray(np.hypot(dx, dy) - self.a)
        value = (dx / self.a) ** 2 + (dy / self.b) ** 2
        slope = 2 * np.hypot(dx / self.a**2, dy / self.b**2)
        inmost = np.full(len(points), -float(min(self.a, self.b)))
        return np.asarray(np.divide(value - 1, slope, out=inmost, where=slope > 0))

    def __str__(self) -> str:
        centre = f"centre X {self.x / 1000:.3f} Y {self.y / 1000:.3f}"
        if self.a == self.b:
            return f"circle, {centre}, radius {self.a / 1000:.3f} in{_GUESSED * self.guessed}"
        axes = f"semi-axes {self.a / 1000:.3f} and {self.b / 1000:.3f} in"
        return f"ellipse, {centre}, {axes}{_GUESSED * self.guessed}"


@dataclass(frozen=True)
class StraightLine(Curve):
    """A straight line from one place to another."""

    x1: float
    y1: float
    x2: float
    y2: float
    guessed: bool = field(default=False, compare=False, kw_only=True)

    def __post_init__(self) -> None:
        """Raise WorkError for a line of length 0."""
        if (self.x1, self.y1) == (self.x2, self.y2):
            raise WorkError(f"{self}: it needs two different ends")

    def stations(self, count: int) -> Stations:
        """Return `count` stations from end to end."""
        start, direction = np.array([self.x1, self.y1]), self._direction()
        points = start + np.linspace(0, 1, count)[:, None] * direction
        normals = np.tile(self._normal(), (count, 1))
        return Stations(points, normals, _along(points))

    def deviations(self, points: Floats) -> Floats:
        """Return the distance to the left of the line, seen along it."""
        start = np.array([self.x1, self.y1])
        return np.asarray((points - start) @ self._normal())

    def _direction(self) -> Floats:
        return np.array([self.x2 - self.x1, self.y2 - self.y1], dtype=np.float64)

    def _normal(self) -> Floats:
        direction = self._direction()
        return np.asarray([-direction[1], direction[0]] / np.hypot(direction[0], direction[1]))

    def __str__(self) -> str:
        ends = (f"X {x / 1000:.3f} Y {y / 1000:.3f}" for x, y in ((self.x1, self.y1), (self.x2, self.y2)))
        return f"line from {' to '.join(ends)}{_GUESSED * self.guessed}"


@dataclass(frozen=True)
class Graph(Curve):
    """y = f(x), x from `first` to `last`, inches; its origin is at `x`, `y` of the table, thousandths.

    If f is the surface of a part, `beside` is how far above it (-: below) the cutter's centre goes.
    """

    x: float
    y: float
    expression: str
    first: float
    last: float
    beside: float = 0

    def __post_init__(self) -> None:
        """Raise WorkError for a range of length 0, and for an expression that is not one."""
        if not self.first < self.last:
            raise WorkError(f"range from {self.first:g} to {self.last:g}: must go from less to more")
        function(self.expression)

    def stations(self, count: int) -> Stations:
        """Return `count` stations in equal steps of x. Raises WorkError where the function has no value."""
        x = np.linspace(self.first, self.last, count)
        points = np.column_stack([self.x + 1000 * x, self.y + 1000 * self._height(x)])
        slope = self._slope(x)
        normals = np.column_stack([-slope, np.ones(count)]) / np.hypot(slope, 1)[:, None]
        points += self.beside * normals
        return Stations(points, normals, _along(points))

    def limit(self, stations: Stations, tolerance: float) -> Floats:
        """Return the points at a distance of `tolerance` along Y (thesis, Chapter 6)."""
        return np.asarray(stations.points + np.array([0.0, tolerance]))

    def deviations(self, points: Floats) -> Floats:
        """Return the distance above the curve, to first order near it; beyond its ends, above the tangent."""
        if self.beside:
            near = self.stations(_FINE)
            at = [np.hypot(*(near.points - point).T).argmin() for point in points]
            return np.asarray(((points - near.points[at]) * near.normals[at]).sum(axis=1))
        x = (points[:, 0] - self.x) / 1000
        nearest = np.clip(x, self.first, self.last)
        slope = self._slope(nearest)
        above = points[:, 1] - self.y - 1000 * (self._height(nearest) + slope * (x - nearest))
        return np.asarray(above / np.hypot(slope, 1))

    def _height(self, x: Floats) -> Floats:
        value = function(self.expression)
        return np.array([value(place) for place in x])

    def _slope(self, x: Floats) -> Floats:
        left, right = np.maximum(x - _STEP, self.first), np.minimum(x + _STEP, self.last)
        return np.asarray((self._height(right) - self._height(left)) / (right - left))

    def __str__(self) -> str:
        surface = f", the surface {'below' if self.beside > 0 else 'above'} the cutter" if self.beside else ""
        return (
            f"curve y = {self.expression}, x from {self.first:g} to {self.last:g}, "
            f"origin X {self.x / 1000:.3f} Y {self.y / 1000:.3f}{surface}"
        )


def nominal(
    *,
    circle: Sequence[float] | None = None,
    ellipse: Sequence[float] | None = None,
    line: Sequence[float] | None = None,
    function: str | None = None,
    origin: Sequence[float] = (0, 0),
    range_: Sequence[float] | None = None,
    beside: float = 0,
) -> Curve | None:
    """Return the one curve that is named, lengths in inches; None if none is.

    `circle` is X, Y, radius; `ellipse` X, Y and the semi-axes; `line` X and Y of both ends; `function`
    an expression in x, with its `origin` and `range_`; if it is a surface, `beside` is the cutter's radius, -
    below it. Raises WorkError for two curves, or one that does not exist.
    """
    named = [curve for curve in (circle, ellipse, line, function) if curve is not None]
    if len(named) > 1:
        raise WorkError(f"{len(named)} curves are named; at most one is allowed")
    if circle:
        x, y, radius = _thousandths(circle)
        return Ellipse(x, y, radius, radius)
    if ellipse:
        return Ellipse(*_thousandths(ellipse))
    if line:
        return StraightLine(*_thousandths(line))
    if function is not None:
        if range_ is None:
            raise WorkError(f"function {function}: its range of x is needed")
        x, y = _thousandths(origin)
        return Graph(x, y, function, range_[0], range_[1], beside * 1000)
    return None


def fitted(points: Floats, within: float, band: float = 0) -> Ellipse | StraightLine | None:
    """Return the line, circle or ellipse nearest to the points (n, 2); its constants are rounded to five
    thousandths if all points lie within `band` of it then, else to one.

    None if some point lies further than `within` from each of them, or if less than a quarter of the ellipse
    is there: many ellipses fit a short arc.
    """
    for fit in (_fitted_line, _fitted_ellipse):
        for unit, furthest in ((_ROUND, band), (1, within)):
            curve = fit(points, unit)
            if curve is not None and np.abs(curve.deviations(points)).max() <= furthest:
                return replace(curve, guessed=True)
    return None


def _fitted_line(points: Floats, unit: int) -> StraightLine | None:
    """Fit through the points' mean along their greatest spread, from the first to the last."""
    mean = points.mean(axis=0)
    direction = np.linalg.svd(points - mean, full_matrices=False)[2][0]
    ends = mean + ((points[[0, -1]] - mean) @ direction)[:, None] * direction
    (x1, y1), (x2, y2) = (unit * np.rint(ends / unit)).tolist()
    return StraightLine(x1, y1, x2, y2) if (x1, y1) != (x2, y2) else None


def _fitted_ellipse(points: Floats, unit: int) -> Ellipse | None:
    """Fit p x² + q y² + r x + s y = 1 about the points' mean, least squares."""
    mean = points.mean(axis=0)
    size = np.abs(points - mean).max()
    u, v = ((points - mean) / size).T
    p, q, r, s = np.linalg.lstsq(np.column_stack([u * u, v * v, u, v]), np.ones(len(u)), rcond=None)[0]
    if p <= 0 or q <= 0:
        return None
    whole = 1 + r * r / (4 * p) + s * s / (4 * q)
    place, axes = mean + size * np.array([-r / (2 * p), -s / (2 * q)]), size * np.sqrt([whole / p, whole / q])
    if np.ptp(np.rint(axes)) <= 1:
        axes[:] = np.rint(axes).mean()
    x, y, a, b = (unit * np.rint(np.concatenate([place, axes]) / unit)).tolist()
    width, height = np.ptp(points, axis=0)
    return Ellipse(x, y, a, b) if 0 < a < 1.1 * width and 0 < b < 1.1 * height else None


def _thousandths(inches: Sequence[float]) -> tuple[float, ...]:
    return tuple(round(length * 1000, 6) for length in inches)


def _along(points: Floats) -> Floats:
    steps = np.hypot(*np.diff(points, axis=0).T)
    return np.concatenate([[0.0], np.cumsum(steps)])
