"""Words of core spelled out as text, as courses and other tools have them: read by their form, and written.

    octal       0200: 7300 1250          an address and words, octal; also 0200 7300, 0200/7300, 0200=7300,
                                         0200:73001250, and 0200: alone at the end, where the program starts
    readmemh    @080 ec0 2a8             Verilog's $readmemh, hexadecimal
    ep          EP:080 / 080:EC0         an entry point, then an address and its word, hexadecimal
    deposits    d 200 7300 1250          deposits of a SIMH script; go, set and echo are passed over
    bits        111011000000             a line of twelve bits for each word, from 0000 or from @080 on
    frames      102 / 000 / 073          the frames of a BIN tape, octal, one a line, often without a checksum
    intel-hex   :02010000C00E2F          Intel's records, two bytes a word, the low one first, as naken_asm's
    mif         080 : ec0 2a8;           Altera's memory initialization file, in the radix that its head names
    a listing   0200  7300  CLA CLL      an assembler's, with line numbers before it or without; only read

A file is one of these if each of its lines is, and a listing if no address is left out; a comment is what
follows `;`, `#`, `//`, or `/` first or after words, and what is between `/*` and `*/`. There may be a heading
above, such as `Address Contents` and a rule.
In Intel's records the high byte may come first too, if the words say so.
"""

from collections.abc import Callable, Mapping
from typing import Final, NamedTuple

from tapes import binary
from tapes.text import in_ascii, lines_of

_DIGITS: Final = "0123456789abcdef"
_PASSED_OVER = (
    "go", "run", "set", "echo", "reset", "quit", "exit", "load", "cont", "attach", "detach", "boot",
    "examine", "show", "step", "break",
)  # fmt: skip
_REGISTERS = ("pc", "sr", "ac", "l", "link", "lac", "if", "df")
_FEWEST = 8
"""Lines of bits or frames, or words without an address."""
_ROW = 8
_RADIXES: Final = {"bin": 2, "oct": 8, "dec": 10, "uns": 10, "hex": 16}
LISTING: Final = "a listing"
_MOVES = ("PAGE", "FIELD")
_LINKED = "@'"
"""What a listing has behind a word whose address is that of a link."""
_LAST: Final = 0o77777
"""The last address of 32K."""


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


class Format(NamedTuple):
    """A format: `read` puts the words of tokens into a dict and returns where the program starts, -1 if the
    text does not say, or raises ValueError for another format; `write` returns lines.
    """

    title: str
    read: Callable[[list[list[str]], dict[int, int]], int]
    write: Callable[[Mapping[int, int]], list[str]]

    def spell(self, words: Mapping[int, int]) -> str:
        """Return words in this format."""
        return "".join(row + "\n" for row in self.write(words))


def found(content: bytes) -> Spelled | None:
    """Return the words that a file spells, None for any other file."""
    first, *rest = in_ascii(content).split("/*")
    text = first + "".join([piece.partition("*/")[2] for piece in rest])
    lines = [line for line in map(_tokens, lines_of(_by_statements(text))) if line]
    lines = lines[next((at for at, line in enumerate(lines) if not _is_heading(line)), 0) :]
    for known in FORMATS.values() if lines else ():
        words: dict[int, int] = {}
        try:
            start = known.read(lines, words)
        except ValueError:
            continue
        if words:
            return Spelled(known.title, words, start)
    words = _listed([_tokens(line) for line in lines_of(in_ascii(content))])  # in PAL /* begins one comment
    return Spelled(LISTING, words) if words else None


