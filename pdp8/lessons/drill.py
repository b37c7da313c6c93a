"""Drills at the panel: a card to follow key by key, and a coach who names the first wrong switch.

    rim       the RIM loader, 17 words        deposit   five words, a program that counts
    examine   a chain: each word is the address of the next
    boot      a morning from cold: RIM, BIN, the program, and AC 0000

A key that is not the card's next one is not pressed: the coach says what is wrong, and the machine stays as
it is. So nobody gets stuck; one can begin again at any time. At a kiosk, a drill that is left
alone begins again by itself.
"""

from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import NamedTuple

from pdp8.computer.machine import Machine
from pdp8.computer.use.operator import BIN_HALT, BIN_START, RIM, RIM_START, TELETYPE_READER
from tapes.quantities import counted, duration

LEFT_ALONE = 60.0
"""Seconds without a key or a switch after which a kiosk begins again."""

_KEYS = {
    "load_add": "LOAD ADD", "exam": "EXAM", "dep": "DEP", "start": "START", "cont": "CONT", "stop": "STOP",
}  # fmt: skip
_LOCKING = {
    "mem_prot": "MEM PROT is up", "sing_step": "SING STEP is on",
    "inst_field": "INST FIELD is up", "data_field": "DATA FIELD is up",
}  # fmt: skip


class DrillStep(NamedTuple):
    """A line of the card: a key to press, with `sr` in the switches or None for any; or a state to reach."""

    say: str
    key: str = ""
    sr: int | None = None
    come: Callable[[Machine], bool] | None = None


class Drill(NamedTuple):
    """A drill: its name, subject and card, and the words in core when it begins."""

    name: str
    title: str
    steps: tuple[DrillStep, ...]
    words: Mapping[int, int] = {}


def _words(address: int, words: Sequence[int]) -> Iterator[DrillStep]:
    yield DrillStep(f"{address:04o}  LOAD ADD", "load_add", address)
    for offset, word in enumerate(words):
        yield DrillStep(f"{word:04o}  DEP       into {address + offset:04o}", "dep", word)


_CHAIN = (0o300, 0o345, 0o1234, 0o4571, 0o7402)
_COUNTING = (0o7200, 0o7001, 0o2206, 0o5202, 0o5201)
"""CLA; IAC; ISZ 206; JMP .-1; JMP .-3: a count that can be watched in the AC."""


def _chain() -> Iterator[DrillStep]:
    yield DrillStep(f"{_CHAIN[0]:04o}  LOAD ADD", "load_add", _CHAIN[0])
    yield DrillStep("EXAM: MB shows an address", "exam")
    for address in _CHAIN[1:-1]:
        yield DrillStep("set the address that MB shows, LOAD ADD", "load_add", address)
        yield DrillStep("EXAM", "exam")


def _boot(tapes: Sequence[tuple[str, Mapping[int, int]]]) -> Iterator[DrillStep]:
    (loader, bin_words), (program, words) = tapes
    yield from _words(RIM_START, RIM)
    yield DrillStep(f"O: {loader} into the reader", come=_at_its_beginning)
    yield DrillStep(f"{RIM_START:04o}  LOAD ADD", "load_add", RIM_START)
    yield DrillStep("START: RIM reads BIN (P: faster)", "start")
    yield DrillStep("wait until the tape has run through", come=lambda machine: _holds(machine, bin_words))
    yield DrillStep("STOP", "stop")
    yield DrillStep(f"O: {program} into the reader", come=_at_its_beginning)
    yield DrillStep(f"{BIN_START:04o}  LOAD ADD", "load_add", BIN_START)
    yield DrillStep("START: BIN reads the program", "start", TELETYPE_READER)
    yield DrillStep("it halts; AC 0000: checksum right", come=lambda machine: _loaded(machine, words))


def _at_its_beginning(machine: Machine) -> bool:
    reader = machine.teletype.reader
    return bool(reader.tape) and reader.position == 0


def _holds(machine: Machine, words: Mapping[int, int]) -> bool:
    reader = machine.teletype.reader
    return reader.position == len(reader.tape) and _in_core(machine, words)


