"""The Teletype and the model of DEC's modules, driven together.

Every change of a flag and of READER RUN is timed on both sides; every IOT must give the same AC and the same
skip; the printed frames must be the same. At the package's conventions nothing may differ by a tick. With
free clocks both sides time some changes differently, and an IOT stands clear of these.
"""

from collections import deque
from typing import NamedTuple

from pdp8.computer.hardware.bus import Bus
from pdp8.computer.hardware.teletype import Teletype
from tests.reference.gates import PARTS, UNIT, Gates

CYCLE, IOT = 32, 85
SKIPS = 0o10000
PULSES = {1: 29, 2: 47, 4: 65}
KEYBOARD_FLAG, PRINTER_FLAG, READER_RUN = SIGNALS = ("keyboard flag", "printer flag", "READER RUN")


class Window(NamedTuple):
    """How many ticks the Teletype may be later than the modules, and how many earlier."""

    later: int
    earlier: int


SAME = dict.fromkeys(SIGNALS, Window(0, 0))
EIGHTH, HALF = UNIT // 8 // PARTS + 1, UNIT // 2 // PARTS + 1
FREE = {
    KEYBOARD_FLAG: Window(EIGHTH, 0),
    PRINTER_FLAG: Window(0, HALF),
    READER_RUN: Window(EIGHTH, 0),
}
STEP, LONGEST_STEP = 5, 10_000
"""Ticks by which an act that stands too near a change is put off: more each time."""


class Difference(AssertionError):
    """The first difference."""


class _Edges:
    """The changes of one signal that only one side has shown so far."""

    def __init__(self, name: str, window: Window) -> None:
        self.name = name
        self.window = window
        self.ours = deque[tuple[int, int]]()
        self.gates = deque[tuple[int, int]]()

    def match(self, now: int) -> None:
        """Match the changes one by one. Raises Difference."""
        while self.ours and self.gates:
            (ours, our_level), (gates, level) = self.ours.popleft(), self.gates.popleft()
            if our_level != level or not -self.window.earlier <= ours - gates <= self.window.later:
                self._differ((ours, our_level), (gates, level))
        if self.ours and now - self.ours[0][0] > self.window.earlier:
            self._differ(self.ours[0], None)
        if self.gates and now - self.gates[0][0] > self.window.later:
            self._differ(None, self.gates[0])

    def _differ(self, ours: tuple[int, int] | None, gates: tuple[int, int] | None) -> None:
        raise Difference(f"{self.name}: {_told(ours)}, in the modules {_told(gates)}")


def _told(edge: tuple[int, int] | None) -> str:
    return f"to {edge[1]} at tick {edge[0]}" if edge else "no change"


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
        self.edges = [_Edges(name, window) for name, window in (FREE if self.free else SAME).items()]
        self._seen_ours, self._seen_gates = self._ours(), self._gates()
        self._printed = 0

    def _ours(self) -> tuple[int, int, int]:
        receiver = self.teletype.receiver
        return receiver.flag, self.teletype.transmitter.flag, receiver.reader_run

    def _gates(self) -> tuple[int, int, int]:
        receiver = self.gates.receiver
        return receiver.flag, self.gates.transmitter.flag, receiver.reader_run

    def _note_ours(self, now: int) -> None:
        if (seen := self._ours()) == self._seen_ours:
            return
        for edges, before, level in zip(self.edges, self._seen_ours, seen, strict=True):
            if level != before:
                edges.ours.append((now, level))
        self._seen_ours = seen

    def _note_gates(self, now: int) -> None:
        if (seen := self._gates()) == self._seen_gates:
            return
        for edges, before, level in zip(self.edges, self._seen_gates, seen, strict=True):
            if level != before:
                edges.gates.append((now, level))
        self.characters += seen[0] > self._seen_gates[0]
        self._seen_gates = seen

    def _note(self) -> None:
        self._note_ours(self.now)
        self._note_gates(self.now)

    def _run_ours(self, until: int) -> None:
        now = self.now
        self.bus.advance(now)
        self._note_ours(now)
        while now < until:
            now = max(now + 1, min(self.bus.next_event(now), self.teletype.receiver.step, until))
            self.bus.advance(now)
            self._note_ours(now)

    def run(self, until: int) -> None:
        """Let time go on to tick `until`. Raises Difference."""
        self._run_ours(until)
        now = self.now
        while now < until:
            now = self.gates.run(until)
            self._note_gates(now)
        self.now = until
        for edges in self.edges:
            edges.match(until)
        self._compare_pages()

    def _compare_pages(self) -> None:
        page = self.teletype.printer.frames
        until = min(len(page), self.gates.selector.printed)
        if until > self._printed:
            expected = self.gates.printed(self._printed)[: until - self._printed]
            ours = bytes(page[self._printed : until])
            if ours != expected:
                raise Difference(
                    f"tick {self.now}: printed {_octal(ours)}, by the modules {_octal(expected)}"
                )
            self.characters += until - self._printed
            self._printed = until

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
            self._note()
        self.run(began + IOT)

    def initialize(self) -> None:
        """INITIALIZE on both."""
        self.bus.initialize(self.now)
        self.gates.initialize(self.now)
        self._note()
        self.run(self.now + 1)

    def type(self, frames: bytes) -> None:
        """Press the keys that send `frames`."""
        self.bus.advance(self.now)
        self.teletype.keyboard.press(frames)
        self.gates.type(frames)
        self.run(self.now + 1)

    def load_tape(self, frames: bytes) -> None:
        """Put a tape in."""
        self.bus.advance(self.now)
        self.teletype.reader.load(frames)
        self.gates.load_tape(frames)
        self.run(self.now + 1)

    def lever(self, on: bool) -> None:
        """Put the reader's lever to START or STOP."""
        self.bus.advance(self.now)
        self.teletype.reader.lever(on)
        self.gates.sender.lever = on
        self.run(self.now + 1)

    def end(self) -> None:
        """Let everything come to its end; then compare all that was printed and read. Raises Difference."""
        self.lever(False)
        while (waiting := self.gates.sender.keys - self.gates.sender.keys_sent) or self.gates.sender.units:
            self.run(self.now + (waiting + 1) * 2_000_000)
        self.run(self.now + 6_000_000)
        ours, gates = self.teletype, self.gates
        if len(ours.printer.frames) != gates.selector.printed:
            raise Difference(
                f"printed {len(ours.printer.frames)} frames, the modules {gates.selector.printed}"
            )
        if self._seen_ours != self._seen_gates:
            raise Difference(f"{SIGNALS} {self._seen_ours}, in the modules {self._seen_gates}")


def _octal(frames: bytes) -> str:
    return " ".join(f"{frame:03o}" for frame in frames)


def _answer(answer: int) -> str:
    return f"{answer & 0o7777:04o}{' and skips' if answer & SKIPS else ''}"
