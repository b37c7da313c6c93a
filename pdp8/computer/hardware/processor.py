"""The PDP-8/L's processor, one memory cycle at a time.

                 ┌────────── direct JMP, OPR, IOT ──────────┐
                 ▼                                          │
      ┌──►  FETCH ──── indirect ────►  DEFER ──── JMP I ────┤
      │      │ direct                   │                   │
      │      └───────►  EXECUTE  ◄──────┘                   │
      │                    │                                │
      └────────────────────┴── end of instruction ◄─────────┘
                                   │ request and ION                    │ else BRK RQ at the last TP1
                                   ▼                                    ▼
               INTERRUPT: an EXECUTE cycle that does JMS 0     WORD COUNT, CURRENT ADDRESS, BREAK

A cycle begins by loading MA and ends with MA, MB, IR and the major state as the lamps show them; what the
next cycle needs is in them, so the lamps are the whole state. After HLT they show the HLT.

Time is exact: a cycle is 1.6 us, an IOT 4.25 us whatever its device code, its three pulses at 1.45, 2.35 and
3.25 us whether they are sent or not. All in ticks of 0.05 us.

Interrupt: ION takes effect after the next instruction, IOF at once; a request is looked at as the instruction
ends. If the machine stops there, CONT does the interrupt. IOT 600x: pulse 1 is ION, pulse 2 IOF, in this
order. What 6003 to 6007 do is undefined on an 8/L; here they do as their pulses do.

MEM PROT stops a write into 7600-7777: the word stays, the rest of the cycle happens, PROTECT lights, the
machine stops.

Each cycle is in a field, which the memory extension (extension.py) names; in 4K that is field 0, and its IOTs
do nothing. A data break comes between two instructions, after an interrupt that is due; an instruction in
which the machine stops is followed by it at CONT. WORD COUNT and CURRENT ADDRESS are in field 0.

Not emulated: MP8/L parity, KP8/L power fail. AC, L, PC, MA, MB are 0 at power-up, where a real machine's are
whatever they are.

Sources: PDP-8/L Users Handbook 1968; Small Computer Handbook 1970; PDP-8/I instruction card (4.25 us); pulse
times and MEM PROT as measured on a real 8/L by the pdp8l project (mrieker).
"""

from array import array

from pal.isa import (
    AND,
    BREAK,
    CURRENT_ADDRESS,
    DCA,
    DEFER,
    EXECUTE,
    FETCH,
    GROUP_2,
    GROUP_3,
    HLT,
    INDIRECT,
    IOT,
    ISZ,
    JMP,
    JMS,
    NO_STATE,
    OPR,
    TAD,
    WORD_COUNT,
    autoindexed,
    refers_to,
)
from pdp8.computer.hardware.bus import BreakDevice, Bus
from pdp8.computer.hardware.extension import FIELD, Extension
from pdp8.computer.hardware.fields import BIT, COUNT, TICK, saved
from pdp8.computer.hardware.operate import group1, group2, skips
from pdp8.computer.hardware.signals import CYCLE, INTERRUPT, IO_TICKS, PROTECTED, TP1

_FORMS = array("H", bytes(2 * 8 * (FIELD + 2)))
"""The decoded forms of the largest core, of which none is known."""


