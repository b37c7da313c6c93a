"""Rows of small round holes in a picture, followed one by one: a tape's sprocket holes are such a row.

    spots     places darker than what is around them, at each of several sizes of the picture
    starts    ten spots in a row, as far apart as it takes
    rows      from a start on both ways, hole by hole: where the next one is expected, something round and as
              dark has to be. A few may be missing, and are put in between.

Rows are found among code holes too, and in many a picture without a tape: paper.py says which are a tape's.
Holes are dark; the picture of a tape lit from behind has to be inverted. Needs OpenCV, the extra `vision`.
"""

from typing import NamedTuple

import cv2
import numpy as np

from tapes.photograph.pixels import Array, vertex

FEWEST = 10
"""Frames of a tape: not even a frame of all holes has so many in a row."""

_STEP = 2**0.5
"""From one size of the picture to the next."""
_NEAR, _FAR = 4.7, 10.5
"""Pixels from hole to hole that are looked for at each size."""
_SMALLEST = 50
"""Pixels of a picture, across or down, that are too few for the width of a tape."""
_MOST_SPOTS = 12_000
_MOST_ROWS = 40
_LONGEST_GAP = 12
_AFTER_GAP = 4
"""So many holes in a row have to follow a gap of more than two."""
_REACH = 0.3
"""Of a step, within which a hole is of its place."""


class Row(NamedTuple):
    """Holes in a row: places (n, 2) in pixels, and which were seen; the others were put in between."""

    places: Array
    seen: Array


class Size(NamedTuple):
    """A picture; how much darker it is in each place than around, as a part of the light there; which places
    are deeper than those beside them; and its pixels to one of the first's.
    """

    light: Array
    depth: Array
    spot: Array
    scale: float


class Sizes(NamedTuple):
    """A picture in several sizes, each smaller than the one before by the square root of 2."""

    pictures: list[Size]

    def for_step(self, step: float) -> Size:
        """Return the picture in which `step` pixels of the first are some 11."""
        wanted = np.log(max(step, 9) / 9) / np.log(_STEP)
        return self.pictures[min(int(wanted), len(self.pictures) - 1)]


def sizes(light: Array) -> Sizes:
    """Return the picture, shades of grey, in all sizes in which a row may be found."""
    found: list[Size] = []
    wide, high = light.shape[::-1]
    while min(wide, high) > _SMALLEST:
        picture = cv2.resize(light, (wide, high), interpolation=cv2.INTER_AREA)
        relative: Array = picture / (cv2.blur(picture, (41, 41)) + 4)
        soft, sharp = (np.asarray(cv2.GaussianBlur(relative, (0, 0), width)) for width in (2.1, 1.1))
        depth = soft - sharp
        spot = depth >= cv2.dilate(depth, np.ones((3, 3)))
        found.append(Size(picture, depth, spot, wide / light.shape[1]))
        wide, high = (round(length / _STEP ** len(found)) for length in light.shape[::-1])
    return Sizes(found)


def starts(pictures: Sizes) -> list[Array]:
    """Return places (FEWEST, 2) of spots in a row, in pixels, the clearest first."""
    found: list[tuple[float, Array]] = []
    for _, depth, spot, scale in pictures.pictures:
        y, x = np.nonzero(spot & (depth > 4 * np.median(abs(depth))))
        deepest = np.argsort(-depth[y, x])[:_MOST_SPOTS]
        y, x = y[deepest], x[deepest]
        places = np.stack([x, y], axis=1).astype(float)
        for row in _straight(places, depth.shape):
            found.append((float(depth[y[row], x[row]].min()), (places[row] + 0.5) / scale - 0.5))
    return [row for _, row in sorted(found, key=lambda pair: -pair[0])]


def _straight(places: Array, shape: tuple[int, ...]) -> Array:
    """Return the numbers (n, FEWEST) of spots that follow each other at like distances and directions."""
    numbered = np.zeros(shape, np.uint16)
    x, y = places.astype(int).T
    numbered[y, x] = np.arange(1, len(places) + 1)
    which = np.asarray(cv2.dilate(numbered, np.ones((3, 3))))

    def spot_at(place: Array) -> Array:
        x, y = np.rint(place).astype(int).T
        found = which[y.clip(0, shape[0] - 1), x.clip(0, shape[1] - 1)].astype(int)
        return np.array([np.arange(len(place)), found - 1])[:, found > 0]

    offsets = np.arange(-_FAR, _FAR + 1, 2)
    pairs = [spot_at(places + np.array([aside, down])) for aside in offsets for down in offsets]
    rows = np.unique(np.concatenate(pairs, axis=1), axis=1).T
    length = np.hypot(*(places[rows[:, 1]] - places[rows[:, 0]]).T)
    rows = rows[(length > _NEAR) & (length < _FAR)]
    while rows.shape[1] < FEWEST:
        step = (places[rows[:, -1]] - places[rows[:, 0]]) / (rows.shape[1] - 1)
        expected = places[rows[:, -1]] + step
        kept, following = spot_at(expected)
        near = np.hypot(*(places[following] - expected[kept]).T) < _REACH * np.hypot(*step[kept].T)
        rows = np.concatenate([rows[kept], following[:, None]], axis=1)[near]
    return np.asarray(rows)


