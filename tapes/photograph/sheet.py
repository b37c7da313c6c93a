"""Where each place of a tape lies in a picture: paper that lies flat, or bends along its length.

    place(u, v)    u counts rows of holes from the first, v pitches across from the sprocket track

    a(u) + v b(u) / (1 + v w(u))      a, b, w: splines along the tape

Each row of holes is a straight line, seen in perspective; from row to row everything may change slowly.
"""

from itertools import pairwise
from typing import NamedTuple

import numpy as np

from tapes.photograph.pixels import Array

THREE, FIVE = 3.92, 6.08
"""Pitches from the sprocket track to the edges beside three and five channels (ECMA-10)."""

BEYOND = 4
"""Rows before the first and after the last that have a place too."""
KNOTS = 10
"""Rows from knot to knot of the splines of what crosses the tape."""
_KNOTS = 6


class Spline(NamedTuple):
    """Cubic B-splines along a tape of `length` rows and BEYOND more at each end, in so many pieces."""

    length: int
    pieces: int

    def at(self, rows: Array) -> Array:
        """Return the weight of each spline (n, pieces + 3) at each row (n,)."""
        x = (rows + BEYOND) / (self.length - 1 + 2 * BEYOND) * self.pieces
        away = abs(x[:, None] - np.arange(-1, self.pieces + 2))
        far, near = (2 - away).clip(0), (1 - away).clip(0)
        return np.asarray((far * far * far - 4 * near * near * near) / 6)

    def bends(self) -> Array:
        """Return the matrix of the second differences of its coefficients."""
        return np.diff(np.eye(self.pieces + 3), 2, axis=0)


class Sheet(NamedTuple):
    """A sheet: the splines' coefficients, and the pitch in pixels that they were fitted by."""

    soft: Spline
    stiff: Spline
    middle: Array
    across: Array
    narrowing: Array

    def place(self, u: Array, v: Array) -> Array:
        """Return the pixels (..., 2) of places on the tape: arrays that are broadcast together."""
        rows = u.ravel()
        soft, stiff = self.soft.at(rows), self.stiff.at(rows)
        a, b = (
            (weights @ place).reshape(*u.shape, 2)
            for weights, place in ((soft, self.middle), (stiff, self.across))
        )
        w = (stiff @ self.narrowing).reshape(u.shape)
        return np.asarray(a + b * (v / (1 + v * w))[..., None])

    def covers(self, places: Array) -> bool:
        """Tell whether it lies beneath some of the places (n, 2), in pixels."""
        u = np.arange(self.length, dtype=float)
        away = np.hypot(*np.moveaxis(places[:, None] - self.place(u, 0 * u), 2, 0))
        return bool((away < FIVE * self.pitches()[1]).any(axis=1).mean() > 0.2)

    @property
    def length(self) -> int:
        """How many rows it has."""
        return self.soft.length

    def pitches(self) -> tuple[Array, Array]:
        """Return the pixels from row to row and from track to track, for each row the least of both sides."""
        u = np.arange(self.length, dtype=float)
        sides = [np.array([side]) for side in (-THREE, THREE)]
        along = [np.hypot(*(self.place(u + 0.5, side) - self.place(u - 0.5, side)).T) for side in sides]
        across = [np.hypot(*(self.place(u, side + 0.5) - self.place(u, side - 0.5)).T) for side in sides]
        return np.min(along, axis=0), np.min(across, axis=0)


class Points(NamedTuple):
    """Places that were seen: row and track of each, pixels, the direction (a unit vector) along which its
    distance from the sheet counts, and how much it counts.
    """

    u: Array
    v: Array
    pixels: Array
    direction: Array
    weight: Array

    def and_(self, *others: "Points") -> "Points":
        """Return all of them."""
        return Points(*(np.concatenate(parts) for parts in zip(self, *others, strict=True)))


def holes_at(u: Array, v: Array, pixels: Array, weight: Array | float = 1) -> Points:
    """Return the middles of holes as points: their distance counts in all directions."""
    weights = np.broadcast_to(np.asarray(weight, dtype=float), u.shape)
    on_x, on_y = (np.tile(way, (len(u), 1)) for way in ((1.0, 0.0), (0.0, 1.0)))
    return Points(u, v, pixels, on_x, weights).and_(Points(u, v, pixels, on_y, weights))


def fit(length: int, points: Points, first: Sheet | None = None, knots: int = KNOTS) -> Sheet:
    """Return the sheet of `length` rows that fits the points best, by least squares.

    What crosses the tape may bend every `knots` rows. How the tracks draw together, `narrowing`, is found
    only where there is a `first` sheet that says how far each point is from the sprocket track.
    """
    soft = Spline(length, length // _KNOTS + 2)
    stiff = Spline(length, length // knots + 2)
    pitch = float(np.hypot(*np.ptp(points.pixels, axis=0))) / length
    a, b = soft.at(points.u), stiff.at(points.u)
    x, y = points.direction[:, :1], points.direction[:, 1:]
    v = points.v[:, None]
    base = first.place(points.u, 0 * points.v) if first else points.pixels
    away = ((points.pixels - base) * points.direction).sum(axis=1)[:, None] / pitch
    seen = np.concatenate([x * a, y * a, x * v * b, y * v * b, -v * away * b], axis=1)
    seen *= points.weight[:, None]
    squares = seen.T @ seen + 1e-9 * np.eye(seen.shape[1])
    ends = [0]
    for spline, stiffness in ((soft, 4e-4), (soft, 4e-4), (stiff, 0.02), (stiff, 0.02), (stiff, 400)):
        bends = spline.bends()
        block = slice(ends[-1], ends[-1] + bends.shape[1])
        squares[block, block] += stiffness * bends.T @ bends
        ends.append(block.stop)
    right = (points.pixels * points.direction).sum(axis=1) / pitch * points.weight
    found = np.linalg.solve(squares, seen.T @ right)
    ax, ay, bx, by, w = (found[start:end] for start, end in pairwise(ends))
    return Sheet(soft, stiff, np.stack([ax, ay], axis=1) * pitch, np.stack([bx, by], axis=1) * pitch, w)
