"""A photograph or scan of tape becomes frames.

    sprocket holes   where each frame is                                        (sprockets.py)
    paper            reaches farther on the side of five channels than on that of three: which way it is read
    channels         the light at each place, between that of paper and that of holes around

Each frame has a confidence: how far its most doubtful channel is from the middle between paper and hole, 1
quite clear, 0 a guess. A hole that is open to a torn edge makes it doubtful, and a sprocket hole that was not
seen, beyond the last one too, if the paper goes on.

Not emulated: holes with hanging chad, folds. Tape seen from below looks like another tape seen from above:
`underside` has to say so.

Needs OpenCV, the extra `vision`. Source: ECMA-10 (the tracks' places, in pitches of .1 in).
"""

from typing import NamedTuple

import cv2
import numpy as np

from tapes import sprockets
from tapes.errors import TapeError
from tapes.sprockets import Array, Tape

DOUBTFUL = 0.5
"""A frame of less confidence wants to be looked at."""
LARGEST = 64_000_000
"""Pixels of a picture."""

_TRACKS = np.array([3, 2, 1, -1, -2, -3, -4, -5])
"""Channels 1 to 8, in pitches from the sprocket track towards channel 1."""
_BETWEEN = np.array([3.5, 2.5, 1.5, 0.5, -0.5, -1.5, -2.5, -3.5, -4.5, -5.5])
"""Between the tracks, where half way to the next frame there is paper."""
_BEYOND = 5.5
"""So many pitches from the sprocket track there is paper on the side of five channels only."""
_RING = [(np.cos(turn) / 2, np.sin(turn) / 2) for turn in np.arange(8) * np.pi / 4]
_ENOUGH = 2_000_000
_WINDOW = 10
_LEAST_CONTRAST = 8
_TORN, _UNSEEN = 0.3, 0.4
"""The most confidence left to a frame with a torn hole, or with a sprocket hole that was not seen."""


class Frame(NamedTuple):
    """A frame as it was seen: its holes, how sure that is, the channel most in doubt, its place in pixels."""

    holes: int
    confidence: float
    channel: int
    x: int
    y: int

    @property
    def doubtful(self) -> bool:
        """Whether the frame wants to be looked at."""
        return self.confidence < DOUBTFUL


