"""What a machine has done, kept so that it can be undone.

        ●────────────○───────────●──────────○──────x────── now
     snapshot     SR set     snapshot   key pressed │
                                 └── run again ─────┘ as far as the moment wanted

A run depends on nothing but the machine's state as it begins: so a moment is had again, exactly, by running
again from a snapshot. What is set between two runs (a word deposited, a switch, a key, a tape) is kept as a
change at its tick, and made again there. Snapshots are some seconds apart, farther when there are many; when
the memory allowed is full, the oldest past is forgotten.

Not undone: what has left the machine, such as a frame that an `on_frame` passed on. Not recorded: what an
`on_frame` changes while a run goes on.
"""

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any, NamedTuple

from pal.isa import BREAK
from pdp8.computer.hardware.fields import Values, changed, size, walk
from pdp8.computer.hardware.signals import TICKS_PER_SECOND
from pdp8.computer.hardware.teletype import Printer, Punch
from pdp8.computer.machine import Machine
from pdp8.computer.stop import Reason
from pdp8.computer.watch import Watch
from tapes.errors import WorkError

MEMORY = 64 << 20
"""Bytes that a history may take, about, if nothing else is said."""
_APART = 5 * TICKS_PER_SECOND
"""Machine time between two snapshots at least, while they are few."""
_MOST = 128
"""Snapshots."""
_SHARE = 4
"""The largest share of the memory for the marks between two snapshots, so that old ones can be dropped."""
_MARK = 200
"""About what a mark takes, in bytes."""


class HistoryError(WorkError):
    """A moment before the recorded history."""


class _Mark(NamedTuple):
    """Values set when a run began or ended, all or only the changed; a `jump` follows single cycles."""

    clock: int
    instructions: int
    values: Values
    whole: bool
    jump: bool


