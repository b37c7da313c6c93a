"""One afternoon of 1971, done again: from a part program to a milled part.

    terminal ──► RIM toggled ──► BIN loaded ──► eia.pal loaded ──► translation ──► Hydra-Point ──► Talyrond
    ASCII tape      switches      RIM tape         BIN tape          EIA tape         path         deviations

Times of the terminal, the Teletype, the processor and the Hydra-Point are the machines' own. What a man takes
to carry a tape, mount it or set switches is nowhere recorded; those seconds are ours (see PACE and the
constants here) and stand apart from the figures that are compared with the thesis.

Not emulated: the GE time-sharing service's own delays, the telephone line, a misread switch.
"""

from collections.abc import Callable
from dataclasses import dataclass
from enum import StrEnum
from time import perf_counter
from typing import Final

import nc
import pal
from nc.curves import nominal
from nc.inspection import Inspection, inspect
from pdp8.computer.hardware.signals import TICKS_PER_SECOND
from pdp8.computer.machine import Machine
from pdp8.computer.use.operator import Action, Operator, Pace
from programs.parts import find
from tapes import ascii, frames, rim, shelf
from tapes.errors import WorkError
from tapes.measure import inches

OPENS: Final = 13 * 3600
"""The afternoon begins at one o'clock: seconds since midnight."""

PACE: Final = Pace(setting=4, pressing=1, mounting=20, lever=0.25)
"""The operator's: five seconds to set the twelve switches and press a key, and one hand on the reader's lever
while the other presses START. Ours, not the thesis's."""

WALK_SECONDS, CLAMP_SECONDS, MEASURE_SECONDS = 60, 180, 120
"""To the next room; a plate onto the table; one turn of the Talyrond. Ours."""

FRAMES_PER_SECOND = 10


