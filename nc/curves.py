"""The curve that was meant: what the cutter's centre should have followed, sampled at stations.

    station ── a place on the curve, with the direction square to it (outward, or left of the way along it)

The curves are the thesis's: circle, ellipse, straight line, polynomial. `fitted` finds the one a path follows
by least squares, as one centres the work under an instrument that is told nothing; a polynomial must be told.

Lengths are thousandths of an inch, angles degrees counterclockwise from +X.
"""

from dataclasses import dataclass
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from tapes.errors import WorkError

Floats = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Stations:
    """Places on a curve: `points` and unit `normals`, both (n, 2); `along`, the way from the first, (n,)."""

    points: Floats
    normals: Floats
    along: Floats

    def __len__(self) -> int:
        return len(self.points)

    @property
    def angles(self) -> Floats:
        """The direction of each normal in degrees, 0 up to 360."""
        return np.degrees(np.arctan2(self.normals[:, 1], self.normals[:, 0])) % 360

    def part(self, chosen: slice | NDArray[np.intp]) -> "Stations":
        """Return some of the stations."""
        return Stations(self.points[chosen], self.normals[chosen], self.along[chosen])


class Curve(Protocol):
    """A curve that can be sampled."""

    @property
    def closed(self) -> bool:
        """Whether it comes back to where it began."""

    def stations(self, count: int) -> Stations:
        """Return `count` stations, evenly spread over its parameter."""

    def deviations(self, points: Floats) -> Floats:
        """Return how far outside (left of) the curve each of the points (n, 2) lies, to first order."""

    def __str__(self) -> str:
        """Say what it is, in inches."""


@dataclass(frozen=True)
class Ellipse:
    """An ellipse with its axes along X and Y; a circle where they are equal."""

    x: float
    y: float
    a: float
    b: float

    def __post_init__(self) -> None:
        """Raise WorkError for axes that are none."""
        if not (self.a > 0 and self.b > 0):
            raise WorkError("a circle's radius and an ellipse's semi-axes are greater than 0")

    @property
    def closed(self) -> bool:
        """An ellipse is."""
        return True

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
            return f"circle, {centre}, radius {self.a / 1000:.3f} in"
        return f"ellipse, {centre}, semi-axes {self.a / 1000:.3f} and {self.b / 1000:.3f} in"


@dataclass(frozen=True)
class Line:
    """A straight line from one place to another."""

    x1: float
    y1: float
    x2: float
    y2: float

    def __post_init__(self) -> None:
        """Raise WorkError for a line of no length."""
        if (self.x1, self.y1) == (self.x2, self.y2):
            raise WorkError("a line needs two different ends")

    @property
    def closed(self) -> bool:
        """A line is not."""
        return False

    def stations(self, count: int) -> Stations:
        """Return `count` stations from end to end."""
        start, way = np.array([self.x1, self.y1]), self._way()
        points = start + np.linspace(0, 1, count)[:, None] * way
        normals = np.tile(self._normal(), (count, 1))
        return Stations(points, normals, _along(points))

    def deviations(self, points: Floats) -> Floats:
        """Return the distance to the left of the line, seen along it."""
        start = np.array([self.x1, self.y1])
        return np.asarray((points - start) @ self._normal())

    def _way(self) -> Floats:
        return np.array([self.x2 - self.x1, self.y2 - self.y1], dtype=np.float64)

    def _normal(self) -> Floats:
        way = self._way()
        return np.asarray([-way[1], way[0]] / np.hypot(way[0], way[1]))

    def __str__(self) -> str:
        ends = (f"X {x / 1000:.3f} Y {y / 1000:.3f}" for x, y in ((self.x1, self.y1), (self.x2, self.y2)))
        return f"line from {' to '.join(ends)}"


@dataclass(frozen=True)
class Cubic:
    """The thesis's polynomial y = A x (x - B) (x - C), in inches, from its first crossing of zero to x = C.

    `x` and `y` are where its origin lies on the table, in thousandths.
    """

    x: float
    y: float
    a: float
    b: float
    c: float

    def __post_init__(self) -> None:
        """Raise WorkError for a polynomial of no length."""
        if self.c <= 0:
            raise WorkError("the polynomial runs from 0 to C, which is greater than 0")

    @property
    def closed(self) -> bool:
        """A polynomial is not."""
        return False

    def stations(self, count: int) -> Stations:
        """Return `count` stations in equal steps of x."""
        x = np.linspace(0, self.c, count)
        points = np.column_stack([self.x + 1000 * x, self.y + 1000 * self._height(x)])
        slope = self._slope(x)
        normals = np.column_stack([-slope, np.ones(count)]) / np.hypot(slope, 1)[:, None]
        return Stations(points, normals, _along(points))

    def deviations(self, points: Floats) -> Floats:
        """Return the distance above the curve, to first order near it."""
        x = (points[:, 0] - self.x) / 1000
        above = points[:, 1] - self.y - 1000 * self._height(x)
        return np.asarray(above / np.hypot(self._slope(x), 1))

    def _height(self, x: Floats) -> Floats:
        return self.a * x * (x - self.b) * (x - self.c)

    def _slope(self, x: Floats) -> Floats:
        return self.a * (3 * x * x - 2 * (self.b + self.c) * x + self.b * self.c)

    def __str__(self) -> str:
        return (
            f"polynomial y = {self.a:g} x (x - {self.b:g}) (x - {self.c:g}), "
            f"origin X {self.x / 1000:.3f} Y {self.y / 1000:.3f}"
        )


def fitted(points: Floats, within: float) -> Ellipse | Line | None:
    """Return the line, circle or ellipse nearest to the points (n, 2), constants rounded to the thousandth.

    None if some point lies further than `within` from each of them.
    """
    for fit in (_fitted_line, _fitted_ellipse):
        curve = fit(points)
        if curve is not None and np.abs(curve.deviations(points)).max() <= within:
            return curve
    return None


def _fitted_line(points: Floats) -> Line | None:
    """Fit through the points' mean along their greatest spread, from the first to the last."""
    mean = points.mean(axis=0)
    way = np.linalg.svd(points - mean, full_matrices=False)[2][0]
    ends = mean + ((points[[0, -1]] - mean) @ way)[:, None] * way
    (x1, y1), (x2, y2) = np.rint(ends).tolist()
    return Line(x1, y1, x2, y2) if (x1, y1) != (x2, y2) else None


def _fitted_ellipse(points: Floats) -> Ellipse | None:
    """Fit p x² + q y² + r x + s y = 1 about the points' mean, least squares."""
    mean = points.mean(axis=0)
    size = np.abs(points - mean).max()
    u, v = ((points - mean) / size).T
    p, q, r, s = np.linalg.lstsq(np.column_stack([u * u, v * v, u, v]), np.ones(len(u)), rcond=None)[0]
    if p <= 0 or q <= 0:
        return None
    whole = 1 + r * r / (4 * p) + s * s / (4 * q)
    x, y = np.rint(mean + size * np.array([-r / (2 * p), -s / (2 * q)])).tolist()
    a, b = np.rint(size * np.sqrt([whole / p, whole / q])).tolist()
    if abs(a - b) <= 1:
        a = b = round((a + b) / 2)
    return Ellipse(x, y, a, b) if a and b else None


def _along(points: Floats) -> Floats:
    steps = np.hypot(*np.diff(points, axis=0).T)
    return np.concatenate([[0.0], np.cumsum(steps)])
