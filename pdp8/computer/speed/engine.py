"""The same PDP-8/L for long runs: core is decoded once, then executed from its decoded form.

    core      7300  1205  5201 ...        words, shared with the processor
    forms       6     1     4  ...        what to do, 0 where the word is not decoded
    arg       300   205   201  ...        its operand: an effective address, or OPR bits

The engine keeps no state of its own but the decoded forms. It works on the registers and the core of the
processor in processor.py, and leaves to it whatever is rare or reaches outside: IOT, HLT, OSR, what MEM PROT
stops, interrupts, and the last instruction before a run ends, which lights the lamps. So a run is

    piece ─► does the program only wait? ─► one instruction of the processor ─► does it wait? ─► piece ...

where a piece (piece.py) goes on until something is due (a flag under ION, a data break, the end of the run)
or such an instruction comes. In more than 4K a piece stays in one instruction field and one data field. Every
store, by the program or from outside, clears the decoded form of its word. ISZ X, JMP .-1 is counted down at
once, as far as the piece goes.

This file runs as it is; Cython compiles it with the types in engine.pxd beside it.

Sources: those of processor.py, which tests hold this in lockstep with.
"""

from array import array
from collections.abc import Set

from pal.isa import (
    BREAK,
    CLA,
    EXECUTE,
    FETCH,
    GROUP_2,
    INDIRECT,
    IOT,
    ISZ,
    JMP,
    JMS,
    REVERSED,
    autoindexed,
    jumps_to,
    refers_to,
)
from pdp8.computer.hardware.extension import FIELD
from pdp8.computer.hardware.processor import Processor
from pdp8.computer.hardware.signals import CYCLE, PROTECTED
from pdp8.computer.speed import piece
from pdp8.computer.speed.piece import (
    AND_I,
    AND_X,
    DCA_AUTO,
    DCA_I,
    DCA_X,
    DELAY,
    GROUP_1,
    GROUP_1_ROTATE,
    ISZ_I,
    ISZ_X,
    JMP_I,
    JMP_X,
    JMS_I,
    JMS_X,
    LEFT,
    RAL,
    RAR,
    SKIP,
    SKIP_CLA,
    SKIP_UNLESS,
    SKIP_UNLESS_CLA,
    STRIDE,
    TAD_AUTO,
    TAD_I,
    TAD_X,
    UNDECODED,
    WRAP,
)
from pdp8.computer.speed.waiting import Waiting

LONGEST = 3
"""The cycles of the longest instruction a piece executes."""
PIECE = 200_000
"""The ticks of the longest piece: as many cycles can be counted in 13 bits of its `time`."""
_CYCLES = PIECE // CYCLE

# The conditions of every {L, AC} by the bits of the skips that look for them: SMA 100, SZA 40, SNL 20.
CONDITIONS = b"\x20" + bytes(2047) + b"\x40" * 2048 + b"\x30" + b"\x10" * 2047 + b"\x50" * 2048

_DIRECT = (AND_X, TAD_X, ISZ_X, DCA_X, JMS_X, JMP_X)
_INDIRECT = (AND_I, TAD_I, ISZ_I, DCA_I, JMS_I, JMP_I)
_AUTOINDEXED = (LEFT, TAD_AUTO, LEFT, DCA_AUTO, LEFT, LEFT)
_FREQUENT_ROTATES = {0o4: RAL, 0o10: RAR}
_ARG = array("H", bytes(2 * 8 * STRIDE))
# Group 1 without its rotate, by its low 8 bits: {L, AC} & keep ^ flip, + plus.
_KEEP = array(
    "H", [(0o10000 if i & 0o200 else 0o17777) & (0o7777 if i & 0o100 else 0o17777) for i in range(256)]
)
_FLIP = array("H", [(0o7777 if i & 0o40 else 0) | (0o10000 if i & 0o20 else 0) for i in range(256)])
_PLUS = array("H", [i & 1 for i in range(256)])
_SKIPS = {0: SKIP, REVERSED: SKIP_UNLESS, CLA: SKIP_CLA, CLA | REVERSED: SKIP_UNLESS_CLA}


