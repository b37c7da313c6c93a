"""What is no picture, or has too many pixels by its header, is refused before it is decoded."""

import struct
import zlib

import pytest

cv2 = pytest.importorskip("cv2", reason="OpenCV is not installed")

from tapes import photograph  # noqa: E402
from tapes.errors import TapeError  # noqa: E402


def png(width: int, height: int) -> bytes:
    """Return a PNG file that says it has so many pixels."""

    def chunk(name: bytes, content: bytes) -> bytes:
        return (
            struct.pack(">I", len(content)) + name + content + struct.pack(">I", zlib.crc32(name + content))
        )

    header = chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 0, 0, 0, 0))
    return b"\x89PNG\r\n\x1a\n" + header + chunk(b"IDAT", zlib.compress(bytes(1000))) + chunk(b"IEND", b"")


def tiff(order: str, width: int, height: int) -> bytes:
    entries = struct.pack(order + "H", 2) + b"".join(
        struct.pack(order + "HHII", tag, 4, 1, length) for tag, length in ((256, width), (257, height))
    )
    return (b"II*\0" if order == "<" else b"MM\0*") + struct.pack(order + "I", 8) + entries


JPEG = b"\xff\xd8\xff\xe0\0\4\0\0\xff\xc0\0\x0b\x08" + struct.pack(">HH", 40_000, 30_000) + b"\1\1\x11\0"


@pytest.mark.parametrize(
    ("content", "complaint"),
    [
        (b"", "no picture that can be read"),
        (b"\x89PNG\r\n", "no picture that can be read"),
        (b"GIF89a" + bytes(100), "PNG, JPEG or TIFF is wanted"),
        (png(0, 7), "no picture that can be read"),
        (png(40_000, 40_000), "40,000 by 40,000 pixels: a picture may have 64,000,000"),
        (JPEG, "30,000 by 40,000 pixels"),
        (tiff("<", 30_000, 20_000), "30,000 by 20,000 pixels"),
        (tiff(">", 30_000, 20_000), "30,000 by 20,000 pixels"),
    ],
    ids=["empty", "cut off", "GIF", "no pixels", "PNG", "JPEG", "TIFF", "TIFF of a Macintosh"],
)
def test_what_is_no_picture_or_too_large_a_one_is_refused(content: bytes, complaint: str) -> None:
    with pytest.raises(TapeError, match=complaint):
        photograph.read(content)
