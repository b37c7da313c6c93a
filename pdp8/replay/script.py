"""Any instant of a day: the operator's actions done again on a machine, on from a snapshot.

    Course ──► actions ──► Script ──► its machine, as it was at `now`
                             ▲
            to(tick), next(unit), previous(unit)

A day leaves what the operator did and when. An instant is the last snapshot of the machine before it, the
actions since done again, and the machine run on, as far as the last cycle that ended. The first snapshot is
the machine as it is switched on; others may be given by `keep`; the script keeps one for each ten seconds
that it passes. To work at the machine, take a copy of it.
"""

from bisect import bisect_left
from collections.abc import Iterator
from enum import StrEnum
from functools import cached_property
from typing import Final

from pal.isa import FETCH, IOT
from pdp8.computer.hardware.fields import Values
from pdp8.computer.hardware.signals import CYCLE, FRAME, IO_TICKS, TICKS_PER_SECOND
from pdp8.computer.machine import Machine
from pdp8.computer.use.operator import Action, Operator
from pdp8.replay.day import Act, Course, Kind
from tapes.ascii import CR
from tapes.hydrapoint import ROWS

_LONGEST: Final = 3 * CYCLE + IO_TICKS
"""Ticks: no instruction takes more."""

_APART: Final = 10 * TICKS_PER_SECOND
"""Ticks from a snapshot to the next."""


class Unit(StrEnum):
    """The size of a step."""

    BLOCK = "block"
    CHARACTER = "character"
    INSTRUCTION = "instruction"
    CYCLE = "cycle"


