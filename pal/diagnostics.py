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
from pal.messages import DIALECT, STOPPED, worded
from pal.notes import ERROR, NOTE, Note, Said, note
from pal.source import Place, Source
from pal.symbols import PSEUDO_OPERATORS, REFERENCES

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
        """The line that editors and CI understand: file, line, column, severity, message."""
        code = f" [{self.code}]" if self.code[2:] else ""
        return f"{self.file}:{self.line}:{self.column}: {self.severity}: {self.message}{code}"

    @property
    def excerpt(self) -> list[str]:
        """The source line, shortened to the screen, with carets below it; "" for an empty line."""
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
        advice = _advice(message, subject, at, source)
        if subject == "0277":
            mark = source.spans[message.at][1]
            advice = advice.replace("?", source.shown[mark : mark + 1])
        said = Note(message.code, at, str(message), advice)
        found.append((ERROR, said, hint(message.code, subject)))
        full |= message.code == "ST"
    if stopped and not full:
        why, at = stopped
        name = source.items[at][0]
        key = "PS01 name" if name in PSEUDO_OPERATORS else STOPPED
        found.append((ERROR, note(key, at, why=why, name=name), ""))
    return [*found, *((NOTE, each, "") for each in notes)]


def empty(names: Sequence[str]) -> Diagnostic:
    """Return the note on a source without a character."""
    file = names[0] if names else "source"
    return Diagnostic(NOTE, *worded("PN27 empty"), "", file, 1, 1, 2, "")


def told(said: Iterable[Said], names: Sequence[str], place_of: Callable[[int], Place]) -> list[Diagnostic]:
    """Return messages and notes as diagnostics, sorted by the places that `place_of` gives."""
    diagnostics: list[tuple[tuple[int, int, int], Diagnostic]] = []
    for severity, (code, at, message, advice), sentence in said:
        place = place_of(at)
        if severity == ERROR or not _silenced(place.text, code):
            end = max(place.end, place.start + 1) + 1
            shown = "" if code == DIALECT else place.text  # it is of the whole source
            where = names[place.tape], place.line, place.start + 1, end, shown
            diagnostic = Diagnostic(severity, code, message.translate(_CONTROLS), advice, sentence, *where)
            diagnostics.append(((place.tape, place.line, place.start), diagnostic))
    return [diagnostic for _, diagnostic in sorted(diagnostics, key=lambda each: each[0])]


def _silenced(text: str, code: str) -> bool:
    """Whether a comment of the line silences the notes of `code`: `/ pal: PN06`."""
    comment = text.partition("/")[2].lower()
    return "pal:" in comment and code.lower() in comment.partition("pal:")[2]


def _reference(source: Source, end: int) -> int:
    """Return the memory-reference symbol of the statement that ends at an item, or that item."""
    statement = reversed(range(source.begun(end), end + 1))
    return next((at for at in statement if source.items[at][0] in REFERENCES), end)


def _advice(message: Message, subject: str, at: int, source: Source) -> str:
    """Return what a message means and what to do about its subject."""
    location = message.location
    if message.code == "IC":
        value = int(subject, 8)
        figure, letter, character = chr(value & 0o177), chr(value + 0o100), _spelled(value & 0o177)
        said = worded(_kind_of_illegal(value), figure=figure, letter=letter, character=character)
    elif message.code == "IR":
        key = "IR negative" if source.items[at + 1 : at + 2] == [("", "-")] else "IR"
        used = location & PAGE | int(subject, 8) & ADDRESS
        said = worded(key, address=subject, location=f"{location:04o}", used=f"{used:04o}")
    elif message.code == "UA":
        key, line = _kind_of_undefined(subject, source)
        said = worded(key, name=subject, value=f"{location | ADDRESS:04o}", line=line)
    else:
        said = worded(message.code, name=subject or "it")
    return f"{said.message}; {said.advice}" if said.advice else said.message


def _kind_of_illegal(value: int) -> str:
    if value > 0o200:
        return "IC"
    if value == 0o200:
        return "IC lost"
    return "IC figure" if value >= 0o60 else "IC letter"


def _kind_of_undefined(name: str, source: Source) -> tuple[str, str]:
    """Return the key of the message on an undefined symbol, and the line where its tag may lack a comma."""
    at = source.bare_tag(name)
    if at is None:
        return "UA", ""
    return "UA EQU" if source.items[at + 1][0] == "EQU" else "UA tag", str(source.place(at).line)


def _spelled(character: int) -> str:
    return chr(character) if chr(character).isprintable() else f"(code {character | 0o200:04o})"
