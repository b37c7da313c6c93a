"""A photograph or scan of tape becomes frames.

    light        the file as shades of grey                                       (pixels.py)
    rows         small round holes in a row, followed one by one                  (sprockets.py)
    paper        a sheet around such a row, with holes and edges at their places  (paper.py)
    channels     here: how dark each place of the flattened sheet is, beside paper around it and holes near

A frame is sure only if everything around it is as on a tape: its sprocket hole and both edges of the paper
are seen, holes are at their places, paper is clear, holes are round and as dark as those near. Anything else
makes it doubtful, and says why. A strip with more doubtful frames than the sure ones can carry is left out.

Not emulated: holes with hanging chad are doubtful, not mended; five-channel tape is refused. Tape seen from
below looks like another tape seen from above: `underside` has to say so.

Needs OpenCV, the extra `vision`. Source: ECMA-10.
"""

from typing import NamedTuple

import cv2
import numpy as np

from tapes.errors import TapeError
from tapes.photograph import pixels, sprockets
from tapes.photograph.flat import SAMPLES, Flat, flatten
from tapes.photograph.paper import Found, find
from tapes.photograph.pixels import Array
from tapes.photograph.sheet import Sheet

FEWEST_PIXELS = 5.2
"""From row to row and from track to track."""

UNSEEN = "its sprocket hole is not seen"
"""Why a frame is doubtful in a gap: it was counted by its distance from those before."""

_TRACKS = np.array([-3, -2, -1, 1, 2, 3, 4, 5], dtype=float)
"""Channels 1 to 8, in pitches from the sprocket track."""
_SPROCKET = 3
"""Its number among the tracks from channel 1 to channel 8."""
_ADVICE = {
    "holes are not at their places": "lay it flat, and photograph it from straight above",
    "an edge of the paper is not seen": "both edges have to be free, on something of another colour",
    "paper that is not clear": "light it evenly",
    "too little light": "give it more light",
}
"""What to do about a strip most of whose frames are doubtful for this reason; about any other: _DARKER."""
_DARKER = "lay it on something black and even, or light it from behind"
_WINDOW = 8
_MOST_DOUBTFUL = 0.35
_FAILURES = 4
_LEAST_LIGHT = 6
_NO_TAPE = "no tape in the picture: "


class Frame(NamedTuple):
    """A frame as it was seen: its holes, its channels in doubt as a mask, why the first of them is or "", the
    places in pixels of the sprocket hole and of channels 1 to 8, and the channel that is nearest to being the
    other, as a mask, with how near: 0 to .5 of a hole's darkness.
    """

    holes: int
    open: int
    why: str
    places: tuple[tuple[int, int], ...]
    weakest: int = 0
    margin: float = 0.5

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


class Strip(NamedTuple):
    """A strip of tape in a picture: its frames as they are read, whether the tape leaves the picture before
    the first and after the last of them, and why it cannot be read, or "".
    """

    frames: list[Frame]
    off: tuple[bool, bool] = (False, False)
    why: str = ""

    def turned(self) -> "Strip":
        """Return it as it is if it was photographed from below."""
        return self._replace(frames=self.frames[::-1], off=self.off[::-1])


def read(picture: bytes, underside: bool = False) -> list[Frame]:
    """Return the frames of the tape in a picture, strip after strip; those that cannot be read are left out.

    Raises TapeError where no strip can be read, and as `strips` does.
    """
    found = strips(picture, underside)
    if all(strip.why for strip in found):
        raise TapeError(found[0].why)
    return [frame for strip in found if not strip.why for frame in strip.frames]


def strips(picture: bytes, underside: bool = False) -> list[Strip]:
    """Return the strips of tape in a picture, a file's content, in the order in which they are read.

    They are read line after line, from top to bottom, or from left to right if most of them are upright; on
    one line as they lie, each after the one before. Raises TapeError where there is no picture or no tape.
    """
    light = pixels.light(picture)
    found, why = _strips(light)
    if not found:
        found, _ = _strips(255 - light)
    if not found:
        raise TapeError(_NO_TAPE + why)
    read = [_strip(pictures, tape) for pictures, tape in found]
    ordered = _ordered([strip for strip in read if strip.frames], underside)
    ordered += (strip for strip in read if not strip.frames)
    return [strip.turned() for strip in ordered] if underside else ordered


