"""Where a source means something else to PAL III than it says.

PAL III is silent here, and the tape is the same; a person would rather know. `Watched` is the assembler
itself, run once more, which notes what it comes across.
"""

from typing import NamedTuple

from pal.assembler import WORD, Assembler, Listed, Message, Punched
from pal.isa import ADDRESS, PAGE
from pal.listing import LONGEST
from pal.source import Source
from pal.symbols import PSEUDO_OPERATORS, spelled
from pal.table import ENTRY, PSEUDO, UNDEFINED, VALUE

_POINTER = "PAL III takes the symbol it looked up last; write the symbol directly before"
_LOST_OPERATOR = "a space is an operator too, and the last one counts; leave no space after + or -"


class Note(NamedTuple):
    """What is to be noted, at which item, and what to do."""

    at: int
    message: str
    advice: str


def notes(source: Source, tapes: int, capacity: int) -> list[Note]:
    """Return what is to be noted of a source of so many tapes."""
    watched = Watched(source, capacity)
    for number in (1, 2, 3):
        watched.run(number)
        if watched.stopped:
            return watched.notes
    ended = watched.ended
    return [
        *watched.notes,
        *_lost_operators(source.items[:ended]),
        *_overlong(source, ended),
        *_of_the_end(source, tapes, ended),
    ]


def _overlong(source: Source, ended: int) -> list[Note]:
    """Note the first line that pass 3 has no room for."""
    if max(map(len, source.text.split("\r"))) <= LONGEST:
        return []
    start = 0
    for at, (_, mark) in enumerate(source.items[:ended]):
        end = source.spans[at][1]
        if mark == "\r" and end - start > LONGEST:
            message = f"a line of {end - start} characters: pass 3 has room for {LONGEST}"
            return [Note(at, message, "the tape is good, the listing is not; break the line")]
        if mark == "\r":
            start = end + 1
    return []


def _lost_operators(items: list[tuple[str, str]]) -> list[Note]:
    return [
        Note(at, "this makes an inclusive OR of it", _LOST_OPERATOR)
        for at, (before, blank, after) in enumerate(zip(items, items[1:], items[2:], strict=False), 1)
        if before[1] in "+-" and blank[0] == "" and blank[1] in " \t" and (after[0] or after[1] == ".")
    ]


def _of_the_end(source: Source, tapes: int, ended: int) -> list[Note]:
    if ended == len(source.items) - 1:
        advice = "PAL III would wait for more tape; it is taken as if there were one"
        return [Note(max(ended - 1, 0), "no $ at the end", advice)]
    unread = tapes - 1 - source.place(ended).tape
    if not unread:
        return []
    message = f"{unread} more tape{'s' * (unread > 1)} not read"
    return [Note(ended, message, "$ ends the source; on a tape that others follow, PAUSE stands instead")]


