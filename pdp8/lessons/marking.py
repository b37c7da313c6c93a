"""Points and failures: an answer held against every case or question of its exercise.

A case gives its points when everything it looks at is as expected, and none otherwise. Bounds on the source
and words it must or must not have count for the whole: what breaks them gets no points.
"""

from collections.abc import Iterator
from dataclasses import dataclass

from pdp8.computer.use.program import FOUND
from pdp8.lessons import answer as answers
from pdp8.lessons import trial
from pdp8.lessons.answer import Answer
from pdp8.lessons.exercise import Case, Exercise, Question
from pdp8.lessons.trial import Outcome


@dataclass(frozen=True)
class Failure:
    """One thing that is not as expected; a tape's is shown as holes, any other's as text."""

    what: str
    expected: str | bytes
    got: str | bytes


@dataclass(frozen=True)
class Mark:
    """What one case or question brought; `hint` is for whom it failed."""

    name: str
    points: int
    of: int
    failures: tuple[Failure, ...] = ()
    hint: str = ""


@dataclass(frozen=True)
class Result:
    """The marks of one answer; `fault` says why there are none."""

    answer: str
    marks: tuple[Mark, ...]
    of: int
    fault: str = ""

    @property
    def points(self) -> int:
        """The points of all marks."""
        return sum(mark.points for mark in self.marks)

    @property
    def right(self) -> bool:
        """Whether nothing was wrong."""
        return not self.fault and not any(mark.failures for mark in self.marks)


def mark(exercise: Exercise, answer: Answer, dialect: str = FOUND) -> Result:
    """Return the marks of `answer`, a source in `dialect`. Nothing that an answer does raises an error."""
    if not exercise.questions:
        answer = answers.assembled(answer, dialect)
    fault = answer.fault or _broken(exercise, answer)
    if fault:
        return Result(answer.name, (), exercise.points, fault)
    lines = answer.lines()
    marks = [_try(case, answer) for case in exercise.cases]
    marks += [_compare(question, lines.get(question.name.lower(), "")) for question in exercise.questions]
    return Result(answer.name, tuple(marks), exercise.points)


def _broken(exercise: Exercise, answer: Answer) -> str:
    """Return which rule of the exercise the source breaks."""
    source = exercise.source
    items = answer.items()
    if (source.required or source.forbidden) and not answer.source:
        return "this exercise looks at the source: hand in PAL, not a tape"
    for item in source.required:
        if item not in items:
            return f"{item} is to be used, and is not"
    for item in source.forbidden:
        if item in items:
            return f"{item} is not to be used"
    if source.words is not None and len(answer.words) > source.words:
        return f"{len(answer.words)} words of core; at most {source.words} are allowed"
    missing = [name for case in exercise.cases for name in trial.needs(case) if name not in answer.symbols]
    return f"the tag {missing[0]} is missing; the exercise looks for it" if missing else ""


def _try(case: Case, answer: Answer) -> Mark:
    failures = tuple(_failures(case, answer, trial.run(answer, case)))
    if failures:
        return Mark(case.name, 0, case.points, failures, case.hint)
    return Mark(case.name, case.points, case.points)


def _failures(case: Case, answer: Answer, outcome: Outcome) -> Iterator[Failure]:
    stop = outcome.stop
    if case.stop not in (stop.reason, "any"):
        limit = f" after {case.seconds:g} s" if stop.reason == "limit" else ""
        yield Failure("the end", case.stop, f"{stop.reason}{limit}, before {stop.pc:04o}")
    if case.ac not in (None, outcome.ac):
        yield Failure("AC", f"{case.ac:04o}", f"{outcome.ac:04o}")
    if case.link not in (None, outcome.link):
        yield Failure("L", f"{case.link}", f"{outcome.link}")
    for place, word in case.core.items():
        found = outcome.core[answer.address(place) or 0]
        if found != word:
            yield Failure(place, f"{word:04o}", f"{found:04o}")
    for place in case.changed:
        address = answer.address(place) or 0
        if outcome.core[address] == outcome.before[address]:
            yield Failure(place, "another word", f"{outcome.core[address]:04o}, as before")
    if case.page not in (None, outcome.page):
        yield Failure("the page", str(case.page), outcome.page)
    if case.tape not in (None, outcome.tape):
        yield Failure("the tape", case.tape or b"", outcome.tape)
    if case.instructions is not None and outcome.instructions > case.instructions:
        yield Failure("instructions", f"at most {case.instructions:,}", f"{outcome.instructions:,}")


def _compare(question: Question, given: str) -> Mark:
    if _plain(given) in [_plain(right) for right in question.answer]:
        return Mark(question.name, question.points, question.points)
    slips = {_plain(slip): hint for slip, hint in question.slips.items()}
    hint = slips.get(_plain(given), question.hint)
    return Mark(question.name, 0, question.points, (Failure("answer", "", given or "nothing"),), hint)


def _plain(answer: str) -> str:
    """Return an answer without what does not matter: case, blanks, commas between digits, leading zeros."""
    words = answer.lower().replace(",", "").split()
    return " ".join(word.lstrip("0") or "0" for word in words)
