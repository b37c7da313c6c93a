"""What a tape is, told by its frames alone.

    bin, rim   leader, then frames of the loader formats' classes
    eia        frames with an odd number of holes, of RS-244, with ends of block
    ascii      characters and line ends, with channel 8 or without
    blank      no holes (or no frames) at all;   unknown   none of these

A damaged tape is still what it was: it is told by what most of its frames say, so that the reader that is
then chosen can name the frame which is wrong.

A RIM tape's groups are address, word; a BIN tape of single words at scattered addresses is origin, word too,
and differs in what stands before the trailer: its checksum. So a tape that reads as both is BIN when its
checksum is good and it holds a word by that reading; a RIM tape is that once in 4096.
"""

from tapes import binary, eia, rim
from tapes.errors import TapeError
from tapes.frames import BLANK, LEADER, RUBOUT

BIN, RIM, EIA, ASCII, BLANK_TAPE, UNKNOWN = "bin", "rim", "eia", "ascii", "blank", "unknown"

_TEXT = bytes([*range(0o007, 0o016), *range(0o040, 0o200)])  # BELL to CR, and all that prints
_WRITING = bytes(frame for frame in range(256) if frame & 0o177 in _TEXT)
_EIA_CODES = bytes([*eia.CHARACTERS, eia.DELETE])
_NO_WORD = bytes([BLANK, LEADER, RUBOUT])
_SHORTEST_LEADER = 8  # no EIA tape begins with eight empty blocks


def classify(frames: bytes) -> str:
    """Return "bin", "rim", "eia", "ascii", "blank" or "unknown"."""
    body = frames.lstrip(b"\0")
    if not body:
        return BLANK_TAPE
    return _whole_loader_tape(body) or _whole_eia_tape(body) or _likeliest(body)


def _whole_loader_tape(body: bytes) -> str | None:
    if body[0] != LEADER:
        return None
    holds_words = _reads(body)
    if holds_words:
        return BIN
    try:
        rim.decode(body)
    except TapeError:
        return None if holds_words is None else BIN
    return RIM


def _reads(body: bytes) -> bool | None:
    """Say whether the tape, read as BIN, holds words; None if it is no good BIN tape."""
    try:
        return bool(binary.decode(body).words)
    except TapeError:
        return None


def _whole_eia_tape(body: bytes) -> str | None:
    data = body.lstrip(bytes([eia.EOB]))
    loader = len(body) - len(data) >= _SHORTEST_LEADER
    odd_one_out = body.translate(None, _EIA_CODES + bytes([BLANK]))
    return EIA if eia.EOB in data and not odd_one_out and not loader else None


def _likeliest(body: bytes) -> str:
    frames = body.translate(None, _NO_WORD)
    if not frames:
        return BIN if body[0] == LEADER else ASCII
    if _share(frames, _WRITING) >= 0.9:
        return ASCII
    if body.startswith(bytes([LEADER]) * _SHORTEST_LEADER) and frames[0] >> 6 in (1, 3):
        addresses = sum(frame >> 6 == 1 for frame in body)
        words = sum(frame >> 6 == 0 for frame in body.rstrip(b"\0"))
        return RIM if 4 * addresses > words else BIN
    return EIA if _share(frames, _EIA_CODES) >= 0.9 else UNKNOWN


def _share(frames: bytes, of: bytes) -> float:
    return 1 - len(frames.translate(None, of)) / len(frames)
