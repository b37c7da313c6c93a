"""The holes of a sheet: seen near their places, they say where the sheet is.

Nothing is known of a row at first but its own holes. So slants and widths of what is beside it are tried, and
the likeliest path of both along the tape is taken. Then the sheet is fitted to the holes that are near their
places, step by step farther from the row, and each time less stiffly.
"""

import cv2
import numpy as np

from tapes.photograph.flat import BEYOND, SAMPLES, Flat, find_spots, flatten
from tapes.photograph.pixels import Array, vertex
from tapes.photograph.sheet import FIVE, KNOTS, THREE, Points, Sheet, fit, holes_at
from tapes.photograph.sprockets import Row, Sizes

FULL = 12
"""Pitches to each side of a row that may be any track of a tape."""

_AROUND = 1, 17
"""Columns and rows over which is smoothed along the tape."""
_SKEW_STEP, _WIDTH_STEP = 0.05, 0.045
_SKEWS = _SKEW_STEP * np.arange(-12, 13)
_WIDTHS = np.exp(_WIDTH_STEP * np.arange(-11, 13))
_EVERY, _STIFFNESS = 4, 0.03
_ASTRAY = 4
"""Samples from its place within which a hole is looked for."""
_MIDDLE = 0.1
"""Pitches over which a hole is smoothed to find its middle: what is seen through it then moves it little."""
_FAINT = 0.02
"""The weight of places that only keep the sheet in shape where there are no holes."""


def by_holes(pictures: Sizes, row: Row) -> Sheet:
    """Return the sheet of a row by the holes beside it, whatever track it is."""
    sheet = _first(pictures, row)
    for reach, knots in ((2, 60), (2, 40), (3, 30), (5, 20), (7, 14), (9, KNOTS)):
        flat = flatten(pictures, sheet, reach + 1.5)
        holes, _ = find_holes(flat, sheet, range(-reach, reach + 1))
        sheet = fit(sheet.length, sprocket_points(row).and_(holes, grid(sheet, weight=_FAINT)), sheet, knots)
    return sheet


def sprocket_points(row: Row) -> Points:
    u = np.arange(len(row.places), dtype=float)
    return holes_at(u, 0 * u, row.places, np.where(row.seen, 1, 0.05))


def grid(sheet: Sheet, width: float = 1, weight: float = 1) -> Points:
    """Return places of the sheet as points, to fit it again with another width."""
    u, v = np.stack(np.meshgrid(np.arange(sheet.length), [-3, -1.5, 0, 2.5, 5])).reshape(2, -1)
    return holes_at(u, v, sheet.place(u, v * width), weight)


def _first(pictures: Sizes, row: Row) -> Sheet:
    """Return the sheet of a row, its slant and distance those that put most dark places on its tracks."""
    length = len(row.places)
    steps = cv2.blur(np.gradient(row.places, axis=0), _AROUND, borderType=cv2.BORDER_REPLICATE)
    square = np.stack([-steps[:, 1], steps[:, 0]], axis=1)
    u = np.arange(length, dtype=float)
    sheet = fit(length, _beside(row, square))
    flat = flatten(pictures, sheet, 1.3 * FULL)
    spots = np.maximum(find_spots(flat.dark), 0)
    tracks = np.array([track for track in range(-6, 7) if track])
    skews, widths = (axis.ravel() for axis in np.meshgrid(_SKEWS, _WIDTHS))
    along = u[:, None, None] + skews[:, None] * tracks * widths[:, None]
    aside = np.broadcast_to(tracks * widths[:, None], along.shape)
    depth = flat.take(np.minimum(spots, np.quantile(spots, 0.98)), along, aside).mean(axis=2)
    best = _likeliest(depth, np.stack([skews / _SKEW_STEP, np.log(widths) / _WIDTH_STEP], axis=1))
    across = (square + skews[best][:, None] * steps) * widths[best][:, None]
    return fit(length, _beside(row, across), None, 60)


