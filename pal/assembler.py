"""PAL III: the mechanism of DEC-08-ASB1, three passes over the same reading.

    pass 1    defines the symbols          messages IC RD DT ST, and UA in the symbol table at its end
    pass 2    punches the object tape      message  IR
    pass 3    types the listing            message  IR

A statement is read item by item. Each item is looked up, and the character that ends it then does its work
on the cells of the statement, which are cleared when a statement begins:

    item         value of the item read last; a symbol not seen before leaves it as it is
    refers       whether that item was a memory-reference symbol, or I
    made         whether the statement makes a word
    word         the memory-reference symbols and I, ORed; `referring`: there was one
    address      the other items, from left to right by `operator`: OR (0), +1, -1
    zero         whether there was a Z, or an address on page zero

CR and ``;`` make a word of it. ``=``, ``*``, FIELD and FIXMRI read an expression, to its CR or ``;``, without
clearing the cells; meanwhile they wait on a push-down list of seven places.

`pointer` is where in the symbol table the last look-up ended; ``,`` and ``=`` define what it points to,
whatever it is. Other routines use the cell too and leave it pointing into page zero: words and origins as
they are punched, lines without a word and form feeds as they are typed.

Not emulated: what follows once PAL III has written over itself; `Stop` is raised then, as where it would
never end. Waiting for ever for the rest of a source without ``$``: `pal.source` adds it.

Sources: DEC-08-ASAC-D; DEC-08-ASB1 (February 1967) and its outputs in tests/pal/examples.
"""

from typing import NamedTuple

from pal.isa import ADDRESS, CURRENT_PAGE, INDIRECT, PAGE
from pal.source import ENDS, Source
from pal.symbols import PSEUDO_OPERATORS, SIGNIFICANT, spelled, typed
from pal.table import ENTRY, PSEUDO, UNDEFINED, VALUE, Stop, SymbolTable
from tapes.binary import FIELD, ORIGIN, WORD

START = 0o200  # the origin before any other
TELETYPE_SYMBOLS = 585  # how many symbols of the source the table takes, by the ASR-33's reader
HIGH_SPEED_SYMBOLS = 489  # and by the high-speed reader, whose buffer takes the rest

_MASK = 0o7777
_OPERATORS = {" ": 0, "\t": 0, "+": 1, "-": -1}
_ROUTINES = {address: name for name, address in PSEUDO_OPERATORS.items()}
_PLACES = 7  # of the push-down list
_PUSHED = {"=": 2, "*": 1, "FIELD": 2, "FIXMRI": 2}  # places that each takes while it waits
_SAFE_IN_3 = 0o12  # up to here in page zero pass 3 does not mind what is stored
_REREAD = 7  # the letter of a number that is read twice, and counts so
_TO_BLANKS = (10, 13, 14)  # letters of a number after which blank frames seem to be read
_BLANK = "\x80"
_RESUMED = "!"  # marks a number that is read on after an illegal character


class Message(NamedTuple):
    """DEC's message: its code, a name or four octal digits, the location, and the item that caused it."""

    code: str
    subject: str
    location: int
    at: int

    def __str__(self) -> str:
        return f"{self.code}  {self.subject}  AT  {self.location:04o}"


class Punched(NamedTuple):
    """What pass 2 punches besides: an ORIGIN, a FIELD, or the checksum, as a WORD."""

    kind: str
    value: int


class Written:
    """A word that a source makes.

    address  where it is loaded, the field above the twelve bits
    at       the item that ends its statement; in PAL8, the place of the statement
    names    the symbols it is made of, in the order of the source
    literal  whether it is a literal; `link`, whether it refers through a pointer that PAL8 added
    """

    def __init__(
        self, address: int, word: int, at: int, names: list[str], literal: bool = False, link: bool = False
    ) -> None:
        self.address = address
        self.word = word
        self.at = at
        self.names = names
        self.literal = literal
        self.link = link


class Listed:
    """A statement of the listing: its location, field included, its word or None, the item that ends it."""

    def __init__(self, location: int, word: int | None, at: int) -> None:
        self.location = location
        self.word = word
        self.at = at


Output = list[Message | Punched | Written | Listed]
"""What a pass types, punches or lists, in order."""


class Entry(NamedTuple):
    """A symbol of the source in the symbol table; `at` is the item where it was first seen."""

    name: str
    value: int
    defined: bool
    at: int


