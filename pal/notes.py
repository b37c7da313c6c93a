"""Notes on a program that assembles: what its author may not have meant. Each has a permanent code.

A note points at something that the assembler accepts and the author hardly meant. `--strict` makes an error
of each note; a comment with `pal:` and the code, as in `/ pal: PN06`, silences it on that line. docs/notes.md
has a paragraph for each code.

This module has the notes on the words of a program, in either dialect; `pal.watched` has the notes on what
PAL III does, `pal.pal8` and `pal.work8` those on PAL8.

Sources: Small Computer Handbook 1970 (operate groups); DEC-08-ASAC-D.
"""

from collections.abc import Iterable, Mapping
from typing import NamedTuple

from pal.assembler import START, Written
from pal.isa import (
    CLA,
    DCA,
    GROUP_2,
    INDIRECT,
    IOT,
    ISZ,
    JMP,
    JMS,
    OPR,
    REVERSED,
    SMA,
    SNL,
    SZA,
    changes_field,
    halts,
    in_field,
    jumps_to,
    refers_to,
    tests_flag,
)
from pal.messages import MEANT, NO_SLASH, worded
from pal.symbols import SIGNIFICANT

ASKED = 100
"""For so many undefined names a similar known one is looked for."""
_SKIPS = SMA | SZA | SNL
_ION, _TSF, _TSK, _PRINT = 0o6001, 0o6041, 0o6045, (0o6044, 0o6046)
_HANDLED = (0o3001, 0o4001, 0o5400)
"""DCA 1, JMS 1 and JMP I 0: there is a handler."""
_LOADERS = 0o7612
"""Where DEC's loaders begin."""
_FITTED = (0o00, 0o01, 0o02, 0o03, 0o04, 0o10, 0o13, 0o40, 0o41, 0o60, 0o61, 0o62, 0o66, 0o76, 0o77)
"""Devices that a PDP-8/L may have: high-speed reader and punch, Teletype, memory parity, clock, a second
Teletype, disk, line printer, DECtape.
"""
_SAME_AS = {
    **{"HALT": "HLT", "STOP": "HLT", "JUMP": "JMP", "BRA": "JMP", "GOTO": "JMP", "CALL": "JMS", "JSR": "JMS"},
    **{"ADD": "TAD", "LOAD": "TAD", "LDA": "TAD", "STORE": "DCA", "STO": "DCA", "INC": "IAC", "CLEAR": "CLA"},
    **{"NEG": "CIA", "COM": "CMA", "NOT": "CMA", "CLR": "CLA", "SKIP": "SKP", "ROL": "RAL", "ROR": "RAR"},
    **{"SUBR": "JMS", "RETURN": "JMP I", "RET": "JMP I", "RTS": "JMP I", "BYTE": "TEXT", "ORG": "*"},
}
"""What other machines and assemblers call it."""


class Note(NamedTuple):
    """A note: its code, its item or place, what is wrong, and what to do."""

    code: str
    at: int
    message: str
    advice: str


def note(key: str, at: int, **values: str) -> Note:
    """Return what the table of messages says under a key."""
    code, message, advice = worded(key, **values)
    return Note(code, at, message, advice)


ERROR, NOTE = "error", "note"

Said = tuple[str, Note, str]
"""What is said of a source: ERROR or NOTE, the message with its place, and a hint or ""."""


class Mention:
    """One use of a symbol: its item or place in the source, and whether it is defined there."""

    def __init__(self, name: str, at: int, defined: bool) -> None:
        self.name = name
        self.at = at
        self.defined = defined


def of_overlays(words: Iterable[Written]) -> list[Note]:
    """Return the notes on addresses that get two words."""
    notes: list[Note] = []
    loaded: set[int] = set()
    last = -1
    for written in words:
        address = written.address
        if address in loaded and not written.literal:
            if last != address - 1:
                notes.append(note("PN02", written.at, address=f"{address:04o}"))
            last = address
        loaded.add(address)
    return notes


def of_words(words: Iterable[Written], instructions: Mapping[str, int]) -> list[Note]:
    """Return the notes on the words of a program, given the symbols that are instructions."""
    notes: list[Note] = []
    cells: dict[int, Written] = {}
    looked_at: dict[str, Note | None] = {}
    for written in words:
        cells[written.address] = written
        if written.word >= IOT << 9:
            key = " ".join(written.names)
            if key not in looked_at:
                looked_at[key] = _combination(written, instructions)
            wrong = looked_at[key]
            if wrong:
                notes.append(wrong._replace(at=written.at))
    return notes + _flow(cells, instructions) + _run(cells, instructions) + _devices(cells, instructions)


