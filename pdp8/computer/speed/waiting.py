"""Loops that only wait, and how many turns of one can be passed over at once with the same result.

A program waits when it comes back to the same PC, AC, L and core, and in between no pulse has acted on a
device and no flag has changed. Every further turn is then the same turn until the next event of a device:
KSF, JMP .-1 and its kin, JMP . under interrupt, a ring of several flag tests. If no event can come, it
never ends.

To compare at every instruction would cost more than the waiting. So it is done where programs wait: in front
of a flag test or of a JMP to itself, and, for a loop that has neither, every 10 ms of machine time. Only the
state of the machine decides, so that it makes no difference who runs it or in how many pieces.

Passing over ends short of the event, so that the processor itself does what the event does. The count of
instructions and of ticks stays exact.
"""

from array import array

from pal.isa import BREAK, FETCH, IOT, JMP, jumps_to, tests_flag
from pdp8.computer.hardware.extension import FIELD
from pdp8.computer.hardware.fields import BIT, CORE, COUNT, FRAMES, PART, TICK, saved
from pdp8.computer.hardware.processor import Processor
from pdp8.computer.hardware.signals import CYCLE, INTERRUPT, IO_TICKS, NEVER

PERIOD = 200_000
_TESTS = 8
"""Flag tests of one ring: after so many the state remembered is given up for a new one."""
_STEPS = 5_000
"""Instructions of one ring without a flag test: all of core goes round in less, a count in AC in more."""

_FLAG_TICKS = CYCLE + IO_TICKS + CYCLE
"""A turn of KSF, JMP .-1."""
_FIELDS = 0o2
"""The first digit of the codes of the memory extension."""
_FORGOTTEN = -1


class Left:
    """The registers after a run that reached its limit; a loop goes on if they are unchanged."""

    fields = saved(
        **dict.fromkeys(("pc", "sr"), "7777"),
        **dict.fromkeys(("ion", "ion_delayed", "mem_prot"), BIT),
        lac="17777",
        next=BREAK,
        clock=TICK,
        instructions=COUNT,
    )

    def __init__(self, processor: Processor) -> None:
        self.note(processor)
        self.clock = _FORGOTTEN

    def note(self, processor: Processor) -> None:
        """Remember the registers."""
        for name in self.fields:
            setattr(self, name, getattr(processor, name))
        processor.extension.left = processor.extension.registers()

    def forget(self) -> None:
        """Remember nothing: the run ended by itself."""
        self.clock = _FORGOTTEN

    def holds(self, processor: Processor) -> bool:
        """Tell whether the registers are as they were noted."""
        same = all(getattr(self, name) == getattr(processor, name) for name in self.fields)
        return same and processor.extension.left == processor.extension.registers()


