"""An answer run on one trial, on a machine of its own, for a bounded machine time.

Core that the answer does not load is filled for each trial with words drawn anew, many of which are addresses
of programs: none may count on what it finds there. There is no HLT among them, and one that
runs into them is stopped: it has left the program.
"""

from array import array
from collections.abc import Sequence
from typing import NamedTuple

from pal.isa import DEFER, FETCH, JMS, halts
from pdp8.computer.hardware.processor import Processor
from pdp8.computer.hardware.teletype import printed
from pdp8.computer.machine import Machine
from pdp8.computer.stop import Reason, Stop
from pdp8.lessons.answer import Answer, tag
from pdp8.lessons.exercise import Trial

_DRAWN = 127
"""Words drawn; copies of them fill core. A page has one word more, so no two pages are alike."""
_TURNS = 500
"""Instructions that show where a loop that did not stop begins and ends."""
_LOOKED_AT = 100_000
"""Instructions in which a changed word is looked for among those that are executed."""
_CALLS = 1000
"""Stops of the search for a changed word that is executed: each call of a subroutine is one."""


class Outcome(NamedTuple):
    """The machine when it stopped; tape, page and count are those of START number `number`. Leaving the
    program counts as a breakpoint; `printing`: a character was being printed.
    """

    stop: Stop
    ac: int
    link: int
    before: Sequence[int]
    core: Sequence[int]
    tape: bytes
    page: str
    instructions: int
    printing: bool = False
    number: int = 0


class Looks:
    """How often each word is executed or called, from where, and through which words it goes."""

    def __init__(self) -> None:
        self.executed: dict[int, int] = {}
        self.callers: dict[int, set[int]] = {}
        self.pointers: set[int] = set()
        self._at = 0

    def cycle(self, processor: Processor, interrupt: bool) -> None:
        """Take notice of a memory cycle."""
        address = processor.ma
        if processor.state == FETCH:
            self._at = address
        if processor.state == DEFER:
            self.pointers.add(address)
        called = processor.ir == JMS and not interrupt and processor.state not in (FETCH, DEFER)
        if called:
            self.callers.setdefault(address, set()).add(self._at)
        if called or processor.state == FETCH:
            self.executed[address] = self.executed.get(address, 0) + 1

    def waited(self, processor: Processor, instructions: int, ticks: int) -> None:
        """Ignore what was passed over: every loop has been seen once."""


def missing(answer: Answer, trial: Trial) -> str:
    """Return the first tag that the trial uses and the answer does not have, "" if there is none."""
    if not any(has(answer, place) for place in trial.start):
        return trial.start[0]
    pointers = [word for word in trial.deposit.values() if isinstance(word, str)]
    places = [*trial.deposit, *pointers, *trial.core, *trial.changed, *trial.unchanged, *trial.executed]
    for place in [*places, *trial.callers]:
        if not has(answer, place):
            return tag(place)[0]
    return next((name for name in (missing(answer, each) for each in trial.again) if name), "")


def has(answer: Answer, place: str) -> bool:
    """Return whether an answer has a place: an address, or a tag of its own."""
    return place[0].isdigit() or tag(place)[0] in answer.symbols


def start(answer: Answer, trial: Trial) -> int:
    """Return the address at which to start: of the trial's places, the first one that the answer has."""
    return next(answer.address(place) for place in trial.start if has(answer, place))


def run(answer: Answer, trial: Trial) -> list[Outcome]:
    """Run `answer` as the trial says; return the outcome of its last START, then that of each `again`."""
    tried = Tried(answer, trial)
    outcomes = [tried.outcome(number) for number in range(len(tried.starts))]
    return outcomes[trial.starts - 1 :]


def looks(answer: Answer, trial: Trial) -> Looks:
    """Return what an answer does beside its results, from the first START to the end of the last."""
    tried, seen = Tried(answer, trial), Looks()
    tried.machine.watch.observer = seen
    for number in range(len(tried.starts)):
        tried.outcome(number)
    return seen


