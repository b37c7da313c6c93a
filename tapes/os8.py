"""Files of PS/8 and OS/8 on a DECtape.

    block 0       the bootstrap                        one OS/8 block: 256 words, two DECtape blocks,
    blocks 1-6    the directory, in linked segments    of which 128 words each are used
    then          the files, one after the other, and what is free

    segment       -entries, first block, next segment, a tentative file, -extra words, entries ...
    file          four words of name in SIXBIT, extra words (the first is the date), -length in blocks
    free          0, -length
    three bytes   in two words: 4 bits of the third, the high ones first, above 8 of the first and second

A text ends with ^Z; so does a BIN tape. Deleting, renaming and squeezing are OS/8's own work.

Held against DIR, PIP and TYPE of OS/8 V3D themselves, and PIP of PS/8, whose handler of the Teletype types
RUBOUT after a tab and NUL after a form feed beside.
"""

import re
from array import array
from collections.abc import Iterator, Sequence
from typing import NamedTuple

from tapes.dectape import BLOCKS, WORDS, Image
from tapes.errors import TapeError
from tapes.quantities import counted

_HALF, _BLOCK = 128, 256
_SEGMENTS = range(1, 7)
_HEAD = 5
_CTRL_Z = 0o32
_NAME = re.compile(r"([A-Z][A-Z0-9]{0,5})(?:\.([A-Z0-9]{0,2}))?")
_YEARS = (1970, 1978)
"""A date counts years from the one or the other."""


class Entry(NamedTuple):
    """A file, or a free place if it has no name: first block, length in blocks, date or 0."""

    name: str
    block: int
    length: int
    date: int = 0


class _Place(NamedTuple):
    entry: Entry
    segment: int
    word: int
    """The first word of the entry in its segment."""

    @property
    def is_open(self) -> bool:
        return bool(self.entry.name) and not self.entry.length


def directory(image: Image) -> list[Entry]:
    """Return the files and free places in the order of the tape. Raises TapeError for a damaged directory.

    As OS/8's own, it leaves out a file of no blocks: it was opened for output and not closed.
    """
    return [place.entry for place in _places(image) if not place.is_open]


def listing(image: Image) -> str:
    """Return the directory as text: name, length, first block, date."""
    places = _places(image)
    entries = [place.entry for place in places if not place.is_open]
    rows = [
        f"{each.name or '<empty>':9}  {each.length:3}  {each.block:04o}  {_date(each.date)}".rstrip()
        for each in entries
    ]
    free = sum(each.length for each in entries if not each.name)
    files = sum(bool(each.name) for each in entries)
    held = counted(sum(each.length for each in entries) - free, "blocks")
    rows.append(f"{counted(files, 'files')} in {held}, {free} free")
    is_open = [place.entry.name for place in places if place.is_open]
    rows += [f"{name} was opened for output and not closed: OS/8 does not list it" for name in is_open]
    return "\n".join(rows)


def words(image: Image, name: str) -> list[int]:
    """Return the words of a file, 256 a block. Raises TapeError if there is none of that name."""
    wanted = canonical(name)
    entry = next((each for each in directory(image) if each.name == wanted), None)
    if entry is None:
        names = [each.name for each in directory(image) if each.name]
        some = ", ".join(names[:8]) + f" and {len(names) - 8} more" * (len(names) > 8) or "no file"
        raise TapeError(f"no file {wanted}; the directory has {some}")
    return [word for block in range(entry.length) for word in _read(image, entry.block + block)]


def frames(packed: Sequence[int]) -> bytes:
    """Return the frames of a BIN tape, up to its ^Z, which no BIN tape has in it."""
    found = _bytes(packed)
    end = found.find(_CTRL_Z | 0o200)
    return found if end < 0 else found[:end]


def _bytes(packed: Sequence[int]) -> bytes:
    """Return the bytes that words hold, three in each two words."""
    found = bytearray()
    for first, second in zip(packed[::2], packed[1::2], strict=False):
        found += bytes((first & 0o377, second & 0o377, first >> 4 & 0o360 | second >> 8))
    return bytes(found)


