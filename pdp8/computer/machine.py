"""The whole PDP-8/L: the one place that knows every part and wires it, and runs it.

    switches, keys, lamps: panel ── processor ◄─► core
                                        │
                                       bus ── 03 receiver ◄─ reader, keyboard   ┐ Teletype
                                        ├──── 04 transmitter ─► printer, punch  ┘
                                        ├──── 01 high-speed reader              ┐ if fitted
                                        └──── 02 high-speed punch               ┘

The machine is a discrete-event simulation: nothing here sleeps, and the same core and tapes give the same
tapes and the same times. While a program only waits, time jumps (see waiting.py).
"""

from collections.abc import Iterable, Iterator, Mapping
from time import monotonic

from pal.isa import FETCH, halts
from pdp8.computer.bus import NEVER, Bus
from pdp8.computer.engine import Engine
from pdp8.computer.highspeed import HighSpeed
from pdp8.computer.panel import Panel
from pdp8.computer.processor import Processor
from pdp8.computer.stop import Reason, Stop
from pdp8.computer.teletype import Teletype
from pdp8.computer.waiting import Waiting
from pdp8.computer.watch import Watch
from tapes.errors import WorkError

TICKS_PER_SECOND = 20_000_000
_AGES = 1e9
"""Seconds, 31 years: nobody waits longer."""
_FIRST = 1.0
"""Seconds of machine time in the first slice of a run; each one that took less than _SOON of ours is followed
by a longer one, each other by a shorter one.
"""
_SOON = 0.05
_WAITS = (Reason.TAPE_OUT, Reason.IDLE)
_BREATH = 60 * TICKS_PER_SECOND
"""After so much machine time Python may take a signal; a compiled run takes none by itself."""


class LoadError(WorkError):
    """Words that do not go into 4K of core, or a tape that did not load."""


class Core:
    """The 4096 words of core, as they are examined and deposited from outside: checked and masked."""

    def __init__(self, processor: Processor, engine: Engine) -> None:
        self._processor = processor
        self._engine = engine

    def __getitem__(self, address: int) -> int:
        return self._processor.core[_checked(address)]

    def __setitem__(self, address: int, word: int) -> None:
        self._processor.core[_checked(address)] = word & 0o7777
        self._processor.written = 1
        self._engine.forget(address)

    def __len__(self) -> int:
        return len(self._processor.core)

    def __iter__(self) -> Iterator[int]:
        return iter(self._processor.core)


def _ticks(seconds: float) -> int:
    return round(min(seconds, _AGES) * TICKS_PER_SECOND)


def _checked(address: int) -> int:
    if not 0 <= address <= 0o7777:
        raise IndexError(f"core has addresses 0000 to 7777, not {address:o}")
    return address


def _check_words(words: Mapping[int, int]) -> None:
    """Raise LoadError unless every address of `words` lies in 4K of core and every word has 12 bits."""
    for address, word in words.items():
        if not 0 <= address <= 0o7777:
            raise LoadError(f"address {address:05o}: a PDP-8/L with 4K of core ends at 07777")
        if not 0 <= word <= 0o7777:
            raise LoadError(f"address {address:04o}: {word:o} is no word of 12 bits")


