"""Pictures without a tape, drawn: what may be taken for one, and what lies on desks beside one."""

from collections.abc import Callable
from typing import Any

import numpy as np
from PIL import Image, ImageDraw, ImageFont

from tests.tapes.photograph.camera import _blurred

Array = np.ndarray[Any, Any]
_SIZE = 900, 700


def _drawn(draw: Callable[[ImageDraw.ImageDraw], None], ground: int = 215, blur: float = 0.8) -> Array:
    image = Image.new("L", (_SIZE[0] * 2, _SIZE[1] * 2), ground)
    draw(ImageDraw.Draw(image))
    return _blurred(np.asarray(image.resize(_SIZE, Image.Resampling.BOX), dtype=float), blur)


def _dot(draw: ImageDraw.ImageDraw, x: float, y: float, across: float, level: int) -> None:
    draw.ellipse((x - across / 2, y - across / 2, x + across / 2, y + across / 2), fill=level)


def _text(draw: ImageDraw.ImageDraw) -> None:
    font = ImageFont.load_default(26)
    for row in range(30):
        draw.text(
            (60, 40 + 44 * row),
            f"{row} of the holes ........................ and so on: {row * 37}",
            30,
            font,
        )


def _dots_and_frame(draw: ImageDraw.ImageDraw) -> None:
    for row in range(8):
        draw.rectangle((40, 60 + 160 * row, 1700, 60 + 160 * row + 100), outline=40, width=3)
        for at in range(60):
            _dot(draw, 70 + 27 * at, 60 + 160 * row + 50, 12, 40)


def _chessboard(draw: ImageDraw.ImageDraw) -> None:
    for x in range(24):
        for y in range(18):
            if (x + y) % 2:
                draw.rectangle((100 + 66 * x, 90 + 66 * y, 166 + 66 * x, 156 + 66 * y), fill=40)


def _sheet(draw: ImageDraw.ImageDraw) -> None:
    for x in range(52):
        for y in range(40):
            _dot(draw, 60 + 33 * x, 40 + 33 * y, 18, 50)


def _strip_of_sheet(draw: ImageDraw.ImageDraw) -> None:
    draw.rectangle((0, 0, 1800, 1400), fill=60)
    draw.rectangle((40, 400, 1760, 730), fill=210)
    for x in range(50):
        for y in range(9):
            _dot(draw, 80 + 33 * x, 435 + 33 * y, 16, 60)


def _stamps(draw: ImageDraw.ImageDraw) -> None:
    for column in range(6):
        for row in range(4):
            for at in range(16):
                _dot(draw, 80 + 280 * column, 80 + 320 * row + 20 * at, 12, 60)
                _dot(draw, 80 + 280 * column + 17.5 * at, 80 + 320 * row, 12, 60)
            draw.ellipse((150 + 280 * column, 150 + 320 * row, 290 + 280 * column, 330 + 320 * row), fill=120)


def _film(draw: ImageDraw.ImageDraw) -> None:
    draw.rectangle((0, 500, 1800, 860), fill=40)
    for at in range(48):
        for y in (515, 820):
            draw.rounded_rectangle((20 + 37 * at, y, 38 + 37 * at, y + 26), 5, fill=215)


def _toy_car(draw: ImageDraw.ImageDraw) -> None:
    draw.rounded_rectangle((300, 600, 1500, 900), 80, fill=90)
    draw.polygon([(560, 600), (700, 420), (1150, 420), (1300, 600)], fill=110)
    for x in (560, 1240):
        for across, level in ((260, 30), (150, 170), (60, 50)):
            _dot(draw, x, 900, across, level)
        for turn in np.linspace(0, 2 * np.pi, 12, endpoint=False):
            _dot(draw, x + 95 * np.cos(turn), 900 + 95 * np.sin(turn), 22, 40)
    for at in range(14):
        _dot(draw, 420 + 70 * at, 700, 20, 200)


def _desk(draw: ImageDraw.ImageDraw) -> None:
    random = np.random.default_rng(5)
    for _ in range(30):
        x, y, wide, high = random.uniform(0, 1700), random.uniform(0, 1300), *random.uniform(40, 500, 2)
        draw.rectangle((x, y, x + wide, y + high), fill=int(random.uniform(30, 250)))
    for row in range(5):
        for key in range(14):
            draw.rounded_rectangle(
                (200 + 90 * key, 700 + 90 * row, 275 + 90 * key, 775 + 90 * row), 12, fill=40
            )
            _dot(draw, 237 + 90 * key, 737 + 90 * row, 24, 220)
    draw.rectangle((100, 1250, 1700, 1330), fill=190)
    for at in range(80):
        draw.line((100 + 20 * at, 1250, 100 + 20 * at, 1290 if at % 5 else 1310), fill=30, width=3)


def _five_channels(draw: ImageDraw.ImageDraw) -> None:
    random = np.random.default_rng(3)
    draw.rectangle((0, 0, 1800, 1400), fill=60)
    draw.rectangle((40, 500, 1760, 500 + round(6.89 * 30)), fill=210)
    for at in range(56):
        x = 60 + 30 * at
        _dot(draw, x, 500 + 2.72 * 30, 14, 60)
        for track in (-2, -1, 1, 2, 3):
            if random.uniform() < 0.5:
                _dot(draw, x, 500 + (2.72 + track) * 30, 22, 60)


def _noise(scale: float) -> Array:
    texture = _blurred(np.random.default_rng(2).normal(0, 1, _SIZE[::-1]), scale)
    return np.asarray(128 + 45 * texture / texture.std())


def _wood() -> Array:
    y, x = np.mgrid[: _SIZE[1], : _SIZE[0]]
    return np.asarray(
        110 + 20 * np.sin(y / 9 + 2 * np.sin(x / 130)) + 9 * np.sin(y / 3.1 + 3 * np.sin(x / 210))
    )


SCENES: dict[str, Callable[[], Array]] = {
    "nothing": lambda: np.full(_SIZE[::-1], 128.0),
    "noise": lambda: _noise(0.5),
    "cloth": lambda: _noise(2.5),
    "clouds": lambda: _noise(20),
    "text with dots": lambda: _drawn(_text, 235),
    "dots in frames": lambda: _drawn(_dots_and_frame, 235),
    "a chessboard": lambda: _drawn(_chessboard),
    "a perforated sheet": lambda: _drawn(_sheet),
    "a strip of it": lambda: _drawn(_strip_of_sheet),
    "stamps": lambda: _drawn(_stamps),
    "film": lambda: _drawn(_film),
    "a toy car": lambda: _drawn(_toy_car),
    "a desk": lambda: _drawn(_desk, 150),
    "five-channel tape": lambda: _drawn(_five_channels),
    "wood": _wood,
}
