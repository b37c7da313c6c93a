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

from pal import scanner
from pal.assembler import Message, Place
from pal.dialects import hint
from pal.notes import Note, notes
from pal.scanner import Line

_CONTROLS = {code: "\N{MIDDLE DOT}" for code in (*range(0x20), 0x7F) if code != ord("\t")}
"""A terminal is shown no control codes of a source."""


class Diagnostic(NamedTuple):
    """One thing that is wrong.

    code        DEC's two letters; "" for a note of ours
    message     what DEC's assembler types, or the note
    advice      what it means and what to do
    hint        what PAL III has for what another assembler's dialect says here, or ""
    file, line, column    the place, counted from 1; `source` is the line, `width` how much of it is meant
    """

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
        """Whether it is DEC's."""
        return bool(self.code)

    def __str__(self) -> str:
        margin = "".join("\t" if character == "\t" else " " for character in self.source[: self.column - 1])
        source = self.source.translate(_CONTROLS)
        shown = f"    {source}\n    {margin}{'^' * max(1, self.width)}\n" if source.strip() else ""
        advice = "".join(f"  {sentence}\n" for sentence in (self.advice, self.hint) if sentence)
        return f"{self.file}:{self.line}:{self.column}: {self.message}\n{shown}{advice}".rstrip("\n")


def diagnose(lines: list[Line], names: Sequence[str], messages: Iterable[Message]) -> list[Diagnostic]:
    """Return the messages and our notes as diagnostics, in source order."""
    if not lines:
        file = names[0] if names else "source"
        return [Diagnostic("", "note: the source is empty", "there is not even a $", "", file, 1, 1, 1, "")]
    found = [(message.place, _diagnostic(lines, names, message)) for message in messages]
    found += [(note.place, _from_note(lines, names, note)) for note in notes(lines, len(names))]
    return [diagnostic for _, diagnostic in sorted(found, key=itemgetter(0))]


def _diagnostic(lines: list[Line], names: Sequence[str], message: Message) -> Diagnostic:
    subject = message.subject.strip()
    advice = _ADVICE[message.code](subject, message.location)
    place = _placed(lines, names, message.place)
    return Diagnostic(message.code, str(message), advice, hint(message.code, subject), *place)


def _from_note(lines: list[Line], names: Sequence[str], note: Note) -> Diagnostic:
    return Diagnostic("", f"note: {note.message}", note.advice, "", *_placed(lines, names, note.place))


def _placed(lines: list[Line], names: Sequence[str], place: Place) -> tuple[str, int, int, int, str]:
    line = lines[place.line]
    start, end = scanner.columns(line, place.statement, place.token)
    return names[line.tape], line.number, start + 1, end - start, line.text


def _undefined(name: str, location: int) -> str:
    value = f"{location | 0o177:04o}"
    where = "the last address of its page"
    return f"undefined: {name} is taken as {value}, {where}; define it with {name}, or {name}="


def _illegal(code: str, location: int) -> str:
    value = int(code, 8)
    if value < 0o200:
        letter = chr(value + 0o100)
        return f"illegal character: the letter {letter} in a number; a symbol begins with a letter"
    return f"illegal character {_spelled(value & 0o177)}: it is passed over; remove it"


def _spelled(character: int) -> str:
    return chr(character) if 0o40 < character < 0o177 else f"(code {character | 0o200:04o})"


def _reference(address: str, location: int) -> str:
    page = location & 0o7600
    low = int(address, 8) & 0o177
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
    "IR": _reference,
}
