r"""The reader: frames of source tapes to the items PAL III reads, each with the character that ends it.

    ``A,<TAB>TAD I B+1  /COMMENT<CR>``
    ("A", ",") ("", TAB) ("TAD", " ") ("I", " ") ("B", "+") ("1", " ") ("", " ") ("", CR)

An item is a run of letters and digits, perhaps empty. Any other character ends it, one that PAL III does not
know too. A comment, from ``/`` to CR, is not read.

Channel 8 is set on every frame of a tape of DEC's and not in a file of a text editor; here it does not
matter. Blank frames, leader (0200), RUBOUT, line feed and form feed are passed over; a form feed stays in
`text`, since pass 3 types it. A line feed without channel 8 is the end of a line in a text file, so it counts
as CR, LF, unless a CR is just before.

Sources: DEC-08-ASAC-D, "Characters"; the output of DEC-08-ASB1.
"""

import re
from collections.abc import Sequence
from functools import cached_property
from typing import NamedTuple

from pal.symbols import SIGNIFICANT
from tapes.frames import PARITIES

_PASSED_OVER = bytes((0o000, 0o200, 0o177, 0o377, 0o212))
_ITEM = re.compile(r"([A-Z0-9\f]*)(?:/[^\r]*)?([^A-Z0-9\f])")

ENDS = frozenset("\r;")
"""The characters that end a statement."""


class Place(NamedTuple):
    """An item in its source: tape and line, counted from 0 and 1; the line's text; the item's columns."""

    tape: int
    line: int
    text: str
    start: int
    end: int


class Source:
    """The source tapes, read one after the other as if they were one.

    text     what is on them, each line ended by CR; a CR and a `$` are added at the end
    shown    the same as a person wrote it: what is not ASCII is `?` in `text`
    items    [(letters and digits, the character that ends them), ...]
    feeds    the items in which, or in the comment after which, there is a form feed
    """

    def __init__(self, tapes: Sequence[bytes | str], modern: bool) -> None:
        texts = [characters(tape) for tape in tapes]
        self.shown = "".join(texts)
        text = plain(self.shown)
        self._starts: list[int] = []
        start = 0
        for each in texts:
            self._starts.append(start)
            start += len(each)
        self.text = text + ("$" if text.endswith("\r") or not text else "\r$")
        self._code = self.text.upper() if modern else self.text
        self.items: list[tuple[str, str]] = _ITEM.findall(self._code)
        self.feeds: list[int] = []
        self._lines: dict[int, tuple[str, list[tuple[int, int]]]] = {}
        """The text of a line that was asked for, which all its places share, and the columns of its items."""
        if "\f" in text:
            self.items = [(item.replace("\f", ""), mark) for item, mark in self.items]
            self.feeds = [at for at, (start, end) in enumerate(self.spans) if "\f" in self.text[start:end]]

    @cached_property
    def spans(self) -> list[tuple[int, int]]:
        """For each item, where it and the character that ends it are in `text`."""
        return [(match.start(), match.end() - 1) for match in _ITEM.finditer(self._code)]

    @cached_property
    def _ends(self) -> list[int]:
        """The end of each line in `text`."""
        ends = []
        end = -1
        lines = self.text.split("\r")
        lines.pop()
        for line in lines:
            end += len(line) + 1
            ends.append(end)
        return ends

    @cached_property
    def line_ends(self) -> list[int]:
        """The last item of each line."""
        return [at for at, (_, mark) in enumerate(self.items) if mark == "\r"]

    def begun(self, at: int) -> int:
        """Return the first item of the statement that item `at` belongs to."""
        while at and self.items[at - 1][1] not in ENDS:
            at -= 1
        return at

    def first_symbol(self, end: int) -> int:
        """Return the first symbol after any tag of the statement that item `end` ends, or `end`."""
        statement = range(self.begun(end), end + 1)
        symbols = (at for at in statement if self.items[at][0][:1].isalpha() and self.items[at][1] != ",")
        return next(symbols, end)

    def bare_tag(self, name: str) -> int | None:
        """Return the item that may be the tag `name` without its comma: it begins a line of several items."""
        items = self.items
        for at in [0, *(end + 1 for end in self.line_ends)]:
            if at + 1 < len(items):
                item, mark = items[at]
                if item[:SIGNIFICANT] == name and mark in " \t" and items[at + 1][0]:
                    return at
        return None

    def place(self, at: int) -> Place:
        """Return the place of item `at`; of an empty one, that of the character that ends it."""
        from bisect import bisect_left

        line = bisect_left(self.line_ends, at)
        begin = self._ends[line - 1] + 1 if line else 0
        end = self._ends[line] if line < len(self._ends) else len(self.text)
        if line not in self._lines:
            found = _ITEM.finditer(self._code[begin : end + 1])
            self._lines[line] = self.shown[begin:end], [(match.start(), match.end()) for match in found]
        text, columns = self._lines[line]
        start, after = columns[at - (self.line_ends[line - 1] + 1 if line else 0)]
        if self.items[at][0]:
            after = start + len(self.items[at][0])
        else:
            start = after - 1
        tape = sum(first <= begin + start for first in self._starts) - 1
        number = line - bisect_left(self._ends, self._starts[tape]) + 1
        return Place(tape, number, text, start, after)


def plain(text: str) -> str:
    """Return a text with a `?` for each character that is not ASCII."""
    return text if text.isascii() else text.encode("ascii", "replace").decode("ascii")


def characters(tape: bytes | str) -> str:
    """The characters that PAL III reads, each line ended by CR; a text or UTF-8 keeps those beyond ASCII."""
    given = _utf_8(tape) if isinstance(tape, bytes) and not tape.isascii() else tape
    if isinstance(given, bytes):
        text = given.translate(PARITIES["none"], _PASSED_OVER).decode("ascii")
    else:
        text = given.removeprefix("\ufeff").replace("\0", "").replace("\x7f", "")
    return text.replace("\r\n", "\r").replace("\n", "\r")


def _utf_8(tape: bytes) -> bytes | str:
    """Return the text of a UTF-8 tape, or the tape itself if it is not UTF-8."""
    try:
        return tape.decode()
    except ValueError:  # it is not UTF-8
        return tape


class Line:
    """A line of a source: its tape, counted from 0, its number on it, from 1, and its text."""

    def __init__(self, tape: int, number: int, text: str) -> None:
        self.tape = tape
        self.number = number
        self.text = text


def lines_of(tapes: Sequence[bytes | str]) -> list[Line]:
    """Return the lines of the source tapes, read one after the other; a tape's end ends a line."""
    lines = []
    for tape, frames in enumerate(tapes):
        text = characters(frames).partition("\x1a")[0].replace("\f", "").replace("\v", "")
        texts = text.split("\r")
        last = texts.pop()
        if last:
            texts.append(last)
        lines += [Line(tape, number, text) for number, text in enumerate(texts, 1)]
    return lines
