"""Words of core spelled out as text, as courses and other tools have them: read by their form, and written.

    octal       0200: 7300 1250          an address and words, octal; also 0200 7300 and 0200/7300
    readmemh    @080 ec0 2a8             Verilog's $readmemh, hexadecimal
    ep          EP:080 / 080:EC0         an entry point, then an address and its word, hexadecimal
    deposits    d 200 7300 1250          deposits of a SIMH script; go, set and echo are passed over
    bits        111011000000             a line of twelve bits for each word, from 0000 on
    frames      102 / 000 / 073          the frames of a BIN tape, octal, one a line, often without a checksum

A file is one of these if each of its lines is; what follows `;`, `#` or `//` is a comment.
"""

from collections.abc import Mapping
from typing import Final, NamedTuple

from tapes import binary
from tapes.text import lines_of

FORMATS: Final = ("octal-words", "readmemh", "ep", "deposits", "bits", "octal-frames")
_TITLES: Final = (
    "octal addresses and words",
    "Verilog's $readmemh",
    "EP, entry point and hexadecimal words",
    "deposits of a SIMH script",
    "lines of twelve bits",
    "octal frames, one a line",
)
_OCTAL, _HEX, _BITS = "01234567", "0123456789abcdefABCDEF", "01"
_PASSED_OVER = ("g", "go", "run", "set", "echo", "reset", "quit", "exit", "load", "c", "cont")
_FEWEST = 8
"""Lines of bits or frames, or words without an address."""
_ROW = 8


class Spelled(NamedTuple):
    """The words of a text, in which format it is, and where the program starts, -1 if it does not say."""

    title: str
    words: dict[int, int]
    start: int = -1

    @property
    def tape(self) -> bytes:
        """The BIN tape that loads them."""
        return binary.encode(self.words)

    @property
    def note(self) -> str:
        """What there is to say of such a file."""
        return f"read as {self.title}" + (f"; it starts at {self.start:04o}" if self.start >= 0 else "")


def found(content: bytes) -> Spelled | None:
    """Return the words that a file spells, None for any other file."""
    if not content or not content.isascii() or b"\0" in content:
        return None
    lines = [line.split() for line in map(_plain, lines_of(content.decode("ascii")))]
    lines = [line for line in lines if line]
    for number, read in enumerate((_octal, _readmemh, _ep, _deposits, _bits, _frames)):
        words = read(lines) if lines else None
        if words is not None and words.words:
            return words._replace(title=_TITLES[number])
    return None


def spell(name: str, words: Mapping[int, int]) -> str:
    """Return words of 4K in a format of FORMATS."""
    rows = []
    if name == "bits":
        rows = [_as_bits(words.get(address, 0)) for address in range(max(words) + 1)]
    elif name == "octal-frames":
        frames = binary.encode(words).strip(b"\200")
        rows = [f"{frame:03o}" for frame in frames[:-2]]
    elif name == "ep":
        rows = [f"EP:{min(words):03x}", *(f"{address:03x}:{words[address]:03x}" for address in sorted(words))]
        rows = [row.upper() for row in rows]
    else:
        for row in _rows(words):
            first = row[0]
            if name == "readmemh":
                rows.append(f"@{first:03x} " + " ".join(f"{words[address]:03x}" for address in row))
            elif name == "deposits":
                rows += [f"deposit {address:o} {words[address]:04o}" for address in row]
            else:
                rows.append(f"{first:04o}: " + " ".join(f"{words[address]:04o}" for address in row))
    return "".join(row + "\n" for row in rows)


def _rows(words: Mapping[int, int]) -> list[list[int]]:
    rows: list[list[int]] = []
    for address in sorted(words):
        if not rows or rows[-1][-1] != address - 1 or len(rows[-1]) == _ROW:
            rows.append([])
        rows[-1].append(address)
    return rows


def _plain(line: str) -> str:
    """Return a line without its comment."""
    for mark in (";", "#", "//"):
        line = line.partition(mark)[0]
    return line.strip()


def _is(text: str, digits: str, least: int, most: int) -> bool:
    return least <= len(text) <= most and not text.strip(digits)


def _hexadecimal(text: str) -> int:
    value = 0
    for digit in text.lower():
        value = value * 16 + "0123456789abcdef".index(digit)
    return value


