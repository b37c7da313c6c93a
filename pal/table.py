"""The symbol table of PAL III as it is in core: a list of words, four for each symbol.

    0 to 2    the name, two characters a word; the first has 4000 while the symbol is undefined
    3         the value

First come the pseudo-operators, whose values are the addresses of their routines, then the permanent symbols,
then the source's. Which symbols are memory references is a matter of place: those before `boundary`.

PAL III defines whatever its pointer points to, which need not be a symbol; so a word is read and stored by
its index here, and an index below 0 is a word of page zero.

Sources: DEC-08-ASB1 and its outputs. What is marked (late) is of a later edition of the program, where the
outputs do not contradict it.
"""

from pal.symbols import PERMANENT, PSEUDO_OPERATORS, SIGNIFICANT, codes, spelled

ENTRY = 4  # words of a symbol
VALUE = 3  # the last of them
PSEUDO = len(PSEUDO_OPERATORS) * ENTRY  # where the pseudo-operators end
UNDEFINED = 0o4000

_MASK = 0o7777
_PERMANENT_END = PSEUDO + len(PERMANENT) * ENTRY
_BOUNDARY = PSEUDO + sum(symbol.memory_reference for symbol in PERMANENT) * ENTRY
_SPILL = 93  # the word that takes the first character of a name after an illegal one (late)
_CORE = 0o2266  # the table's address in core (late; the number of symbols agrees)
_LINE_FEED = 0o212
_SAFE = 0o17  # up to here in page zero passes 1 and 2 do not mind what is stored
_LEFT_THERE = {1: 0o206, 2: 0o1073}  # words of page zero before pass 1; others are 0 (late)

_NAMES = (*PSEUDO_OPERATORS.items(), *((symbol.mnemonic, symbol.octal) for symbol in PERMANENT))
_WORDS = tuple(word for name, value in _NAMES for word in (*codes(name), value))
_INDEX = {name[:SIGNIFICANT]: number * ENTRY for number, (name, _) in enumerate(_NAMES)}


class Stop(Exception):
    """PAL III goes no further: the table is full, or it writes over itself or never ends."""


class SymbolTable:
    """The symbol table, for `capacity` symbols of the source.

    words     the words; `index` {name: where its symbol begins}
    first     where the symbols begin that are listed; `end`, where the table ends
    boundary  where the memory references end
    safe      up to which address of page zero PAL III does not mind what is stored
    """

    def __init__(self, capacity: int) -> None:
        self.words = [*_WORDS, *([0] * (capacity + 1) * ENTRY)]
        self.index = dict(_INDEX)
        self.first = self.end = _PERMANENT_END
        self.boundary = _BOUNDARY
        self.safe = _SAFE
        self._room = _PERMANENT_END + capacity * ENTRY

    @staticmethod
    def page_zero(address: int) -> int:
        """Return the index of a word of page zero."""
        return address - _CORE

    @property
    def full(self) -> bool:
        """Whether the table has no space for another symbol."""
        return self.end + ENTRY > self._room

    def enter(self, name: str, value: int) -> int:
        """Enter an undefined symbol; return its address."""
        entry = self.end
        first, second, third = codes(name)
        for at, word in enumerate((first | UNDEFINED, second, third, value), entry):
            self.words[at] = word
        self.index[name] = entry
        self.end += ENTRY
        return entry

    def overwrite(self) -> None:
        """Put the line feed of pass 3's first line into PAL III's buffer, over a full table's end."""
        if self.full:
            self.words[self.end - ENTRY + VALUE] = _LINE_FEED

    def name(self, entry: int) -> tuple[int, int, int]:
        """Return the words of a name, without the mark of an undefined one."""
        return self.word(entry) & ~UNDEFINED, self.word(entry + 1), self.word(entry + 2)

    def word(self, at: int) -> int:
        """Return a word by its address in the table, in page zero or in the free space."""
        if at < 0:
            return _LEFT_THERE.get(at + _CORE, 0)
        return self.words[at] if at < len(self.words) else 0

    def store(self, at: int, word: int) -> None:
        """Store a word; raise Stop where that breaks PAL III."""
        if at + _CORE <= self.safe:
            return
        if not 0 <= at < len(self.words):
            raise Stop(f"PAL III writes over itself, at {at + _CORE:04o}")
        entry = at - at % ENTRY
        before = self.name(entry)
        self.words[at] = word
        if self.name(entry) != before:
            self._rename()

    def spill(self, characters: str) -> None:
        """Add what follows an illegal character in a name to the table's words, as PAL III does."""
        for at, character in enumerate(characters, _SPILL):
            self.store(at, self.word(at) + ((ord(character) & 0o77) << 6) & _MASK)

    def expunge(self) -> None:
        """Forget all but the pseudo-operators; what is entered next is a memory reference, until FIXMRI."""
        self.first = self.end = PSEUDO
        self.boundary = len(self.words)
        self._rename()

    def fix(self) -> None:
        """Omit the present symbols from the listing."""
        self.first = self.end

    def fix_reference(self) -> None:
        """Move the boundary by one symbol."""
        self.boundary = (PSEUDO if self.boundary == len(self.words) else self.boundary) + ENTRY

    def listed(self) -> list[int]:
        """Return the listed entries, sorted by name, one of each name."""
        entries = {}
        for entry in reversed(range(self.first, self.end, ENTRY)):
            first, second, third = self.name(entry)
            entries[first << 24 | second << 12 | third] = entry
        return [entries[name] for name in sorted(entries)]

    def values(self) -> dict[str, int]:
        """Return {name: value} of all symbols but the pseudo-operators."""
        return {name: self.words[entry + VALUE] for name, entry in self.index.items() if entry >= PSEUDO}

    def _rename(self) -> None:
        self.index.clear()
        for entry in reversed(range(0, self.end, ENTRY)):
            self.index[spelled(self.name(entry))] = entry
