"""The nominal curve: the path that the cutter's centre should follow, sampled at stations.

    station ── a point of the curve, with the normal there (outward, or left of the direction of travel)

The curves are those of `tapes.nominal`. Where one is the surface of a part, the cutter's centre is `beside`
it, + outside or above, and only the wall on the part's side is the part's.

Lengths are thousandths of an inch, angles degrees counterclockwise from +X.
"""

from abc import ABC, abstractmethod
from dataclasses import dataclass, field, replace
from math import cos, pi, radians, sin
from typing import ClassVar

import numpy as np
from numpy.typing import NDArray

from nc.unit import INCH, Unit
from tapes.errors import WorkError
from tapes.expression import function
from tapes.nominal import Nominal

Floats = NDArray[np.float64]

_STEP = 1e-6
"""Inches to each side of a point at which a slope is measured."""
_PLACES = 7200
"""Places of a profile that is a function of the angle."""
_FAN = radians(0.25)
"""Radians between two normals at a corner."""
_CORNER = radians(3)
"""Radians: a turn that matters for the distance of a wall."""
_GUESSED = ", guessed from the path"
_ROUND = 5
"""What a guess is a multiple of, in thousandths, if nothing speaks against it."""


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

    def part(self, chosen: slice | NDArray[np.intp]) -> "Stations":
        """Return some of the stations."""
        return Stations(self.points[chosen], self.normals[chosen], self.along[chosen])


class Curve(ABC):
    """A curve, to be sampled; the cutter's centre goes `beside` it, at a distance that may be 0."""

    closed: ClassVar[bool] = False
    guessed: bool = False
    beside: float = 0.0

    @property
    def part_wall(self) -> str:
        """The wall that belongs to the part, "inner" or "outer"; "" if the curve is no surface."""
        return "" if not self.beside else "inner" if self.beside > 0 else "outer"

    @property
    def tips(self) -> Floats:
        """The corners of the curve, (n, 2)."""
        return np.empty((0, 2))

    def stations(self, count: int) -> Stations:
        """Return `count` stations of the centre's path, evenly spread over the curve's parameter."""
        surface, normals = self.surface(np.linspace(0, 1, count, endpoint=not self.closed))
        points = surface + self.beside * normals
        steps = np.hypot(*np.diff(points, axis=0).T)
        return Stations(points, normals, np.concatenate([[0.0], np.cumsum(steps)]))

    @abstractmethod
    def surface(self, part: Floats) -> tuple[Floats, Floats]:
        """Return points (n, 2) and normals (n, 2) at these parts of its length, (n,), 0 to 1."""

    def limit(self, stations: Stations, tolerance: float) -> Floats:
        """Return one limit of a band, (n, 2); `tolerance` + is outside (left) of the curve."""
        return stations.points + tolerance * stations.normals

    @abstractmethod
    def said(self, unit: Unit) -> str:
        """Return a description of the curve and of where it is."""

    def __str__(self) -> str:
        return self.said(INCH)

    def _kind(self, name: str) -> str:
        """Return the name of the curve, and which side of it the cutter is on if it is a surface."""
        if not self.beside:
            return name
        sides = ("outside", "inside") if self.closed else ("above", "below")
        return f"{name}, the cutter {sides[self.beside < 0]}"