class Assembler:
    """One run of PAL III over a source: `run` pass 1, 2 and 3, in this order.

    capacity  how many symbols of the source the table takes; HIGH_SPEED_SYMBOLS means the high-speed
              reader, which at PAUSE loses what it has read ahead, the rest of the line
    table     the symbols of the source as the last pass left them, in the order of the symbol table
    output    its messages and what it punched or listed
    lost      items that PAUSE lost in it, as pairs of the first and the one after the last
    again     what it typed besides, each with the item and the number of its character that it comes after
    stopped   why it went no further, and at which item; None if it ended
    """

    def __init__(self, source: Source, capacity: int = TELETYPE_SYMBOLS) -> None:
        self._items = source.items
        self._feeds = source.feeds
        self._reads_ahead = capacity == HIGH_SPEED_SYMBOLS
        self._symbols = SymbolTable(capacity)
        self._pointer = self._symbols.page_zero(0)
        self._names: list[str] = []  # in the statement
        self._seen: dict[int, int] = {}
        self._redefined: dict[int, int] = {}  # where a pseudo-operator was
        self.table: list[Entry] = []
        self.lost: list[tuple[int, int]] = []
        self.again: list[tuple[int, int, str]] = []
        self.stopped: tuple[str, int] | None = None

    def run(self, number: int) -> Output:
        """Run pass `number`: its messages and what it punches or lists."""
        self._number = number
        if number == 3:
            self._symbols.safe = _SAFE_IN_3
        self._reader = iter(enumerate(self._items))
        self.output: Output = []
        self._location = START
        self._field = 0
        self._radix = 8
        self._broken = ""  # the item in which there was an illegal character
        self._checksum = 0
        self._line = 0  # the first item of the line
        self._pending: list[tuple[str, int, int]] = []
        self._blamed: int | None = None  # the item that is to blame where PAL III goes no further
        self._places = 1
        self.table = []
        self.lost = []
        self.again = []
        try:
            self._punch(ORIGIN, START)
            self._read()
            self._punch(WORD, self._checksum & _MASK)
            if number != 2:
                self._list_symbols()
        except Stop as stop:
            self.stopped = str(stop), self._at if self._blamed is None else self._blamed
        return self.output

    def values(self) -> dict[str, int]:
        """Return {name: value} of all symbols, the permanent ones included."""
        return self._symbols.values()

    def _clear(self) -> None:
        self._word = self._address = self._item = self._operator = 0
        self._made = self._referring = self._doubtful = self._zero = False
        self._names = []

    def _read(self) -> None:
        """Read the source to the first ``$`` and obey the character that ends each item."""
        self._clear()
        for at, (item, mark) in self._reader:
            self._at = at  # the item read last
            name = self._go_on(item) if self._broken else item
            if not name:
                if self._operator:
                    self._see_lost()
                self._item = 0
                self._refers = False
            elif not self._look_up(name, mark):
                continue
            if mark in _OPERATORS:
                if self._made:
                    self._apply()
                self._operator = _OPERATORS[mark]
            elif mark in ENDS:
                if self._made:
                    self._apply()
                elif not (self._referring or self._pending or self._doubtful or self._number == 3):
                    self._clear()
                    continue
                self._make_word()
                if self._pending:
                    self._finish()
                self._write()
                self._clear()
            elif mark == ",":
                self._tag()
            elif mark == ".":
                self._point()
            elif mark == "=":
                self._assign()
            elif mark == "*":
                self._see_star()
                self._wait("*")
            elif mark == "$":
                break
            else:
                self._say("IC", f"{ord(mark) | 0o200:04o}")
                self._broken = name

    # `pal.watched` overrides what follows, to note where a source means something else than it says.

    def _see_before(self, pointer: int) -> None:
        """Called when something comes before the memory reference at `pointer`."""

    def _see_reference(self) -> None:
        """Called when a memory reference has operation 0400, or a Z and an address on another page."""

    def _see_word(self) -> None:
        """Called when a `doubtful` statement ends, with or without a word."""

    def _see_pseudo(self, pointer: int) -> None:
        """Called for the pseudo-operator at `pointer`."""

    def _see_tag(self) -> None:
        """Called when a comma ends the item."""

    def _see_equals(self, pointer: int) -> None:
        """Called when an equals sign ends the item and defines the symbol at `pointer`."""

    def _see_star(self) -> None:
        """Called when an asterisk ends the item."""

    def _see_moved(self) -> None:
        """Called when an assignment has another value in pass 2 than in pass 1."""

    def _see_number(self, value: int) -> None:
        """Called with the `value` of a number that is too large, or 0 for one with an 8, a 9 or a letter."""

    def _see_point(self) -> None:
        """Called for a point after an operator, which PAL III applies twice."""

    def _see_lost(self) -> None:
        """Called when an operator is not used."""

    def _see_long(self) -> None:
        """Called when a name has more than six characters."""

    def _look_up(self, name: str, mark: str) -> bool:
        """Look an item up; return whether the mark after it still has to be obeyed."""
        self._made = True
        symbols = self._symbols
        found = symbols.index.get(name)
        if found is None:
            if not name[0].isalpha():
                self._item = self._numeral(name)
                self._refers = False
                return True
            found = symbols.index.get(name[:SIGNIFICANT])
            if found is not None:
                self._see_long()
        if self._number == 2 and mark != ",":
            self._names.append(name)
        if found is None:
            self._pointer = self._enter(name[:SIGNIFICANT])
            self._refers = False
            return True
        pointer = found
        self._pointer = pointer
        self._item = symbols.words[pointer + VALUE]
        self._refers = pointer < symbols.boundary
        return pointer >= PSEUDO or self._act(mark)

    def _act(self, mark: str) -> bool:
        """Obey the pseudo-operator just read; return whether the mark after it still has to be obeyed."""
        self._room_for(1)
        self._see_pseudo(self._pointer)
        self._made = False
        routine = _ROUTINES.get(self._item)
        if routine == "I":
            self._item = INDIRECT
            self._made = True
        elif routine == "Z":
            self._zero = True
        elif routine in {"FIELD", "FIXMRI"}:
            self._wait(routine)
            return False
        elif routine == "DECIMAL":
            self._radix = 10
        elif routine == "OCTAL":
            self._radix = 8
        elif routine == "PAUSE":
            if self._reads_ahead and mark != "\r":
                self._lose()
        elif routine is None:
            self._blamed = self._redefined.get(self._pointer)
            raise Stop(
                f"PAL III goes on at {self._item:04o}, where there is no routine, after this definition"
            )
        elif self._number == 1:
            self._symbols.expunge() if routine == "EXPUNGE" else self._symbols.fix()
        return True

    def _apply(self) -> None:
        """Apply the item: put it into the word, or use its operator on the address."""
        self._room_for(1)
        if self._refers:
            if self._address:
                self._see_before(self._pointer)
            self._word |= self._item
            self._referring = True
        elif not self._operator:
            self._address |= self._item
        else:
            self._address = self._address + self._operator * self._item & _MASK

    def _point(self) -> None:
        """``.``: apply the item, then the location, both with the same operator."""
        if self._made:
            if self._operator:
                self._see_point()
            self._apply()
        self._item, self._refers, self._made = self._location, False, True
        self._apply()
        self._operator = 0

    def _finish(self) -> None:
        """Give the finished word to the assignments and operators that wait for it, the last one first."""
        self._room_for(1)
        while self._pending:
            kind, pointer, begun = self._pending.pop()
            self._places -= _PUSHED[kind]
            self._made = False
            if kind == "=":
                self._blamed = begun
                value = pointer + VALUE
                if self._number == 2 and self._word != self._symbols.word(value):
                    self._see_moved()
                self._symbols.store(value, self._word)
                self._blamed = None
            elif kind == "*":
                self._location = self._word
                self._punch(ORIGIN, self._word)
            else:
                self._act_upon(kind)
                self._make_word()

    def _act_upon(self, routine: str) -> None:
        """Use the word as the argument of FIELD, punched in pass 2, or of FIXMRI in pass 1."""
        if routine == "FIELD":
            self._field = (self._word & 7) << 12
            if self._number == 2:
                self.output.append(Punched(FIELD, self._word & 7))
        elif routine == "FIXMRI" and self._number == 1:
            self._symbols.fix_reference()

    def _make_word(self) -> None:
        """Combine the word and its address."""
        address = self._address
        if not self._referring:
            self._word = address
            return
        self._referring = False
        page = address & PAGE
        if self._word == INDIRECT or (self._zero and page):
            self._see_reference()
        if not page:
            self._zero = True
        elif self._number != 1 and page != self._location & PAGE:
            self._room_for(3)
            self.output.append(Message("IR", f"{address:04o}", self._location, self._at))
        self._address = address & ADDRESS
        self._word = self._word + self._address + (0 if self._zero else CURRENT_PAGE) & _MASK

    def _write(self) -> None:
        """Punch or list the statement, and advance the location if it made a word."""
        if self._doubtful:
            self._see_word()
        if self._number == 3:
            self._list(self._at)
        elif self._made and self._number == 2:
            self.output.append(Written(self._field | self._location, self._word, self._at, self._names))
            self._sum(self._word)
        if self._made:
            self._location = self._location + 1 & _MASK

    def _list(self, at: int) -> None:
        self.output.append(Listed(self._field | self._location, self._word if self._made else None, at))
        fed = False
        if self._items[at][1] == "\r":
            self._symbols.overwrite()
            for feed in self._feeds:
                fed = fed or self._line <= feed <= at
            self._line = at + 1
        if fed or not self._made:
            self._pointer = self._symbols.page_zero(0)

    def _punch(self, kind: str, value: int) -> None:
        """Punch an origin or the checksum, in pass 2."""
        if self._number != 2:
            return
        self.output.append(Punched(kind, value))
        self._checksum += 0o100
        self._sum(value)

    def _sum(self, value: int) -> None:
        """Add the frames of a word to the checksum."""
        self._checksum += (value >> 6) + (value & 0o77)
        self._pointer = self._symbols.page_zero(value & 0o77)

    def _tag(self) -> None:
        """``,``: define the symbol at `pointer` as the location."""
        self._see_tag()
        self._made = False
        if self._number != 1:
            return
        pointer = self._pointer
        first = self._symbols.word(pointer)
        if not first & UNDEFINED:
            self._say("DT", typed(spelled(self._symbols.name(pointer))))
            return
        self._symbols.store(pointer, first ^ UNDEFINED)
        self._pointer += VALUE
        self._symbols.store(self._pointer, self._location)

    def _assign(self) -> None:
        """``=``: define the symbol at `pointer` as the value that follows."""
        pointer = self._pointer
        self._see_equals(pointer)
        first = self._symbols.word(pointer)
        if not first & UNDEFINED:
            self._say("RD", typed(spelled(self._symbols.name(pointer))))
        self._blamed = self._at
        self._symbols.store(pointer, first & ~UNDEFINED)
        self._blamed = None
        if pointer < PSEUDO:
            self._redefined.setdefault(pointer, self._at)
        self._wait("=")

    def _wait(self, kind: str) -> None:
        self._room_for(_PUSHED[kind])
        self._places += _PUSHED[kind]
        self._pending.append((kind, self._pointer, self._at))

    def _room_for(self, places: int) -> None:
        if self._places + places > _PLACES:
            raise Stop("expressions within expressions take more than the seven places of the push-down list")

    def _say(self, code: str, subject: str) -> None:
        """Type a message, in pass 1."""
        self._room_for(2)
        if self._number == 1:
            self.output.append(Message(code, subject, self._location, self._at))

    def _go_on(self, rest: str) -> str:
        """Read on after an illegal character; return the item. A number begins again at 0, a name ends."""
        name, self._broken = self._broken, ""
        if not name[0].isalpha():
            if name.isdigit():
                self._letters = 0  # in the number being read
            return _RESUMED + rest
        self._symbols.spill(rest)
        return name

    def _numeral(self, name: str) -> int:
        """Return the value of a number; 8 and 9 count as 8 and 9 in octal too.

        A letter is illegal, and so is each digit after it. From the second letter on all is passed over; but
        each sends PAL III one word further in its reader's routine, where it reads a letter twice, or takes
        what it has read for the frame 0200, which is illegal, and the number begins again at 0.
        """
        if name.isdigit() and (self._radix == 10 or ("8" not in name and "9" not in name)):
            value = int(name[max(len(name) - 12, 0) :], self._radix)
            if value > _MASK or len(name) > 12:
                self._see_number(value)
            return value & _MASK
        if name[0] != _RESUMED:
            self._letters = 0
        self._see_number(0)
        value = 0
        for at, character in enumerate(name.lstrip(_RESUMED)):
            if character.isalpha():
                self._letters += 1
                if self._letters == _REREAD:
                    self._letters += 1
                    self.again.append((self._at, at, character))
            if not self._letters:
                value = value * self._radix + int(character) & _MASK
            elif self._letters == 1:
                self._say("IC", f"{ord(character) & 0o77:04o}")
            elif self._letters in _TO_BLANKS:
                self._say("IC", "0200")
                self.again.append((self._at, at, _BLANK))
                value = 0
        return value

    def _enter(self, name: str) -> int:
        """Enter a symbol that is not in the table; return where."""
        if self._symbols.full:
            self._say("ST", typed(name))
            raise Stop(f"the symbol table is full: there is no room for {name}")
        entry = self._symbols.enter(name, self._location)
        self._seen[entry] = self._at
        return entry

    def _lose(self) -> None:
        """PAUSE: lose what the high-speed reader has read ahead."""
        for after, (_, mark) in self._reader:
            if mark == "\r":
                self.lost.append((self._at + 1, after + 1))
                break

    def _list_symbols(self) -> None:
        """End the pass; pass 1 gives what is undefined the last address of its page."""
        words = self._symbols.words
        for entry in self._symbols.listed():
            value = words[entry + VALUE]
            undefined = words[entry] & UNDEFINED
            name = spelled(self._symbols.name(entry))
            self.table.append(Entry(name, value, not undefined, self._seen[entry]))
            if undefined:
                self._room_for(2)
            if undefined and self._number == 1:
                words[entry] ^= UNDEFINED
                words[entry + VALUE] = value & PAGE | ADDRESS
        if self._reads_ahead and self._symbols.full:
            self._blamed = self._seen[self._symbols.end - ENTRY]
            raise Stop("the symbol table is just full: the high-speed reader's buffer overwrites this symbol")