def read(picture: bytes, underside: bool = False) -> list[Frame]:
    """Return the frames of the tape in a picture, a file's content, in the order in which they are read;
    several strips from top to bottom.

    Raises TapeError where there is no picture, or no tape in it.
    """
    light = _light(picture)
    scale = _scale(light.size)
    light = cv2.resize(light, None, fx=scale, fy=scale, interpolation=cv2.INTER_CUBIC)
    tape = sprockets.find(light)
    smooth = cv2.GaussianBlur(light, (0, 0), 0.12 * tape.pitch).astype(np.float32)
    found = [frame for strip in tape.strips for frame in _strip(tape, strip, smooth, underside)]
    return [frame._replace(x=frame.x // scale, y=frame.y // scale) for frame in found]


def _scale(pixels: int) -> int:
    """Return by how much a small picture is enlarged, so that a hole has some pixels."""
    return min(4, max(1, round((_ENOUGH / pixels) ** 0.5))) if pixels else 1


def _light(picture: bytes) -> Array:
    """Return the picture in the colour in which paper and holes differ most, without its speckles."""
    decoded = cv2.imdecode(np.frombuffer(picture, np.uint8), cv2.IMREAD_COLOR) if picture else None
    if decoded is None:
        raise TapeError("no picture that can be read: PNG, JPEG or TIFF is wanted")
    if decoded.shape[0] * decoded.shape[1] > LARGEST:
        raise TapeError(f"a picture of more than {LARGEST:,} pixels")
    colours = [*cv2.split(decoded), cv2.cvtColor(decoded, cv2.COLOR_BGR2GRAY)]
    return np.asarray(cv2.medianBlur(max(colours, key=lambda colour: float(colour.std())), 3))


def _strip(tape: Tape, strip: Array, smooth: Array, underside: bool) -> list[Frame]:
    places, seen = strip[:, :2], strip[:, 2]
    steps = _steps(places)
    left = np.stack([steps[:, 1], -steps[:, 0]], axis=1)
    on_left, on_right = (_at(tape.paper, places + side * _BEYOND * left).mean() for side in (1, -1))
    if abs(on_left - on_right) < 0.2:
        raise TapeError("three channels or five, on which side? The edges of the tape are not in the picture")
    if (on_left > on_right) != underside:
        places, seen, steps, left = places[::-1], seen[::-1], -steps[::-1], -left[::-1]
    seen[[0, -1]] *= [not _goes_on(tape.paper, end, way) for end, way in
                      ((places[0], -steps[0]), (places[-1], steps[-1]))]  # fmt: skip
    return _frames(places, seen, steps, -left if underside else left, smooth)


def _goes_on(paper: Array, end: Array, way: Array) -> bool:
    """Tell whether there is paper beyond the last sprocket hole that was seen, enough for another one."""
    across = np.array([way[1], -way[0]]) / 2
    return bool(_at(paper, end + 1.3 * way + np.array([across, -across])).min() > 0.5)


def _steps(places: Array) -> Array:
    """Return the way from each frame to the next, smoothed over its neighbours."""
    last = len(places) - 1
    before, after = (np.clip(np.arange(last + 1) + way, 0, last) for way in (-3, 3))
    return np.asarray((places[after] - places[before]) / (after - before)[:, None])


def _at(picture: Array, places: Array) -> Array:
    """Return the picture at places of any shape (..., 2), between its pixels; its edge goes on outside."""
    x, y = (np.ascontiguousarray(places[..., axis], dtype=np.float32).reshape(-1, 1) for axis in (0, 1))
    found = cv2.remap(picture.astype(np.float32), x, y, cv2.INTER_LINEAR, borderMode=cv2.BORDER_REPLICATE)
    return np.asarray(found).reshape(places.shape[:-1])


def _frames(places: Array, seen: Array, steps: Array, towards_1: Array, smooth: Array) -> list[Frame]:
    holes = places[:, None] + _TRACKS[:, None] * towards_1[:, None]
    corners = places[:, None] + steps[:, None] / 2 + _BETWEEN[:, None] * towards_1[:, None]
    paper = _around(np.median(_at(smooth, corners), axis=1))
    depth = paper[:, None] - _at(smooth, np.concatenate([places[:, None], holes], axis=1))
    full = _full_depth(depth)
    clear = abs(full) >= _LEAST_CONTRAST
    share = np.where(clear[:, None], depth[:, 1:] / np.where(clear, full, 1)[:, None], 0.5)
    around = [holes + along * steps[:, None] + across * towards_1[:, None] for along, across in _RING]
    ring = paper[:, None] - np.array([_at(smooth, places) for places in around])
    torn = (ring / np.where(clear, full, 1)[:, None] > 0.75).sum(axis=0) >= 2
    confidence = np.minimum(abs(share - 0.5) * 2, 1)
    confidence[torn] = _TORN
    confidence[seen == 0] = np.minimum(confidence[seen == 0], _UNSEEN)
    return [
        Frame(
            sum(1 << channel for channel in range(8) if share[at, channel] > 0.5),
            round(float(confidence[at].min()), 2),
            int(confidence[at].argmin()) + 1,
            round(places[at, 0]),
            round(places[at, 1]),
        )
        for at in range(len(places))
    ]


def _around(levels: Array) -> Array:
    """Return the median of each level and its neighbours."""
    return np.array([np.median(levels[max(0, at - 2) : at + 3]) for at in range(len(levels))])


def _full_depth(depth: Array) -> Array:
    """Return how much darker holes are than paper around each frame; brighter is negative.

    Sprocket holes, which are everywhere, are blurred more than code holes: these count where there are any.
    """
    found = np.empty(len(depth))
    for at in range(len(depth)):
        near = depth[max(0, at - _WINDOW) : at + _WINDOW + 1]
        sprocket = np.median(near[:, 0])
        found[at] = np.median(near[near / sprocket > 0.5]) if sprocket else 0
    return found
