"""PAL III: source tapes to words, in three passes over the same statements.

    pass 1    defines the symbols          messages IC RD DT ST, and UA in the symbol table at its end
    pass 2    punches the object tape      message  IR
    pass 3    types the listing            message  IR

Each pass goes through every statement with the symbols as the last pass left them and does its assignments
(=) again; so where a symbol is assigned from one that is assigned later, the three passes see three values.
That is why pass 3 is run here, and not its result foretold.

What a statement does:

    A,          pass 1: A is the location; passes 2 and 3: nothing. What was read before is dropped
    A=          A takes the value of the rest of the statement; several in a row all take it
    *           the location takes the value of the rest
    FIELD       the rest is the number of a memory field
    otherwise   one item or more make a word, none make nothing

A comma and an equals sign speak of the symbol read last, even if that was lines before (``1A,`` and ``,5``
are DT of it); before any symbol at all, of one whose name is six blanks (inferred). An equals sign with no
symbol in its own statement gives that symbol a value in pass 1 only: in passes 2 and 3 it is without effect
(seen in one example; as if pass 1 looked for the symbol by its name, and the others took what they found when
they read it).

An undefined symbol is entered when first seen, with the location for a value that counts as zero during
pass 1; at the end of pass 1 it gets the last address of that page. EXPUNGE, FIXTAB and FIXMRI act in pass
1. ``$`` ends the pass where it stands: what precedes it in its own statement is read, but makes no word.

Not emulated: waiting for ever for the rest of a source without ``$`` (it is taken as if it were there);
halting at PAUSE (the next tape just follows); what PAL III's own core holds before the first symbol is read.

Sources: DEC-08-ASAC-D; the output of DEC-08-ASB1 (February 1967). Inferences are marked in docs/pal3.md.
"""

from collections.abc import Callable
from typing import NamedTuple

from pal import scanner
from pal.expressions import Expression
from pal.scanner import Line, Token
from pal.symbols import PERMANENT, PSEUDO_OPERATORS, SIGNIFICANT, Permanent

START = 0o200  # the origin before any other
TELETYPE_SYMBOLS = 590  # room for symbols of the user's with the source in the ASR-33's reader
HIGH_SPEED_SYMBOLS = 495  # and in the high-speed reader, whose buffer takes the rest

WORD, ORIGIN, FIELD, NOTHING = "word", "origin", "field", ""


class Place(NamedTuple):
    """Where in the source: a line, one of its statements, a token of that."""

    line: int
    statement: int
    token: int


class Symbol:
    """An entry of the symbol table."""

    __slots__ = ("defined", "first_seen", "memory_reference", "name", "permanent", "place", "value")

    def __init__(self, name: str, first_seen: int, place: Place) -> None:
        self.name = name
        self.first_seen = first_seen
        self.place = place
        self.value = 0
        self.defined = False
        self.permanent = False
        self.memory_reference = False


class Entry(NamedTuple):
    """A line of the symbol table as a pass prints it; not `defined`: a UA message in its place."""

    name: str
    value: int
    defined: bool
    place: Place


class Message(NamedTuple):
    """A message of DEC's: its code, a name or four octal digits, the location; and where in the source."""

    code: str
    subject: str
    location: int
    place: Place

    def __str__(self) -> str:
        return f"{self.code}  {self.subject}  AT  {self.location:04o}"


class Result(NamedTuple):
    """What a statement of `lines[line]` came to.

    kind        WORD, ORIGIN, FIELD or NOTHING
    location    where the statement stands, or where the origin put the location
    value       the word, or the field's number
    message     an IR message, which precedes it on the Teletype
    """

    line: int
    last: bool
    kind: str
    location: int
    value: int
    message: Message | None


_NOWHERE = Place(-1, 0, 0)  # where a permanent symbol is defined


class TableFull(Exception):
    """No room for a symbol: PAL III says ST and halts for good."""