def _loaded(machine: Machine, words: Mapping[int, int]) -> bool:
    halted = not machine.panel.lamps.run and machine.ma == BIN_HALT
    return halted and machine.ac == 0 and _in_core(machine, words)


def _in_core(machine: Machine, words: Mapping[int, int]) -> bool:
    return all(machine.core[address] == word for address, word in words.items())


NAMES = ("rim", "deposit", "examine", "boot")


def find(name: str, tapes: Sequence[tuple[str, Mapping[int, int]]]) -> Drill:
    """The drill of NAMES called `name`; `boot` takes BIN's tape and the program's words from `tapes`."""
    if name == "rim":
        return Drill(name, "Toggle the RIM loader in", tuple(_words(RIM_START, RIM)))
    if name == "deposit":
        return Drill(name, "Deposit five words", tuple(_words(0o200, _COUNTING)))
    if name == "examine":
        chain = dict(zip(_CHAIN, (*_CHAIN[1:], 0), strict=True))
        return Drill(name, "Examine a chain of addresses", tuple(_chain()), chain)
    return Drill(name, "Boot from cold", tuple(_boot(tapes)))


class Coach:
    """Watches a drill at a machine; a kiosk restarts after `left_alone` seconds."""

    def __init__(self, drill: Drill, machine: Machine, left_alone: float | None = None) -> None:
        self.drill = drill
        self.machine = machine
        self.left_alone = left_alone
        machine.load(drill.words)
        self._cold = machine.values()
        self._begin()

    def _begin(self) -> None:
        self.at = 0
        """The step that is to be done."""
        self.wrong = 0
        """How many keys were not the card's next."""
        self.seconds = 0.0
        """How long it has taken, since the first key."""
        self.said = "Follow the card. The clock begins with your first key."
        self.begun = False
        """Whether a key was pressed."""
        self._still = 0.0
        self._touched = False

    def again(self) -> None:
        """Begin again, with the machine in its first state."""
        self.machine.put(self._cold)
        self._begin()

    @property
    def done(self) -> bool:
        """Whether the card is done."""
        return self.at == len(self.drill.steps)

    def touched(self) -> None:
        """Note that a key or a switch moved: the machine is not left alone."""
        self._still = 0.0
        self._touched = True

    def allows(self, key: str) -> bool:
        """Whether `key` is the card's next one with the switches right, to be pressed now; else say why."""
        self.begun = True
        if self.done:
            return True
        step = self.drill.steps[self.at]
        fault = self._fault(step, key)
        if fault:
            self.wrong += 1
            self.said = fault
            return False
        self._go_on(f"right: {step.say}")
        return True

    def _fault(self, step: DrillStep, key: str) -> str:
        panel = self.machine.panel
        for name, said in _LOCKING.items():
            if getattr(panel, name):
                return f"{said}: put it back first"
        if not step.key:
            return f"not {_KEYS[key]} yet: {step.say}"
        if step.sr is not None and panel.sr != step.sr and key == step.key:
            return _switch(panel.sr, step.sr)
        return "" if key == step.key else f"{_KEYS[step.key]} is next, not {_KEYS[key]}"

    def _go_on(self, said: str) -> None:
        self.at += 1
        self.said = said
        if self.done:
            mistakes = counted(self.wrong, "mistakes") if self.wrong else "no mistake"
            self.said = f"Done in {duration(self.seconds)}, {mistakes}."

    def advance(self, seconds: float) -> bool:
        """Let `seconds` pass; return whether a kiosk has begun again."""
        if self.begun and not self.done:
            self.seconds += seconds
        self._still += seconds
        if self._touched and self.left_alone is not None and self._still >= self.left_alone:
            self.again()
            return True
        if not self.done:
            step = self.drill.steps[self.at]
            if step.come is not None and step.come(self.machine):
                self._go_on(f"right: {step.say}")
        return False


def _switch(found: int, wanted: int) -> str:
    """Name the first wrong switch, from the left, 0 first."""
    bit = next(bit for bit in range(12) if (found ^ wanted) >> 11 - bit & 1)
    way = "up" if wanted >> 11 - bit & 1 else "down"
    return f"switch {bit} should be {way}: {wanted:04o}, not {found:04o}"
