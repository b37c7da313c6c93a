"""The room as the operator finds it: what is in core, in the reader, and at hand."""

from collections.abc import Callable
from time import perf_counter
from typing import NamedTuple

from pdp8.computer.machine import Machine
from pdp8.computer.use import program as programs
from pdp8.computer.use.program import Program
from pdp8.console.session import Session, Tape
from tapes import rim, shelf

RIM, BIN = "rim.pal", "bin.pal"
PROGRAM = "eia.pal"
DATA = ("circle.asc", "ellipse.asc")


class Opening(NamedTuple):
    """A session and the programs whose listings lie ready: RIM, BIN and the one it is about."""

    session: Session
    programs: list[Program]


def opening(
    program: str | None = None,
    reader: str | None = None,
    start: int = 0o200,
    cold: bool = False,
    clock: Callable[[], float] = perf_counter,
) -> Opening:
    """Return the room: `program` in core and the PC at `start`, or `cold`, as it is without a program.

    `reader` names the tape in the reader, `clock` tells the computer's own seconds. Raises WorkError for what
    cannot be read.
    """
    found = [_bundled(RIM), _bundled(BIN), programs.find(program) if program else _bundled(PROGRAM)]
    machine = Machine()
    session = Session(machine, [Tape(name, frames) for name, frames in _at_hand(found[1:])], clock)
    if reader:
        session.tapes.append(Tape(reader, shelf.read(reader)))
        session.mount(session.tapes[-1])
    if program and not cold:
        machine.load(found[-1].words)
        machine.sr = start
        session.press("load_add")
    return Opening(session, found)


def _bundled(name: str) -> Program:
    return programs.read(shelf.read_bundled(name), name)


def _at_hand(programs: list[Program]) -> list[tuple[str, bytes]]:
    bin_loader, program = programs
    loaders = [("bin.rim", rim.encode(bin_loader.words)), (_tape_name(program.name), program.tape)]
    return loaders + [(name, shelf.read_bundled(name)) for name in DATA]


def _tape_name(program: str) -> str:
    """Return what is written on a program's tape."""
    return f"{program.removesuffix('.pal')}.bin" if program.endswith(".pal") else program
