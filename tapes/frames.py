"""A strip of holes: one byte is one frame, channel 8 is 0o200 and channel 1 is 0o001.

    channel   8 7 6 5 4 . 3 2 1        the dot is the sprocket hole, which every frame has
    0o301     o o       .     o        the letter A with channel 8 always punched ("mark")

Readers and punches never look at what a frame means; codes, parity, leader and rubouts exist only in this
package.

Not emulated: torn, stretched or unpunched paper; five-channel tape.

Sources: ASR-33 code chart, Small Computer Handbook (DEC); tape geometry and channel numbers, ECMA-10 and EIA
RS-227.
"""

from typing import NamedTuple

from tapes.errors import TapeError

BLANK = 0o000
LEADER = 0o200  # leader and trailer of DEC's loader formats
RUBOUT = 0o377
CHANNEL_8 = 0o200
FRAMES_PER_INCH = 10

LEADER_LENGTH = 64  # what PAL III (DEC-08-ASB1) punches before and after a binary tape
LEAST_LEADER = bytes([LEADER]) * 8
"""More frames of 200 than letters, words or ends of block have side by side."""

LABEL_GAP = bytes([BLANK]) * 3
"""Between a label and the leader is more blank tape than between what was torn off and its trailer."""

_NO_LETTERS = bytes([BLANK, LEADER])
_RUBBED_OUT = bytes([BLANK, RUBOUT])
_CODES = bytes(range(0o200)) * 2  # of every frame, without its channel 8

PARITIES = {
    "mark": bytes(range(0o200, 0o400)) * 2,
    "even": bytes(code | CHANNEL_8 * (code.bit_count() % 2) for code in _CODES),
    "odd": bytes(code | CHANNEL_8 * (1 - code.bit_count() % 2) for code in _CODES),
    "none": _CODES,
}
"""By each name, the frame that every frame becomes when its channel 8 is punched so."""


class Strip(NamedTuple):
    """A tape in three pieces, which add up to the whole of it."""

    leader: bytes
    body: bytes
    trailer: bytes


def with_parity(frames: bytes, parity: str) -> bytes:
    """Return the same seven-channel codes with channel 8 punched as `parity`, a key of PARITIES, says.

    Raises TapeError for any other `parity`.
    """
    if parity not in PARITIES:
        raise TapeError(f"no parity is called {parity!r}: {', '.join(PARITIES)}")
    return frames.translate(PARITIES[parity])


def parity(frames: bytes) -> str:
    """Return the key of PARITIES that every character of the tape obeys, or "mixed".

    Blank frames, leader and rubouts say nothing of the parity. With no character left it is "none".
    """
    characters = bytes(set(frames) - {BLANK, LEADER, RUBOUT})
    for name in ("none", "mark", "even", "odd"):
        if characters.translate(PARITIES[name]) == characters:
            return name
    return "mixed"


def leader(length: int = LEADER_LENGTH) -> bytes:
    """Return `length` frames of DEC's leader and trailer code, 0o200."""
    return bytes([LEADER]) * length


def blank(length: int) -> bytes:
    """Return `length` frames with no hole but the sprocket's."""
    return bytes(length)


def strip(frames: bytes, code: int = LEADER) -> Strip:
    """Part the tape into leader, body and trailer.

    Outermost are blank frames, then those of the leader `code`, which on an EIA tape is BLANK.
    """
    start = skip(frames, skip(frames, 0, BLANK), code)
    end = max(start, len(frames[: paper_end(frames)].rstrip(bytes([code]))))
    return Strip(frames[:start], frames[start:end], frames[end:])


def skip(frames: bytes, at: int, *codes: int) -> int:
    """Return the first frame from `at` on that is not one of `codes`; the tape's length if there is none."""
    return len(frames) - len(frames[at:].lstrip(bytes(codes)))


def paper_end(frames: bytes) -> int:
    """Return where the blank tape at the end begins: after the last frame with a hole."""
    return len(frames.rstrip(bytes([BLANK])))


def has_leader(frames: bytes) -> bool:
    """Tell whether a tape begins with a frame that may be lost: blank, or leader of DEC's loader formats."""
    return frames[:1] in (bytes([BLANK]), bytes([LEADER]))


def begins_as_words(frames: bytes, content: bytes) -> bool:
    """Whether a tape begins with leader, and its content with a frame that is an origin, address or field."""
    return frames[:1] == bytes([LEADER]) and bool(content) and content[0] >> 6 in (1, 3)


def leader_start(frames: bytes) -> int | None:
    """Return the first frame of a loader tape's leader, where an operator sets the tape: 200 after any blank
    tape, after letters for the eye and blank tape, or after rubouts. None for a tape that begins otherwise.
    """
    start = skip(frames, 0, BLANK)
    if frames[start : start + 1] == bytes([LEADER]):
        return start
    at = frames.find(LEAST_LEADER, start)
    if at == -1 or not frames[at:].strip(_NO_LETTERS):
        return None
    letters = frames[start:at]
    return at if letters.endswith(LABEL_GAP) or not letters.strip(_RUBBED_OUT) else None


def label_before(frames: bytes, leader: int) -> tuple[range, ...]:
    """Return the frames of the letters before a tape's leader, blank tape apart; () if there are none."""
    end = paper_end(frames[:leader])
    return (range(skip(frames, 0, BLANK), end),) if end else ()


def label_after(frames: bytes, labels: tuple[range, ...]) -> range | None:
    """Return that of a tape's labels which is at its end, None if none is."""
    return labels[-1] if labels and labels[-1].stop == len(frames) else None


def check_word(address: int, word: int) -> None:
    """Raise TapeError if `word` is none of 12 bits."""
    if not 0 <= word <= 0o7777:
        raise TapeError(f"{address:04o}: {word:o} (octal) is no word; 0000 to 7777 are")


def find_leader(frames: bytes) -> int:
    """Return `leader_start`. Raises TapeError: an empty tape, nothing but blank tape, another frame than
    200.
    """
    start = leader_start(frames)
    if start is not None:
        return start
    if not frames:
        raise TapeError("empty tape", 0)
    at = skip(frames, 0, BLANK)
    if at == len(frames):
        raise TapeError("nothing but blank tape", 0)
    raise TapeError(f"{frames[at]:03o} where the leader (200) was expected", at)


def channels(frame: int) -> tuple[int, ...]:
    """Return the numbers of the punched channels, 8 first."""
    return tuple(channel for channel in range(8, 0, -1) if frame >> channel - 1 & 1)


def draw_label(frames: bytes, columns: int = 72) -> list[str]:
    """Return letters punched for the eye as it reads them: a frame a column, channel 1 at the top, from the
    first hole to the last; a line of rows for every so many columns.
    """
    holes = frames.strip(bytes([BLANK]))
    rows = []
    for start in range(0, len(holes), columns):
        piece = holes[start : start + columns]
        lines = ("".join("o" if frame >> channel & 1 else " " for frame in piece) for channel in range(8))
        rows += [line.rstrip() for line in lines]
    return rows


def draw(frame: int, hole: str = "o", paper: str = " ", sprocket: str = ".") -> str:
    """Return the frame as nine columns: channels 8 to 4, the sprocket hole, channels 3 to 1."""
    row = "".join(hole if frame >> channel & 1 else paper for channel in range(7, -1, -1))
    return row[:5] + sprocket + row[5:]