class _Hole(NamedTuple):
    number: int
    place: Array
    depth: float


def follow(pictures: Sizes, start: Array) -> Row:
    """Return the whole row that a start belongs to."""
    steps = np.gradient(start, axis=0)
    holes = [_Hole(at, *measured(pictures, *pair)) for at, pair in enumerate(zip(start, steps, strict=True))]
    for _ in range(2):
        holes = _followed(pictures, holes)[::-1]
    numbers = [hole.number for hole in holes]
    all_numbers = np.arange(numbers[0], numbers[-1] + 1)
    places = [np.interp(all_numbers, numbers, axis) for axis in np.transpose([hole.place for hole in holes])]
    return Row(np.stack(places, axis=1), np.isin(all_numbers, numbers))


def _followed(pictures: Sizes, holes: list[_Hole]) -> list[_Hole]:
    """Return the holes with those beyond the last one, as far as no gap is too long."""
    gap = 0
    while gap <= _LONGEST_GAP:
        wanted = _AFTER_GAP if gap > 2 else 1
        ahead: list[_Hole] = []
        while len(ahead) < wanted and (hole := _next(pictures, holes + ahead, 0 if ahead else gap)):
            ahead.append(hole)
        gap = 0 if len(ahead) == wanted else gap + 1
        holes = holes if gap else holes + ahead
    return holes


def _next(pictures: Sizes, holes: list[_Hole], gap: int) -> _Hole | None:
    """Return the hole that follows after a gap, None if none is there."""
    numbers = np.array([hole.number for hole in holes[-FEWEST:]])
    at = numbers[-1] + (1 + gap) * np.sign(numbers[-1] - numbers[0])
    place, step = np.polyfit(numbers - at, [hole.place for hole in holes[-FEWEST:]], 2)[:0:-1]
    hole = _Hole(int(at), *measured(pictures, place, step))
    deep = hole.depth > 0.35 * np.median([hole.depth for hole in holes[-FEWEST:]])
    near = np.hypot(*(hole.place - place)) < _REACH * np.hypot(*step)
    return hole if deep and near and np.hypot(*step) > 3 else None


def measured(pictures: Sizes, place: Array, step: Array) -> tuple[Array, float]:
    """Return the middle of the hole that is nearest to `place`, and how much darker it is than around it, as
    a part of the light there. `step` leads to the next hole.
    """
    _, depth, spot, scale = pictures.for_step(float(np.hypot(*step)))
    reach = min(round(0.4 * float(np.hypot(*step)) * scale), _SMALLEST // 5)
    most = np.array(depth.shape[::-1]) - reach - 2
    x, y = np.rint((place + 0.5) * scale - 0.5).astype(int).clip(reach + 1, most)
    around = slice(y - reach, y + reach + 1), slice(x - reach, x + reach + 1)
    patch = np.where(spot[around], depth[around], 0)
    down, aside = np.unravel_index(int(patch.argmax()), patch.shape)
    x, y = x + aside - reach, y + down - reach
    off = [vertex(*depth[y, x - 1 : x + 2]), vertex(*depth[y - 1 : y + 2, x])]
    return (np.array([x, y]) + off + 0.5) / scale - 0.5, float(patch.max())


def rows(pictures: Sizes) -> list[Row]:
    """Return the rows of holes in a picture, the longest first; none twice."""
    found: list[Row] = []
    left = np.array(starts(pictures)).reshape(-1, FEWEST, 2)
    while len(left) and len(found) < _MOST_ROWS:
        row = follow(pictures, left[0])
        found.append(row)
        left = left[1:][_apart(row, left[1:, FEWEST // 2])]
    return sorted(found, key=lambda row: -int(row.seen.sum()))


def _apart(row: Row, places: Array) -> Array:
    """Tell which places (n, 2) are not within half a step of one of a row's holes."""
    step = np.hypot(*np.gradient(row.places, axis=0).T)
    away = np.hypot(*np.moveaxis(places[:, None] - row.places, 2, 0))
    return np.asarray((away > 0.5 * step).all(axis=1))