@dataclass(frozen=True)
class Ellipse(Curve):
    """An ellipse with its axes along X and Y; a circle where they are equal."""

    closed = True

    x: float
    y: float
    a: float
    b: float
    beside: float = 0
    guessed: bool = field(default=False, compare=False, kw_only=True)

    def __post_init__(self) -> None:
        """Raise WorkError for axes that are not positive."""
        if not (self.a > 0 and self.b > 0):
            raise WorkError("a radius or semi-axis must be greater than 0")

    def surface(self, part: Floats) -> tuple[Floats, Floats]:
        """Return points and normals counterclockwise from +X; the parameter is the eccentric angle."""
        cos, sin = np.cos(2 * np.pi * part), np.sin(2 * np.pi * part)
        points = np.column_stack([self.x + self.a * cos, self.y + self.b * sin])
        normals = np.column_stack([self.b * cos, self.a * sin])
        return points, normals / np.hypot(normals[:, 0], normals[:, 1])[:, None]

    def deviations(self, points: Floats) -> Floats:
        """Return the distance outside the ellipse: exact for a circle, else to first order near the curve."""
        dx, dy = points[:, 0] - self.x, points[:, 1] - self.y
        if self.a == self.b:
            return np.asarray(np.hypot(dx, dy) - self.a)
        value = (dx / self.a) ** 2 + (dy / self.b) ** 2
        slope = 2 * np.hypot(dx / self.a**2, dy / self.b**2)
        inmost = np.full(len(points), -float(min(self.a, self.b)))
        return np.asarray(np.divide(value - 1, slope, out=inmost, where=slope > 0))

    def said(self, unit: Unit) -> str:
        """Return a description of its centre and radius or semi-axes."""
        a, b = unit.said(self.a), unit.said(self.b)
        kind, size = ("circle", f"radius {a}") if self.a == self.b else ("ellipse", f"semi-axes {a} and {b}")
        place = f"centre {unit.place(self.x, self.y)}"
        return f"{self._kind(kind)}, {place}, {size} {unit.name}{_GUESSED * self.guessed}"


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
            raise WorkError("a line needs two different ends")

    def surface(self, part: Floats) -> tuple[Floats, Floats]:
        """Return points from end to end, and the normal to the left."""
        start, way, normal = self._frame
        return start + part[:, None] * way, np.tile(normal, (len(part), 1))

    def deviations(self, points: Floats) -> Floats:
        """Return the distance to the left of the line, seen along it."""
        start, _, normal = self._frame
        return np.asarray((points - start) @ normal)

    @property
    def _frame(self) -> tuple[Floats, Floats, Floats]:
        """Its start, the way to its end, and its normal."""
        way = np.array([self.x2 - self.x1, self.y2 - self.y1], dtype=np.float64)
        return np.array([self.x1, self.y1]), way, np.array([-way[1], way[0]]) / np.hypot(way[0], way[1])

    def said(self, unit: Unit) -> str:
        """Return a description of its ends."""
        ends = unit.place(self.x1, self.y1), unit.place(self.x2, self.y2)
        return f"line from {' to '.join(ends)}{_GUESSED * self.guessed}"


@dataclass(frozen=True)
class Graph(Curve):
    """y = f(x), x from `first` to `last`, inches; its origin is at `x`, `y` of the table, thousandths."""

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

    def surface(self, part: Floats) -> tuple[Floats, Floats]:
        """Return points in steps of x, and the normals upward. Raises WorkError where f has no value."""
        x = self.first + part * (self.last - self.first)
        points = np.column_stack([self.x + 1000 * x, self.y + 1000 * self._height(x)])
        left, right = np.maximum(x - _STEP, self.first), np.minimum(x + _STEP, self.last)
        slope = (self._height(right) - self._height(left)) / (right - left)
        return points, np.column_stack([-slope, np.ones(len(x))]) / np.hypot(slope, 1)[:, None]

    def limit(self, stations: Stations, tolerance: float) -> Floats:
        """Return the points at a distance of `tolerance` along Y (thesis, Chapter 6)."""
        return np.asarray(stations.points + np.array([0.0, tolerance]))

    def _height(self, x: Floats) -> Floats:
        value = function(self.expression)
        return np.array([value(place) for place in x])

    def said(self, unit: Unit) -> str:
        """Return a description of its expression, in inches, and its origin."""
        inches = ", in inches" if unit is not INCH else ""
        return (
            f"{self._kind('curve')} y = {self.expression}{inches}, x from {self.first:g} to {self.last:g}, "
            f"origin {unit.place(self.x, self.y)}"
        )


