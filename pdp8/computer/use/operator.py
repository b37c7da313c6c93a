"""The operator at the panel: sets switches, presses keys, puts tapes in, each at a pace.

    panel ──17 words──► RIM loader, 7756-7776
    BIN loader's tape, RIM format ──► RIM loader ──► 7622-7755, 7777
    program's tape, BIN format ──► BIN loader ──► core, checksum in AC

`boot` is a morning's work: MEM PROT down, field switches at 0, each tape on its leader, SR and LOAD ADD as
the books say, CONT for each further section of a tape, STOP when RIM's tape has run through.

INITIALIZE sets READER RUN: a tape put in with the lever at START would move at once, and START would drop the
frame on its way. So a tape goes in with the lever at STOP, and START or CONT throws the lever too, unless a
hand has put it there.

Sources: PDP-8/I instruction card (the RIM loader's words); Small Computer Handbook 1970, "Loading programs".
"""

from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import NamedTuple

from pdp8.computer.hardware.signals import FRAME, NEVER, TICKS_PER_SECOND
from pdp8.computer.machine import LoadError, Machine
from pdp8.computer.stop import Reason, Stop
from tapes import binary, codes, rim
from tapes.errors import TapeError
from tapes.frames import BLANK, LEADER
from tapes.quantities import counted, duration

RIM_START = 0o7756
BIN_START = 0o7777
BIN_HALT = 0o7700
TELETYPE_READER = 0o7777

# The card's two versions; they differ in the reader's IOTs and in where the loop begins.
RIM = (
    *(0o6032, 0o6031, 0o5357, 0o6036, 0o7106, 0o7006, 0o7510, 0o5357),
    *(0o7006, 0o6031, 0o5367, 0o6034, 0o7420, 0o3776, 0o3376, 0o5356, 0o0000),
)
RIM_HIGH_SPEED = (
    *(0o6014, 0o6011, 0o5357, 0o6016, 0o7106, 0o7006, 0o7510, 0o5374),
    *(0o7006, 0o6011, 0o5367, 0o6016, 0o7420, 0o3776, 0o3376, 0o5357, 0o0000),
)

_SLOWER = (
    "; a slower loader can run as a program, without a limit: "
    "pdp8 run LOADER --start 7777 --sr 7777 --reader TAPE --save FILE"
)


class Pace(NamedTuple):
    """Seconds that an operator takes for switches, a key, a tape, and from the START key to the lever."""

    setting: float = 0.0
    pressing: float = 0.0
    mounting: float = 0.0
    lever: float = 0.0


IN_NO_TIME = Pace()
DEAD = "the machine runs: all keys but STOP are dead"


class Action(NamedTuple):
    """One action: its tick, object, word or tape, and a sentence."""

    at: int
    key: str
    value: int | str | None = None
    say: str = ""


class Loading(NamedTuple):
    """One step of booting: keys pressed, or a tape's `frames`, `sections`, `words` and `seconds`; `missing`
    words of the tape are not in core.
    """

    what: str
    keys: int
    frames: int = 0
    sections: int = 0
    words: int = 0
    seconds: float = 0.0
    missing: int = 0

    def __str__(self) -> str:
        if not self.frames:
            return f"{self.what}: {self.keys} keys"
        counts = [counted(self.frames, "frames")]
        if self.sections > 1:
            counts.append(counted(self.sections, "sections"))
        counts.append(counted(self.words, "words"))
        if self.missing:
            counts.append(f"{self.missing:,} more not in core")
        return f"{self.what}: {', '.join(counts)}; {duration(self.seconds)}"


