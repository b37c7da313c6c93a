"""Things at which PAL III is silent and a person would rather know.

They are no errors: the tape is the same, and is written.
"""

import re
from typing import NamedTuple

from pal import scanner
from pal.assembler import Place
from pal.scanner import Line

_LOST_OPERATOR = re.compile(r"[+-][ \t]+[A-Z0-9.]")


class Note(NamedTuple):
    """What is to be noted, where, and what to do."""

    place: Place
    message: str
    advice: str


def notes(lines: list[Line], tapes: int) -> list[Note]:
    """Return what is to be noted of a source of so many tapes, of which `lines`, at least one, were read."""
    found = [
        Note(
            Place(number, index, at),
            "this makes an inclusive OR of it",
            "a space is an operator too, and the last one counts; leave no space after + or -",
        )
        for number, line in enumerate(lines)
        for index, statement in enumerate(line.statements)
        if _LOST_OPERATOR.search(statement)
        for at, token in enumerate(scanner.tokens(statement))
        if token.mark == scanner.SPACE
    ]
    return _nameless(lines) + found + _of_the_end(lines, tapes)


def _nameless(lines: list[Line]) -> list[Note]:
    for number, line in enumerate(lines):
        for index, statement in enumerate(line.statements):
            for at, token in enumerate(scanner.tokens(statement)):
                if token.symbol:
                    return []
                if token.mark in (",", "="):
                    advice = "PAL III defines a symbol without a name; symbols begin with a capital letter"
                    return [Note(Place(number, index, at), "no symbol stands before this", advice)]
    return []


def _of_the_end(lines: list[Line], tapes: int) -> list[Note]:
    last = lines[-1]
    end = Place(len(lines) - 1, len(last.statements) - 1, 0)
    found = []
    if last.complete:
        advice = "PAL III would wait for more tape; it is taken as if there were one"
        found.append(Note(end, "no $ at the end", advice))
    elif scanner.tokens(last.statements[-1]):
        found.append(
            Note(end, "this makes no word", "$ ends the pass where it stands; put it on its own line")
        )
    if last.tape < tapes - 1:
        unread = tapes - 1 - last.tape
        message = f"{unread} more tape{'s' * (unread > 1)} not read"
        found.append(
            Note(end, message, "$ ends the source; on a tape that others follow, PAUSE stands instead")
        )
    return found
