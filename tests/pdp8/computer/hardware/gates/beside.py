"""The Teletype and the model of DEC's modules, driven together.

Every flag and READER RUN must change in the same tick on both sides; every IOT must give the same AC and the
same skip; the printed frames must be the same.
"""

from collections.abc import Callable
from functools import partial
from typing import Any

from pdp8.computer.hardware.bus import Bus
from pdp8.computer.hardware.teletype import Teletype
from tests.reference.gates import Gates

CYCLE, IOT = 32, 85
SKIPS = 0o10000
PULSES = {1: 29, 2: 47, 4: 65}
SIGNALS = ("keyboard flag", "printer flag", "READER RUN")


class Difference(AssertionError):
    """The first difference."""


class Beside:
    """Both sides at tick `now`."""

    def __init__(self) -> None:
        self.gates = Gates()
        self.gates.sender.lever = 1
        self.teletype = Teletype()
        self.bus = Bus()
        self.teletype.connect(self.bus)
        self.bus.initialize(0)
        self.now = 0
        self.characters = 0
        self._changes: tuple[dict[int, tuple[int, ...]], ...] = ({}, {})
        """The levels of the signals after each tick at which one changed: ours, the modules'."""
        self._seen = [self._levels(0), self._levels(1)]
        self._printed = 0

    def _levels(self, side: int) -> tuple[int, ...]:
        one = (self.teletype, self.gates)[side]
        return one.receiver.flag, one.transmitter.flag, one.receiver.reader_run

    def _note(self, side: int, now: int) -> None:
        """Note what has changed on one side."""
        before, levels = self._seen[side], self._levels(side)
        if levels != before:
            self._seen[side] = self._changes[side][now] = levels
        self.characters += side and levels[0] > before[0]

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
        self._compare_changes()
        self._compare_pages()

    def _compare_changes(self) -> None:
        ours, gates = self._changes
        if ours != gates:
            tick, _ = min(ours.items() ^ gates.items())
            levels, expected = (side.get(tick, "no change") for side in (ours, gates))
            raise Difference(f"tick {tick}: {levels}, in the modules {expected} of {SIGNALS}")
        ours.clear()
        gates.clear()

    def _compare_pages(self) -> None:
        page, since = self.teletype.printer.frames, self._printed
        self._printed = max(since, min(len(page), self.gates.selector.printed))
        self.characters += self._printed - since
        ours, expected = bytes(page[since : self._printed]), self.gates.printed(since)
        if ours != expected[: len(ours)]:
            raise Difference(f"tick {self.now}: printed {ours.hex(' ')}, by the modules {expected.hex(' ')}")

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
