"""Rows of small round holes in a picture, followed one by one: a tape's sprocket holes are such a row.

    spots     places darker than what is around them, at each of several sizes of the picture
    starts    ten spots and more in a row, as far apart as it takes
    rows      from a start on both ways, hole by hole: where the next one is expected, something round and as
              dark has to be. A few may be missing, and are put in between.

Rows are found among code holes too, and in many a picture without a tape: sheet.py says which are a tape's.
Holes are dark; the picture of a tape lit from behind has to be inverted.
"""

from typing import NamedTuple

import cv2
import numpy as np

from tapes.photograph.pixels import Array, between, vertex

FEWEST = 10
"""Frames of a tape: not even a frame of all holes has so many in a row."""

_NEIGHBOURS = np.ones((3, 3), np.uint8)
_STEP = 2**0.5
"""From one size of the picture to the next."""
_NEAR, _FAR = 4.7, 10.5
"""Pixels from hole to hole that are looked for at each size."""
_MOST_SPOTS = 12_000
_FAINTEST = 0.015
_MOST_ROWS = 100
_LONGEST_GAP = 12
_AFTER_GAP = 4
"""So many holes in a row have to follow a gap of more than two."""
_REACH = 0.32
_SAMPLES = 10
"""Samples in the distance of two rows, where a hole is measured."""


class Row(NamedTuple):
    """A row of holes: places (n, 2) in pixels, and which were seen; the others are interpolated."""

    places: Array
    seen: Array


class Sizes(NamedTuple):
    """A picture in several sizes, each smaller than the one before by the square root of 2."""

    pictures: list[Array]

    def for_step(self, step: float) -> tuple[Array, float]:
        """Return the picture in which a step of `step` pixels becomes about 11, and its scale."""
        at = int(np.clip(np.floor(np.log(step / 9) / np.log(_STEP)), 0, len(self.pictures) - 1))
        return self.pictures[at], self.pictures[at].shape[1] / self.pictures[0].shape[1]

    def show(self, places: Array) -> Array:
        """Tell which places (..., 2), in pixels, lie in the picture."""
        last = np.array(self.pictures[0].shape[::-1]) - 1
        return np.asarray(((places >= 0) & (places <= last)).all(axis=-1))


def sizes(light: Array) -> Sizes:
    """Return the picture, shades of grey, in all sizes in which a row may be found."""
    pictures: list[Array] = [light.astype(np.float32)]
    while min(pictures[-1].shape) > 90:
        scale = _STEP ** -len(pictures)
        wide, high = (round(length * scale) for length in light.shape[::-1])
        pictures.append(cv2.resize(pictures[0], (wide, high), interpolation=cv2.INTER_AREA))
    return Sizes(pictures)


def starts(pictures: Sizes) -> list[Array]:
    """Return places (FEWEST, 2) of spots in a row, in pixels, the clearest first."""
    found: list[tuple[float, Array]] = []
    for picture in pictures.pictures:
        scale = picture.shape[1] / pictures.pictures[0].shape[1]
        places, depths = _spots(picture)
        for row in _straight(places, picture.shape):
            clear = float(np.median(depths[row]) - depths[row].std())
            found.append((clear, (places[row] + 0.5) / scale - 0.5))
    return [row for _, row in sorted(found, key=lambda pair: -pair[0])]


def _spots(picture: Array) -> tuple[Array, Array]:
    """Return where it is darker than around, and by which part of the light there; the darkest last."""
    around = cv2.blur(picture, (41, 41)) + 4
    relative = picture / around
    depth = cv2.GaussianBlur(relative, (0, 0), 2.1) - cv2.GaussianBlur(relative, (0, 0), 1.1)
    faintest = max(_FAINTEST, 4.5 * float(np.median(abs(depth.ravel()[::25]))))
    top = (depth >= cv2.dilate(depth, _NEIGHBOURS)) & (depth > faintest)
    y, x = np.nonzero(top)
    kept = np.argsort(depth[y, x])[-_MOST_SPOTS:]
    y, x = y[kept], x[kept]
    return np.stack([x, y], axis=1).astype(float), depth[y, x]


def _straight(places: Array, shape: tuple[int, ...]) -> Array:
    """Return the numbers (n, FEWEST) of spots in a row, at nearly equal distances and directions."""
    margin = 16  # beyond the picture is no spot
    which: Array = np.full(shape, -1, np.float32)
    x, y = places.astype(int).T
    which[y, x] = np.arange(len(places))
    which = np.pad(cv2.dilate(which, _NEIGHBOURS), margin, constant_values=-1).astype(int)

    def spot_at(place: Array) -> Array:
        x, y = np.rint(place).astype(int).T + margin
        return np.asarray(which[y, x])

    reach = range(-9, 10, 3)
    others = [
        spot_at(places + np.array([aside, down]))
        for aside in reach
        for down in reach
        if (aside, down) > (0, 0)
    ]
    rows = np.stack([np.tile(np.arange(len(places)), len(others)), np.concatenate(others)], axis=1)
    length = np.hypot(*(places[rows[:, 1]] - places[rows[:, 0]]).T)
    rows = rows[(rows[:, 1] >= 0) & (length > _NEAR) & (length < _FAR)]
    while rows.shape[1] < FEWEST and len(rows):
        ends = rows[:, -3:]
        last = places[ends[:, -1]]
        step = (last - places[ends[:, 0]]) / (ends.shape[1] - 1)
        following = spot_at(last + step)
        near = np.hypot(*(places[following] - last - step).T) < 0.28 * np.hypot(*step.T)
        rows = np.concatenate([rows, following[:, None]], axis=1)[(following >= 0) & near]
    return np.asarray(rows)