def _listed(lines: list[list[str]]) -> dict[int, int]:
    """Return the words of an assembler's listing, {} for any other text, or where words seem to be missing:
    addresses follow one another, but for an origin between them, and for a page's literals.
    """
    numbered = any(_with_line_number(line) for line in lines)
    words: dict[int, int] = {}
    before = following = 0
    moved = True
    for line in lines:
        place = line[1:] if _with_line_number(line) else line
        word = place[1].rstrip(_LINKED) if len(place) > 1 else ""
        if word and is_number(place[0], 8, 5 if numbered else 4, 5) and is_number(word, 8, 4, 4):
            address = int(place[0], 8)
            if address != before + 1 and not moved and len(place) > 2:
                return {}
            words[address] = int(word, 8)
            following += 1 if address == before + 1 else 0
            before, moved = address, False
        code = " ".join(line).partition("/")[0].split()
        moved = moved or any(token.startswith("*") or token in _MOVES for token in code)
    return words if 0 < len(words) <= 2 * following else {}


def _with_line_number(line: list[str]) -> bool:
    """Whether a line begins as palbart's listing does: its number, and an address of five digits."""
    return len(line) > 2 and line[0].isdecimal() and is_number(line[1], 8, 5, 5)


def _by_statements(text: str) -> str:
    """Return a memory initialization file with a statement on each line, other text as it is."""
    known = text.lower().split()
    if "content" not in known or "begin" not in known:
        return text
    code = "".join([piece for at, piece in enumerate(text.split("%")) if at % 2 == 0])
    code = " ".join([_code(line, ("--", "//", "#")) for line in lines_of(code)])
    return code.lower().replace("begin", "begin;").replace(";", "\n")


def _tokens(line: str) -> list[str]:
    """Return what is on a line without its comment."""
    return _code(line, (";", "#", "//")).strip().removeprefix("sim>").split()


def _code(line: str, marks: tuple[str, ...]) -> str:
    """Return a line without a comment, which begins with one of the marks, or the whole line with / or ;."""
    if line.strip().startswith(("/", ";")):
        return ""
    for mark in marks:
        line = line.partition(mark)[0]
    return line


def _is_heading(line: list[str]) -> bool:
    """Whether a line names the column of addresses, without a digit, or is a rule."""
    text = "".join(line).lower()
    return not text.strip("-=+|_") or (text.startswith(("addr", "loc")) and text.isalpha())


def is_number(text: str, base: int, least: int, most: int) -> bool:
    """Whether a text is a number of so many digits."""
    return least <= len(text) <= most and not text.lower().strip(_DIGITS[:base])


def _number(text: str, base: int, least: int, most: int) -> int:
    """Return a number of so many digits. Raises ValueError for anything else."""
    if not is_number(text, base, least, most):
        raise ValueError
    return int(text, base)


def _store(words: dict[int, int], first: int, values: list[int]) -> None:
    """Put values into words from an address on. Raises ValueError if they do not fit."""
    if first + len(values) > _LAST + 1 or any(value > 0o7777 for value in values):
        raise ValueError
    for offset, value in enumerate(values):
        words[first + offset] = value


def _read_octal(lines: list[list[str]], words: dict[int, int]) -> int:
    start = -1
    if len(lines[-1]) == 1 and lines[-1][0].endswith(":"):
        start = _number(lines[-1][0].removesuffix(":"), 8, 1, 5)
        lines = lines[:-1]
    for line in lines:
        text = " ".join([token.removeprefix("0o") for token in line])
        marked = ":" in text or "=" in text
        for mark in (":", "=", ",", "(", ")"):
            text = text.replace(mark, " ")
        place, _, rest = text.partition("/")
        if len(place.split()) == 1:  # 0200/7300; else a comment follows
            place += f" {rest.partition('/')[0]}"
        numbers = place.split()
        if len(numbers) < 2:
            raise ValueError
        least = 1 if marked and len(numbers[0]) > 2 else 4
        first = _number(numbers[0], 8, 1 if marked else 3, 5)
        values = numbers[1:]
        if marked and len(values) == 1 and len(values[0]) % 4 == 0:
            values = [values[0][at : at + 4] for at in range(0, len(values[0]), 4)]
        _store(words, first, [_number(each, 8, least, 4) for each in values])
    return start


