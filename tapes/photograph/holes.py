"""The holes of a sheet: seen near their places, they say where the sheet is.

Nothing is known of a row at first but its own holes. So slant and width of what lies beside it are tried, and
the likeliest path of both along the tape is taken; then the holes that are near their places fit the sheet,
ever farther from the row and ever less stiffly.
"""

import cv2
import numpy as np

from tapes.photograph.flat import SAMPLES, Flat, flatten
from tapes.photograph.pixels import Array, vertex
from tapes.photograph.sheet import KNOTS, Points, Sheet, fit, holes_at
from tapes.photograph.sprockets import Row, Sizes

_SKEW_STEP, _WIDTH_STEP = 0.05, 0.045
_SKEWS = _SKEW_STEP * np.arange(-12, 13)
_WIDTHS = np.exp(_WIDTH_STEP * np.arange(-11, 13))
_EVERY, _STIFFNESS = 4, 0.03
_ASTRAY = 4
"""Samples from its place within which a hole is looked for."""
FAINT = 0.05
"""What places count that only hold the sheet where there are no holes."""


def by_holes(pictures: Sizes, row: Row) -> Sheet:
    """Return the sheet of a row by the holes beside it, whatever track it is."""
    sheet = _first(pictures, row)
    for reach, knots in ((2, 60), (2, 40), (3, 30), (5, 20), (7, 14), (9, KNOTS)):
        holes, astray = find_holes(flatten(pictures, sheet), sheet, range(-reach, reach + 1))
        held = grid(sheet)
        held = held._replace(weight=FAINT * _trust(astray)[held.u])
        sheet = fit(sheet.length, holes.and_(row_points(row), held), sheet, knots)
    return sheet


def _trust(astray: Array) -> Array:
    """Return what holes count that are astray by so many pitches."""
    return np.asarray(1 / (1 + (astray / 0.07) ** 4))


def row_points(row: Row) -> Points:
    """Return the holes of a row as points; those that were put in count little."""
    u = np.arange(len(row.places), dtype=float)
    return holes_at(u, 0 * u, row.places, np.where(row.seen, 1, FAINT))


def grid(sheet: Sheet, width: float = 1) -> Points:
    """Return places of the sheet as points, to fit it again with another width."""
    u, v = (axis.ravel() for axis in np.meshgrid(np.arange(sheet.length), [-3.0, -1.5, 0, 2.5, 5]))
    return holes_at(u, v, sheet.place(u, v * width))


def _first(pictures: Sizes, row: Row) -> Sheet:
    """Return the sheet of a row by the slant and distance at which most is dark beside it."""
    length = len(row.places)
    steps = cv2.blur(np.gradient(row.places, axis=0), (1, 17), borderType=cv2.BORDER_REPLICATE)
    square = np.stack([-steps[:, 1], steps[:, 0]], axis=1)
    flat = flatten(pictures, fit(length, _beside(row, square)))
    spots = flat.spots.clip(0, np.quantile(flat.spots, 0.98))
    tracks = np.array([track for track in range(-6, 7) if track])
    skews, widths = (axis.ravel() for axis in np.meshgrid(_SKEWS, _WIDTHS))
    along = np.arange(length)[:, None, None] + skews[:, None] * tracks * widths[:, None]
    depth = flat.take(spots, along, tracks * widths[:, None]).mean(axis=2)
    best = _likeliest(depth, np.stack([skews / _SKEW_STEP, np.log(widths) / _WIDTH_STEP], axis=1))
    across = (square + skews[best][:, None] * steps) * widths[best][:, None]
    return fit(length, _beside(row, across), None, 60)


def _likeliest(depth: Array, states: Array) -> Array:
    """Return for each row which state (n, 2) fits best if it changes little from row to row: of all paths,
    the one that gathers most of `depth` (rows, n).
    """
    gathered = cv2.blur(depth, (1, 17), borderType=cv2.BORDER_REFLECT)[::_EVERY]
    score = (gathered - np.median(gathered)) / np.ptp(gathered)
    change = _STIFFNESS * ((states[:, None] - states) ** 2).sum(axis=2)
    total, ways = score[0], []
    for here in score[1:]:
        reached = total[:, None] - change
        ways.append(reached.argmax(axis=0))
        total = reached.max(axis=0) + here
    path = [int(total.argmax())]
    for way in ways[::-1]:
        path.append(int(way[path[-1]]))
    return np.repeat(path[::-1], _EVERY)[: len(depth)]


def _beside(row: Row, across: Array) -> Points:
    """Return the row, and places three pitches beside it."""
    u = np.arange(len(across), dtype=float)
    sides = (holes_at(u, np.full_like(u, side), row.places + side * across, 0.3) for side in (-3.0, 3.0))
    return row_points(row).and_(*sides)


def find_holes(flat: Flat, sheet: Sheet, tracks: range) -> tuple[Points, Array]:
    """Return the holes that are seen near their places, and how far off they are around each row."""
    u, v = np.meshgrid(np.arange(sheet.length), np.array(tracks), indexing="ij")
    near = np.arange(-_ASTRAY, _ASTRAY + 1)
    x, y = flat.at(u, v)
    patch = flat.spots[
        (y[..., None, None] + near[:, None]).astype(int), (x[..., None, None] + near).astype(int)
    ]
    depth = patch.reshape(*u.shape, -1)
    down, aside = np.unravel_index(depth.argmax(axis=2), patch.shape[2:])
    inside = (down % (2 * _ASTRAY) > 0) & (aside % (2 * _ASTRAY) > 0)
    deep = depth.max(axis=2)
    seen = inside & (deep > 0.6 * np.median(deep[:, tracks.index(0)]))
    patch, down, aside, at = patch[seen], down[seen], aside[seen], np.arange(seen.sum())
    off_u = (near[aside] + vertex(*(patch[at, down, aside + step] for step in (-1, 0, 1)))) / SAMPLES
    off_v = (near[down] + vertex(*(patch[at, down + step, aside] for step in (-1, 0, 1)))) / SAMPLES
    u, v, off = u[seen], v[seen], off_u**2 + off_v**2
    around = np.ones(7)
    squares = np.convolve(np.bincount(u, off, sheet.length), around, "same")
    count = np.convolve(np.bincount(u, minlength=sheet.length), around, "same")
    astray = np.sqrt(squares / np.maximum(count, 1))
    weight = _trust(astray)[u] / (1 + off / 0.1**2)
    return holes_at(u, v, sheet.place(u + off_u, v + off_v), weight), astray
