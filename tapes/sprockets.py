"""Where a tape lies in a picture: its paper, the round holes in it, and its sprocket holes in a row.

The paper is the brighter or the darker part of the picture by Otsu's threshold, whichever has more round
holes. Sprocket holes are the small ones a pitch apart; they are followed along a strip over gaps and gentle
bends. Strips lie one above another.

Needs OpenCV, the extra `vision`. Source: ECMA-10 (sprocket holes .046 in, code holes .072 in, a pitch .1 in).
"""

from typing import Any, NamedTuple

import cv2
import numpy as np

from tapes.errors import TapeError

Array = np.ndarray[Any, Any]

_SMALL = (0.06, 0.26)
"""The area of a sprocket hole in square pitches, .166 by the book; a code hole's is .407."""
_SMOOTHED = (1.5, 3)
_DEPTH = 0.35
"""Where the edge of a hole is put, between paper 0 and hole 1: a blurred sprocket hole is shallow."""
_ROUND = 0.6
_REACH = 0.35
_LONGEST_GAP = 3
_FEWEST = 4
_SEEDS = 40
_HALF_WIDTH = 6

_Place = tuple[float, float, bool]


class Tape(NamedTuple):
    """What was found: paper, 1 or 0 each pixel; the pitch in pixels; the sprocket holes of each strip.

    A strip is an array of (x, y, seen), a row a frame; what is not seen was put in between two that are.
    """

    paper: Array
    pitch: float
    strips: list[Array]


class _Hole(NamedTuple):
    x: float
    y: float
    area: float


def find(light: Array) -> Tape:
    """Return the tape in a picture in shades of grey, smoothed as far as shows most sprocket holes.

    Raises TapeError if there is none.
    """
    found = [_find(light), *(_find(cv2.GaussianBlur(light, (0, 0), pixels)) for pixels in _SMOOTHED)]
    best = max(found, key=lambda tape: sum(strip[:, 2].sum() for strip in tape.strips))
    if not best.strips:
        raise TapeError("no tape in the picture: no row of sprocket holes was found")
    return best


def _find(light: Array) -> Tape:
    paper, holes = _paper(light)
    if len(holes) < _FEWEST:
        return Tape(paper, 0, [])
    pitch = _pitch(holes)
    return Tape(paper, pitch, _strips(holes, pitch))


def _paper(light: Array) -> tuple[Array, list[_Hole]]:
    middle, _ = cv2.threshold(light, 0, 1, cv2.THRESH_BINARY | cv2.THRESH_OTSU)
    if light.min() == light.max():
        return light, []
    below, above = (float(light[where].mean()) for where in (light <= middle, light > middle))
    masks = [(light > above - _DEPTH * (above - below)), (light < below + _DEPTH * (above - below))]
    found = [(mask.astype(np.uint8), _round_holes(mask.astype(np.uint8))) for mask in masks]
    return max(found, key=lambda pair: len(pair[1]))


def _round_holes(paper: Array) -> list[_Hole]:
    outlines, tree = cv2.findContours(paper, cv2.RETR_CCOMP, cv2.CHAIN_APPROX_NONE)
    holes = []
    for number, outline in enumerate(outlines):
        area, around = cv2.contourArea(outline), cv2.arcLength(outline, True)
        is_hole = tree[0][number][3] >= 0
        if is_hole and area >= 4 and 4 * np.pi * area >= _ROUND * around * around:
            x, y = outline[:, 0].mean(axis=0)
            holes.append(_Hole(float(x), float(y), area - around / 2))  # its outline runs through the paper
    return holes


def _pitch(holes: list[_Hole]) -> float:
    """Return the distance of most holes to the nearest other."""
    places = np.array([(hole.x, hole.y) for hole in holes])
    nearest = [np.partition(_away(places, place), 1)[1] for place in places]
    return float(np.median(nearest))


def _away(places: Array, place: Array) -> Array:
    return np.asarray(np.hypot(places[:, 0] - place[0], places[:, 1] - place[1]))


def _strips(holes: list[_Hole], pitch: float) -> list[Array]:
    least, most = (share * pitch * pitch for share in _SMALL)
    small = np.array([(hole.x, hole.y) for hole in holes if least <= hole.area <= most]).reshape(-1, 2)
    strips = []
    while len(small) >= _FEWEST:
        chain = _longest(small, pitch)
        if chain is None:
            break
        strips.append(chain)
        apart = np.min([_away(small, place) for place in chain], axis=0) > _HALF_WIDTH * pitch
        small = small[apart]
    return sorted(strips, key=lambda chain: float(chain[:, 1].mean()))


def _longest(small: Array, pitch: float) -> Array | None:
    """Return the longest row of holes, followed from some of them; None if all are too short."""
    best: list[_Place] = []
    for start in small[:: max(1, len(small) // _SEEDS)]:
        for other in small[abs(_away(small, start) - pitch) < 0.2 * pitch]:
            step = other - start
            before, after = (_follow(small, start, way, pitch) for way in (-step, step))
            chain = [*before[::-1], (float(start[0]), float(start[1]), True), *after]
            best = max(best, chain, key=_seen)
        if _seen(best) > len(small) // 2:
            break
    return np.array(best, dtype=float) if _seen(best) >= _FEWEST else None


def _seen(chain: list[_Place]) -> int:
    return sum(seen for _, _, seen in chain)


def _follow(small: Array, start: Array, step: Array, pitch: float) -> list[_Place]:
    """Follow the holes from `start` on, a step at a time, as far as no gap is too long."""
    chain: list[_Place] = []
    missing: list[_Place] = []
    here = start
    while len(missing) <= _LONGEST_GAP:
        there = here + step
        away = _away(small, there)
        nearest = int(away.argmin())
        seen = bool(away[nearest] <= _REACH * pitch)
        if seen:
            there = small[nearest]
            chain += missing
            if not missing:
                step = 0.7 * step + 0.3 * (there - here)
            missing = []
            chain.append((float(there[0]), float(there[1]), True))
        else:
            missing.append((float(there[0]), float(there[1]), False))
        here = there
    return chain