def _read_readmemh(lines: list[list[str]], words: dict[int, int]) -> int:
    address = 0
    tokens = [token.replace("_", "") for line in lines for token in line]
    if not any(token.startswith("@") for token in tokens):
        letters = any(token.strip("0123456789") for token in tokens)
        if len(tokens) < _FEWEST or not letters or any(len(token) != 3 for token in tokens):
            raise ValueError
    for token in tokens:
        number = _number(token.removeprefix("@"), 16, 1, 4)
        if token.startswith("@"):
            address = number
        else:
            _store(words, address, [number])
            address += 1
    return -1


def _read_ep(lines: list[list[str]], words: dict[int, int]) -> int:
    start = -1
    for line in lines:
        first, _, word = "".join(line).lower().replace("0x", "").partition(":")
        value = _number(word, 16, 1, 4 if first == "ep" else 3)
        if first == "ep":
            start = value
        else:
            _store(words, _number(first, 16, 1, 4), [value])
    if start < 0:
        raise ValueError
    return start


def _read_deposits(lines: list[list[str]], words: dict[int, int]) -> int:
    for whole in lines:
        line = [token for token in whole if not token.startswith("-")]  # switches
        command = line[0].lower() if line else ""
        deposits = "deposit".startswith(command)
        if not deposits and any(passed.startswith(command) for passed in _PASSED_OVER):
            continue
        if not deposits or len(line) < 3:
            raise ValueError
        values = [_number(each, 8, 1, 5) for each in line[2:]]
        if line[1].lower() not in _REGISTERS:
            first, to, last = line[1].partition("-")
            address = _number(first, 8, 1, 5)
            many = _number(last, 8, 1, 5) - address + 1 if to else 1
            _store(words, address, values * many if many > 1 else values)
    return -1


def _read_bits(lines: list[list[str]], words: dict[int, int]) -> int:
    address = 0
    for line in lines:
        bits = "".join([token.removeprefix("0b") for token in line]).replace("_", "")
        if bits.startswith("@"):
            address = _number(bits[1:], 16, 1, 4)
            continue
        if len(bits) == 16:  # as a word of today's has it
            bits = bits.removeprefix("0000")
        _store(words, address, [_number(bits[at : at + 12], 2, 12, 12) for at in range(0, len(bits), 12)])
        address += len(bits) // 12
    if len(words) < _FEWEST and len(words) == len(lines):
        raise ValueError
    return -1


def _read_frames(lines: list[list[str]], words: dict[int, int]) -> int:
    numbers = [_number(each.removeprefix("0o"), 8, 3, 4) for line in lines for each in line]
    body = bytes(numbers)
    strange = [frame for frame in body if frame >= 0o200 and frame & 0o307 != 0o300]
    if len(body) < _FEWEST or body[0] < 0o100 or strange or binary.read_whole(body) is not None:
        raise ValueError  # a whole tape is a dump of frames
    words.update(binary.decode(binary.tape(body, sum([frame for frame in body if frame < 0o300]))).words)
    return -1


def _read_intel_hex(lines: list[list[str]], words: dict[int, int]) -> int:
    content: dict[int, int] = {}
    for line in lines:
        (record,) = [token.lower() for token in line]
        digits = record.removeprefix(":")
        if digits == record or not digits:
            raise ValueError
        values = [_number(digits[at : at + 2], 16, 2, 2) for at in range(0, len(digits), 2)]
        if sum(values) & 0o377 or len(values) != values[0] + 5:
            raise ValueError
        if values[3] == 0:
            for offset, value in enumerate(values[4:-1]):
                content[(values[1] << 8 | values[2]) + offset] = value
        elif values[3] in (2, 4) and any(values[4:-1]):
            raise ValueError  # beyond 64K bytes
    places = sorted({place >> 1 for place in content})
    low = [content.get(2 * place, 0) | content.get(2 * place + 1, 0) << 8 for place in places]
    high = [content.get(2 * place, 0) << 8 | content.get(2 * place + 1, 0) for place in places]
    for place, word in zip(places, low if all(word <= 0o7777 for word in low) else high, strict=True):
        _store(words, place, [word])
    return -1