def _combination(written: Written, instructions: Mapping[str, int]) -> Note | None:
    """Return the note on symbols that should not be combined in an IOT or OPR, or None."""
    parts = [(name, instructions[name]) for name in written.names if name in instructions]
    parts = [(name, word) for name, word in parts if word >= IOT << 9]
    named = " ".join(name for name, _ in parts)
    if any(word >> 9 == IOT for _, word in parts):
        devices = {word >> 3 for _, word in parts}
        if len(devices) > 1:
            return note("PN01 devices", written.at, names=named, word=f"{written.word:04o}")
        return None
    first = [name for name, word in parts if not word & GROUP_2 and word & ~CLA & 0o377]
    second = [name for name, word in parts if word & GROUP_2]
    if first and second:
        word = _spelled(written.word)
        return note("PN01 groups", written.at, names=named, word=word, one=first[0], other=second[0])
    senses = {word & REVERSED for _, word in parts if word & GROUP_2 and word & (_SKIPS | REVERSED)}
    if len(senses) > 1:
        return note("PN01 skips", written.at, names=named, word=_spelled(written.word))
    rotations = [name for name, word in parts if not word & GROUP_2 and word & 0o014]
    if len(set(rotations)) > 1:
        return note("PN01 rotates", written.at, names=" and ".join(rotations))
    return None


def _spelled(word: int) -> str:
    from pal.disassembler import microinstruction

    name = microinstruction(word)
    return f"{word:04o}, {name}" if name else f"{word:04o}"


def _is_instruction(written: Written, instructions: Mapping[str, int]) -> bool:
    """Whether a word is written with the name of an instruction."""
    return any(name in instructions for name in written.names)


def _flow(cells: dict[int, Written], instructions: Mapping[str, int]) -> list[Note]:
    """Return the notes on subroutines, returns, and data that the program runs into."""
    notes = []
    called: set[int] = set()
    counted: set[int] = set()
    stored: set[int] = set()
    jumps: list[tuple[Written, int]] = []
    aims: set[int] = set()
    calls: list[tuple[Written, int]] = []
    for written in cells.values():
        operation = written.word >> 9
        if operation > JMP or written.word & INDIRECT or not _is_instruction(written, instructions):
            continue
        if operation >= JMS and _changes_field(cells, written.address):
            continue
        target = refers_to(written.word, written.address)
        if operation == JMP:
            jumps.append((written, target))
            aims.add(target)
        elif operation == JMS:
            called.add(target)
            calls.append((written, target))
        elif operation == DCA:
            stored.add(target)
        else:
            counted.add(target)
    told: set[int] = set()
    for written, target in calls:
        cell = cells.get(target)
        if cell is None or cell.literal or halts(cell.word) or target == written.address:
            continue  # HLT may be a word that is only not 0 yet; JMS . finds its own address
        if _is_instruction(cell, instructions) and target not in told:
            told.add(target)
            notes.append(note("PN07", written.at, target=f"{target:04o}"))
    for written, target in jumps:
        cell = cells.get(target)
        if target in called and cell is not None and not _is_instruction(cell, instructions):
            notes.append(note("PN08", written.at, target=f"{target:04o}"))
    for target in sorted(called | (counted - stored)):
        cell = cells.get(target)
        before = cells.get(target - 1)
        if cell is None or before is None or cell.literal or cell.word >= IOT << 9:
            continue
        if _is_instruction(cell, instructions) or not _is_instruction(before, instructions):
            continue
        after = cells.get(target + 1)
        if target not in called and after is not None and _is_instruction(after, instructions):
            continue  # a constant that is run on purpose
        first = cells.get(target - 2)
        reached = first is None or target - 1 in aims
        if first is not None and not reached and _is_instruction(first, instructions):
            reached = _goes_on(first.word, cells.get(target - 3))
        ends = target not in called and _ends_loop(before, first)
        if ends or (reached and _goes_on(before.word, first)):
            notes.append(note("PN06", cell.at, before=f"{target - 1:04o}", target=f"{target:04o}"))
    return notes


def _run(cells: dict[int, Written], instructions: Mapping[str, int]) -> list[Note]:
    """Return notes on programs and subroutines that, without a branch, leave their words or hang."""
    called = {
        refers_to(cell.word, address) + 1
        for address, cell in cells.items()
        if cell.word >> 8 == JMS << 1
        and _is_instruction(cell, instructions)
        and not _changes_field(cells, address)
    }
    found = [_followed(cells, instructions, START, False)]
    found += [_followed(cells, instructions, start, True) for start in sorted(called - {START})]
    return [each for each in found if each is not None]


def _followed(
    cells: dict[int, Written], instructions: Mapping[str, int], address: int, called: bool
) -> Note | None:
    """Return the note on running from `address`, which may be a subroutine."""
    printing = called  # whether a TLS may have come before
    passed: set[int] = set()
    while address not in passed and address in cells:
        passed.add(address)
        cell = cells[address]
        word = cell.word
        following = cells.get(address + 1)
        waits = tests_flag(word) and following is not None and jumps_to(address, following.word, address + 1)
        if cell.literal or not (waits or _is_instruction(cell, instructions)):
            return None
        if waits:
            device = word >> 3 & 0o77
            if device not in _FITTED:
                return note("PN59", cell.at, device=f"{device:02o}")
            if word == _TSF and not printing:
                return note("PN40", cell.at)
            address += 1
        elif halts(word) or _skips(word) or word >> 9 in (ISZ, JMS) or word >> 8 == JMP << 1 | 1:
            return None
        printing = printing or word in _PRINT
        jumps = word >> 9 == JMP
        if jumps and _changes_field(cells, address):
            return None
        address = refers_to(word, address) if jumps else in_field(address, address + 1)
        if address not in cells and cell.address + 1 == address and (called or len(passed) > 2):
            return note("PN39", cell.at, before=f"{cell.address:04o}", target=f"{address:04o}")
    return None