def _ordered(strips: list[Strip], underside: bool) -> list[Strip]:
    """Return the strips line after line, by a picture turned so that most of them lie level or nearly so."""
    if not strips:
        return []
    ends = np.array([[strip.frames[at].places[0] for at in (0, -1)] for strip in strips], dtype=float)
    ways = (ends[:, 1] - ends[:, 0]) @ [1, 1j]
    turn = np.angle((ways**2).sum()) / 2  # which end is the first does not count
    turn -= np.pi * (turn > np.pi / 4)
    along, aside = ends @ [np.cos(turn), np.sin(turn)], (ends @ [-np.sin(turn), np.cos(turn)]).mean(axis=1)
    lines: list[list[int]] = []
    for at in np.argsort(aside).tolist():
        half = 0.5 * np.hypot(*np.subtract(strips[at].frames[0].places[1], strips[at].frames[0].places[8]))
        if lines and aside[at] - aside[lines[-1][-1]] < half:
            lines[-1].append(at)
        else:
            lines.append([at])
    for line in lines:
        onward = 2 * sum(along[at, 1] > along[at, 0] for at in line) >= len(line)
        line.sort(key=lambda at: float(along[at].mean()), reverse=bool(onward) == underside)
    return [strips[at] for line in lines for at in line]


def _strips(light: Array) -> tuple[list[tuple[sprockets.Sizes, Found]], str]:
    """Return the tapes in which holes are dark, and if there are none, why the likeliest row is not one."""
    pictures = sprockets.sizes(light)
    found: list[tuple[sprockets.Sizes, Found]] = []
    why: list[str] = []
    for row in sprockets.rows(pictures):
        if len(why) >= _FAILURES:
            break
        if any(tape.sheet.covers(row.places) for _, tape in found):
            continue
        try:
            found.append((pictures, find(pictures, row)))
        except TapeError as error:
            why.append(str(error))
    return found, why[0] if why else "no row of small round holes was found"


class _Cells(NamedTuple):
    """Of each frame (n) and channel (8): how dark the middle is, the darkest and brightest of what should be
    like it, and the darkness of eight places beyond the hole; all in parts of a hole's full darkness (n).
    """

    core: Array
    most: Array
    ring: Array
    full: Array
    sprocket: Array
    paper: Array


def _strip(pictures: sprockets.Sizes, tape: Found) -> Strip:
    flat = flatten(pictures, tape.sheet)
    flat = flat._replace(light=cv2.GaussianBlur(flat.light, (0, 0), 0.08 * SAMPLES))
    u = np.arange(tape.sheet.length, dtype=float)[:, None]
    places = tape.sheet.place(u, np.concatenate([[0], _TRACKS]))
    shown = pictures.show(places)
    on_paper = _on_paper(flat, tape.edged) & shown[:, 0]
    if on_paper.sum() < sprockets.FEWEST:
        return Strip([], why=_NO_TAPE + "no paper around the row of holes")
    cells = _cells(flat, tape.sheet.length)
    along, across = tape.sheet.pitches()
    least = float(np.quantile(np.minimum(along, across)[on_paper], 0.02))
    if least < FEWEST_PIXELS:
        why = f"rows and tracks are only {least:.1f} pixels apart: 6 are needed; photograph it from nearer"
        return Strip([], why=why)
    doubts = _doubts(cells, tape, _ends(flat, tape.sheet, pictures, on_paper), ~shown[:, 1:])
    doubtful = np.any([*doubts.values()], axis=0)
    margin = abs(cells.core - 0.5)
    frames = [
        Frame(
            _mask(cells.core[at] > 0.5),
            _mask(doubtful[at]),
            next((why for why, where in doubts.items() if where[at, doubtful[at].argmax()]), ""),
            tuple((round(float(x)), round(float(y))) for x, y in places[at]),
            1 << int(margin[at].argmin()),
            float(margin[at].min()),
        )
        for at in np.nonzero(on_paper)[0]
    ]
    return Strip(frames, _leaves(tape.sheet, pictures, on_paper), _too_doubtful(frames))


