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
from tapes.quantities import counted

BLANK = 0o000
LEADER = 0o200  # leader and trailer of DEC's loader formats
RUBOUT = 0o377
CHANNEL_8 = 0o200
FRAMES_PER_INCH = 10

LEADER_LENGTH = 64  # what PAL III (DEC-08-ASB1) punches before and after a binary tape
LEAST_LEADER = bytes([LEADER]) * 8
"""Leader has at least so many frames of 200 side by side; letters, words and ends of block have fewer."""

LABEL_GAP = bytes([BLANK]) * 3
"""So many blank frames part a label from the leader; fewer are between the end of a tape and its trailer."""

PADDING = bytes([BLANK, 0o012, 0o015, 0o032, 0o212, 0o215, 0o232])
"""What a file may have after a tape's end: blank tape, a line end, ^Z."""

WRITING = bytes([*range(0o007, 0o016), *range(0o040, 0o200), *range(0o207, 0o216), *range(0o240, 0o400)])
"""BELL to CR and all that prints in ASCII, with and without channel 8."""

FILL = bytes([BLANK, LEADER, RUBOUT])
"""Frames that are no characters and no words."""

LONGEST_LABEL = 1_000
_END_OF_FILE = b"\x1a"
_MOST_LINES = 2
"""Lines of a title: more are a text."""
_SILENT = bytes([*range(0o007, 0o012), 0o013, 0o014, RUBOUT & 0o177])
_NO_LETTERS = bytes([BLANK, LEADER])
_RUBBED_OUT = bytes([BLANK, RUBOUT])
_CODES = bytes(range(0o200)) * 2  # of every frame, without its channel 8

PARITIES = {
    "mark": bytes(range(0o200, 0o400)) * 2,
    "even": bytes(code | CHANNEL_8 * (code.bit_count() % 2) for code in _CODES),
    "odd": bytes(code | CHANNEL_8 * (1 - code.bit_count() % 2) for code in _CODES),
    "none": _CODES,
}
"""For each name, a table: what each frame becomes when its channel 8 is punched so."""


class Strip(NamedTuple):
    """A tape in three pieces, which add up to the whole of it."""

    leader: bytes
    body: bytes
    trailer: bytes


def with_parity(frames: bytes, parity: str) -> bytes:
    """Return the same codes with channel 8 by `parity`, a key of PARITIES. Raises TapeError for any other."""
    if parity not in PARITIES:
        raise TapeError(f"no parity is called {parity!r}: {', '.join(PARITIES)}")
    return frames.translate(PARITIES[parity])


def leader(length: int = LEADER_LENGTH) -> bytes:
    """Return `length` frames of DEC's leader and trailer code, 0o200."""
    return bytes([LEADER]) * length


def strip(frames: bytes, code: int = LEADER) -> Strip:
    """Part the tape into leader, body and trailer: blank frames outermost, then those of the `code`."""
    start = skip(frames, skip(frames, 0, BLANK), code)
    end = max(start, len(frames[: paper_end(frames)].rstrip(bytes([code]))))
    return Strip(frames[:start], frames[start:end], frames[end:])


def skip(frames: bytes, at: int, *codes: int) -> int:
    """Return the first frame from `at` on that is not one of `codes`; the tape's length if there is none."""
    return len(frames) - len(frames[at:].lstrip(bytes(codes)))


def paper_end(frames: bytes) -> int:
    """Return where the blank tape at the end begins: after the last frame with a hole."""
    return len(frames.rstrip(bytes([BLANK])))


def text_end(frames: bytes) -> int:
    """Return where a text ends: before the ^Z with which OS/8 and CP/M end a file, or with the paper."""
    end = paper_end(frames)
    while end > 0 and frames[end - 1] & 0o177 == 0o032:
        end -= 1
    return end


def has_leader(frames: bytes) -> bool:
    """Tell whether a tape begins with a frame that may be lost: blank, or leader of DEC's loader formats."""
    return frames[:1] in (bytes([BLANK]), bytes([LEADER]))


def begins_as_words(frames: bytes, content: bytes) -> bool:
    """Whether a tape begins with leader, and its content with a frame that is an origin, address or field."""
    return frames[:1] == bytes([LEADER]) and bool(content) and content[0] >> 6 in (1, 3)


