"""Frames spelled out as a dump: hexadecimal, octal or binary, as xxd, hexdump, od and programs write them.

00000000: 0000 0b80 4520 2001   ....E  .      xxd: what is beside the numbers is not read
0000000 200 200 102 000                       od: a longer first number in each line is its address
10001101 00000001      0x8d, 0x01             binary; hexadecimal with its mark
"""

import re
from typing import Final, NamedTuple

from tapes import spelled
from tapes.errors import TextError
from tapes.text import with_ends

_MARK = re.compile(r"(?:(?:0x|\\x|\$)(?=[0-9a-f])|0o(?=[0-7]{3}$)|0b(?=[01]{8}$))", re.IGNORECASE)
_ADDRESS = re.compile(r"\s*[0-9a-fA-F]+:\s*")
_NUMBER = re.compile(r"[^\s,;{}\[\]()\"']+")
_NOTATIONS: Final = {
    "binary": (re.compile(r"[01]{8}"), 2, 8),
    "octal": (re.compile(r"[0-3][0-7]{2}"), 8, 3),
    "hexadecimal": (re.compile(r"(?:[0-9a-f]{2})+", re.IGNORECASE), 16, 2),
}
"""Each with the form of its numbers, its base and the digits of a frame."""
_FEWEST = 8


class Dump(NamedTuple):
    """The frames that a text spells, and in which notation."""

    notation: str
    frames: bytes

    @property
    def note(self) -> str:
        """What there is to say of such a file."""
        return f"a dump in {self.notation}, read as {len(self.frames):,} frames"


def read(text: str) -> Dump:
    """Return the frames of a dump. Raises TextError with line and column for what is none."""
    numbers = _numbers(text)
    for notation, (form, base, digits) in _NOTATIONS.items():
        if numbers and all(form.fullmatch(number) for number, _ in numbers):
            joined = "".join(number for number, _ in numbers)
            pieces = (joined[at : at + digits] for at in range(0, len(joined), digits))
            return Dump(notation, bytes(int(piece, base) for piece in pieces))
    fits = _NOTATIONS["hexadecimal"][0]
    number, index = next((each for each in numbers if not fits.fullmatch(each[0])), ("", 0))
    raise TextError(f"{number!r} is no frame in octal, hexadecimal or binary", text, index)


def found(content: bytes) -> Dump | None:
    """Return the dump that a file is, None if it is anything else: other text, or few numbers."""
    if not content.isascii() or b"\0" in content:
        return None
    text = content.decode()
    try:
        dump = read(text)
    except TextError:
        return None
    many = len(_numbers(text)) >= _FEWEST or (len(dump.frames) >= 2 * _FEWEST and re.search("[a-fA-F]", text))
    return dump if many else None


def unspelled(content: bytes) -> tuple[bytes, str]:
    """Return the frames that a file spells as words or as a dump, and a note on it; "" for any other file."""
    words = spelled.found(content)
    if words is not None:
        return words.tape, words.note
    dump = found(content)
    return (dump.frames, dump.note) if dump else (content, "")


def _numbers(text: str) -> list[tuple[str, int]]:
    """Return the numbers of a text without marks and addresses, each with its place."""
    lines, at = [], 0
    for line in with_ends(text):
        numbers = _NUMBER.finditer(_data(line))
        lines.append([(_MARK.sub("", number[0], count=1), at + number.start()) for number in numbers])
        at += len(line)
    lines = [line for line in lines if line]
    if _addressed(lines):
        lines = [line[1:] for line in lines]
    return [number for line in lines for number in line]


def _data(line: str) -> str:
    """Return a line with blanks where its address before a colon is, without what is beside its numbers."""
    address = _ADDRESS.match(line)
    if not address:
        return re.split(r"[|/]|\s{2,}>", line)[0]
    return " " * address.end() + re.split(r"\s{2,}", line[address.end() :])[0].partition("/")[0]


def _addressed(lines: list[list[tuple[str, int]]]) -> bool:
    """Whether each line begins with an address: a number longer than all others, six digits or more."""
    firsts = [line[0][0] for line in lines]
    others = [number for line in lines for number, _ in line[1:]]
    longest = max(map(len, others), default=99)
    return all(re.fullmatch(r"[0-9a-fA-F]{6,}", first) and len(first) > longest for first in firsts)
