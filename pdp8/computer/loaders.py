"""Loading as it was done: RIM toggled in at the panel, RIM reads BIN, BIN reads the program.

    panel ──17 words──► RIM loader, 7756-7776
    BIN loader's tape, RIM format ──► RIM loader ──► 7600-7755, 7777
    program's tape, BIN format ──► BIN loader ──► core, checksum in AC

`boot` is the operator: MEM PROT down, each tape on its leader, SR and LOAD ADD as the books say, STOP when
RIM's tape has run through. Only what the tapes take is machine time; what the operator's hands take is
counted in keys.

Sources: PDP-8/I instruction card (the RIM loader's words); Small Computer Handbook 1970, "Loading programs".
"""

from collections.abc import Iterable
from typing import NamedTuple

from pdp8.computer.machine import LoadError, Machine
from pdp8.computer.panel import Panel
from tapes import kinds
from tapes.frames import LEADER

RIM_START = 0o7756
BIN_START = 0o7777
BIN_HALT = 0o7700
TELETYPE_READER = 0o7777
HIGH_SPEED_READER = 0o3777

# The card's two versions; they differ in the reader's IOTs and in where the loop begins.
RIM = (
    *(0o6032, 0o6031, 0o5357, 0o6036, 0o7106, 0o7006, 0o7510, 0o5357),
    *(0o7006, 0o6031, 0o5367, 0o6034, 0o7420, 0o3776, 0o3376, 0o5356, 0o0000),
)
RIM_HIGH_SPEED = (
    *(0o6014, 0o6011, 0o5357, 0o6016, 0o7106, 0o7006, 0o7510, 0o5374),
    *(0o7006, 0o6011, 0o5367, 0o6016, 0o7420, 0o3776, 0o3376, 0o5357, 0o0000),
)


class Step(NamedTuple):
    """One thing the operator did: keys pressed at the panel, or a tape read in `seconds` of machine time."""

    what: str
    keys: int
    frames: int
    seconds: float

    def __str__(self) -> str:
        if not self.frames:
            return f"{self.what}: {self.keys} keys"
        minutes, seconds = divmod(round(self.seconds), 60)
        return f"{self.what}: {self.frames} frames, {minutes} min {seconds} s"


def toggle(panel: Panel, address: int, words: Iterable[int]) -> int:
    """Put `words` into core from `address` on with the switches; return how many keys that took."""
    panel.sr = address
    panel.load_add()
    keys = 1
    for word in words:
        panel.sr = word
        panel.dep()
        keys += 1
    return keys


def boot(machine: Machine, bin_loader: bytes, program: bytes, program_name: str = "program") -> list[Step]:
    """Load `program`, a BIN or RIM tape, from cold through the Teletype; `bin_loader` is BIN's RIM tape.

    Leaves the machine standing still, the reader empty. Raises LoadError if a loader ends as it should not.
    """
    panel = machine.panel
    panel.stop()
    panel.mem_prot = panel.sing_step = False
    steps = [Step("RIM loader toggled in", toggle(panel, RIM_START, RIM), 0, 0.0)]
    steps.append(read_rim(machine, bin_loader, "BIN loader"))
    if kinds.classify(program) == kinds.RIM:
        steps.append(read_rim(machine, program, program_name))
    else:
        steps.append(read_bin(machine, program, program_name))
    return steps


def read_rim(machine: Machine, tape: bytes, name: str = "tape") -> Step:
    """Let the RIM loader read `tape`; press STOP when it has run through. Raises LoadError if it does not."""
    panel = machine.panel
    seconds, reason = _read(machine, RIM_START, RIM_START, tape)
    if reason != "tape out":
        raise LoadError(f"{name}: the RIM loader ended with {reason} at {machine.pc:04o}")
    panel.stop()
    return Step(f"{name} read by RIM", 2, _length(tape), seconds)


def read_bin(machine: Machine, tape: bytes, name: str = "tape") -> Step:
    """Let the BIN loader read `tape` from the Teletype. Raises LoadError unless it halts with AC = 0."""
    seconds, reason = _read(machine, BIN_START, TELETYPE_READER, tape)
    machine.teletype.reader.remove()
    if reason != "halt" or machine.ma != BIN_HALT:
        raise LoadError(
            f"{name}: the BIN loader ended with {reason} at {machine.pc:04o}, not with HLT at 7700"
        )
    if machine.ac:
        raise LoadError(f"{name}: the BIN loader halted with AC = {machine.ac:04o}: wrong checksum")
    return Step(f"{name} read by BIN", 2, _length(tape), seconds)


def _read(machine: Machine, start: int, switches: int, tape: bytes) -> tuple[float, str]:
    """Start the loader at `start` with `tape` on its leader; return the seconds and why it ended."""
    panel, reader = machine.panel, machine.teletype.reader
    reader.load(tape[_leader(tape) :])
    panel.sr = start
    panel.load_add()
    panel.sr = switches
    panel.start()
    stop = machine.run()
    return stop.elapsed, stop.reason


def _leader(tape: bytes) -> int:
    """Return where the operator puts the tape: on the first frame of leader, if it has one."""
    return max(tape.find(LEADER), 0)


def _length(tape: bytes) -> int:
    return len(tape) - _leader(tape)
