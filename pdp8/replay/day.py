"""The afternoon as a script of the operator's hands, from a part program's printout to a milled part.

    terminal ──► RIM toggled ──► BIN loaded ──► eia.pal loaded ──► translation ──► Hydra-Point ──► judged
    ASCII tape      switches      RIM tape         BIN tape          EIA tape         path

Times of the terminal, the Teletype, the processor and the Hydra-Point are the machines' own. Nobody
recorded how long it took to carry a tape, mount it or set switches: those seconds are ours (PACE and the
constants here), and no figure that is compared with the thesis has them.

Not emulated: the GE time-sharing service's own delays, the telephone line, a misread switch.
"""

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from enum import StrEnum
from functools import cached_property
from time import monotonic
from typing import Final, NamedTuple

from nc.machine import cut
from nc.path import Path
from pal.assembling import assemble
from pal.assembly import Assembly
from pdp8.computer.hardware.signals import FRAME, TICKS_PER_SECOND
from pdp8.computer.machine import Machine
from pdp8.computer.stop import Reason
from pdp8.computer.use.operator import BIN_START, RIM_START, Action, Operator, Pace
from tapes import ascii, frames, rim
from tapes.errors import WorkError

ARRANGED: Final = (
    "The thesis gives minutes for punching, translating and cutting; the others, and that it was one "
    "afternoon, are our arrangement."
)
"""The note at the beginning of an afternoon. The Talyrond was, it seems, at Mohawk College, whose
metrology facilities the thesis gives thanks for; the way there is left out."""

OPENS: Final = 13 * 3600
"""The afternoon begins at one o'clock: seconds since midnight."""

PACE: Final = Pace(setting=4, pressing=1, mounting=20, lever=0.25)
"""The operator's: five seconds to set the twelve switches and press a key, and one hand on the reader's lever
while the other presses START. Ours, not the thesis's."""

WALK_SECONDS, CLAMP_SECONDS, MEASURE_SECONDS = 60, 180, 120
"""To the next room; a plate onto the table; one turn of the Talyrond. Ours."""

PROGRAMS: Final = ("rim.pal", "bin.pal", "eia.pal")
"""The sources that are read beside the part program: two loaders and the translation."""

_SLICE: Final = 10
"""Seconds of machine time after which the caller can look at the day."""


