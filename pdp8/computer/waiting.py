"""Loops that only wait, and how many turns of one can be passed over at once without anybody noticing.

A program waits when it is again as it was: the same PC, AC, L and core, and since then nothing told to a
device and nothing happened in one. Every further turn is the same turn until the next event of a device: KSF,
JMP .-1 and its kin, JMP . under interrupt, a ring of several flag tests. If no event can come, it waits for
ever.

Looking at every instruction would cost more than the waiting, so one looks where programs wait: in front of a
flag test or of a JMP to itself, and, for a loop that has neither, every 10 ms of machine time. All that is
looked at is the state of the machine, so that it makes no difference who runs it or in how many pieces.

Passing over stops short of the event, so that what the event does is done by the processor itself. The count
of instructions and of ticks stays exact.
"""

from array import array

from pal.isa import FETCH, jumps_to, tests_flag
from pdp8.computer.bus import NEVER
from pdp8.computer.processor import CYCLE, IO_TICKS, Processor

PERIOD = 200_000
_TESTS = 8
"""Flag tests of one ring: how many strangers are met before the one remembered is given up."""
_STEPS = 5_000
"""Instructions of one ring that has no flag test: all of core goes round in less, a count in AC in more."""

_FLAG_TICKS = CYCLE + IO_TICKS + CYCLE
"""A turn of KSF, JMP .-1."""


class Waiting:
    """Watches a running processor; `look` belongs after every instruction, or every piece of a run that holds
    no flag test and no JMP to itself and does not reach `strike`.
    """

    def __init__(self, processor: Processor) -> None:
        self.processor = processor
        self.endless = False
        """Set when the processor stands in a loop that no event will ever end."""
        self.watched = False
        """Set while somebody looks at single instructions: a turn is seen before others are passed over."""
        self.strike = 0
        """The tick from which the next look is due wherever the processor is."""
        self.hunting = False
        """Set while every instruction is looked at, because core stood still since the last strike."""
        self.core = processor.core
        self.seen: array[int] | None = None
        """Core when it was remembered, if that is needed because words were written since."""
        self._remember()

    def _remember(self) -> None:
        """Remember the machine as it is, to know it again."""
        p = self.processor
        self.quiet_until = p.bus.next_event(p.clock)  # first: whoever sees a frame now may set the machine
        self.pc, self.lac = p.pc, p.lac
        self.sr, self.mem_prot, self.ion = p.sr, p.mem_prot, p.ion
        self.told = p.bus.told
        self.clock, self.instructions = p.clock, p.instructions
        self.patience = _TESTS
        self.hunting = False
        self.seen = None
        p.written = 0
        p.bus.asked = 0

    def forget(self) -> None:
        """Remember nothing: a hand has come between, or what is passed over next has to be seen first."""
        self.told = -1

    def look(self, until: int, last: int) -> None:
        """Look at the processor between two instructions; pass over what it would only wait through.

        Stops short of tick `until` and of `last` instructions in all.
        """
        p = self.processor
        if self.hunting:
            self._compare(until, last)
        elif p.clock >= self.strike:
            self._strike()
        elif tests_flag(self.core[p.pc]):
            if not self._waits_for_flag(until, last):
                self._compare(until, last)
        elif self._jumps_to(p.pc, p.pc):
            self._compare(until, last)

    def _jumps_to(self, target: int, address: int) -> bool:
        """Tell whether JMP `target`, not indirect, is at `address`."""
        return jumps_to(target, self.core[address], address)

    def _waits_for_flag(self, until: int, last: int) -> bool:
        """Tell whether KSF, JMP .-1 or one of its kin is here, which needs no second turn to be known; pass
        over its turns if the flag is down. One that is for ever is left to be known as any ring is, and so is
        every one if somebody may want to stop in its first turn.
        """
        p = self.processor
        event = p.bus.next_event(p.clock)  # whoever sees a frame now may have stopped the machine, or set it
        if self.watched or event == NEVER or not p.run or p.next != FETCH or p.ion != p.ion_delayed:
            return False
        word = self.core[p.pc]
        code = word >> 3 & 0o77
        if not tests_flag(word) or code == 0 or not self._jumps_to(p.pc, p.pc + 1 & 0o7777):
            return False
        if p.ion and p.bus.request(p.clock):
            return False
        device = p.bus.device(code)
        if device is None or not device.flag:
            self._pass(event, until, last, _FLAG_TICKS, 2)
        return True

    def _strike(self) -> None:
        """Remember, and if core stood still since the last time, look at what follows step by step."""
        p = self.processor
        self.strike = p.clock - p.clock % PERIOD + PERIOD
        still = p.bus.told == self.told and p.clock < self.quiet_until and self._unwritten()
        self._remember()
        if still:
            self.hunting = True
            self.patience = _STEPS
        self.seen = p.core[:]

    def _unwritten(self) -> bool:
        """Tell whether core is as it was remembered. If words were written that may have been the same ones,
        one has to see core twice to know: not the first time.
        """
        p = self.processor
        return not p.written or (self.seen is not None and p.core == self.seen)

    def _compare(self, until: int, last: int) -> None:
        p = self.processor
        if p.bus.told != self.told or p.clock >= self.quiet_until:
            self._remember()
        elif p.pc != self.pc or p.lac != self.lac or p.next != FETCH:
            self.patience -= 1
            if self.patience == 0:
                self._remember()
        elif p.ion != self.ion or p.sr != self.sr or p.mem_prot != self.mem_prot:
            self._remember()
        elif self._unwritten():
            self._pass_turns(until, last)
        else:
            self._remember()
            self.seen = p.core[:]

    def _pass_turns(self, until: int, last: int) -> None:
        p = self.processor
        ticks, count = p.clock - self.clock, p.instructions - self.instructions
        event = p.bus.next_event(p.clock)
        if event == NEVER == self.quiet_until:
            self.endless = True
            self._turn_again(ticks, count)
        else:
            if event == self.quiet_until:
                self._pass(event, until, last, ticks, count)
            self._remember()

    def _pass(self, event: int, until: int, last: int, ticks: int, count: int) -> None:
        """Pass over the turns of `count` instructions in `ticks` that end before `event` and the limits."""
        p = self.processor
        turns = min((min(event, until) - 1 - p.clock) // ticks, (last - 1 - p.instructions) // count)
        if turns > 0:
            p.clock += turns * ticks
            p.instructions += turns * count
            self.strike = max(self.strike, p.clock - p.clock % PERIOD + PERIOD)

    def _turn_again(self, ticks: int, count: int) -> None:
        """Run the last turn once more in its own time, so that the lamps are those of the instruction that
        ended it, whoever ran it.
        """
        p = self.processor
        p.clock -= ticks
        p.instructions -= count
        for _ in range(count):
            p.instruction()
