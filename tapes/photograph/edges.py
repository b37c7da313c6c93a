"""The edges of a sheet: 3.92 and 6.08 pitches from the sprocket track, beside three and five channels.

They say which track the sprocket track is, which way the tape is read, and that it is a tape at all. Source:
ECMA-10.
"""

from typing import NamedTuple

import cv2
import numpy as np

from tapes.errors import TapeError
from tapes.photograph.flat import SAMPLES, Flat, find_spots
from tapes.photograph.pixels import Array
from tapes.photograph.sheet import FIVE, THREE, Points, Sheet

_TWO = 2.95
"""Pitches from the sprocket track to the edge beside two channels, of a tape with five, 11/16 in wide."""

_PROFILE = np.arange(-8, 9) / SAMPLES
"""Places across an edge, from inside to outside."""


class Side(NamedTuple):
    """The number of the sprocket track, and on which side of it are three channels: -1 or 1."""

    track: int
    three: int
    width: float
    share: float


def find_side(flat: Flat, sheet: Sheet) -> Side:
    """Which track has the sprockets and the side of three channels. Raises TapeError for edges of no tape."""
    spots = find_spots(flat.dark)
    u = np.arange(sheet.length, dtype=float)
    limit = 0.5 * np.median(flat.take(spots, u, 0 * u))
    holes = {track: u[flat.take(spots, u, 0 * u + track) > limit] for track in range(-5, 6)}
    mass = {track: _mass(flat, rows, track) for track, rows in holes.items() if len(rows) > 0.1 * len(u)}
    has_codes = sum(map(len, holes.values())) > len(u) + 12
    tracks = [track for track in mass if len(holes[track]) > 0.7 * len(u)] if has_codes else [0]
    widths = np.array([1.0]) if has_codes else np.geomspace(0.55, 1.8, 33)
    paper = _paper(flat, sheet)
    sides = [
        Side(track, three, float(width), _share(flat, paper, track, three * width))
        for track in tracks
        for three in (-1, 1)
        for width in widths
    ]
    best = max((side.share for side in sides), default=0)
    if best < 0.5:
        if max(_share(flat, paper, 0, three, _TWO) for three in (-1, 1)) > 0.5:
            raise TapeError("a five-channel tape: only tape of eight channels is read")
        raise TapeError(
            "the paper's edges are not 3.92 and 6.08 rows' distances from the sprocket holes; both have to be"
            " in the picture, uncovered, on a background of another colour"
        )
    likely = [side for side in sides if side.share > 0.75 * best]
    found = min(likely, key=lambda side: (round(mass[side.track] / mass[0], 1), -side.share))
    others = [mass[track] for track in mass if track != found.track and abs(track) <= 3]
    if others and np.median(others) < 1.35 * mass[found.track]:
        raise TapeError(
            "the holes are all of one size: a tape's sprocket holes are smaller than its code holes"
        )
    return found


def _mass(flat: Flat, u: Array, track: int) -> float:
    """Return a hole's lost light, depth times area, which blur does not change."""
    away = np.arange(-5, 6) / SAMPLES
    x, y = np.meshgrid(away, away)
    disc = np.hypot(x, y) < 0.45
    x, y = x[disc], y[disc]
    dark = flat.take(flat.dark, u[:, None] + x, track + 0 * u[:, None] + y)
    return float(np.median(dark.sum(axis=1)))


class _Paper(NamedTuple):
    """The light of the paper between each two rows, `u`, and how dark a sprocket hole is beside it."""

    u: Array
    light: Array
    depth: float


def _paper(flat: Flat, sheet: Sheet) -> _Paper:
    u = np.arange(-0.5, sheet.length)
    light = np.median(flat.take(flat.light, *np.broadcast_arrays(u[:, None], np.arange(-2.5, 3))), axis=1)
    rows = np.arange(sheet.length, dtype=float)
    depth = float(np.median(flat.take(flat.dark, rows, 0 * rows)))
    return _Paper(u, cv2.medianBlur(light[:, None].astype(np.float32), 5)[:, 0] + 2, depth)


def _profiles(flat: Flat, paper: _Paper, edge: float, outward: float) -> tuple[Array, Array]:
    """The light across an edge between each two rows, (rows, places), over the paper's; and where one is."""
    rows = (paper.u[:, None] + np.array([-0.1, 0, 0.1]))[:, :, None]
    places = edge + outward * _PROFILE
    profile = flat.take(flat.light, *np.broadcast_arrays(rows, places)).mean(axis=1) / paper.light[:, None]
    inside, outside = profile[:, :5].mean(axis=1), profile[:, -5:].mean(axis=1)
    return profile, (abs(inside - outside) > 0.4 * paper.depth) & (abs(inside - 1) < 0.35)


def _share(flat: Flat, paper: _Paper, track: int, three: float, other: float = FIVE) -> float:
    """Return the share of rows with both edges in place, if `three` channels are on that side."""
    edges = ((track + three * THREE, np.sign(three)), (track - three * other, -np.sign(three)))
    return float(min(_profiles(flat, paper, edge, outward)[1].mean() for edge, outward in edges))


def find_edges(flat: Flat, sheet: Sheet) -> tuple[Points, Array]:
    """Return the paper's edges as points, and which rows have both."""
    paper = _paper(flat, sheet)
    sides: list[Points] = []
    both: list[Array] = []
    for edge, outward in ((-THREE, -1.0), (FIVE, 1.0)):
        profile, there = _profiles(flat, paper, edge, outward)
        both.append(there[:-1] | there[1:])
        profile, u = profile[there], paper.u[there]
        inside, outside = profile[:, :4].mean(axis=1), profile[:, -4:].mean(axis=1)
        share = ((profile - outside[:, None]) / (inside - outside)[:, None]).clip(0, 1).mean(axis=1)
        off = (share - 0.5) * len(_PROFILE) / SAMPLES
        v = np.full_like(u, edge)
        along = sheet.place(u + 0.5, v) - sheet.place(u - 0.5, v)
        normal = np.stack([-along[:, 1], along[:, 0]], axis=1) / np.hypot(*along.T)[:, None]
        sides.append(Points(u, v, sheet.place(u, v + outward * off), normal, np.full_like(u, 0.3)))
    return sides[0].and_(sides[1]), both[0] & both[1]
