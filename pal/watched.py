"""PAL III with an eye on what it makes of a source that means something else than it says.

PAL III is silent there, and the tape is the same; a person would rather know. `Watched` is the assembler
itself, which notes what it comes across in the passes that run anyway; `notes` adds what is to be seen in the
source and in the words.
"""

from collections.abc import Sequence

from pal.assembler import Assembler, Entry, Listed, Message, Punched, Written
from pal.dialects import hint
from pal.isa import ADDRESS, INDIRECT, PAGE
from pal.listing import LONGEST
from pal.notes import (
    AFTER_END,
    COLON,
    LOWER_CASE,
    NO_SLASH,
    NOT_IN_TABLE,
    NOT_OCTAL,
    RESERVED,
    TOO_LARGE,
    Note,
    of_names,
    of_undefined,
    of_words,
)
from pal.source import Source
from pal.symbols import PERMANENT, PSEUDO_OPERATORS, SIGNIFICANT, spelled
from pal.symbols8 import INSTRUCTIONS
from pal.table import ENTRY, PSEUDO, UNDEFINED, VALUE

_POINTER = "PAL III takes the symbol it looked up last; write the symbol directly before"
_INSTRUCTIONS = {symbol.mnemonic: symbol.octal for symbol in PERMANENT}
_NAMES = {*_INSTRUCTIONS, *(name[:SIGNIFICANT] for name in PSEUDO_OPERATORS)}
_REFERENCES = {symbol.mnemonic for symbol in PERMANENT if symbol.memory_reference}