def clock(tick: int) -> str:
    """Return the time of day at a tick of the afternoon: "1:29:58 pm"."""
    minutes, seconds = divmod(OPENS + tick // TICKS_PER_SECOND, 60)
    hours, minutes = divmod(minutes, 60)
    half = "am" if hours % 24 < 12 else "pm"
    return f"{(hours + 11) % 12 + 1}:{minutes:02}:{seconds:02} {half}"


class Kind(StrEnum):
    """What an act is about."""

    TERMINAL = "terminal"
    TOGGLE = "toggle"
    LOAD = "load"
    TRANSLATE = "translate"
    MILL = "mill"
    INSPECT = "inspect"


@dataclass(frozen=True)
class Act:
    """A part of the afternoon, in ticks since it began.

    `program` is the one that runs in the PDP-8/L, or ""; `outcome` is its result; `real` is in seconds of
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


@dataclass(frozen=True)
class Afternoon:
    """Everything the afternoon left.

    `tapes` are {name: frames}; `programs` {name: assembly}; `minutes` what the thesis timed: punch, translate
    and cut. `path` began at tick `mill_starts`. `inspection` is None where the part follows no curve that
    could be inspected.
    """

    part: str
    text: str
    acts: tuple[Act, ...]
    actions: tuple[Action, ...]
    tapes: dict[str, bytes]
    programs: dict[str, pal.Assembly]
    path: nc.Path
    mill_starts: int
    inspection: Inspection | None
    minutes: dict[str, float]


def replay(part: str, tell: Callable[[Act], object] = lambda act: None) -> Afternoon:
    """Do the whole afternoon for the part program `part`; `tell` hears of every act as it is done.

    Raises WorkError, naming its place, where something goes wrong, as it would have in 1971.
    """
    return _Day(part, tell).through()


class _Day:
    """The afternoon while it happens."""

    def __init__(self, part: str, tell: Callable[[Act], object]) -> None:
        self.part = part
        self.entry = find(part)
        self.tell = tell
        self.machine = Machine()
        self.actions: list[Action] = []
        self.operator = Operator(self.machine, PACE, self.actions.append)
        self.acts: list[Act] = []
        self.tapes: dict[str, bytes] = {}
        self.programs: dict[str, pal.Assembly] = {}
        self.minutes: dict[str, float] = {}
        self.began = perf_counter()

    def through(self) -> Afternoon:
        self._punch()
        self._toggle()
        self._load_bin()
        self._load_program()
        self._translate()
        path, mill_starts = self._mill()
        inspection = self._inspect(path)
        return Afternoon(
            self.part,
            self.text,
            tuple(self.acts),
            tuple(self.actions),
            self.tapes,
            self.programs,
            path,
            mill_starts,
            inspection,
            self.minutes,
        )

    @property
    def now(self) -> int:
        """Ticks of 0.05 µs since the machine was switched on."""
        return self.machine.processor.clock

    def _elapsed(self, key: str) -> float:
        """Return the seconds since the last action with `key`."""
        at = next(action.at for action in reversed(self.actions) if action.key == key)
        return (self.now - at) / TICKS_PER_SECOND

    def _act(self, kind: Kind, name: str, say: str, outcome: str, program: str = "") -> None:
        """Write down the act that has just ended."""
        starts = self.acts[-1].ends if self.acts else 0
        act = Act(kind, name, program, say, starts, self.now, outcome, perf_counter() - self.began)
        self.acts.append(act)
        self.tell(act)
        self.began = perf_counter()

    def _punch(self) -> None:
        self.text = self.entry.program()()
        tape = self.tapes[f"{self.part}.asc"] = ascii.encode(self.text)
        self.operator.wait(len(tape) / FRAMES_PER_SECOND)
        self.minutes["punch"] = len(tape) / FRAMES_PER_SECOND / 60
        lines = self.text.count("\n")
        self._act(
            Kind.TERMINAL,
            "FORTRAN",
            f"The part program runs in Toronto; the terminal types and punches its {lines} blocks.",
            f"{lines} lines, {len(tape):,} frames",
        )

    def _toggle(self) -> None:
        self.operator.wait(WALK_SECONDS)
        assembly = self._assemble("rim.pal")
        for _ in self.operator.toggle(min(assembly.words), list(assembly.words.values())):
            pass
        self._act(
            Kind.TOGGLE,
            "RIM toggled in",
            f"The core is empty. The RIM loader goes in by the switches, {len(assembly.words)} words.",
            f"{len(assembly.words)} words at {min(assembly.words):04o}",
            "rim.pal",
        )

    def _load_bin(self) -> None:
        assembly = self._assemble("bin.pal")
        self._mount("bin.rim", rim.encode(assembly.words))
        stop = self.operator.start(min(self.programs["rim.pal"].words))
        self._expect(stop.reason == "tape out", f"RIM stopped at {stop.pc:04o}: {stop.reason}")
        self.operator.stop()
        self._act(
            Kind.LOAD,
            "BIN loaded",
            "RIM reads the BIN loader into the last page of core, ten frames a second.",
            f"{len(assembly.words)} words",
            "rim.pal",
        )

    def _load_program(self) -> None:
        assembly = self._assemble("eia.pal")
        self._mount("eia.bin", assembly.tape[frames.leader_start(assembly.tape) or 0 :])
        stop = self.operator.start(0o7777)
        self._expect(stop.reason == "halt", f"BIN stopped at {stop.pc:04o}: {stop.reason}")
        ac = self.machine.ac
        self._expect(ac == 0, f"BIN halted with AC {ac:04o}: the checksum of eia.bin is wrong")
        self._act(
            Kind.LOAD,
            "eia.pal loaded",
            "BIN reads the translation program and halts with AC 0000: the checksum is right.",
            f"{len(assembly.words)} words, checksum right",
            "bin.pal",
        )

    def _translate(self) -> None:
        name = f"{self.part}.asc"
        self._mount(name, self.tapes[name])
        punched = len(self.machine.teletype.punch.tape)
        stop = self.operator.start(0o200)
        self._expect(stop.reason == "tape out", f"eia.pal stopped at {stop.pc:04o}: {stop.reason}")
        self.minutes["translate"] = self._elapsed("lever") / 60
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

    def _mill(self) -> tuple[nc.Path, int]:
        path = nc.cut(self.tapes[f"{self.part}.eia"])
        times = path.times
        self.operator.wait(WALK_SECONDS + CLAMP_SECONDS)
        mill_starts = self.now
        self.operator.wait(times.total)
        self.minutes["cut"] = times.total / 60
        self._act(
            Kind.MILL,
            "Hydra-Point",
            "The Hydra-Point reads a block in two seconds, moves, and reads the next.",
            f"{len(path)} blocks, {times.reading / 60:.1f} min reading, {times.milling / 60:.1f} min milling",
        )
        return path, mill_starts

    def _inspect(self, path: nc.Path) -> Inspection | None:
        self.operator.wait(MEASURE_SECONDS)
        try:
            inspection = inspect(
                path, nominal(**self.entry.nominal), self.entry.cutter * 1000, self.entry.tolerance * 1000
            )
        except WorkError as error:
            self._act(Kind.INSPECT, "Inspection", f"Not inspected: {error}.", "not inspected")
            return None
        worst = inspection.worst
        found = f"worst trough to peak {inches(worst.trough_to_peak)} in, {worst.wall} wall, {worst.place}"
        instrument = self.entry.instrument
        done = "The stylus follows the walls" if instrument else "The thesis measured no such part; computed"
        self._act(Kind.INSPECT, instrument or "Inspection", f"{done}: {found}.", found)
        return inspection

    def _assemble(self, name: str) -> pal.Assembly:
        assembly = self.programs[name] = pal.assemble(shelf.read_bundled(name), names=[name])
        self._expect(assembly.ok, f"{name}: does not assemble")
        return assembly

    def _mount(self, name: str, tape: bytes) -> None:
        self.tapes[name] = tape
        self.operator.mount(name, tape)

    def _expect(self, met: bool, otherwise: str) -> None:
        if not met:
            raise WorkError(otherwise)
