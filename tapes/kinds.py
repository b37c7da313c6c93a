"""What a tape is, by its frames alone.

    bin, rim   leader, then frames of the loader formats' classes; letters for the eye may stand before it
    eia        frames with an odd number of holes, of RS-244, with ends of block
    ascii      characters and line ends, with channel 8 or without
    blank      no holes (or no frames) at all;   unknown   anything else

Most of the frames decide the kind, so that a damaged tape keeps its own, and the reader of that kind can name
the frame that is wrong.

A RIM tape's groups are address, word; a BIN tape of single words at scattered addresses is origin, word too,
and differs in what stands before the trailer: its checksum. So a tape that reads as both is BIN when its
checksum is good and it holds a word by that reading; one RIM tape in 4096 is taken for BIN by this.
"""

from itertools import pairwise

from tapes import ascii, binary, eia, rim
from tapes.errors import TapeError
from tapes.frames import (
    BLANK,
    LEADER,
    LEAST_LEADER,
    PARITIES,
    RUBOUT,
    label_before,
    leader_start,
    skip,
    strip,
)

BIN, RIM, EIA, ASCII, BLANK_TAPE, UNKNOWN = "bin", "rim", "eia", "ascii", "blank", "unknown"

_TEXT = bytes([*range(0o007, 0o016), *range(0o040, 0o200)])  # BELL to CR, and all that prints
_WRITING = bytes(frame for frame in range(256) if frame & 0o177 in _TEXT)
_EIA_CODES = bytes([*eia.CHARACTERS, eia.DELETE])
_NO_WORD = bytes([BLANK, LEADER, RUBOUT])
_FIGURES = bytes(code | channel_8 for code in b"0123456789 \r\n\0\x7f" for channel_8 in (0, 0o200))


def classify(frames: bytes) -> str:
    """Return "bin", "rim", "eia", "ascii", "blank" or "unknown"."""
    body = frames[skip(frames, 0, BLANK) :]
    if not body:
        return BLANK_TAPE
    return _whole_loader_tape(body) or _whole_eia_tape(body) or _after_label(body) or _likeliest(body)


def start(frames: bytes) -> int:
    """Return the frame on which an operator sets the tape: its leader of 200, past blank tape, and past a
    label of a loader tape; any other tape's first.
    """
    leader = leader_start(frames)
    if leader is None or (label_before(frames, leader) and classify(frames) not in (BIN, RIM)):
        return 0
    return leader


def doubt(frames: bytes) -> str:
    """Say why a program for ASCII may not do with this tape what its owner expects; "" if it may."""
    kind = classify(frames)
    if kind == EIA:
        return "is an EIA tape: a program for ASCII finds no character on it"
    if kind not in (BIN, RIM) and not ends_blocks(frames):
        return (
            "has line feeds but no carriage returns: no block will end. "
            "A proper tape is made from text with: pdp8 tape punch FILE -o FILE.asc"
        )
    return ""


def ends_blocks(frames: bytes) -> bool:
    """Tell whether an ASCII tape with line feeds has carriage returns, which end a block."""
    codes = frames.translate(PARITIES["none"])
    return b"\n" not in codes or b"\r" in codes


def only_figures(frames: bytes) -> bool:
    """Tell whether an ASCII tape holds nothing but figures and line ends: data, and no program's source."""
    return not frames.translate(None, _FIGURES)


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
    has_blocks = eia.EOB in body.lstrip(bytes([eia.EOB])) and not _long_leader(body)
    odd_one_out = body.translate(None, _EIA_CODES + bytes([BLANK]))
    return EIA if has_blocks and not odd_one_out else None


def _likeliest(body: bytes) -> str:
    _, content, trailer = strip(body)
    if not content:
        return BIN
    loader = body[0] == LEADER and content[0] >> 6 in (1, 3)
    if loader and _long_leader(body) and not _has_lines(content):
        return _loader_tape(content, trailer)
    written = content.translate(None, _NO_WORD)
    if _nearly_all(content if loader else written, _WRITING):
        return ASCII
    if _nearly_all(written, _EIA_CODES):
        return EIA
    return _loader_tape(content, trailer) if loader else UNKNOWN


def _after_label(body: bytes) -> str | None:
    """Return the kind of a loader tape after letters for the eye; None where there is none.

    Lines that end with CR LF are no such letters, and damaged frames after them are no text either.
    """
    leader = leader_start(body)
    if not leader or b"\r\n" in body[:leader].translate(PARITIES["none"]):
        return None
    tape = body[leader:]
    if whole := _whole_loader_tape(tape):
        return whole
    likeliest = _likeliest(tape)
    if likeliest in (BIN, RIM) and not _nearly_all(tape.strip(_NO_WORD), _WRITING):
        return likeliest
    return None


def _long_leader(body: bytes) -> bool:
    """Tell whether a tape begins with leader; no EIA tape begins with so many empty blocks."""
    return body.startswith(LEAST_LEADER)


def _loader_tape(content: bytes, trailer: bytes) -> str:
    return RIM if _steps_by_words(content, ended=LEADER in trailer) else BIN


def _has_lines(content: bytes) -> bool:
    codes = content.translate(PARITIES["none"])
    return _nearly_all(content, _WRITING) and (ascii.CR in codes or ascii.LF in codes)


def _steps_by_words(content: bytes, ended: bool) -> bool:
    """Say whether addresses come every four frames, as on a RIM tape; before a checksum come six."""
    addresses = [at for at, frame in enumerate(content) if frame >> 6 == 1]
    steps = [after - at for at, after in pairwise([*addresses, *[len(content)] * ended])]
    return bool(steps) and steps.count(4) >= 0.75 * len(steps) and steps[-1] != 6


def _nearly_all(frames: bytes, of: bytes) -> bool:
    return not frames or 1 - len(frames.translate(None, of)) / len(frames) >= 0.9
