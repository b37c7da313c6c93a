"""What a run goes on until, and steps forward by it; past/rewind.py has the steps back.

address, word                     an address is come to, a word becomes another one
flag, frame, block, character     a flag of the Teletype rises, a frame or an end of block is punched,
                                  a character is read, printed or typed
"""

from collections.abc import Callable, MutableSequence

from pdp8.computer.hardware.signals import TICKS_PER_SECOND
from pdp8.computer.hardware.teletype import Teletype
from pdp8.computer.machine import Machine
from pdp8.computer.past.history import History
from pdp8.computer.stop import Reason
from tapes.eia import EOB

REACHED = "reached"
"""Why a run ended at its goal, where it is not a breakpoint."""

_FAR = {"character": 3 * TICKS_PER_SECOND, "block": 30 * TICKS_PER_SECOND}
"""Ticks that a step may take at most."""

_GLANCE = TICKS_PER_SECOND // 100
"""Ticks: a character takes ten times as long."""


class Goal:
    """No goal: a run ends by itself, or at a breakpoint."""

    def run(self, machine: Machine, ticks: int) -> str:
        """Run for `ticks` at most; return why the run ended."""
        return machine.run(seconds=ticks / TICKS_PER_SECOND).reason

    def over(self) -> None:
        """Leave what is watched as it was."""


class _Met(Goal):
    """An address among the breakpoints, or among the words that are written, until its word is another."""

    def __init__(self, core: MutableSequence[int], places: set[int], address: int, written: bool) -> None:
        self._core, self._places, self._address = core, places, address
        self._before = core[address] if written else None
        self._had = address in places
        places.add(address)

    def run(self, machine: Machine, ticks: int) -> str:
        """Run to it; a word that is written and stays the same ends nothing."""
        reason = super().run(machine, ticks)
        same = self._core[self._address] == self._before
        return Reason.LIMIT if same and reason == Reason.BREAKPOINT else reason

    def over(self) -> None:
        """Watch the address no more, unless it was watched before."""
        if not self._had:
            self._places.discard(self._address)


class _Grown(Goal):
    """A number of the Teletype grows. It is looked at after each event and each `_GLANCE`: an event that an
    instruction begins takes longer than that.
    """

    def __init__(self, counted: Callable[[Teletype], list[int]]) -> None:
        self._counted = counted

    def run(self, machine: Machine, ticks: int) -> str:
        """Run to the next event, or for a glance."""
        clock = machine.processor.clock
        before = self._counted(machine.teletype)
        event = max(1, machine.bus.next_event(clock) - clock)
        reason = super().run(machine, min(ticks, event, _GLANCE))
        after = self._counted(machine.teletype)
        return REACHED if any(now > then for now, then in zip(after, before, strict=True)) else reason


def _flags(teletype: Teletype) -> list[int]:
    return [teletype.receiver.flag, teletype.transmitter.flag]


def _frames(teletype: Teletype) -> list[int]:
    return [len(teletype.punch.frames)]


def _blocks(teletype: Teletype) -> list[int]:
    frames = teletype.punch.frames
    return [len(frames) if frames[-1:] == bytes([EOB]) else 0]


def _characters(teletype: Teletype) -> list[int]:
    return [teletype.reader.position + len(teletype.printer.frames) - len(teletype.keyboard.waiting)]


_COUNTED = {"flag": _flags, "frame": _frames, "block": _blocks, "character": _characters}


def until(machine: Machine, kind: str, address: int) -> Goal:
    """Return the goal of that kind, at `address` where it has one."""
    core, watch = machine.processor.core, machine.watch
    if kind == "address":
        return _Met(core, watch.breakpoints, address, written=False)
    if kind == "word":
        return _Met(core, watch.writes, address, written=True)
    return _Grown(_COUNTED[kind])


def forward(history: History, unit: str) -> str:
    """Do one cycle, instruction, character or block; return why it ended, Reason.LIMIT if by itself."""
    machine = history.machine
    processor = machine.processor
    if unit == "instruction":
        return machine.run(instructions=1).reason
    if unit == "cycle":
        return machine.run(cycles=1).reason
    goal = _Grown(_COUNTED[unit])
    end = processor.clock + _FAR[unit]

    def work() -> str:
        reason: str = Reason.LIMIT
        while reason == Reason.LIMIT and processor.clock < end:
            reason = goal.run(machine, end - processor.clock)
        return reason

    reason = history.together(work)
    return Reason.LIMIT if reason == REACHED else reason
