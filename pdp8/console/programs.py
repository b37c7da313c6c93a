"""Programs with their listings, and which of them is in core where the PC points.

A listing is believed where it says of the PC's address what core says: so RIM's is shown while RIM runs, then
BIN's, then the program's own.
"""

from collections.abc import Iterable
from typing import NamedTuple

import pal
from tapes import kinds, rim, shelf
from tapes.errors import WorkError, naming

RIM, BIN = "rim.pal", "bin.pal"


class Program(NamedTuple):
    """A program: its listing line by line, what is in core when it is loaded, and the tape to load.

    `lines` are as pass 3 typed them, TABs counted from where the source begins; `places` is {address: number
    of its line}.
    """

    name: str
    lines: tuple[str, ...]
    places: dict[int, int]
    words: dict[int, int]
    tape: bytes


def read(name: str) -> Program:
    """Return the program called `name`: PAL source, or a BIN or RIM tape, which is listed disassembled.

    Raises WorkError saying what is wrong with it, and where.
    """
    frames = shelf.read(name)
    kind = kinds.classify(frames)
    if kind in (kinds.BIN, kinds.RIM):
        from pal.disassembler import disassemble_tape

        with naming(name):
            source: str | bytes = disassemble_tape(frames)
        return listed(name, pal.assemble(source), frames)
    if kind not in (kinds.ASCII, kinds.BLANK_TAPE):
        raise WorkError(f"{name}: neither PAL source nor a BIN or RIM tape")
    assembly = pal.assemble(frames, names=[name])
    if not assembly.ok:
        report = "\n".join(str(diagnostic) for diagnostic in assembly.diagnostics)
        raise WorkError(f"{name}: not loaded, it has errors\n{report}")
    if not assembly.words:
        raise WorkError(f"{name}: no word in it goes into core")
    return listed(name, assembly, rim.encode(assembly.words) if name == BIN else assembly.tape)


def listed(name: str, assembly: pal.Assembly, tape: bytes) -> Program:
    """Return the program of an assembly, with its tape."""
    lines: list[str] = []
    places = {}
    for line in assembly.lines:
        if line.address is None or line.word is None:
            lines.append(f"{'':12}{line.source.expandtabs()}".rstrip())
        else:
            places[line.address] = len(lines)
            lines.append(f"{line.address:04o}  {line.word:04o}  {line.source.expandtabs()}".rstrip())
    return Program(name, tuple(lines), places, assembly.words, tape)


def fitting(programs: Iterable[Program], address: int, word: int) -> Program | None:
    """Return the first of the programs that has `word` at `address`, None if none has."""
    return next((program for program in programs if program.words.get(address) == word), None)
