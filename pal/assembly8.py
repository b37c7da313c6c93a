"""An assembly in PAL8: with the same names as in PAL III, and PAL8's words and messages.

Its listing has the form of PAL III's: location, word, source; a `@` stands after a word that goes by a link.
"""

from collections.abc import Sequence
from functools import cached_property
from typing import TYPE_CHECKING

from pal import pal8, punch, symbols8
from pal.assembler import Written
from pal.assembly import PAL8, Assembly
from pal.listing import UNNUMBERED, ListingLine, Teletype, octal
from pal.notes import (
    AFTER_END,
    DIALECT,
    NOT_ON_8L,
    OVERLAID,
    Mention,
    Note,
    of_model,
    of_names,
    of_undefined,
    of_words,
)
from pal.source import Place, lines_of, tokens
from pal.symbols import SIGNIFICANT

if TYPE_CHECKING:
    from pal.diagnostics import Diagnostic

TAKEN = "taken for PAL8: it has what PAL III has not"

_MARKS = set('(["<&^%')
_NAMES = {name[:SIGNIFICANT] for name in symbols8.PSEUDO_OPERATORS}
_FIELDS = ("CDF", "CIF", "CDI")
_INSTRUCTIONS = {**symbols8.REFERENCES, **symbols8.INSTRUCTIONS, **symbols8.PALBARTS}