def _read_mif(lines: list[list[str]], words: dict[int, int]) -> int:
    radix = {"address_radix": 16, "data_radix": 16}
    begun = False
    for line in lines:
        text = " ".join(line)
        name, mark, value = (part.strip() for part in text.partition(":" if begun else "="))
        if begun and mark:
            first, many, last = (part.strip() for part in name.strip("[]").partition(".."))
            base = radix["address_radix"]
            address = _number(first, base, 1, 15)
            data = [_number(each, radix["data_radix"], 1, 12) for each in value.split()]
            end = _number(last, base, 1, 15) if many else address
            _store(words, address, data * (min(end, _LAST + 1) - address + 1))
        elif not begun and mark:
            if name in radix:
                radix[name] = _RADIXES.get(value, 0)
            elif name not in ("width", "depth"):
                raise ValueError
        elif name not in ("", "content", "begin", "content begin", "end"):
            raise ValueError
        begun = begun or name.endswith("begin")
    if not begun:
        raise ValueError
    return -1


def _rows(words: Mapping[int, int]) -> list[list[int]]:
    """Return the addresses in rows of eight at most."""
    rows: list[list[int]] = []
    for address in sorted(words):
        if not rows or rows[-1][-1] != address - 1 or len(rows[-1]) == _ROW:
            rows.append([])
        rows[-1].append(address)
    return rows


def _octal(words: Mapping[int, int]) -> list[str]:
    return [f"{row[0]:04o}: " + " ".join(f"{words[each]:04o}" for each in row) for row in _rows(words)]


def _readmemh(words: Mapping[int, int]) -> list[str]:
    return [f"@{row[0]:03x} " + " ".join(f"{words[each]:03x}" for each in row) for row in _rows(words)]


def _ep(words: Mapping[int, int]) -> list[str]:
    rows = [f"EP:{min(words):03x}", *(f"{each:03x}:{words[each]:03x}" for each in sorted(words))]
    return [row.upper() for row in rows]


def _deposits(words: Mapping[int, int]) -> list[str]:
    return [f"deposit {address:o} {words[address]:04o}" for address in sorted(words)]


def _bits(words: Mapping[int, int]) -> list[str]:
    every = [words.get(address, 0) for address in range(max(words) + 1)]
    return ["".join(str(word >> bit & 1) for bit in range(11, -1, -1)) for word in every]


def _frames(words: Mapping[int, int]) -> list[str]:
    return [f"{frame:03o}" for frame in binary.encode(words).strip(b"\200")[:-2]]


def _intel_hex(words: Mapping[int, int]) -> list[str]:
    records = []
    for row in _rows(words):
        values = [2 * len(row), row[0] >> 7, row[0] << 1 & 0o377, 0]
        for each in row:
            values += [words[each] & 0o377, words[each] >> 8]
        records.append(":" + "".join(f"{value:02x}" for value in [*values, -sum(values) & 0o377]).upper())
    return [*records, ":00000001FF"]


def _mif(words: Mapping[int, int]) -> list[str]:
    head = ["WIDTH=12;", f"DEPTH={4096 * (max(words) // 4096 + 1)};", "ADDRESS_RADIX=OCT;", "DATA_RADIX=OCT;"]
    rows = [f"{row[0]:04o} : " + " ".join(f"{words[each]:04o}" for each in row) + ";" for row in _rows(words)]
    return [*head, "CONTENT BEGIN", *rows, "END;"]


FORMATS: Final = {
    "octal-words": Format("octal addresses and words", _read_octal, _octal),
    "readmemh": Format("Verilog's $readmemh", _read_readmemh, _readmemh),
    "ep": Format("EP, entry point and hexadecimal words", _read_ep, _ep),
    "deposits": Format("deposits of a SIMH script", _read_deposits, _deposits),
    "bits": Format("lines of twelve bits", _read_bits, _bits),
    "intel-hex": Format("Intel's hexadecimal records", _read_intel_hex, _intel_hex),
    "mif": Format("Altera's memory initialization file", _read_mif, _mif),
    "octal-frames": Format("octal frames, one a line", _read_frames, _frames),
}
