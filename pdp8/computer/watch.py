"""What can be watched while a machine runs.

Breakpoints at addresses, breakpoints on words being read or written, and an observer that is called after
every memory cycle and for every wait that was passed over.
"""

from typing import Protocol

from pal.isa import AND, DCA, DEFER, EXECUTE, ISZ, JMS, TAD, WORD_COUNT, autoindexed, in_field
from pdp8.computer.hardware.processor import Processor
from pdp8.computer.hardware.signals import INTERRUPT


class Observer(Protocol):
    """Is called with what a processor does; `Processor.stop` ends the run."""

    def cycle(self, processor: Processor, interrupt: bool) -> None:
        """Called after each memory cycle; the lamps show it."""

    def waited(self, processor: Processor, instructions: int, ticks: int) -> None:
        """Called when `instructions` of a waiting loop, `ticks` long, were skipped."""


class Watch:
    """The breakpoints and the observer of a machine; `again` is true while a recorded run is repeated."""

    def __init__(self, again: bool = False) -> None:
        self.again = again
        self.breakpoints: set[int] = set()
        """Addresses before whose instruction a run stops, and after a JMS to them."""
        self.writes: set[int] = set()
        """Addresses of words after whose writing a run stops."""
        self.reads: set[int] = set()
        """Addresses of words after whose reading a run stops, as operands or pointers."""
        self.observer: Observer | None = None
        self.reached = False
        """Set when the last instruction wrote or read a watched word, or was a JMS to a breakpoint."""
        self.written: set[int] = set()
        self.read: set[int] = set()
        """Which of the watched words the last instruction wrote, and which it read."""

    def each_cycle(self) -> bool:
        """Tell whether every cycle has to be looked at; breakpoints alone do not need it."""
        return bool(self.writes or self.reads or self.observer)

    def instruction(self, processor: Processor) -> None:
        """Run one instruction, interrupt or break, looking at each cycle; SING STEP may act within."""
        self.reached = False
        self.written.clear()
        self.read.clear()
        self.cycle(processor)
        while processor.within() and not (processor.sing_step or processor.protect):
            self.cycle(processor)

    def called(self, processor: Processor) -> bool:
        """Tell whether the last cycle was that of a JMS to a breakpoint."""
        return (
            processor.state == EXECUTE
            and processor.ir == JMS
            and memory_address(processor) in self.breakpoints
        )

    def cycle(self, processor: Processor) -> None:
        """Run one memory cycle, and look at it."""
        interrupt = processor.next == INTERRUPT
        processor.cycle()
        if wrote(processor):
            self.reached |= self.called(processor)
            if memory_address(processor) in self.writes:
                self.written.add(memory_address(processor))
        if memory_address(processor) in self.reads and read(processor):
            self.read.add(memory_address(processor))
        self.reached |= bool(self.written or self.read)
        if self.observer:
            self.observer.cycle(processor, interrupt)


def memory_address(processor: Processor) -> int:
    """Return MA with the field in front of it."""
    return processor.extension.field | processor.ma


def wrote(processor: Processor) -> bool:
    """Whether the last cycle wrote the word at MA."""
    if processor.state >= WORD_COUNT:
        return processor.stored == 1
    if processor.state == EXECUTE:
        return processor.ir in (ISZ, DCA, JMS) and not processor.protect
    return processor.state == DEFER and autoindexed(processor.ma)


def read(processor: Processor) -> bool:
    """Whether the last cycle read the word at MA as operand or pointer."""
    if processor.state == EXECUTE:
        return processor.ir in (AND, TAD, ISZ)
    return processor.state == DEFER


def instruction_at(processor: Processor) -> int:
    """Return the address of the current or next instruction."""
    within = processor.next in (DEFER, EXECUTE)  # its first cycle has counted PC on
    return in_field(processor.extension.inst_field, processor.pc - within)
