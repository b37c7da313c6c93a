"""The Teletype and the model of DEC's modules, driven together.

Every change of a flag and of READER RUN is timed on both sides; every IOT must give the same AC and the same
skip; the printed frames must be the same. At the package's conventions nothing may differ by a tick. With
free clocks both sides time some changes differently, and an IOT stands clear of these.
"""

from collections import deque
from collections.abc import Callable
from functools import partial
from typing import Any

from pdp8.computer.hardware.bus import Bus
from pdp8.computer.hardware.teletype import Teletype
from tests.reference.gates import PARTS, UNIT, Gates

CYCLE, IOT = 32, 85
SKIPS = 0o10000
PULSES = {1: 29, 2: 47, 4: 65}
KEYBOARD_FLAG, PRINTER_FLAG, READER_RUN = SIGNALS = ("keyboard flag", "printer flag", "READER RUN")


EIGHTH, HALF = UNIT // 8 // PARTS + 1, UNIT // 2 // PARTS + 1
FREE = {KEYBOARD_FLAG: (EIGHTH, 0), PRINTER_FLAG: (0, HALF), READER_RUN: (EIGHTH, 0)}
"""With free clocks, how many ticks the Teletype may be later than the modules, and how many earlier."""
STEP, LONGEST_STEP = 5, 10_000
"""Ticks by which an act that stands too near a change is put off: more each time."""


class Difference(AssertionError):
    """The first difference."""


class _Edges:
    """The changes of one signal that only one side has shown so far: ours, the modules'."""

    def __init__(self, name: str, later: int, earlier: int) -> None:
        self.name = name
        self.later, self.earlier = later, earlier
        self.shown = deque[tuple[int, int]](), deque[tuple[int, int]]()

    def match(self, now: int) -> None:
        """Match the changes one by one. Raises Difference."""
        ours, gates = self.shown
        while ours and gates:
            (tick, level), (expected_tick, expected) = one, other = ours.popleft(), gates.popleft()
            if level != expected or not -self.earlier <= tick - expected_tick <= self.later:
                raise Difference(f"{self.name}: {_told(one)}, in the modules {_told(other)}")
        if ours and now - ours[0][0] > self.earlier:
            raise Difference(f"{self.name}: {_told(ours[0])}, in the modules no change")
        if gates and now - gates[0][0] > self.later:
            raise Difference(f"{self.name}: no change, in the modules {_told(gates[0])}")


def _told(edge: tuple[int, int]) -> str:
    return f"to {edge[1]} at tick {edge[0]}"


