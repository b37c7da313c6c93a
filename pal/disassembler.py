"""The disassembler: words, or a BIN or RIM tape, back to PAL III source that assembles to the same.

    *200
    L0200,  TLS             /0200 6046
            KCC             /0201 6032
            JMS L0214       /0202 4214

A tape that PAL III punched comes back frame for frame: every origin is kept, equal and overlapping ones too.
One of PAL8 comes back word for word.

Combined microinstructions are written as a combination. What PAL III's symbols cannot give is an octal
number, as is an instruction on page zero with the current page bit. If entries are given, what is reached
from them is code and the rest is numbers; otherwise a word that is fetched, stored, counted or called, and to
which nothing jumps, is a number.

Symbols give words their tags; without one a tag is L and its address.

Not emulated: distinguishing instructions from numbers where no instruction refers to them.

Sources: the table of symbols; Small Computer Handbook (operate groups).
"""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import NamedTuple

from pal import isa
from pal.assembler import HIGH_SPEED_SYMBOLS, START
from pal.symbols import PERMANENT, PSEUDO_OPERATORS
from tapes import binary, codes, rim
from tapes.binary import FIELD, ORIGIN, WORD

_BARE = binary.tape(binary.origin(START), sum(binary.origin(START)))
"""What PAL III punches for a source without a word; its checksum would be a word of a RIM tape."""

_PLAIN = [symbol for symbol in PERMANENT if not symbol.memory_reference]
_BY_OCTAL = {symbol.octal: symbol.mnemonic for symbol in reversed(_PLAIN)}
_BY_NAME = {symbol.mnemonic: symbol.octal for symbol in _PLAIN}
_PERMANENT = {*(symbol.mnemonic for symbol in PERMANENT), *PSEUDO_OPERATORS}
_GROUP_1 = ("CLA", "CLL", "CMA", "CML", "RTR", "RTL", "RAR", "RAL", "IAC")
_SKIPS = ("SMA", "SZA", "SNL")
_REVERSED_SKIPS = ("SPA", "SNA", "SZL", "SKP")


class Piece(NamedTuple):
    """One thing on a tape: a WORD, with its address, an ORIGIN or a FIELD."""

    kind: str
    value: int
    address: int = 0


def disassemble(
    words: Mapping[int, int], symbols: Mapping[str, int] | None = None, entries: Sequence[int] = ()
) -> str:
    """Return PAL source for {address: word}; the field is above the twelve bits of an address.

    symbols  {name: address}: tags for the words
    entries  addresses at which the program is started: only what is reached from them is code

    Of a program in one field, twelve bits of an address are enough.
    """
    return _source(_pieces_of(sorted(words), words), symbols or {}, entries)


def disassemble_tape(
    frames: bytes, symbols: Mapping[str, int] | None = None, entries: Sequence[int] = ()
) -> str:
    """Return PAL source for a BIN or RIM tape, as `disassemble`. Raises TapeError if damaged."""
    if codes.recognise(frames) is codes.RIM and _BARE not in frames:
        words = rim.decode(frames)
        return _source(_pieces_of(words, words), symbols or {}, entries)
    return _source(_pieces_on(frames), symbols or {}, entries)


def field_of(words: Iterable[int]) -> int:
    """Return the field, above twelve bits, in which all addresses are; 0 if they are in several."""
    fields = {address & 0o70000 for address in words}
    return min(fields) if len(fields) == 1 else 0


def _pieces_of(addresses: Iterable[int], words: Mapping[int, int]) -> Iterator[Piece]:
    following = -1
    bank = 0
    for address in addresses:
        if address >> 12 != bank:
            bank = address >> 12
            yield Piece(FIELD, bank)
            following = -1
        if address != following:
            yield Piece(ORIGIN, address & 0o7777)
        yield Piece(WORD, words[address], address)
        following = address + 1


def _pieces_on(frames: bytes) -> Iterator[Piece]:
    """Yield what is on a BIN tape but for the first origin, which PAL III punches of itself."""
    location = START
    bank = 0
    silent = True
    reading = binary.read(frames)
    damage = binary.find_damage(reading)
    if damage:
        raise damage
    for section in reading.sections:
        if bank:
            bank = 0
            yield Piece(FIELD, 0)
        for kind, value, _ in section.items:
            if kind == FIELD:
                bank = value
                yield Piece(FIELD, value)
                continue
            if kind == WORD:
                yield Piece(WORD, value, bank << 12 | location)
                location = location + 1 & 0o7777
            elif not silent or value != location:
                yield Piece(ORIGIN, value)
            if kind == ORIGIN:
                location = value
            silent = False


def _source(pieces: Iterable[Piece], symbols: Mapping[str, int], entries: Sequence[int]) -> str:
    tape = list(pieces)
    labels = _Labels(tape, symbols, entries)
    lines = [_line(piece, labels) for piece in tape]
    return "\n".join([*labels.definitions(), *lines, "$", ""])