class Watched(Assembler):
    """The assembler with an eye on what it makes of a source: `notes`, and the item where it `ended`."""

    def __init__(self, source: Source, capacity: int) -> None:
        super().__init__(source, capacity)
        self.notes: list[Note] = []
        self.ended = 0
        self._twice: set[int] = set()
        self._assigned = 0
        self._expunged: int | None = None
        self._on_tape: list[int] = []

    def run(self, number: int) -> list[Message | Punched | Listed]:
        """Run a pass, then look at what it made."""
        output = super().run(number)
        if self.stopped:
            return output
        self.ended = self._at
        if number == 1:
            self._look_at_references()
        elif number == 2:
            punched = [piece for piece in output if isinstance(piece, Punched)]
            self._on_tape = [piece.value for piece in punched if piece.kind == WORD]
            if self._made or self._applied:
                self._note("what stands before this $ is lost", "put the $ on its own line")
        else:
            self._compare([piece for piece in output if isinstance(piece, Listed) and piece.word is not None])
        return output

    def _look_at_references(self) -> None:
        if self._expunged is not None and self._symbols.boundary > self._symbols.end and self.table:
            advice = "define the memory references first after EXPUNGE, each with FIXMRI"
            message = "with EXPUNGE and no FIXMRI every symbol is a memory reference"
            self.notes.append(Note(self._expunged, message, advice))

    def _compare(self, listed: list[Listed]) -> None:
        """Note the first word that pass 2 and pass 3 see differently."""
        for piece, word in zip(listed, self._on_tape, strict=False):
            if piece.word != word:
                message = f"this is {word:04o} on the tape and {piece.word:04o} in the listing"
                advice = "each pass assigns again, with the values that the last one left"
                self.notes.append(Note(piece.at, message, advice))
                return

    def _note(self, message: str, advice: str) -> None:
        """Note something once, in pass 2, when all values are known."""
        if self._number == 2:
            self.notes.append(Note(self._at, message, advice))

    @property
    def _name(self) -> str:
        return self._items[self._at][0]

    @property
    def _has_symbol(self) -> bool:
        """Whether a symbol stands before the mark just read, if with blanks between."""
        at = self._at
        while at > self._begun and not self._items[at][0] and self._items[at - 1][1] in " \t":
            at -= 1
        return self._items[at][0][:1] > "9"

    @property
    def _so_far(self) -> int:
        return self._word | self._address

    def _clear(self) -> None:
        super()._clear()
        self._begun = self._at + 1
        self._applied = self._operated = False
        self._swallowed: tuple[int, str] | None = None
        self._kept: int | None = None

    def _say(self, code: str, subject: str) -> None:
        super()._say(code, subject)
        if code in ("DT", "RD"):
            self._twice.add(self._pointer)

    def _act(self, mark: str) -> bool:
        routine = list(PSEUDO_OPERATORS)[self._pointer // ENTRY]
        if self._number == 1 and routine == "EXPUNGE":
            self._look_at_forgotten()
        if self._number == 1 and routine == "FIXTAB":
            self._look_at_undefined()
        if self._applied and routine not in ("I", "FIELD", "FIXMRI"):
            self._swallowed = self._at, routine
        if routine in ("FIELD", "FIXMRI") and mark not in " \t":
            what = "the next statement" if mark in "\r;" else f"what follows the {mark}"
            self._note(f"{routine} takes {what}", f"write a space and the operand after {routine}")
        return super()._act(mark)

    def _look_at_forgotten(self) -> None:
        self._expunged = self._at
        if self._symbols.end > self._symbols.first:
            message = "EXPUNGE forgets the symbols that the source has used before"
            self.notes.append(Note(self._at, message, "put it first"))

    def _look_at_undefined(self) -> None:
        words = self._symbols.words
        entries = range(self._symbols.first, self._symbols.end, ENTRY)
        names = [spelled(self._symbols.name(entry)) for entry in entries if words[entry] & UNDEFINED]
        if names:
            message = f"FIXTAB keeps what is not defined yet: {' '.join(names)}"
            advice = "it is in no symbol table and gets no UA; put FIXTAB after the definitions"
            self.notes.append(Note(self._at, message, advice))

    def _apply(self) -> None:
        if self._refers and self._pointer >= PSEUDO:
            self._operated = True
            if self._address and self._kept is None:
                self._note(
                    f"what stands before {self._name} is part of its address",
                    "write what belongs to the address after the instruction, and nothing else beside it",
                )
        self._applied = True
        super()._apply()

    def _point(self) -> None:
        if self._made and self._operator and self._name:
            sign = "+" if self._operator > 0 else "-"
            message = f"the {sign} is used for {self._name} and for the location"
            self._note(message, "write the location first, or a space before the point")
        super()._point()

    def _make_word(self) -> None:
        if self._referring and not self._operated:
            message = "I without a memory-reference symbol makes an AND"
            self._note(message, "write the instruction before I")
        page = self._address & PAGE
        if self._referring and self._zeros and page == self._location & PAGE != 0:
            message = f"Z makes this refer to {self._address & ADDRESS:04o} on page zero"
            self._note(message, f"for {self._address:04o}, on this page, leave out Z")
        super()._make_word()

    def _write(self) -> None:
        swallowed = self._swallowed
        if self._number == 2 and swallowed and not self._made:
            message = f"{swallowed[1]} at the end of a statement leaves no word"
            advice = "put it on its own line" if swallowed[1] != "Z" else "write Z before the address"
            self.notes.append(Note(swallowed[0], message, advice))
        if self._number == 2 and self._kept is not None and self._made:
            message = "what stands before this comma is part of the word"
            advice = "a space puts even the tag there; write the tag first, the comma directly after it"
            self.notes.append(Note(self._kept, message, advice))
        super()._write()

    def _tag(self) -> None:
        if self._so_far:
            self._kept = self._at
        if not self._has_symbol:
            self._note("no symbol stands before this comma", _POINTER)
        value = self._symbols.word(self._pointer + VALUE)
        if self._name[:1] > "9" and value != self._location and self._pointer not in self._twice:
            message = f"{self._name} is {value:04o} from pass 1, and stands at {self._location:04o} in pass 2"
            self._note(message, "an origin depends on a symbol that is defined after it; define it first")
        super()._tag()

    def _assign(self) -> None:
        if not self._has_symbol:
            self._note("no symbol stands before this equals sign", _POINTER)
        elif self._so_far:
            message = f"what stands before the equals sign, {self._so_far:04o}, is part of the value"
            self._note(message, "a space puts even the symbol there; write the equals sign directly after it")
        self._assigned = self._pointer
        super()._assign()

    def _wait(self, kind: str, pointer: int) -> None:
        if kind == "*" and self._name:
            self._note(f"{self._name} before the asterisk has no effect", "put the origin on its own line")
        elif kind in ("*", "FIELD") and self._so_far:
            message = f"what stands before it, {self._so_far:04o}, is part of the operand"
            self._note(message, "put it on its own line")
        super()._wait(kind, pointer)

    def _act_upon(self, routine: str) -> None:
        boundary = self._symbols.boundary
        super()._act_upon(routine)
        moved = self._symbols.boundary
        if moved == boundary or moved == self._assigned + ENTRY:
            return
        name = spelled(self._symbols.name(moved - ENTRY))
        message = f"FIXMRI makes {name} a memory reference, whatever it defines"
        self.notes.append(Note(self._at, message, "use it for the first definitions after EXPUNGE"))

    def _lose(self) -> None:
        super()._lose()
        first, after = self.lost[-1]
        if any(name or mark not in " \t\r" for name, mark in self._items[first:after]):
            self._note("what follows PAUSE on its line is lost", "end the line after PAUSE")
