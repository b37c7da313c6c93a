"""What is wrong with a source, said to a person: DEC's message, the place, the line, and what to do.

    eia.pal:12:5: UA  LOOP    AT  0203
        JMP LOOP
            ^^^^
      undefined: LOOP is taken as 0377, the last address of its page; define it with LOOP, or LOOP=

The errors are DEC's, all of them: IC, RD, DT, ST and UA of pass 1, IR of passes 2 and 3. Besides, there are
notes of ours, of things at which PAL III is silent.

Sources: DEC-08-ASAC-D, "Diagnostics"; the output of DEC-08-ASB1.
"""

from collections.abc import Callable, Iterable, Sequence
from operator import itemgetter
from typing import NamedTuple

from pal.assembler import Message
from pal.dialects import hint
from pal.isa import ADDRESS, PAGE
from pal.notes import Note
from pal.source import Source
from pal.symbols import PERMANENT

ERROR, NOTE = "error", "note"

_CONTROLS = {code: "\N{MIDDLE DOT}" for code in (*range(0x20), 0x7F) if code != ord("\t")}
"""A terminal is shown no control codes of a source."""


_REFERENCES = {symbol.mnemonic for symbol in PERMANENT if symbol.memory_reference}


_WIDTH = 100
"""Characters of a line that are shown."""


class Diagnostic(NamedTuple):
    """One thing that is wrong.

    severity    ERROR, what DEC's assembler says or where it goes no further; or NOTE, which is ours
    code        DEC's two letters; "" for what it does not say
    message     what DEC's assembler types, or what we say
    advice      what it means and what to do
    hint        what PAL III has for what another assembler's dialect says here, or ""
    file, line, column    the place, counted from 1; `source` is the line, `width` how much of it is marked
    """

    severity: str
    code: str
    message: str
    advice: str
    hint: str
    file: str
    line: int
    column: int
    width: int
    source: str

    @property
    def error(self) -> bool:
        """Whether it is an error."""
        return self.severity == ERROR

    def __str__(self) -> str:
        start, end = _excerpt(self.source, self.column - 1)
        before = self.source[start : self.column - 1]
        margin = "".join("\t" if character == "\t" else " " for character in before)
        source = self.source[start:end].translate(_CONTROLS)
        carets = "^" * max(1, min(self.width, end - self.column + 1))
        shown = f"    {source}\n    {margin}{carets}\n" if source.strip() else ""
        advice = "".join(f"  {sentence}\n" for sentence in (self.advice, self.hint) if sentence)
        return f"{self.file}:{self.line}:{self.column}: {self.message}\n{shown}{advice}".rstrip("\n")


def _excerpt(source: str, place: int) -> tuple[int, int]:
    """Return which part of a line is shown: all of it, or of a long one a screen's width about the place."""
    if len(source) <= _WIDTH:
        return 0, len(source)
    start = max(0, min(place - _WIDTH // 2, len(source) - _WIDTH))
    return start, start + _WIDTH


def diagnose(
    source: Source,
    names: Sequence[str],
    messages: Iterable[Message],
    stops: Iterable[tuple[str, int]],
    notes: Iterable[Note],
) -> list[Diagnostic]:
    """Return the messages, why PAL III went no further, and our notes as diagnostics, in source order."""
    if len(source.text) == 1:
        file = names[0] if names else "source"
        return [
            Diagnostic(NOTE, "", "note: the source is empty", "write at least a $", "", file, 1, 1, 1, "")
        ]
    found: list[tuple[int, Diagnostic]] = []

    def add(severity: str, at: int, code: str, said: str, advice: str, sentence: str = "") -> None:
        place = source.place(at)
        where = names[place.tape], place.line, place.start + 1, place.end - place.start, place.text
        message = said.translate(_CONTROLS)
        found.append((at, Diagnostic(severity, code, message, advice, sentence, *where)))

    full = False
    for message in messages:
        at = _reference(source, message.at) if message.code == "IR" else message.at
        subject = message.subject.strip()
        advice = _ADVICE[message.code](subject, message.location)
        add(ERROR, at, message.code, str(message), advice, hint(message.code, subject))
        full |= message.code == "ST"
    for reason, at in stops:
        if not full:
            add(ERROR, at, "", f"error: {reason}", "")
    for note in notes:
        add(NOTE, note.at, "", f"note: {note.message}", note.advice)
    return [diagnostic for _, diagnostic in sorted(found, key=itemgetter(0))]


def _reference(source: Source, end: int) -> int:
    """Return the memory-reference symbol of the statement that ends there, or its end."""
    for at in range(end, -1, -1):
        if at < end and source.items[at][1] in "\r;":
            break
        if source.items[at][0] in _REFERENCES:
            return at
    return end


def _undefined(name: str, location: int) -> str:
    value = f"{location | ADDRESS:04o}"
    where = "the last address of its page"
    return f"undefined: {name} is taken as {value}, {where}; define it with {name}, or {name}="


def _illegal(code: str, location: int) -> str:
    value = int(code, 8)
    if value < 0o200:
        if value >= 0o60:
            return f"illegal character: the digit {chr(value)} after a letter in a number"
        letter = chr(value + 0o100)
        return f"illegal character: the letter {letter} in a number; a symbol begins with a letter"
    return f"illegal character {_spelled(value & 0o177)}: PAL III passes over it"


def _spelled(character: int) -> str:
    return chr(character) if 0o40 < character < 0o177 else f"(code {character | 0o200:04o})"


def _beyond(address: str, location: int) -> str:
    page = location & PAGE
    low = int(address, 8) & ADDRESS
    return (
        f"illegal reference: {address} is neither on page zero nor on the page of {location:04o}; "
        f"{page | low:04o} is used; go through a pointer on this page, with I"
    )


_ADVICE: dict[str, Callable[[str, int], str]] = {
    "IC": _illegal,
    "RD": lambda name, _: f"redefinition: {name} has a value already and takes the new one; use another name",
    "DT": lambda name, _: f"duplicate tag: {name or 'it'} keeps the value it has; use another name",
    "ST": lambda name, _: f"symbol table full: no room for {name}, and no tape; use fewer symbols",
    "UA": _undefined,
    "IR": _beyond,
}
