"""A straight tape, drawn PITCH pixels a row, each of whose places is known: track v of row u is at
(MARGIN + u, MARGIN + v) pitches.
"""

from collections.abc import Iterable

import numpy as np

from tapes.photograph.pixels import Array
from tapes.photograph.sheet import Sheet, fit, holes_at
from tapes.photograph.sprockets import Row, Sizes

PITCH, MARGIN = 12, 15
CODE, FEED = 0.36, 0.23
"""Radii of holes (ECMA-10), in pitches."""
TRACKS = (-3, -2, -1, 1, 2, 3, 4, 5)


def tape(
    length: int, codes: Iterable[tuple[float, float]] = (), feed: Iterable[float] | None = None
) -> Array:
    """Return the light of a tape with feed holes in all rows, or those named, and code holes (row, track)."""
    light = np.full((2 * MARGIN * PITCH + 1, (2 * MARGIN + length - 1) * PITCH + 1), 60.0)
    paper(light, (-0.5, length - 0.5), (-3.92, 6.08))
    for u in range(length) if feed is None else feed:
        hole(light, u, 0, FEED)
    for u, v in codes:
        hole(light, u, v, CODE)
    return light


def paper(light: Array, along: tuple[float, float], across: tuple[float, float], level: float = 200) -> None:
    """Draw a rectangle, from and to places in pitches."""
    v, u = (np.arange(size) / PITCH - MARGIN for size in light.shape)
    rows = _soft(v - across[0]) * _soft(across[1] - v)
    columns = _soft(u - along[0]) * _soft(along[1] - u)
    light += np.outer(rows, columns) * (level - light)


def hole(light: Array, u: float, v: float, radius: float, level: float = 60) -> None:
    first = [max(0, int((place + MARGIN - radius) * PITCH) - 1) for place in (v, u)]
    window = light[tuple(slice(start, start + int(2 * radius * PITCH) + 4) for start in first)]
    y, x = (
        np.arange(start, start + size) / PITCH - MARGIN
        for start, size in zip(first, window.shape, strict=True)
    )
    window += _soft(radius - np.hypot(x - u, y[:, None] - v)) * (level - window)


def _soft(inside: Array) -> Array:
    """Return how much of a pixel lies inside an edge that is so many pitches away."""
    return (inside * PITCH + 0.5).clip(0, 1)


def pictures(light: Array) -> Sizes:
    return Sizes([light.astype(np.float32)])


def sheet(length: int, along: float = 1, across: float = 1) -> Sheet:
    """Return the sheet of such a tape."""
    u, v = (axis.ravel() for axis in np.meshgrid(np.arange(float(length)), np.arange(-3.0, 6)))
    return fit(length, holes_at(u, v, at(u * along, v * across)))


def at(u: Array, v: Array) -> Array:
    return (np.stack(np.broadcast_arrays(u, v), axis=-1) + MARGIN) * PITCH


def row(length: int, track: float = 0) -> Row:
    return Row(at(np.arange(float(length)), np.array(track)), np.ones(length, bool))
