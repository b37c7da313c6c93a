"""An exercise as data: a program to write, tried on cases, or a sheet of questions.

form reads it from its file; what is random in it has been drawn by then. So a page that has these values
marks as the command does.
"""

from collections.abc import Mapping
from dataclasses import dataclass, field

from pdp8.lessons.answer import tag
from tapes.quantities import counted


@dataclass(frozen=True)
class Trial:
    """One run of a program: its inputs and expected results; None is not checked."""

    start: tuple[str, ...] = ("0200",)
    """Tags or addresses; the run starts at the first of them that the answer has."""
    starts: int = 1
    again: tuple["Trial", ...] = ()
    """Further STARTs, each with its own inputs and results; core stays."""
    sr: int = 0
    deposit: Mapping[str, int | str] = field(default_factory=dict)
    reader: bytes = b""
    keys: bytes = b""
    seconds: float = 10
    """The most machine time that it may take."""
    stop: str = "halt"
    tape: bytes | None = None
    nul: str = "counted"
    """`ignored`: blank frames of the tape that is punched are no part of it."""
    itself: bool = False
    """Whether the tape must be the program itself in RIM format, without leader."""
    page: str | None = None
    ac: int | None = None
    link: int | None = None
    core: Mapping[str, int] = field(default_factory=dict)
    changed: tuple[str, ...] = ()
    unchanged: tuple[str, ...] = ()
    executed: Mapping[str, int] = field(default_factory=dict)
    """How often each place is executed or called, at least."""
    callers: Mapping[str, int] = field(default_factory=dict)
    """From how many places each is called, at least."""
    indirect: tuple[str, ...] = ()
    """Places of which one at least must serve as a pointer."""
    done: bool = False
    """Whether the last character must be printed when it halts."""
    instructions: int | None = None
    takes: tuple[float, float] | None = None
    """The least and the most seconds of machine time from START to the end."""


@dataclass(frozen=True)
class Case:
    """Trials that must all be right; `tests` quotes the task, `hints` are by what happened or differs, "" for
    any. Of a hidden case only the name is shown.
    """

    name: str
    trials: tuple[Trial, ...]
    points: int = 1
    tests: str = ""
    hints: Mapping[str, str] = field(default_factory=dict)
    hidden: bool = False


@dataclass(frozen=True)
class Question:
    """One question of a sheet, its right answers, and the hint for a wrong one.

    A number is right by its value in `unit`, within `tolerance`; of other answers the unit may be octal.
    A student's form has no answer: what is given is neither right nor wrong.
    """

    name: str
    ask: str
    answer: tuple[str, ...] = ()
    number: float | None = None
    unit: str = ""
    tolerance: float = 0
    points: int = 1
    hint: str = ""
    slips: Mapping[str, str] = field(default_factory=dict)

    @property
    def unmarked(self) -> bool:
        """Whether no right answer is known, as in a student's form."""
        return self.number is None and not self.answer


@dataclass(frozen=True)
class Source:
    """Requirements for an answer's source."""

    words: int | None = None
    required: tuple[str, ...] = ()
    forbidden: tuple[str, ...] = ()
    spare: tuple[str, ...] = ()
    """Addresses that an answer must not load: the checker uses them."""


@dataclass(frozen=True)
class Exercise:
    """An exercise; a student's form has no solution, no mistakes, and names hidden cases (`others`)."""

    name: str
    title: str
    task: str
    source: Source
    cases: tuple[Case, ...]
    questions: tuple[Question, ...]
    others: int = 0
    solution: str = ""
    mistakes: Mapping[str, tuple[str, str]] = field(default_factory=dict)

    @property
    def asked(self) -> str:
        """The task, followed by what is checked besides the results."""
        trials = [each for case in self.cases for each in case.trials]
        every = [each for first in trials for each in (first, *first.again)]
        spare = [f"We use {_ranged(self.source.spare)}: leave them free."] if self.source.spare else []
        said = [line for each in every for line in _looked_at(each)]
        lines = [line for line in dict.fromkeys([*spare, *said]) if line not in self.task]
        return "\n- ".join([self.task.rstrip("\n"), *lines]) if lines else self.task

    @property
    def names(self) -> tuple[str, ...]:
        """The names of all cases and questions."""
        return (*[case.name for case in self.cases], *[question.name for question in self.questions])

    @property
    def points(self) -> int:
        """The points of an answer that is right throughout."""
        marked = [question.points for question in self.questions if not question.unmarked]
        return sum(case.points for case in self.cases) + sum(marked)

    @property
    def note(self) -> str:
        """The sentence below the marks of a student's form, "" for a whole exercise."""
        if any(question.unmarked for question in self.questions):
            return "The teacher says whether each answer is right."
        if self.others:
            tried = len(self.cases)
            return f"{tried} of {tried + self.others} cases were tried; the teacher tries the others too."
        return ""


def _looked_at(trial: Trial) -> list[str]:
    """Return a sentence for each thing checked besides the results."""
    said = [
        f"{place} is executed or called {counted(times, 'times')} at least."
        for place, times in trial.executed.items()
    ]
    said += [
        f"{place} is called from {counted(times, 'places')} at least."
        for place, times in trial.callers.items()
    ]
    if trial.indirect:
        said.append(f"One of the words {_ranged(trial.indirect)} serves as a pointer, by I.")
    if trial.unchanged:
        said.append(f"The program leaves {_ranged(trial.unchanged)} unchanged.")
    if trial.done:
        said.append("It halts only when the last character is printed.")
    if trial.nul == "ignored":
        said.append("Blank frames that are punched do not count.")
    return said


def _ranged(places: tuple[str, ...]) -> str:
    """Return places in words, `0020 to 0023` for those that follow each other."""
    said: list[str] = []
    before, last = "", 0
    for place in places:
        name, behind = ("", int(place, 8)) if place[0].isdigit() else tag(place)
        if said and name == before and behind == last + 1:
            said[-1] = f"{said[-1].split(' to ')[0]} to {place}"
        else:
            said.append(place)
        before, last = name, behind
    return ", ".join(said)
