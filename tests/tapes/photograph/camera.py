"""Photographs of tape: paper with holes in millimetres, bent, lit, and seen through a lens.

    sheet    ECMA-10: 25.4 wide, rows 2.54 apart; code holes 1.83 and feed holes 1.17 across, feed holes 9.96
             from the edge beside channel 1, three tracks on that side and five on the other, 2.54 apart
    space    the sheet bends along its length as an arc, and is turned in front of a camera with one eye
    lens     barrel distortion, blur
    light    falls off over the picture; a shadow lies across it; what is under a hole is in its shadow
    film     noise, JPEG

It shares nothing with the reader: outlines are computed as polygons and filled by Pillow, and no OpenCV is
used. Source: ECMA-10; lengths in millimetres until they are projected.
"""

from collections.abc import Iterable, Iterator, Sequence
from io import BytesIO
from typing import Any, NamedTuple

import numpy as np
from PIL import Image, ImageDraw

Array = np.ndarray[Any, Any]

ROW, WIDTH, FEED_TRACK, CODE_HOLE, FEED_HOLE = 2.54, 25.4, 9.96, 1.83, 1.17
TRACKS = FEED_TRACK + ROW * np.array([0, -3, -2, -1, 1, 2, 3, 4, 5])
"""Of the sprocket holes and of channels 1 to 8."""
_OVERSAMPLED = 4
_TURNS = np.linspace(0, 2 * np.pi, 24, endpoint=False)
_CIRCLE = np.stack([np.cos(_TURNS), np.sin(_TURNS)], axis=1) / 2
_THUMB = np.array([[-ROW, -9], [2 * ROW, -9], [2 * ROW, 30], [-ROW, 30]])


class Shot(NamedTuple):
    """How a tape lies and is photographed.

    `row` is the distance of two rows in pixels where it is least. `perspective` p: the nearer end is seen
    (1 + p) / (1 - p) as large as the farther one, which lies towards `towards` degrees. `curl` is the rise of
    the arc in parts of its chord. `barrel` k: what is at the picture's corner comes 1 - k as far from its
    middle. `fall` and `shadow` are the part of the light that is lost, at one end and beyond the shadow's
    edge. `blur` is a standard deviation in rows, `noise` one in grey levels of 256.
    """

    row: float = 12
    angle: float = 0
    perspective: float = 0
    towards: float = 0
    curl: float = 0
    barrel: float = 0
    fall: float = 0
    fall_towards: float = 0
    shadow: float = 0
    shadow_at: float = 0.5
    noise: float = 2
    blur: float = 0.06
    jpeg: int = 92
    paper: int = 205
    behind: int = 60
    table: str = "plain"
    below: bool = False
    covered: Sequence[int] = ()
    seed: int = 1


def photograph(frames: bytes, shot: Shot) -> bytes:
    """Return a JPEG file of a tape of these frames."""
    return develop(picture(frames, shot), shot)


def develop(light: Array, shot: Shot) -> bytes:
    """Return light in grey levels as a JPEG file, with the noise of the shot."""
    noisy = light + np.random.default_rng(shot.seed).normal(0, shot.noise, light.shape)
    file = BytesIO()
    Image.fromarray(np.clip(noisy, 0, 255).astype(np.uint8)).save(file, "JPEG", quality=shot.jpeg)
    return file.getvalue()


def picture(frames: bytes, shot: Shot) -> Array:
    """Return the light that falls on the film, in grey levels."""
    eye = _Eye(len(frames), shot)
    paper = eye.cover([_edge(len(frames))])
    hole = eye.cover(_holes(frames))
    finger = eye.cover(_THUMB + np.array([at * ROW, 0]) for at in shot.covered)
    table = _table(shot, eye.height, eye.width)
    light = table * (1 - paper) + paper * ((1 - hole) * shot.paper + hole * 0.85 * table)
    light = light * (1 - finger) + finger * 0.6 * (shot.paper + shot.behind) / 2
    light = light * _light(shot, eye.height, eye.width)
    return blurred(light, shot.blur * shot.row * 1.3)


def places(length: int, shot: Shot) -> Array:
    """Return the pixels (length, 9, 2) of each frame's sprocket hole and channels 1 to 8."""
    along, across = np.meshgrid((np.arange(length) + 0.5) * ROW, TRACKS, indexing="ij")
    sheet = np.stack([along.ravel(), across.ravel()], axis=1)
    return _Eye(length, shot).place(sheet).reshape(length, 9, 2) - 0.5


