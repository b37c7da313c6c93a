"""What became of a source in PAL8.

The listing has the form of PAL III's: location, word, source; a `@` marks a word that refers through a link.
"""

import re
from collections.abc import Iterator, Sequence
from functools import cached_property

from pal import punch
from pal.assembler import Written
from pal.assembly import PAL8, Assembly
from pal.listing import UNNUMBERED, ListingLine, Teletype, octal, typed_frames
from pal.messages import UNLOADABLE
from pal.notes import (
    ERROR,
    NOTE,
    Mention,
    Note,
    Said,
    note,
    of_model,
    of_names,
    of_overlays,
    of_undefined,
    of_words,
)
from pal.pal8 import symbols
from pal.pal8.assembler import Assembler
from pal.pal8.lexer import LINE
from pal.source import Place, lines_of, plain
from pal.symbols import SIGNIFICANT

_TOKEN = re.compile(r'[A-Z][A-Z0-9]*|".|/.*|[^\t ]')
_PSEUDO = {name[:SIGNIFICANT] for name in symbols.PSEUDO_OPERATORS}
_FIELDS = ("CDF", "CIF", "CDI")
_INSTRUCTIONS = {**symbols.REFERENCES, **symbols.MARKS, **symbols.INSTRUCTIONS, **symbols.PALBARTS}


