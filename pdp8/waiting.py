"""Loops that only wait, and how many turns of one can be passed over at once without anybody noticing.

A program waits when it comes back to an instruction with the same AC and L, no word of core changed, nothing
told to a device and nothing happened in one since it was last there: KSF, JMP .-1 and its kin, JMP . under
interrupt, a ring of several flag tests. Every further turn is the same turn until the next event of a device.
A delay loop, ISZ X and JMP .-1, is a count and nothing else until X runs out.

Passing over stops short of the event, so that what the event does is done by the processor itself. The count
of instructions and of ticks stays exact.
"""

from pdp8.bus import NEVER
from pdp8.processor import CYCLE, FETCH, ISZ, JMP, PROTECTED, Processor

_DELAY_TICKS = 3 * CYCLE
_PATIENCE = 8


class Waiting:
    """Watches a running processor at its backward jumps."""

    def __init__(self, processor: Processor) -> None:
        self.processor = processor
        self.endless = False
        """Set when the processor stands in a loop that no event will ever end."""
        self.delays = True
        """Whether delay loops are passed over too; not when somebody watches core being written."""
        self.strangers = 0
        """Backward jumps since the remembered one that led elsewhere: a ring may have several."""
        self.quiet_until = 0
        self._remember()

    def _remember(self) -> None:
        p = self.processor
        self.pc, self.lac, self.changes = p.pc, p.lac, p.changes
        self.clock, self.instructions = p.clock, p.instructions
        self.quiet_until = p.bus.next_event()
        self.strangers = 0

    def came_back(self, until: int, instructions: int) -> None:
        """Look at the processor after a jump backward; pass over what it would only wait through.

        Stops short of tick `until` and of `instructions` in all.
        """
        p = self.processor
        if p.core[p.pc] >> 8 == ISZ << 1 and p.ir == JMP and p.state == FETCH and p.ma == p.pc + 1:
            self._pass_delay(until, instructions)
        elif p.changes != self.changes or self.strangers > _PATIENCE:
            p.bus.asked = 0
            self._remember()
        elif p.pc != self.pc or p.lac != self.lac or p.next != FETCH:
            self.strangers += 1
        else:
            self._pass_turns(until, instructions)

    def _pass_turns(self, until: int, instructions: int) -> None:
        p = self.processor
        p.bus.advance(p.clock)
        event = p.bus.next_event()
        if p.clock < self.quiet_until:
            if event == NEVER:
                self.endless = True
                return
            ticks, count = p.clock - self.clock, p.instructions - self.instructions
            turns = min((min(event, until) - 1 - p.clock) // ticks, (instructions - p.instructions) // count)
            if turns > 0:
                p.clock += turns * ticks
                p.instructions += turns * count
        self._remember()

    def _pass_delay(self, until: int, instructions: int) -> None:
        p = self.processor
        word = p.core[p.pc]
        counter = word & 0o177 | (p.pc & 0o7600 if word & 0o200 else 0)
        if not self.delays or counter in (p.pc, p.pc + 1) or (p.mem_prot and counter >= PROTECTED):
            return
        p.bus.advance(p.clock)
        turns = min(
            0o7777 - p.core[counter],
            (min(p.bus.next_event(), until) - 1 - p.clock) // _DELAY_TICKS,
            (instructions - p.instructions) // 2,
        )
        if turns > 0 and p.next == FETCH:
            p.core[counter] += turns
            p.clock += turns * _DELAY_TICKS
            p.instructions += turns * 2
            p.changes += 1
