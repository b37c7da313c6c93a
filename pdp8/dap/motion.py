"""Steps: into, over and out of subroutines, forwards; and back.

A JMS is stepped over by running until its subroutine returns: until the PC is what the subroutine's first
word says, which the subroutine itself may have moved past arguments. What is stepped over may be an interrupt
as well: its routine returns through word 0.
"""

from collections.abc import Callable
from typing import NamedTuple

from pal.isa import EXECUTE, ISZ, JMS, in_field, refers_to
from pdp8.computer.hardware.signals import CYCLE, INTERRUPT, TICKS_PER_SECOND
from pdp8.computer.machine import Machine
from pdp8.computer.past import rewind
from pdp8.computer.past.history import History, HistoryError
from pdp8.computer.stop import Stop
from pdp8.computer.watch import Watch
from pdp8.dap import calls
from tapes.errors import WorkError

Look = Callable[[float], None]
"""What is called while a search goes back, with the part of the history that it has searched."""


class Goal(NamedTuple):
    """The end of the subroutine at `entry` that was called from the field of `caller`; after an interrupt the
    instruction is still to be executed.
    """

    entry: int
    caller: int
    interrupt: bool = False

    def places(self, machine: Machine) -> set[int]:
        """Return the subroutine's return addresses, past arguments if it counts up its first word."""
        core = machine.core
        back = core[self.entry]
        counts = any(
            word >> 8 == ISZ << 1 and refers_to(word, address) == self.entry
            for address, word in enumerate(core)
        )
        places = [
            in_field(self.caller, back + offset) for offset in range(2 * calls.ARGUMENTS if counts else 1)
        ]
        return set(places[: places.index(self.entry)] if self.entry in places else places)

    def reached(self, machine: Machine) -> bool:
        """Tell whether it has returned."""
        return machine.pc == in_field(self.caller, machine.core[self.entry])


def into(machine: Machine) -> Stop:
    """Do one instruction, or the cycle of an interrupt."""
    if machine.processor.next == INTERRUPT:
        return machine.run(seconds=CYCLE / TICKS_PER_SECOND)
    return machine.run(instructions=1)


def over(machine: Machine) -> tuple[Stop, Goal | None]:
    """Execute one instruction; return the goal too if it was a call or interrupted."""
    p, caller = machine.processor, machine.pc
    interrupt = p.next == INTERRUPT
    stop = into(machine)
    called = p.state == EXECUTE and p.ir == JMS
    return stop, Goal(machine.ma, caller, interrupt) if called else None


def out(machine: Machine) -> Goal:
    """Return the end of the subroutine that the machine is in. Raises WorkError outside of one."""
    inner, *callers = calls.of(machine)
    if inner.entry is None:
        raise WorkError(f"{machine.pc:04o} is in no subroutine that was called by JMS: there is no way out")
    return Goal(inner.entry, callers[0].address)


def back_to(
    history: History, watched: Watch, stops: Callable[[bool], bool] | None = None, look: Look | None = None
) -> bool:
    """Undo as far as the last stop, as rewind.until_stopped does; else all. Returns whether there was one."""
    try:
        rewind.until_stopped(history, watched, "no breakpoint was reached", stops, look)
    except HistoryError:
        rewind.instructions(history, history.instructions)
        return False
    return True
