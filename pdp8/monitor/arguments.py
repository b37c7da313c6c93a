r"""The words of a line: separated by spaces, or quoted; `#` begins a comment.

expect "A    B\r"      ->  expect, A    B RETURN      \r \n \f \t \a \e \\ \" and three octal digits
"""

import re
from collections.abc import Sequence

from tapes.errors import WorkError

FRAME = 0xF700
"""A code without a character, such as \\375, is the character with the number FRAME + 0o375."""

_WORD = re.compile(r'#.*|"((?:\\.|[^"\\])*)("?)|[^\s#]+', re.DOTALL)
_ESCAPE = re.compile(r"\\([0-3][0-7]{2}|.?)", re.DOTALL)
_ESCAPES = dict(zip('rnfta\\"', '\r\n\f\t\a\\"', strict=True)) | {"e": chr(FRAME + 0o375)}
LONGEST = 1e9
"""Seconds of machine time that may be named."""


class MonitorError(WorkError):
    """A line that the monitor cannot carry out."""


class Quoted(str):
    """A word that stood in quotes, its escapes replaced."""

    __slots__ = ()


def command(line: str) -> tuple[str, str]:
    """Return a command's name, "" for none or a comment (;), and what comes after it."""
    name, *_ = line.partition("#")[0].split() or ("",)
    name = "" if name[:1] in (";", ":") else name
    return name, line.lstrip()[len(name) :]


def split(line: str) -> list[str]:
    """Return the words of `line`. Raises MonitorError for a quote without its other, an unknown escape."""
    words: list[str] = []
    for found in _WORD.finditer(line):
        if found[0][0] == '"':
            if not found[2]:
                raise MonitorError('a quote (") has no other to end it')
            words.append(Quoted(_ESCAPE.sub(_escaped, found[1])))
        elif found[0][0] != "#":
            words.append(found[0])
    return words


def _escaped(escape: re.Match[str]) -> str:
    if len(escape[1]) == 3:
        code = int(escape[1], 8)
        return chr(code if code < 0o200 else FRAME + code)
    if escape[1] in _ESCAPES:
        return _ESCAPES[escape[1]]
    raise MonitorError(f'{escape[0]}: the escapes are \\r \\n \\f \\t \\a \\e \\\\ \\" and \\000 to \\377')


def as_it_stands(rest: str) -> list[str]:
    """Return everything after a command's name and one blank as one word."""
    return [rest[1:]]


def octal(text: str, most: int = 0o7777) -> int:
    """Return the octal number, 0 to `most`. Raises MonitorError."""
    try:
        number = int(text, 8)
    except ValueError:
        raise MonitorError(f"{text}: neither an octal number nor a symbol of the program") from None
    if not 0 <= number <= most:
        width = len(f"{most:o}")
        raise MonitorError(f"{text}: not between {0:0{width}o} and {most:o}")
    return number


def seconds(text: str) -> float:
    """Return a time in seconds. Raises MonitorError."""
    try:
        number = float(text)
    except ValueError:
        raise MonitorError(f"{text}: seconds of machine time were expected") from None
    if not 0 <= number <= LONGEST:
        raise MonitorError(f"{text}: not between 0 and 1e9 seconds of machine time")
    return number


def some(arguments: Sequence[str], what: str, least: int = 1, most: int | None = None) -> Sequence[str]:
    """Return `arguments` if their number is at least `least` and at most `most`. Raises MonitorError."""
    if len(arguments) < least:
        raise MonitorError(f"{what} expected")
    if most is not None and len(arguments) > most:
        raise MonitorError(f"{what} expected, and no more: {' '.join(arguments[most:])}")
    return arguments