class Watched(Assembler):
    """The assembler with an eye on what it makes of a source: `notes`, and the item where it `ended`.

    moved     whether an assignment in pass 2 gave another value, so that pass 3 may differ
    cuts      whether a name has more than six characters
    """

    def __init__(self, source: Source, capacity: int) -> None:
        super().__init__(source, capacity)
        self.notes: list[Note] = []
        self.ended = 0
        self.moved = False
        self.cuts = False
        self._twice: set[int] = set()
        self._assigned = 0
        self._expunged: int | None = None
        self._swallowed: tuple[int, str] | None = None
        self._kept: int | None = None

    def run(self, number: int) -> list[Message | Punched | Written | Listed]:
        """Run a pass, then look at how it ended."""
        output = super().run(number)
        if self.stopped:
            return output
        self.ended = self._at
        if number == 1 and self._expunged is not None:
            self._look_at_references()
        if number == 2 and self._symbols.full:
            last = self._symbols.end - ENTRY
            name = spelled(self._symbols.name(last))
            message = f"the symbol table is just full: in the listing {name} is 0212"
            advice = "the buffer of pass 3 begins at its value; use one symbol fewer"
            self.notes.append(Note("PN29", self._seen[last], message, advice))
        if number == 2 and self._made:
            self._note("PN27", "what stands before this $ is lost", "put the $ on its own line")
        return output

    def _look_at_references(self) -> None:
        if self._expunged is not None and self._symbols.boundary > self._symbols.end and self.table:
            advice = "define the memory references first after EXPUNGE, each with FIXMRI"
            message = "with EXPUNGE and no FIXMRI every symbol is a memory reference"
            self.notes.append(Note("PN22", self._expunged, message, advice))

    def _note(self, code: str, message: str, advice: str) -> None:
        """Note something once, in pass 2, when all values are known."""
        if self._number == 2:
            self.notes.append(Note(code, self._at, message, advice))

    @property
    def _name(self) -> str:
        return self._items[self._at][0]

    @property
    def _begun(self) -> int:
        """The first item of the statement."""
        at = self._at
        while at and self._items[at - 1][1] not in "\r;":
            at -= 1
        return at

    @property
    def _has_symbol(self) -> bool:
        """Whether a symbol stands before the mark just read, if with blanks between."""
        at, begun = self._at, self._begun
        while at > begun and not self._items[at][0] and self._items[at - 1][1] in " \t":
            at -= 1
        return self._items[at][0][:1] > "9"

    @property
    def _so_far(self) -> int:
        return self._word | self._address

    def _say(self, code: str, subject: str) -> None:
        super()._say(code, subject)
        if code in ("DT", "RD"):
            self._twice.add(self._pointer)

    def _watch(self, what: str, pointer: int) -> None:
        if what == "before":
            self._see_before(pointer)
        elif what == "reference":
            self._see_reference()
        elif what == "word":
            self._see_word()
        elif what == "pseudo":
            self._see_pseudo(list(PSEUDO_OPERATORS)[pointer // ENTRY])
        elif what == "tag":
            self._see_tag()
        elif what == "equals":
            self._see_equals(pointer)
        elif what == "star":
            self._see_star()
        elif what == "moved":
            self.moved = True
        elif what == "long":
            self.cuts = True
        elif what == "lost":
            self._see_lost()
        elif what == "number":
            self._see_number(pointer)
        elif what == "point" and self._name:
            sign = "+" if self._operator > 0 else "-"
            message = f"the {sign} is used for {self._name} and for the location"
            self._note("PN18", message, "write the location first, or a space before the point")

    def _see_number(self, value: int) -> None:
        """Note a number that does not fit, or has an 8 or 9 in octal."""
        name = self._name
        if value:
            message = f"{name} does not fit into twelve bits: it is {value & 0o7777:04o}"
            self._note(TOO_LARGE, message, "the most is 7777 octal, 4095 decimal")
        elif name.isdigit():
            message = f"{name} is octal here, and has an 8 or a 9"
            self._note(NOT_OCTAL, message, "DECIMAL before it makes it decimal")

    def _see_lost(self) -> None:
        """Note an operator with a space after it."""
        at = self._at
        mark = self._items[at][1]
        after, point = self._items[at + 1] if mark in " \t" else ("", "")
        if (after or point == ".") and self._items[at - 1][1] in "+-":
            advice = "a space is an operator too, and the last one counts; leave no space after + or -"
            self._note("PN17", "this makes an inclusive OR of it", advice)

    def _see_before(self, pointer: int) -> None:
        if pointer >= PSEUDO and self._kept is None:
            advice = "write what belongs to the address after the instruction, and nothing else beside it"
            self._note("PN15", f"what stands before {self._name} is part of its address", advice)

    def _see_reference(self) -> None:
        """Look at a memory reference of operation 0400, or with a Z and another page."""
        items = self._items[self._begun : self._at + 1]
        if self._word == INDIRECT and not any(item in _REFERENCES for item, _ in items):
            self._note(
                "PN16", "I without a memory-reference symbol makes an AND", "write the instruction before I"
            )
        page = self._address & PAGE
        if self._zeros and page and page == self._location & PAGE:
            message = f"Z makes this refer to {self._address & ADDRESS:04o} on page zero"
            self._note("PN14", message, f"for {self._address:04o}, on this page, leave out Z")

    def _see_word(self) -> None:
        """Look at a statement that was doubtful."""
        swallowed, kept = self._swallowed, self._kept
        self._swallowed = self._kept = None
        if self._number != 2:
            return
        if swallowed and not self._made:
            message = f"{swallowed[1]} at the end of a statement leaves no word"
            advice = "put it on its own line" if swallowed[1] != "Z" else "write Z before the address"
            self.notes.append(Note("PN13", swallowed[0], message, advice))
        if kept is not None and self._made:
            message = "what stands before this comma is part of the word"
            advice = "a space puts even the tag there; write the tag first, the comma directly after it"
            self.notes.append(Note("PN10", kept, message, advice))

    def _see_pseudo(self, routine: str) -> None:
        if self._number == 1 and routine == "EXPUNGE":
            self._look_at_forgotten()
        if self._number == 1 and routine == "FIXTAB":
            self._look_at_undefined()
        if routine not in ("I", "FIELD", "FIXMRI") and self._so_far:
            self._swallowed = self._at, routine
            self._doubtful = True
        if routine not in ("FIELD", "FIXMRI"):
            return
        mark = self._items[self._at][1]
        if mark not in " \t":
            what = "the next statement" if mark in "\r;" else f"what follows the {mark}"
            self._note("PN20", f"{routine} takes {what}", f"write a space and the operand after {routine}")
        if routine == "FIELD" and self._so_far:
            self._see_operand()

    def _see_operand(self) -> None:
        message = f"what stands before it, {self._so_far:04o}, is part of the operand"
        self._note("PN19", message, "put it on its own line")

    def _look_at_forgotten(self) -> None:
        self._expunged = self._at
        if self._symbols.end > self._symbols.first:
            message = "EXPUNGE forgets the symbols that the source has used before"
            self.notes.append(Note("PN22", self._at, message, "put it first"))

    def _look_at_undefined(self) -> None:
        words = self._symbols.words
        entries = range(self._symbols.first, self._symbols.end, ENTRY)
        names = [spelled(self._symbols.name(entry)) for entry in entries if words[entry] & UNDEFINED]
        if names:
            message = f"FIXTAB keeps what is not defined yet: {' '.join(names)}"
            advice = "it is in no symbol table and gets no UA; put FIXTAB after the definitions"
            self.notes.append(Note("PN23", self._at, message, advice))

    def _see_tag(self) -> None:
        if self._so_far:
            self._kept = self._at
            self._doubtful = True
        if self._number != 2:
            return
        if not self._has_symbol:
            self._note("PN11", "no symbol stands before this comma", _POINTER)
        name = self._name[:SIGNIFICANT]
        if name in _NAMES:
            message = f"{name} is a permanent symbol, and keeps its value"
            self._note(RESERVED, message, "give the tag another name")
            return
        value = self._symbols.word(self._pointer + VALUE)
        if name[:1] > "9" and value != self._location and self._pointer not in self._twice:
            message = f"{name} is {value:04o} from pass 1, and stands at {self._location:04o} in pass 2"
            self._note(
                "PN25", message, "an origin depends on a symbol that is defined after it; define it first"
            )

    def _see_equals(self, pointer: int) -> None:
        if not self._has_symbol:
            self._note("PN11", "no symbol stands before this equals sign", _POINTER)
        elif self._so_far:
            message = f"what stands before the equals sign, {self._so_far:04o}, is part of the value"
            advice = "a space puts even the symbol there; write the equals sign directly after it"
            self._note("PN12", message, advice)
        elif self._number == 2 and self._name[:SIGNIFICANT] in _NAMES:
            message = f"{self._name} is a permanent symbol, and has another value from here on"
            self._note(RESERVED, message, "give the symbol another name")
        self._assigned = pointer

    def _see_star(self) -> None:
        if self._name:
            self._note(
                "PN19", f"{self._name} before the asterisk has no effect", "put the origin on its own line"
            )
        elif self._so_far:
            self._see_operand()

    def _act_upon(self, routine: str) -> None:
        boundary = self._symbols.boundary
        super()._act_upon(routine)
        moved = self._symbols.boundary
        if moved == boundary or moved == self._assigned + ENTRY:
            return
        name = spelled(self._symbols.name(moved - ENTRY))
        message = f"FIXMRI makes {name} a memory reference, whatever it defines"
        self.notes.append(Note("PN21", self._at, message, "use it for the first definitions after EXPUNGE"))

    def _lose(self) -> None:
        super()._lose()
        first, after = self.lost[-1]
        if any(name or mark not in " \t\r" for name, mark in self._items[first:after]):
            self._note("PN26", "what follows PAUSE on its line is lost", "end the line after PAUSE")


def notes(
    source: Source,
    tapes: int,
    watched: Watched,
    messages: Sequence[Message],
    punched: Sequence[Message | Punched | Written | Listed],
    table: Sequence[Entry],
) -> list[Note]:
    """Return what is to be noted of a source of so many tapes, after passes 1 and 2.

    `messages` are theirs, `punched` is what pass 2 punched, `table` the symbols as pass 1 left them.
    """
    found = list(watched.notes)
    if watched.stopped:
        return found
    ended = watched.ended
    items = source.items
    words = [piece for piece in punched if isinstance(piece, Written)]
    found += [note._replace(at=_first_symbol(items, note.at)) for note in of_words(words, _INSTRUCTIONS)]
    undefined = [entry for entry in table if not entry.defined]
    if undefined:
        found += _undefined(source, undefined, [entry.name for entry in table if entry.defined])
    if watched.cuts:
        long = [(item, at) for at, (item, _) in enumerate(items[:ended]) if len(item) >= SIGNIFICANT]
        found += of_names([(item, at) for item, at in long if item > ":"], _NAMES)
    return [
        *found,
        *_illegal(source, messages),
        *_overlong(source, ended),
        *_of_the_end(source, tapes, ended),
    ]


def _first_symbol(items: list[tuple[str, str]], end: int) -> int:
    """Return the first symbol but a tag of the statement that ends at `end`; `end` where there is none."""
    first = at = end
    while True:
        item, mark = items[at]
        if item > ":" and mark != ",":
            first = at
        at -= 1
        if at < 0 or items[at][1] in "\r;":
            return first


def _undefined(source: Source, table: list[Entry], known: list[str]) -> list[Note]:
    """Note undefined symbols that another PDP-8 has, that are misspelled, or that are text."""
    notes = []
    others = []
    names = {*_NAMES, *(entry.name for entry in table)}
    for entry in sorted(table, key=lambda entry: entry.at):
        octal = INSTRUCTIONS.get(entry.name)
        if octal is not None:
            message = f"{entry.name} is not in PAL III's table; it is {octal:04o}"
            notes.append(Note(NOT_IN_TABLE, entry.at, message, f"define it: {entry.name}={octal:04o}"))
        elif not hint("UA", entry.name):
            before, blank = source.items[entry.at - 1] if entry.at else ("", "")
            if blank in (" ", "\t") and before and before[:SIGNIFICANT] not in names:
                notes.append(Note(NO_SLASH, entry.at, "this reads as text", "a comment begins with a slash"))
                continue
            end = entry.at
            while source.items[end][1] not in "\r;$":
                end += 1
            others.append((entry.name, entry.at, end))
    return notes + of_undefined(others, [*known, *_INSTRUCTIONS])


def _illegal(source: Source, messages: Sequence[Message]) -> list[Note]:
    """Note colons after tags, and the first of the small letters."""
    illegal = [(chr(int(said.subject, 8) & 0o177), said.at) for said in messages if said.code == "IC"]
    notes = [
        Note(COLON, at, "a colon ends no tag in PAL III", "write a comma after a tag, as in A,")
        for character, at in illegal
        if character == ":" and source.items[at][0]
    ]
    small = [at for character, at in illegal if "a" <= character <= "z"]
    if small:
        message = f"small letters are illegal characters in PAL III: {len(small):,} of them"
        notes.append(Note(LOWER_CASE, small[0], message, "--modern reads them as capitals"))
    return notes


def _overlong(source: Source, ended: int) -> list[Note]:
    """Note the first line that pass 3 has no room for."""
    if max(map(len, source.text.split("\r"))) <= LONGEST:
        return []
    start = 0
    for at, (_, mark) in enumerate(source.items[:ended]):
        end = source.spans[at][1]
        if mark == "\r" and end - start > LONGEST:
            message = f"a line of {end - start} characters: pass 3 has room for {LONGEST}"
            return [Note("PN28", at, message, "the tape is good, the listing is not; break the line")]
        if mark == "\r":
            start = end + 1
    return []


def _of_the_end(source: Source, tapes: int, ended: int) -> list[Note]:
    if ended == len(source.items) - 1:
        advice = "PAL III would wait for more tape; it is taken as if there were one"
        return [Note("PN27", max(ended - 1, 0), "no $ at the end", advice)]
    notes = []
    for at in range(ended + 1, len(source.items) - 1):
        item, mark = source.items[at]
        if item or mark not in "\r \t":
            if source.place(at).tape == source.place(ended).tape:
                notes = [Note(AFTER_END, at, "text after $ is not read", "put the $ at the end")]
            break
    unread = tapes - 1 - source.place(ended).tape
    if unread:
        message = f"{unread} more tape{'s' * (unread > 1)} not read"
        advice = "$ ends the source; on a tape that others follow, PAUSE stands instead"
        notes.append(Note("PN27", ended, message, advice))
    return notes


def of_pass_3(
    punched: Sequence[Message | Punched | Written | Listed],
    listed: Sequence[Message | Punched | Written | Listed],
) -> list[Note]:
    """Note the first word that pass 2 and pass 3 see differently."""
    on_tape = [piece for piece in punched if isinstance(piece, Written)]
    words = [piece for piece in listed if isinstance(piece, Listed) and piece.word is not None]
    for word, piece in zip(on_tape, words, strict=False):
        if piece.word != word.word:
            message = f"this is {word.word:04o} on the tape and {piece.word:04o} in the listing"
            advice = "each pass assigns again, with the values that the last one left"
            return [Note("PN24", piece.at, message, advice)]
    return []
