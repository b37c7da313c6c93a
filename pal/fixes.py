"""What an editor offers to mend a diagnostic with: the advice that it carries, as edits of the source.

TAD NIX         undefined: NIX       "Define NIX": the line `NIX,  0` on this page
START  CLA      undefined: START     "Write START, as a tag"
JMP FAR         illegal reference    "Go through a pointer": `JMP I PFAR`, and the line `PFAR,  FAR`
TAD 18          18 has an 8          "Write 22, octal for 18"
"""

import re
from collections.abc import Iterator
from typing import NamedTuple

from pal.assembly import PAL3, PAL8
from pal.diagnostics import Diagnostic
from pal.document import SYMBOL, Document, Span
from pal.messages import COLON, MEANT, NO_SLASH, NOT_OCTAL
from pal.pieces import COMMENT, TEXT, comment, pieces

_UNDEFINED = ("UA", "US")
_ILLEGAL_REFERENCE = "IR"
_MEANT = re.compile(r"did you mean ([A-Z0-9 ]+)\?")
_ORIGINS = {
    dialect: re.compile(rf"[ \t]*(?:[*$]|(?:{names})\b(?![ \t]*[,=]))")
    for dialect, names in ((PAL3, "FIELD"), (PAL8, "FIELD|PAGE"))
}
_OPERAND = re.compile(r"[ \t]+([A-Za-z0-9]+)[ \t]*(?:;|$)")
_LONGEST = 5
"""Characters of a name that follow the P in the name of its pointer."""


class Fix(NamedTuple):
    """A change that mends a diagnostic: its title, and what comes in place of each span."""

    title: str
    edits: list[tuple[Span, str]]


def fixes(document: Document, tape: int, found: Diagnostic) -> Iterator[Fix]:
    """Yield the fixes for a diagnostic of a tape, the likeliest first."""
    line = found.line - 1
    text = document.line(tape, line)
    span = Span(tape, line, found.column - 1, min(found.end_column - 1, len(text)))
    name = text[span.start : span.end]
    behind = Span(tape, line, span.end, span.end)
    if found.code in _UNDEFINED and name[:1].isalpha():
        if span.start == 0 and text[span.end :][:1] in (" ", "\t"):
            yield Fix(f"Write {name}, as a tag", [(behind, ",")])
        yield Fix(f"Define {name}", [_at_the_end_of_page(document, span, f"{name},\t0")])
    elif found.code == MEANT and (meant := _MEANT.search(found.message)):
        yield Fix(f"Write {meant[1]}", [(span, meant[1])])
    elif found.code == NOT_OCTAL and name.isdecimal():
        yield Fix(f"Write {int(name):o}, octal for {name}", [(span, f"{int(name):o}")])
    elif found.code == COLON:
        yield Fix(
            "End the tag with a comma",
            [(span._replace(start=text.index(":", span.start), end=text.index(":", span.start) + 1), ",")],
        )
    elif found.code == NO_SLASH:
        start = _as_text(document, found, text[: span.start].strip(" \t"), span.start)
        yield Fix("Make it a comment", [(Span(tape, line, start, start), "/")])
    elif found.code == _ILLEGAL_REFERENCE:
        yield from _through_a_pointer(document, span)


def _as_text(document: Document, found: Diagnostic, before: str, start: int) -> int:
    """Return where text begins: at the undefined name `before` it, which looks like a tag, or at `start`."""
    names = [each for each in document.assembly.diagnostics if each.code in _UNDEFINED]
    at = [name.column - 1 for name in names if (name.file, name.line) == (found.file, found.line)]
    return at[0] if SYMBOL.fullmatch(before) and at and at[0] < start else start


def _through_a_pointer(document: Document, span: Span) -> Iterator[Fix]:
    """Yield the fix that refers through a pointer on this page."""
    text = document.line(span.tape, span.line)
    operand = _OPERAND.match(text[: comment(text, document.dialect)], span.end)
    if operand is None:
        return
    pointer = f"P{operand[1][:_LONGEST].upper()}"
    if pointer not in document.assembly.symbols:
        place = span._replace(start=operand.start(1), end=operand.end(1))
        word = _at_the_end_of_page(document, span, f"{pointer},\t{operand[1]}")
        yield Fix(f"Go through a pointer, {pointer}", [(place, f"I {pointer}"), word])


def _at_the_end_of_page(document: Document, span: Span, line: str) -> tuple[Span, str]:
    """Return the edit that puts a line behind this page's words: before the next origin or the $."""
    lines, origin = document.tapes[span.tape], _ORIGINS[document.dialect]
    for number, text in enumerate(lines[span.line :], span.line):
        if number > span.line and origin.match(text):
            return Span(span.tape, number, 0, 0), f"{line}\n"
        texts = [piece for piece in pieces(text, document.dialect) if piece.kind in (TEXT, COMMENT)]
        for end in (at for at, mark in enumerate(text) if mark == "$"):
            if not any(piece.start <= end < piece.end for piece in texts):
                return Span(span.tape, number, end, end), f"\n{line}\n"
    end = len(lines[-1])
    return Span(span.tape, len(lines) - 1, end, end), "\n" * (end > 0) + f"{line}\n"
