"""Tests of an exercise: its solution gets all points, however it is written; mistakes do not; and the task
mentions whatever is checked.
"""

import re
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from random import Random

from pdp8.lessons import handed, mutants, trial
from pdp8.lessons.answer import Answer, assembled, tag
from pdp8.lessons.exercise import Exercise, Trial
from pdp8.lessons.marking import Result, first_failed, mark
from pdp8.lessons.tables import ExerciseError

SLIPS = 100
"""Slips that are tried, of all that there are."""
_SEEDS = 3
"""Seeds whose random cases a slip is tried on."""
_LONGER = 10
"""How much longer than the solution a slip may take."""


def solution(exercise: Exercise) -> Result:
    """Return the marks of the exercise's own solution. Raises ExerciseError where it has no answers."""
    for question in exercise.questions:
        if question.unmarked:
            raise ExerciseError(f"{exercise.name}: question {question.name!r}: answer is missing")
    return _marked(exercise, exercise.solution, "the solution")


def mistakes(exercise: Exercise) -> Iterator[tuple[str, Result]]:
    """Yield each known mistake with its marks. Raises ExerciseError if it does not fit the solution once."""
    for what, (piece, instead) in exercise.mistakes.items():
        if exercise.solution.count(piece) != 1 or piece == instead:
            count = exercise.solution.count(piece)
            raise ExerciseError(
                f"{exercise.name}: mistake {what!r}: {piece!r} stands {count} times in the solution, not once"
            )
        yield what, _marked(exercise, exercise.solution.replace(piece, instead), what)
    sheet = handed.of(exercise.solution.encode(), "the solution").lines()
    for question in exercise.questions:
        for slip in question.slips:
            lines = {**sheet, question.name.lower(): slip}
            text = "".join(f"{name}: {line}\n" for name, line in lines.items())
            yield f"{question.name}: {slip}", _marked(exercise, text, slip)


def _marked(exercise: Exercise, text: str, name: str) -> Result:
    return mark(exercise, handed.of(text.encode(), name))


def restated(exercise: Exercise) -> list[tuple[str, Result]]:
    """Return the marks of the solution written in other ways, after each way."""
    if not exercise.cases:
        return []
    source, trials = exercise.source, [each for case in exercise.cases for each in _all(case.trials)]
    kept = {
        *source.required,
        *source.forbidden,
        *(tag(place)[0] for each in trials for place in _places(each)),
    }
    counted = source.words or any(each.itself or each.takes or each.instructions for each in trials)
    places = [int(place, 8) for each in trials for place in _places(each) if place[0].isdigit()]
    written = mutants.restatements(
        exercise.solution, kept, longer=not counted, elsewhere=max(places, default=0) < mutants.ELSEWHERE
    )
    return [(how, _marked(exercise, text, how)) for how, text in written if text != exercise.solution]


@dataclass(frozen=True)
class Slips:
    """How many slips there are and were tried, and those taken for right: with one seed, or with all."""

    number: int
    tried: int
    lucky: list[str]
    survivors: list[str]


def slips(read: Callable[[int], Exercise], seed: int, most: int = SLIPS) -> Slips:
    """Try the slips of a solution, or a random sample of them. `read` returns the exercise by a seed."""
    if not read(seed).cases:
        return Slips(0, 0, [], [])
    exercises = [_bounded(read(seed + more)) for more in range(_SEEDS)]
    words = dict(_assembled(exercises[0].solution).words)
    found: dict[str, Answer] = {}
    for what, text in mutants.slips(exercises[0].solution):
        answer = _assembled(text)
        if not answer.fault and answer.words != words:
            found.setdefault(repr(sorted(answer.words.items())), replace(answer, name=what))
    drawn = [*found.values()]
    if len(drawn) > most:
        drawn = Random(seed).sample(drawn, most)
    taken = [answer for answer in drawn if _taken(exercises[0], answer)]
    lucky = [answer.name for answer in taken if not all(_taken(other, answer) for other in exercises[1:])]
    survivors = [answer.name for answer in taken if answer.name not in lucky]
    return Slips(len(found), len(drawn), lucky, survivors)


