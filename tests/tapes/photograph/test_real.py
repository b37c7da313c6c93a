"""Photographs of an ASR-33's tape by somebody else (real/NOTICE), transcribed by eye before they were read.

A strip is told without the blank tape at its ends. Both run off the picture: no frame is beyond its edge.
"""

from collections.abc import Callable
from pathlib import Path

import cv2
import numpy as np
import pytest

from tapes import photograph
from tapes.photograph import Strip
from tapes.photograph.pixels import Array

REAL = Path(__file__).parent / "real"


def octal(frames: str) -> bytes:
    return bytes(int(frame, 8) for frame in frames.split())


_INVADER = "160 030 175 266 274 074 274 266 175 030 160"
_SECOND = "036 270 175 066 074 074 074 066 175 270 036"
_SQUIDS = "230 134 266 137 137 266 134 230", "130 274 026 077 077 026 274 130"
_OCTOPI = "234 236 136 166 067 137 137 067 166 136 236 234", "034 136 376 266 067 137 137 067 266 376 136 034"
STRIPS = {
    "tape_invaders": [
        octal(f"{_INVADER} 0 0 0 {_SECOND} 0 0 0 {_INVADER}"),
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
BOOK = [
    octal(" 0 0 0 0 0 0 ".join((*_SQUIDS, *_SQUIDS, _SQUIDS[0]))),
    octal(" 0 0 0 ".join((_INVADER, _SECOND, _INVADER, _SECOND, _INVADER))),
    octal(" 0 0 ".join((*_OCTOPI, *_OCTOPI, _OCTOPI[0]))),
]


def holes(strip: Strip) -> bytes:
    return bytes(frame.holes for frame in strip.frames)


def picture(file: Path) -> Array:
    content = np.frombuffer(file.read_bytes(), np.uint8)
    return np.asarray(cv2.imdecode(content, cv2.IMREAD_COLOR))


def outside(strip: Strip, light: Array) -> list[tuple[int, int]]:
    high, wide = light.shape[:2]
    places = [frame.places[0] for frame in strip.frames]
    return [(x, y) for x, y in places if not (0 <= x < wide and 0 <= y < high)]


@pytest.mark.parametrize("name", STRIPS)
def test_what_is_read_is_what_the_eye_sees(name: str) -> None:
    content = (REAL / f"{name}.jpg").read_bytes()
    found = [strip for strip in photograph.strips(content) if strip.frames]
    assert [holes(strip).strip(b"\0") for strip in found] == STRIPS[name]
    assert [len(strip.frames) for strip in found] == LENGTHS[name]
    assert [place for strip in found for place in outside(strip, picture(REAL / f"{name}.jpg"))] == []
    assert [strip.off for strip in found] == {
        "tape_invaders": [(True, True)],
        "tape_invaders2": [(False, False), (True, False), (True, True)],
    }[name]
    assert sum(frame.doubtful for strip in found for frame in strip.frames) <= 5


WAYS: dict[str, Callable[[Array], Array]] = {
    "turned a quarter": lambda light: cv2.rotate(light, cv2.ROTATE_90_CLOCKWISE),
    "turned by half": lambda light: cv2.rotate(light, cv2.ROTATE_180),
    "mirrored": lambda light: light[:, ::-1],
    "half as large": lambda light: cv2.resize(light, None, fx=0.5, fy=0.5, interpolation=cv2.INTER_AREA),
    "poor JPEG": lambda light: light,
    "left part cut off": lambda light: light[:, light.shape[1] // 5 :],
    "right part cut off": lambda light: light[:, : light.shape[1] * 4 // 5],
}


def is_wrong(strip: Strip, transcribed: bytes) -> bool:
    """Tell whether a sure frame is not as it was transcribed, wherever on that tape the strip begins."""
    sure = [frame.holes if not frame.doubtful else -1 for frame in strip.frames]
    known = [0] * len(sure) + [*transcribed] + [0] * len(sure)
    return not any(
        all(one in (-1, other) for one, other in zip(sure, known[at:], strict=False))
        for at in range(len(known) - len(sure) + 1)
    )


def read(name: str, way: str) -> list[Strip]:
    """Return the strips of the picture made so, in the order of the picture as it was; none is outside it."""
    light = WAYS[way](picture(REAL / f"{name}.jpg"))
    quality = 30 if way == "poor JPEG" else 92
    content = bytes(cv2.imencode(".jpg", light, [cv2.IMWRITE_JPEG_QUALITY, quality])[1])
    found = [strip for strip in photograph.strips(content, underside=way == "mirrored") if strip.frames]
    assert [place for strip in found for place in outside(strip, light)] == []
    return found[::-1] if way.startswith("turned") else found  # what was the uppermost is the lowest now


@pytest.mark.slow("fourteen photographs, half a minute")
@pytest.mark.parametrize("way", WAYS)
@pytest.mark.parametrize("name", STRIPS)
def test_no_frame_is_wrong_and_sure_however_the_picture_is_spoilt(name: str, way: str) -> None:
    found = read(name, way)
    for strip, transcribed in zip(found, STRIPS[name], strict=True):
        assert (strip.why, is_wrong(strip, transcribed)) == ("", False)
    assert sum(frame.doubtful for strip in found for frame in strip.frames) <= 6


RARE = ("turned by half", "poor JPEG", "left part cut off")
"""Of these ways others are much like."""


@pytest.mark.slow("three photographs, each in all colours, 20 s; six by WHOLE=1")
@pytest.mark.parametrize(
    "way",
    [
        pytest.param(way, marks=pytest.mark.rare("7 s each")) if way in RARE else way
        for way in WAYS
        if way != "half as large"
    ],
)
def test_tape_over_a_coloured_book_is_read_in_the_colour_in_which_its_holes_are_dark(way: str) -> None:
    """In blue, where most differs, the cover is brighter than the paper. Beneath the third strip it ends.

    The picture is half as large already.
    """
    *above, lowest = read("tape_book1", way)
    for strip, transcribed in zip(above, BOOK, strict=False):
        assert (len(above), strip.why, is_wrong(strip, transcribed)) == (2, "", False)
        assert sum(frame.doubtful for frame in strip.frames) <= 12
    assert not is_wrong(lowest, BOOK[2])


PARCELS = [
    (705, 337),
    (929, 641),
    (1378, 609),
    (1378, 833),
    (1362, 1042),
    (978, 1234),
    (176, 689),
    (192, 1218),
]
"""A place on each strip that a person has counted on the parcels, and could read."""


@pytest.mark.slow("a photograph in all colours, half a minute")
def test_every_strip_that_a_person_counts_is_read_or_left_out_with_its_place() -> None:
    found = photograph.strips((REAL / "tape_xmas.jpg").read_bytes())
    assert all(strip.why or strip.frames for strip in found)
    lines = [np.array(strip.ends, dtype=float) for strip in found]
    for place in PARCELS:
        assert min(away(np.array(place), *line) for line in lines) < 80, place


def away(place: Array, start: Array, end: Array) -> float:
    """Return how far a place is from a line between two others."""
    along = end - start
    part = np.clip((place - start) @ along / (along @ along), 0, 1)
    return float(np.hypot(*(place - start - part * along)))