class Assembly8(Assembly):
    """What became of a source in PAL8. `noted` are notes from outside."""

    dialect = PAL8

    def __init__(
        self, sources: Sequence[str | bytes], names: Sequence[str], model: str | None = None
    ) -> None:
        self.model = model
        self.names = names
        self.noted: list[Note] = []
        self._lines = lines_of(sources)
        self._run = run = pal8.Assembler(self._lines)
        run.run(1)
        run.run(2)
        self.stopped = None
        self.words = punch.words(run.output)

    @property
    def ok(self) -> bool:
        """Whether there is no error."""
        return not self._problems

    def takes(self, marks: set[str], names: set[str]) -> bool:
        """Tell whether a line without an error has one of these marks or names."""
        wrong = {self._run.places[problem.at][0] for problem in self._problems}
        for index in range(self._run.ended):
            if index not in wrong:
                for token in tokens(self._lines[index].text):
                    if token[:1] in marks or token[:SIGNIFICANT] in names:
                        return True
        return False

    @cached_property
    def tape(self) -> bytes:
        """The object tape: leader, origins and words as they come, checksum, trailer."""
        return punch.tape(self._run.output)

    @cached_property
    def symbols(self) -> dict[str, int]:
        """The symbols of the source in the order of their names."""
        known = self._run.symbols
        return {name: known[name].value & 0o7777 for name in sorted(known) if known[name].passed}

    @cached_property
    def values(self) -> dict[str, int]:
        """{name: value} of all symbols, the permanent ones included."""
        return {
            name: symbol.value & 0o7777
            for name, symbol in self._run.symbols.items()
            if symbol.kind != pal8.PSEUDO
        }

    @cached_property
    def mentions(self) -> list[Mention]:
        """The symbols where they stand."""
        return self._run.mentions

    def place(self, at: int) -> Place:
        """Return a place of the source."""
        index, start, end = self._run.places[at]
        line = self._lines[index]
        return Place(line.tape, line.number, line.text, start, end)

    @cached_property
    def _rows(self) -> list[tuple[ListingLine, str]]:
        """The listing with the mark of each word: all of a line at its first word, literals at the end."""
        rows: list[tuple[ListingLine, str]] = []
        literals: list[tuple[ListingLine, str]] = []
        last = -1
        for written in self._run.written:
            index = self._run.places[written.at][0]
            line = self._lines[index]
            text = "" if written.literal or index == last else line.text
            row = ListingLine(written.address, written.word, text, line.tape, line.number)
            if written.literal:
                literals.append((row, "  "))
                continue
            rows += [*self._without_word(last + 1, index), (row, "@ " if written.link else "  ")]
            last = index
        return [*rows, *self._without_word(last + 1, self._run.ended + 1), *literals]

    def _without_word(self, first: int, after: int) -> list[tuple[ListingLine, str]]:
        lines = self._lines[first:after]
        return [(ListingLine(None, None, line.text, line.tape, line.number), "") for line in lines]

    @cached_property
    def lines(self) -> list[ListingLine]:
        """The listing by statements; literals stand after the program, where they are put out."""
        return [line for line, _ in self._rows]

    @cached_property
    def listing(self) -> str:
        """The listing with the symbol table, as text."""
        listed = []
        for line, mark in self._rows:
            word = UNNUMBERED
            if line.address is not None and line.word is not None:
                word = f"{octal(line.address)}  {octal(line.word)}{mark}"
            listed.append((word + line.source).rstrip())
        return "\n".join([*listed, "", self.symbol_table])

    def text(self, number: int) -> str:
        """Return what pass 1, 2 or 3 has to show: the symbol table, nothing, the listing."""
        return ("", self.symbol_table, "", self.listing)[number]

    @cached_property
    def teletype(self) -> Teletype:
        """Raise ValueError: the frames of an ASR-33 are PAL III's."""
        raise ValueError("the frames of an ASR-33 are PAL III's alone")

    @cached_property
    def diagnostics(self) -> list["Diagnostic"]:
        """What is wrong, and what to know besides, in source order."""
        from pal.diagnostics import ERROR, NOTE, empty, told

        if not any(line.text for line in self._lines):
            return [empty(self.names)]
        found = [
            (ERROR, each._replace(message=f"{each.code}  {each.message}"), "") for each in self._problems
        ]
        found += [(NOTE, note, "") for note in self._notes()]
        found = sorted(found, key=lambda each: self._run.places[each[1].at])
        return told(found, self.names, self.place)

    @cached_property
    def _problems(self) -> list[Note]:
        """Return the errors: also a word and a literal in the same place."""
        problems = list(self._run.problems)
        if not any(written.literal for written in self._run.written):
            return problems
        cells: dict[int, Written] = {}
        full: set[int] = set()
        for written in self._run.written:
            page = written.address >> 7
            other = cells.get(written.address, written)
            if page not in full and other.literal != written.literal:
                full.add(page)
                at = other.at if written.literal else written.at
                code, which = ("PE", "the current page") if page & 0o37 else ("ZE", "page zero")
                message = f"{which} is full: a literal and a word are both at {written.address:04o}"
                problems.append(Note(code, at, message, "put fewer words on the page"))
            cells[written.address] = written
        return problems

    def _notes(self) -> list[Note]:
        run = self._run
        notes = [*run.notes, *self.noted]
        full = any(problem.code in ("PE", "ZE") for problem in self._problems)
        said = of_words(run.written, _INSTRUCTIONS)
        notes += [note for note in said if note.code != OVERLAID or not full]
        if self.model:
            named = (
                written for written in run.written if any(name in _INSTRUCTIONS for name in written.names)
            )
            notes += of_model(named, self.model)
        return notes + self._on_names() + self._of_fields() + self._of_the_end()

    def _on_names(self) -> list[Note]:
        """Note what was meant by undefined names, names cut short, and instructions that an 8/L has not."""
        run = self._run
        notes = []
        told: set[str] = set()
        known = list(self.symbols)
        longer = []
        undefined: list[tuple[str, int]] = []
        noteworthy = {name for name, symbol in run.symbols.items() if self._is_noteworthy(symbol)}
        for mention in run.mentions:
            if mention.name not in noteworthy or mention.name in told:
                continue
            symbol = run.symbols[mention.name]
            if symbol.kind == pal8.UNKNOWN:
                told.add(mention.name)
                if mention.name not in symbols8.ELSEWHERE:
                    undefined.append((mention.name, mention.at))
            elif symbol.kind == pal8.INSTRUCTION and not mention.defined:
                told.add(mention.name)
                message = f"{mention.name}, {symbol.value:04o}, is no instruction of a PDP-8/L"
                notes.append(Note(NOT_ON_8L, mention.at, message, "it does nothing there, or something else"))
            elif len(mention.name) == SIGNIFICANT:
                longer.append((self._in_full(mention.at), mention.at))
        places = [(name, at, self._statement(at)) for name, at in undefined]
        notes += of_undefined(places, [*known, *_INSTRUCTIONS])
        return notes + of_names(longer, _INSTRUCTIONS)

    def _of_fields(self) -> list[Note]:
        """Note the first change to a field beyond 0: without the MC8/L it does nothing."""
        for written in self._run.written:
            field = written.word >> 3 & 7
            if field and written.word & 0o7704 == 0o6200 and any(name in _FIELDS for name in written.names):
                message = f"{written.word:04o} is for field {field}, which a PDP-8/L of 4K has not"
                return [Note(NOT_ON_8L, written.at, message, "without the MC8/L it does nothing")]
        return []

    @staticmethod
    def _is_noteworthy(symbol: pal8.Symbol) -> bool:
        if symbol.kind == pal8.INSTRUCTION:
            return symbol.name in symbols8.NOT_ON_THE_8L
        return symbol.kind == pal8.UNKNOWN or len(symbol.name) == SIGNIFICANT

    def _statement(self, at: int) -> int:
        """Return a number for the statement at a place: its line and the semicolons before it."""
        index, start, _ = self._run.places[at]
        return index << 10 | self._lines[index].text.count(";", 0, start)

    def _in_full(self, at: int) -> str:
        index, start, end = self._run.places[at]
        return self._lines[index].text[start:end].upper()

    def _of_the_end(self) -> list[Note]:
        run = self._run
        lines = self._lines
        if any(problem.code == "PH" for problem in run.problems):
            return []
        if run.ended == len(lines):
            at = run.place_of_line(len(lines) - 1)
            return [Note("PN27", at, "no $ at the end", "DEC's PAL8 supplies it; palbart asks for it")]
        for index in range(run.ended + 1, len(lines)):
            if lines[index].text.strip(" \t\f"):
                at = run.place_of_line(index)
                return [Note(AFTER_END, at, "text after $ is not read", "put the $ at the end")]
        return []


def found(assembly: Assembly, sources: Sequence[str | bytes]) -> Assembly:
    """Return a source in error as PAL8, if it has half as many errors there, and a line of PAL8's alone.

    That line has what PAL III refuses, an operator or a pseudo-operator of PAL8, and no error in PAL8.
    """
    illegal = {chr(int(said.subject, 8) & 0o177) for said in assembly.messages if said.code == "IC"} & _MARKS
    undefined = {said.subject.strip() for said in assembly.messages if said.code == "UA"} & _NAMES
    if not illegal and not undefined:
        return assembly
    other = Assembly8(sources, assembly.names, assembly.model)
    if 2 * len(other._problems) > len(assembly.messages) or not other.takes(illegal, undefined):
        return assembly
    at = other._run.place_of_line(0)
    other.noted.append(Note(DIALECT, at, TAKEN, "--dialect pal8 says so, --dialect pal3 keeps to PAL III"))
    return other
