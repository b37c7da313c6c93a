"""DEC's BIN format: runs of words after their origin, and a checksum.

    200 ...      leader
    3n0          field n of the words that follow (none: field 0)
    1aa 0aa      origin, six bits a frame, channel 7 marks its first half
    0dd 0dd      words, for ascending addresses
    377 .. 377   whatever is between two rubouts (a typed message) is not read
    0cc 0cc      checksum: the sum of the frames of all origins and words, as whole frames, modulo 2**12
    200 ...      trailer

One tape may hold several such sections; after each the loader halts, and CONT reads the next, into the field
of the last word unless it names another. Leader and trailer are 64 frames, as PAL III of 1967 (DEC-08-ASB1)
punched them.

A tape is read as the loader reads it, from the frame on which an operator would set it: past blank tape and
past a title, with whose frames the loader would make words. It may have no leader; letters with channel 8 in
the leader are passed over, as the loader passes over them; leader after an origin too. Where the trailer is
missing, blank or a file's last newline, the checksum says whether the tape is whole. What follows the last
trailer and is no section is a label. `Reading.notes` names all this.

Not emulated: what the loader makes of frames that are not BIN; such a tape is damaged. Whether a field
exists is for the machine to judge: addresses here have 15 bits, the field first.

Sources: Small Computer Handbook (DEC), "Binary Loader"; the loader's documented tape format, DEC-08-LBAA-D.
"""

from collections.abc import Iterable, Mapping
from functools import cache
from typing import NamedTuple

from tapes.errors import TapeError
from tapes.frames import (
    BLANK,
    LEADER,
    LEAST_LEADER,
    PADDING,
    RUBOUT,
    check_word,
    find_start,
    label_after,
    label_before,
    leader,
    missing_leader,
    no_trailer,
    skip,
    starts,
)

FIELD, ORIGIN, WORD = "field", "origin", "word"

_A_SECTION = 8  # items: fewer before a wrong frame are a label

_NO_ORIGIN = "a word before any origin"


class Item(NamedTuple):
    """One field setting, origin or word of a tape and the frame at which it begins."""

    kind: str
    value: int
    frame: int


class Section(NamedTuple):
    """The items between a leader and a trailer, in order."""

    items: tuple[Item, ...]
    computed: int
    punched: int
    frame: int
    """The frame at which the checksum begins."""


class Reading(NamedTuple):
    """A tape as far as it can be read: whole sections, the items of an unended one, the damage or None, the
    labels' frames; `notes` on what is missing, and `start`, where an operator sets it.
    """

    sections: tuple[Section, ...]
    unended: tuple[Item, ...] = ()
    damage: TapeError | None = None
    labels: tuple[range, ...] = ()
    notes: tuple[str, ...] = ()
    start: int = 0


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


@cache
def word(value: int) -> bytes:
    """Return the two frames of a word."""
    return bytes((value >> 6 & 0o77, value & 0o77))


def tape(body: bytes, checksum: int) -> bytes:
    """Return a whole tape: leader, `body` as punched, its checksum, trailer."""
    return leader() + body + word(checksum) + leader()


def encode(words: Mapping[int, int]) -> bytes:
    """Punch {address: word} in one section, in order. Raises TapeError for one beyond 77777, or 7777."""
    body = bytearray()
    following, current = -1, 0
    for address in sorted(words):
        if not 0 <= address <= 0o77777:
            raise TapeError(f"address {address:o}: a BIN tape can name only 00000 to 77777")
        if address >> 12 != current:
            current = address >> 12
            body += field(current)
            following = -1
        if address != following:
            body += origin(address)
        check_word(address, words[address])
        body += word(words[address])
        following = address + 1
    return tape(bytes(body), sum(frame for frame in body if frame < 0o300))


def decode(frames: bytes) -> Content:
    """Return the words, the later where an address comes twice. Raises TapeError, naming the frame."""
    reading = read(frames)
    damage = find_damage(reading)
    if damage:
        raise damage
    return content(reading)


def find_damage(reading: Reading) -> TapeError | None:
    """Return the first thing that is wrong with a tape, a wrong checksum included; None for a good one."""
    for section in reading.sections:
        begin = first(section.items)
        if begin.kind == WORD:
            return TapeError(_NO_ORIGIN, begin.frame)
        if section.computed != section.punched:
            return TapeError(
                f"checksum: computed {section.computed:04o}, punched {section.punched:04o}", section.frame
            )
    return reading.damage


