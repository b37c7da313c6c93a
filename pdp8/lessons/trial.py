"""An answer run on one trial, on a machine of its own, for a bounded machine time.

Core that the answer does not load is full of 5200, a jump to the first word of its page: no program may
count on what it finds there, and one that runs into it does not end.
"""

from array import array
from collections.abc import Sequence
from typing import NamedTuple

from pdp8.computer.hardware.teletype import printed
from pdp8.computer.machine import Machine
from pdp8.computer.stop import Reason, Stop
from pdp8.lessons.answer import Answer
from pdp8.lessons.exercise import Trial

_JUNK = array("H", [0o5200] * 0o10000).tobytes()
_TURNS = 500
"""Instructions in which a loop that did not stop is looked at."""
_LOOKED_AT = 100_000
"""Instructions in which a changed word is looked for among those that are executed."""


class Outcome(NamedTuple):
    """What the machine was like when it stopped; of tape, page and count what the last START brought."""

    stop: Stop
    ac: int
    link: int
    before: Sequence[int]
    core: Sequence[int]
    tape: bytes
    page: str
    instructions: int


def needs(trial: Trial) -> list[str]:
    """Return the symbols by which the trial calls places of an answer."""
    pointers = [word for word in trial.deposit.values() if isinstance(word, str)]
    places = [trial.start, *trial.deposit, *pointers, *trial.core, *trial.changed]
    return [place for place in places if not place[0].isdigit()]


def run(answer: Answer, trial: Trial) -> Outcome:
    """Run `answer`, which has the symbols the trial needs, as the trial says."""
    machine = _ready(answer, trial)
    before = list(machine.core)
    punched, printer = machine.teletype.punch.frames, machine.teletype.printer.frames
    stop = Stop(Reason.LIMIT, machine.pc, 0)
    instructions = 0
    for _ in range(trial.starts):
        punched.clear()
        printer.clear()
        instructions = machine.instructions
        _start(machine, answer, trial)
        stop = machine.run(seconds=trial.seconds)
    page = printed(bytes(printer)).decode().replace("\r\n", "\n")
    instructions = machine.instructions - instructions
    core = list(machine.core)
    return Outcome(stop, machine.ac, machine.link, before, core, bytes(punched), page, instructions)


def turns(answer: Answer, trial: Trial) -> tuple[int, int]:
    """Return the lowest and the highest address of the loop in which the trial's time is over."""
    machine = _ready(answer, trial)
    _start(machine, answer, trial)
    machine.run(seconds=trial.seconds)
    addresses = [machine.pc]
    for _ in range(_TURNS):
        machine.run(instructions=1)
        addresses.append(machine.pc)
    return min(addresses), max(addresses)


def overwritten(answer: Answer, trial: Trial, outcome: Outcome) -> int | None:
    """Return the first address whose word the answer has changed and executes, None if there is none."""
    changed = [each for each in answer.words if outcome.core[each] != outcome.before[each]]
    if not changed:
        return None
    machine = _ready(answer, trial)
    _start(machine, answer, trial)
    machine.watch.breakpoints.update(changed)
    while machine.instructions < _LOOKED_AT:
        stop = machine.run(seconds=trial.seconds, instructions=_LOOKED_AT - machine.instructions)
        if stop.reason is not Reason.BREAKPOINT:
            return None
        if stop.pc in changed:  # after a JMS it is not, which writes its first word and does not execute it
            return stop.pc
    return None


def _ready(answer: Answer, trial: Trial) -> Machine:
    machine = Machine()
    machine.put({"core": _JUNK})
    machine.load(answer.words)
    for place, word in trial.deposit.items():
        machine.core[answer.address(place)] = word if isinstance(word, int) else answer.address(word)
    machine.sr = trial.sr
    return machine


def _start(machine: Machine, answer: Answer, trial: Trial) -> None:
    machine.teletype.reader.load(trial.reader)
    machine.start(answer.address(trial.start))
    machine.teletype.keyboard.press(trial.keys)
