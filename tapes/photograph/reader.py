"""A photograph or scan of tape becomes frames.

    light        the file as shades of grey                                       (pixels.py)
    rows         small round holes in a row, followed one by one                  (sprockets.py)
    paper        a sheet around such a row, with holes and edges at their places  (paper.py)
    channels     here: how dark each place of the flattened sheet is, beside paper around it and holes near

A frame is sure only if everything around it is as on a tape: its sprocket hole and both edges of the paper
are seen, holes are at their places, paper is clear, holes are round and as dark as those near. Anything else
makes it doubtful, and says why. More doubtful frames than sure ones can carry make the picture refused.

Not emulated: holes with hanging chad are doubtful, not mended; five-channel tape is refused. Tape seen from
below looks like another tape seen from above: `underside` has to say so.

Needs OpenCV, the extra `vision`. Source: ECMA-10.
"""

from itertools import compress
from typing import NamedTuple

import cv2
import numpy as np

from tapes.errors import TapeError
from tapes.photograph import pixels, sprockets
from tapes.photograph.flat import SAMPLES, Flat, flatten
from tapes.photograph.paper import Found, find
from tapes.photograph.pixels import Array, between

FEWEST_PIXELS = 5.2
"""From row to row and from track to track."""

UNSEEN = "its sprocket hole is not seen"
"""Why a frame is doubtful in a gap: it was counted by its distance from those before."""

_GOES_ON = "the tape goes on beyond it, where no sprocket hole is seen"

_TRACKS = (-3, -2, -1, 1, 2, 3, 4, 5)
"""Channels 1 to 8, in pitches from the sprocket track."""
_WINDOW = 8
_MOST_DOUBTFUL = 0.35
_FAILURES = 4
_LEAST_LIGHT = 6
_NO_TAPE = "no tape in the picture: "


class Frame(NamedTuple):
    """A frame as it was seen: its holes, its channels in doubt as a mask, why the first of them is or "", and
    the places in pixels of the sprocket hole and of channels 1 to 8.
    """

    holes: int
    open: int
    why: str
    places: tuple[tuple[int, int], ...]

    @property
    def doubtful(self) -> bool:
        """Whether the frame wants to be looked at."""
        return self.open != 0

    @property
    def channel(self) -> int:
        """The first channel in doubt."""
        return (self.open & -self.open).bit_length()

    @property
    def x(self) -> int:
        """Its sprocket hole's place, in pixels from the left."""
        return self.places[0][0]

    @property
    def y(self) -> int:
        """Its sprocket hole's place, in pixels from the top."""
        return self.places[0][1]


def read(picture: bytes, underside: bool = False) -> list[Frame]:
    """Return the frames of the tape in a picture, a file's content, in the order in which they are read;
    several strips from top to bottom.

    Raises TapeError where there is no picture, no tape in it, or one that cannot be read; it says why.
    """
    light = pixels.light(picture)
    pictures = sprockets.sizes(light)
    found, why = _strips(pictures)
    if not found:
        pictures = sprockets.sizes(255 - light)
        found, _ = _strips(pictures)
    if not found:
        raise TapeError(_NO_TAPE + why)
    strips = [_frames(pictures, strip) for strip in found]
    strips.sort(key=lambda strip: sum(frame.y for frame in strip) / len(strip))
    return [frame for strip in strips for frame in (strip[::-1] if underside else strip)]


def _strips(pictures: sprockets.Sizes) -> tuple[list[Found], str]:
    """Return the tapes in which holes are dark, the longest where two are one; and if there are none, why the
    likeliest row is not one.
    """
    found: list[Found] = []
    why: list[str] = []
    for row in sprockets.rows(pictures):
        if len(why) >= _FAILURES:
            break
        if any(tape.sheet.covers(row.places) for tape in found):
            continue
        try:
            tape = find(pictures, row)
        except TapeError as error:
            why.append(str(error))
            continue
        u = np.arange(tape.sheet.length)
        same = [other.sheet.covers(tape.sheet.place(u, 0 * u)) for other in found]
        if all(len(other.seen) < len(tape.seen) for other in compress(found, same)):
            found = [*(other for other, covers in zip(found, same, strict=True) if not covers), tape]
    return found, why[0] if why else "no row of small round holes was found"


def _frames(pictures: sprockets.Sizes, tape: Found) -> list[Frame]:
    hole, doubts, rows = _judged(flatten(pictures, tape.sheet), tape)
    least = float(np.quantile(np.minimum(*tape.sheet.pitches())[rows], 0.1))
    if least < FEWEST_PIXELS:
        raise TapeError(f"rows and tracks are only {least:.1f} pixels apart: 6 are needed")
    places = tape.sheet.place(np.arange(-1, tape.sheet.length + 1)[:, None], np.array([0, *_TRACKS]))
    most = np.array(pictures.pictures[0].light.shape[::-1]) - 1
    for end, beyond in ((rows[0], rows[0]), (rows[-1], rows[-1] + 2)):
        doubts[_GOES_ON][end] &= bool((places[beyond] == places[beyond].clip(0, most)).all())
    doubtful = np.any([*doubts.values()], axis=0)
    frames = [
        Frame(
            _mask(hole[at]),
            _mask(doubtful[at]),
            next((why for why, where in doubts.items() if where[at, doubtful[at].argmax()]), ""),
            tuple((round(float(x)), round(float(y))) for x, y in places[1 + at]),
        )
        for at in rows
    ]
    _refuse_doubtful(frames)
    return frames