class Machine:
    """A PDP-8/L with 4K of core and an ASR-33, as it is when it is switched on: core and registers 0.

    `highspeed` fits the PC8/L reader and punch too.
    """

    def __init__(self, highspeed: bool = False) -> None:
        self.bus = Bus()
        self.teletype = Teletype()
        self.teletype.connect(self.bus)
        self.processor = Processor(self.bus)
        self.waiting = Waiting(self.processor)
        self.engine = Engine(self.processor, self.waiting)
        self.core = Core(self.processor, self.engine)
        self.panel = Panel(self.processor)
        self.watch = Watch()
        self._minded = frozenset[int]()
        self._left: tuple[int, ...] = ()
        self.highspeed = HighSpeed()
        if highspeed:
            self.highspeed.connect(self.bus)
        self.power_up()

    def power_up(self) -> None:
        """Do what the power switch does: INITIALIZE, and stand still."""
        self.processor.initialize()
        self.processor.run = 0

    def load(self, words: Mapping[int, int] | Iterable[tuple[int, int]]) -> None:
        """Put `words`, {address: word}, into core. Raises LoadError if one lies outside it, and then loads
        none.
        """
        words = dict(words)
        _check_words(words)
        for address, word in words.items():
            self.core[address] = word

    def start(self, address: int | None = None) -> None:
        """Press START, after LOAD ADD of `address` if one is given; time counts from here."""
        if address is not None:
            self.pc = address
        self.processor.initialize()
        self.processor.run = 1

    def stop(self) -> None:
        """Press STOP: the run ends with the instruction."""
        self.panel.stop()

    def wait(self, seconds: float) -> None:
        """Let time pass while the processor stands still: the Teletype goes on with what it has begun.

        Raises ValueError for less than nothing.
        """
        if seconds < 0:
            raise ValueError("time does not go back")
        self.processor.clock += _ticks(seconds)
        self.bus.advance(self.processor.clock)

    def run(self, seconds: float | None = None, instructions: int | None = None) -> Stop:
        """Run until the program stops or only waits for what can never come; return why.

        `seconds` of machine time and number of `instructions` limit this run. From a standstill this is CONT.
        """
        p = self.processor
        until = NEVER if seconds is None else min(NEVER, p.clock + _ticks(seconds))
        last = NEVER if instructions is None else min(NEVER, p.instructions + instructions)
        p.run = 1
        self.bus.advance(p.clock)
        if self._left != self._registers():
            self.waiting.forget()
        self._mind_breakpoints()
        if p.sing_step:
            reason = self._cycle()
        elif self.watch.watchful():
            reason = self._run_watched(until, last)
        else:
            reason = self._run(until, last)
        left = self._registers()
        self.bus.advance(p.clock)
        if not p.run and reason is Reason.LIMIT:  # who saw a frame just now pressed STOP
            reason = self._stopped()
        if reason is not Reason.LIMIT:
            self.bus.finish()
        self._left = left if reason is Reason.LIMIT else ()
        return Stop(reason, p.pc, self.elapsed)

    def slices(
        self,
        seconds: float | None = None,
        shortest: float = 0.05,
        longest: float = 60.0,
        through_waits: bool = False,
    ) -> Iterator[Stop]:
        """Run as `run` does, slice by slice; yield how the machine stands after each, the last time as the
        run ended. Until then the reason is `limit`.

        A slice takes some twentieth of a second of real time, but `shortest` to `longest` seconds of machine
        time: whoever runs the machine can look at it in between, press keys, STOP too, or leave the loop. A
        program that waits for what can never come ends the run, unless `through_waits`: then whoever presses
        a key, or lets time pass with `wait`, has it go on.
        """
        last = NEVER if seconds is None else self.ticks + _ticks(seconds)
        slice_ = min(max(_FIRST, shortest), longest)
        while True:
            began = monotonic()
            stop = self.run(min(slice_, max(last - self.ticks, 0) / TICKS_PER_SECOND))
            ended = stop.reason is not Reason.LIMIT or self.ticks >= last
            if not ended and stop.pc in self.watch.breakpoints:
                stop, ended = stop._replace(reason=Reason.BREAKPOINT), True
            soon = monotonic() < began + _SOON
            slice_ = min(2 * slice_, longest) if soon else max(slice_ / 2, shortest)
            yield stop
            if ended and not (through_waits and stop.reason in _WAITS and self.ticks < last):
                return
            if not self.processor.run:
                self.bus.finish()
                yield Stop(Reason.STOP_KEY, self.pc, self.elapsed)
                return

    def _registers(self) -> tuple[int, ...]:
        """Return what a hand may have changed when a run goes on; what only waited then waits anew."""
        p = self.processor
        return p.clock, p.instructions, p.pc, p.lac, p.next, p.ion, p.ion_delayed, p.sr, p.mem_prot

    def _mind_breakpoints(self) -> None:
        """Have no turn of a loop passed over in which a breakpoint lies or a watched word is written."""
        breakpoints = frozenset(self.watch.breakpoints)
        self.waiting.watched = self.watch.watchful() or len(breakpoints) > 0
        if self.watch.writes or self.processor.pc in breakpoints or breakpoints != self._minded:
            self.waiting.forget()
            self._minded = breakpoints

    def _run(self, until: int, last: int) -> Reason:
        """Let the engine run, as far as nobody looks closer than at breakpoints."""
        p, breakpoints = self.processor, self.watch.breakpoints
        while not self.engine.run(min(until, p.clock + _BREATH), last, breakpoints):
            if self.waiting.endless:
                return self._endless()
            if not p.run:
                return self._stopped()
            if p.clock >= until or p.instructions >= last:
                return Reason.LIMIT
            if p.pc in breakpoints:
                break
        return Reason.BREAKPOINT

    def _run_watched(self, until: int, last: int) -> Reason:
        """Run as `_run` does, instruction by instruction, and tell the watch of each cycle."""
        p, watch, waiting = self.processor, self.watch, self.waiting
        waiting.endless = False
        first = True
        while p.clock < until and p.instructions < last:
            if p.pc in watch.breakpoints and not first:
                return Reason.BREAKPOINT
            first = False
            watch.instruction(p)
            if not p.run:
                return self._stopped()
            if watch.reached:
                return Reason.BREAKPOINT
            instructions, clock = p.instructions, p.clock
            waiting.look(until, last)
            if waiting.endless:
                return self._endless()
            if watch.observer and p.clock > clock:
                watch.observer.waited(p, p.instructions - instructions, p.clock - clock)
        return Reason.LIMIT

    def _endless(self) -> Reason:
        """Return why a loop will never end."""
        return Reason.TAPE_OUT if self._out_of_tape() else Reason.IDLE

    def _cycle(self) -> Reason:
        """Do what CONT does under SING STEP, and say what the run came to."""
        self.processor.run = 0
        self.processor.cycle()
        return Reason.PROTECT if self.processor.protect else Reason.STOP_KEY

    def _stopped(self) -> Reason:
        """Return why RUN went off."""
        p = self.processor
        if p.protect:
            return Reason.PROTECT
        return Reason.HALT if p.state == FETCH and halts(p.mb) else Reason.STOP_KEY

    def _out_of_tape(self) -> bool:
        """Tell whether the loop the program stands in waits for a reader whose tape has run out."""
        p = self.processor
        return any(
            device.out_of_tape() and (p.ion or self.bus.asked >> device.code & 1) for device in self.bus
        )

    @property
    def ac(self) -> int:
        """The accumulator."""
        return self.processor.lac & 0o7777

    @ac.setter
    def ac(self, word: int) -> None:
        self.processor.lac = self.processor.lac & 0o10000 | word & 0o7777

    @property
    def link(self) -> int:
        """The link, 0 or 1."""
        return self.processor.lac >> 12

    @link.setter
    def link(self, bit: int) -> None:
        self.processor.lac = self.processor.lac & 0o7777 | (bit & 1) << 12

    @property
    def pc(self) -> int:
        """The program counter; setting it makes the next cycle a FETCH."""
        return self.processor.pc

    @pc.setter
    def pc(self, address: int) -> None:
        self.processor.pc = address & 0o7777
        self.processor.next = FETCH

    @property
    def ma(self) -> int:
        """The memory address of the last cycle."""
        return self.processor.ma

    @ma.setter
    def ma(self, address: int) -> None:
        self.processor.ma = address & 0o7777

    @property
    def mb(self) -> int:
        """The memory buffer: the word the last cycle read or wrote."""
        return self.processor.mb

    @mb.setter
    def mb(self, word: int) -> None:
        self.processor.mb = word & 0o7777

    @property
    def ir(self) -> int:
        """The instruction register: the op code, 0 to 7."""
        return self.processor.ir

    @ir.setter
    def ir(self, code: int) -> None:
        self.processor.ir = code & 7

    @property
    def sr(self) -> int:
        """The switch register."""
        return self.processor.sr

    @sr.setter
    def sr(self, word: int) -> None:
        self.processor.sr = word & 0o7777

    @property
    def ion(self) -> int:
        """The ION lamp."""
        return self.processor.ion

    @ion.setter
    def ion(self, on: int) -> None:
        self.processor.ion = self.processor.ion_delayed = 1 if on else 0

    @property
    def ticks(self) -> int:
        """Machine time since START in ticks of 0.05 us."""
        return self.processor.clock - self.processor.started

    @property
    def elapsed(self) -> float:
        """Machine time since START in seconds."""
        return self.ticks / TICKS_PER_SECOND

    @property
    def instructions(self) -> int:
        """Instructions fetched since power-up."""
        return self.processor.instructions
