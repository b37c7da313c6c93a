"""The goals at which a run ends, and steps forward by them; past/rewind.py has the steps back.

address, word                     an address is reached, a word changes
flag, frame, block, character     a flag of the Teletype rises, a frame or an end of block is punched,
                                  a character is read, printed or typed
"""

from collections.abc import Callable

from pal.isa import FETCH
from pdp8.computer.hardware.signals import TICKS_PER_SECOND
from pdp8.computer.hardware.teletype import Teletype
from pdp8.computer.machine import Machine
from pdp8.computer.past.history import History
from pdp8.computer.stop import Reason
from tapes.eia import EOB

REACHED = "reached"
"""Why a run ended at its goal; the goal's `said` tells what happened."""

_FAR = {"character": 3 * TICKS_PER_SECOND, "block": 30 * TICKS_PER_SECOND}
"""Ticks that a step may take at most."""

_GLANCE = TICKS_PER_SECOND // 100
"""Ticks: a character takes ten times as long."""


class Goal:
    """How far to run; this one sets no end, so that a run ends by itself or at a breakpoint."""

    def __init__(self) -> None:
        self.said = ""
        """What happened, once the goal is reached."""
        self.added: int | None = None
        """The address that is watched for this goal alone."""

    def run(self, machine: Machine, ticks: int) -> str:
        """Run for `ticks` at most, or to a breakpoint, the last tick included; return why the run ended."""
        reason = machine.run(seconds=ticks / TICKS_PER_SECOND).reason
        return Reason.BREAKPOINT if reason == Reason.LIMIT and _at_a_breakpoint(machine) else reason

    def cycle(self, machine: Machine) -> str:
        """Run one memory cycle; return why the run ended, Reason.LIMIT if it goes on."""
        machine.processor.run = 1
        machine.watch.cycle(machine.processor)
        if not machine.processor.run:
            return machine.why_stopped()
        return Reason.BREAKPOINT if _at_a_breakpoint(machine) else Reason.LIMIT

    def over(self) -> None:
        """Restore the watched addresses."""


def _at_a_breakpoint(machine: Machine) -> bool:
    """Whether the machine is at a breakpoint: the next instruction or the target of the JMS just done."""
    p, watch = machine.processor, machine.watch
    return p.next == FETCH and (machine.pc in watch.breakpoints or watch.called(p))


class _Watched(Goal):
    """Adds an address to the breakpoints or watched words until the run is over."""

    def __init__(self, places: set[int], address: int) -> None:
        super().__init__()
        self.address = address
        self.added = None if address in places else address
        self._places = places
        places.add(address)

    def over(self) -> None:
        """Stop watching the address, unless it was watched before."""
        if self.added is not None:
            self._places.discard(self.added)


class _Changed(_Watched):
    """A word changes; writing the same value does not count."""

    def __init__(self, machine: Machine, address: int) -> None:
        super().__init__(machine.watch.writes, address)
        self._before = machine.core[address]

    def run(self, machine: Machine, ticks: int) -> str:
        """Run until the word has changed."""
        return self._met(machine, super().run(machine, ticks))

    def cycle(self, machine: Machine) -> str:
        """Run one memory cycle, which may change it."""
        return self._met(machine, super().cycle(machine))

    def _met(self, machine: Machine, reason: str) -> str:
        word = machine.core[self.address]
        if word != self._before:
            self.said = f"the word at {self.address:04o} has changed from {self._before:04o} to {word:04o}"
            return REACHED
        same = reason == Reason.BREAKPOINT and not _at_a_breakpoint(machine)
        return Reason.LIMIT if same else reason


class _Grown(Goal):
    """A number of the Teletype grows; it is checked after each event and each `_GLANCE`, which is shorter."""

    def __init__(self, counted: Callable[[Teletype], list[int]], said: list[str]) -> None:
        super().__init__()
        self._counted = counted
        self._told = said

    def run(self, machine: Machine, ticks: int) -> str:
        """Run to the next event, or for a glance."""
        clock = machine.processor.clock
        before = self._counted(machine.teletype)
        event = max(1, machine.bus.next_event(clock) - clock)
        reason = super().run(machine, min(ticks, event, _GLANCE))
        return self._met(machine, before, reason)

    def cycle(self, machine: Machine) -> str:
        """Run one memory cycle and bring the Teletype up to its end."""
        before = self._counted(machine.teletype)
        reason = super().cycle(machine)
        machine.bus.advance(machine.processor.clock)
        return self._met(machine, before, reason)

    def _met(self, machine: Machine, before: list[int], reason: str) -> str:
        for then, now, said in zip(before, self._counted(machine.teletype), self._told, strict=True):
            if now > then:
                self.said = said
                return REACHED
        return reason


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
_TOLD = {
    "flag": ["the flag of the keyboard and reader has risen", "the flag of the printer and punch has risen"],
    "frame": ["a frame has been punched"],
    "block": ["a block has been punched"],
    "character": ["a character has passed"],
}


def until(machine: Machine, kind: str, address: int) -> Goal:
    """Return the goal of that kind, at `address` where it has one."""
    if kind == "address":
        return _Watched(machine.watch.breakpoints, address)
    return _Changed(machine, address) if kind == "word" else _grown(kind)


def _grown(kind: str) -> Goal:
    return _Grown(_COUNTED[kind], _TOLD[kind])


def forward(history: History, unit: str) -> str:
    """Run one cycle, instruction, character or block; return Reason.LIMIT, or why it stopped."""
    machine = history.machine
    processor = machine.processor
    if unit == "instruction":
        return machine.run(instructions=1).reason
    if unit == "cycle":
        return machine.run(cycles=1).reason
    goal = _grown(unit)
    end = processor.clock + _FAR[unit]

    def work() -> str:
        reason: str = Reason.LIMIT
        while reason == Reason.LIMIT and processor.clock < end:
            reason = goal.run(machine, end - processor.clock)
        return reason

    reason = history.together(work)
    return Reason.LIMIT if reason == REACHED else reason
