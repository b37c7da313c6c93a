"""A picture's file: its size by its header, as the standards have it, before it is decoded; its light."""

import struct
from io import BytesIO

import numpy as np
import pytest
from PIL import Image

from tapes.errors import TapeError
from tapes.photograph import pixels

NONE = "no picture that can be read: PNG, JPEG or TIFF is wanted"


def header(kind: str, wide: int, high: int) -> bytes:
    """Return how a file of a picture of this size begins, as its standard has it."""
    match kind:
        case "PNG":
            return b"\x89PNG\r\n\x1a\n\0\0\0\rIHDR" + struct.pack(">II", wide, high)
        case "TIFF":
            entries = struct.pack("<HHIIHHII", 256, 4, 1, wide, 257, 4, 1, high)
            return b"II*\0\x0c\0\0\0####\2\0" + entries
        case "TIFF of a Macintosh":
            entries = struct.pack(">HHIHHHHII", 256, 3, 1, wide, 0xFFFF, 257, 4, 1, high)
            return b"MM\0*\0\0\0\x08\0\2" + entries
    # of a JPEG other segments before that of the frame, which `kind` ends with, and a filling byte
    others = b"".join(b"\xff%c\0\2" % code for code in b"\xc4\xc8\xcc\xd0\xbf")
    frame = bytes.fromhex(f"ffff{kind[-2:]}") + struct.pack(">HBHH", 11, 8, high, wide)
    return b"\xff\xd8\xff\xe0\1\x02" + bytes(256) + others + frame


@pytest.mark.parametrize(
    ("kind", "wide", "high"),
    [
        ("PNG", 0x01020304, 0x05060708),
        ("PNG", 64_000_001, 1),
        ("JPEG C0", 0x2345, 0xFEDC),
        ("JPEG CF", 0x2345, 0xFEDC),
        ("TIFF", 0x01020304, 0x05060708),
        ("TIFF of a Macintosh", 0x2345, 0x05060708),
    ],
)
def test_a_picture_of_too_many_pixels_is_not_decoded(kind: str, wide: int, high: int) -> None:
    with pytest.raises(TapeError, match=f"{wide:,} by {high:,} pixels: a picture may have 64,000,000"):
        pixels.lights(header(kind, wide, high))
    for size in ((0, 7), (7, 0), (8000, 8000)):
        with pytest.raises(TapeError, match=NONE):
            pixels.lights(header(kind, *size))


def file(light: pixels.Array, kind: str) -> bytes:
    written = BytesIO()
    Image.fromarray(light).save(written, kind)
    return written.getvalue()


STRIPES = np.full((40, 60, 3), 128, np.uint8)
STRIPES[::2] += np.array([20, 0, 80], np.uint8)  # red, green, blue


@pytest.mark.parametrize(
    "content", [b"", b"\x89PNG\r\n", b"\xff\xd8\xff\xe0", b"GIF89a" + bytes(100), file(STRIPES, "BMP")]
)
def test_what_is_no_picture_is_refused(content: bytes) -> None:
    with pytest.raises(TapeError, match=NONE):
        pixels.lights(content)


@pytest.mark.parametrize("kind", ["PNG", "TIFF"])
def test_light_is_the_colour_in_which_most_differs(kind: str) -> None:
    for order in ((0, 1, 2), (1, 2, 0), (2, 0, 1)):
        assert (pixels.lights(file(STRIPES[:, :, order], kind))[0] == STRIPES[:, :, 2]).all()


def test_what_a_page_shows_is_a_jpeg_of_quality_85() -> None:
    shown = Image.open(BytesIO(pixels.shown(file(STRIPES, "PNG"))))
    assert (shown.format, shown.size) == ("JPEG", (60, 40))
    assert shown.quantization[0][:3] == [5, 3, 3]  # type: ignore[attr-defined]  # 30 % of T.81's Table K.1: 16, 11, 10


def test_the_top_between_three_places_is_a_parabolas() -> None:
    tops = np.linspace(-0.5, 0.5, 11)
    for height in (3, 1e-3):
        before, top, after = (5 - height * (step - tops) ** 2 for step in (-1, 0, 1))
        assert pixels.vertex(before, top, after) == pytest.approx(tops)
    level, higher = np.zeros(1), np.ones(1)
    assert pixels.vertex(level, level, level) == 0
    assert pixels.vertex(level, level, higher) == 0.5, "no farther than half way"
    assert pixels.vertex(2 * higher, 1.1 * higher, level) == -0.5