def _assembled(text: str) -> Answer:
    return assembled(handed.of(text.encode(), "the solution"))


def _taken(exercise: Exercise, answer: Answer) -> bool:
    """Tell whether every case accepts an answer."""
    trials = [each for case in exercise.cases for each in case.trials]
    if any(trial.missing(answer, each) for each in trials):
        return False
    return all(first_failed(answer, each) is None for each in trials)


def _bounded(exercise: Exercise) -> Exercise:
    """Return the exercise with a short time limit, enough for a slip."""
    answer = _assembled(exercise.solution)
    cases = []
    for case in exercise.cases:
        trials = []
        for each in case.trials:
            longest = max(outcome.stop.elapsed for outcome in trial.run(answer, each))
            seconds = each.seconds if each.stop == "limit" else min(each.seconds, longest * _LONGER + 0.1)
            again = tuple(replace(other, seconds=seconds) for other in each.again)
            trials.append(replace(each, seconds=seconds, again=again))
        cases.append(replace(case, trials=tuple(trials)))
    return replace(exercise, cases=tuple(cases))


_SAID = {
    "deposit": r"[A-Z]", "reader": r"tape|reader|frame", "keys": r"key|typed|tape", "sr": "switches",
    "ac": r"\bAC\b", "link": r"\bL\b|link", "instructions": "instructions", "takes": r"second|\bms\b",
    "tape": r"punch|print|echo|typ|tape", "page": r"print|typ|Teletype", "itself": "itself",
}  # fmt: skip
"""What a task has to mention, by the key of a trial that wants it."""


def untold(exercise: Exercise) -> Iterator[str]:
    """Yield what the cases use but the task does not mention: tags, addresses, restarts, limits."""
    asked = " ".join(exercise.asked.split())
    for case in exercise.cases:
        if not case.tests:
            yield f"{case.name}: tests is missing: the words of the task that this case tries"
        elif " ".join(case.tests.split()) not in asked:
            yield f"{case.name}: tests = {case.tests!r} is no quotation from the task"
        every = _all(case.trials)
        for place in dict.fromkeys(place for each in every for place in _places(each)):
            if not _told(place, asked):
                yield f"{case.name}: {place} is not mentioned"
        if any(each.starts > 1 or each.again for each in every) and not re.search(r"\bagain\b", asked):
            yield f"{case.name}: it is started again, which is not mentioned"
        for key, words in _SAID.items():
            plain = getattr(Trial(), key)
            if any(getattr(each, key) != plain for each in every) and not re.search(words, asked):
                yield f"{case.name}: {key} is checked or used, and not mentioned"


def _all(trials: tuple[Trial, ...]) -> list[Trial]:
    return [each for first in trials for each in (first, *first.again)]


def _places(each: Trial) -> list[str]:
    """Return the places that a trial uses."""
    pointers = [word for word in each.deposit.values() if isinstance(word, str)]
    looked = [*each.core, *each.changed, *each.unchanged, *each.executed, *each.callers, *each.indirect]
    return [*each.start[-1:], *each.deposit, *pointers, *looked]


def _told(place: str, asked: str) -> bool:
    """Tell whether a text mentions a place: a tag, an address, or a range around it."""
    if not place[0].isdigit():
        return re.search(rf"\b{tag(place)[0]}\b", asked) is not None
    address = int(place, 8)
    if re.search(rf"\b0*{address:o}\b", asked):
        return True
    for first, last in re.findall(r"\b([0-7]{2,4})(?: (?:to|and|or) ([0-7]{2,4})| and after| on\b)", asked):
        if int(first, 8) <= address <= int(last or "7777", 8):
            return True
    return False