class Script:
    """A day at any instant: `now` is in ticks of 0.05 µs since it began."""

    def __init__(self, day: Course) -> None:
        self.day = day
        self.machine = Machine()
        self.now = 0
        self.done = 0
        """Actions done."""
        self._ticks: list[int] = []
        self._snapshots: list[Values] = []
        self.keep(0, self.machine.values())

    def keep(self, tick: int, values: Values) -> None:
        """Keep the machine's values at a tick, after all that happens at it."""
        at = bisect_left(self._ticks, tick)
        self._ticks.insert(at, tick)
        self._snapshots.insert(at, values)

    @cached_property
    def _rows(self) -> list[int]:
        """The ticks at which the terminal punches a frame or the Hydra-Point reads a row."""
        path = self.day.path
        reading = path.read_seconds * TICKS_PER_SECOND
        punched = [number * FRAME for number in range(1, len(self._printout) + 1)]
        return punched + [
            round(begins + reading * row / ROWS) for begins in self._begins for row in range(ROWS)
        ]

    @cached_property
    def _blocks(self) -> list[int]:
        """The ticks at which a line ends at the terminal or a block begins at the Hydra-Point."""
        ends = [number * FRAME for number, frame in enumerate(self._printout, 1) if frame & 0o177 == CR]
        return ends + [round(begins) for begins in self._begins]

    @property
    def _printout(self) -> bytes:
        return self.day.tapes[f"{self.day.part}.asc"]

    @property
    def _begins(self) -> list[float]:
        """When the Hydra-Point begins each block, in ticks."""
        return [self.day.mill_starts + start * TICKS_PER_SECOND for start in self.day.path.starts]

    @property
    def end(self) -> int:
        """The tick at which the day ends."""
        return self.day.acts[-1].ends

    @property
    def act(self) -> Act:
        """The act that is under way."""
        return next(act for act in reversed(self.day.acts) if act.starts <= self.now)

    @property
    def action(self) -> Action | None:
        """The last action that was done."""
        return self.day.actions[self.done - 1] if self.done else None

    @property
    def mounted(self) -> str:
        """The name of the tape that is in the reader, or ""."""
        mounts = (action for action in reversed(self.day.actions[: self.done]) if action.key == "mount")
        action = next(mounts, None)
        return str(action.value) if action else ""

    def to(self, tick: int) -> None:
        """Go to an instant."""
        tick = min(max(0, tick), self.end)
        nearest = bisect_left(self._ticks, tick + 1) - 1
        if tick < self.now or self._ticks[nearest] > self.now:
            self._restore(nearest)
        self._advance(tick)

    def next(self, unit: Unit) -> None:
        """Go to the next instant, a `unit` later."""
        in_machine = unit in (Unit.INSTRUCTION, Unit.CYCLE) and self.machine.processor.run
        if in_machine:
            self._next_cycle(unit == Unit.INSTRUCTION)
            return
        for _ in self._instants(unit, self.end):
            return

    def previous(self, unit: Unit) -> None:
        """Go to the previous instant, a `unit` earlier."""
        processor = self.machine.processor
        until, cycles = self.now - 1, unit in (Unit.INSTRUCTION, Unit.CYCLE)
        if cycles and processor.run and processor.clock > self._acted:  # a cycle since the last action
            until = processor.clock - 1
        self.to(until)  # so that a snapshot is near
        if cycles and processor.run:
            self._begin_cycle(unit == Unit.INSTRUCTION)
            return
        for at in range(bisect_left(self._ticks, self.now) - 1, -1, -1):
            self._restore(at)
            found = list(self._instants(unit, until))
            if found:
                self.to(found[-1])
                return
            until = self._ticks[at]
        self.to(0)

    @property
    def _acted(self) -> int:
        """The tick of the last action of a machine that runs."""
        return self.day.actions[self.done - 1].at

    def _next_cycle(self, whole: bool) -> None:
        """Run one cycle, or to the end of the instruction, or until the next action."""
        processor, done = self.machine.processor, self.done
        while True:
            self.to(min(processor.clock + _cycle(self.machine), self._next_action))
            if not (whole and processor.run and processor.next != FETCH and self.done == done):
                return

    def _begin_cycle(self, whole: bool) -> None:
        """Go to the begin of this cycle, or of the `whole` instruction."""
        processor = self.machine.processor
        while whole and processor.next != FETCH:
            self.to(processor.clock - 1)
        self.now = max(processor.clock, self._acted)

    @property
    def _next_action(self) -> int:
        """The tick of the next action or of the day's end."""
        return self.day.actions[self.done].at if self.done < len(self.day.actions) else self.end

    def _instants(self, unit: Unit, until: int) -> Iterator[int]:
        """Run from event to event until tick `until`; yield the ticks that are instants of `unit`."""
        receiver = self.machine.teletype.receiver
        blocks = unit == Unit.BLOCK
        while self.now < until:
            act, done, flag = self.act, self.done, receiver.flag
            self._advance(min(until, self._event(act)))
            received = bool(receiver.flag) and not flag
            if self.act.starts != act.starts or self.now == self.end:
                yield self.now
            elif act.kind in (Kind.TERMINAL, Kind.MILL):
                ticks = self._blocks if blocks else self._rows
                if self.now == _first_from(ticks, self.now):
                    yield self.now
            elif blocks:
                if received and act.kind == Kind.TRANSLATE and receiver.buffer & 0o177 == CR:
                    yield self.now
            elif received or self.done != done:
                yield self.now

    def _event(self, act: Act) -> int:
        """Return the tick of the next possible event."""
        soon = min(self._next_action, act.ends)
        if act.kind in (Kind.TERMINAL, Kind.MILL):
            return min(soon, _first_from(self._rows, self.now + 1))
        processor = self.machine.processor
        event = self.machine.bus.next_event(processor.clock)
        if processor.run:
            event = min(event, self.now + FRAME // 4)
        return max(self.now + 1, min(soon, event))

    def _restore(self, at: int) -> None:
        self.machine.put(self._snapshots[at])
        self.now = self._ticks[at]
        self.done = sum(action.at <= self.now for action in self.day.actions)

    def _advance(self, tick: int) -> None:
        """Run until a tick, and keep a snapshot at intervals."""
        while self.machine.processor.run and tick - self.now > _APART:
            self._go_on(self.now + _APART)
            self._keep_now()
        self._go_on(tick)
        self._keep_now()

    def _keep_now(self) -> None:
        nearest = self._ticks[bisect_left(self._ticks, self.now + 1) - 1]
        if self.machine.processor.run and self.now - nearest >= _APART:
            self.keep(self.now, self.machine.values())

    def _go_on(self, tick: int) -> None:
        while self.done < len(self.day.actions) and self.day.actions[self.done].at <= tick:
            action = self.day.actions[self.done]
            go_on(self.machine, action.at)
            self._do(action)
            self.now = action.at
            self.done += 1
        go_on(self.machine, tick)
        self.now = tick

    def _do(self, action: Action) -> None:
        """Carry out the operator's action."""
        operator = Operator(self.machine)
        if action.key == "sr":
            operator.set_switches(int(action.value or 0))
        elif action.key == "lever":
            operator.throw_lever()
        elif action.key == "mount":
            operator.mount(str(action.value), self.day.tapes[str(action.value)])
        else:
            getattr(operator.panel, action.key.replace(" ", "_"))()


def go_on(machine: Machine, until: int) -> None:
    """Run the last cycle that ends by tick `until`; let time pass if the machine is stopped."""
    p = machine.processor
    while p.run and p.next != FETCH and p.clock + CYCLE <= until:
        p.cycle()
    room = until - p.clock - _LONGEST
    if p.run and room > 0:
        machine.run(room / TICKS_PER_SECOND)
    while p.run and p.clock + _cycle(machine) <= until:
        p.cycle()
    if not p.run and p.clock < until:
        p.clock = until
    machine.bus.advance(p.clock)


def _cycle(machine: Machine) -> int:
    """Return the ticks of the next cycle."""
    p = machine.processor
    return CYCLE + IO_TICKS if p.next == FETCH and p.core[p.pc] >> 9 == IOT else CYCLE


def _first_from(ticks: list[int], tick: int) -> int:
    """Return the first of `ticks` from `tick` on, or one later than all."""
    at = bisect_left(ticks, tick)
    return ticks[at] if at < len(ticks) else 1 << 52
