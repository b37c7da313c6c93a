"""What is done to the Teletype and to the modules, by chance, most of it near the instants that matter.

A mood lasts some acts:

    wild      any IOT at any time, singly and in bursts
    reading   the keyboard's alone
    writing   the printer's alone
    polite    an IOT when a flag rises, as programs do
    silent    some characters' time without one
"""

import random
from collections.abc import Callable
from functools import partial

from tests.pdp8.computer.hardware.gates.beside import CYCLE, PULSES, Beside
from tests.reference.gates import PARTS, UNIT, Gates

FRAME = 2_000_000
KEYBOARD, PRINTER = range(0o6030, 0o6040), range(0o6040, 0o6050)


class Scenes:
    """Acts on both sides; the same seed does the same."""

    def __init__(self, beside: Beside, seed: int) -> None:
        self.beside = beside
        self.draw = random.Random(seed)
        self.acts: list[str] = []
        """What was done last, for the report."""

    def play(self, characters: int) -> None:
        """Act until so many characters were received and printed. Raises Difference."""
        moods: tuple[Callable[[], None], ...] = (
            partial(self._burst, (KEYBOARD, PRINTER)),
            partial(self._burst, (KEYBOARD,)),
            partial(self._burst, (PRINTER,)),
            self._polite,
            self._polite,
            self._silent,
        )
        while self.beside.characters < characters:
            mood = self.draw.choice(moods)
            for _ in range(self.draw.randrange(1, 30)):
                mood()
                self._hands()
        self.beside.end()

    def _burst(self, words: tuple[range, ...]) -> None:
        self._wait(self._moment())
        for _ in range(self.draw.choice((1, 1, 1, 2, 5))):
            self._iot(self.draw.choice(self.draw.choice(words)))
            if self.draw.random() < 0.5:
                self._wait(self.beside.now + CYCLE * self.draw.randrange(4))

    def _polite(self) -> None:
        """Wait for a flag, then answer as a program does."""
        beside = self.beside
        ahead = Gates.from_buffer_copy(beside.gates)
        at = ahead.run(beside.now + FRAME)
        self._wait(at + self.draw.choice((0, 2, 30, 1000, 40_000, 400_000)))
        if beside.gates.receiver.flag:
            self._iot(self.draw.choice((0o6036, 0o6036, 0o6037, 0o6034, 0o6032)))
        if beside.gates.transmitter.flag or self.draw.random() < 0.1:
            self._iot(self.draw.choice((0o6046, 0o6046, 0o6044, 0o6047)))

    def _silent(self) -> None:
        self._wait(self.beside.now + self.draw.randrange(2 * FRAME))

    def _moment(self) -> int:
        """Return a tick from now on: near an edge of a clock or of a unit, or any."""
        beside, draw = self.beside, self.draw
        aside = draw.choice((-2, -1, 1, 2, 10, -10, 1000, -1000)) - draw.choice((0, *PULSES.values()))
        kind = draw.random()
        if kind < 0.4 and beside.gates.sender.units:
            at = int(beside.gates.sender.at) + draw.randrange(-8, 60) * UNIT // 8
        elif kind < 0.5 and beside.gates.receiver.in_last_unit:
            at = int(beside.gates.receiver.pulse_at) + draw.randrange(40) * UNIT // 8
        elif kind < 0.7 and beside.gates.transmitter.active:
            at = int(beside.gates.transmitter.edge_at) + draw.randrange(20) * UNIT // 2
        else:
            return beside.now + draw.randrange(FRAME // draw.choice((1, 4, 20)))
        return max(beside.now, at // PARTS + aside)

    def _wait(self, until: int) -> None:
        if until > self.beside.now:
            self.beside.run(until)

    def _iot(self, word: int) -> None:
        ac = self.draw.randrange(0o10000)
        self._note(f"{word:o} with AC {ac:04o}")
        self.beside.iot(word, ac)

    def _hands(self) -> None:
        """Now and then press keys, change the tape, throw the lever, press START."""
        beside, draw = self.beside, self.draw
        kind = draw.random()
        if kind > 0.15:
            return
        if draw.random() < 0.5:
            self._wait(self._moment())
        if kind < 0.07:
            frames = draw.randbytes(draw.choice((1, 1, 2, 5)))
            self._note(f"type {frames.hex(' ')}")
            beside.type(frames)
        elif kind < 0.1:
            frames = draw.randbytes(draw.choice((1, 5, 30)))
            self._note(f"tape {frames.hex(' ')}")
            beside.load_tape(frames)
        elif kind < 0.12:
            on = draw.random() < 0.8
            self._note(f"lever {'START' if on else 'STOP'}")
            beside.lever(on)
        else:
            self._note("INITIALIZE")
            beside.initialize()

    def _note(self, act: str) -> None:
        self.acts.append(f"tick {self.beside.now}: {act}")
        del self.acts[:-40]