def _likeliest(depth: Array, states: Array) -> Array:
    """For each row the state (n, 2) of the path that gathers most `depth` (rows, n) with small changes."""
    rows = np.arange(0, len(depth), _EVERY)
    gathered = cv2.blur(depth, _AROUND, borderType=cv2.BORDER_REFLECT)[rows]
    score = gathered / (gathered.max() - np.median(gathered) + 1e-9)
    change = _STIFFNESS * ((states[:, None] - states) ** 2).sum(axis=2)
    total, ways = score[0], []
    for here in score[1:]:
        reached = total[:, None] - change
        ways.append(reached.argmax(axis=0))
        total = reached.max(axis=0) + here
    path = [int(total.argmax())]
    for way in ways[::-1]:
        path.append(int(way[path[-1]]))
    return np.array(path[::-1])[np.arange(len(depth)) // _EVERY]


def _beside(row: Row, across: Array) -> Points:
    """Return the row, and places three pitches beside it."""
    u = np.arange(len(across), dtype=float)
    sides = (holes_at(u, np.full_like(u, side), row.places + side * across, 0.3) for side in (-3.0, 3.0))
    return sprocket_points(row).and_(*sides)


def find_holes(flat: Flat, sheet: Sheet, tracks: range) -> tuple[Points, Array]:
    """Return the holes that are seen near their places, and how far off they are around each row."""
    spots = find_spots(flat.dark)
    u, v = np.meshgrid(np.arange(sheet.length, dtype=float), np.array(tracks, dtype=float), indexing="ij")
    near = np.arange(-_ASTRAY, _ASTRAY + 1)
    x, y = (axis.astype(int) for axis in flat.at(u, v))
    around = y[..., None, None] + near[:, None], x[..., None, None] + near
    deep = spots[around].max(axis=(2, 3))
    patch = cv2.GaussianBlur(spots, (0, 0), _MIDDLE * SAMPLES)[around]
    down, aside = np.unravel_index(patch.reshape(*u.shape, -1).argmax(axis=2), patch.shape[2:])
    inside = np.maximum(abs(near[down]), abs(near[aside])) < _ASTRAY
    limit = 0.6 * np.median(deep[:, tracks.index(0)])
    seen = inside & (deep > limit)
    patch, down, aside, at = patch[seen], down[seen], aside[seen], np.arange(seen.sum())
    off_x = near[aside] + vertex(*(patch[at, down, aside + step] for step in (-1, 0, 1)))
    off_y = near[down] + vertex(*(patch[at, down + step, aside] for step in (-1, 0, 1)))
    off_u = (x[seen] + off_x) / SAMPLES - BEYOND - u[seen]
    off_v = (y[seen] + off_y) / SAMPLES - flat.reach - v[seen]
    u, v = u[seen], v[seen]
    squares = np.bincount(u.astype(int), off_u**2 + off_v**2, sheet.length)
    count = np.bincount(u.astype(int), minlength=sheet.length).astype(float)
    width = np.ones(7)
    astray = np.sqrt(np.convolve(squares, width, "same") / np.maximum(np.convolve(count, width, "same"), 1))
    astray = np.maximum(astray, _strays(flat, sheet, spots, limit))
    trust = 1 / (1 + (astray / 0.07) ** 4)
    weight = trust[u.astype(int)] / (1 + (off_u**2 + off_v**2) / 0.1**2)
    return holes_at(u, v, sheet.place(u + off_u, v + off_v), weight), astray


def _strays(flat: Flat, sheet: Sheet, spots: Array, limit: float) -> Array:
    """Return for each row how far a nearby spot is from every hole's place."""
    y, x = np.nonzero((spots > limit) & (spots >= cv2.dilate(spots, np.ones((7, 7), np.uint8))))
    u, v = x / SAMPLES - BEYOND, y / SAMPLES - flat.reach
    off = np.maximum(abs(u - np.rint(u)), abs(v - np.rint(v)))
    stray = (
        (off * SAMPLES > _ASTRAY - 0.5)
        & (v > 0.7 - THREE)
        & (v < FIVE - 0.7)
        & (u > -0.5)
        & (u < sheet.length - 0.5)
    )
    found = np.zeros(sheet.length)
    np.maximum.at(found, np.rint(u[stray]).astype(int), off[stray])
    return np.asarray(cv2.dilate(found[:, None], np.ones((5, 1), np.uint8))[:, 0])
