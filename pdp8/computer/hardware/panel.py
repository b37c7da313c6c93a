"""The operator's panel of the PDP-8/L: lamps, switches and keys.

EMA .  MA  ............    IR ...                  FETCH  DEFER  EXECUTE
    MB  ............  LINK .  AC ............      WORD COUNT  CURRENT ADDRESS  BREAK
                                                   ION  PARITY  PROTECT  RUN
    DATA FIELD  INST FIELD  SR  ____________  MEM PROT   LOAD ADD   START CONT STOP   SING STEP   EXAM DEP

An 8/L has no lamps for the PC, and its IR shows the op code as three bits. LOAD ADD does a memory cycle, so
that MB shows the word. All keys but STOP do nothing while RUN is on. LOAD ADD, EXAM, DEP and START abandon
an instruction or a data break that is not finished, and an interrupt that is due; all major states are dark.

EMA and the field switches belong to the memory extension, and do nothing without one. EMA shows the field of
the next cycle, where MA shows the address of the last one. LOAD ADD loads IF and DF from the switches; it,
EXAM and DEP are in the instruction field.

A hand comes between two cycles: SING STEP stops the machine there, STOP at the end of the instruction.

Not emulated: the power and lock switch, the 100 ms a key takes. PARITY never lights.

By convention, where the sources differ (docs/emulated.md): STOP comes before an interrupt that is due, which
CONT then does; ION lights its lamp at once; a DEP that MEM PROT refuses leaves the old word in MB.

Sources: PDP-8/L Users Handbook 1968, operator console; the RTL of an 8/L, and key sequences as tried on a
real one, by the pdp8l project (mrieker); the gates of an 8/I from DEC's drawings (drovak/verilogpdp).
"""

from collections.abc import Callable, Sequence
from typing import Final, NamedTuple

from pal.isa import BREAK, CURRENT_ADDRESS, DEFER, EXECUTE, FETCH, WORD_COUNT
from pdp8.computer.hardware.core import allowed
from pdp8.computer.hardware.extension import FIELD
from pdp8.computer.hardware.processor import Processor
from pdp8.computer.hardware.signals import PROTECTED


class Lamps(NamedTuple):
    """What the lamps show: words for the rows, 0 or 1 for the single ones."""

    ma: int
    mb: int
    link: int
    ac: int
    ir: int
    fetch: int
    defer: int
    execute: int
    word_count: int
    current_address: int
    break_: int
    ion: int
    parity: int
    protect: int
    run: int


LAMPS: Final = {
    "ma": 12, "mb": 12, "link": 1, "ac": 12, "ir": 3, "fetch": 1, "defer": 1, "execute": 1, "word_count": 1,
    "current_address": 1, "break_": 1, "ion": 1, "parity": 1, "protect": 1, "run": 1,
}  # fmt: skip
"""How many lamps each field of Lamps has."""


def shares(samples: Sequence[Lamps]) -> dict[str, tuple[float, ...]]:
    """Return how often each lamp was lit, 0 to 1, by field, the most significant bit first."""
    found: dict[str, tuple[float, ...]] = {}
    for field, width in LAMPS.items():
        words = [int(getattr(sample, field)) for sample in samples]
        places = range(width - 1, -1, -1)
        found[field] = tuple(sum(word >> place & 1 for word in words) / len(words) for place in places)
    return found


