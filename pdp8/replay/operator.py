"""The operator at the PDP-8/L: what he does and when, and the machine he does it to.

His clock is the machine's, which was switched on as the afternoon began. Every deed is written down with its
tick, so that whoever repeats the deeds at those ticks has the same machine at every instant.

His pace is ours, not the thesis's: five seconds to set the twelve switches and press a key, and one hand on
the reader's lever while the other presses START.
"""

from collections.abc import Mapping
from typing import NamedTuple

from pdp8.computer.machine import TICKS_PER_SECOND, Machine
from pdp8.computer.stop import Stop

SETTING_SECONDS = 4
PRESSING_SECONDS = 1
LEVER_SECONDS = 0.25


class Deed(NamedTuple):
    """One thing done: when, in ticks; to what; the word set or the tape's name; and how it is told."""

    at: int
    key: str
    value: int | str | None = None
    say: str = ""


class Operator:
    """A machine that has been switched on, and what was done to it."""

    def __init__(self) -> None:
        self.machine = Machine()
        self.panel = self.machine.panel
        self.deeds: list[Deed] = []

    @property
    def now(self) -> int:
        """Ticks of 0.05 µs since the machine was switched on."""
        return self.machine.processor.clock

    def wait(self, seconds: float) -> None:
        """Let time pass while the machine stands still."""
        self.machine.wait(seconds)

    def set_switches(self, word: int) -> None:
        """Set the switch register."""
        self.wait(SETTING_SECONDS)
        self.panel.sr = word
        self._note("sr", word, f"{word:04o} into the switches.")

    def load_address(self, address: int) -> None:
        """Set the switches to `address` and press LOAD ADD."""
        self.set_switches(address)
        self.wait(PRESSING_SECONDS)
        self.panel.load_add()
        self._note("load add", None, f"{address:04o}, LOAD ADD.")

    def deposit(self, word: int) -> None:
        """Set the switches to `word` and press DEP."""
        self.set_switches(word)
        self.wait(PRESSING_SECONDS)
        self.panel.dep()
        self._note("dep", None, f"{word:04o} into {self.machine.ma:04o}, DEP.")

    def toggle(self, words: Mapping[int, int]) -> None:
        """Toggle in consecutive words: LOAD ADD of the first address, then DEP of each."""
        self.load_address(min(words))
        for address in sorted(words):
            self.deposit(words[address])

    def mount(self, name: str, tape: bytes) -> None:
        """Put a tape into the Teletype's reader, its lever at STOP."""
        self.machine.teletype.reader.lever(False)
        self.machine.teletype.reader.load(tape)
        self._note("mount", name, f"{name} goes into the reader.")

    def start(self, address: int) -> Stop:
        """Start at `address`, put the reader's lever to START as the program waits; run until it ends.

        It ends where it halts, or waits for a reader that has no more tape.
        """
        self.load_address(address)
        self.wait(PRESSING_SECONDS)
        self._note("start", None, f"START at {address:04o}.")
        self.panel.start()
        self._run_on(LEVER_SECONDS)
        self.machine.teletype.reader.lever(True)
        self._note("lever", None, "The reader's lever to START.")
        return self.machine.run()

    def _run_on(self, seconds: float) -> None:
        """Let the machine run for a while, though it waits for what only the operator will do."""
        processor = self.machine.processor
        until = processor.clock + round(seconds * TICKS_PER_SECOND)
        while processor.clock < until:
            processor.instruction()

    def stop(self) -> None:
        """Press STOP."""
        self.panel.stop()
        self._note("stop", None, "The reader is empty: STOP.")

    def elapsed(self, key: str) -> float:
        """Return the seconds since the last deed with `key`."""
        at = next(deed.at for deed in reversed(self.deeds) if deed.key == key)
        return (self.now - at) / TICKS_PER_SECOND

    def _note(self, key: str, value: int | str | None, say: str) -> None:
        self.deeds.append(Deed(self.now, key, value, say))