def _binary(text: str) -> int:
    value = 0
    for digit in text:
        value = value * 2 + (digit == "1")
    return value


def _as_bits(word: int) -> str:
    return "".join("1" if word >> bit & 1 else "0" for bit in range(11, -1, -1))


def _stored(words: dict[int, int], first: int, values: list[int]) -> bool:
    """Put values into words from an address on; return whether they fit into 4K."""
    for offset, value in enumerate(values):
        words[first + offset] = value
    return first + len(values) <= 0o10000 and all(value <= 0o7777 for value in values)


def _octal(lines: list[list[str]]) -> Spelled | None:
    words: dict[int, int] = {}
    for line in lines:
        first, *rest = " ".join(line).replace(":", " ").replace("/", " ").split() or [""]
        if not rest or not _is(first, _OCTAL, 4, 5) or not all(_is(each, _OCTAL, 4, 4) for each in rest):
            return None
        if not _stored(words, int(first, 8), [int(each, 8) for each in rest]):
            return None
    return Spelled("", words)


def _readmemh(lines: list[list[str]]) -> Spelled | None:
    words: dict[int, int] = {}
    address = 0
    tokens = [token for line in lines for token in line]
    if not any(token.startswith("@") for token in tokens):
        letters = any(token.strip("0123456789") for token in tokens)
        if len(tokens) < _FEWEST or not letters or any(len(token) != 3 for token in tokens):
            return None
    for token in tokens:
        number = token.removeprefix("@")
        if not _is(number, _HEX, 1, 4) or _hexadecimal(number) > 0o7777:
            return None
        if token.startswith("@"):
            address = _hexadecimal(number)
        else:
            words[address] = _hexadecimal(number)
            address = address + 1 & 0o7777
    return Spelled("", words)


def _ep(lines: list[list[str]]) -> Spelled | None:
    words: dict[int, int] = {}
    start = -1
    for line in lines:
        first, colon, word = "".join(line).partition(":")
        if not colon or not _is(word, _HEX, 1, 3):
            return None
        if first.upper() == "EP":
            start = _hexadecimal(word)
        elif not _is(first, _HEX, 1, 3):
            return None
        else:
            words[_hexadecimal(first)] = _hexadecimal(word)
    return Spelled("", words, start) if start >= 0 else None


def _deposits(lines: list[list[str]]) -> Spelled | None:
    words: dict[int, int] = {}
    for line in lines:
        command = line[0].lower()
        if command in _PASSED_OVER:
            continue
        if not "deposit".startswith(command) or len(line) < 3:
            return None
        if not all(_is(each, _OCTAL, 1, 5) for each in line[2:]):
            return None
        values = [int(each, 8) for each in line[2:]]
        if _is(line[1], _OCTAL, 1, 5):
            if not _stored(words, int(line[1], 8), values):
                return None
        elif line[1].lower() not in ("pc", "sr", "ac", "l", "link"):
            return None
    return Spelled("", words)


def _bits(lines: list[list[str]]) -> Spelled | None:
    numbers = [line[0] for line in lines if len(line) == 1]
    if not _FEWEST <= len(lines) == len(numbers) <= 0o10000 or not all(
        _is(each, _BITS, 12, 12) for each in numbers
    ):
        return None
    return Spelled("", {address: _binary(number) for address, number in enumerate(numbers)})


def _frames(lines: list[list[str]]) -> Spelled | None:
    numbers = [line[0] for line in lines if len(line) == 1]
    if not _FEWEST <= len(lines) == len(numbers) or not all(_is(each, _OCTAL, 3, 3) for each in numbers):
        return None
    frames = bytes(int(number, 8) for number in numbers if int(number, 8) < 0o400)
    whole = binary.read_whole(frames)
    if len(frames) != len(numbers) or whole is not None or frames[0] >> 6 != 1 or len(frames) % 2:
        return None  # a whole tape is a dump of frames
    words: dict[int, int] = {}
    address = 0
    for at in range(0, len(frames), 2):
        first, second = frames[at], frames[at + 1]
        if first >= 0o200 or second >= 0o100:
            return None
        if first >= 0o100:
            address = (first & 0o77) << 6 | second
        else:
            words[address] = first << 6 | second
            address = address + 1 & 0o7777
    return Spelled("", words)
