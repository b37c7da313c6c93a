"""The symbol table of PAL8."""

from pal.notes import note
from pal.pal8 import symbols
from pal.pal8.lexer import Lexer
from pal.pal8.log import Log
from pal.symbols import SIGNIFICANT

# What a symbol is: any other, a memory reference, I or Z, a pseudo-operator, one of palbart's.
PLAIN, REFERENCE, MARK, PSEUDO, WEAK = 1, 2, 3, 4, 5


class Symbol:
    """A symbol: its type and value; `passed`, the last defining pass or 0; `where`, line and column."""

    def __init__(self, name: str, kind: int, value: int, permanent: bool) -> None:
        self.name = name
        self.kind = kind
        self.value = value
        self.permanent = permanent
        self.passed = 0
        self.where = (0, 0)


class SymbolTable:
    """The symbols by their names, and the one that was looked up last.

    DEC's PAL8 keeps `found` and `last` from one statement to the next, and uses them for a missing term.
    EXPUNGE and FIXTAB clear them, in pass 1.

    known         {name: symbol}
    found         the symbol looked up last; `found_at`, its column
    last          the value of the symbol or number read last
    is_undefined  whether `found` is undefined
    undefined     not 0 if something in the expression read last is undefined
    """

    def __init__(self, lexer: Lexer, log: Log, exact: bool) -> None:
        self._lexer = lexer
        self._log = log
        self._exact = exact
        self._early: set[str] = set()  # names that are used before they are defined
        self._left: dict[str, int] = {}  # values of expunged names: they stay in DEC's table
        self.known = _permanent()
        self.found = Symbol("", PLAIN, 0, False)
        self.found_at = 0
        self.last = 0
        self.is_undefined = False
        self.undefined = 0
        self.expunged = False

    def look_up(self) -> None:
        """Look the token up, and take the next one."""
        name = self._lexer.token[:SIGNIFICANT]
        self.found_at = self._lexer.start
        found = self.known.get(name)
        self.is_undefined = found is None
        self.found = Symbol(name, PLAIN, self._left.get(name, 0), False) if found is None else found
        self.last = self.found.value
        self._lexer.advance()

    def use_undefined(self) -> bool:
        """Note that an expression has an undefined symbol; return whether to report it now."""
        self._early.add(self.found.name)
        self.is_undefined = False
        self.undefined += 1
        return self._log.number == 2 or not self.undefined

    def define_tag(self, name: str, start: int, end: int) -> None:
        """`NAME,`: define it as the location."""
        log = self._log
        log.mention(name, start, end, True)
        self._lexer.advance()
        self.is_undefined = False
        symbol = self.known.get(name)
        if symbol is not None and not self._exact and symbol.kind in (PLAIN, REFERENCE) and not symbol.passed:
            at = log.keep(start, end)
            log.notes.append(note("PN30 PAL8", at, name=name, value=f"{symbol.value:04o}"))
            symbol = None
        if symbol is None or symbol.kind == WEAK:
            symbol = self.known[name] = Symbol(name, PLAIN, log.location, False)
            symbol.where = (self._lexer.index, start)
            self._take(symbol)
        elif symbol.value != log.location:
            self._say_redefined(symbol, start)
            return
        symbol.passed = log.number
        log.tag = name
        log.tag_at = log.location

    def _say_redefined(self, symbol: Symbol, start: int) -> None:
        """Report a tag with another value: it is I or Z, has moved since pass 1, or is defined twice."""
        moved = symbol.where == (self._lexer.index, start)
        key = "ID mark" if symbol.kind == MARK else "ID moved" if moved else "ID"
        value, location = f"{symbol.value:04o}", f"{self._log.location:04o}"
        self._log.say(key, start, name=symbol.name, value=value, location=location)

    def define(self, name: str, kind: int, value: int, start: int) -> None:
        """`NAME=value`; `kind` is REFERENCE after FIXMRI."""
        number = self._log.number
        self.is_undefined = False
        symbol = self.known.get(name)
        if symbol is None or symbol.kind == WEAK:
            symbol = self.known[name] = Symbol(name, kind, value, False)
        elif symbol.value != value:
            before, now = f"{symbol.value:04o}", f"{value:04o}"
            if symbol.permanent:
                self._log.say("RD permanent", start, name=name, value=before, now=now)
            elif symbol.passed == number and name in self._early:
                self._log.note("PN41", start, name=name, value=before, now=now)
        if symbol.value != value or symbol.passed or not symbol.permanent:
            symbol.value = value
            symbol.passed = number
        if symbol.kind in (PLAIN, REFERENCE):
            symbol.kind = kind
        self._take(symbol)

    def _take(self, symbol: Symbol) -> None:
        self.found = symbol
        self.last = symbol.value

    def expunge(self) -> None:
        """Forget all symbols but the pseudo-operators, I and Z."""
        self.expunged = True
        self._left |= {name: symbol.value for name, symbol in self.known.items()}
        kept = [symbol for symbol in self.known.values() if symbol.kind in (MARK, PSEUDO)]
        self.known = {symbol.name[:SIGNIFICANT]: symbol for symbol in kept}
        self._take(Symbol("", PLAIN, 0, False))

    def fix(self) -> None:
        """Make all symbols permanent."""
        for symbol in self.known.values():
            symbol.permanent = True
        self._take(Symbol("", PLAIN, 0, False))

    def add_palbarts(self) -> None:
        """Add palbart's names that the source does not define."""
        for name, value in symbols.PALBARTS.items():
            if name not in self.known:
                self.known[name] = Symbol(name, WEAK, value, False)


def _permanent() -> dict[str, Symbol]:
    return {
        **{name: Symbol(name, REFERENCE, value, True) for name, value in symbols.REFERENCES.items()},
        **{name: Symbol(name, PLAIN, value, True) for name, value in symbols.INSTRUCTIONS.items()},
        **{name[:SIGNIFICANT]: Symbol(name, PSEUDO, at, True) for name, at in symbols.HANDLERS.items()},
        **{name: Symbol(name, MARK, value, True) for name, value in symbols.MARKS.items()},
    }
