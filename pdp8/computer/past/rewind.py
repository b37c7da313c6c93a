"""Undo what a machine has done, by a number of instructions, seconds or frames, or to an event.

    instructions, cycles    so many of them
    seconds                 so much machine time
    characters, blocks      so many frames that the Teletype printed, ends of block that it punched
    until_left, until_written, until_stopped, until_flag    to the last time that something happened

Each raises HistoryError, and leaves the machine as it is, where the history does not go back so far.
"""

from collections.abc import Callable, Iterator
from contextlib import contextmanager

from pal.isa import FETCH
from pdp8.computer.hardware.signals import TICKS_PER_SECOND
from pdp8.computer.machine import Machine
from pdp8.computer.past.history import History, HistoryError
from pdp8.computer.stop import Reason
from pdp8.computer.watch import Watch
from tapes.eia import EOB

_SEARCHED = TICKS_PER_SECOND // 4
"""Ticks that are searched through at a time."""
_GLANCE = TICKS_PER_SECOND // 400
"""Ticks: a flag that an instruction lets rise takes longer."""


def instructions(history: History, count: int = 1) -> None:
    """Undo `count` instructions, and what was set since."""
    _check(count, history.instructions, "instructions")
    with history.going_back():
        history.go_to_instruction(history.machine.instructions - count)


def seconds(history: History, time: float) -> None:
    """Undo `time` seconds of machine time, as far as the end of an instruction."""
    _check(time, history.seconds, "seconds")
    with history.going_back():
        history.go_to_tick(history.machine.processor.clock - round(time * TICKS_PER_SECOND))


def cycles(history: History, count: int = 1) -> None:
    """Undo `count` memory cycles; the machine may then stand within an instruction."""
    machine = history.machine
    now = machine.processor.clock
    with history.going_back():
        history.go_to_instruction(machine.instructions - min(count, history.instructions))
        start = machine.values()
        done = 0
        while machine.processor.clock < now:
            machine.processor.cycle()
            done += 1
        _check(count, done, "cycles")
        machine.put(start)
        for _ in range(done - count):
            machine.processor.cycle()


def characters(history: History, count: int = 1) -> None:
    """Undo as far as before the last `count` frames that the Teletype printed."""
    _before(history, "printer", history.machine.teletype.printer.frames, len, count, "characters")


def blocks(history: History, count: int = 1) -> None:
    """Undo as far as before the last `count` ends of block, 200, that the Teletype punched."""
    _before(history, "punch", history.machine.teletype.punch.frames, _ends, count, "blocks")


def until_left(history: History, address: int) -> None:
    """Undo as far as before `address` was last executed, or after the last JMS to it."""
    watched = Watch()
    watched.breakpoints.add(address)
    until_stopped(history, watched, f"nothing was executed at {address:04o}")


def until_written(history: History, address: int) -> None:
    """Undo as far as before the last instruction that wrote the word at `address`."""
    watched = Watch()
    watched.writes.add(address)
    until_stopped(history, watched, f"nothing was written at {address:04o}")


def until_stopped(
    history: History,
    watched: Watch,
    otherwise: str,
    stops: Callable[[bool], bool] | None = None,
    look: Callable[[float], None] | None = None,
) -> None:
    """Undo to the last breakpoint, or use of a watched word (True), at which `stops` holds; `look` gets the
    part searched, 0 to 1; if it raises, the machine is not changed.
    """

    def holds(of_words: bool) -> bool:
        return stops is None or stops(of_words)

    def step(machine: Machine, clock: int) -> list[int]:
        watch = machine.watch
        watch.breakpoints, watch.writes, watch.reads = watched.breakpoints, watched.writes, watched.reads
        found: list[int] = []
        if machine.pc in watch.breakpoints and machine.processor.next == FETCH and holds(False):
            found.append(machine.instructions)
        if _run_to(machine, clock) is Reason.BREAKPOINT:
            if (watch.written or watch.read) and holds(True):
                found.append(machine.instructions - 1)
            if watch.called(machine.processor) and holds(False):
                found.append(machine.instructions)
        return found

    _search(history, step, otherwise, look)


