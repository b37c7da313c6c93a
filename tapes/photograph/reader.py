"""A photograph or scan of tape becomes frames.

A strip with more doubtful frames than the sure ones can carry is left out.

Not emulated: holes with hanging chad are doubtful, not mended; five-channel tape is refused. Tape seen from
below looks like another tape seen from above: `underside` has to say so.
"""

from typing import NamedTuple

import cv2
import numpy as np

from tapes.errors import TapeError
from tapes.photograph import cells, pixels, sprockets
from tapes.photograph.flat import SAMPLES, flatten
from tapes.photograph.paper import Found, find
from tapes.photograph.pixels import Array
from tapes.photograph.sheet import FIVE, THREE, Sheet

FEWEST_PIXELS = 5.2
"""From row to row and from track to track."""

_ADVICE = {
    "holes are not at their places": "lay it flat, and photograph it from straight above",
    "an edge of the paper is not seen": "both edges have to be uncovered, on a background of another colour",
    "paper that is not clear": "light it evenly",
    "too little light": "give it more light",
}
"""What to do about a strip most of whose frames are doubtful for this reason; about any other: _DARKER."""
_DARKER = "lay it on something black and even, or light it from behind"
_MOST_DOUBTFUL = 0.35
_FAILURES = 4
LONG = 20
"""Holes of a row that is called a tape though it cannot be read."""
_NEAR = 8
"""Steps: rows that are nearer to each other are on one strip."""
_NO_TAPE = "no tape is read: "


class Frame(NamedTuple):
    """A frame as it was seen: its holes; its doubtful channels, a mask; why the first of them is doubtful, or
    ""; the places in pixels of the sprocket hole and of channels 1 to 8; the channel that is nearest to being
    the opposite, a mask; and how near it is, 0 to .5 of a hole's darkness.
    """

    holes: int
    open: int
    why: str
    places: tuple[tuple[int, int], ...]
    weakest: int = 0
    margin: float = 0.5

    @property
    def doubtful(self) -> bool:
        """Whether the frame needs a check."""
        return self.open != 0

    @property
    def channel(self) -> int:
        """The first channel in doubt."""
        return (self.open & -self.open).bit_length()

    @property
    def place(self) -> str:
        """Its sprocket hole's place, in pixels from the left and from the top."""
        return "{}, {}".format(*self.places[0])


class Strip(NamedTuple):
    """A strip: its frames, whether the tape leaves the picture at either end, why it is unreadable or ""."""

    frames: list[Frame]
    off: tuple[bool, bool] = (False, False)
    why: str = ""
    ends: tuple[tuple[int, int], ...] = ()
    """The places of its first hole and its last, if they are known."""
    tape: bool = True
    """False for a row too short to be called a tape."""

    def turned(self) -> "Strip":
        """Return the strip as seen from above, if it was photographed from below."""
        return self._replace(frames=self.frames[::-1], off=self.off[::-1])


def read(picture: bytes, underside: bool = False) -> list[Frame]:
    """Return the frames of each readable strip. Raises TapeError if there is none, and as `strips`."""
    found = strips(picture, underside)
    if all(strip.why for strip in found):
        raise TapeError(found[0].why)
    return [frame for strip in found if not strip.why for frame in strip.frames]


def strips(picture: bytes, underside: bool = False) -> list[Strip]:
    """Return the strips of tape in a picture, a file's content, in the order in which they are read.

    They are read line after line, from top to bottom, or from left to right if most of them are upright; on
    one line as they lie, each after the one before. Raises TapeError where there is no picture or no tape.
    """
    light, *others = pixels.lights(picture)
    read, unread, why = _strips(light)
    for other in (*[255 - light] * (_sure(read) == 0), *others):
        if not read or any(strip.why for strip in read):
            better = _strips(other)
            if (_sure(better[0]), len(better[0])) > (_sure(read), len(read)):
                read, unread, _ = better
    if not read:
        raise TapeError(_NO_TAPE + why)
    ordered = _ordered([strip for strip in read if strip.frames], underside)
    ordered += (strip for strip in read if not strip.frames)
    ordered += unread
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


def _sure(strips: list[Strip]) -> int:
    """Return how many frames are certain in the strips that can be read."""
    return sum(not frame.doubtful for strip in strips if not strip.why for frame in strip.frames)


def _strips(light: Array) -> tuple[list[Strip], list[Strip], str]:
    """The strips with dark holes, the rows on none, and without strips why the likeliest row is no tape."""
    pictures = sprockets.sizes(light)
    found: list[tuple[Sheet, Array, Strip]] = []
    why: list[str] = []
    refused: list[tuple[sprockets.Row, str]] = []
    for row in sprockets.rows(pictures):
        if any(sheet.covers(row.places) for sheet, _, strip in found if strip.frames):
            continue
        if len(why) >= _FAILURES:
            why_not = (
                f"not looked at after {_FAILURES} rows that cannot be read: crop the picture to this one"
            )
            refused.append((row, why_not))
            continue
        try:
            tape = find(pictures, row)
        except TapeError as error:
            why.append(str(error))
            refused.append((row, str(error)))
            continue
        found.append((tape.sheet, row.places, _strip(pictures, tape)._replace(ends=_ends(row))))
        why += [strip.why for _, _, strip in found[-1:] if not strip.frames]
    said = why[0] if why else "no row of small round holes was found"
    kept: list[tuple[Sheet, Strip]] = []
    for sheet, places, strip in sorted(found, key=lambda one: not one[2].frames):
        if strip.frames or not any(other.covers(places) for other, _ in kept):
            kept.append((sheet, strip))
    return [strip for _, strip in kept], _unread(refused, [sheet for sheet, _ in kept]), said