def text(packed: Sequence[int]) -> str:
    """Return a file of text as PIP types it: 7-bit ASCII without NUL, lines ended by line feeds."""
    plain, _, _ = bytes(byte & 0o177 for byte in _bytes(packed)).partition(bytes((_CTRL_Z,)))
    return plain.replace(b"\0", b"").decode("ascii").replace("\r\n", "\n").replace("\r", "\n")


def from_text(lines: str) -> list[int]:
    """Return the words of a text: mark parity, CR LF after each line, ^Z. Raises TapeError if not ASCII."""
    for number, line in enumerate(lines.split("\n"), 1):
        if not line.isascii():
            other = next(char for char in line if not char.isascii())
            raise TapeError(f"line {number}: {other!r} is not ASCII")
    plain = "\r\n".join(re.split("\r\n|\r|\n", lines)).encode("ascii")
    return pack(bytes(byte | 0o200 for byte in plain))


def pack(frames: bytes) -> list[int]:
    """Return words that hold these bytes and a ^Z, three in each two words."""
    ended = frames + bytes((_CTRL_Z | 0o200,))
    ended += bytes(-len(ended) % 3)
    packed = []
    for first, second, third in zip(ended[::3], ended[1::3], ended[2::3], strict=True):
        packed += [first | (third & 0o360) << 4, second | (third & 0o17) << 8]
    return packed


