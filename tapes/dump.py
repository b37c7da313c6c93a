"""Frames spelled out as a dump: hexadecimal, octal or binary, as xxd, hexdump, od and programs write them.

00000000: 0000 0b80 4520 2001   ....E  .      xxd: what is beside the numbers is not read
0000000 200 200 102 000                       od: a longer first number in each line is its address
0000000 100200 000102                         od, hexdump: words of two frames or more, the last one first
*                                             as the line above, up to the next address
10001101 00000001      0x8d, 0x01             binary; hexadecimal with its mark
0200                   [128, 66, 0]           octal as C has it; a list, decimal
80 42 0                                       any base, if the tape begins with leader in it
|oo     .  o|          | o o       .     o |  a drawing of holes, as BSD's ppt and `pdp8 tape show` make it;
|o  .     oo|                                 or from channel 1 on

What follows `#` is a comment.
"""

import re
from itertools import pairwise
from typing import NamedTuple

from tapes import spelled
from tapes.frames import LEADER
from tapes.spelled import is_number
from tapes.text import in_ascii, lines_of

_FEWEST = 8
_FARTHEST = 1 << 24
"""Frames from the first address to another, which * may fill."""
_GAP = "; its addresses do not follow one another: is a line missing?"
_STARRED = "; * stands for lines that it lacks: od -v writes them"
_DRAWN = 9  # columns: eight channels and the sprocket hole
_LIST = re.compile(r"[\[{]([\s,0-9a-fA-FoOxX]{15,})[\]}]")
"""Of a program in C, Python or JSON: eight numbers or more."""
_BASES = {"binary": 2, "octal": 8, "decimal": 10}
_BESIDE = ("|", "/", "#", "  >")
_BETWEEN = (",", ";", "[", "]", "(", ")", '"', "'", "\\x", "$")


class Dump(NamedTuple):
    """The frames that a text spells, in which notation, how it shows a gap, if it does, and in which base its
    addresses were taken, 0 if that is sure.
    """

    notation: str
    frames: bytes
    gap: str = ""
    base: int = 0

    @property
    def note(self) -> str:
        """What there is to say of such a file."""
        taken = f"; its addresses are taken in base {self.base}" if self.base else ""
        return f"a dump in {self.notation}, read as {len(self.frames):,} frames{self.gap}{taken}"


class _Row(NamedTuple):
    """A line: its address, "" where it has none, and its numbers."""

    address: str
    numbers: list[str]


def found(content: bytes) -> Dump | None:
    """Return the dump that a file is, None if it is anything else: other text, or few numbers."""
    text = in_ascii(content)
    drawn = _drawn(lines_of(text))
    if len(drawn) >= _FEWEST:
        return Dump("holes", drawn)
    lists = _LIST.findall(text)
    rows = [_row(line) for line in lines_of(lists[0] if lists else text)]
    rows = [row for row in rows if row.address or row.numbers]
    colons = any(row.address.strip("*") for row in rows)
    rows = rows if colons else _addressed(rows)
    addresses = "".join([row.address for row in rows])
    words = not colons and addresses.strip("*") != ""
    numbers = [number for row in rows for number in row.numbers]
    listed = bool(lists) and "x" not in lists[0].lower()
    notation = _by_leader(numbers, 0 if addresses else len(rows)) or _notation(numbers, words, listed)
    octal = not addresses and all(is_number(number, 8, 4, 4) for number in numbers)  # words without a place
    if not notation or (octal and notation == "hexadecimal"):
        return None
    pieces = [b"".join([_frames(number, notation) for number in row.numbers]) for row in rows]
    digits = max(len(row.address) for row in rows)  # 6 or 8: of xxd, hexdump -C, od -Ax
    hexadecimal = digits in (6, 8) or notation == "hexadecimal words"
    fit = [base for base in ((16, 8, 10) if hexadecimal else (8, 10, 16)) if _placed(rows, pieces, base)]
    placed = _placed(rows, pieces, fit[0]) if fit else b""
    unsure = any(_placed(rows, pieces, base) != placed for base in fit)
    frames = placed or b"".join(pieces)
    sure = any(number.strip("0123456789") for number in numbers) or (placed != b"" and len(rows) > 1)
    many = len(numbers) >= _FEWEST or (len(frames) >= 2 * _FEWEST and sure)
    gap = "" if placed or not addresses else _GAP if addresses.strip("*") else _STARRED
    return Dump(notation.partition(" ")[0], frames, gap, fit[0] if unsure else 0) if many else None


def unspelled(content: bytes) -> tuple[bytes, str]:
    """Return the frames that a file spells as words or as a dump, and a note on it; "" for any other file."""
    words = spelled.found(content)
    if words is not None:
        return words.tape, words.note
    dump = found(content)
    return (content, "") if dump is None else (dump.frames, dump.note)


def _drawn(lines: list[str]) -> bytes:
    """Return the frames that lines between two bars draw; b"" if one after the first is no frame."""
    frames: list[int] = []
    for line in lines:
        if "|" in line:
            holes = _holes(line.partition("|")[2].partition("|")[0])
            if len(holes) == 8:
                frames.append(sum([0o200 >> at for at, hole in enumerate(holes) if hole != " "]))
            elif frames:
                return b""
    return bytes(frames)