class Assembler:
    """One run of PAL III over the lines of a source: `define`, then `assemble` for pass 2, and for pass 3."""

    def __init__(self, lines: list[Line], capacity: int) -> None:
        self.lines = lines
        self.messages: list[Message] = []
        self.full = False
        self._room = capacity + len(PERMANENT)
        self._table = {symbol.mnemonic: _permanent(symbol) for symbol in PERMANENT}
        self._tokens: dict[str, list[Token]] = {}
        self._last = ""
        self._begin(defining=True)

    def define(self) -> list[Entry]:
        """Run pass 1 and return the symbol table it prints; its messages except UA are then in `messages`."""
        try:
            self._run()
        except TableFull as full:
            self._say("ST", f"{full!s:6}")
            self.full = True
        table = self.table()
        for symbol in self._table.values():
            if not symbol.defined:
                symbol.value = symbol.first_seen | 0o177
                symbol.defined = True
        return table

    def assemble(self) -> list[Result]:
        """Run pass 2 or 3: what each statement came to, in source order."""
        self._begin(defining=False)
        return self._run()

    def table(self) -> list[Entry]:
        """Return the user's symbols as they stand, in no order."""
        return [
            Entry(
                symbol.name,
                symbol.value if symbol.defined else symbol.first_seen,
                symbol.defined,
                symbol.place,
            )
            for symbol in self._table.values()
            if not symbol.permanent
        ]

    def values(self) -> dict[str, int]:
        """Return {name: value} of all symbols as they stand."""
        return {symbol.name: symbol.value for symbol in self._table.values()}

    def _begin(self, defining: bool) -> None:
        self._defining = defining
        self._location = START
        self._radix = 8
        self._expression = Expression()
        self._targets: list[Symbol] = []
        self._kind = WORD
        self._fixing = False
        self._named = False
        self._statement = 0, 0
        self._at = 0
        self._instruction = 0

    def _run(self) -> list[Result]:
        results: list[Result] = []
        cache = self._tokens
        for number, line in enumerate(self.lines):
            final = len(line.statements) - 1
            for index, statement in enumerate(line.statements):
                tokens = cache.get(statement)
                if tokens is None:
                    tokens = cache[statement] = scanner.tokens(statement)
                self._statement = number, index
                for self._at, token in enumerate(tokens):
                    self._read(token)
                if index < final or line.complete:
                    results.append(self._finish(index == final))
        return results

    def _read(self, token: Token) -> None:
        symbol, number, illegal, mark = token
        if illegal and self._defining:
            for code in illegal:
                self._say("IC", f"{code:04o}")
        if symbol:
            self._last = symbol
            self._named = True
            self._symbol(symbol)
        elif not mark:
            self._expression.item(_number(number, self._radix))
        elif mark in "+- ":
            self._expression.operate(mark)
        elif mark == ".":
            self._expression.item(self._location)
        elif mark == ",":
            self._tag()
        elif mark == "=":
            self._assign()
        elif mark == "*":
            self._expression.clear()
            self._kind = ORIGIN

    def _symbol(self, name: str) -> None:
        symbol = self._table.get(name)
        if symbol is None:
            pseudo = _PSEUDO.get(name)
            if pseudo is not None:
                pseudo(self)
                return
            symbol = self._enter(name)
        if symbol.memory_reference:
            self._instruction = self._at
            self._expression.instruction(symbol.value)
        else:
            self._expression.item(symbol.value)

    def _enter(self, name: str) -> Symbol:
        """Enter a symbol; after pass 1 that is one which EXPUNGE forgot, and it is zero."""
        if self._defining and len(self._table) >= self._room:
            raise TableFull(name)
        symbol = self._table[name] = Symbol(name, self._location, self._place())
        symbol.defined = not self._defining
        return symbol

    def _tag(self) -> None:
        self._expression.clear()
        if not self._defining:
            return
        symbol = self._spoken_of()
        if symbol is None or symbol.defined:
            self._say("DT", f"{self._last:6}")
        if symbol is not None and not symbol.defined:
            symbol.defined = True
            symbol.value = self._location

    def _assign(self) -> None:
        self._expression.clear()
        if not (self._defining or self._named):
            return
        symbol = self._spoken_of()
        if self._defining and (symbol is None or symbol.defined):
            self._say("RD", f"{self._last:6}")
        if symbol is None:
            return
        symbol.defined = True
        symbol.memory_reference |= self._fixing
        self._targets.append(symbol)
        self._kind = NOTHING

    def _spoken_of(self) -> Symbol | None:
        """Return the symbol read last, None if it is a pseudo-operator."""
        name = self._last
        symbol = self._table.get(name)
        if symbol is None and name not in _PSEUDO:
            symbol = self._enter(name)
        return symbol

    def _say(self, code: str, subject: str) -> None:
        self.messages.append(Message(code, subject, self._location, self._place()))

    def _place(self) -> Place:
        return Place(*self._statement, self._at)

    def _finish(self, last: bool) -> Result:
        expression = self._expression
        kind = self._kind
        location = self._location
        value = 0
        message = None
        if kind == WORD and expression.empty:
            kind = NOTHING
        else:
            value = expression.word(location)
            beyond = expression.illegal_reference(location)
            if beyond is not None:
                message = Message("IR", f"{beyond:04o}", location, Place(*self._statement, self._instruction))
            if kind == WORD:
                self._location = location + 1 & 0o7777
            elif kind == ORIGIN:
                self._location = location = value
            for symbol in self._targets:
                symbol.value = value
        self._next_statement()
        return Result(self._statement[0], last, kind, location, value, message)

    def _next_statement(self) -> None:
        self._expression.clear()
        self._targets = []
        self._kind = WORD
        self._fixing = False
        self._named = False

    def _decimal(self) -> None:
        self._radix = 10

    def _octal(self) -> None:
        self._radix = 8

    def _field(self) -> None:
        self._expression.clear()
        self._kind = FIELD

    def _expunge(self) -> None:
        if self._defining:
            self._table.clear()

    def _fixtab(self) -> None:
        if self._defining:
            for symbol in self._table.values():
                symbol.permanent |= symbol.defined

    def _fixmri(self) -> None:
        self._fixing = self._defining

    def _pause(self) -> None:
        """Go on with the next tape: it is already there."""

    def _i(self) -> None:
        self._expression.indirect()

    def _z(self) -> None:
        self._expression.page_zero()


_ACTIONS = (
    Assembler._decimal,
    Assembler._octal,
    Assembler._field,
    Assembler._expunge,
    Assembler._fixtab,
    Assembler._fixmri,
    Assembler._pause,
    Assembler._i,
    Assembler._z,
)
_PSEUDO: dict[str, Callable[[Assembler], None]] = {
    name[:SIGNIFICANT]: action for name, action in zip(PSEUDO_OPERATORS, _ACTIONS, strict=True)
}


def _permanent(known: Permanent) -> Symbol:
    symbol = Symbol(known.mnemonic, 0, _NOWHERE)
    symbol.value = known.octal
    symbol.defined = symbol.permanent = True
    symbol.memory_reference = known.memory_reference
    return symbol


def _number(digits: str, radix: int) -> int:
    """Return the value of `digits` modulo 010000; 8 and 9 count as 8 and 9 in octal too."""
    value = 0
    for digit in digits:
        value = value * radix + ord(digit) - 0o60 & 0o7777
    return value