def follow(pictures: Sizes, start: Array) -> Row:
    """Return the whole row that a start belongs to."""
    chain, depths = measured_all(pictures, start)
    after, before = (_onward(pictures, known, float(np.median(depths))) for known in (chain, chain[::-1]))
    whole = [*before[::-1], *((place, True) for place in chain), *after]
    return Row(np.array([place for place, _ in whole]), np.array([seen for _, seen in whole]))


def measured_all(pictures: Sizes, places: Array) -> tuple[Array, Array]:
    """Return the middles (n, 2) of the holes nearest to places in a row, and how much darker they are."""
    steps = np.gradient(places, axis=0)
    found = [measured(pictures, place, step) for place, step in zip(places, steps, strict=True)]
    return np.array([place for place, _ in found]), np.array([depth for _, depth in found])


def _onward(pictures: Sizes, chain: Array, depth: float) -> list[tuple[Array, bool]]:
    """Follow the holes past the chain's end until a gap is too long."""
    known = sure = list(enumerate(chain))
    found: list[tuple[Array, bool]] = []
    waiting: list[tuple[Array, bool]] = []
    run = 0
    size = pictures.pictures[0].shape[::-1]
    while len(waiting) - run <= _LONGEST_GAP:
        at = len(chain) + len(found) + len(waiting)
        place, step = _expected(known, at)
        if (place < 0).any() or (place >= size).any() or np.hypot(*step) < 3:
            break
        there, deep = measured(pictures, place, step)
        if deep > 0.35 * depth and np.hypot(*(there - place)) < _REACH * np.hypot(*step):
            depth = 0.8 * depth + 0.2 * deep
            known = [*known, (at, there)][-14:]
            waiting.append((there, True))
            run += 1
            if len(waiting) - run <= 2 or run >= _AFTER_GAP:
                found += waiting
                waiting, run, sure = [], 0, known
        else:
            waiting = [*((lost, False) for lost, _ in waiting), (place, False)]
            run, known = 0, sure
    return found


def _expected(known: list[tuple[int, Array]], at: int) -> tuple[Array, Array]:
    """Return where hole `at` is expected and the step there, by those before it: on a parabola."""
    numbers, places = zip(*known, strict=True)
    curve = np.polyfit(np.array(numbers) - at, np.array(places), 2)
    return curve[-1], curve[-2]


def measured(pictures: Sizes, place: Array, step: Array) -> tuple[Array, float]:
    """The centre of the hole nearest to `place`, its relative darkness; `step` leads to the next hole."""
    picture, scale = pictures.for_step(float(np.hypot(*step)))
    along = step / _SAMPLES
    across = np.array([-along[1], along[0]])
    x, y = ((place + _GRID[0] * along + _GRID[1] * across + 0.5) * scale - 0.5).transpose(2, 0, 1)
    patch = between(picture, x, y)
    level = float(np.partition(patch, _BRIGHT, axis=None)[_BRIGHT]) + 4
    depth = cv2.filter2D(patch / level, -1, _HOLE)
    inner = depth[_MARGIN:-_MARGIN, _MARGIN:-_MARGIN]
    down, aside = (at + _MARGIN for at in np.unravel_index(int(inner.argmax()), inner.shape))
    top = depth[down, aside]
    off_x = aside - _SIDE + vertex(depth[down, aside - 1], top, depth[down, aside + 1])
    off_y = down - _SIDE + vertex(depth[down - 1, aside], top, depth[down + 1, aside])
    return place + off_x * along + off_y * across, float(top)


def _kernel() -> Array:
    y, x = np.mgrid[-4:5, -4:5] / _SAMPLES
    away = np.hypot(x, y)
    inside, ring = np.exp(-0.5 * (away / 0.15) ** 2), ((away > 0.3) & (away < 0.44)).astype(float)
    return np.asarray((ring / ring.sum() - inside / inside.sum()), dtype=np.float32)


_MARGIN = 5
"""Samples at the border of what is measured, in which no hole has its middle: half a hole, and one more."""
_SIDE = 9
_GRID = np.mgrid[-_SIDE : _SIDE + 1, -_SIDE : _SIDE + 1, 0:1].astype(float)[1::-1]
_BRIGHT = int(0.7 * _GRID[0].size)
_HOLE = _kernel()


def rows(pictures: Sizes) -> list[Row]:
    """Return the rows of holes in a picture, none twice: first those of most holes, less those not seen."""
    found: list[Row] = []
    left = np.array(starts(pictures)).reshape(-1, FEWEST, 2)
    while len(left) and len(found) < _MOST_ROWS:
        row = follow(pictures, left[0])
        found.append(row)
        left = left[1:][_apart(row, left[1:, FEWEST // 2])]
    return sorted(found, key=lambda row: int((~row.seen).sum()) - int(row.seen.sum()))


def _apart(row: Row, places: Array) -> Array:
    """Tell which places (n, 2) are not within half a step of one of a row's holes."""
    step = np.hypot(*np.gradient(row.places, axis=0).T)
    away = np.hypot(*np.moveaxis(places[:, None] - row.places, 2, 0))
    return np.asarray((away > 0.5 * step).all(axis=1))
