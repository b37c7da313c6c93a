"""A line of a source in pieces, as an editor colours and completes it: names, numbers, texts, the comment.

    LOOP, TAD (7  /ADD      name LOOP, name TAD, number 7, comment /ADD
    TEXT /A/; "/            name TEXT, text /A/, text "/

The assembler reads by itself; this tells where in a line code ends and a comment begins.
"""

import re
from collections.abc import Iterator
from typing import NamedTuple

from pal.assembly import PAL8

NAME, NUMBER, TEXT, COMMENT = "name", "number", "text", "comment"
_PAL3 = re.compile(r"(?P<name>[A-Za-z][A-Za-z0-9]*)|(?P<number>[0-9]+)|(?P<comment>/.*)|.", re.DOTALL)
_PAL8 = re.compile(
    r"(?P<text>\".|(?<=\bTEXT)(?:[ \t]*([^ \tA-Z0-9;])|[ \t]+([A-Z0-9])).*?(?:\2|\3|$))"
    rf"|{_PAL3.pattern}",
    re.DOTALL | re.IGNORECASE,
)


class Piece(NamedTuple):
    """A part of a line from column `start` to before `end`, and its kind."""

    kind: str
    start: int
    end: int


def pieces(line: str, dialect: str) -> Iterator[Piece]:
    """Yield the names, numbers, texts and the comment of a line, in its order."""
    for found in (_PAL8 if dialect == PAL8 else _PAL3).finditer(line):
        if found.lastgroup:
            yield Piece(found.lastgroup, found.start(), found.end())


def comment(line: str, dialect: str) -> int:
    """Return the column at which the comment of a line begins, its length if it has none."""
    return next((piece.start for piece in pieces(line, dialect) if piece.kind == COMMENT), len(line))
