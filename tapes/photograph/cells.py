"""How dark each place of a flattened strip is, and which frames are doubtful for it.

A place is measured beside the paper around it, in parts of the darkness of the holes near it. A frame is
sure only if nothing around it is one of `doubts`.
"""

from typing import NamedTuple

import cv2
import numpy as np

from tapes.photograph import sprockets
from tapes.photograph.flat import SAMPLES, Flat
from tapes.photograph.paper import Found
from tapes.photograph.pixels import Array
from tapes.photograph.sheet import Sheet

UNSEEN = "its sprocket hole is not seen"
"""Why a frame is doubtful in a gap: it was counted by its distance from those before."""

TRACKS = np.array([-3, -2, -1, 1, 2, 3, 4, 5], dtype=float)
"""Channels 1 to 8, in pitches from the sprocket track."""
_SPROCKET = 3
"""The sprocket track's number among the tracks from channel 1 to channel 8."""
_WINDOW = 8
_LEAST_LIGHT = 6


class Cells(NamedTuple):
    """Of each frame (n) and channel (8): how dark the middle is, the darkest and brightest of what should be
    like it, and the darkness of eight places beyond the hole; all in parts of a hole's full darkness (n).
    """

    core: Array
    most: Array
    ring: Array
    full: Array
    sprocket: Array
    paper: Array


def on_paper(flat: Flat, edged: Array) -> Array:
    """Return which rows are on paper: from the first with a hole to the last."""
    u = np.arange(len(edged), dtype=float)[:, None]
    v = np.arange(-2.5, 5)
    light = [flat.take(flat.light, *np.broadcast_arrays(u + off, v)) for off in (-0.3, 0, 0.3)]
    paper = np.median(np.concatenate(light, axis=1), axis=1)
    depth = 1 - flat.take(flat.light, u, 0 * u)[:, 0] / np.maximum(paper, 1)
    rows = np.nonzero(edged & (depth > 0.5 * np.median(depth)))[0]
    there = np.zeros(len(edged), dtype=bool)
    if len(rows):
        there[rows[0] : rows[-1] + 1] = True
    return there


def ends(flat: Flat, tape: Sheet, pictures: sprockets.Sizes, there: Array) -> Array:
    """Return which rows are first or last although the paper has room for another."""
    found = np.zeros(len(there), dtype=bool)
    rows = np.nonzero(there)[0]
    v = np.arange(-2.5, 5)
    last = np.array(pictures.pictures[0].shape[::-1]) - 1
    for end, way in ((rows[0], -1), (rows[-1], 1)):
        near, beyond = (end + way * np.array(off)[:, None] for off in (np.arange(-5.0, 1), (0.8, 1.1)))
        paper = np.median(flat.take(flat.light, *np.broadcast_arrays(near - way / 2, v)))
        hole = np.quantile(flat.take(flat.light, near, 0 * near), 0.25)
        light = np.median(flat.take(flat.light, *np.broadcast_arrays(beyond, v)), axis=1).min()
        places = tape.place(beyond, v)
        found[end] = (places == places.clip(0, last)).all() and light > (paper + hole) / 2
    return found


_OFFSETS = np.arange(-4, 5) / SAMPLES
_AWAY = np.hypot(*np.meshgrid(_OFFSETS, _OFFSETS))
_CORE = np.exp(-0.5 * (_AWAY / 0.11) ** 2)
_CORE /= _CORE.sum()
_TURNS = (np.arange(8) + 0.5) * np.pi / 4
_RING = 0.52 * np.stack([np.cos(_TURNS), np.sin(_TURNS)], axis=1)


def measure(flat: Flat, length: int) -> Cells:
    """Measure each hole's place beside the paper at its four corners."""
    rows, tracks = np.arange(length, dtype=float)[:, None], np.arange(-3.0, 6)
    between = np.broadcast_arrays(np.arange(-0.5, length)[:, None], np.arange(-3.5, 6))
    corners = flat.take(cv2.blur(flat.light, (3, 3)), *between)

    def paper(along: float, aside: float) -> Array:
        sides = corners[:-1] * (0.5 - along) + corners[1:] * (0.5 + along)
        return np.maximum(sides[:, :-1] * (0.5 - aside) + sides[:, 1:] * (0.5 + aside), 1)

    def dark(along: float, aside: float) -> Array:
        here = flat.take(flat.light, *np.broadcast_arrays(rows + along, tracks + aside))
        return np.asarray(1 - here / paper(along, aside))

    disc = np.stack([[dark(along, aside) for along in _OFFSETS] for aside in _OFFSETS])
    core = np.tensordot(_CORE, disc, axes=2)
    ring = np.stack([dark(along, aside) for along, aside in _RING])
    inside = disc[_AWAY < 0.3]
    sprocket, codes = core[:, _SPROCKET], np.delete(core, _SPROCKET, axis=1)
    full = full_darkness(codes, sprocket)
    spread = np.where(core > 0.5 * full[:, None], inside.min(axis=0), inside.max(axis=0))
    most, beside = (np.delete(of, _SPROCKET, axis=-1) for of in (spread, ring))
    scale = full[:, None]
    light = np.delete(paper(0, 0), _SPROCKET, axis=1)
    return Cells(codes / scale, most / scale, beside / scale, full, sprocket / full, light)


def full_darkness(core: Array, sprocket: Array) -> Array:
    """Return a hole's full darkness around each frame, over the paper's light, by clear holes near."""
    clear = core > 0.5 * sprocket[:, None]
    more = np.median(core[clear]) / np.median(sprocket) if clear.sum() > 8 else 1.1
    full = np.empty(len(core))
    for at in range(len(core)):
        near = slice(max(0, at - _WINDOW), at + _WINDOW + 1)
        there = core[near][core[near] > 0.5 * np.median(sprocket[near])]
        full[at] = np.median(there) if len(there) >= 6 else more * np.median(sprocket[near])
    return np.maximum(full, 0.01)


def doubts(cells: Cells, tape: Found, beyond: Array, outside: Array) -> dict[str, Array]:
    """Return which places (n, 8) are doubtful, by reason, the worst first."""
    hole = cells.core > 0.5
    rows = {
        UNSEEN: ~tape.seen | (cells.sprocket < 0.4) | (cells.sprocket > 1.6),
        "the tape goes on beyond it, where no sprocket hole is seen": beyond,
        "holes are not at their places": tape.astray > 0.08,
        "an edge of the paper is not seen": ~tape.edged,
    }
    return {why: np.broadcast_to(where[:, None], hole.shape) for why, where in rows.items()} | {
        "outside the picture": outside,
        "not a round hole: torn, or dirt": hole & ((cells.ring > 0.6).sum(axis=0) >= 2),
        "a hole that is not dark throughout": hole & (cells.most < 0.25),
        "paper that is not clear": ~hole & (cells.most > 0.5),
        "too little light": cells.full[:, None] * cells.paper < _LEAST_LIGHT,
        "between paper and hole": abs(cells.core - 0.5) < np.maximum(0.25, 4.5 * noise(cells.core, hole)),
    }


def noise(core: Array, hole: Array) -> Array:
    """Return the standard deviation of the darkness around each place, among holes or among paper."""
    found = np.empty(core.shape)
    for at in range(len(core)):
        near = slice(max(0, at - _WINDOW), at + _WINDOW + 1)
        for kind in np.unique(hole[at]):
            like = core[near][hole[near] == kind]
            found[at, hole[at] == kind] = 1.48 * np.median(abs(like - np.median(like)))
    return found