class Waiting:
    """Skips a processor's waits: call `look` after each instruction, or each piece up to `next_look`."""

    fields = saved(
        **dict.fromkeys(("stepping", "mem_prot", "ion"), BIT),
        **dict.fromkeys(("next_look", "actions", "clock", "quiet_until"), TICK),
        **dict.fromkeys(("instructions", "writes"), COUNT),
        pc="7777",
        lac="17777",
        sr="7777",
        tries=_STEPS,
        core=CORE,
        marks=FRAMES,
        left=PART,
    )

    def __init__(self, processor: Processor) -> None:
        self.processor = processor
        self.endless = False
        """Set when the processor is in a loop that no event will ever end."""
        self.turn_first = False
        """Set while single instructions are watched: a turn is executed before others are passed over."""
        self.next_look = 0
        """The tick from which the next look is due wherever the processor is."""
        self.stepping = False
        """Set while every instruction is looked at, because core did not change since the last look of this
        kind.
        """
        self.core: array[int] | None = None
        """Core as it was remembered, if that is needed because words were written since."""
        self.marks = b""
        """The breakpoints of the last run, two frames of six bits each: no turn with one is passed over."""
        self.left = Left(processor)
        self._words = processor.core
        self.varies = 0
        """The word that was seen to have changed: it is compared before all of core."""
        self._remember()

    def _remember(self) -> None:
        """Remember the state of the machine, to recognize it."""
        p = self.processor
        self.quiet_until = p.bus.next_event(p.clock)  # first: what sees a frame now may set the machine
        self.pc, self.lac = p.pc, p.lac
        p.extension.remembered = p.extension.registers()
        self.sr, self.mem_prot, self.ion = p.sr, p.mem_prot, p.ion
        self.actions = p.bus.actions
        self.clock, self.instructions = p.clock, p.instructions
        self.tries = _TESTS
        self.stepping = False
        self.core = None
        self.writes = p.writes
        p.bus.forget_tests()

    def forget(self) -> None:
        """Remember nothing, because the machine was changed or the next turn has to be executed."""
        self.actions = _FORGOTTEN

    def look(self, until: int, last: int) -> None:
        """Skip what the processor would only wait through, up to tick `until` and of instruction `last`."""
        p = self.processor
        if p.next > INTERRUPT:
            pass  # a data break comes first
        elif self.stepping:
            self._compare(until, last)
        elif p.clock >= self.next_look:
            self._look_anywhere()
        else:
            word = self._words[p.extension.inst_field | p.pc]
            if word >> 9 == IOT:
                if tests_flag(word) and not self._waits_for_flag(until, last):
                    self._compare(until, last)
            elif word >> 9 == JMP and jumps_to(p.pc, word, p.pc):
                self._compare(until, last)

    def _waits_for_flag(self, until: int, last: int) -> bool:
        """Recognise KSF, JMP .-1 and its like at once and skip its turns; return whether it is here."""
        p = self.processor
        event = p.bus.next_event(p.clock)  # a device that saw a frame may have stopped the machine, or set it
        if self.turn_first or event == NEVER or not p.run or p.next != FETCH or p.ion != p.ion_delayed:
            return False
        field, behind = p.extension.inst_field, p.pc + 1 & 0o7777
        word = self._words[field | p.pc]
        code = word >> 3 & 0o77
        if not tests_flag(word) or not jumps_to(p.pc, self._words[field | behind], behind):
            return False
        if p.extension.changes_field() or (p.extension.size > FIELD and code >> 3 == _FIELDS):
            return False
        if p.ion and p.bus.request(p.clock):
            return False
        device = p.bus.device(code)
        if device is None or not device.flag:
            self._pass(event, until, last, _FLAG_TICKS, 2)
        return True

    def _look_anywhere(self) -> None:
        """Remember the state, and step on if core did not change since the last look."""
        p = self.processor
        self.next_look = p.clock - p.clock % PERIOD + PERIOD
        still = p.bus.actions == self.actions and p.clock < self.quiet_until and self._unchanged()
        self._remember()
        if still:
            self.stepping = True
            self.tries = _STEPS
        self.core = p.core[:]

    def _unchanged(self) -> bool:
        """Whether core is as remembered: words were possibly written, but with the values that they had."""
        p, old = self.processor, self.core
        if p.writes == self.writes:
            return True
        if old is None or self._words[self.varies] != old[self.varies]:
            return False
        if p.core == old:
            return True
        self._find(old)
        return False

    def _find(self, old: "array[int]") -> None:
        """Find a word that has changed."""
        while self._words[self.varies] == old[self.varies]:
            self.varies = self.varies + 1 & len(old) - 1

    def _compare(self, until: int, last: int) -> None:
        p = self.processor
        if p.bus.actions != self.actions or p.clock >= self.quiet_until:
            self._remember()
        elif p.pc != self.pc or p.lac != self.lac or p.next != FETCH:
            self.tries -= 1
            if self.tries == 0:
                self._remember()
        elif (
            p.ion != self.ion
            or p.sr != self.sr
            or p.mem_prot != self.mem_prot
            or p.extension.remembered != p.extension.registers()
        ):
            self._remember()
        elif self._unchanged():
            self._pass_turns(until, last)
        else:
            self._remember()
            self.core = p.core[:]

    def _pass_turns(self, until: int, last: int) -> None:
        p = self.processor
        ticks, count = p.clock - self.clock, p.instructions - self.instructions
        event = p.bus.next_event(p.clock)
        if event == NEVER:
            self.endless = True
            self._turn_again(ticks, count)
        else:
            self._pass(event, until, last, ticks, count)
            self._remember()

    def _pass(self, event: int, until: int, last: int, ticks: int, count: int) -> None:
        """Skip turns of `count` instructions and `ticks` that end before `event` and the limits."""
        p = self.processor
        turns = (min(event, until) - 1 - p.clock) // ticks
        if turns * count >= last - p.instructions:
            turns = (last - 1 - p.instructions) // count
        if turns > 0:
            p.clock += turns * ticks
            p.instructions += turns * count
            self.next_look = max(self.next_look, p.clock - p.clock % PERIOD + PERIOD)

    def _turn_again(self, ticks: int, count: int) -> None:
        """Run the last turn once more in its own time, so that the lamps are those of its end."""
        p = self.processor
        p.clock -= ticks
        p.instructions -= count
        for _ in range(count):
            p.instruction()