def _mask(channels: Array) -> int:
    return sum(1 << channel for channel in np.nonzero(channels)[0].tolist())


def _refuse_doubtful(frames: list[Frame]) -> None:
    why = [frame.why for frame in frames if frame.doubtful]
    if len(why) > _MOST_DOUBTFUL * len(frames):
        most = max(set(why), key=why.count)
        raise TapeError(f"{len(why)} of {len(frames)} frames are doubtful, most of them: {most}")


_OFFSETS = np.arange(-4, 5) / SAMPLES
_AWAY = np.hypot(*np.meshgrid(_OFFSETS, _OFFSETS))
_CORE = np.exp(-0.5 * (_AWAY / 0.11) ** 2)
_RING = [(0.52 * np.cos(turn), 0.52 * np.sin(turn)) for turn in np.arange(8) * np.pi / 4 + np.pi / 8]


def _judged(flat: Flat, tape: Found) -> tuple[Array, dict[str, Array], Array]:
    """Return which places (n, 8) are holes, where one is doubtful, by why, the worst first, and which rows
    are on paper: from the first that has both edges and a sprocket hole to the last.

    How dark a place is, is measured beside the paper at its four corners; the darkness of a hole is that of
    the clear ones near.
    """
    light = cv2.GaussianBlur(flat.light, (0, 0), 0.08 * SAMPLES)
    rows, tracks = np.arange(tape.sheet.length)[:, None], np.array([0, *_TRACKS])
    corners = flat.take(light, np.arange(-0.5, tape.sheet.length)[:, None], np.arange(-3.5, 6))

    def paper_at(u: Array, v: Array) -> Array:
        return np.maximum(between(corners, *np.broadcast_arrays(v + 3.5, u + 0.5)), 1)

    def dark(u: Array, v: Array) -> Array:
        return np.asarray(1 - flat.take(light, u, v) / paper_at(u, v))

    disc = np.stack([[dark(rows + along, tracks + aside) for along in _OFFSETS] for aside in _OFFSETS])
    core = np.tensordot(_CORE / _CORE.sum(), disc, axes=2)
    full = _full(core[:, 1:], core[:, 0])[:, None]
    core = core[:, 1:] / full
    ring = np.stack([dark(rows + along, tracks[1:] + aside) for along, aside in _RING]) / full
    inside = disc[_AWAY < 0.3][..., 1:] / full
    hole = core > 0.5
    on_paper, unseen, goes_on = _ends(flat._replace(light=light), tape)
    found = {
        UNSEEN: unseen[:, None],
        _GOES_ON: goes_on[:, None],
        "holes are not at their places": tape.astray[:, None] > 0.08,
        "an edge of the paper is not seen": ~tape.edged[:, None],
        "not a round hole: torn, or dirt": hole & ((ring > 0.6).sum(axis=0) >= 2),
        "a hole that is not dark throughout": hole & (inside.min(axis=0) < 0.25),
        "paper that is not clear": ~hole & (inside.max(axis=0) > 0.5),
        "too little light": full * paper_at(rows, tracks[1:]) < _LEAST_LIGHT,
        "between paper and hole": abs(core - 0.5) < np.maximum(0.25, 4.5 * _noise(core, hole)),
    }
    doubts = {why: np.broadcast_to(where, hole.shape).copy() for why, where in found.items()}
    return hole, doubts, on_paper


def _ends(flat: Flat, tape: Found) -> tuple[Array, Array, Array]:
    """Return the rows on paper, which rows have no sprocket hole, and which one is the first or last although
    the paper goes on.
    """
    u = np.arange(-1, tape.sheet.length + 1)
    paper = np.median(flat.take(flat.light, u[:, None], np.arange(-2.5, 5)), axis=1)
    hole = flat.take(flat.light, u, 0)
    depth = 1 - hole / np.maximum(paper, 1)
    unseen = ~tape.seen | (depth < 0.5 * np.median(depth))[1:-1]
    there = np.nonzero(tape.edged & ~unseen)[0]
    if len(there) < sprockets.FEWEST:
        raise TapeError(_NO_TAPE + "no paper around the row of holes")
    first, last = there[0], there[-1]
    goes_on = np.zeros_like(unseen)
    for end, beyond in ((first, first), (last, last + 2)):
        goes_on[end] = paper[beyond] > (paper[end + 1] + hole[end + 1]) / 2
    return np.arange(first, last + 1), unseen, goes_on


def _near(at: int) -> slice:
    return slice(max(0, at - _WINDOW), at + _WINDOW + 1)


def _full(core: Array, sprocket: Array) -> Array:
    """Return how dark a hole is around each frame, as a part of the paper's light, by the clear ones near.

    Sprocket holes, which are everywhere, are blurred more than code holes: these count where there are any.
    """
    clear = core > 0.5 * sprocket[:, None]
    more = np.median(core[clear]) / np.median(sprocket) if clear.sum() > 8 else 1.1
    full = np.empty(len(core))
    for at in range(len(core)):
        there = core[_near(at)][clear[_near(at)]]
        full[at] = np.median(there) if len(there) >= 6 else more * np.median(sprocket[_near(at)])
    return np.maximum(full, 0.01)


def _noise(core: Array, hole: Array) -> Array:
    """Return the standard deviation of what is alike around each place, holes or paper."""
    found = np.empty(core.shape)
    for at in range(len(core)):
        for kind in np.unique(hole[at]):
            like = core[_near(at)][hole[_near(at)] == kind]
            found[at, hole[at] == kind] = 1.48 * np.median(abs(like - np.median(like)))
    return found
