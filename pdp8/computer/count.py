"""How often each word was executed and written, each operation done, and how long the program waited.

A Count watches a machine (`with machine.count() as count`), which then runs instruction by instruction;
without one a run costs nothing more. Turns of a waiting loop that the machine passes over are counted as if
it had run them: the instructions before tell which loop it is.
"""

from collections import Counter, deque
from typing import NamedTuple

from pal.disassembler import microinstruction
from pal.isa import FETCH, INDIRECT, IOT, OPERATIONS
from pdp8.computer.hardware.processor import Processor
from pdp8.computer.hardware.signals import CYCLE, IO_TICKS
from pdp8.computer.watch import memory_address, wrote

_RING = 8192
"""Instructions that are remembered: more than the longest loop that is passed over."""


class _Executed(NamedTuple):
    """An instruction: its address and word, the tick at which it began, and the addresses it wrote."""

    address: int
    word: int
    began: int
    written: list[int]


class Count:
    """Counts by address (`executed`, `written`), of operations, interrupts and cycles; `ticks` in all and
    `waiting`.
    """

    def __init__(self) -> None:
        self.executed: Counter[int] = Counter()
        self.written: Counter[int] = Counter()
        self.operations: Counter[str] = Counter()
        self.interrupts = 0
        self.cycles = 0
        self.ticks = 0
        self.waiting = 0
        self.went_back = False
        """Whether some of what was counted was undone."""
        self._last: deque[_Executed] = deque(maxlen=_RING)
        """The last instructions, up to `_RING` of them."""

    def cycle(self, processor: Processor, interrupt: bool) -> None:
        """Count a memory cycle that has ended, an instruction's or an interrupt's."""
        p = processor
        if p.state == FETCH:
            self._execute(memory_address(p), p.mb, 1)
            self._last.append(_Executed(memory_address(p), p.mb, self.ticks, []))
            if p.ir == IOT:
                self.ticks += IO_TICKS
        self.interrupts += interrupt
        self.cycles += 1
        self.ticks += CYCLE
        if wrote(p):
            self.written[memory_address(p)] += 1
            if self._last:
                self._last[-1].written.append(memory_address(p))

    def waited(self, processor: Processor, instructions: int, ticks: int) -> None:
        """Count skipped turns of the loop that the processor is in."""
        ring = self._ring(processor, instructions, ticks)
        self.ticks += ticks
        self.waiting += ticks
        turns = instructions // len(ring)
        for executed in ring:
            self._execute(executed.address, executed.word, turns)
            for address in executed.written:
                self.written[address] += turns
        tests = sum(executed.word >> 9 == IOT for executed in ring)
        self.cycles += (ticks - IO_TICKS * turns * tests) // CYCLE

    def _execute(self, address: int, word: int, times: int) -> None:
        self.executed[address] += times
        self.operations[_operation(word)] += times

    def _ring(self, processor: Processor, instructions: int, ticks: int) -> list[_Executed]:
        """Return one turn of the loop up to now, if whole turns of it make `instructions` and `ticks`."""
        ring = []
        for executed in reversed(self._last):
            ring.append(executed)
            turn = self.ticks - executed.began
            if (
                executed.address == processor.extension.inst_field | processor.pc
                and instructions * turn == ticks * len(ring)
            ):
                break
        return ring

    @property
    def instructions(self) -> int:
        """How many instructions there were."""
        return self.executed.total()


def _operation(word: int) -> str:
    """Return the counter of an operation: indirect ones apart, OPR and IOT by name."""
    code = word >> 9
    if code >= IOT:
        return microinstruction(word) or f"{word:04o}"
    return f"{OPERATIONS[code]} I" if word & INDIRECT else OPERATIONS[code]
