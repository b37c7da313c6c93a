"""The operator's time at the machine: what happens while so many seconds pass in the room.

    room's clock ── speed ──► machine.run ──► lamps, each as bright as its share of the time
                        └──► hands at the switches: the RIM loader, a key every tenth of a second

The machine stays what it is: everything here is done with its panel's keys, its reader, its punch and its
keyboard. At speed 1 the room's second is the machine's; where Python is slower than that, the machine's time
falls behind and nothing is left out.

While the processor is stopped the Teletype finishes what it has begun, in the room's own time.
"""

from collections.abc import Callable, Iterator
from random import randrange
from time import perf_counter
from typing import NamedTuple

from pal.isa import STATES
from pdp8.computer.hardware.panel import Lamps, shares
from pdp8.computer.hardware.signals import NEVER
from pdp8.computer.machine import Machine
from pdp8.computer.past import rewind
from pdp8.computer.past.history import History
from pdp8.computer.stop import Reason, Stop
from pdp8.computer.use.ending import ended, told
from pdp8.computer.use.operator import DEAD, RIM, RIM_START, Operator
from pdp8.computer.use.trace import Listing
from pdp8.computer.watch import instruction_at
from tapes import codes

SPEEDS = (1, 10, 100, 1000)
KEY_SECONDS = 0.1
"""What a key takes: its contacts are given a tenth of a second to come to rest."""

_SAMPLES = 8
_BUDGET = 0.030  # seconds of ours for one turn, so that the room stays awake
_SHORTEST = 1e-4


class Tape(NamedTuple):
    """A tape at hand, and what is written on its leader."""

    name: str
    frames: bytes