def content(reading: Reading) -> Content:
    """The words of a damaged tape; the last of an unended section may be a checksum and is left out."""
    found = Content({}, {})
    bank = 0
    for items in (*(section.items for section in reading.sections), reading.unended[:-1]):
        bank = _load(items, bank, found)
    return found


def read(frames: bytes) -> Reading:
    """Return the tape by sections, checksums not checked. Raises TapeError where no BIN tape begins."""
    return read_whole(frames) or _read_from(frames, find_start(frames))


def read_whole(frames: bytes) -> Reading | None:
    """Return the tape read from the first of its `starts` that gives a whole section, or None."""
    for start in starts(frames):
        if skip(frames, start, LEADER) == len(frames):
            continue
        reading = _read_from(frames, start)
        if reading.sections and _is_whole(reading.sections[0], frames[start] == LEADER):
            return reading
    return None


def _is_whole(section: Section, led: bool) -> bool:
    """Tell whether a tape's first section is certainly valid."""
    begins = first(section.items).kind if section.items or not led else ORIGIN
    return section.computed == section.punched and begins == ORIGIN


def _read_from(frames: bytes, start: int) -> Reading:
    at = skip(frames, start, LEADER)
    if at == len(frames):
        raise TapeError("nothing but leader", at)
    labels = [*label_before(frames, start)]
    notes = missing_leader(frames, start)
    sections: list[Section] = []
    padding = len(frames.rstrip(PADDING))
    while at < (padding if sections else len(frames)):
        items, end, damage = _items(frames, at, labels)
        if not sections and labels:
            start = max(start, labels[-1].stop)  # past a title, which no loader is sure to pass over
        closing = _checksum_at(frames, items) if damage else 0
        if closing and (not sections or first(items).kind == ORIGIN):
            sections.append(_close(items[: closing + 1]))
            notes = (*notes, no_trailer(len(frames) - items[closing].frame - 2, "checksum"))
            break
        if sections and _is_label(frames, at, items, end if damage else -1):
            labels = [*(label for label in labels if label.start < at), range(at, len(frames))]
            break
        if damage is not None:
            return Reading(tuple(sections), tuple(items), damage, tuple(labels), notes, start)
        sections.append(_close(items))
        at = skip(frames, end, LEADER, BLANK)
    return Reading(tuple(sections), (), None, tuple(labels), notes, start)


def _checksum_at(frames: bytes, items: list[Item]) -> int:
    """Return the index of the checksum in a section without trailer: the sum of what comes before, with only
    padding and one frame after it; 0 if there is none.
    """
    computed = 0
    for number, (kind, value, frame) in enumerate(items):
        summed = kind == WORD and number > 0 and computed & 0o7777 == value
        if summed and not frames[frame + 2 : -1].strip(PADDING):
            return number
        computed += _frames_of(kind, value)
    return 0


def first(items: Iterable[Item]) -> Item:
    """Return the first origin or word, an item of no kind if there is none."""
    return next((item for item in items if item.kind != FIELD), Item("", 0, 0))


def find_apart(frames: bytes, labels: tuple[range, ...]) -> int | None:
    """Return the frame of a second tape's leader before or behind the label at the end, or None."""
    label = label_after(frames, labels)
    if label is None:
        return None
    at = len(frames[: label.start].rstrip(bytes([LEADER])))
    while (start := frames.find(LEAST_LEADER, at)) != -1:
        good, at = good_section(frames, start)
        if good:
            return start
    return None


def good_section(frames: bytes, start: int) -> tuple[bool, int]:
    """Return whether a section with a good checksum begins at the leader of frame `start`, and its end."""
    items, end, damage = _items(frames, skip(frames, start, LEADER), [])
    if damage is not None or items[0].kind == WORD:
        return False, end
    section = _close(items)
    return section.computed == section.punched, end


def _is_label(frames: bytes, at: int, items: list[Item], wrong: int) -> bool:
    """Tell whether the frames after a trailer are a label, which is soon `wrong` when read as `items`; a
    section begins with an origin or field after leader, and goes on for longer.
    """
    if frames[at - 1] != LEADER or first(items).kind != ORIGIN:
        return True
    return 0 <= wrong < len(frames) and len(items) < _A_SECTION