def insert(image: Image, name: str, packed: Sequence[int], date: int = 0) -> Image:
    """Return the image with a new file in the first free place that is large enough and can be divided.
    Raises TapeError if none is.
    """
    called = canonical(name)
    length = max(1, -(-len(packed) // _BLOCK))
    places = _places(image)
    if any(place.entry.name == called and not place.is_open for place in places):
        raise TapeError(f"{called} is there already: delete it with OS/8's PIP, or give another name")
    free = [place for place in places if not place.entry.name]
    enough = [each for each in free if each.entry.length >= length]
    if not enough:
        most = max((each.entry.length for each in free), default=0)
        raise TapeError(
            f"{called} needs {counted(length, 'blocks')}; the largest free place has {most}: "
            "squeeze the tape with PIP /S"
        )
    changed = Image(array("H", image.words), image.width)
    place = next((each for each in enough if _enter(changed, each, places, called, length, date)), None)
    if place is None:
        full = ", ".join(f"{number}" for number in sorted({each.segment for each in enough}))
        raise TapeError(f"segment {full} of the directory is full: squeeze the tape with PIP /S")
    for block in range(length):
        _write(changed, place.entry.block + block, packed[_BLOCK * block : _BLOCK * (block + 1)])
    return changed


def _enter(image: Image, place: _Place, places: list[_Place], name: str, length: int, date: int) -> bool:
    """Enter a file at a free place; return whether its segment has room, or another segment begins."""
    segment = _read(image, place.segment)
    left = place.entry.length - length
    extra = [date, *[0] * (-segment[4] & 0o7777)][: -segment[4] & 0o7777]
    entries = [*_sixbit(name), *extra, -length & 0o7777, *([0, -left & 0o7777] if left else [])]
    before, behind = segment[: place.word], segment[place.word + 2 :]
    last = [each for each in places if each.segment == place.segment][-1]
    if last.word + _size(segment, last.word) - 2 + len(entries) <= _BLOCK:
        before[0] = segment[0] - bool(left) & 0o7777
        _write(image, place.segment, [*before, *entries, *behind][:_BLOCK])
    elif place == last and not segment[2] and place.segment + 1 in _SEGMENTS:
        before[0], before[2] = segment[0] + 1 & 0o7777, place.segment + 1
        head = [-1 - bool(left) & 0o7777, place.entry.block, 0, 0, segment[4]]
        _write(image, place.segment, [*before, *behind][:_BLOCK])
        _write(image, place.segment + 1, [*head, *entries])
    else:
        return False
    return True


def canonical(name: str) -> str:
    """Return a name as OS/8 has it, FILE.EX. Raises TapeError for one that it cannot have."""
    found = _NAME.fullmatch(name.upper())
    if found is None:
        raise TapeError(
            f"{name!r} is no OS/8 name: a letter and up to five letters or digits, a point, up to two more"
        )
    return f"{found[1]}.{found[2] or ''}".removesuffix(".")


def _places(image: Image) -> list[_Place]:
    found: list[_Place] = []
    segment, seen = 1, set[int]()
    while segment:
        if segment not in _SEGMENTS or segment in seen:
            raise TapeError(
                f"no OS/8 directory: the next segment is {segment:o}; 1 to 6 are allowed, each once"
            )
        seen.add(segment)
        found += _in_segment(_read(image, segment), segment)
        segment = _read(image, segment)[2]
    return found


def _in_segment(segment: list[int], number: int) -> Iterator[_Place]:
    """Yield the entries of a segment. Raises TapeError where it cannot be one."""
    count, block, extra = -segment[0] & 0o7777, segment[1], -segment[4] & 0o7777
    where = f"segment {number} of the directory"
    if count > (_BLOCK - _HEAD) // 2 or extra > _BLOCK or not 0 < block <= BLOCKS // 2:
        raise TapeError(f"no OS/8 directory: {where} has {count} entries from block {block:o} on")
    at = _HEAD
    for index in range(1, count + 1):
        size = _size(segment, at) if at < _BLOCK else 2
        if at + size > _BLOCK:
            raise TapeError(f"{where} is damaged: entry {index} of {count} lies beyond its 256 words")
        name = _name(segment[at : at + 4]) if size > 2 else ""
        length = -segment[at + size - 1] & 0o7777
        if block + length > BLOCKS // 2 or (name and not _NAME.fullmatch(name)):
            said = f"{name or 'a free place'} of {counted(length, 'blocks')} from block {block:o} on"
            raise TapeError(
                f"{where} is damaged: entry {index}, {said}; the tape ends at {BLOCKS // 2 - 1:o}"
            )
        yield _Place(Entry(name, block, length, segment[at + 4] if size > 2 and extra else 0), number, at)
        at, block = at + size, block + length


def _size(segment: Sequence[int], at: int) -> int:
    """Return how many words an entry has."""
    return 5 + (-segment[4] & 0o7777) if segment[at] else 2


def _read(image: Image, block: int) -> list[int]:
    """Return the 256 words of an OS/8 block."""
    return [
        word
        for half in (2 * block, 2 * block + 1)
        for word in image.words[WORDS * half : WORDS * half + _HALF]
    ]


def _write(image: Image, block: int, filled: Sequence[int]) -> None:
    padded = [*filled, *[0] * (_BLOCK - len(filled))]
    for half in range(2):
        start = WORDS * (2 * block + half)
        image.words[start : start + _HALF] = array("H", padded[_HALF * half : _HALF * (half + 1)])


def _name(sixbit: Sequence[int]) -> str:
    letters = "".join(
        chr(code + 0o100 if code < 0o40 else code) for word in sixbit for code in (word >> 6, word & 0o77)
    )
    return f"{letters[:6].rstrip('@')}.{letters[6:].rstrip('@')}".removesuffix(".")


def _sixbit(name: str) -> list[int]:
    base, _, extension = name.partition(".")
    codes = [ord(letter) & 0o77 for letter in f"{base:@<6}{extension:@<2}"]
    return [high << 6 | low for high, low in zip(codes[::2], codes[1::2], strict=True)]


def _date(date: int) -> str:
    """Return a date as day and month, and the two years that three bits may mean."""
    month, day, year = date >> 8, date >> 3 & 0o37, date & 7
    return f"{month}/{day}/{_YEARS[0] + year} or {_YEARS[1] + year}" if date else ""
