"""What the page says of a source while it is typed: where its words are, and what is wrong, line by line."""

from typing import NamedTuple

from pal.assembling import FOUND, assemble
from pal.assembly import MOST, Assembly
from pal.diagnostics import Diagnostic
from tapes.quantities import counted


class Said(NamedTuple):
    """A diagnostic: line, from 1; columns, from 0 to before `end`; its short and its whole text."""

    line: int
    start: int
    end: int
    severity: str
    brief: str
    whole: str


class Findings(NamedTuple):
    """What the assembler made of a source: (line, address, word)s; the first diagnostics; a summary."""

    ok: bool
    tape: bytes
    words: list[tuple[int, int]]
    places: list[tuple[int, int, int | None]]
    diagnostics: list[Said]
    more: int
    summary: str


def assembled(name: str, text: str) -> Assembly:
    """Assemble a source, in the dialect that it is written in."""
    return assemble(text, names=[name], dialect=FOUND)


def checked(name: str, text: str) -> Findings:
    """Assemble a source, and return what was found."""
    return findings(assembled(name, text))


def findings(assembly: Assembly) -> Findings:
    """Return what became of a source."""
    diagnostics = assembly.diagnostics
    return Findings(
        assembly.ok,
        assembly.tape,
        list(assembly.words.items()),
        [(line.number, line.address, line.word) for line in assembly.lines if line.address is not None],
        [_said(diagnostic) for diagnostic in diagnostics[:MOST]],
        max(0, len(diagnostics) - MOST),
        _summary(assembly),
    )


def here(message: str) -> str:
    """Return a message without advice on the command's options."""
    return "; ".join(part for part in message.split("; ") if "--" not in part)


def _said(of: Diagnostic) -> Said:
    sentences = [f"  {here(sentence)}" for sentence in (of.advice, of.hint) if here(sentence)]
    brief = here(of.advice).split("; ")[0] or of.message
    whole = "\n".join([of.headline, *of.excerpt, *sentences])
    return Said(of.line, of.column - 1, of.end_column - 1, of.severity, brief, whole)


def _summary(assembly: Assembly) -> str:
    errors = sum(diagnostic.error for diagnostic in assembly.diagnostics)
    numbers = ((errors, "errors"), (len(assembly.diagnostics) - errors, "notes"))
    found = ", ".join(counted(number, what) for number, what in numbers if number)
    made = f"{counted(len(assembly.words), 'words')}, a tape of {counted(len(assembly.tape), 'frames')}"
    return f"{made}; {found}." if found else f"{made}."
