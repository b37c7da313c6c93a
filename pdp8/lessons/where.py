"""The place where an answer goes wrong in a trial: it is stopped there, before the wrong instruction.

The first of these that there is:

    the first instruction that is no word of the program     a word that is wrong: its last writing
    a character sent while the one before is under way       AC or L: their last change
    the sending of the first wrong character                 a loop that does not end: coming to it for good
    and else the end
"""

from typing import NamedTuple

from pal.isa import FETCH, IOT
from pdp8.computer.hardware.processor import Processor
from pdp8.computer.machine import Machine
from pdp8.computer.stop import Reason
from pdp8.computer.watch import wrote
from pdp8.lessons import diagnosis
from pdp8.lessons.answer import Answer
from pdp8.lessons.exercise import Trial
from pdp8.lessons.marking import Failed
from pdp8.lessons.trial import Tried, last, turns
from tapes.quantities import counted

_MOST = 1_000_000
"""Memory cycles in which the place is looked for, those of waiting loops apart."""
_NONE = -1


class Place(NamedTuple):
    """A sentence on what goes wrong, the instruction's address, and how many came before it since START."""

    says: str
    address: int
    instructions: int


class _Seen:
    """Records what a run does; a place is the number of instructions before it."""

    def __init__(self, machine: Machine, word: int, low: int, high: int) -> None:
        self._line = machine.teletype.transmitter
        self._before = machine.instructions + 1
        self._word, self._low, self._high = word, low, high
        self._lac, self._pc = machine.processor.lac, _NONE
        self._sends = False
        self.sent: list[int] = []
        self.early = self.written = self.changed = self.entered = _NONE
        self._at = 0
        self._left = _MOST

    def cycle(self, processor: Processor, interrupt: bool) -> None:
        """Take notice of a memory cycle."""
        p = processor
        self._left -= 1
        if self._left == 0:
            p.stop()
        if p.state == FETCH:
            self._at = p.instructions - self._before
            if self._low <= p.ma <= self._high and not self._low <= self._pc <= self._high:
                self.entered = self._at
            self._pc = p.ma
            if p.ir == IOT and p.mb & 0o774 == 0o044:
                self.sent.append(self._at)
                if self._sends and self.early == _NONE:
                    self.early = self._at
        self._sends = self._line.register != 0
        if wrote(p) and p.ma == self._word:
            self.written = self._at
        if p.lac != self._lac:
            self._lac, self.changed = p.lac, self._at

    @property
    def whole(self) -> bool:
        """Whether all of the run was seen: what was last in it is known."""
        return self._left > 0

    def waited(self, processor: Processor, instructions: int, ticks: int) -> None:
        """A waiting loop was skipped: the line may be free now."""
        self._sends = self._line.register != 0


def find(answer: Answer, whole: Trial, failed: Failed) -> Place:
    """Return the place where a trial of an answer goes wrong."""
    outcome, wrong = failed.outcome, failed.failures[0]
    if outcome.stop.reason is Reason.BREAKPOINT:
        came = last(answer, whole, outcome).pc if outcome.instructions else outcome.stop.pc
        left = f"it leaves the program, from {came:04o} to {outcome.stop.pc:04o}"
        return Place(left, outcome.stop.pc, outcome.instructions)
    loops = wrong.happened in (diagnosis.NOT_STOPPED, diagnosis.JUMP)
    low, high = turns(answer, whole, outcome) if loops else (_NONE, _NONE)
    words = [each for each in failed.failures if each.what in failed.trial.core]
    word = answer.address(words[0].what) if words else _NONE
    tried = Tried(answer, whole, outcome.number)
    tried.start(outcome.number)
    seen = _Seen(tried.machine, word, low, high)
    tried.machine.watch.observer = seen
    tried.machine.run(seconds=failed.trial.seconds, instructions=outcome.instructions)
    says, at = _says(failed, seen, outcome.instructions - (outcome.stop.reason is Reason.HALT))
    return Place(says, _standing(answer, whole, outcome.number, at).pc, at)


def _says(failed: Failed, seen: _Seen, end: int) -> tuple[str, int]:
    """Return what goes wrong, and after how many instructions."""
    reason = failed.outcome.stop.reason
    ends = "it ends" if reason is Reason.HALT else "it goes on" if reason is Reason.LIMIT else "it waits"
    for wrong in failed.failures:
        if isinstance(wrong.expected, bytes) or wrong.what == "the page":
            if seen.early != _NONE:
                return "a character is sent while the one before is still under way", seen.early
            number = diagnosis.first_difference(wrong.expected, wrong.got)
            if number < len(seen.sent) and number < len(wrong.got):
                return f"character {number + 1} is sent, the first that is wrong", seen.sent[number]
    for wrong in failed.failures if seen.whole else ():
        if wrong.what in failed.trial.core:
            if seen.written != _NONE:
                return (
                    f"{wrong.what} becomes {_text(wrong.got)}; {_text(wrong.expected)} is wanted",
                    seen.written,
                )
            if seen.entered == _NONE:
                return f"{ends}, and nothing has written {wrong.what}", end
        elif wrong.what in ("AC", "L") and seen.changed != _NONE:
            return f"{wrong.what} becomes {_text(wrong.got)}; {_text(wrong.expected)} is wanted", seen.changed
    if seen.entered != _NONE:
        return "it comes to a loop that it does not leave", seen.entered
    wrong = failed.failures[0]
    return f"{ends}, {wrong.what}: {_text(wrong.got)}", end


def _text(value: str | bytes) -> str:
    """Return what was expected or found, in words."""
    return value or "nothing" if isinstance(value, str) else counted(len(value), "frames")


def standing(answer: Answer, whole: Trial, number: int) -> Machine:
    """Return a machine stopped just after START number `number` was pressed."""
    tried = Tried(answer, whole, number)
    tried.start(number)
    tried.machine.stop()
    return tried.machine


def _standing(answer: Answer, whole: Trial, number: int, instructions: int) -> Machine:
    machine = standing(answer, whole, number)
    machine.run(instructions=instructions)
    return machine
