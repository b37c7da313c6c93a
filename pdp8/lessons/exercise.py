"""An exercise as data: a program to write, tried on cases, or a sheet of questions.

form reads it from its file; what is random in it has been drawn by then. So a page that has these values
marks as the command does.
"""

from collections.abc import Mapping
from dataclasses import dataclass, field


@dataclass(frozen=True)
class Trial:
    """One run of a program: how it is set up, what it must do. None is not looked at."""

    start: tuple[str, ...] = ("0200",)
    """Tags or addresses: the first that the answer has."""
    starts: int = 1
    again: tuple["Trial", ...] = ()
    """What it is started with after that, each with its own inputs and results; core stays."""
    sr: int = 0
    deposit: Mapping[str, int | str] = field(default_factory=dict)
    reader: bytes = b""
    keys: bytes = b""
    seconds: float = 10
    """Of machine time, the most it may take."""
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
    """What is marked as one: every trial must be right. Nothing of a hidden case is shown but its name.

    `hints` are by what happened (diagnosis.py) or by what differs (AC, the tape, a tag); "" for any result.
    """

    name: str
    trials: tuple[Trial, ...]
    points: int = 1
    hints: Mapping[str, str] = field(default_factory=dict)
    hidden: bool = False


@dataclass(frozen=True)
class Question:
    """One line of a sheet: what is asked, which answers are right, what is said to a wrong one.

    A number is right by its value in `unit`, within `tolerance`. A student's form has no answer: what is
    given is neither right nor wrong.
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
        """Whether nothing says which answer is right."""
        return self.number is None and not self.answer


@dataclass(frozen=True)
class Source:
    """What an answer's source must keep to."""

    words: int | None = None
    required: tuple[str, ...] = ()
    forbidden: tuple[str, ...] = ()
    spare: tuple[str, ...] = ()
    """Addresses that an answer must not load: the checker uses them."""


@dataclass(frozen=True)
class Exercise:
    """A whole exercise; `mistakes` are by what a student did: a piece of the solution, and what he wrote.

    A student's form has neither solution nor mistakes; `others` are the hidden cases that it leaves out.
    """

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
    def names(self) -> tuple[str, ...]:
        """The names of what is marked one by one."""
        return (*[case.name for case in self.cases], *[question.name for question in self.questions])

    @property
    def points(self) -> int:
        """The most that can be had."""
        marked = [question.points for question in self.questions if not question.unmarked]
        return sum(case.points for case in self.cases) + sum(marked)

    @property
    def note(self) -> str:
        """What is said below the marks that a student's form gives."""
        if any(question.unmarked for question in self.questions):
            return "Of what is given the teacher says whether it is right."
        if self.others:
            tried = len(self.cases)
            return f"{tried} of {tried + self.others} cases were tried; the teacher tries the others too."
        return ""
