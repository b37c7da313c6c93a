"""The processor of the package, led through the operator's actions to any instant of the page."""

from pal.isa import FETCH
from pdp8.computer.hardware.signals import CYCLE, TICKS_PER_SECOND
from pdp8.computer.machine import Machine
from pdp8.computer.use.operator import Action
from pdp8.replay import Afternoon

IO_CYCLE = 85
_NEARLY = 4 * (IO_CYCLE + CYCLE)  # ticks before an instant from which on every cycle is done by itself


class Follower:
    """A machine that does the afternoon again, forward only."""

    def __init__(self, afternoon: Afternoon) -> None:
        self.afternoon = afternoon
        self.machine = Machine()
        self.actions = list(afternoon.actions)

    def to(self, tick: int) -> None:
        """Go on to the last cycle that ends at or before `tick`."""
        while self.actions and self.actions[0].at <= tick:
            action = self.actions.pop(0)
            self._run(action.at)
            assert self.machine.processor.clock == action.at
            self._do(action)
        self._run(tick)

    def _run(self, tick: int) -> None:
        machine, processor = self.machine, self.machine.processor
        if processor.run and processor.clock + _NEARLY < tick:
            while processor.next != FETCH:
                processor.cycle()
            machine.run(seconds=(tick - _NEARLY - processor.clock) / TICKS_PER_SECOND)  # or less, if in vain
        while processor.run and processor.clock + self._next_cycle() <= tick:
            processor.cycle()
        if not processor.run:
            machine.wait((tick - processor.clock) / TICKS_PER_SECOND)
        machine.bus.advance(processor.clock)

    def _next_cycle(self) -> int:
        processor = self.machine.processor
        iot = processor.next == FETCH and processor.core[processor.pc] >> 9 == 6
        return IO_CYCLE if iot else CYCLE

    def _do(self, action: Action) -> None:
        panel, reader = self.machine.panel, self.machine.teletype.reader
        match action.key, action.value:
            case "sr", int(switches):
                panel.sr = switches
            case "mount", tape:
                reader.lever(False)
                reader.load(self.afternoon.tapes[str(tape)])
            case "lever", _:
                reader.lever(True)
            case key, _:
                getattr(panel, key.replace(" ", "_"))()


def state(machine: Machine) -> dict[str, object]:
    """Return all values of a machine, but for what it notes of its own runs."""
    return {name: value for name, value in machine.values().items() if not name.startswith("waiting")}
