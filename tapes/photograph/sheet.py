"""Where each place of a tape lies in a picture: paper that lies flat, or bends along its length.

    place(u, v)    u counts rows of holes from the first, v pitches across from the sprocket track

    a(u) + v b(u) / (1 + v w(u))      a, b, w: splines along the tape

Each row of holes is a straight line, seen in perspective; from row to row everything may change slowly.
"""

from typing import NamedTuple

import cv2
import numpy as np

from tapes.photograph.pixels import Array

THREE, FIVE = 3.92, 6.08
"""Pitches from the sprocket track to the edges beside three and five channels (ECMA-10)."""

KNOTS = 10
"""Rows from knot to knot of the splines that give how the tape lies across its length."""
_KNOTS = 6


class Spline(NamedTuple):
    """Cubic B-splines along a tape of `length` rows, with knots every `knots` rows."""

    length: int
    pieces: int

    def at(self, rows: Array) -> Array:
        """Return the weight of each spline (n, pieces + 3) at each row (n,)."""
        x = rows / (self.length - 1) * self.pieces
        piece = np.clip(np.floor(x), 0, self.pieces - 1).astype(int)
        t = x - piece
        weights = np.stack(
            [(1 - t) ** 3, 3 * t**3 - 6 * t**2 + 4, -3 * t**3 + 3 * t**2 + 3 * t + 1, t**3], axis=1
        )
        found = np.zeros((len(rows), self.pieces + 3))
        for number in range(4):
            found[np.arange(len(rows)), piece + number] = weights[:, number] / 6
        return found

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
        """Tell whether it lies beneath or close beside some of the places (n, 2), in pixels."""
        u = np.arange(-1.0, self.length + 1)
        sides = [self.place(along, np.array([aside])) for along, aside in ((u, -5.5), (u[::-1], 7.5))]
        outline = np.concatenate(sides).astype(np.float32)
        inside = sum(cv2.pointPolygonTest(outline, place, False) > 0 for place in places.tolist())
        return bool(inside > 0.2 * len(places))

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
    """Places seen: row, track, pixels, the unit vector along which the distance counts, and its weight."""

    u: Array
    v: Array
    pixels: Array
    direction: Array
    weight: Array

    def and_(self, *others: "Points") -> "Points":
        """Return both sets of points as one."""
        return Points(*(np.concatenate(parts) for parts in zip(self, *others, strict=True)))


def holes_at(u: Array, v: Array, pixels: Array, weight: Array | float = 1) -> Points:
    """Return the middles of holes as points: their distance counts in all directions."""
    weights = np.broadcast_to(np.asarray(weight, dtype=float), u.shape)
    on_x, on_y = (np.tile(way, (len(u), 1)) for way in np.eye(2))
    return Points(u, v, pixels, on_x, weights).and_(Points(u, v, pixels, on_y, weights))


def fit(length: int, points: Points, first: Sheet | None = None, knots: int = KNOTS) -> Sheet:
    """Return the sheet of `length` rows that fits the points best, by least squares.

    What crosses the tape may bend every `knots` rows. How the tracks draw together, `narrowing`, is found
    only where there is a `first` sheet that says how far each point is from the sprocket track.
    """
    soft = Spline(length, round(length / _KNOTS))
    stiff = Spline(length, max(1, round(length / knots)))
    pitch = float(np.hypot(*np.ptp(points.pixels, axis=0))) / length
    a, b = soft.at(points.u), stiff.at(points.u)
    x, y = points.direction[:, :1], points.direction[:, 1:]
    v = points.v[:, None]
    base = first.place(points.u, 0 * points.v) if first else points.pixels
    away = ((points.pixels - base) * points.direction).sum(axis=1)[:, None] / pitch
    counts = [a.shape[1], a.shape[1], b.shape[1], b.shape[1], b.shape[1]]
    stiffness = _blocks([(0.02, soft), (0.02, soft), (0.15, stiff), (0.15, stiff), (20, stiff)], counts)
    small = np.concatenate([np.zeros((counts[4], sum(counts[:4]))), 3 * np.eye(counts[4])], axis=1)
    seen = np.concatenate([x * a, y * a, x * v * b, y * v * b, -v * away * b], axis=1)
    matrix = np.concatenate([seen * points.weight[:, None], stiffness, small])
    right = np.zeros(len(matrix))
    right[: len(seen)] = (points.pixels * points.direction).sum(axis=1) / pitch * points.weight
    found = np.linalg.solve(matrix.T @ matrix + 1e-9 * np.eye(sum(counts)), matrix.T @ right)
    ax, ay, bx, by, w = np.split(found, np.cumsum(counts)[:-1])
    return Sheet(soft, stiff, np.stack([ax, ay], axis=1) * pitch, np.stack([bx, by], axis=1) * pitch, w)


def _blocks(bends: list[tuple[float, Spline]], counts: list[int]) -> Array:
    """Return rows that make each block of coefficients stiff."""
    rows = []
    for number, (stiffness, spline) in enumerate(bends):
        row = np.zeros((spline.pieces + 1, sum(counts)))
        start = sum(counts[:number])
        row[:, start : start + counts[number]] = stiffness * spline.bends()
        rows.append(row)
    return np.concatenate(rows)