class Engine:
    """Runs a processor in pieces; with `delays` a delay loop is counted down in one step."""

    def __init__(self, processor: Processor, waiting: Waiting, delays: bool = True) -> None:
        self.processor = processor
        self.waiting = waiting
        self.delays = delays
        self.core = processor.core
        self.base = 0
        """Where the decoded forms of the instruction field begin."""
        self.wall = 0o10000
        """The first address that may not be written: MEM PROT's, or that after the end of core."""
        self.breakpoints: Set[int] = frozenset()
        self.has_breakpoints = False
        """Whether there are any breakpoints."""
        self.conditions = CONDITIONS
        # Two words past the end of a field wrap the PC, which can overrun by a skip.
        for field in range(processor.extension.size // FIELD):
            past = STRIDE * field + FIELD
            self.processor.forms[past] = self.processor.forms[past + 1] = WRAP
        self.arg = _ARG[:]
        self.registers = [0, 0, 0]
        self.keep, self.flip, self.plus = _KEEP[:], _FLIP[:], _PLUS[:]

    def run(self, until: int, last: int, breakpoints: Set[int] = frozenset()) -> bool:
        """Run to tick `until`, to `last` instructions in all, to an endless wait or a stop; return True only
        at one of the `breakpoints`, or after a JMS to one.
        """
        self._prepare(breakpoints)
        self.waiting.endless = False
        return self._run_pieces(until, last)

    def _called(self) -> bool:
        """Tell whether the last instruction was a JMS to a breakpoint."""
        p = self.processor
        return (
            p.run == 1 and p.ir == JMS and p.state == EXECUTE and p.extension.field | p.ma in self.breakpoints
        )

    def _prepare(self, breakpoints: Set[int]) -> None:
        """Clear the decoded words if MEM PROT or breakpoints have changed since the last run."""
        wall = _wall(self.processor.mem_prot)
        if wall == self.wall and breakpoints == self.breakpoints:
            return
        self.wall = wall
        self.breakpoints = frozenset(breakpoints)
        self.has_breakpoints = len(breakpoints) > 0
        for address in range(self.processor.extension.size):
            self.processor.forms[address + 2 * (address // FIELD)] = UNDECODED

    def _room(self, until: int, last: int) -> int:
        """Return the cycles of the next piece, 0 if the processor has to do the next instruction itself."""
        p = self.processor
        if p.next != FETCH or self.waiting.stepping:
            return 0
        if self.wall != _wall(p.mem_prot) or p.extension.changes_field():
            return 0
        if not piece.reaches(p.extension.inst_field, p.extension.data_field):
            return 0
        room = min(PIECE, self.waiting.next_look - p.clock, until - p.clock - LONGEST * CYCLE)
        if last - p.instructions <= _CYCLES:
            room = min(room, (last - p.instructions - 1) * CYCLE)
        if p.ion and (not p.ion_delayed or p.bus.request(p.clock)):
            return 0
        if p.ion or p.bus.has_breaks:
            room = min(room, p.bus.next_event(p.clock) - p.clock - LONGEST * CYCLE)
        return max(room + CYCLE - 1, 0) // CYCLE if p.run else 0

    def _decode(self, address: int) -> None:
        """Fill in the operation of the word at `address`, and its operand."""
        field = self.processor.extension.inst_field
        word = self.core[field | address]
        code = word >> 9
        if code < IOT:
            operand = refers_to(word, address)
            op = self._memory_reference(word, operand, address)
        elif code == IOT:
            operand, op = 0, LEFT
        elif not word & GROUP_2:
            operand, op = word & 0o377, _group1(word & 0o377)
        else:
            operand, op = _group2(word)
        if self.has_breakpoints and self._may_lead_to_one(word, operand, address):
            op = LEFT
        self.arg[self.base + address] = operand
        self.processor.forms[self.base + address] = op

    def _memory_reference(self, word: int, operand: int, address: int) -> int:
        code = word >> 9
        if word & INDIRECT:
            return _AUTOINDEXED[code] if autoindexed(operand) else _INDIRECT[code]
        if code == JMP:
            return LEFT if operand == address else JMP_X
        if code >= ISZ and operand >= self.wall:
            return LEFT
        if code == ISZ and self.delays and self._may_delay(operand, address):
            return DELAY
        return _DIRECT[code]

    def _may_delay(self, counter: int, address: int) -> bool:
        """Whether ISZ at `address` is a delay loop: JMP .-1 follows, and it counts neither word."""
        if address == 0o7777 or counter in (address, address + 1):
            return False
        behind = self.core[self.processor.extension.inst_field | address + 1]
        return jumps_to(address, behind, address + 1)

    def _may_lead_to_one(self, word: int, operand: int, address: int) -> bool:
        """Whether the next instruction may be at a breakpoint, where the lamps must be exact."""
        after = [address + 1 & 0o7777, address + 2 & 0o7777]
        if word >> 9 in (JMS, JMP):
            if word & INDIRECT:
                return True
            after = [operand, operand + 1 & 0o7777]
        field = self.processor.extension.inst_field
        return field | after[0] in self.breakpoints or field | after[1] in self.breakpoints

    def _run_pieces(self, until: int, last: int) -> bool:
        """Run piece by piece; return whether it ended with a JMS to a breakpoint."""
        p, waiting = self.processor, self.waiting
        while p.clock < until and p.instructions < last:
            self.base = (p.extension.inst_field >> 12) * STRIDE
            left = p.forms[self.base + (p.pc & 0o7777)] == LEFT
            if left or not self._run_piece(self._room(until, last) << 26):
                p.instruction()
                if self.has_breakpoints and self._called():
                    return True
                if not p.run:
                    return False
            waiting.look(until, last)
            if waiting.endless or (self.has_breakpoints and self._at_breakpoint()):
                return False
        return False

    def _at_breakpoint(self) -> bool:
        """Whether the run has reached a breakpoint; after a data break its instruction is finished first."""
        p = self.processor
        return p.state != BREAK and p.extension.inst_field | p.pc in self.breakpoints

    def _run_piece(self, limit: int) -> bool:
        """Run a piece of `limit`; return whether it executed anything."""
        if limit == 0:
            return False
        p, registers = self.processor, self.registers
        registers[0], registers[1], registers[2] = p.pc & 0o7777, p.lac & 0o17777, 0
        while self._execute(limit) == UNDECODED:
            self._decode(registers[0])
        time = registers[2]
        if time == 0:
            return False
        p.pc, p.lac = registers[0] & 0o7777, registers[1]
        p.clock += (time >> 26) * CYCLE
        p.instructions += time & 0o17777
        p.writes += time >> 13 & 0o17777
        p.protect = 0
        return True

    def _execute(self, limit: int) -> int:
        p = self.processor
        return piece.run(
            self.core,
            p.forms,
            self.arg,
            p.extension.inst_field,
            p.extension.data_field,
            self.keep,
            self.flip,
            self.plus,
            self.conditions,
            self.registers,
            self.wall,
            limit,
        )


def _wall(mem_prot: int) -> int:
    return PROTECTED if mem_prot else 0o10000


def _group1(bits: int) -> int:
    rotate = bits & 0o14
    if rotate == 0:
        return GROUP_1
    return LEFT if rotate == 0o14 else _FREQUENT_ROTATES.get(bits, GROUP_1_ROTATE)


def _group2(word: int) -> tuple[int, int]:
    """Return operand and operation; group 3 does nothing, OSR and HLT are not decoded."""
    if word & 1:
        return 0, GROUP_1
    if word & 6:
        return 0, LEFT
    return word & 0o160, _SKIPS[word & 0o210]