def _holes(row: str) -> str:
    """Return the eight channels of a drawn row, 8 first, "" for anything else: by the place of the sprocket
    hole either 8 or 1 is on the left.
    """
    if len(row) == 2 * _DRAWN + 1:
        row = "".join([row[at] for at in range(1, 2 * _DRAWN, 2)])
    left, _, right = row.partition(".")
    holes = left + right if len(left) == 5 else "".join([*reversed(left + right)])
    return "" if len(left) not in (3, 5) or len(row) != _DRAWN or holes.strip(" oO") else holes


def _row(line: str) -> _Row:
    address, colon, data = line.partition(":")
    address = address.strip()
    if line.strip() == "*" or (colon and is_number(address, 16, 1, 16)):
        data = data.strip().partition("  ")[0]
    else:
        address, data = "", line
    for mark in _BESIDE:
        data = data.partition(mark)[0]
    for mark in _BETWEEN:
        data = data.replace(mark, " ")
    return _Row(address, [_unmarked(number) for number in data.split()])


def _unmarked(number: str) -> str:
    """Return a number without 0x, 0o or 0b, with as many digits as a frame has."""
    mark, rest = number[:2].lower(), number[2:]
    digits = {"0x": 2, "0o": 3}.get(mark, len(rest) if mark == "0b" and len(rest) == 8 else 0)
    return rest.rjust(digits, "0") if digits else number


def _addressed(rows: list[_Row]) -> list[_Row]:
    """Return the lines by their addresses, if each begins with one: six digits or more, none as long, or each
    a little greater than the one before.
    """
    with_numbers = [row.numbers for row in rows if row.numbers]
    others = [len(number) for numbers in with_numbers for number in numbers[1:]]
    if not others or not all(is_number(numbers[0], 16, 6, 16) for numbers in with_numbers):
        return rows
    firsts = [int(numbers[0], base=16) for numbers in with_numbers]
    steps = [after - at for at, after in pairwise(firsts)]
    rise = len(steps) > 0 and all(0 < step < _FARTHEST >> 8 for step in steps)
    if rise or min(len(numbers[0]) for numbers in with_numbers) > max(others):
        return [_Row(row.numbers[0], row.numbers[1:]) if row.numbers else row for row in rows]
    return rows


def _by_leader(numbers: list[str], lines: int) -> str:
    """Return the notation in which numbers of any length begin with leader, or blank tape and leader, or are
    octal as C has it, one a line; or "".
    """
    first = next((at for at, number in enumerate(numbers) if number.strip("0")), 0)
    for notation, base, most in ("octal", 8, 4), ("decimal", 10, 3), ("hexadecimal", 16, 2):
        if _are_frames(numbers, base, most):
            octal = lines == len(numbers) and {len(number) for number in numbers} == {4}
            if octal or {int(number, base) for number in numbers[first : first + 2]} == {LEADER}:
                return notation
    return ""


def _are_frames(numbers: list[str], base: int, most: int) -> bool:
    """Whether each number, of at most so many digits, is a frame."""
    return all(is_number(number, base, 1, most) and int(number, base) < 1 << 8 for number in numbers)


def _notation(numbers: list[str], words: bool, listed: bool) -> str:
    """Return the notation that all numbers have, or ""; with `words` a number may be of two frames, and
    `listed` they are in brackets, without 0x.
    """
    if not numbers:
        return ""
    if all(is_number(number, 2, 8, 8) for number in numbers):
        return "binary"
    zeros = any(number[1:] and number[0] == "0" for number in numbers)
    if listed and not zeros and _are_frames(numbers, 10, 3):
        return "decimal"
    if all(is_number(number, 8, 3, 3) and number[0] < "4" for number in numbers):
        return "octal"
    if all(is_number(number, 8, 6, 6) and number[0] < "2" for number in numbers):
        return "octal words"
    if not all(is_number(number, 16, 2, 1 << 20) and len(number) % 2 == 0 for number in numbers):
        return ""
    longest, shortest = max(map(len, numbers)), min(map(len, numbers))
    return "hexadecimal words" if words and longest == shortest and longest in (4, 8, 16) else "hexadecimal"


def _frames(number: str, notation: str) -> bytes:
    if notation in _BASES:
        return bytes([int(number, _BASES[notation])])
    if notation == "octal words":
        word = int(number, base=8)
        return bytes([word & 0o377, word >> 8])
    places = range(len(number) - 2, -1, -2) if notation == "hexadecimal words" else range(0, len(number), 2)
    return bytes([int(number[at : at + 2], base=16) for at in places])


def _placed(rows: list[_Row], pieces: list[bytes], base: int) -> bytes:
    """Return the frames at their addresses from the first on, b"" if those do not fit; * repeats the frames
    before it.
    """
    placed = b""
    last = b""
    repeats = False
    first = -1
    word = 0
    for row, piece in zip(rows, pieces, strict=True):
        if row.address == "*":
            repeats = True
            continue
        if not is_number(row.address, base, 1, 16):
            return b""
        at = int(row.address, base=base)
        first = at if first < 0 else first
        at -= first
        if at > _FARTHEST:
            return b""
        if repeats and last and len(placed) < at:
            placed += last * -((len(placed) - at) // len(last))
        if not row.numbers:
            return placed[:at] if 0 <= len(placed) - at < word else b""
        if at != len(placed):
            return b""
        word = max(2, len(piece) // len(row.numbers))  # of which but one frame may be there
        repeats = False
        last = piece
        placed += piece
    return placed
