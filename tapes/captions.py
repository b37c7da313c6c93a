"""What each frame says, in a few letters beside its row: a character, an origin, a word with its address.

Every frame gets a caption, also on a damaged tape and in a code that was guessed wrong; a frame that makes no
sense in that code gets "?".
"""

import re
from collections.abc import Callable

from tapes import ascii, binary, eia, rim
from tapes.errors import TapeError
from tapes.frames import BLANK, LEADER, RUBOUT

_Captions = Callable[[bytes], list[str]]

CODES = ("ascii", "eia", "bin", "rim")

_BIN_ITEM = re.compile(
    rb"(?P<message>\xff[^\xff]*\xff)|(?:\A|\x80)\0+|(?P<pair>[\0-\x7f][\0-\x3f])|.", re.DOTALL
)
"""What stands between two rubouts; blank tape, which is no word; an origin or a word; any other frame."""
_RIM_ITEM = re.compile(rb"[\x40-\x7f][\0-\x3f]{3}|.", re.DOTALL)
"""An address with its word; any other frame."""


def captions(frames: bytes, code: str) -> list[str]:
    """Return one caption a frame, in `code`, one of CODES; in any other code they are empty."""
    by_code: dict[str, _Captions] = {
        "ascii": lambda frames: [ascii.name(frame) for frame in frames],
        "eia": lambda frames: [eia.name(frame) for frame in frames],
        "bin": lambda frames: _between_labels(frames, code, _binary),
        "rim": lambda frames: _between_labels(frames, code, _rim),
    }
    return by_code.get(code, _none)(frames)


def labels(frames: bytes, code: str) -> tuple[range, ...]:
    """Return the frames of the labels of a BIN or RIM tape, () for any other."""
    if code not in ("bin", "rim"):
        return ()
    try:
        return binary.read(frames).labels if code == "bin" else rim.read(frames).labels
    except TapeError:
        return ()


def _none(frames: bytes) -> list[str]:
    return [""] * len(frames)


def _binary(frames: bytes) -> list[str]:
    said: list[str] = []
    address: int | None = None
    for item in _BIN_ITEM.finditer(frames):
        piece = item[0]
        if item.lastgroup == "message":
            said += ["rubout", *(f"({ascii.name(frame)})" for frame in piece[1:-1]), "rubout"]
        elif item.lastgroup == "pair":
            value = (piece[0] & 0o77) << 6 | piece[1]
            if piece[0] >> 6:
                caption, address = f"origin {value:04o}", value
            elif address is None or frames.startswith(bytes([LEADER]), item.end()):
                caption, address = f"checksum {value:04o}", None
            else:
                caption, address = f"{address:04o}: {value:04o}", address + 1 & 0o7777
            said += [caption, '"']
        else:
            said += map(_single, piece)
    return said


def _rim(frames: bytes) -> list[str]:
    said: list[str] = []
    for piece in _RIM_ITEM.findall(frames):
        if len(piece) == 4:
            address, word = (piece[0] & 0o77) << 6 | piece[1], piece[2] << 6 | piece[3]
            said += [f"address {address:04o}", '"', f"{word:04o}", '"']
        else:
            said += map(_single, piece)
    return said


def _single(frame: int) -> str:
    if frame == LEADER:
        return "leader"
    if frame == RUBOUT:
        return "rubout"
    if frame == BLANK:
        return "blank"
    return f"field {frame >> 3 & 7}" if frame >> 6 == 3 else "?"


def _between_labels(frames: bytes, code: str, body: _Captions) -> list[str]:
    """Caption the labels as such, and what is between by `body`."""
    said: list[str] = []
    for label in (*labels(frames, code), range(len(frames), len(frames))):
        said += body(frames[len(said) : label.start]) + ["label"] * len(label)
    return said
