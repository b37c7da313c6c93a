"""Pictures without an eight-channel tape, drawn: what may be taken for one."""

from collections.abc import Callable
from typing import Any

import numpy as np
from PIL import Image, ImageDraw, ImageFont

from tests.tapes.photograph import camera

_SIZE = 900, 700


def picture(name: str) -> np.ndarray[Any, Any]:
    """Return a scene in grey levels."""
    ground, draw, _ = SCENES[name]
    image = Image.new("L", (_SIZE[0] * 2, _SIZE[1] * 2), ground)
    draw(ImageDraw.Draw(image))
    return camera.blurred(np.asarray(image.resize(_SIZE, Image.Resampling.BOX), dtype=float), 0.8)


def _dot(draw: ImageDraw.ImageDraw, x: float, y: float, across: float, level: int = 60) -> None:
    draw.ellipse((x - across / 2, y - across / 2, x + across / 2, y + across / 2), fill=level)


def _noise(draw: ImageDraw.ImageDraw) -> None:
    levels = np.random.default_rng(2).normal(128, 45, (1400, 1800)).clip(0, 255)
    draw.bitmap((0, 0), Image.fromarray(levels.astype(np.uint8)), fill=255)


def _text(draw: ImageDraw.ImageDraw) -> None:
    for row in range(30):
        text = f"{row} of the holes ........................ and so on: {row * 37}"
        draw.text((60, 40 + 44 * row), text, 30, ImageFont.load_default(26))


def _film(draw: ImageDraw.ImageDraw) -> None:
    draw.rectangle((0, 500, 1800, 860), fill=40)
    for at in range(48):
        for y in (515, 820):
            draw.rounded_rectangle((20 + 37 * at, y, 38 + 37 * at, y + 26), 5, fill=215)


def _desk(draw: ImageDraw.ImageDraw) -> None:
    random = np.random.default_rng(5)
    for _ in range(30):
        x, y, wide, high = random.uniform(0, 1700), random.uniform(0, 1300), *random.uniform(40, 500, 2)
        draw.rectangle((x, y, x + wide, y + high), fill=int(random.uniform(30, 250)))
    for x in range(200, 1460, 90):
        for y in range(700, 1150, 90):
            draw.rounded_rectangle((x, y, x + 75, y + 75), 12, fill=40)  # a key
            _dot(draw, x + 37, y + 37, 24, 220)


def _perforated(draw: ImageDraw.ImageDraw) -> None:
    draw.rectangle((40, 400, 1760, 730), fill=210)
    for x in range(50):
        for y in range(9):
            _dot(draw, 80 + 33 * x, 435 + 33 * y, 16)


def _five_channels(draw: ImageDraw.ImageDraw) -> None:
    random = np.random.default_rng(3)
    draw.rectangle((40, 494, 1760, 700), fill=210)  # 17.46 mm, the sprocket holes 9.96 from its lower edge
    for x in range(60, 1740, 30):
        _dot(draw, x, 582, 14)
        for y in (522, 552, 612, 642, 672):
            if random.uniform() < 0.5:
                _dot(draw, x, y, 22)


_EDGES = "the paper's edges are not 3.92 and 6.08 rows' distances from the sprocket holes"
SCENES: dict[str, tuple[int, Callable[[ImageDraw.ImageDraw], None], str]] = {
    "noise": (0, _noise, "no row of small round holes was found"),
    "text with dots": (235, _text, _EDGES),
    "film": (215, _film, _EDGES),
    "a desk": (150, _desk, _EDGES),
    "a strip of a perforated sheet": (60, _perforated, "the holes are all of one size"),
    "five-channel tape": (60, _five_channels, "a five-channel tape: only tape of eight channels is read"),
}
"""By each name how light its ground is, what is drawn on it, and why it is refused."""
