"""How often each word was executed and written, each operation done, and how long the program waited.

A Count watches a machine (`with machine.count() as count`), which then runs instruction by instruction;
without one a run costs nothing more. What is passed over of a waiting loop is counted as if it had been run:
the loop is known by the instructions before.
"""

from collections import Counter, deque

from pal.disassembler import microinstruction
from pal.isa import FETCH, INDIRECT, IOT, OPERATIONS, jumps_to, tests_flag
from pdp8.computer.hardware.processor import Processor
from pdp8.computer.hardware.signals import CYCLE, INTERRUPT, IO_TICKS
from pdp8.computer.watch import wrote

_RING = 8192
"""Instructions that are remembered: more than the longest loop that is passed over."""


class Count:
    """What was counted: executed[address] and written[address], how often each word was; operations[name];
    interrupts, cycles, and `ticks` of 0.05 us in all, `waiting` those of the loops that only wait.
    """

    def __init__(self) -> None:
        self.executed: Counter[int] = Counter()
        self.written: Counter[int] = Counter()
        self.operations: Counter[str] = Counter()
        self.interrupts = 0
        self.cycles = 0
        self.ticks = 0
        self.waiting = 0
        self._last: deque[tuple[int, int, int]] = deque(maxlen=_RING)
        """The instructions before: address, word and the tick at which they began."""
        self._next = FETCH

    def cycle(self, processor: Processor) -> None:
        """Count a memory cycle that has ended."""
        p = processor
        if p.state == FETCH:
            self._execute(p.ma, p.mb, 1)
            self._last.append((p.ma, p.mb, self.ticks))
            if p.ir == IOT:
                self.ticks += IO_TICKS
        elif self._next == INTERRUPT:
            self.interrupts += 1
        self.cycles += 1
        self.ticks += CYCLE
        if wrote(p):
            self.written[p.ma] += 1
        self._next = p.next

    def waited(self, processor: Processor, instructions: int, ticks: int) -> None:
        """Count what was passed over: whole turns of the loop that the processor stands in."""
        ring = self._ring(processor, instructions, ticks)
        self.ticks += ticks
        self.waiting += ticks
        turns = instructions // len(ring)
        for address, word in ring:
            self._execute(address, word, turns)
        self.cycles += (ticks - IO_TICKS * turns * sum(word >> 9 == IOT for _, word in ring)) // CYCLE

    def _execute(self, address: int, word: int, times: int) -> None:
        self.executed[address] += times
        self.operations[_operation(word)] += times

    def _ring(self, processor: Processor, instructions: int, ticks: int) -> list[tuple[int, int]]:
        """Return one turn of the loop: a flag's test and the JMP back, or what was executed since the PC was
        here before, if turns of it make so many instructions in so many ticks.
        """
        pc, core = processor.pc, processor.core
        after = pc + 1 & 0o7777
        if tests_flag(core[pc]) and jumps_to(pc, core[after], after):
            return [(pc, core[pc]), (after, core[after])]
        ring = []
        for address, word, began in reversed(self._last):
            ring.append((address, word))
            if address == pc and instructions * (self.ticks - began) == ticks * len(ring):
                break
        return ring

    @property
    def instructions(self) -> int:
        """How many instructions there were."""
        return self.executed.total()


def _operation(word: int) -> str:
    """Return what is counted together: an operation, with I its own; an OPR or IOT by its name."""
    code = word >> 9
    if code >= IOT:
        return microinstruction(word) or f"{word:04o}"
    return f"{OPERATIONS[code]} I" if word & INDIRECT else OPERATIONS[code]
