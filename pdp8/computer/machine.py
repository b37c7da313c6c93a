"""The whole PDP-8/L: the one place that knows every part and wires it, and runs it.

    switches, keys, lamps: panel ── processor ◄─► core
                                        │
                                       bus ── 03 receiver ◄─ reader, keyboard   ┐ Teletype
                                        ├──── 04 transmitter ─► printer, punch  ┘
                                        ├──── 01 high-speed reader              ┐ HighSpeed
                                        ├──── 02 high-speed punch               ┘
                                        └──── ...                                 devices.py has all

The machine is a discrete-event simulation: nothing here sleeps, and the same core and tapes give the same
tapes and the same times. While a program only waits, time jumps (see waiting.py).
"""

from array import array
from collections.abc import Callable, Iterable, Iterator, Mapping
from contextlib import contextmanager
from time import monotonic
from typing import TYPE_CHECKING, Protocol

from pal.isa import BREAK, FETCH, halts
from pdp8.computer.hardware.bus import Bus, Peripheral
from pdp8.computer.hardware.core import WORD, Core, allowed
from pdp8.computer.hardware.extension import FIELD
from pdp8.computer.hardware.fields import Field, Part, Values, all_fields, put, take
from pdp8.computer.hardware.highspeed import HighSpeed
from pdp8.computer.hardware.panel import Panel
from pdp8.computer.hardware.processor import Processor
from pdp8.computer.hardware.signals import INTERRUPT, NEVER, TICKS_PER_SECOND
from pdp8.computer.hardware.teletype import Teletype
from pdp8.computer.speed.engine import Engine
from pdp8.computer.speed.waiting import Waiting
from pdp8.computer.stop import Reason, Stop
from pdp8.computer.watch import Observer, Watch
from tapes.errors import WorkError

if TYPE_CHECKING:
    from pdp8.computer.count import Count

_LONGEST = 1e9
"""Seconds, 31 years: more is no limit."""
_FIRST = 1.0
"""Seconds of machine time in the first slice of a run; each one that took less than _SOON of ours is followed
by a longer one, each other by a shorter one.
"""
_SOON = 0.05
_WAITS = (Reason.TAPE_OUT, Reason.IDLE)
_UNINTERRUPTED = 60 * TICKS_PER_SECOND
"""After so much machine time Python may take a signal; compiled code takes none by itself."""


class LoadError(WorkError):
    """Words that lie outside core, or a tape that did not load."""


class Recorder(Protocol):
    """Is called when a run begins and ends."""

    def begins(self) -> None:
        """Called when a run begins."""

    def ended(self, reason: Reason, in_cycles: bool) -> None:
        """Called when a run has ended; `in_cycles` says whether it ran memory cycles."""


def _ticks(seconds: float) -> int:
    """Return `seconds` in ticks. Raises ValueError for a negative time and for NaN."""
    if not seconds >= 0:
        raise ValueError(f"a time of {float(seconds)} seconds: 0 or more is allowed")
    return round(min(seconds, _LONGEST) * TICKS_PER_SECOND)