class _Eye:
    """Where a place on the sheet comes to lie in the picture, in pixels."""

    def __init__(self, length: int, shot: Shot) -> None:
        self._shot = shot
        self._half = (length + 4) * ROW / 2
        self._middle = length * ROW / 2
        flat = self._project(np.concatenate([_edge(length), [[self._middle, FEED_TRACK]]]))
        self._centre = flat[-1]
        self._radius = float(np.hypot(*(flat - self._centre).T).max())
        rows = np.array([[at * ROW, side] for at in range(length + 1) for side in (0, WIDTH)])
        seen = self._seen(rows).reshape(-1, 2, 2)
        along = np.hypot(*np.diff(seen, axis=0).reshape(-1, 2).T).min()
        across = np.hypot(*(seen[:, 1] - seen[:, 0]).T).min() / 10
        self._scale = shot.row / min(along, across)
        corners = self._seen(_edge(length)) * self._scale
        margin = 4 * shot.row
        self._corner = corners.min(axis=0) - margin
        self.width, self.height = (int(size) for size in np.ceil(corners.max(axis=0) - self._corner + margin))

    def place(self, sheet: Array) -> Array:
        """Return pixels (n, 2) of places on the sheet (n, 2), along and across in millimetres."""
        return np.asarray(self._seen(sheet) * self._scale - self._corner)

    def cover(self, outlines: Iterable[Array]) -> Array:
        """Return which part of each pixel lies within outlines on the sheet."""
        mask = Image.new("L", (self.width * _OVERSAMPLED, self.height * _OVERSAMPLED))
        for outline in outlines:
            ImageDraw.Draw(mask).polygon([*map(tuple, self.place(outline) * _OVERSAMPLED)], fill=255)
        small = mask.resize((self.width, self.height), Image.Resampling.BOX)
        return np.asarray(small, dtype=float) / 255

    def _seen(self, sheet: Array) -> Array:
        """Return places as the lens has them."""
        flat = (self._project(sheet) - self._centre) / self._radius
        lens = 1 - self._shot.barrel * (flat**2).sum(axis=1)[:, None]
        return np.asarray(flat * lens * self._radius)

    def _project(self, sheet: Array) -> Array:
        shot = self._shot
        x, y = sheet[:, 0] - self._middle, sheet[:, 1] - WIDTH / 2
        if shot.below:
            y = -y
        z = np.zeros_like(x)
        if shot.curl:
            bend = 4 * np.arctan(2 * abs(shot.curl))  # the whole angle of an arc that rises so far
            radius = 2 * self._half / bend
            x, z = radius * np.sin(x / radius), np.sign(shot.curl) * radius * (np.cos(x / radius) - 1)
        away = 1.6 * self._half
        tilt = np.arcsin(shot.perspective * away / self._half)
        forth, side = _turned(x, y, shot.angle - shot.towards)
        forth, depth = forth * np.cos(tilt) - z * np.sin(tilt), away + forth * np.sin(tilt) - z * np.cos(tilt)
        return np.asarray(np.stack(_turned(forth, side, shot.towards), axis=1) / depth[:, None] * away)


def _turned(x: Array, y: Array, degrees: float) -> tuple[Array, Array]:
    turn = np.radians(degrees)
    return x * np.cos(turn) - y * np.sin(turn), x * np.sin(turn) + y * np.cos(turn)


def _edge(length: int) -> Array:
    """Return the outline of the sheet, which is cut half way beyond the first and the last row."""
    along = np.linspace(0, length, 4 * length) * ROW
    return np.array([*((x, 0) for x in along), *((x, WIDTH) for x in along[::-1])])


def _holes(frames: bytes) -> Iterator[Array]:
    """Yield the outlines of the holes."""
    for number, frame in enumerate(frames):
        for channel, track in enumerate(TRACKS):
            if (frame << 1 | 1) >> channel & 1:
                yield _CIRCLE * (CODE_HOLE if channel else FEED_HOLE) + ((number + 0.5) * ROW, track)


def _places(height: int, width: int, towards: float) -> Array:
    """Return for each pixel how far it lies towards an angle, from 0 at one corner to 1 at the other."""
    y, x = np.mgrid[:height, :width]
    along, _ = _turned(x, y, -towards)
    return np.asarray((along - along.min()) / (along.max() - along.min()))


def _table(shot: Shot, height: int, width: int) -> Array:
    random = np.random.default_rng(shot.seed + 1000)
    level = np.full((height, width), float(shot.behind))
    if shot.table == "wood":
        y, x = np.mgrid[:height, :width]
        level += 14 * np.sin(y / 9 + 2 * np.sin(x / 130)) + 8 * np.sin(y / 3.1 + 3 * np.sin(x / 210))
    elif shot.table == "desk":
        for _ in range(14):
            x, y = random.uniform(0, width), random.uniform(0, height)
            wide, high = random.uniform(20, width / 4), random.uniform(20, height / 3)
            level[int(y) : int(y + high), int(x) : int(x + wide)] += random.uniform(-40, 60)
    return np.asarray(np.clip(level, 4, 250))


def _light(shot: Shot, height: int, width: int) -> Array:
    light = 1 - shot.fall * _places(height, width, shot.fall_towards)
    if shot.shadow:
        across = (_places(height, width, shot.angle + 20) - shot.shadow_at) * width
        light = light * (1 - shot.shadow / (1 + np.exp(-across / 3)))
    return light


def blurred(light: Array, radius: float) -> Array:
    """Return light through a Gaussian of so many pixels."""
    reach = int(4 * radius)
    kernel = np.exp(-0.5 * (np.arange(-reach, reach + 1) / radius) ** 2)
    for axis in (0, 1):
        sides = [(reach, reach) if way == axis else (0, 0) for way in (0, 1)]
        padded = np.pad(light, sides, mode="edge")
        light = np.apply_along_axis(np.convolve, axis, padded, kernel / kernel.sum(), "valid")
    return light
