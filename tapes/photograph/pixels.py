"""A picture's file becomes light: shades of grey, of a size that is known before anything is decoded.

Sources of the headers: PNG (W3C, IHDR), JPEG (ITU T.81, B.2.2), TIFF 6.0.
"""

from typing import Any, Literal

import cv2
import numpy as np

from tapes.errors import TapeError

Array = np.ndarray[Any, Any]

LARGEST = 64_000_000
"""Pixels of a picture."""
LARGEST_FILE = 64 << 20
"""Bytes of its file; a camera's has some 8 MB, a scanner's 35."""

_PNG, _JPEG = b"\x89PNG\r\n\x1a\n", b"\xff\xd8"
_FRAMES = {*range(0xC0, 0xD0)} - {0xC4, 0xC8, 0xCC}
"""Markers of a JPEG's frame; the three between them begin tables."""
_NONE = "no picture that can be read: PNG, JPEG or TIFF is wanted"


def lights(picture: bytes) -> list[Array]:
    """Return the picture, PNG, JPEG or TIFF, in each colour, 8 bits a pixel: that first in which its parts
    differ most; of colours that are the same, one.

    Raises TapeError where it is none, or has more than LARGEST pixels by its header.
    """
    colours = sorted(
        cv2.split(_decoded(picture)), key=lambda colour: -float(cv2.meanStdDev(colour)[1].item())
    )
    return [
        colour
        for at, colour in enumerate(colours)
        if not any(np.array_equal(colour, one) for one in colours[:at])
    ]


def shown(picture: bytes) -> bytes:
    """Return the picture as a JPEG file that a page can show, pixel for pixel the same size."""
    return bytes(cv2.imencode(".jpg", _decoded(picture), [cv2.IMWRITE_JPEG_QUALITY, 85])[1])


def between(picture: Array, x: Array, y: Array, how: int = cv2.INTER_LINEAR) -> Array:
    """The light at places between pixels, `x` and `y`, by OpenCV's method `how`; beyond, the edge's."""
    places = x.astype(np.float32), y.astype(np.float32)
    return np.asarray(cv2.remap(picture, *places, how, borderMode=cv2.BORDER_REPLICATE))


def vertex(before: Array, top: Array, after: Array) -> Array:
    """Return the vertex of a parabola through three values, at most .5 from the middle."""
    curvature = np.minimum(before - 2 * top + after, -1e-9)
    return np.asarray(0.5 * (before - after) / curvature).clip(-0.5, 0.5)


def _decoded(picture: bytes) -> Array:
    width, height = _size(picture)
    if width * height > LARGEST:
        raise TapeError(f"{width:,} by {height:,} pixels: a picture may have {LARGEST:,}")
    try:
        decoded = cv2.imdecode(np.frombuffer(picture, np.uint8), cv2.IMREAD_COLOR)
    except cv2.error:
        decoded = None
    if decoded is None:
        raise TapeError(_NONE)
    return np.asarray(decoded)


def _size(picture: bytes) -> tuple[int, int]:
    """Return width and height by the file's header."""
    if picture.startswith(_PNG):
        return int.from_bytes(picture[16:20], "big"), int.from_bytes(picture[20:24], "big")
    if picture.startswith(_JPEG):
        return _size_of_jpeg(picture)
    if picture[:4] in (b"II*\0", b"MM\0*"):
        return _size_of_tiff(picture, "little" if picture[:2] == b"II" else "big")
    raise TapeError(_NONE)


def _size_of_jpeg(picture: bytes) -> tuple[int, int]:
    at = 2
    while at + 9 <= len(picture) and picture[at] == 0xFF:
        marker = picture[at + 1]
        if marker in _FRAMES:
            height, width = (int.from_bytes(picture[at + place : at + place + 2], "big") for place in (5, 7))
            return width, height
        at += 1 if marker == 0xFF else 2 + int.from_bytes(picture[at + 2 : at + 4], "big")
    raise TapeError(_NONE)


def _size_of_tiff(picture: bytes, order: Literal["little", "big"]) -> tuple[int, int]:
    def number(at: int, length: int) -> int:
        return int.from_bytes(picture[at : at + length], order)

    directory = number(4, 4)
    entries = range(directory + 2, directory + 2 + 12 * number(directory, 2), 12)
    lengths = {number(at, 2): number(at + 8, 2 if number(at + 2, 2) == 3 else 4) for at in entries}
    return lengths.get(256, 0), lengths.get(257, 0)