def until_flag(history: History, code: int) -> None:
    """Undo as far as the last instruction after which the flag of device `code` had risen."""
    device = history.machine.bus.device(code)
    if device is None:
        raise HistoryError(f"device {code:02o} is not fitted")

    def step(machine: Machine, clock: int) -> list[int]:
        down, now = not device.flag, machine.processor.clock
        _run_to(machine, min(clock, machine.bus.next_event(now), now + _GLANCE))
        return [machine.instructions] if down and device.flag else []

    _search(history, step, f"the flag of device {code:02o} did not rise", None)


_Step = Callable[[Machine, int], list[int]]


def _search(history: History, step: _Step, otherwise: str, look: Callable[[float], None] | None) -> None:
    """Go to the last moment that `step` finds: it runs to a tick at most and returns instruction counts."""
    machine = history.machine
    now, end = machine.instructions, machine.processor.clock
    latest = end
    oldest = history.snapshots()[-1].clock
    ticks = _SEARCHED
    with history.going_back():
        again = machine.watch
        while end > oldest:
            begin = max(oldest, end - ticks)
            history.go_to_tick(begin)
            been = (latest - end) / (latest - oldest)
            machine.watch = Watch()
            found = [number for number in _hits(history, step, end, look, been) if number < now]
            machine.watch = again
            if found:
                history.go_to_instruction(found[-1])
                return
            end, ticks = begin, 2 * ticks
        raise HistoryError(f"{otherwise} as far as the history goes back")


def _hits(
    history: History, step: _Step, end: int, look: Callable[[float], None] | None, been: float
) -> Iterator[int]:
    machine = history.machine
    for clock in history.ahead(end):
        while machine.processor.clock < clock:
            if look is not None:
                look(been)
            yield from step(machine, clock)


def _run_to(machine: Machine, clock: int) -> Reason:
    ticks = max(1, clock - machine.processor.clock)
    return machine.run(seconds=ticks / TICKS_PER_SECOND).reason


def _units(count: float, what: str) -> str:
    return what.removesuffix("s") if count == 1 else what


def _check(count: float, most: float, what: str) -> None:
    if not 0 <= count <= most:
        raise HistoryError(
            f"{count:,} {_units(count, what)} cannot be undone: the history goes back {most:,}"
        )


def _ends(frames: bytes) -> int:
    return frames.count(EOB)


def _before(
    history: History, part: str, frames: bytearray, counted: Callable[[bytes], int], count: int, what: str
) -> None:
    """Go to the last moment at which the frames counted were `count` fewer than now."""
    now = counted(bytes(frames))
    _check(count, now, what)
    if count == 0:
        return
    fewer = now - count + 1
    below, above = -1, history.machine.instructions
    with history.going_back():
        for number, then in history.kept(f"devices 04 {part} frames"):  # a tape that is taken off has none
            if counted(then) < fewer:
                below = number
                break
            above = number
        if below < 0:
            raise HistoryError(
                f"{count:,} {_units(count, what)} cannot be undone: the history does not go back so far"
            )
        while above - below > 1:
            middle = (below + above) // 2
            history.go_to_instruction(middle)
            below, above = (below, middle) if counted(bytes(frames)) >= fewer else (middle, above)
        history.go_to_instruction(below)


@contextmanager
def looking_back(history: History) -> Iterator[None]:
    """Let the machine go back and run on inside; restore it afterwards."""
    machine = history.machine
    now, endless = machine.values(), machine.waiting.endless
    with history.going_back():
        try:
            yield
        finally:
            machine.put(now)
            machine.waiting.endless = endless


def come_to(history: History, end: int, places: set[int], stops: Callable[[], bool]) -> bool:
    """Run on to the first of `places` at which `stops` holds; return whether one comes before tick `end`."""
    machine = history.machine
    for clock in history.ahead(end):
        machine.watch.breakpoints = places
        while machine.processor.clock < clock:
            reason = _run_to(machine, clock)
            if reason is Reason.BREAKPOINT and stops():
                return True
            if reason not in (Reason.BREAKPOINT, Reason.LIMIT):
                return False
    return False