class Tried:
    """A machine with an answer, to be started as a trial says; `starts` has each START's trial."""

    def __init__(self, answer: Answer, trial: Trial, before: int = 0) -> None:
        """Prepare the machine and run the STARTs before the first that counts."""
        self.answer = answer
        self.starts = [trial] * trial.starts + [*trial.again]
        self.machine = Machine()
        self._filled = array("H", _fill(trial))
        self.machine.put({"core": self._filled.tobytes()})
        self.machine.load(answer.words)
        own = {answer.address(place) for each in self.starts for place in each.deposit}
        self._free = {*range(len(self._filled))} - own - {*answer.words}
        for number in range(before):
            self.outcome(number)

    def start(self, number: int) -> None:
        """Set the inputs of START number `number`, and press START."""
        trial, machine, answer = self.starts[number], self.machine, self.answer
        if number == 0 or trial is not self.starts[number - 1]:
            for place, word in trial.deposit.items():
                machine.core[answer.address(place)] = word if isinstance(word, int) else answer.address(word)
        machine.sr = trial.sr
        machine.teletype.punch.frames.clear()
        machine.teletype.printer.frames.clear()
        machine.teletype.reader.load(trial.reader)
        machine.start(start(answer, trial))
        machine.teletype.keyboard.press(trial.keys)

    def run(self, number: int) -> Stop:
        """Run to the end; leaving the program stops at a breakpoint."""
        machine, watch, seconds = self.machine, self.machine.watch, self.starts[number].seconds
        watch.breakpoints = set(self._free)
        stop = Stop(Reason.BREAKPOINT, machine.pc, 0)
        while stop.reason is Reason.BREAKPOINT and stop.pc not in self._free:
            stop = machine.run(seconds=max(seconds - machine.elapsed, 0))
            if stop.reason is Reason.BREAKPOINT:  # what it has written and what it calls is its own now
                entry = machine.ma if machine.ir == JMS else -1
                core, filled = machine.processor.core, self._filled
                self._free = {at for at in self._free if core[at] == filled[at] and at != entry}
                watch.breakpoints = set(self._free)
        watch.breakpoints = set()
        return stop

    def outcome(self, number: int) -> Outcome:
        """Press START number `number`, run, and return what that brought."""
        machine = self.machine
        self.start(number)
        before, instructions = list(machine.core), machine.instructions
        stop = self.run(number)
        page = printed(bytes(machine.teletype.printer.frames)).decode("ascii").replace("\r\n", "\n")
        return Outcome(
            stop, machine.ac, machine.link, before, list(machine.core), machine.teletype.punch.tape, page,
            machine.instructions - instructions, machine.teletype.transmitter.register != 0, number,
        )  # fmt: skip


def last(answer: Answer, trial: Trial, outcome: Outcome) -> Machine:
    """Return the machine before the last instruction."""
    tried = Tried(answer, trial, outcome.number)
    tried.start(outcome.number)
    tried.machine.run(instructions=outcome.instructions - 1)
    return tried.machine


def turns(answer: Answer, trial: Trial, outcome: Outcome) -> tuple[int, int]:
    """Return the lowest and highest address of the loop that ran out of time."""
    tried = Tried(answer, trial, outcome.number)
    tried.start(outcome.number)
    tried.run(outcome.number)
    addresses = [tried.machine.pc]
    for _ in range(_TURNS):
        tried.machine.run(instructions=1)
        addresses.append(tried.machine.pc)
    return min(addresses), max(addresses)


def overwritten(answer: Answer, trial: Trial, outcome: Outcome) -> int | None:
    """Return the first executed address whose word the answer changed, or None."""
    changed = [each for each in answer.words if outcome.core[each] != outcome.before[each]]
    if not changed:
        return None
    tried = Tried(answer, trial, outcome.number)
    machine = tried.machine
    tried.start(outcome.number)
    machine.watch.breakpoints.update(changed)
    last = machine.instructions + _LOOKED_AT
    for _ in range(_CALLS):
        stop = machine.run(
            seconds=tried.starts[outcome.number].seconds, instructions=last - machine.instructions
        )
        if stop.reason is not Reason.BREAKPOINT or machine.instructions >= last:
            return None
        if stop.pc in changed:  # after a JMS it is not, which writes its first word and does not execute it
            return stop.pc
    return None


def _fill(trial: Trial) -> list[int]:
    """Return core full of random words, every other one a pointer to the program's own words."""
    seed = trial.sr + len(trial.keys)
    for number in (*trial.reader, *[word for word in trial.deposit.values() if isinstance(word, int)]):
        seed = (seed * 31 + number) % (1 << 31)
    drawn = []
    for _ in range(_DRAWN):
        seed = (seed * 69069 + 12345) % (1 << 31)
        word = seed >> 19
        if (seed >> 12) % 2 == 0:
            word = 0o200 + word % 0o100
        drawn.append(word & 0o7775 if halts(word) else word)
    return (drawn * 33)[: 1 << 12]