class Machine:
    """A PDP-8/L just switched on, with `memory` words of core, `devices` (by default an ASR-33), each in
    front of those before, and above 4K the memory extension MC8/L.
    """

    def __init__(self, devices: Iterable[Peripheral] | None = None, memory: int = FIELD) -> None:
        self.bus = Bus()
        self.devices: list[Peripheral] = []
        """What is fitted."""
        self.teletype = Teletype()
        self.highspeed = HighSpeed()
        """`teletype` and `highspeed` are always there; those among the devices replace them."""
        for device in [self.teletype] if devices is None else devices:
            self._connect(device)
        self.processor = Processor(self.bus, memory)
        self.waiting = Waiting(self.processor)
        self.engine = Engine(self.processor, self.waiting)
        self.core = Core(self.processor)
        self.panel = Panel(self.processor, self.run)
        self.watch = Watch()
        self.recorder: Recorder | None = None
        """Who records what happens, so that it can be undone."""
        self._watched: tuple[frozenset[int], ...] = (frozenset(), frozenset(), frozenset())
        """The breakpoints, and the words watched for writes and reads, that are known to be addresses."""
        self._marks = b""
        """The watched breakpoints, as Waiting has them."""
        self._observer: Observer | None = None
        """The observer of the last run."""
        self.power_up()

    def __repr__(self) -> str:
        p = self.processor
        stands = "running" if p.run else "stopped"
        return f"<Machine at {self.pc:04o}: L {self.link} AC {self.ac:04o}, {stands}, {self.elapsed:.6f} s>"

    def __reduce__(self) -> tuple[Callable[..., "Machine"], tuple[list[type[Peripheral]], int, Values]]:
        """Copy by the state: breakpoints, observers and `on_frame` stay with the original."""
        return _copied, ([type(device) for device in self.devices], self.memory, self.values())

    def fit(self, device: Peripheral) -> None:
        """Fit a device in front of the others. Raises ValueError for an impossible or used code."""
        self._connect(device)
        self.waiting.left.forget()

    def _connect(self, device: Peripheral) -> None:
        device.connect(self.bus)
        self.devices.append(device)
        if isinstance(device, Teletype) and device.CODE == Teletype.CODE:
            self.teletype = device
        elif isinstance(device, HighSpeed):
            self.highspeed = device

    def power_up(self) -> None:
        """Do what the power switch does: INITIALIZE, and stand still."""
        self.processor.initialize()
        self.processor.run = 0

    def load(self, words: Mapping[int, int] | Iterable[tuple[int, int]]) -> None:
        """Put {address: word} into core. Raises LoadError, and loads nothing, if one is out of range."""
        if isinstance(words, (str, bytes)):
            raise LoadError(
                "a name or a tape: load(pdp8.assemble(pdp8.tape(NAME))) loads a source, "
                "load(pdp8.binary.decode(pdp8.tape(NAME)).words) a BIN tape"
            )
        words = dict(words)
        for address, word in words.items():
            if not 0 <= address < self.memory:
                size, last = self.memory // 1024, self.memory - 1
                raise LoadError(f"address {address:05o}: a PDP-8/L with {size}K of core ends at {last:05o}")
            if not 0 <= word <= WORD:
                raise LoadError(f"{address:04o}: {word:o} (octal) is no word; 0000 to 7777 are")
        for address, word in words.items():
            self.core[address] = word

    def start(self, address: int | None = None) -> None:
        """Press STOP, LOAD ADD with `address` if one is given, and START; switches stay, time starts at 0."""
        self.panel.stop()
        if address is not None:
            self.panel.load_address(address)
        self.panel.start()

    @property
    def memory(self) -> int:
        """The words of core."""
        return self.processor.extension.size

    def stop(self) -> None:
        """Press STOP: the instruction ends, and the run with it."""
        self.panel.stop()

    def wait(self, seconds: float) -> None:
        """Let time pass with the processor stopped. Raises ValueError for a time below 0 or NaN."""
        ticks = _ticks(seconds)
        if ticks == 0:
            return
        self.bus.advance(self.processor.clock)
        self.processor.clock += ticks
        self.bus.advance(self.processor.clock)

    def run(
        self, seconds: float | None = None, instructions: int | None = None, cycles: int | None = None
    ) -> Stop:
        """Press CONT and run until the program stops or waits for ever, for `seconds`, `instructions`, or
        only `cycles`, which ignore breakpoints; return why. Raises ValueError for a negative limit or NaN.
        """
        p = self.processor
        for limit, what in ((instructions, "instructions"), (cycles, "cycles")):
            if limit is not None and limit < 0:
                raise ValueError(f"a limit of {limit} {what}: 0 or more is allowed")
        if p.sing_step and cycles != 0:
            cycles = 1
        until = NEVER if seconds is None else min(NEVER, p.clock + _ticks(seconds))
        last = NEVER if instructions is None else min(NEVER, p.instructions + instructions)
        goes = p.clock < until and p.instructions < last and cycles != 0
        if goes:
            self._take_breakpoints()
        if self.recorder is not None:
            self.recorder.begins()
        reason = self._continue(until, last, cycles) if goes else Reason.LIMIT
        if self.recorder is not None:
            self.recorder.ended(reason, cycles is not None)
        return Stop(reason, self.pc, self.elapsed)

    def _continue(self, until: int, last: int, cycles: int | None) -> Reason:
        """Press CONT until a tick, an instruction or so many cycles; return why the run ended."""
        p = self.processor
        p.run = 1
        self.bus.advance(p.clock)
        if not self.waiting.left.holds(p):
            self.waiting.forget()
        if cycles is not None:
            reason = self._cycles(cycles)
        elif self.watch.each_cycle():
            reason = self._run_watched(until, last)
        else:
            reason = self._run(until, last)
        self.waiting.left.note(p)
        self.bus.advance(p.clock)
        if not p.run and reason is Reason.LIMIT:  # STOP was pressed as a frame was seen just now
            reason = self.why_stopped()
        if reason is not Reason.LIMIT:
            self.bus.finish()
            self.waiting.left.forget()
        return reason

    @contextmanager
    def count(self) -> Iterator["Count"]:
        """Count what is executed inside `with machine.count() as count:`, at lower speed."""
        from pdp8.computer.count import Count

        count = Count()
        before, self.watch.observer = self.watch.observer, count
        try:
            yield count
        finally:
            self.watch.observer = before

    def parts(self) -> list[tuple[str, Part]]:
        """Return what has a state, each with its path; parts within these are in their fields."""
        p, bus, waiting = self.processor, self.bus, self.waiting
        extension: list[tuple[str, Part]] = [("extension", p.extension)] if self.memory > FIELD else []
        devices = [(f"devices {device.code:02o}", device) for device in bus]
        return [("processor", p), ("bus", bus), ("waiting", waiting), *extension, *devices]

    def fields(self) -> list[Field]:
        """Return the fields of all parts (see fields.py)."""
        return all_fields(self.parts())

    def values(self, fields: list[Field] | None = None) -> Values:
        """Return the state as values: `fields`, by default this machine's, and core."""
        return {"core": self.processor.core.tobytes(), **take(fields or self.fields())}

    def put(self, values: Values) -> None:
        """Set the machine to `values` of its own or of another, all or some; further core stays as it is."""
        if "core" in values:
            self.processor.fill(array("H", values["core"])[: self.memory])
        put(self.fields(), values)
        self._observer = None  # it did not see how the machine came here

    def slices(
        self,
        seconds: float | None = None,
        shortest: float = 0.05,
        longest: float = 60.0,
        through_waits: bool = False,
    ) -> Iterator[Stop]:
        """Run as `run` does, in slices of about a twentieth of a real second; yield the state after each, so
        that the caller can press keys or stop. With `through_waits` an endless wait does not end the run.
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
            slice_ = min(2 * slice_ if soon else max(slice_ / 2, shortest), longest)
            yield stop
            if ended and not (through_waits and stop.reason in _WAITS and self.ticks < last):
                return
            if not self.processor.run:
                self.bus.finish()
                yield Stop(Reason.STOP_KEY, self.pc, self.elapsed)
                return

    def _take_breakpoints(self) -> None:
        """Let no turn of a loop be skipped that has a breakpoint, touches a watched word or is unseen."""
        watch, waiting = self.watch, self.waiting
        if not watch.again:
            self._check_watched()
            if watch.writes or watch.reads or self.pc in watch.breakpoints:
                waiting.forget()
            if self._marks != waiting.marks or watch.observer is not self._observer:
                waiting.forget()
                waiting.marks, self._observer = self._marks, watch.observer
        waiting.turn_first = watch.each_cycle() or len(waiting.marks) > 0

    def _check_watched(self) -> None:
        """Raise ValueError for a breakpoint or a word to be watched that is no address."""
        watch = self.watch
        watched = frozenset(watch.breakpoints), frozenset(watch.writes), frozenset(watch.reads)
        if watched == self._watched:
            return
        last = self.memory - 1
        for places in watched:
            for place in places:
                if not (isinstance(place, int) and 0 <= place <= last):
                    allowed(place, "a breakpoint", last)
        self._watched = watched
        parts = (6, 0) if self.memory == FIELD else (12, 6, 0)
        self._marks = bytes([address >> part & 0o77 for address in sorted(watched[0]) for part in parts])

    def _run(self, until: int, last: int) -> Reason:
        """Run the engine, which watches only breakpoints."""
        p, breakpoints = self.processor, self.watch.breakpoints
        while not self.engine.run(min(until, p.clock + _UNINTERRUPTED), last, breakpoints):
            if self.waiting.endless:
                return self._endless()
            if not p.run:
                return self.why_stopped()
            if p.clock >= until or p.instructions >= last:
                return Reason.LIMIT
            if self.pc in breakpoints:
                break
        return Reason.BREAKPOINT

    def _run_watched(self, until: int, last: int) -> Reason:
        """Run as `_run` does, instruction by instruction, the watch looking at each cycle."""
        p, watch, waiting = self.processor, self.watch, self.waiting
        waiting.endless = False
        first = True
        while p.clock < until and p.instructions < last:
            if self.pc in watch.breakpoints and not first and p.state != BREAK:
                return Reason.BREAKPOINT
            first = False
            watch.instruction(p)
            if not p.run:
                return self.why_stopped()
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

    def _cycles(self, count: int) -> Reason:
        """Run so many cycles, the watch looking at each; return why it ended."""
        p = self.processor
        while count and p.run:
            self.watch.cycle(p)
            count -= 1
        if p.run:
            return Reason.LIMIT
        return self.why_stopped() if not p.sing_step or p.protect else Reason.STOP_KEY

    def why_stopped(self) -> Reason:
        """Return why RUN went off."""
        p = self.processor
        if p.protect:
            return Reason.PROTECT
        return Reason.HALT if p.state == FETCH and halts(p.mb) else Reason.STOP_KEY

    def _out_of_tape(self) -> bool:
        """Tell whether the loop that the program is in waits for a reader whose tape has run out."""
        p = self.processor
        return any(device.out_of_tape() and (p.ion or device.tested) for device in self.bus)

    @property
    def ac(self) -> int:
        """The accumulator."""
        return self.processor.lac & 0o7777

    @ac.setter
    def ac(self, word: int) -> None:
        self.processor.lac = self.processor.lac & 0o10000 | allowed(word, "AC")

    @property
    def link(self) -> int:
        """The link, 0 or 1."""
        return self.processor.lac >> 12

    @link.setter
    def link(self, bit: int) -> None:
        self.processor.lac = self.processor.lac & 0o7777 | allowed(bit, "the link", 1) << 12

    @property
    def pc(self) -> int:
        """The program counter below the instruction field; setting it makes the next cycle a FETCH."""
        return self.processor.extension.inst_field | self.processor.pc

    @pc.setter
    def pc(self, address: int) -> None:
        p = self.processor
        allowed(address, "PC", self.memory - 1)
        if p.next > INTERRUPT:
            p.preset()
        p.pc = address & 0o7777
        p.next = FETCH
        p.extension.inst_field = p.extension.inst_buffer = address & 0o70000

    @property
    def ma(self) -> int:
        """The memory address of the last cycle, with its field in front of it."""
        return self.processor.extension.field | self.processor.ma

    @ma.setter
    def ma(self, address: int) -> None:
        allowed(address, "MA", self.memory - 1)
        self.processor.ma = address & 0o7777
        self.processor.extension.field = address & 0o70000

    @property
    def mb(self) -> int:
        """The memory buffer: the word the last cycle read or wrote."""
        return self.processor.mb

    @mb.setter
    def mb(self, word: int) -> None:
        self.processor.mb = allowed(word, "MB")

    @property
    def ir(self) -> int:
        """The instruction register: the op code, 0 to 7."""
        return self.processor.ir

    @ir.setter
    def ir(self, code: int) -> None:
        self.processor.ir = allowed(code, "IR", 7)

    @property
    def sr(self) -> int:
        """The switch register."""
        return self.processor.sr

    @sr.setter
    def sr(self, word: int) -> None:
        self.panel.sr = word

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


def _copied(devices: Iterable[type[Peripheral]], memory: int, values: Values) -> Machine:
    """Return a machine with a device of each class, and with `values`."""
    machine = Machine([made() for made in devices], memory)
    machine.put(values)
    return machine
