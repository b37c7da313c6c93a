"""What is wrong with a source, said to a person: DEC's message, the place, the line, and what to do.

    eia.pal:12:5: error: UA  LOOP    AT  0203
        JMP LOOP
            ^^^^
      undefined: LOOP is taken as 0377, the last address of its page; define it with LOOP, or LOOP=
    eia.pal:20:2: note: the program runs on from 0214 into data at 0215 [PN06]

PAL III's errors are DEC's, all of them: IC, RD, DT, ST and UA of pass 1, IR of passes 2 and 3; PAL8's
begin with DEC's codes too. Besides, there are notes of ours, of things at which the assembler is silent; a
comment with `pal:` and a note's code silences it on its line.

Sources: DEC-08-ASAC-D, "Diagnostics"; the output of DEC-08-ASB1.
"""

from collections.abc import Callable, Iterable, Sequence
from typing import NamedTuple

from pal.assembler import Message
from pal.dialects import hint
from pal.isa import ADDRESS, PAGE
from pal.notes import Note
from pal.source import Place, Source
from pal.symbols import PERMANENT

ERROR, NOTE = "error", "note"
STOPPED = "PS01"
"""Where PAL III goes no further."""

_CONTROLS = {code: "\N{MIDDLE DOT}" for code in (*range(0x20), 0x7F) if code != ord("\t")}
"""A terminal is shown no control codes of a source."""


_REFERENCES = {symbol.mnemonic for symbol in PERMANENT if symbol.memory_reference}


_WIDTH = 100
"""Characters of a line that are shown."""


class Diagnostic(NamedTuple):
    """One thing that is wrong.

    severity    ERROR, what DEC's assembler says or where it goes no further; or NOTE, which is ours
    code        DEC's two letters; a note's PN and number; STOPPED where PAL III goes no further
    message     what DEC's assembler types, or what we say
    advice      what it means and what to do
    hint        what PAL III has for what another assembler's dialect says here, or ""
    file, line, column, end_column    the place, counted from 1; the end is the column after it
    source      the line
    """

    severity: str
    code: str
    message: str
    advice: str
    hint: str
    file: str
    line: int
    column: int
    end_column: int
    source: str

    @property
    def error(self) -> bool:
        """Whether it is an error."""
        return self.severity == ERROR

    def __str__(self) -> str:
        return "\n".join([self.headline, *self.excerpt, *self.sentences])

    @property
    def headline(self) -> str:
        """The line that editors and CI know: file, line, column, severity, message."""
        code = f" [{self.code}]" if self.code[2:] else ""
        return f"{self.file}:{self.line}:{self.column}: {self.severity}: {self.message}{code}"

    @property
    def excerpt(self) -> list[str]:
        """The source line and carets below it; nothing of an empty line."""
        if not self.source.strip(" \t\f\r\n"):
            return []
        start, end = _excerpt(self.source, self.column - 1)
        before = self.source[start : self.column - 1]
        margin = "".join("\t" if character == "\t" else " " for character in before)
        carets = "^" * max(1, min(self.end_column - self.column, end - self.column + 1))
        return [f"    {self.source[start:end].translate(_CONTROLS)}", f"    {margin}{carets}"]

    @property
    def sentences(self) -> list[str]:
        """Advice and hint, a line each."""
        return [f"  {sentence}" for sentence in (self.advice, self.hint) if sentence]


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
        return [empty(names)]
    found: list[tuple[int, Diagnostic]] = []
    full = False
    small = 0
    for message in messages:
        at = _reference(source, message.at) if message.code == "IR" else message.at
        place = source.place(at)
        subject = message.subject.strip()
        if message.code == "IC" and 0o341 <= int(subject, 8) <= 0o372:
            small += 1
            if small > 1:
                continue
        advice = _ADVICE[message.code](subject, message.location)
        if message.code == "IC" and subject == "0277":
            advice = _ADVICE["IC"](subject, message.location).replace("?", _shown(source, message.at), 1)
        said = str(message)
        found.append(
            (at, at_place(ERROR, message.code, said, advice, names, place, hint(message.code, subject)))
        )
        full |= message.code == "ST"
    for reason, at in stops:
        if not full:
            found.append((at, at_place(ERROR, STOPPED, reason, "", names, source.place(at))))
    for note in notes:
        place = source.place(note.at)
        if not silenced(place.text, note.code):
            found.append((note.at, at_place(NOTE, note.code, note.message, note.advice, names, place)))
    return [diagnostic for _, diagnostic in sorted(found, key=lambda each: each[0])]


def empty(names: Sequence[str]) -> Diagnostic:
    """Return the note on a source without a character."""
    file = names[0] if names else "source"
    return Diagnostic(NOTE, "PN27", "the source is empty", "write at least a $", "", file, 1, 1, 2, "")


def at_place(
    severity: str,
    code: str,
    message: str,
    advice: str,
    names: Sequence[str],
    place: Place,
    sentence: str = "",
) -> Diagnostic:
    """Return a diagnostic of what stands at `place`; `sentence` is its hint."""
    end = max(place.end, place.start + 1) + 1
    where = names[place.tape], place.line, place.start + 1, end, place.text
    return Diagnostic(severity, code, message.translate(_CONTROLS), advice, sentence, *where)


def silenced(text: str, code: str) -> bool:
    """Tell whether a comment of the line silences the notes of `code`: `/ pal: PN06`."""
    comment = text.partition("/")[2].lower()
    return "pal:" in comment and code.lower() in comment.partition("pal:")[2]


def _shown(source: Source, at: int) -> str:
    """Return the character that ends an item as a person wrote it."""
    return source.shown[source.spans[at][1] : source.spans[at][1] + 1]


def _reference(source: Source, end: int) -> int:
    """Return the memory-reference symbol of the statement that ends there, or its end."""
    statement = reversed(range(source.begun(end), end + 1))
    return next((at for at in statement if source.items[at][0] in _REFERENCES), end)


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
    if value == 0o200:
        return "so many letters in a number that PAL III loses its way; a symbol begins with a letter"
    return f"illegal character {_spelled(value & 0o177)}: PAL III passes over it"


def _spelled(character: int) -> str:
    return chr(character) if chr(character).isprintable() else f"(code {character | 0o200:04o})"


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