class History:
    """The past of a machine, from the moment this is made until `close`."""

    def __init__(self, machine: Machine, memory: int = MEMORY) -> None:
        self.machine = machine
        self._fields = machine.fields()
        self._memory = memory
        self._apart = _APART
        self._marks: list[_Mark] = []
        self._size = self._since = 0
        self._ended = self._began = self._values()
        """The machine as the last run left it, and as that run began."""
        self._stands = self._moment()
        """When the last run ended."""
        self._add(self._ended, whole=True)
        machine.recorder = self

    def close(self) -> None:
        """Stop recording, and forget the past."""
        self.machine.recorder = None
        self._keep([])

    @property
    def size(self) -> int:
        """About how many bytes the history takes."""
        return self._size

    @property
    def instructions(self) -> int:
        """How many instructions can be undone."""
        return self.machine.instructions - self._marks[0].instructions

    @property
    def seconds(self) -> float:
        """How much machine time can be undone."""
        return (self.machine.processor.clock - self._marks[0].clock) / TICKS_PER_SECOND

    def begins(self) -> None:
        """Record what was changed since the last run."""
        now = self._values()
        self._note(now)
        apart = self.machine.processor.clock - self._newest
        if apart >= self._apart or self._since > self._memory // _SHARE:
            self._add(now, whole=True)
        self._began, self._stands = now, self._moment()

    def together(self, work: Callable[[], str]) -> str:
        """Keep the runs of `work` as one; return why the last ended."""
        self.begins()
        self.machine.recorder = None
        reason: str = Reason.LIMIT
        try:
            reason = work()
        finally:
            self.machine.recorder = self
            self.ended(reason, False)
        return reason

    def ended(self, reason: str, in_cycles: bool) -> None:
        """Record the moment at which a run ended, and values that running again does not give."""
        self._ended = self._values()
        others, moment = changed(self._began, self._ended), self._moment()
        if in_cycles or moment == self._stands:
            self._jump(others)
            return
        self._stands = moment
        if reason != Reason.LIMIT:
            left = self._ended.items()
            self._add({name: value for name, value in left if name in others or not isinstance(value, bytes)})
        elif self.machine.processor.state == BREAK:  # several moments have this number of instructions
            self._add({})

    def _note(self, now: Values) -> None:
        others = changed(self._ended, now)
        if self.machine.instructions != self._stands[1]:
            self._jump(others)
        elif others:
            self._add(others)

    def _jump(self, values: Values) -> None:
        """Record values that no run leads to."""
        if not values:
            return
        last = self._marks[-1]
        if (last.clock, last.instructions) != self._stands:
            self._add({})
        self._stands = self._moment()
        self._add(values, jump=True)

    def _values(self) -> Values:
        return self.machine.values(self._fields)

    def _moment(self) -> tuple[int, int]:
        return self.machine.processor.clock, self.machine.instructions

    def _add(self, values: Values, whole: bool = False, jump: bool = False) -> None:
        self._marks.append(_Mark(*self._stands, values, whole, jump))
        takes = _MARK + size(values)
        self._size += takes
        self._since = 0 if whole else self._since + takes
        if whole:
            self._newest = self._stands[0]
            """The tick of the newest snapshot."""
        if whole and sum(mark.whole for mark in self._marks) > _MOST:
            self._thin_out()
        while self._size > self._memory and self._forget_the_oldest():
            pass

    def _thin_out(self) -> None:
        """Drop snapshots until they are twice as far apart, as those to come will be."""
        self._apart *= 2
        kept: list[_Mark] = []
        newest = -self._apart
        for mark in self._marks:
            if not mark.whole or mark.clock >= newest + self._apart:
                kept.append(mark)
                newest = mark.clock if mark.whole else newest
        self._keep(kept)

    def _forget_the_oldest(self) -> bool:
        """Forget what comes before the second snapshot; return whether there is one."""
        second = next((at for at, mark in enumerate(self._marks) if at and mark.whole), None)
        if second is not None:
            self._keep(self._marks[second:])
        return second is not None

    def _keep(self, marks: list[_Mark]) -> None:
        self._marks = marks
        self._newest = next((mark.clock for mark in reversed(marks) if mark.whole), 0)
        self._size = self._since = 0
        for mark in marks:
            takes = _MARK + size(mark.values)
            self._size += takes
            self._since = 0 if mark.whole else self._since + takes

    @contextmanager
    def going_back(self) -> Iterator[None]:
        """Let the machine run unrecorded, then forget what comes later; an error changes nothing."""
        machine, watch = self.machine, self.machine.watch
        now = self._values()
        self._note(now)
        parts = [part for _, part in walk(machine.parts())]
        heard = [part for part in parts if isinstance(part, (Printer, Punch))]
        callbacks = [device.on_frame for device in heard]
        machine.recorder, machine.watch = None, Watch(again=True)
        for device in heard:
            device.on_frame = None
        try:
            yield
        except BaseException:
            machine.put(now)
            raise
        finally:
            machine.recorder, machine.watch = self, watch
            for device, callback in zip(heard, callbacks, strict=True):
                device.on_frame = callback
            self._ended, self._stands = self._values(), self._moment()
            clock, number = self._stands
            past = [mark for mark in self._marks if mark.clock <= clock and mark.instructions <= number]
            in_cycles = self._marks[len(past) :][:1]
            self._keep(past)
            if in_cycles and in_cycles[0].jump:
                self._add(self._ended, jump=True)

    def snapshots(self) -> list[_Mark]:
        """Return the snapshots, the newest first."""
        return [mark for mark in reversed(self._marks) if mark.whole]

    def kept(self, name: str) -> Iterator[tuple[int, Any]]:
        """Yield each value of `name` that is kept, after so many instructions, the newest first."""
        for mark in reversed(self._marks):
            if name in mark.values:
                yield mark.instructions, mark.values[name]

    def go_to_instruction(self, number: int) -> None:
        """Go to the last moment at which the machine had done this number of instructions."""
        self._go(sum(mark.instructions <= number for mark in self._marks))
        machine = self.machine
        in_cycles = self._next < len(self._marks) and self._marks[self._next].jump
        while in_cycles and machine.instructions < number:
            machine.processor.instruction()
        while machine.instructions < number:  # a run may end before, as idle
            machine.run(instructions=number - machine.instructions)

    def go_to_tick(self, clock: int) -> None:
        """Go to the first end of an instruction at tick `clock` or after it."""
        self._go(sum(mark.clock <= clock for mark in self._marks))
        self._run_to(clock)
        for _ in self.ahead(self.machine.processor.clock):
            pass

    def ahead(self, clock: int) -> Iterator[int]:
        """Yield the ticks at which recorded changes are made, up to `clock`."""
        while self._next < len(self._marks) and self._marks[self._next].clock <= clock:
            mark = self._marks[self._next]
            if not mark.jump:
                yield mark.clock
            self.machine.put({} if mark.whole else mark.values)
            self._next += 1
        yield clock

    def _go(self, count: int) -> None:
        """Go to the last of the first `count` marks."""
        start = max(at for at, mark in enumerate(self._marks[:count]) if mark.whole)
        self.machine.put(self._marks[start].values)
        for mark in self._marks[start + 1 : count]:
            if not mark.jump:
                self._run_to(mark.clock)
            self.machine.put(mark.values)
        self._next = count
        """The first mark that is not reached yet."""

    def _run_to(self, clock: int) -> None:
        while (ticks := clock - self.machine.processor.clock) > 0:
            self.machine.run(seconds=ticks / TICKS_PER_SECOND)


class PipedHistory(History):
    """The past of a machine whose Teletype may read a tape that is still being made: all of it is there."""

    def ended(self, reason: str, in_cycles: bool) -> None:
        """Record the end of a run, and what has come of the tape."""
        name, place = "devices 03 reader tape", "devices 03 reader position"
        tape = self.machine.teletype.reader.tape
        for mark in reversed(self._marks if tape != self._began[name] else ()):
            if not tape.startswith(mark.values.get(name, b"")):
                break
            if name in mark.values:
                mark.values[name] = tape
            if not mark.whole and mark.values.get(place) == 0:  # it was put in
                break
        super().ended(reason, in_cycles)

    @contextmanager
    def going_back(self) -> Iterator[None]:
        """Let the machine run unrecorded, as History does, and take no more of the tape."""
        reader = self.machine.teletype.reader
        more, reader.more = reader.more, None
        try:
            with super().going_back():
                yield
        finally:
            reader.more = more