class Panel:
    """The keys and switches of a processor; `run` runs the machine until it stops."""

    def __init__(self, processor: Processor, run: Callable[[], object]) -> None:
        self.processor = processor
        self._run = run

    @property
    def sr(self) -> int:
        """The switch register."""
        return self.processor.sr

    @sr.setter
    def sr(self, word: int) -> None:
        self.processor.sr = allowed(word, "the switch register")

    @property
    def mem_prot(self) -> bool:
        """MEM PROT: up, and 7600-7777 cannot be written."""
        return bool(self.processor.mem_prot)

    @mem_prot.setter
    def mem_prot(self, up: bool) -> None:
        self.processor.mem_prot = 1 if up else 0

    @property
    def sing_step(self) -> bool:
        """SING STEP: down, and the machine stops at the end of every cycle, also of the one it is in."""
        return bool(self.processor.sing_step)

    @sing_step.setter
    def sing_step(self, down: bool) -> None:
        p = self.processor
        p.sing_step = 1 if down else 0
        if down:
            p.run = p.stopping = 0

    @property
    def lamps(self) -> Lamps:
        """What the lamps show now."""
        p = self.processor
        return Lamps(
            ma=p.ma,
            mb=p.mb,
            link=p.lac >> 12,
            ac=p.lac & 0o7777,
            ir=p.ir,
            fetch=int(p.state == FETCH),
            defer=int(p.state == DEFER),
            execute=int(p.state == EXECUTE),
            word_count=int(p.state == WORD_COUNT),
            current_address=int(p.state == CURRENT_ADDRESS),
            break_=int(p.state == BREAK),
            ion=p.ion,
            parity=0,
            protect=p.protect,
            run=p.run,
        )

    @property
    def inst_field(self) -> int:
        """INST FIELD, the number of a field."""
        return self.processor.extension.inst_switch >> 12

    @inst_field.setter
    def inst_field(self, field: int) -> None:
        self.processor.extension.inst_switch = self._field(field, "INST FIELD")

    @property
    def data_field(self) -> int:
        """DATA FIELD, the number of a field."""
        return self.processor.extension.data_switch >> 12

    @data_field.setter
    def data_field(self, field: int) -> None:
        self.processor.extension.data_switch = self._field(field, "DATA FIELD")

    def _field(self, field: int, switch: str) -> int:
        return allowed(field, switch, (self.processor.extension.size >> 12) - 1) << 12

    @property
    def ema(self) -> int:
        """The EMA lamp: the number of the field of the next cycle."""
        return self.processor.next_field() >> 12

    def load_add(self) -> None:
        """LOAD ADD: the switches into PC and MA, and MB shows the word there."""
        self.load_address(self.processor.extension.inst_switch | self.processor.sr)

    def load_address(self, address: int) -> None:
        """Load PC and MA with `address`, as LOAD ADD does, and its field with INST FIELD."""
        p = self.processor
        allowed(address, "the address", p.extension.size - 1)
        if not p.run:
            if p.extension.size > FIELD:
                p.extension.load_address(address & 0o70000, p.extension.data_switch)
            p.pc = address & 0o7777
            self._read()

    def exam(self) -> None:
        """EXAM: MB shows the word at PC, and PC goes on."""
        p = self.processor
        if not p.run:
            self._read()
            p.pc = p.pc + 1 & 0o7777

    def dep(self) -> None:
        """DEP: the switches into the word at PC, and PC goes on. Under MEM PROT PROTECT lights instead."""
        p = self.processor
        if p.run:
            return
        self._read()
        if p.mem_prot and p.ma >= PROTECTED and p.extension.field == 0:
            p.protect = 1
        else:
            p.mb = p.sr
            p.deposit(p.extension.field | p.ma, p.sr)
        p.pc = p.pc + 1 & 0o7777

    def _read(self) -> None:
        p = self.processor
        p.preset()
        p.protect = 0
        p.ma = p.pc
        p.extension.field = p.extension.inst_field
        p.mb = p.core[p.extension.field | p.ma]

    def start(self) -> None:
        """START: INITIALIZE, then FETCH at PC."""
        if not self.processor.run:
            self.processor.initialize()
            self._go()

    def cont(self) -> None:
        """CONT: go on with the next cycle; nothing is cleared."""
        if not self.processor.run:
            self._go()

    def _go(self) -> None:
        """Light RUN; under SING STEP it goes off with the end of one cycle."""
        if self.processor.sing_step:
            self._run()
        else:
            self.processor.run = 1

    def stop(self) -> None:
        """STOP: the instruction ends and RUN goes off, before an interrupt that is due."""
        self.processor.stop()
        if self.processor.stopping:
            self._run()