class Operator:
    """An operator at `machine`. `note` is called with each action as it is done."""

    def __init__(
        self,
        machine: Machine,
        pace: Pace = IN_NO_TIME,
        note: Callable[[Action], object] = lambda action: None,
    ) -> None:
        self.machine = machine
        self.panel = machine.panel
        self.reader = machine.teletype.reader
        self.pace = pace
        self.note = note
        self._thrown = NEVER
        """The tick at which the lever was put to STOP by hand, if it was."""

    @property
    def lever_waits(self) -> bool:
        """Whether START or CONT throws the lever: it is at STOP, and the tape has not moved yet."""
        reader = self.reader
        fresh = reader.loaded and not reader.on and reader.position == 0
        return fresh and self.machine.processor.clock < self._thrown

    def wait(self, seconds: float) -> None:
        """Let time pass while the machine is stopped."""
        self.machine.wait(seconds)

    def set_switches(self, word: int) -> None:
        """Set the switch register."""
        self.wait(self.pace.setting)
        self.panel.sr = word
        self._note("sr", word, f"{word:04o} into the switches.")

    def load_address(self, address: int) -> None:
        """Set the switches to `address` and press LOAD ADD."""
        self.set_switches(address)
        self.wait(self.pace.pressing)
        self.panel.load_add()
        self._note("load add", None, f"{address:04o}, LOAD ADD.")

    def deposit(self, word: int) -> None:
        """Set the switches to `word` and press DEP."""
        self.set_switches(word)
        self.wait(self.pace.pressing)
        self.panel.dep()
        self._note("dep", None, f"{word:04o} into {self.machine.ma:04o}, DEP.")

    def toggle(self, address: int, words: Sequence[int]) -> Iterator[None]:
        """Put `words` into core from `address` on with the switches, a key at each step of the iterator."""
        self.load_address(address)
        yield
        for word in words:
            self.deposit(word)
            yield

    def mount(self, name: str, tape: bytes) -> None:
        """Put a tape in the reader, a loader's on its leader; if halted, START or CONT throws the lever."""
        self.wait(self.pace.mounting)
        if self.reader.on and not self.panel.lamps.run:
            self.reader.lever(False)
            self._thrown = NEVER
        self.reader.load(tape[codes.start(tape) :])
        self._note("mount", name, f"{name} goes into the reader.")

    def throw_lever(self, on: bool | None = None) -> None:
        """Put the reader's lever to START or STOP, by default to the other one."""
        self.reader.lever(not self.reader.on if on is None else on)
        self._thrown = NEVER if self.reader.on else self.machine.processor.clock
        self._note("lever", None, f"The reader's lever to {'START' if self.reader.on else 'STOP'}.")

    def press(self, key: str) -> None:
        """Press a momentary key, named as the Panel's method is: load_add, start, cont, stop, exam, dep."""
        if not self.panel.lamps.run:
            self.wait(self.pace.pressing)
        getattr(self.panel, key)()
        if key in ("start", "cont"):
            self.throw_what_waits()

    def start(self, address: int, switches: int | None = None, seconds: float | None = None) -> Stop:
        """Set `switches`, start at `address`, run until it halts or needs a tape, at most for `seconds`."""
        self.begin(address, switches)
        return self.machine.run(seconds)

    def begin(self, address: int, switches: int | None = None) -> None:
        """Set `switches` if they differ, press START at `address` and throw a waiting lever."""
        self.load_address(address)
        if switches is not None and switches != address:
            self.set_switches(switches)
        self.wait(self.pace.pressing)
        self._note("start", None, f"START at {address:04o}.")
        self.panel.start()
        self.throw_what_waits()

    def throw_what_waits(self) -> None:
        """Throw a waiting lever."""
        if self.lever_waits:
            self._run_on(self.pace.lever)
            self.throw_lever()

    def go_on(self, seconds: float | None = None) -> Stop:
        """Press CONT and run as `start` does."""
        self.press("cont")
        return self.machine.run(seconds)

    def stop(self) -> None:
        """Press STOP, as the reader is empty."""
        self.panel.stop()
        self._note("stop", None, "The reader is empty: STOP.")

    def boot(
        self, loader: bytes, program: bytes, name: str = "program", force: bool = False
    ) -> Iterator[Loading]:
        """Load `program`, a BIN or RIM tape, from cold by `loader`, BIN's RIM tape; yield each step. Raises
        LoadError if a loader fails; `force` accepts a wrong checksum or a missing end. A tape that starts
        itself is left in the reader, and RIM running.
        """
        self.panel.stop()
        self.panel.mem_prot = self.panel.sing_step = False
        self.panel.inst_field = self.panel.data_field = 0
        self._thrown = NEVER
        yield Loading("RIM loader toggled in", sum(1 for _ in self.toggle(RIM_START, RIM)))
        by_rim = codes.recognise(program) is codes.RIM
        if by_rim and rim.starts_itself(_rim_content(program)[1]) is not None:
            self.mount(name, program)
            self.begin(RIM_START)
            yield Loading(f"{name} into the reader, to be read by RIM; it starts itself", 2)
            return
        yield self.read_rim(loader, "BIN loader")
        if by_rim:
            yield self.read_rim(program, name)
        else:
            yield self.read_bin(program, name, force)
        self.reader.remove()

    def read_rim(self, tape: bytes, name: str = "tape") -> Loading:
        """Let RIM read `tape` and press STOP in its trailer. Raises LoadError if it does not get there."""
        end, words = _rim_content(tape)
        began = self.machine.processor.clock
        self.mount(name, tape[:end])
        stop = self.start(RIM_START, seconds=_longest(tape))
        if stop.reason is not Reason.TAPE_OUT:
            raise LoadError(f"{name}: the RIM loader {_ended(stop, tape)}")
        self.stop()
        return self._read(f"{name} read by RIM", began, words)

    def read_bin(self, tape: bytes, name: str = "tape", force: bool = False) -> Loading:
        """Let BIN read `tape`, with CONT for each further section. Raises LoadError unless it halts with AC =
        0 each time; with `force` the tape may run out or have a wrong checksum.
        """
        sections, words, end, halts = _bin_sections(tape)
        tape = tape[:end]
        began = self.machine.processor.clock
        self.mount(name, tape)
        stop = self.start(BIN_START, TELETYPE_READER, _longest(tape))
        self._judge(stop, tape, name, force or (sections == 1 and not halts))
        before = 0
        for left in range(sections - 1, 0, -1):
            before += self._pass_blank(name)
            stop = self.go_on(_longest(tape))
            self._judge(stop, tape, name, force or (left == 1 and not halts))
        found = self._read(f"{name} read by BIN", began, words)
        return found._replace(frames=before + found.frames, sections=sections)

    def _pass_blank(self, name: str) -> int:
        """Move past blank tape after the trailer, which RIM would load as 0000; return the frames passed."""
        read = self.reader.position
        rest = self.reader.tape[read:]
        gap = rest[: len(rest) - len(rest.lstrip(bytes((LEADER, BLANK))))]
        if BLANK not in gap:
            return 0
        self.mount(name, rest[gap.rfind(BLANK) :])
        return read

    def _judge(self, stop: Stop, tape: bytes, name: str, force: bool) -> None:
        """Raise LoadError unless the BIN loader has read the tape and halted with AC = 0."""
        ac, read = self.machine.ac, counted(self.reader.position, "frames")
        if stop.reason is Reason.TAPE_OUT and force:
            self.stop()
            return
        if stop.reason is not Reason.HALT:
            self.reader.remove()
            advice = _SLOWER if stop.reason is Reason.LIMIT else ""
            raise LoadError(f"{name}: the BIN loader {_ended(stop, tape)} after {read}{advice}")
        if self.reader.position <= 1:  # START itself sets READER RUN, which moves one
            self.reader.remove()
            raise LoadError(f"{name}: what was loaded as the BIN loader halted and had not read the tape")
        if ac and not force:
            self.reader.remove()
            raise LoadError(f"{name}: the BIN loader halted with AC = {ac:04o} after {read}: wrong checksum")

    def _read(self, what: str, began: int, words: Mapping[int, int]) -> Loading:
        """Return what was read of `words` since `began`."""
        seconds = (self.machine.processor.clock - began) / TICKS_PER_SECOND
        core = self.machine.core
        loaded = sum(core[address & self.machine.memory - 1] == word for address, word in words.items())
        return Loading(what, 2, self.reader.position, 1, loaded, seconds, len(words) - loaded)

    def _run_on(self, seconds: float) -> None:
        """Continue the run if the machine waits for what the operator does next."""
        processor = self.machine.processor
        until = processor.clock + round(seconds * TICKS_PER_SECOND)
        while processor.run and processor.clock < until:
            processor.instruction()
        self.wait(max(0, until - processor.clock) / TICKS_PER_SECOND)

    def _note(self, key: str, value: int | str | None, say: str) -> None:
        self.note(Action(self.machine.processor.clock, key, value, say))