class Session:
    """One operator at one machine, with `tapes` at hand."""

    def __init__(
        self, machine: Machine, tapes: list[Tape] | None = None, clock: Callable[[], float] = perf_counter
    ) -> None:
        self.machine = machine
        self.operator = Operator(machine)
        self.history = History(machine)
        """What can be undone."""
        self.tapes = tapes or []
        self.speed = 1
        self.behind = False
        """Whether the machine could not keep the speed in the last turn."""
        self.said = "standing still"
        """What became of the machine, in words."""
        self.hand = 0
        """Which switch of the switch register the hand is at, 0 the leftmost."""
        self.listing = Listing()
        """The listing of the program in core."""
        self._explained_at = -1
        """Where the program waits, if that was explained already, else -1."""
        self._names: dict[bytes, str] = {}
        """The names of the tapes that were mounted, by what the reader has of them."""
        self._clock = clock
        self._slice = _SHORTEST
        self._hands: Iterator[None] | None = None
        self._rest = 0.0
        self._look()

    def advance(self, seconds: float) -> None:
        """Let `seconds` pass in the room."""
        self._work(seconds)
        self.behind = False
        samples: list[Lamps] = []
        if self.machine.panel.lamps.run:
            self._run(seconds * self.speed, samples)
        elif self.machine.bus.next_event(self.machine.processor.clock) != NEVER:
            self.machine.wait(seconds)
        self._look(samples)

    def _run(self, seconds: float, samples: list[Lamps]) -> None:
        machine, began = self.machine, self._clock()
        until = machine.elapsed + seconds
        while machine.elapsed < until:
            before = self._clock()
            if before - began > _BUDGET:
                self.behind = True
                return
            step = min(self._slice, until - machine.elapsed, seconds / _SAMPLES)
            stop = machine.run(seconds=max(step, 1e-6))
            samples.append(machine.panel.lamps)
            if stop.reason != "limit":
                self.said = self._ended(stop)
                break
            self.said = "running"
            self._explained_at = -1
            took = self._clock() - before  # slices are to take some milliseconds each
            if took < _BUDGET / 10:
                self._slice *= 2
            elif took > _BUDGET / 4:
                self._slice = max(self._slice / 2, _SHORTEST)

    def _ended(self, stop: Stop) -> str:
        """Return how a run ended, and why where something is wrong."""
        if stop.pc == self._explained_at and stop.reason in ("idle", "tape out"):
            return self.said
        self._explained_at = stop.pc
        return told(stop, self.history, self.listing)[1]

    def _look(self, samples: list[Lamps] | None = None) -> None:
        """Read the lamps: exact when the machine is stopped, else their average brightness."""
        lamps = self.machine.panel.lamps
        self.brightness = shares(samples if samples and lamps.run else [lamps])
        """How bright each lamp is, 0 to 1, most significant first."""

    @property
    def reader_tape(self) -> str:
        """The name of the tape in the reader, also after time ran back, or ""."""
        return self._names.get(self.machine.teletype.reader.tape, "")

    @property
    def address(self) -> int:
        """Where the instruction is that is under way, or the next one."""
        return instruction_at(self.machine.processor)

    def press(self, key: str) -> None:
        """Press a momentary key, named as the Panel's method is: load_add, start, cont, stop, exam, dep."""
        panel = self.machine.panel
        self._hands = None
        self.operator.press(key)
        self._explained_at = -1
        if key == "stop":
            self.said = f"stopped before {self.machine.pc:04o}"
        elif key in ("start", "cont") and panel.lamps.run:
            self.said = "running"
        elif panel.lamps.run:
            self.said = DEAD
        elif panel.lamps.protect:
            self.said = ended(Stop(Reason.PROTECT, self.machine.pc, 0.0), self.machine)
        elif key in ("start", "cont"):
            self.said = f"one cycle: {STATES[self.machine.processor.state]}"
        else:
            self.said = f"{self.machine.ma:04o} holds {self.machine.mb:04o}"
        self._look()

    def back(self, seconds: float = 0) -> None:
        """Undo one instruction, or that much machine time, or all there is; the machine is stopped then."""
        self._hands = None
        if seconds:
            rewind.seconds(self.history, min(seconds, self.history.seconds))
        else:
            rewind.instructions(self.history, min(1, self.history.instructions))
        self.machine.panel.stop()
        self.said = f"back before {self.machine.pc:04o}"
        self._look()

    def throw(self, bit: int) -> None:
        """Throw switch `bit` of the switch register, 0 the leftmost."""
        self.machine.sr ^= 0o4000 >> bit

    def lock(self, switch: str) -> None:
        """Throw a locking switch, as Panel calls it, between two instructions."""
        panel = self.machine.panel
        if switch == "sing_step" and panel.lamps.run:
            self.machine.run(cycles=randrange(3))
        setattr(panel, switch, not getattr(panel, switch))

    def dial(self, digit: int) -> None:
        """Shift one octal `digit` into the switches from the right."""
        self.machine.sr = (self.machine.sr << 3 | digit) & 0o7777

    def toggle_rim(self) -> None:
        """Begin to toggle in the RIM loader, a key every tenth of a second."""
        if self.machine.panel.lamps.run:
            self.said = "the machine runs: press STOP first"
        else:
            self._hands = self._rim()
            self._rest = KEY_SECONDS

    def _rim(self) -> Iterator[None]:
        for _ in self.operator.toggle(RIM_START, RIM):
            self.said = f"toggling RIM in: {self.machine.mb:04o} into {self.machine.ma:04o}"
            yield
        refused = self.machine.panel.lamps.protect
        self.said = "MEM PROT is up: RIM did not go in" if refused else "the RIM loader is in core"

    def _work(self, seconds: float) -> None:
        """Press the keys that fit into `seconds`."""
        self._rest += seconds
        while self._hands is not None and self._rest >= KEY_SECONDS:
            self._rest -= KEY_SECONDS
            if next(self._hands, self) is self:
                self._hands = None

    def mount(self, tape: Tape) -> None:
        """Put a tape into the reader, as Operator.mount does, and warn if ASCII programs cannot read it."""
        if doubt := codes.recognise(tape.frames).doubt(tape.frames):
            self.said = f"{tape.name} {doubt}"
        self.operator.mount(tape.name, tape.frames)
        self._names[self.machine.teletype.reader.tape] = tape.name

    def tear_off(self, name: str) -> Tape:
        """Tear off what was punched; it lies with the other tapes then, called `name`."""
        punch = self.machine.teletype.punch
        tape = Tape(name, punch.tape)
        punch.frames.clear()
        self.lay(tape)
        return tape

    def lay(self, tape: Tape) -> None:
        """Lay a tape with the others, in place of one of its name."""
        self.tapes = [other for other in self.tapes if other.name != tape.name] + [tape]

    def clear(self, tapes: list[Tape]) -> None:
        """Forget messages and planned actions, with `tapes` at hand: the next operator comes."""
        self._hands = None
        self.operator = Operator(self.machine)
        self.tapes = [*tapes]
        self.speed = 1
        self.hand = 0
        self.said = "standing still"
        self._look()

    def change_speed(self) -> None:
        self.speed = SPEEDS[(SPEEDS.index(self.speed) + 1) % len(SPEEDS)]
