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
from pal.notes import DIALECT, ERROR, NOTE, Note, Said
from pal.source import Place, Source
from pal.symbols import PSEUDO_OPERATORS, REFERENCES

STOPPED = "PS01"
"""Where PAL III goes no further."""

_CONTROLS = {code: "\N{MIDDLE DOT}" for code in range(0x20) if code != ord("\t")}
"""A terminal is shown no control codes of a source."""

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
        """The source line and carets below it; of a long one a screen's width, nothing of an empty one."""
        if not self.source.strip(" \t\f\r\n"):
            return []
        start = max(0, min(self.column - 1 - _WIDTH // 2, len(self.source) - _WIDTH))
        end = start + _WIDTH
        before = self.source[start : self.column - 1]
        margin = "".join("\t" if character == "\t" else " " for character in before)
        carets = "^" * max(1, min(self.end_column - self.column, end - self.column + 1))
        return [f"    {self.source[start:end].translate(_CONTROLS)}", f"    {margin}{carets}"]

    @property
    def sentences(self) -> list[str]:
        """Advice and hint, a line each."""
        return [f"  {sentence}" for sentence in (self.advice, self.hint) if sentence]


def of_pal3(
    source: Source, messages: Iterable[Message], stopped: tuple[str, int] | None, notes: Iterable[Note]
) -> list[Said]:
    """Return what is said of a source in PAL III: its messages, why it went no further, and our notes."""
    found: list[Said] = []
    full = small = False
    for message in messages:
        at = _reference(source, message.at) if message.code == "IR" else message.at
        subject = message.subject.strip()
        lower = message.code == "IC" and 0o341 <= int(subject, 8) <= 0o372
        if lower and small:
            continue
        small |= lower
        if message.code == "UA":
            advice = _undefined(subject, message.location, source)
        elif message.code == "IR":
            advice = _beyond(subject, message.location, source.items[at + 1 : at + 2] == [("", "-")])
        else:
            advice = _ADVICE[message.code](subject, message.location)
        if subject == "0277":
            mark = source.spans[message.at][1]
            advice = advice.replace("?", source.shown[mark : mark + 1])
        said = Note(message.code, at, str(message), advice)
        found.append((ERROR, said, hint(message.code, subject)))
        full |= message.code == "ST"
    if stopped and not full:
        name = source.items[stopped[1]][0]
        advice = f"{name} is PAL III's own; give it another name" if name in PSEUDO_OPERATORS else ""
        found.append((ERROR, Note(STOPPED, stopped[1], stopped[0], advice), ""))
    return [*found, *((NOTE, note, "") for note in notes)]


def empty(names: Sequence[str]) -> Diagnostic:
    """Return the note on a source without a character."""
    file = names[0] if names else "source"
    return Diagnostic(NOTE, "PN27", "the source is empty", "write at least a $", "", file, 1, 1, 2, "")


def told(said: Iterable[Said], names: Sequence[str], place_of: Callable[[int], Place]) -> list[Diagnostic]:
    """Return what is said of a source as diagnostics, in the order of the places that `place_of` gives."""
    diagnostics: list[tuple[tuple[int, int, int], Diagnostic]] = []
    for severity, note, sentence in said:
        place = place_of(note.at)
        if severity == ERROR or not _silenced(place.text, note.code):
            end = max(place.end, place.start + 1) + 1
            shown = "" if note.code == DIALECT else place.text  # it is of the whole source
            where = names[place.tape], place.line, place.start + 1, end, shown
            message = note.message.translate(_CONTROLS)
            diagnostic = Diagnostic(severity, note.code, message, note.advice, sentence, *where)
            diagnostics.append(((place.tape, place.line, place.start), diagnostic))
    return [diagnostic for _, diagnostic in sorted(diagnostics, key=lambda each: each[0])]


def _silenced(text: str, code: str) -> bool:
    """Tell whether a comment of the line silences the notes of `code`: `/ pal: PN06`."""
    comment = text.partition("/")[2].lower()
    return "pal:" in comment and code.lower() in comment.partition("pal:")[2]


def _reference(source: Source, end: int) -> int:
    """Return the memory-reference symbol of the statement that ends there, or its end."""
    statement = reversed(range(source.begun(end), end + 1))
    return next((at for at in statement if source.items[at][0] in REFERENCES), end)


def _undefined(name: str, location: int, source: Source) -> str:
    """Return what an undefined symbol became, and how to define it: perhaps its tag lacks a comma."""
    taken = f"undefined: {name} is taken as {location | ADDRESS:04o}, the last address of its page; "
    at = source.bare_tag(name)
    if at is None:
        return f"{taken}define it with {name}, or {name}="
    if source.items[at + 1][0] == "EQU":
        return f"{taken}PAL III has no EQU: in line {source.place(at).line} write {name}="
    return f"{taken}if it is the tag of line {source.place(at).line}, write {name}, there"


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


def _beyond(address: str, location: int, negative: bool) -> str:
    page = location & PAGE
    low = int(address, 8) & ADDRESS
    pointer = "go through a pointer on this page, with I"
    return (
        f"illegal reference: {address} is neither on page zero nor on the page of {location:04o}; "
        f"{page | low:04o} is used; "
        + ("a negative number is referred to by a tag, as in M5, -5" if negative else pointer)
    )


_ADVICE: dict[str, Callable[[str, int], str]] = {
    "IC": _illegal,
    "RD": lambda name, _: f"redefinition: {name} has a value already and takes the new one; use another name",
    "DT": lambda name, _: f"duplicate tag: {name or 'it'} keeps the value it has; use another name",
    "ST": lambda name, _: f"symbol table full: no room for {name}, and no tape; use fewer symbols",
}