def clock(tick: int) -> str:
    """Return the time of day at a tick of the afternoon: "1:29:58 pm"."""
    minutes, seconds = divmod(OPENS + tick // TICKS_PER_SECOND, 60)
    hours, minutes = divmod(minutes, 60)
    half = "am" if hours % 24 < 12 else "pm"
    return f"{(hours + 11) % 12 + 1}:{minutes:02}:{seconds:02} {half}"


class Kind(StrEnum):
    """The subject of an act."""

    TERMINAL = "terminal"
    TOGGLE = "toggle"
    LOAD = "load"
    TRANSLATE = "translate"
    MILL = "mill"
    INSPECT = "inspect"


class Act(NamedTuple):
    """A part of the afternoon, in ticks from its start; `program` runs in the PDP-8/L; `real` is seconds
    today.
    """

    kind: Kind
    name: str
    program: str
    say: str
    starts: int
    ends: int
    outcome: str
    real: float

    @property
    def seconds(self) -> float:
        """How long it took in 1971."""
        return (self.ends - self.starts) / TICKS_PER_SECOND


class Judgement(NamedTuple):
    """The inspection's result: the act's name, its sentence, its outcome."""

    name: str
    say: str
    outcome: str


@dataclass(frozen=True)
class Course:
    """A finished day: what the operator did when, the results, the tapes by name, the mill's first tick."""

    part: str
    acts: Sequence[Act]
    actions: Sequence[Action]
    tapes: Mapping[str, bytes]
    mill_starts: int

    @cached_property
    def path(self) -> Path:
        """What the Hydra-Point cut."""
        return cut(self.tapes[f"{self.part}.eia"])


class Day:
    """The afternoon while it happens, for the part program `part` that printed `text`.

    `sources` holds PROGRAMS, {name: source}; `judge` inspects the path that was cut; `tell` hears of every
    act as it is done. `machine` is a plain PDP-8/L if none is given.
    """

    def __init__(
        self,
        part: str,
        text: str,
        sources: Mapping[str, bytes],
        judge: Callable[[Path], Judgement],
        tell: Callable[[Act], object] = lambda act: None,
        machine: Machine | None = None,
    ) -> None:
        self.part = part
        self.text = text
        self.sources = sources
        self.judge = judge
        self.tell = tell
        self.machine = machine or Machine()
        self.actions: list[Action] = []
        self.operator = Operator(self.machine, PACE, self.actions.append)
        self.acts: list[Act] = []
        self.tapes: dict[str, bytes] = {}
        self.programs: dict[str, Assembly] = {}
        self.minutes: dict[str, float] = {}
        """What the thesis timed: punch, translate and cut."""
        self.path = Path((), 0.0, 0.0)
        self.mill_starts = 0
        self.began = monotonic()

    def through(self) -> Iterator[None]:
        """Do the whole day, yielding now and then. Raises WorkError where 1971 would have failed."""
        yield from self._punch()
        yield from self._toggle()
        yield from self._load_bin()
        yield from self._load_program()
        yield from self._translate()
        yield from self._mill()
        yield from self._inspect()

    @property
    def course(self) -> Course:
        """The day's results, from which a Script can restore any instant."""
        return Course(self.part, self.acts, self.actions, self.tapes, self.mill_starts)

    @property
    def now(self) -> int:
        """Ticks of 0.05 µs since the machine was switched on."""
        return self.machine.processor.clock

    def _act(self, kind: Kind, name: str, say: str, outcome: str, program: str = "") -> None:
        """Record the act that has just ended."""
        starts = self.acts[-1].ends if self.acts else 0
        act = Act(kind, name, program, say, starts, self.now, outcome, monotonic() - self.began)
        self.acts.append(act)
        self.tell(act)
        self.began = monotonic()

    def _wait(self, seconds: float) -> Iterator[None]:
        """Let time pass, a minute at a time."""
        while seconds > 60:
            self.operator.wait(60)
            seconds -= 60
            yield
        self.operator.wait(seconds)
        yield

    def _read(self, name: str, tape: bytes, program: str, address: int, end: Reason) -> Iterator[None]:
        """Let `program`, started at `address`, read a tape to its end."""
        self.tapes[name] = tape
        self.operator.mount(name, tape)
        self.operator.begin(address)
        stop = self.machine.run(_SLICE)
        while stop.reason is Reason.LIMIT:
            yield
            stop = self.machine.run(_SLICE)
        if stop.reason is not end:
            raise WorkError(f"{program} stopped at {stop.pc:04o}: {stop.reason}")
        yield

    def _punch(self) -> Iterator[None]:
        tape = self.tapes[f"{self.part}.asc"] = ascii.encode(self.text)
        seconds = len(tape) * FRAME / TICKS_PER_SECOND
        yield from self._wait(seconds)
        self.minutes["punch"] = seconds / 60
        lines = self.text.count("\n")
        self._act(
            Kind.TERMINAL,
            "FORTRAN",
            f"The part program runs in Toronto; the terminal types and punches its {lines} blocks.",
            f"{lines} lines, {len(tape):,} frames",
        )

    def _toggle(self) -> Iterator[None]:
        yield from self._wait(WALK_SECONDS)
        assembly = self._assemble("rim.pal")
        words = list(assembly.words.values())
        yield from self.operator.toggle(min(assembly.words), words)
        self._act(
            Kind.TOGGLE,
            "RIM toggled in",
            f"Dr. Elliott's PDP-8/L: its core is empty. RIM goes in by the switches, {len(words)} words.",
            f"{len(words)} words at {min(assembly.words):04o}",
            "rim.pal",
        )

    def _load_bin(self) -> Iterator[None]:
        assembly = self._assemble("bin.pal")
        yield from self._read("bin.rim", rim.encode(assembly.words), "RIM", RIM_START, Reason.TAPE_OUT)
        self.operator.stop()
        self._act(
            Kind.LOAD,
            "BIN loaded",
            "RIM reads the BIN loader into the last page of core, ten frames a second.",
            f"{len(assembly.words)} words",
            "rim.pal",
        )

    def _load_program(self) -> Iterator[None]:
        assembly = self._assemble("eia.pal")
        tape = assembly.tape[frames.leader_start(assembly.tape) or 0 :]
        yield from self._read("eia.bin", tape, "BIN", BIN_START, Reason.HALT)
        if self.machine.ac:
            raise WorkError(f"BIN halted with AC {self.machine.ac:04o}: the checksum of eia.bin is wrong")
        self._act(
            Kind.LOAD,
            "eia.pal loaded",
            "BIN reads the translation program and halts with AC 0000: the checksum is right.",
            f"{len(assembly.words)} words, checksum right",
            "bin.pal",
        )

    def _translate(self) -> Iterator[None]:
        name = f"{self.part}.asc"
        punched = len(self.machine.teletype.punch.tape)
        yield from self._read(name, self.tapes[name], "eia.pal", 0o200, Reason.TAPE_OUT)
        lever = self.actions[-1]
        self.minutes["translate"] = (self.now - lever.at) / TICKS_PER_SECOND / 60
        self.operator.stop()
        tape = self.machine.teletype.punch.tape[punched:]
        self.tapes[f"{self.part}.eia"] = tape
        self._act(
            Kind.TRANSLATE,
            "Translation",
            "eia.pal reads ASCII and punches EIA: a space as a zero, a carriage return as end of block.",
            f"{len(tape):,} frames, {self.machine.instructions:,} instructions",
            "eia.pal",
        )

    def _mill(self) -> Iterator[None]:
        path = self.path = cut(self.tapes[f"{self.part}.eia"])
        times = path.times
        yield from self._wait(WALK_SECONDS + CLAMP_SECONDS)
        self.mill_starts = self.now
        yield from self._wait(times.total)
        self.minutes["cut"] = times.total / 60
        self._act(
            Kind.MILL,
            "Hydra-Point",
            "The Hydra-Point reads a block in two seconds, moves, and reads the next.",
            f"{len(path)} blocks, {times.reading / 60:.1f} min reading, {times.milling / 60:.1f} min milling",
        )

    def _inspect(self) -> Iterator[None]:
        yield from self._wait(MEASURE_SECONDS)
        found = self.judge(self.path)
        self._act(Kind.INSPECT, found.name, found.say, found.outcome)

    def _assemble(self, name: str) -> Assembly:
        assembly = self.programs[name] = assemble(self.sources[name], names=[name])
        if not assembly.ok:
            raise WorkError(f"{name}: does not assemble")
        return assembly