def _unread(refused: list[tuple[sprockets.Row, str]], sheets: list[Sheet]) -> list[Strip]:
    """Return rows that are on no strip; of neighbours only the one with most holes."""
    rows: list[tuple[sprockets.Row, Strip]] = []
    for row, why in sorted(refused, key=lambda one: -int(one[0].seen.sum())):
        beside = any(_distance(row, other) < _NEAR for other, _ in rows)
        if beside or any(sheet.covers(row.places) for sheet in sheets):
            continue
        rows.append((row, Strip([], why=why, ends=_ends(row), tape=bool(row.seen.sum() >= LONG))))
    return [strip for _, strip in rows]


def _ends(row: sprockets.Row) -> tuple[tuple[int, int], ...]:
    return tuple((round(float(x)), round(float(y))) for x, y in row.places[[0, -1]])


def _distance(row: sprockets.Row, other: sprockets.Row) -> float:
    """Return how far two rows are apart where they are nearest, in steps of the wider one."""
    steps = (float(np.median(np.hypot(*np.diff(each.places, axis=0).T))) for each in (row, other))
    away = np.hypot(*np.moveaxis(row.places[:, None] - other.places, 2, 0))
    return float(away.min()) / max(steps)


def _strip(pictures: sprockets.Sizes, tape: Found) -> Strip:
    flat = flatten(pictures, tape.sheet)
    flat = flat._replace(light=cv2.GaussianBlur(flat.light, (0, 0), 0.08 * SAMPLES))
    u = np.arange(tape.sheet.length, dtype=float)[:, None]
    places = tape.sheet.place(u, np.concatenate([[0], cells.TRACKS]))
    shown = pictures.show(places)
    on_paper = cells.on_paper(flat, tape.edged) & shown[:, 0]
    if on_paper.sum() < sprockets.FEWEST:
        return Strip([], why=_NO_TAPE + "no paper around the row of holes")
    measured = cells.measure(flat, tape.sheet.length)
    along, across = tape.sheet.pitches()
    least = float(np.quantile(np.minimum(along, across)[on_paper], 0.02))
    if least < FEWEST_PIXELS:
        why = f"rows and tracks are only {least:.1f} pixels apart: 6 are needed; photograph it from nearer"
        return Strip([], why=why)
    doubts = cells.doubts(measured, tape, cells.ends(flat, tape.sheet, pictures, on_paper), ~shown[:, 1:])
    doubtful = np.any([*doubts.values()], axis=0)
    margin = abs(measured.core - 0.5)
    frames = [
        Frame(
            _mask(measured.core[at] > 0.5),
            _mask(doubtful[at]),
            next((why for why, where in doubts.items() if where[at, doubtful[at].argmax()]), ""),
            tuple((round(float(x)), round(float(y))) for x, y in places[at]),
            1 << int(margin[at].argmin()),
            float(margin[at].min()),
        )
        for at in np.nonzero(on_paper)[0]
    ]
    edges = pictures.show(tape.sheet.place(u[on_paper], np.array([-THREE, FIVE])))
    within = [frame for frame, shown in zip(frames, edges.tolist(), strict=True) if all(shown)]
    why = too_doubtful(within if len(within) >= sprockets.FEWEST else frames)
    return Strip(frames, _leaves(tape.sheet, pictures, on_paper), why)


def _leaves(sheet: Sheet, pictures: sprockets.Sizes, on_paper: Array) -> tuple[bool, bool]:
    """Return whether the tape may continue beyond the picture, before the first row and after the last."""
    rows = np.nonzero(on_paper)[0]
    beyond = sheet.place(np.array([[rows[0] - 1.25], [rows[-1] + 1.25]]), np.array([-THREE, 0, FIVE]))
    before, after = (not pictures.show(places).all() for places in beyond)
    return before, after


def _mask(channels: Array) -> int:
    return sum(1 << channel for channel in np.nonzero(channels)[0].tolist())


def too_doubtful(frames: list[Frame]) -> str:
    """Return why a strip cannot be read if too many of its frames are doubtful, or ""."""
    why = [frame.why for frame in frames if frame.doubtful]
    if len(why) <= _MOST_DOUBTFUL * len(frames):
        return ""
    most = max(set(why), key=why.count)
    advice = _ADVICE.get(most, _DARKER)
    return f"{len(why)} of {len(frames)} frames are doubtful, most of them: {most}; {advice}"