class Beside:
    """Both sides at tick `now`; with `phase` the modules' clocks run free."""

    def __init__(self, phase: int | None = None) -> None:
        self.free = phase is not None
        self.gates = Gates(phase)
        self.gates.sender.lever = 1
        self.teletype = Teletype()
        self.bus = Bus()
        self.teletype.connect(self.bus)
        self.bus.initialize(0)
        self.now = 0
        self.characters = 0
        self.edges = [_Edges(name, *(FREE[name] if self.free else (0, 0))) for name in SIGNALS]
        self._seen = [self._levels(0), self._levels(1)]
        self._printed = 0

    def _levels(self, side: int) -> tuple[int, ...]:
        receiver, transmitter = (
            (self.gates.receiver, self.gates.transmitter)
            if side
            else (self.teletype.receiver, self.teletype.transmitter)
        )
        return receiver.flag, transmitter.flag, receiver.reader_run

    def _note(self, side: int, now: int) -> None:
        """Note what has changed on one side."""
        before, self._seen[side] = self._seen[side], self._levels(side)
        for edges, old, level in zip(self.edges, before, self._seen[side], strict=True):
            if level != old:
                edges.shown[side].append((now, level))
        self.characters += side and self._seen[side][0] > before[0]

    def run(self, until: int) -> None:
        """Let time go on to tick `until`. Raises Difference."""
        now = self.now
        self.bus.advance(now)
        self._note(0, now)
        while now < until:
            now = max(now + 1, min(self.bus.next_event(now), self.teletype.receiver.step, until))
            self.bus.advance(now)
            self._note(0, now)
        while self.now < until:
            self.now = self.gates.run(until)
            self._note(1, self.now)
        for edges in self.edges:
            edges.match(until)
        self._compare_pages()

    def _compare_pages(self) -> None:
        page, since = self.teletype.printer.frames, self._printed
        self._printed = max(since, min(len(page), self.gates.selector.printed))
        self.characters += self._printed - since
        ours, expected = bytes(page[since : self._printed]), self.gates.printed(since)
        if ours != expected[: len(ours)]:
            raise Difference(f"tick {self.now}: printed {ours.hex(' ')}, by the modules {expected.hex(' ')}")

    def stand_clear(self, device: int, *pulses: int) -> None:
        """With free clocks let time go on until both sides have done all that an IOT of `device` could meet,
        and neither does more while its pulses last; device 0 for INITIALIZE and the hands. Raises Difference.
        """
        if not self.free:
            return
        late, early = (EIGHTH, 0) if device == 3 else (0, HALF)
        step = STEP
        while not self._still(device, late, late + max(pulses, default=0) + early):
            self.run(self.now + step)
            step = min(2 * step, LONGEST_STEP)
        self.run(self.now + late)

    def _still(self, device: int, late: int, ticks: int) -> bool:
        """Tell whether nothing changes for so many ticks from now; nor could the reader begin a character, or
        the selector, still turning, take one from rest at another time of its turn.
        """
        now, gates = self.now, self.gates
        if device == 3:
            pulse = (gates.receiver.pulse_at // PARTS - now - late) % EIGHTH
            return pulse > IOT and gates.quiet(3, now, now + ticks)
        turning = gates.selector.unit and not gates.transmitter.active
        return not (device == 4 and turning) and gates.quiet(device, now, now + ticks)

    def iot(self, word: int, ac: int) -> None:
        """Do an IOT that begins now, pulse after pulse, on both. Raises Difference."""
        began = self.now
        for pulse, after in PULSES.items():
            if not word & pulse:
                continue
            self.run(began + after)
            ours = self.bus.transfer(word & ~7 | pulse, ac, began + CYCLE)
            answer = self.gates.iot(word & ~7 | pulse, ac, began)
            ours = ours & 0o7777 | (SKIPS if ours & 0o20000 else 0)
            if ours != answer:
                raise Difference(
                    f"tick {self.now}: IOP{pulse} of {word:o} with AC {ac:04o} gives {_answer(ours)}, "
                    f"in the modules {_answer(answer)}"
                )
            ac = answer & 0o7777
            self._note(0, self.now)
            self._note(1, self.now)
        self.run(began + IOT)

    def initialize(self) -> None:
        """INITIALIZE on both."""
        self.bus.initialize(self.now)
        self.gates.initialize(self.now)
        self._note(0, self.now)
        self._note(1, self.now)
        self.run(self.now + 1)

    def type(self, frames: bytes) -> None:
        """Press the keys that send `frames`."""
        self._hands(self.teletype.keyboard.press, self.gates.type, frames)

    def load_tape(self, frames: bytes) -> None:
        """Put a tape in."""
        self._hands(self.teletype.reader.load, self.gates.load_tape, frames)

    def lever(self, on: bool) -> None:
        """Put the reader's lever to START or STOP."""
        self._hands(self.teletype.reader.lever, partial(setattr, self.gates.sender, "lever"), on)

    def _hands(self, ours: Callable[[Any], object], gates: Callable[[Any], object], value: object) -> None:
        self.bus.advance(self.now)
        ours(value)
        gates(value)
        self.run(self.now + 1)

    def end(self) -> None:
        """Let everything come to its end; then compare all that was printed and read. Raises Difference."""
        self.lever(False)
        while (waiting := self.gates.sender.keys - self.gates.sender.keys_sent) or self.gates.sender.units:
            self.run(self.now + (waiting + 1) * 2_000_000)
        self.run(self.now + 6_000_000)
        printed, expected = len(self.teletype.printer.frames), self.gates.selector.printed
        if printed != expected or self._seen[0] != self._seen[1]:
            raise Difference(
                f"at the end {printed} frames and {self._seen[0]}, "
                f"in the modules {expected} and {self._seen[1]} of {SIGNALS}"
            )


def _answer(answer: int) -> str:
    return f"{answer & 0o7777:04o}{' and skips' if answer & SKIPS else ''}"
