r"""The text of an open document, and places in it as an editor counts them.

A line ends at "\n", "\r\n" or "\r", as in the Language Server Protocol; a form feed, a vertical tab or a
Unicode separator ends none. A place is a line and a character in it, both from 0. Characters are counted in
the unit that editor and server agreed on: bytes of UTF-8, words of UTF-16, or code points.
"""

import re
from functools import cached_property
from urllib.parse import unquote, urlsplit

UTF8, UTF16, UTF32 = "utf-8", "utf-16", "utf-32"
_ENDS = re.compile(r"\r\n|\r|\n")


def path_of(uri: str) -> str:
    """Return the path that a file's URI names."""
    return unquote(urlsplit(uri).path)


class Text:
    """The text of a document, in the `unit` of its editor; an edit gives a new one."""

    def __init__(self, content: str, unit: str = UTF16) -> None:
        self.content = content
        self.unit = unit

    @cached_property
    def lines(self) -> list[str]:
        """The lines without their ends; one more than there are ends."""
        return _ENDS.split(self.content)

    @cached_property
    def _starts(self) -> list[int]:
        """Where each line begins, in code points."""
        return [0, *(end.end() for end in _ENDS.finditer(self.content))]

    def column(self, line: int, character: int) -> int:
        """Return the code points before a place; a place behind the end of its line is at the end."""
        text = self.lines[line] if line < len(self.lines) else ""
        if self.unit == UTF32 or text.isascii():
            return min(character, len(text))
        column = 0
        while column < len(text) and character > 0:
            character -= self._width(text[column])
            column += 1
        return column

    def character(self, line: int, column: int) -> int:
        """Return the characters, in the editor's unit, before a column in code points."""
        text = self.lines[line][:column] if line < len(self.lines) else ""
        if self.unit == UTF32 or text.isascii():
            return column
        return column - len(text) + sum(map(self._width, text))

    def _width(self, code_point: str) -> int:
        if self.unit == UTF8:
            return len(code_point.encode("utf-8", "surrogatepass"))
        return 2 if code_point > "\uffff" else 1

    def _offset(self, line: int, character: int) -> int:
        if line >= len(self.lines):
            return len(self.content)
        return self._starts[line] + self.column(line, character)

    def edited(self, start: tuple[int, int], end: tuple[int, int], new: str) -> "Text":
        """Return the text with `new` from place `start` to place `end`, each (line, character)."""
        first, last = sorted((self._offset(*start), self._offset(*end)))
        return Text(self.content[:first] + new + self.content[last:], self.unit)