def _devices(cells: dict[int, Written], instructions: Mapping[str, int]) -> list[Note]:
    """Return the notes on printing without waiting, on interrupts without a handler, on words over BIN."""
    written = [cell for cell in cells.values() if _is_instruction(cell, instructions)]
    used: dict[int, int] = {}
    for cell in written:
        used.setdefault(cell.word, cell.at)
    notes = []
    prints = [cell for cell in written if cell.word in _PRINT]
    again = len(prints) > 1 or any(_jumps_over(cell, prints[0].address) for cell in written if prints)
    if prints and again and not any(word in used for word in (_TSF, _TSK, _ION)):
        notes.append(note("PN58", prints[0].at))
    if _ION in used and 1 not in cells and not any(word in used for word in _HANDLED):
        notes.append(note("PN60", used[_ION]))
    over = [cell.at for address, cell in cells.items() if _LOADERS <= address <= 0o7777]
    if over and min(cells) < 0o7600:
        notes.append(note("PN57", over[0]))
    return notes


def _jumps_over(cell: Written, address: int) -> bool:
    """Whether a word jumps back to an address or to one before it."""
    direct = cell.word >> 8 == JMP << 1
    return direct and refers_to(cell.word, cell.address) <= address <= cell.address


def _changes_field(cells: dict[int, Written], address: int) -> bool:
    """Whether a CIF comes just before, so that a JMP or JMS goes to another field."""
    for before in (address - 1, address - 2, address - 3):
        cell = cells.get(before)
        if cell is not None and changes_field(cell.word):
            return True
    return False


def _goes_on(word: int, before: Written | None) -> bool:
    """Whether `word` may be followed by the next word, other than by ISZ."""
    operation = word >> 9
    if operation == JMS or halts(word):
        return False
    if operation != JMP:
        return True
    return before is not None and _skips(before.word) and bool(before.names)


def _ends_loop(written: Written, before: Written | None) -> bool:
    """Whether a word is the JMP back of a loop that an ISZ before it ends."""
    back = refers_to(written.word, written.address) <= written.address
    is_jump = written.word >> 9 == JMP and not written.word & INDIRECT
    return is_jump and back and before is not None and before.word >> 9 == ISZ


def _skips(word: int) -> bool:
    if word >> 9 == OPR:
        return word & 0o7401 == 0o7400 and bool(word & (_SKIPS | REVERSED))
    return tests_flag(word) and word & 0o7700 != 0o6200  # not the memory extension's


def of_model(words: Iterable[Written], model: str) -> list[Note]:
    """Return a note for each word that other models than `model` execute otherwise. Raises ValueError."""
    from pal.models import differs

    found = [(written.at, written.word, differs(written.word, model)) for written in words]
    return [note("PN38", at, octal=f"{word:04o}", differs=said) for at, word, said in found if said]


def meant(name: str, known: Iterable[str]) -> str | None:
    """Return the symbol that was probably meant by an undefined one, None if none is near."""
    if name in _SAME_AS:
        return _SAME_AS[name]
    return next((other for other in known if other != name and _near(name, other)), None)


def _near(name: str, other: str) -> bool:
    """Whether two names differ by two letters exchanged, one letter more, or one letter of five or more."""
    shorter = min(len(name), len(other))
    start = [*(one == two for one, two in zip(name, other, strict=False)), False].index(False)
    rest, others = name[start:], other[start:]
    if rest in (others[1:], others[1:2] + others[:1] + others[2:]) or rest[1:] == others:
        return shorter > 2
    return shorter > 4 and rest[1:] == others[1:]


def of_undefined(undefined: Iterable[tuple[str, int, int]], known: Iterable[str]) -> list[Note]:
    """Return notes on undefined symbols, (name, place, statement): a similar name, or a line of text."""
    lines: dict[int, list[tuple[str, int]]] = {}
    for name, at, line in undefined:
        lines.setdefault(line, []).append((name, at))
    notes = []
    names = list(known)
    asked = 0
    for found in lines.values():
        if len(found) > 1:
            notes.append(note(NO_SLASH, found[0][1]))
            continue
        name, at = found[0]
        asked += 1
        other = meant(name, names) if asked <= ASKED else None
        if other:
            notes.append(note(MEANT, at, name=name, other=other))
    return notes


def of_names(mentions: Iterable[tuple[str, int]], permanent: Iterable[str]) -> list[Note]:
    """Return notes on names, each with its place, that differ only after their first six characters."""
    notes = []
    spelled: dict[str, str] = {}
    known = set(permanent)
    told: set[str] = set()
    for name, at in mentions:
        cut = name[:SIGNIFICANT]
        first = spelled.setdefault(cut, name)
        if cut in told or cut in known or first.startswith(name) or name.startswith(first):
            continue  # the same name, shortened
        told.add(cut)
        notes.append(note("PN09", at, name=name, first=first))
    return notes