def _load(items: Iterable[Item], bank: int, content: Content) -> int:
    """Put the words of a section into `content`, from field `bank` on; return the field of the last."""
    address: int | None = None
    last = bank
    for kind, value, frame in items:
        if kind == FIELD:
            bank = value << 12
            content.fields.setdefault(value, frame)
        elif kind == ORIGIN:
            address = value
        elif address is None:
            raise TapeError(_NO_ORIGIN, frame)
        else:
            content.words[bank | address] = value
            address = address + 1 & 0o7777
            last = bank
    return last


def _items(frames: bytes, at: int, labels: list[range]) -> tuple[list[Item], int, TapeError | None]:
    """The items from frame `at`, and the frame of the trailer or first fault; add letters to `labels`."""
    items: list[Item] = []
    begun = summed = False  # whether an origin or a word has come; whether the last one was a word
    while at < len(frames):
        frame = frames[at]
        if frame == LEADER:
            if summed:
                return items, at, None
            at += 1  # within the leader, or after an origin
        elif frame == RUBOUT:
            closing = frames.find(RUBOUT, at + 1)
            if closing == -1:
                message = "this rubout has no other to end it: the tape is cut short"
                return items, at, TapeError(message, at)
            at = closing + 1
        elif frame > LEADER and not begun:
            end = at
            while end < len(frames) and frames[end] > LEADER:
                end += 1
            if all(each & 0o307 == 0o300 for each in frames[at:end]):
                items += [Item(FIELD, frames[each] >> 3 & 7, each) for each in range(at, end)]
            else:
                items.clear()
                labels.append(range(at, end))
            at = end
        elif frame >> 6 == 3:
            items.append(Item(FIELD, frame >> 3 & 7, at))
            at += 1
        else:
            damage = _fault(frames, at)
            closes = _closes(frames, at, items)
            if damage and not closes:
                return items, damage.frame or 0, damage
            items.append(Item(WORD if closes or not frame >> 6 else ORIGIN, together(frames, at), at))
            begun, summed = True, items[-1].kind == WORD
            at += 2
    end = items[-1].frame + 2 if items else at
    if begun and not summed and end < at and not frames[end:].strip(bytes([LEADER])):
        return items, end, TapeError("the trailer where a checksum was expected", end)
    return items, at, TapeError("the tape is cut short: it has no trailer", at)


def _close(items: list[Item]) -> Section:
    """Return the section of `items`, the last word of which is its checksum."""
    last = len(items) - 1
    while items[last].kind != WORD:
        last -= 1
    _, punched, frame = items[last]
    summed = items[:last]
    return Section(tuple(summed), _sum(summed), punched, frame)


def _sum(items: Iterable[Item]) -> int:
    """Return the checksum of items."""
    return sum(_frames_of(kind, value) for kind, value, _ in items) & 0o7777


def _closes(frames: bytes, at: int, items: list[Item]) -> bool:
    """Whether two frames before a trailer are the checksum; DEC's loader takes them with channel 7 too."""
    closing = frames[at + 2 : at + 3] == bytes([LEADER]) and frames[at + 1] < LEADER
    return closing and together(frames, at) == _sum(items)


def together(frames: bytes, at: int) -> int:
    """Return the word that DEC's loader makes of two frames: it shifts the first, and adds the second."""
    return (frames[at] << 6) + frames[at + 1] & 0o7777


def _frames_of(kind: str, value: int) -> int:
    """Return the sum of an item's frames, for the checksum."""
    return 0 if kind == FIELD else (value >> 6) + (value & 0o77) + (0o100 if kind == ORIGIN else 0)


def _fault(frames: bytes, at: int) -> TapeError | None:
    """Return what is wrong where a word or an origin should begin, None if nothing is."""
    frame = frames[at]
    if frame >> 6 == 2:
        return TapeError(f"{frame:03o} is not a frame of a BIN tape", at)
    if at + 1 == len(frames):
        return TapeError("the tape is cut short inside a word", at + 1)
    if frames[at + 1] > 0o77:
        return TapeError(f"{frames[at + 1]:03o} where the second half of a word was expected", at + 1)
    return None