def _leaves(sheet: Sheet, pictures: sprockets.Sizes, on_paper: Array) -> tuple[bool, bool]:
    """Return whether the picture has no room for another row before the first one, and after the last."""
    rows = np.nonzero(on_paper)[0]
    beyond = sheet.place(np.array([rows[0] - 1.25, rows[-1] + 1.25]), np.zeros(2))
    before, after = (~pictures.show(beyond)).tolist()
    return before, after


def _mask(channels: Array) -> int:
    return sum(1 << channel for channel in np.nonzero(channels)[0].tolist())


def _too_doubtful(frames: list[Frame]) -> str:
    """Return why a strip cannot be read if too many of its frames are doubtful, or ""."""
    why = [frame.why for frame in frames if frame.doubtful]
    if len(why) <= _MOST_DOUBTFUL * len(frames):
        return ""
    most = max(set(why), key=why.count)
    advice = _ADVICE.get(most, _DARKER)
    return f"{len(why)} of {len(frames)} frames are doubtful, most of them: {most}; {advice}"


def _on_paper(flat: Flat, edged: Array) -> Array:
    """Return which rows have paper around them, and a hole in it: from the first that has to the last."""
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


def _ends(flat: Flat, tape: Sheet, pictures: sprockets.Sizes, on_paper: Array) -> Array:
    """Return which rows are a first or last one beyond which there is room for another one on the paper."""
    found = np.zeros(len(on_paper), dtype=bool)
    rows = np.nonzero(on_paper)[0]
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


def _cells(flat: Flat, length: int) -> _Cells:
    """Measure each place of a hole beside the paper at its four corners."""
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
    full = _full(codes, sprocket)
    spread = np.where(core > 0.5 * full[:, None], inside.min(axis=0), inside.max(axis=0))
    most, beside = (np.delete(of, _SPROCKET, axis=-1) for of in (spread, ring))
    scale = full[:, None]
    light = np.delete(paper(0, 0), _SPROCKET, axis=1)
    return _Cells(codes / scale, most / scale, beside / scale, full, sprocket / full, light)


def _full(core: Array, sprocket: Array) -> Array:
    """Return how dark a hole is around each frame, as a part of the paper's light, by the clear ones near.

    Sprocket holes, which are everywhere, are blurred more than code holes: these count where there are any.
    """
    clear = core > 0.5 * sprocket[:, None]
    more = np.median(core[clear]) / np.median(sprocket) if clear.sum() > 8 else 1.1
    full = np.empty(len(core))
    for at in range(len(core)):
        near = slice(max(0, at - _WINDOW), at + _WINDOW + 1)
        there = core[near][core[near] > 0.5 * np.median(sprocket[near])]
        full[at] = np.median(there) if len(there) >= 6 else more * np.median(sprocket[near])
    return np.maximum(full, 0.01)


def _doubts(cells: _Cells, tape: Found, beyond: Array, outside: Array) -> dict[str, Array]:
    """Return where (n, 8) a place is doubtful, by why, the worst first."""
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
        "between paper and hole": abs(cells.core - 0.5) < np.maximum(0.25, 4.5 * _noise(cells.core, hole)),
    }


def _noise(core: Array, hole: Array) -> Array:
    """Return the standard deviation of what is alike around each place, holes or paper."""
    found = np.empty(core.shape)
    for at in range(len(core)):
        near = slice(max(0, at - _WINDOW), at + _WINDOW + 1)
        for kind in np.unique(hole[at]):
            like = core[near][hole[near] == kind]
            found[at, hole[at] == kind] = 1.48 * np.median(abs(like - np.median(like)))
    return found