def _longest(tape: bytes) -> float:
    """Return a loader's time limit: a minute and twice what the tape takes."""
    return 60 + 2 * len(tape) * FRAME / TICKS_PER_SECOND


def _ended(stop: Stop, tape: bytes) -> str:
    if stop.reason is Reason.LIMIT:
        limit = f"{duration(_longest(tape))}, a minute and twice what its tape takes"
        return f"did not end within {limit}; STOP was pressed at {stop.pc:04o}"
    return f"ended with {stop.reason} at {stop.pc:04o}"


def _rim_content(tape: bytes) -> tuple[int, dict[int, int]]:
    """Return the end of a RIM tape's trailer and its words."""
    try:
        reading = rim.read(tape)
    except TapeError:
        return len(tape), {}
    return len(tape) if reading.damage else reading.end, reading.words


def _bin_sections(tape: bytes) -> tuple[int, dict[int, int], int, bool]:
    """A BIN tape's sections, its words, the frames to read, and whether the loader halts after the last."""
    try:
        reading = binary.read(tape)
    except TapeError:
        return 1, {}, len(tape), True
    sections, words = len(reading.sections) + bool(reading.unended), binary.content(reading).words
    if not reading.sections or reading.unended:
        return sections, words, len(tape), True
    end = reading.sections[-1].frame + 2
    halts = LEADER in tape[end:]
    return sections, words, len(tape) if halts else end, halts