class Processor:
    """The registers, the core, and what one memory cycle does to them."""

    fields = saved(
        **dict.fromkeys(("pc", "ma", "mb", "sr"), "7777"),
        **dict.fromkeys(("run", "stopping", "ion", "ion_delayed", "mem_prot", "sing_step", "protect"), BIT),
        **dict.fromkeys(("instructions", "writes"), COUNT),
        **dict.fromkeys(("clock", "started"), TICK),
        lac="17777",
        ir="7",
        state=BREAK,
        next=BREAK,
    )

    def __init__(self, bus: Bus, size: int = FIELD) -> None:
        self.bus = bus
        self.extension = Extension(size)
        self.core = array("H", bytes(2 * size))
        """To be read; `deposit` writes."""
        self._core = self.core
        """The same; compiled, a view that is read without asking Python."""
        self.lac = 0
        """The link and the accumulator, one word of 13 bits."""
        self.pc = 0
        self.ma = 0
        self.mb = 0
        self.ir = 0
        """The op code, 0 to 7: three bits, as the lamps have them."""
        self.state = NO_STATE
        """The major state of the last cycle, as the lamps show it."""
        self.next = FETCH
        """The major state of the next one."""
        self.stored = 0
        """Whether the last cycle wrote into core."""
        self.run = 0
        self.stopping = 0
        """Set by STOP in the middle of an instruction, whose end clears RUN."""
        self.ion = 0
        self.ion_delayed = 0
        """Interrupts are taken when this is set too, one instruction after ION."""
        self.sr = 0
        self.mem_prot = 0
        self.sing_step = 0
        self.protect = 0
        """The PROTECT lamp."""
        self.clock = 0
        """Ticks since power-up."""
        self.started = self.clock
        """The clock at the last INITIALIZE."""
        self.instructions = 0
        """Instructions fetched since power-up."""
        self.writes = 0
        """A count that rises whenever words of core are written."""
        self.forms = _FORMS[:]
        """The engine's decoded form of each word, with two more after each field; writing the word sets it to
        0.
        """

    def initialize(self) -> None:
        """INITIALIZE: clear AC, L and the interrupt, and every device; core and PC stay."""
        self.lac = self.ion = self.ion_delayed = self.stopping = 0
        self.extension.inhibit = 0
        self.preset()
        self.started = self.clock
        self.bus.initialize(self.clock)

    def preset(self) -> None:
        """MANUAL PRESET: make the next cycle a FETCH, with no instruction, break or interrupt under way."""
        if self.next > INTERRUPT:
            device = self.bus.in_break()
            assert device is not None
            device.breaking = 0
        self.state = NO_STATE
        self.next = FETCH

    def deposit(self, address: int, word: int) -> None:
        """Write `word`, of 12 bits, into core at `address`, field and all."""
        self._core[address] = word
        self.forms[address + 2 * (address >> 12)] = 0
        self.writes += 1

    def fill(self, words: "array[int]") -> None:
        """Write words into core from address 0 on; a word that is there already is not written."""
        for address in range(len(words)):
            if words[address] != self._core[address]:
                self.deposit(address, words[address])

    def stop(self) -> None:
        """STOP: clear RUN at the end of the instruction, before an interrupt that is due."""
        if self.within():
            self.stopping = self.run
        else:
            self.run = 0

    def within(self) -> bool:
        """Tell whether the last cycle left an instruction or a break unfinished."""
        if self.next <= INTERRUPT:
            return self.next in (DEFER, EXECUTE)
        return self.state in (WORD_COUNT, CURRENT_ADDRESS)

    def cycle(self) -> None:
        """Run one memory cycle, at whose end SING STEP clears RUN."""
        self.protect = self.stored = 0
        if self.next == FETCH:
            self._fetch()
        elif self.next == DEFER:
            self._defer()
        elif self.next == EXECUTE:
            self._execute()
        elif self.next == INTERRUPT:
            self._interrupt()
        else:
            self._break()
        if self.next == FETCH and (self.ion or self.stopping or self.bus.has_breaks):
            self._end()
        if self.sing_step:
            self.run = 0

    def instruction(self) -> None:
        """Run cycles to the end of the instruction, or of an interrupt or a break that is due."""
        self.protect = 0
        if self.next == INTERRUPT:
            self._interrupt()
        elif self.next > INTERRUPT:
            self._break()
            while self.next > INTERRUPT and not self.protect:
                self._break()
        else:
            if self.next == FETCH:
                self._fetch()
            if self.next == DEFER:
                self._defer()
            if self.next == EXECUTE:
                self._execute()
        if self.next == FETCH and (self.ion or self.stopping or self.bus.has_breaks):
            self._end()

    def _fetch(self) -> None:
        self.state = FETCH
        self.ma = self.pc
        self.extension.field = self.extension.inst_field
        self.mb = word = self._core[self.extension.field | self.ma]
        self.ir = code = word >> 9
        self.pc = self.ma + 1 & 0o7777
        self.clock += CYCLE
        self.instructions += 1
        if code < JMP:
            self.next = DEFER if word & INDIRECT else EXECUTE
            if code == JMS and not word & INDIRECT:
                self.extension.load_inst_field()
        elif code == OPR:
            self._operate(word)
        elif code == IOT:
            self._input_output(word)
        elif word & INDIRECT:
            self.next = DEFER
        else:
            self.pc = refers_to(word, self.ma)
            self.extension.load_inst_field()

    def _defer(self) -> None:
        self.state = DEFER
        self.ma = refers_to(self.mb, self.ma)
        self.extension.field = self.extension.inst_field
        self.mb = self._core[self.extension.field | self.ma]
        if autoindexed(self.ma):
            self._write(self.mb + 1 & 0o7777)
        if self.ir == JMP:
            self.pc = self.mb
            self.next = FETCH
        else:
            self.next = EXECUTE
        if self.ir in (JMP, JMS):
            self.extension.load_inst_field()
        self.clock += CYCLE

    def next_field(self) -> int:
        """Return the field of the next cycle, which is the EMA lamp."""
        if self.next == EXECUTE and self.state == DEFER and self.ir != JMS:
            return self.extension.data_field
        if self.next == BREAK:
            device = self.bus.in_break()
            assert device is not None
            return device.field & self.extension.size - 1
        return self.extension.inst_field if self.next < INTERRUPT else 0

    def _execute(self) -> None:
        self.extension.field = self.next_field()
        self.ma = self.mb if self.state == DEFER else refers_to(self.mb, self.ma)
        self.state = EXECUTE
        self.next = FETCH
        self.mb = self._core[self.extension.field | self.ma]
        if self.ir == TAD:
            self.lac = self.lac + self.mb & 0o17777
        elif self.ir == DCA:
            self._write(self.lac & 0o7777)
            self.lac &= 0o10000
        elif self.ir == AND:
            self.lac &= self.mb | 0o10000
        elif self.ir == ISZ:
            self._write(self.mb + 1 & 0o7777)
            if self.mb == 0:
                self.pc = self.pc + 1 & 0o7777
        else:
            self._write(self.pc)
            self.pc = self.ma + 1 & 0o7777
        self.clock += CYCLE

    def _interrupt(self) -> None:
        self.state = EXECUTE
        self.next = FETCH
        self.ir = JMS
        self.ma = self.extension.field = 0
        self.extension.interrupt()
        self._write(self.pc)
        self.pc = 1
        self.ion = self.ion_delayed = 0
        self.clock += CYCLE

    def _break(self) -> None:
        """One cycle of the break that is under way."""
        device = self.bus.in_break()
        assert device is not None
        if self.next == WORD_COUNT:
            self._word_count(device)
        elif self.next == CURRENT_ADDRESS:
            self._current_address(device)
        else:
            self._transfer(device)
        self.clock += CYCLE

    def _word_count(self, device: BreakDevice) -> None:
        self.state = WORD_COUNT
        self.next = CURRENT_ADDRESS
        self.extension.field = 0
        self.ma = device.address
        self.mb = self._core[self.ma]
        overflows = self.mb == 0o7777
        self._write(self.mb + 1 & 0o7777)
        if overflows:
            device.overflow(self.clock)

    def _current_address(self, device: BreakDevice) -> None:
        self.state = CURRENT_ADDRESS
        self.next = BREAK
        self.ma = self.ma + 1 & 0o7777
        self.mb = self._core[self.ma]
        if device.counts_address:
            self._write(self.mb + 1 & 0o7777)

    def _transfer(self, device: BreakDevice) -> None:
        self.extension.field = self.next_field()
        self.ma = self.mb if device.three_cycle else device.address
        self.state = BREAK
        self.next = FETCH
        device.breaking = 0
        self.mb = self._core[self.extension.field | self.ma]
        if device.into_core:
            self._write(device.give(self.clock))
        else:
            device.take(self.mb, self.clock)
            if device.increments:
                self._write(self.mb + 1 & 0o7777)

    def _write(self, word: int) -> None:
        """Write `word` through MB into core at MA; where MEM PROT forbids it, stop the machine instead."""
        if self.mem_prot and self.ma >= PROTECTED and self.extension.field == 0:
            self.protect = 1
            self.run = 0
            return
        self.mb = word
        self.stored = 1
        self.deposit(self.extension.field | self.ma, word)

    def _operate(self, word: int) -> None:
        if not word & GROUP_2:
            self.lac = group1(word, self.lac)
        elif word & GROUP_3 != GROUP_3:
            if skips(word, self.lac):
                self.pc = self.pc + 1 & 0o7777
            self.lac = group2(word, self.lac, self.sr)
            if word & HLT:
                self.run = 0

    def _input_output(self, word: int) -> None:
        if word & 0o700 == 0o200 and self.extension.size > FIELD:
            self.lac = self.extension.input_output(word, self.lac)
        elif word & 0o770:
            answer = self.bus.transfer(word, self.lac, self.clock)
            self.lac = answer & 0o17777
            self.pc = self.pc + (answer >> 13) & 0o7777
        else:
            self._interrupt_enable(word)
        self.clock += IO_TICKS

    def _interrupt_enable(self, word: int) -> None:
        self.bus.actions += 1
        if word & 1:
            self.ion = 1
        if word & 2:
            self.ion = self.ion_delayed = 0

    def _end(self) -> None:
        """End an instruction or a break: a requested interrupt or break comes next, also after a stop."""
        if self.stopping:
            self.run = self.stopping = 0
        if self.ion and self.ion_delayed and not self.extension.inhibit and self.bus.request(self.clock):
            self.next = INTERRUPT
        elif self.bus.has_breaks:
            self._accept_break()
        if self.ion and self.next <= INTERRUPT:
            self.ion_delayed = 1

    def _accept_break(self) -> None:
        began = self.clock - CYCLE
        if self.state == FETCH and self.ir == IOT:
            began -= IO_TICKS
        device = self.bus.accept_break(began + TP1, self.clock)
        if device is not None:
            self.next = WORD_COUNT if device.three_cycle else BREAK
