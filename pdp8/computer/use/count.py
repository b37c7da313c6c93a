"""How often each word was executed and written, each operation done, and how long the program waited.

A Count watches a machine (`machine.watch.observer = Count()`), which then runs instruction by instruction;
without one a run costs nothing more. What is passed over of a waiting loop is counted as if it had been run:
the loop is known by the instructions before.
"""

from collections import Counter, deque
from collections.abc import Iterator

from pal.isa import FETCH, INDIRECT, IOT, OPERATIONS, jumps_to, tests_flag
from pdp8.computer.hardware.processor import Processor
from pdp8.computer.hardware.signals import CYCLE, INTERRUPT, IO_TICKS, TICKS_PER_SECOND
from pdp8.computer.use.trace import Listing, instruction
from pdp8.computer.watch import wrote
from tapes.measure import duration, ranges

_RING = 8192
"""Instructions that are remembered: more than the longest loop that is passed over."""
_COLUMN = 12


class Count:
    """What was counted: of each address how often its word was executed, and written; operations by name.

    `ticks` is the time in all, `waiting` that of the turns passed over.
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

    def record(self, listing: Listing) -> dict[str, object]:
        """Return all of it as JSON has it; addresses are octal strings."""
        return {
            "instructions": self.instructions,
            "cycles": self.cycles,
            "interrupts": self.interrupts,
            "seconds": self.ticks / TICKS_PER_SECOND,
            "waiting_seconds": self.waiting / TICKS_PER_SECOND,
            "operations": dict(self.operations.most_common()),
            "executed": {f"{address:04o}": self.executed[address] for address in sorted(self.executed)},
            "written": {f"{address:04o}": self.written[address] for address in sorted(self.written)},
            "never_executed": [f"{address:04o}" for address in self.never_executed(listing)],
        }

    def table(self, listing: Listing) -> Iterator[str]:
        """Yield the lines of a table for people."""
        share = 100 / max(1, self.instructions)
        yield f"{self.instructions:,} instructions, {self.cycles:,} cycles, {_time(self.ticks)}"
        yield f"waiting {100 * self.waiting / max(1, self.ticks):.2f} %, {_time(self.waiting)}"
        if self.interrupts:
            yield f"interrupts {self.interrupts:,}"
        for name, times in self.operations.most_common():
            yield f"    {name:12} {times:15,} {share * times:7.2f} %"
        yield f"never executed: {ranges(self.never_executed(listing))}"
        yield f"written: {ranges(self.written)}"

    def never_executed(self, listing: Listing) -> list[int]:
        """Return the addresses of the listing whose words were never executed, data among them."""
        return sorted(listing.words.keys() - self.executed.keys())

    def annotated(self, listing: Listing) -> list[str]:
        """Return the listing with, in its margin, how often each word was executed, or written (w)."""
        at = {place: address for address, place in listing.places.items()}
        return [
            f"{self._margin(at.get(place)):>{_COLUMN}}  {line}".rstrip()
            for place, line in enumerate(listing.lines)
        ]

    def _margin(self, address: int | None) -> str:
        if address is None:
            return ""
        if self.executed[address]:
            return f"{self.executed[address]:,}"
        return f"{self.written[address]:,} w" if self.written[address] else "-"


def _time(ticks: int) -> str:
    return duration(ticks / TICKS_PER_SECOND)


def _operation(word: int) -> str:
    """Return what is counted together: an operation, with I its own; an OPR or IOT by its name."""
    code = word >> 9
    if code >= IOT:
        return instruction(0, word)
    return f"{OPERATIONS[code]} I" if word & INDIRECT else OPERATIONS[code]