def leader_start(frames: bytes) -> int | None:
    """Return the first frame of the leader: after blank tape, letters or rubouts; None if there is none."""
    start = skip(frames, 0, BLANK)
    if frames[start : start + 1] == bytes([LEADER]):
        return start
    at = frames.find(LEAST_LEADER, start)
    if at == -1 or not frames[at:].strip(_NO_LETTERS):
        return None
    letters = frames[start:at]
    return at if letters.endswith(LABEL_GAP) or not letters.strip(_RUBBED_OUT) else None


def starts(frames: bytes) -> list[int]:
    """Return where an operator might set a loader tape, the likeliest first: its first hole, its leader."""
    first = skip(frames, 0, BLANK)
    found = [first]
    eye = leader_start(frames)
    if eye is not None and eye != first and _lines(frames[first:eye]) <= _MOST_LINES:
        found.append(eye)
    title = skip(frames, first, LEADER)
    after = frames.find(LEAST_LEADER, title)
    if after > title and after not in found and _is_title(frames[title:after]):
        found.append(after)
    return found


def _is_title(frames: bytes) -> bool:
    """Whether frames before a leader are a line or two of characters, or a file that ends with ^Z."""
    text = frames.strip(_NO_LETTERS)
    ended = text.endswith(_END_OF_FILE)
    return (ended or _lines(text) <= _MOST_LINES) and not text.strip(_END_OF_FILE).translate(None, WRITING)


def _lines(frames: bytes) -> int:
    """Return how many lines of a text the frames would be."""
    return frames.translate(PARITIES["none"]).strip(b"\r\n\0\x7f").count(b"\r\n") + 1


def label_before(frames: bytes, start: int) -> tuple[range, ...]:
    """Return the frames of the letters before a tape's start, blank tape and leader apart, or ()."""
    end = len(frames[:start].rstrip(_NO_LETTERS))
    return (range(skip(frames, 0, BLANK, LEADER), end),) if end else ()


def label_after(frames: bytes, labels: tuple[range, ...]) -> range | None:
    """Return the label at a tape's end, None if there is none."""
    return labels[-1] if labels and labels[-1].stop == len(frames) else None


def check_word(address: int, word: int) -> None:
    """Raise TapeError if `word` is none of 12 bits."""
    if not 0 <= word <= 0o7777:
        raise TapeError(f"{address:04o}: {word:o} (octal) is no word; 0000 to 7777 are")


def find_start(frames: bytes) -> int:
    """Where a damaged tape may begin: leader, or first hole if an origin. Raises TapeError if nowhere."""
    start = leader_start(frames)
    if start is not None:
        return start
    if not frames:
        raise TapeError("empty tape", 0)
    at = skip(frames, 0, BLANK)
    if at == len(frames):
        raise TapeError("nothing but blank tape", 0)
    if frames[at] >> 6 != 1:
        raise TapeError(f"{frames[at]:03o} where the leader (200) or an origin (1nn) was expected", at)
    return at


def missing_leader(frames: bytes, start: int) -> tuple[str, ...]:
    """Say that a loader tape which begins at frame `start` has no leader; () if it has."""
    if start == len(frames) or frames[start] >= LEADER:
        return ()
    return (f"{start:,} blank frames instead of leader, passed over" if start else "no leader",)


def no_trailer(rest: int, last: str) -> str:
    """Say that a loader tape has no trailer, and that `rest` frames after its `last` item are left out."""
    return "no trailer" + f"; {counted(rest, 'frames')} after the {last}, left out" * (rest > 0)


def channels(frame: int) -> tuple[int, ...]:
    """Return the numbers of the punched channels, 8 first."""
    return tuple(channel for channel in range(8, 0, -1) if frame >> channel - 1 & 1)


def draw_label(frames: bytes, columns: int = 72) -> list[str]:
    """Lines of characters as they are; letters for the eye as rows, a frame a column, channel 1 at the top,
    new rows after so many columns; none for what is longer than any label.
    """
    text = frames.strip(_NO_LETTERS + _END_OF_FILE).translate(PARITIES["none"])
    if b"\r\n" in text and not text.translate(None, WRITING):
        return [line for line in text.translate(None, _SILENT).decode("ascii").split("\r\n") if line]
    holes = frames.strip(bytes([BLANK]))
    if len(holes) > LONGEST_LABEL:
        return []
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
