"""PAL III, noting where a source means something else than it says.

PAL III itself says nothing there, and the tape is the same. `Watched` is the assembler with notes that are
found in the passes that run anyway; `pal.review` adds what the source
and the words show. A source of which there is nothing to note never loads `pal.notes`.
"""

from typing import TYPE_CHECKING

from pal.assembler import Assembler, Output
from pal.isa import ADDRESS, INDIRECT, PAGE
from pal.source import ENDS, Source
from pal.symbols import PERMANENT, PSEUDO_OPERATORS, REFERENCES, SIGNIFICANT, spelled
from pal.table import ENTRY, PSEUDO, UNDEFINED, VALUE

if TYPE_CHECKING:
    from pal.notes import Note

NAMES = {*(symbol.mnemonic for symbol in PERMANENT), *(name[:SIGNIFICANT] for name in PSEUDO_OPERATORS)}


class Watched(Assembler):
    """The assembler with its `notes`, and the item at which it `ended`.

    moved     whether an assignment in pass 2 gave another value, so that pass 3 may differ
    cuts      whether a name has more than six characters
    """

    def __init__(self, source: Source, capacity: int) -> None:
        super().__init__(source, capacity)
        self._source = source
        self.notes: list[Note] = []
        self.moved = False
        self.cuts = False
        self._twice: set[int] = set()
        self._assigned: int | None = None
        self._expunged: int | None = None
        self._swallowed: tuple[int, str] | None = None
        self._kept: int | None = None

    def run(self, number: int) -> Output:
        """Run a pass, then look at how 1 and 2 ended."""
        output = super().run(number)
        if self.stopped or number == 3:
            return output
        self.ended = self._at
        references_grow = self._symbols.boundary > self._symbols.end and self.table
        if number == 1 and self._expunged is not None and references_grow:
            self._add("PN22 FIXMRI", self._expunged)
        if number == 2 and self._symbols.full:
            last = self._symbols.end - ENTRY
            name = spelled(self._symbols.name(last))
            self._add("PN29", self._seen[last], name=name)
        if self._made:
            self._note("PN27 lost", self._at)
        return output

    def _note(self, key: str, at: int, **values: str) -> None:
        """Note something once, in pass 2, when all values are known."""
        if self._number == 2:
            self._add(key, at, **values)

    def _add(self, key: str, at: int, **values: str) -> None:
        from pal.notes import note

        self.notes.append(note(key, at, **values))

    @property
    def _name(self) -> str:
        return self._items[self._at][0]

    @property
    def _has_symbol(self) -> bool:
        """Whether a symbol comes before the mark just read, perhaps with blanks between."""
        at, begun = self._at, self._source.begun(self._at)
        while at > begun and not self._items[at][0] and self._items[at - 1][1] in " \t":
            at -= 1
        return self._items[at][0][:1].isalpha()

    @property
    def _so_far(self) -> int:
        return self._word | self._address

    def _say(self, code: str, subject: str) -> None:
        super()._say(code, subject)
        if code in ("DT", "RD"):
            self._twice.add(self._pointer)

    def _see_moved(self) -> None:
        self.moved = True

    def _see_long(self) -> None:
        self.cuts = True

    def _see_point(self) -> None:
        if self._name:
            self._note("PN18", self._at, sign="+" if self._operator == 1 else "-", name=self._name)

    def _see_number(self, value: int) -> None:
        name = self._name
        if value:
            self._note("PN04", self._at, number=name, word=f"{value & 0o7777:04o}")
        elif name.isdigit() and self._radix == 8 and int(max(name)) > 7:
            self._note("PN05", self._at, number=name)

    def _see_lost(self) -> None:
        at = self._at
        mark = self._items[at][1]
        after, point = self._items[at + 1] if mark in " \t" else ("", "")
        if (after or point == ".") and self._items[at - 1][1] in "+-":
            self._note("PN17", at)

    def _see_before(self, pointer: int) -> None:
        if pointer >= PSEUDO and self._kept is None:
            self._note("PN15", self._at, name=self._name)

    def _see_reference(self) -> None:
        items = self._items[self._source.begun(self._at) : self._at + 1]
        if self._word == INDIRECT and not any(item in REFERENCES for item, _ in items):
            self._note("PN16", self._at)
        page = self._address & PAGE
        if self._zero and page and page == self._location & PAGE:
            target, address = f"{self._address & ADDRESS:04o}", f"{self._address:04o}"
            self._note("PN14", self._at, target=target, address=address)

    def _see_word(self) -> None:
        swallowed, kept = self._swallowed, self._kept
        self._swallowed = self._kept = None
        if swallowed and not self._made:
            at, name = swallowed
            self._note("PN13 Z" if name == "Z" else "PN13", at, name=name)
        if kept is not None and self._made:
            self._note("PN10", kept)

    def _see_pseudo(self, pointer: int) -> None:
        routine = list(PSEUDO_OPERATORS)[pointer // ENTRY]
        if self._number == 1 and routine == "EXPUNGE":
            self._expunged = self._at
            if self._symbols.end > self._symbols.first:
                self._add("PN22", self._at)
        if self._number == 1 and routine == "FIXTAB":
            self._look_at_undefined()
        if routine not in ("I", "FIELD", "FIXMRI") and self._so_far:
            self._swallowed = self._at, routine
            self._doubtful = True
        if routine not in ("FIELD", "FIXMRI"):
            return
        mark = self._items[self._at][1]
        if mark not in " \t":
            what = "the next statement" if mark in ENDS else f"what follows the {mark}"
            self._note("PN20", self._at, name=routine, what=what)
        if routine == "FIELD" and self._so_far:
            self._see_operand()

    def _see_operand(self) -> None:
        self._note("PN19", self._at, word=f"{self._so_far:04o}")

    def _look_at_undefined(self) -> None:
        words = self._symbols.words
        entries = range(self._symbols.first, self._symbols.end, ENTRY)
        names = [spelled(self._symbols.name(entry)) for entry in entries if words[entry] & UNDEFINED]
        if names:
            self._add("PN23", self._at, names=" ".join(names))

    def _see_tag(self) -> None:
        if self._so_far:
            self._kept = self._at
            self._doubtful = True
        if not self._has_symbol:
            self._note("PN11", self._at, mark="comma")
        name = self._name[:SIGNIFICANT]
        if name in NAMES:
            self._note("PN30", self._at, name=name)
            return
        value = self._symbols.word(self._pointer + VALUE)
        if name[:1].isalpha() and value != self._location and self._pointer not in self._twice:
            location = f"{self._location:04o}"
            self._note("PN25", self._at, name=name, value=f"{value:04o}", location=location)

    def _see_equals(self, pointer: int) -> None:
        if not self._has_symbol:
            self._note("PN11", self._at, mark="equals sign")
        elif self._so_far:
            self._note("PN12", self._at, word=f"{self._so_far:04o}")
        elif self._name[:SIGNIFICANT] in NAMES:
            self._note("PN30 value", self._at, name=self._name)
        self._assigned = pointer

    def _see_star(self) -> None:
        if self._name:
            self._note("PN19 name", self._at, name=self._name)
        elif self._so_far:
            self._see_operand()

    def _act_upon(self, routine: str) -> None:
        boundary = self._symbols.boundary
        super()._act_upon(routine)
        moved = self._symbols.boundary
        if moved == boundary or moved - ENTRY == self._assigned:
            return
        name = spelled(self._symbols.name(moved - ENTRY))
        self._add("PN21", self._at, name=name)

    def _lose(self) -> None:
        super()._lose()
        first, after = self.lost[-1]
        if any(name or mark not in " \t\r" for name, mark in self._items[first:after]):
            self._note("PN26", self._at)
