"""DEC's BIN format: runs of words after their origin, and a checksum.

    200 ...      leader
    3n0          field n of the words that follow (none: field 0)
    1aa 0aa      origin, six bits a frame, channel 7 marks its first half
    0dd 0dd      words, for ascending addresses
    377 .. 377   whatever stands between two rubouts (a typed message) is not read
    0cc 0cc      checksum: the sum of the frames of all origins and words, as whole frames, modulo 2**12
    200 ...      trailer

One tape may hold several such sections; after the first the loader halts, and CONT reads the next.
Leader and trailer are 64 frames, as PAL III of 1967 (DEC-08-ASB1) punched them.

Not emulated: what the loader makes of frames that are not BIN; such a tape is an error. Whether a field
exists is for the machine to judge: addresses here have 15 bits, the field first.

Sources: Small Computer Handbook (DEC), "Binary Loader"; the loader's documented tape format, DEC-08-LBAA-D.
"""

from collections.abc import Mapping
from typing import NamedTuple

from tapes.errors import TapeError
from tapes.frames import BLANK, LEADER, RUBOUT, find_leader, leader

FIELD, ORIGIN, WORD = "field", "origin", "word"


class Item(NamedTuple):
    """One field setting, origin or word of a tape and the frame at which it begins."""

    kind: str
    value: int
    frame: int


class Section(NamedTuple):
    """What stands between a leader and a trailer, in the tape's order."""

    items: tuple[Item, ...]
    computed: int
    punched: int
    frame: int
    """The frame at which the checksum begins."""


class Reading(NamedTuple):
    """A whole tape: its sections, and how many frames after the last trailer belong to none."""

    sections: tuple[Section, ...]
    unread: int


class Content(NamedTuple):
    """What a tape puts into core: {address: word}, field n from n0000 on; and {field: its first frame}."""

    words: dict[int, int]
    fields: dict[int, int]


def field(number: int) -> bytes:
    """Return the one frame of a field setting, 0 to 7."""
    return bytes([0o300 | (number & 7) << 3])


def origin(address: int) -> bytes:
    """Return the two frames of an origin."""
    return bytes((0o100 | address >> 6 & 0o77, address & 0o77))


def word(value: int) -> bytes:
    """Return the two frames of a word."""
    return bytes((value >> 6 & 0o77, value & 0o77))


def tape(body: bytes, checksum: int) -> bytes:
    """Return a whole tape: leader, `body` as punched, its checksum, trailer."""
    return leader() + body + word(checksum) + leader()


def encode(words: Mapping[int, int]) -> bytes:
    """Punch `words`, {address: word}, in one section: ascending, an origin before each run, fields other than
    0 named.

    Raises TapeError for an address outside 0-77777.
    """
    body = bytearray()
    summed = 0
    following = -1
    current = 0
    for address in sorted(words):
        if not 0 <= address <= 0o77777:
            raise TapeError(f"address {address:o}: a BIN tape can name only 00000 to 77777")
        if address >> 12 != current:
            current = address >> 12
            body += field(current)
            following = -1
        if address != following:
            start = origin(address)
            summed += sum(start)
            body += start
        frames = word(words[address])
        summed += sum(frames)
        body += frames
        following = address + 1
    return tape(bytes(body), summed)


def decode(frames: bytes) -> Content:
    """Return the words of every section, the later where an address comes twice, and the fields.

    Raises TapeError naming the frame: an empty tape, no leader, a frame out of place, a word before any
    origin, a tape cut short, a checksum that is not the sum.
    """
    content = Content({}, {})
    for section in read(frames).sections:
        if section.computed != section.punched:
            raise TapeError(
                f"checksum: computed {section.computed:04o}, punched {section.punched:04o}", section.frame
            )
        _load(section, content)
    return content


def read(frames: bytes) -> Reading:
    """Return the tape section by section, its checksums unjudged. Raises TapeError as `decode` does."""
    at = _skip(frames, find_leader(frames), LEADER)
    if at == len(frames):
        raise TapeError("nothing but leader", at)
    sections: list[Section] = []
    while at < len(frames) and (not sections or frames[at] >> 6 in (1, 3)):
        section, at = _section(frames, at)
        sections.append(section)
        at = _skip(frames, at, LEADER, BLANK)
    return Reading(tuple(sections), len(frames) - at)


def _load(section: Section, content: Content) -> None:
    bank = 0
    address: int | None = None
    for kind, value, frame in section.items:
        if kind == FIELD:
            bank = value << 12
            content.fields.setdefault(value, frame)
        elif kind == ORIGIN:
            address = value
        elif address is None:
            raise TapeError("a word before any origin", frame)
        else:
            content.words[bank | address] = value
            address = address + 1 & 0o7777


def _skip(frames: bytes, at: int, *codes: int) -> int:
    """Return the first frame from `at` on that is none of `codes`, or the tape's length."""
    while at < len(frames) and frames[at] in codes:
        at += 1
    return at


def _section(frames: bytes, at: int) -> tuple[Section, int]:
    """Return the section whose first frame is `at`, and where its trailer begins."""
    items: list[Item] = []
    summed = 0
    while at < len(frames):
        frame = frames[at]
        if frame == LEADER:
            return _close(items, summed, at), at
        if frame == RUBOUT:
            at = _after_rubouts(frames, at)
        elif frame >> 6 == 3:
            items.append(Item(FIELD, frame >> 3 & 7, at))
            at += 1
        else:
            _check_word(frames, at)
            low = frames[at + 1]
            items.append(Item(ORIGIN if frame >> 6 else WORD, (frame & 0o77) << 6 | low, at))
            summed += frame + low
            at += 2
    raise TapeError("the tape is cut short: it has no trailer", at)


def _close(items: list[Item], summed: int, trailer: int) -> Section:
    if not items or items[-1].kind != WORD:
        raise TapeError("the trailer where a checksum was expected", trailer)
    _, punched, frame = items.pop()
    computed = summed - (punched >> 6) - (punched & 0o77) & 0o7777
    return Section(tuple(items), computed, punched, frame)


def _after_rubouts(frames: bytes, at: int) -> int:
    closing = frames.find(RUBOUT, at + 1)
    if closing < 0:
        raise TapeError("this rubout has no other to end it: the tape is cut short", at)
    return closing + 1


def _check_word(frames: bytes, at: int) -> None:
    frame = frames[at]
    if frame >> 6 == 2:
        raise TapeError(f"{frame:03o} is no frame of a BIN tape", at)
    if at + 1 == len(frames):
        raise TapeError("the tape is cut short inside a word", at + 1)
    if frames[at + 1] > 0o77:
        raise TapeError(f"{frames[at + 1]:03o} where the second half of a word was expected", at + 1)