class Assembly8(Assembly):
    """What became of a source in PAL8: `wipe` is /W, `exact` DEC's own reading."""

    def __init__(
        self, sources: Sequence[str | bytes], names: Sequence[str], model: str | None, wipe: bool, exact: bool
    ) -> None:
        super().__init__(PAL8, names)
        self._model = model
        self._lines = lines_of(sources)
        self._run = run = Assembler(self._lines, wipe, exact)
        run.run()
        self._log = run.log
        self.errors = [*self._errors(), *run.log.faults]
        self.stopped: tuple[str, int] | None = None
        if run.fatal:
            last = run.log.complaints[len(run.log.complaints) - 1]
            self.stopped = (last.about, last.at)
        if run.fatal:
            self.words = {}
        else:
            self.words = punch.loaded(self.tape) if run.log.faults else punch.words(run.punch.tape)
        self.ok = not self.errors

    def _errors(self) -> list[Note]:
        """Return the messages of pass 2, only the first IC of a statement, and those that only pass 1 has."""
        places = self._log.places
        again = {f"{said.code} {places[said.at][0]}" for said in self._log.complaints if said.number == 2}
        return [
            Note(said.code, said.at, f"{said.code}  {said.about}", said.advice)
            for said in self._log.complaints
            if said.about and (said.number == 2 or f"{said.code} {places[said.at][0]}" not in again)
        ]

    def takes(self, marks: set[str], names: set[str]) -> bool:
        """Whether a line with no error, or only one undefined symbol, has one of these marks or names."""
        wrong: set[int] = set()
        undefined: set[int] = set()
        for error in self.errors:
            index = self._log.places[error.at][0]
            if error.code == "US" and index not in undefined:
                undefined.add(index)
            elif error.code != UNLOADABLE:
                wrong.add(index)
        for index in range(min(self._run.ended, len(self._lines))):
            if index not in wrong:
                for token in _TOKEN.findall(plain(self._lines[index].text)):
                    if token[:1] in marks or token[:SIGNIFICANT] in names:
                        return True
        return False

    @cached_property
    def tape(self) -> bytes:
        return b"" if self._run.fatal else punch.tape(self._run.punch.tape)

    @cached_property
    def symbols(self) -> dict[str, int]:
        known = self._run.table.known
        return {name: known[name].value for name in sorted(known) if known[name].passed}

    @cached_property
    def values(self) -> dict[str, int]:
        known = self._run.table.known
        return {name: symbol.value for name, symbol in known.items() if name not in _PSEUDO}

    @cached_property
    def mentions(self) -> list[Mention]:
        return self._log.mentions

    def first(self) -> int:
        return self._log.line(0)

    @cached_property
    def messages(self) -> list[str]:
        return [f"{said.code}  {said.location}" for said in self._log.complaints]

    def place(self, at: int) -> Place:
        index, start, end = self._log.places[at]
        line = self._lines[index]
        return Place(line.tape, line.number, line.text, start, end)

    def _rows(self) -> Iterator[tuple[Written | None, int, str]]:
        """Yield word, line and text of the listing: the text with the line's first word; literals last."""
        lines = self._lines
        places = self._log.places
        shown = 0  # lines so far
        for written in self._run.punch.written:
            index = places[written.at][0]
            if written.literal:
                continue
            for number in range(shown, index):
                yield None, number, lines[number].text
            yield written, index, lines[index].text if shown <= index else ""
            shown = index + 1
        for number in range(shown, min(self._run.ended + 1, len(lines))):
            yield None, number, lines[number].text
        for written in self._run.punch.written:
            if written.literal:
                yield written, places[written.at][0], ""

    @cached_property
    def lines(self) -> list[ListingLine]:
        rows = []
        for written, index, text in self._rows():
            line = self._lines[index]
            address, word = (written.address, written.word) if written else (None, None)
            rows.append(ListingLine(address, word, text, line.tape, line.number))
        return rows

    def text(self, number: int) -> str:
        if number < 3:
            said = [said for said in self._log.complaints if said.number == number]
            return "".join(f"{one.code}  {one.location}\n" for one in said)
        listed = []
        for written, _, text in self._rows():
            word = UNNUMBERED
            if written is not None:
                word = f"{octal(written.address)}  {octal(written.word)}{'@ ' if written.link else '  '}"
            listed.append((word + text).rstrip())
        table = [f"{name:6}  {value:04o}" for name, value in self.symbols.items()]
        return "\n".join([*listed, "", *table, ""])

    @cached_property
    def teletype(self) -> Teletype:
        return Teletype(*(typed_frames(self.text(number)) for number in (1, 2, 3)))

    def is_empty(self) -> bool:
        return not any(line.text for line in self._lines)

    def said(self) -> list[Said]:
        return [*((ERROR, error, "") for error in self.errors), *((NOTE, each, "") for each in self._notes())]

    def _notes(self) -> list[Note]:
        run = self._run
        full = any(problem.code in ("PE", "ZE") for problem in self.errors)
        notes = [*run.log.notes, *of_words(run.punch.written, _INSTRUCTIONS)]
        if not full:
            punched = [piece for piece in run.punch.tape if isinstance(piece, Written)]
            notes += [each for each in of_overlays(punched) if not self._is_meant(each.at)]
        if self._model:
            named = (each for each in run.punch.written if any(name in _INSTRUCTIONS for name in each.names))
            notes += of_model(named, self._model)
        return notes + self._on_names() + self._of_fields() + self._of_lines() + self._of_the_end()

    def _is_meant(self, at: int) -> bool:
        """Whether the last origin before a place uses a symbol or a point, as overlays do."""
        from bisect import bisect_left

        before = bisect_left(self._origins, self._log.places[at][0] + 1)
        return before > 0 and not self._run.operators.origins[before - 1][1]

    @cached_property
    def _origins(self) -> list[int]:
        return [index for index, _ in self._run.operators.origins]

    def _on_names(self) -> list[Note]:
        """Note what was meant by undefined names, names cut short, and instructions that an 8/L lacks."""
        known = self._run.table.known
        later = {name for name in symbols.NOT_ON_THE_8L if name in known and not known[name].passed}
        asked = {name for name in known if len(name) == SIGNIFICANT or name in later}
        notes = []
        longer = []
        for mention in [mention for mention in self._log.mentions if mention.name in asked]:
            name = mention.name
            if len(name) == SIGNIFICANT:
                longer.append((self._in_full(mention.at), mention.at))
            elif name in later and not mention.defined:
                later.discard(name)  # one note is enough
                notes.append(note("PN37", mention.at, name=name, octal=octal(known[name].value)))
        return [*notes, *self._on_undefined(), *of_names(longer, _INSTRUCTIONS)]

    def _on_undefined(self) -> list[Note]:
        named = {self._named(error) for error in self.errors if "if it is a tag" in error.advice}
        places = []
        for error in self.errors:
            name = self._named(error)
            if name and name not in named and name not in symbols.ELSEWHERE:
                named.add(name)
                places.append((name, error.at, self._statement(error.at)))
        return of_undefined(places, [*self.symbols, *_INSTRUCTIONS])

    def _named(self, error: Note) -> str:
        """Return the significant part of an undefined name, "" for other errors."""
        return self._in_full(error.at)[:SIGNIFICANT] if error.code == "US" else ""

    def _of_fields(self) -> list[Note]:
        """Note the first change to a field beyond 0: without the MC8/L it does nothing."""
        for written in self._run.punch.written:
            word = written.word
            if word & 0o7704 == 0o6200 and word & 0o70 and any(name in _FIELDS for name in written.names):
                return [note("PN37 field", written.at, octal=octal(word), field=str(word >> 3 & 7))]
        return []

    def _of_lines(self) -> list[Note]:
        """Note the first small letter, and each line with code that DEC's PAL8 does not read."""
        notes = []
        small = False
        for index in range(min(self._run.ended, len(self._lines))):
            text = self._lines[index].text
            code = text.partition("/")[0]
            if (
                not small
                and code != code.upper()
                and any("a" <= each <= "z" for each in _TOKEN.findall(text))
            ):
                small = True
                notes.append(note("PN35 PAL8", self._log.line(index)))
            if len(code) > LINE and code[LINE:].strip():
                at = self._log.line(index)
                notes.append(note("PN55", at, length=str(len(text)), most=str(LINE)))
        return notes

    def _statement(self, at: int) -> int:
        """Return a number for the statement at a place: its line and the semicolons before it."""
        index, start, _ = self._log.places[at]
        return index << 10 | self._lines[index].text.count(";", 0, start)

    def _in_full(self, at: int) -> str:
        index, start, end = self._log.places[at]
        return self._lines[index].text[start:end].upper()

    def _of_the_end(self) -> list[Note]:
        run = self._run
        lines = self._lines
        if run.fatal:
            return []
        if run.ended == len(lines):
            at = run.log.line(len(lines) - 1)
            return [note("PN27 PAL8", at)]
        for index in range(run.ended + 1, len(lines)):
            if lines[index].text.strip(" \t"):
                at = run.log.line(index)
                return [note("PN03", at)]
        return []
