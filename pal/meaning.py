"""What a word or a name means, in a few lines: for an editor's hover.

    1410  TAD I 0010         add the word to the AC, two's complement; indirect, autoindexed: 0010 steps first
                             3 cycles, 4.8 µs
    7041  CMA IAC            complement the AC; increment the AC

Sources: the table of symbols; PDP-8/L Users Handbook 1968 (times).
"""

from pal.disassembler import microinstruction
from pal.isa import INDIRECT, JMP, OPERATIONS, OPR, autoindexed, refers_to
from pal.pal8 import symbols as symbols8
from pal.symbols import PERMANENT, PSEUDO_OPERATORS

_CYCLE = 1.6
_IOT = 4.25
"""Microseconds that an IOT takes."""
_MEANINGS = {symbol.mnemonic: symbol.meaning for symbol in reversed(PERMANENT)}
_WORDS = {symbol.mnemonic: symbol.octal for symbol in reversed(PERMANENT)}
_MARKS = {"I": "indirect: the word there holds the address", "Z": "on page zero"}
_FIELDS = {
    "CDF": "change the data field, with the MC8/L",
    "CIF": "change the instruction field at the next jump, with the MC8/L",
    "CDI": "change both fields, with the MC8/L",
    "RDF": "read the data field, with the MC8/L",
    "RIF": "read the instruction field, with the MC8/L",
    "RIB": "read the fields as the interrupt found them, with the MC8/L",
    "RMF": "restore the fields as the interrupt found them, with the MC8/L",
}
_PSEUDO = "a pseudo-operator: it tells the assembler something and makes no word"


def of_name(name: str) -> str:
    """Return what a permanent symbol means, "" for one that is none."""
    word = f"{_WORDS[name]:04o}  " if name in _WORDS else ""
    meaning = names().get(name)
    return f"{word}{name}: {meaning}" if meaning else ""


def names() -> dict[str, str]:
    """Return {permanent symbol: meaning}, the pseudo-operators included."""
    return {**dict.fromkeys(PSEUDO_OPERATORS, _PSEUDO), **_MEANINGS, **_MARKS}


def names8() -> dict[str, str]:
    """Return {permanent symbol of PAL8, palbart's too: meaning}, the octal word where there is none."""
    known = dict.fromkeys(symbols8.PSEUDO_OPERATORS, _PSEUDO)
    words = (symbols8.INSTRUCTIONS, symbols8.PALBARTS, symbols8.REFERENCES)
    for table in words:
        for name, word in table.items():
            lacks = ", no instruction of a PDP-8/L" if name in symbols8.NOT_ON_THE_8L else ""
            known[name] = _MEANINGS.get(name, _FIELDS.get(name, f"{word:04o}{lacks}"))
    return {**known, **_MARKS}


def of_word(word: int, location: int) -> list[str]:
    """Return what `word` at `location` does as an instruction, and how long that takes, in lines."""
    code = word >> 9
    if code <= JMP:
        return [_reference(word, location), _time(1 + (code != JMP) + bool(word & INDIRECT))]
    written = microinstruction(word)
    if written is None:
        return [f"{word:04o}: no symbols give it"]
    done = "; ".join(_MEANINGS.get(name, name) for name in written.split())
    return [f"{word:04o}  {written}: {done}", _time(1) if code == OPR else f"an IOT, {_IOT} µs"]


def _reference(word: int, location: int) -> str:
    operation = OPERATIONS[word >> 9]
    address = refers_to(word, location & 0o7777)
    how = ""
    if word & INDIRECT:
        how = f"; indirect: {address:04o} holds the address"
        how += ", and is incremented first" if autoindexed(address) else ""
    shown = f"{operation} {'I ' if word & INDIRECT else ''}{address:04o}"
    return f"{word:04o}  {shown}: {_MEANINGS[operation]}{how}"


def _time(cycles: int) -> str:
    return f"{cycles} cycle{'s' if cycles > 1 else ''}, {cycles * _CYCLE:.1f} µs"