def _line(piece: Piece, labels: "_Labels") -> str:
    if piece.kind == FIELD:
        return f"FIELD {piece.value}"
    if piece.kind == ORIGIN:
        return f"*{piece.value:o}"
    tag = labels.define(piece.address)
    text = labels.text(piece)
    tabs = "\t" * (1 if len(text) >= 8 else 2)
    return f"{tag}\t{text}{tabs}/{piece.address:04o} {piece.value:04o}"


class _Labels:
    """Which words have a tag and which are numbers; no more tags than PAL III takes."""

    def __init__(self, tape: list[Piece], symbols: Mapping[str, int], entries: Sequence[int]) -> None:
        words = {piece.address: piece.value for piece in tape if piece.kind == WORD}
        self._names: dict[int, str] = {}
        bank = field_of(words)
        for name, address in symbols.items():
            if name not in _PERMANENT:
                self._names.setdefault(bank | address, name)
        self._taken = set(symbols)
        jumped_to: set[int] = set()
        handled: set[int] = set()
        outside: set[int] = set()
        for piece in tape:
            target = _target(piece)
            if target in words:
                jump = piece.value >> 9 == isa.JMP and not piece.value & isa.INDIRECT
                (jumped_to if jump else handled).add(target)
            elif target is not None and target in self._names:
                outside.add(target)
        starts = [bank | each for each in entries]
        self._numbers = set(words) - _reached(words, starts, handled) if entries else handled - jumped_to
        named = [address for address in self._names if address in words]
        first = [*sorted(outside), *sorted(named), *sorted(jumped_to), *sorted(handled)]
        self._tagged: set[int] = set()
        for address in first:
            if self._tag(address) and len(self._tagged) < HIGH_SPEED_SYMBOLS - 1:
                self._tagged.add(address)
        self._outside: list[int] = sorted(address for address in outside if address in self._tagged)
        self._undefined = set(self._tagged)

    def _tag(self, address: int) -> str:
        """Return the tag for an address, "" if it would be another's."""
        name = self._names.get(address, "")
        made = f"L{address:04o}"
        return name or ("" if made in self._taken else made)

    def definitions(self) -> list[str]:
        """Return lines that define the symbols of addresses without a word."""
        return [f"{self._tag(address)}={address & 0o7777:o}" for address in self._outside]

    def define(self, address: int) -> str:
        """Return the tag for the word at `address`, the first time; otherwise ""."""
        if address not in self._undefined:
            return ""
        self._undefined.discard(address)
        return self._tag(address) + ","

    def text(self, piece: Piece) -> str:
        """Return the word as source."""
        number = f"{piece.value:o}"
        if piece.address in self._numbers:
            return number
        if piece.value >> 9 > isa.JMP:
            return microinstruction(piece.value) or number
        target = _target(piece)
        if target is None:
            return number
        indirect = "I " if piece.value & isa.INDIRECT else ""
        address = self._tag(target) if target in self._tagged else f"{target & 0o7777:o}"
        return f"{isa.OPERATIONS[piece.value >> 9]} {indirect}{address}"


def _reached(words: Mapping[int, int], entries: Sequence[int], handled: set[int]) -> set[int]:
    """The addresses that execution from `entries` reaches, also past HLT, but not into `handled` data."""
    reached: set[int] = set()
    called: set[int] = set()
    waiting = list(entries)
    while waiting:
        address = waiting.pop()
        if address in reached or address not in words:
            continue
        reached.add(address)
        word = words[address]
        target = isa.refers_to(word, address)
        if word >> 8 == isa.JMP << 1:
            waiting.append(target)
        elif word >> 9 != isa.JMP and not (isa.halts(word) and address + 1 in handled):
            waiting.append(address + 1)
        if word >> 8 == isa.JMS << 1:
            waiting.append(target + 1)
            called.add(target)
        skips = word & 0o7401 == 0o7400 and word & 0o170 != 0
        if skips or isa.tests_flag(word) or word >> 9 == isa.ISZ:
            waiting.append(address + 2)
    return reached - called


def _target(piece: Piece) -> int | None:
    """Return the address of a memory reference that PAL III can write as one, in its own field; else None."""
    if piece.kind != WORD or piece.value >> 9 > isa.JMP:
        return None
    if piece.value & isa.CURRENT_PAGE and not piece.address & isa.PAGE:
        return None
    return isa.refers_to(piece.value, piece.address)


def microinstruction(word: int) -> str | None:
    """Return an IOT or OPR as the symbol, or symbols, that give it; None where no symbols give it."""
    if word in _BY_OCTAL:
        return _BY_OCTAL[word]
    names = _candidates(word)
    chosen: list[str] = []
    together = 0
    for name in names:
        bits = _BY_NAME[name]
        if not bits & ~word and bits & ~together:
            chosen.append(name)
            together |= bits
    return " ".join(chosen) if together == word else None


def _candidates(word: int) -> Iterable[str]:
    if word >> 9 == isa.IOT:
        return [symbol.mnemonic for symbol in _PLAIN if symbol.octal >> 3 == word >> 3]
    if not word & 0o400:
        return _GROUP_1
    if word & 1:
        return ()
    return (_REVERSED_SKIPS if word & isa.REVERSED else _SKIPS) + ("CLA", "OSR", "HLT")