@dataclass(frozen=True, eq=False)
class Outline(Curve):
    """A closed line through `corners`, (n, 2), counterclockwise, about `x`, `y`; `what` describes it."""

    closed = True

    x: float
    y: float
    corners: Floats
    what: str
    beside: float = 0

    def surface(self, part: Floats) -> tuple[Floats, Floats]:
        """Return points in equal steps along the line, more where a cutter rounds a corner."""
        sides = np.roll(self.corners, -1, axis=0) - self.corners
        length = np.hypot(sides[:, 0], sides[:, 1])
        normals = np.column_stack([sides[:, 1], -sides[:, 0]]) / length[:, None]
        ends = np.concatenate([[0.0], np.cumsum(length)])
        along = part * ends[-1]
        side = np.minimum(np.searchsorted(ends, along, side="right") - 1, len(sides) - 1)
        points = self.corners[side] + ((along - ends[side]) / length[side])[:, None] * sides[side]
        angles = np.arctan2(normals[:, 1], normals[:, 0])
        turns = (angles - np.roll(angles, 1) + np.pi) % (2 * np.pi) - np.pi
        steps = np.where(turns * self.beside >= 0, np.ceil(np.abs(turns) / _FAN), 0).astype(np.intp)
        at = np.repeat(np.arange(len(steps)), np.maximum(steps - 1, 0))
        step = np.arange(len(at)) - np.searchsorted(at, at) + 1
        back = turns[at] * (1 - step / steps[at])
        fan = np.column_stack([np.cos(angles[at] - back), np.sin(angles[at] - back)])
        order = np.argsort(np.concatenate([along, ends[at]]), kind="stable")
        return (
            np.concatenate([points, self.corners[at]])[order],
            np.concatenate([normals[side], fan])[order],
        )

    @property
    def tips(self) -> Floats:
        """The points where it turns by more than a curve's points do."""
        sides = np.roll(self.corners, -1, axis=0) - self.corners
        ways = np.arctan2(sides[:, 1], sides[:, 0])
        turns = (ways - np.roll(ways, 1) + np.pi) % (2 * np.pi) - np.pi
        return self.corners[np.abs(turns) > _CORNER]

    def said(self, unit: Unit) -> str:
        """Return a description of the outline and its centre."""
        return f"{self._kind(self.what)}, centre {unit.place(self.x, self.y)}"


def curve(nominal: Nominal, cutter: float) -> Curve:
    """Return the curve for a cutter of this diameter, in thousandths. Raises WorkError if there is none."""
    beside = {"": 0.0, "above": 0.5, "outside": 0.5, "below": -0.5, "inside": -0.5}[nominal.side] * cutter
    thousandths = [round(number * 1000, 6) for number in nominal.numbers]
    x, y = thousandths[:2]
    if nominal.kind == "line":
        return StraightLine(*thousandths)
    if nominal.kind in ("circle", "ellipse"):
        return Ellipse(x, y, thousandths[2], thousandths[-1], beside)
    if nominal.kind == "function":
        return Graph(x, y, nominal.expression, nominal.numbers[2], nominal.numbers[3], beside)
    if nominal.expression or not nominal.points:
        radius = function(nominal.expression)
        angles = [2 * pi * place / _PLACES for place in range(_PLACES)]
        places = [(radius(angle) * cos(angle), radius(angle) * sin(angle)) for angle in angles]
        what = f"profile r = {nominal.expression}"
    else:
        around = zip(nominal.points, (*nominal.points[1:], *nominal.points[:1]), strict=True)
        places = [here for here, there in around if here != there]
        what = f"outline of {len(places)} points"
    return Outline(x, y, np.array([x, y]) + 1000 * np.array(places), what, beside)


def fitted(points: Floats, within: float, band: float = 0) -> Ellipse | StraightLine | None:
    """Return the line, circle or ellipse nearest to the points (n, 2), None if it misses some by more than
    `within` or spans less than a quarter; constants are multiples of five thousandths if it stays within
    `band`.
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
