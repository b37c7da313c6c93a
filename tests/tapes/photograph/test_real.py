"""Photographs of an ASR-33's tape by somebody else (real/NOTICE), transcribed by eye before they were read.

A strip is told without the blank tape at its ends. Both run off the picture: no frame is beyond its edge.
"""

from collections.abc import Callable
from pathlib import Path

import cv2
import pytest

from tapes import photograph
from tapes.photograph import Strip, pixels
from tapes.photograph.pixels import Array

REAL = Path(__file__).parent / "real"


def octal(frames: str) -> bytes:
    return bytes(int(frame, 8) for frame in frames.split())


_INVADER = "160 030 175 266 274 074 274 266 175 030 160"
STRIPS = {
    "tape_invaders": [
        octal(f"{_INVADER} 0 0 0 036 270 175 066 074 074 074 066 175 270 036 0 0 0 {_INVADER}"),
    ],
    "tape_invaders2": [
        octal("040 222 104 050 201 102 000 102 201 050 104 222 020"),
        octal("340 360 360 360 360 370 375 370 360 360 360 360 340"),
        octal(
            "074 102 102 102 044 0 0 176 012 032 052 104 0 0 176 112 112 112 102 0 0 176 102 102 102 074"
            " 0 0 102 176 102 0 0 002 002 176 002 002 0 0 0 0 0 074 122 112 102 074 0 0 104 176"
        ),
    ],
}
LENGTHS = {"tape_invaders": [44], "tape_invaders2": [50, 58, 64]}
"""Sprocket holes that are whole or cut by the edge of the picture by less than half."""


def holes(strip: Strip) -> bytes:
    return bytes(frame.holes for frame in strip.frames)


def outside(strip: Strip, light: Array) -> list[tuple[int, int]]:
    high, wide = light.shape[:2]
    return [(frame.x, frame.y) for frame in strip.frames if not (0 <= frame.x < wide and 0 <= frame.y < high)]


@pytest.mark.parametrize("name", STRIPS)
def test_what_is_read_is_what_the_eye_sees(name: str) -> None:
    content = (REAL / f"{name}.jpg").read_bytes()
    found = photograph.strips(content)
    assert [holes(strip).strip(b"\0") for strip in found] == STRIPS[name]
    assert [len(strip.frames) for strip in found] == LENGTHS[name]
    light = pixels.light(content)
    assert [place for strip in found for place in outside(strip, light)] == []
    assert [strip.off for strip in found] == {
        "tape_invaders": [(True, True)],
        "tape_invaders2": [(False, False), (True, False), (True, True)],
    }[name]
    assert sum(frame.doubtful for strip in found for frame in strip.frames) <= 4


WAYS: dict[str, Callable[[Array], Array]] = {
    "turned a quarter": lambda light: cv2.rotate(light, cv2.ROTATE_90_CLOCKWISE),
    "turned by half": lambda light: cv2.rotate(light, cv2.ROTATE_180),
    "mirrored": lambda light: light[:, ::-1],
    "half as large": lambda light: cv2.resize(light, None, fx=0.5, fy=0.5, interpolation=cv2.INTER_AREA),
    "poor JPEG": lambda light: light,
    "left part cut off": lambda light: light[:, light.shape[1] // 5 :],
    "right part cut off": lambda light: light[:, : light.shape[1] * 4 // 5],
}


@pytest.mark.slow("fourteen photographs, half a minute")
@pytest.mark.parametrize("way", WAYS)
@pytest.mark.parametrize("name", STRIPS)
def test_no_frame_is_wrong_and_sure_however_the_picture_is_spoilt(name: str, way: str) -> None:
    light = WAYS[way](pixels.light((REAL / f"{name}.jpg").read_bytes()))
    quality = 30 if way == "poor JPEG" else 92
    content = bytes(cv2.imencode(".jpg", light, [cv2.IMWRITE_JPEG_QUALITY, quality])[1])
    found = photograph.strips(content, underside=way == "mirrored")
    if way.startswith("turned"):
        found = found[::-1]  # what was the uppermost is the lowest now, or the rightmost
    assert [place for strip in found for place in outside(strip, light)] == []
    for strip, transcribed in zip(found, STRIPS[name], strict=True):
        assert not strip.why
        sure = [frame.holes if not frame.doubtful else -1 for frame in strip.frames]
        known = [0] * len(sure) + [*transcribed] + [0] * len(sure)
        shifts = range(len(known) - len(sure) + 1)
        right = [
            at
            for at in shifts
            if all(one in (-1, other) for one, other in zip(sure, known[at:], strict=False))
        ]
        assert right, f"wrong and sure: {holes(strip).hex(' ')}"
    assert sum(frame.doubtful for strip in found for frame in strip.frames) <= 6
