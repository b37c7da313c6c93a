"""The room as the operator finds it: what is in core, in the reader, and at hand."""

import os
from collections.abc import Callable
from time import perf_counter

from pdp8 import shelf
from pdp8.computer.hardware.extension import FIELD
from pdp8.computer.machine import Machine
from pdp8.computer.use.program import Program
from pdp8.console.session import Session, Tape
from tapes import codes, rim

DATA = ("circle.asc", "ellipse.asc")


def label(program: Program) -> str:
    """Return the name of the tape that loads a program: a source is punched in BIN format."""
    return f"{os.path.splitext(program.name)[0]}.bin" if program.code is codes.ASCII else program.name


def opening(
    program: str | None = None,
    reader: str | None = None,
    start: int = 0o200,
    cold: bool = False,
    clock: Callable[[], float] = perf_counter,
    memory: int = FIELD,
) -> tuple[Session, list[Program]]:
    """Return the session and its listings' programs; `program` is in core and the PC at `start`, unless
    `cold`; `reader` names a tape, `clock` gives real seconds, core has `memory` words. Raises WorkError for
    an unreadable file.
    """
    rim_loader, loader = shelf.bundled_program("rim.pal"), shelf.bundled_program("bin.pal")
    last = shelf.program(program, memory=memory) if program else shelf.bundled_program("eia.pal")
    tapes = [Tape("bin.rim", rim.encode(loader.words)), Tape(label(last), last.tape)]
    machine = Machine(memory=memory)
    session = Session(machine, [*tapes, *(Tape(name, shelf.read_bundled(name)) for name in DATA)], clock)
    if reader:
        session.lay(Tape(reader, shelf.read(reader)))
        session.mount(session.tapes[-1])
    if program and not cold:
        machine.load(last.words)
        session.listing = last.listing
        machine.panel.inst_field = start >> 12
        machine.sr = start & 0o7777
        session.press("load_add")
    notes = (*last.notes, *(last.notes_on(start, "--start") if program and not cold else ()))
    if notes:
        session.said = f"{last.name}: {'; '.join(notes)}"
    return session, [rim_loader, loader, last]
