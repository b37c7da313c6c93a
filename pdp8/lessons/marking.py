"""Points and failures: an answer held against every case or question of its exercise.

A case gives its points when everything it looks at is as expected in every trial, and none otherwise; the
first trial that fails is shown. An answer that breaks a rule on its source, a limit of words or a word it
must or must not have, gets no points at all. Of a hidden case nothing is kept but what was wrong.
"""

from collections.abc import Iterator
from dataclasses import dataclass, replace

from pdp8.computer.stop import Reason
from pdp8.computer.use.program import FOUND
from pdp8.lessons import diagnosis, evidence, hints, trial, values
from pdp8.lessons.answer import Answer, assembled
from pdp8.lessons.exercise import Case, Exercise, Question, Trial
from pdp8.lessons.trial import Outcome
from tapes import rim
from tapes.quantities import counted

_PRINTS = (0o6044, 0o6046)
"""TPC and TLS."""
_TOGETHER = 6
"""Trials of each case in which a common pattern is looked for."""


@dataclass(frozen=True)
class Failure:
    """One wrong result; bytes are a tape. `happened` is a word of diagnosis; a hidden case has no values."""

    what: str
    expected: str | bytes
    got: str | bytes
    happened: str = diagnosis.RESULT


@dataclass(frozen=True)
class Mark:
    """The mark of a case or question, with a failed trial's `inputs`; a `given` answer has no mark."""

    name: str
    points: int
    of: int
    failures: tuple[Failure, ...] = ()
    hint: str = ""
    inputs: str = ""
    hidden: bool = False
    given: bool = False


@dataclass(frozen=True)
class Result:
    """The marks of one answer; where there are none, `fault` says why."""

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
        """Whether every mark is right, and none is unknown."""
        return not self.fault and not any(mark.failures or mark.given for mark in self.marks)


def mark(exercise: Exercise, answer: Answer, dialect: str = FOUND) -> Result:
    """Return the marks of `answer`; whatever it is, no error is raised."""
    if exercise.cases:
        answer = assembled(answer, dialect)
    fault = answer.fault or _broken(exercise, answer)
    if fault:
        return Result(answer.name, (), exercise.points, fault)
    lines = answer.lines()
    marks = _cases(exercise, answer)
    marks += [_compare(question, lines.get(question.name.lower(), "")) for question in exercise.questions]
    return Result(answer.name, tuple(marks), exercise.points)


def _broken(exercise: Exercise, answer: Answer) -> str:
    """Return the rule of the exercise that the source breaks."""
    source = exercise.source
    names = [question.name for question in exercise.questions]
    if names and not any(name.lower() in answer.lines() for name in names):
        return f"no line begins with the name of a question; write a line for each, such as {names[0]}: ..."
    items = answer.items()
    if (source.required or source.forbidden) and not answer.source:
        return "this exercise looks at the source: hand in PAL, not a tape"
    for item in source.required:
        if item not in items:
            return f"this exercise requires {item}"
    for item in source.forbidden:
        if item in items:
            return f"this exercise forbids {item}"
    if source.words is not None and len(answer.words) > source.words:
        return f"{counted(len(answer.words), 'words')} of core; at most {source.words} are allowed"
    for place in source.spare:
        if int(place, 8) in answer.words:
            return f"the word {place} is spare: this exercise puts its own there"
    missing = [trial.missing(answer, each) for case in exercise.cases for each in case.trials]
    name = next((each for each in missing if each), "")
    return f"the tag {name} is missing; the exercise looks for it" if name else ""


def _cases(exercise: Exercise, answer: Answer) -> list[Mark]:
    """Return the mark of each case, with a hint for one that failed."""
    patterns: dict[str, str] = {}
    marks: list[Mark] = []
    for case in exercise.cases:
        found = _case_failed(case, answer)
        if found is None:
            marks.append(Mark(case.name, case.points, case.points, hidden=case.hidden))
            continue
        wrong = found.failures[0]
        result = wrong.happened not in diagnosis.ENDS
        if result and wrong.what not in patterns:
            patterns[wrong.what] = _pattern(exercise, answer, wrong.what)
        applies = result and "" in case.hints and _starts_once(found, answer)
        hint = hints.hint(
            hints.Failed(
                case,
                [failure.happened for failure in found.failures],
                [failure.what for failure in found.failures],
                found.trial.stop,
                general=case.hints[""] if applies else "",
                pattern=patterns[wrong.what] if result else "",
                prints=any(word in _PRINTS for word in answer.words.values()),
                first=not marks,
                first_right=bool(marks) and not marks[0].failures,
            )
        )
        marks.append(_failed(case, found, hint))
    return marks


@dataclass(frozen=True)
class Failed:
    """A START with a wrong result: its trial, outcome, failures; `whole`: the trial with all STARTs."""

    whole: Trial
    trial: Trial
    outcome: Outcome
    failures: list[Failure]


def first_failed(answer: Answer, whole: Trial) -> Failed | None:
    """Return the first START of a trial after which not all is as expected, None if all is."""
    outcomes = trial.run(answer, whole)
    for tried, outcome in zip([whole, *whole.again], outcomes, strict=True):
        failures = list(_failures(tried, answer, outcome, whole))
        if failures:
            return Failed(whole, tried, outcome, failures)
    failures = list(_looked_at(answer, whole))
    return Failed(whole, whole, outcomes[-1], failures) if failures else None


def _case_failed(case: Case, answer: Answer) -> Failed | None:
    """Return the first trial of a case that failed, or None; a program that wrote over itself failed."""
    for whole in case.trials:
        found = first_failed(answer, whole)
        if found is not None:
            over = trial.overwritten(answer, whole, found.outcome)
            # a program that was left executes its data on the way
            if over is not None and found.failures[0].happened != diagnosis.LEFT:
                said = f"a write over itself at {over:04o}"
                found.failures.append(Failure("the program", "", said, diagnosis.ITSELF))
            return found
    return None


def _failed(case: Case, found: Failed, hint: str) -> Mark:
    """Return the mark of a case that failed."""
    if case.hidden:
        bare = tuple(Failure(failure.what, "", "", failure.happened) for failure in found.failures)
        return Mark(case.name, 0, case.points, bare, hint, hidden=True)
    several = len(case.trials) > 1 or found.whole.again
    inputs = _inputs(found.trial) if several else ""
    if found.outcome.number > 0 and found.whole.again:
        inputs = f"start {found.outcome.number + 1}, {inputs}".removesuffix(", ")
    return Mark(case.name, 0, case.points, tuple(found.failures), hint, inputs)


def _starts_once(found: Failed, answer: Answer) -> bool:
    """Whether the first START was right, so that hints for several STARTs fit."""
    if found.whole.starts == 1:
        return found.outcome.number > 0 or not found.whole.again
    return first_failed(answer, replace(found.whole, starts=1, again=())) is None


def _pattern(exercise: Exercise, answer: Answer, what: str) -> str:
    """Return the pattern that all trials show in a word, in AC or in characters."""
    words: list[evidence.Word] = []
    texts: list[evidence.Text] = []
    trials = [each for case in exercise.cases if not case.hidden for each in case.trials[:_TOGETHER]]
    for each in trials:
        tried = trial.Tried(answer, each)
        outcome = tried.outcome(0)
        if each.stop not in ("any", outcome.stop.reason) or outcome.stop.reason is Reason.BREAKPOINT:
            continue
        inputs = {place: word for place, word in each.deposit.items() if isinstance(word, int)}
        if what == "AC" and each.ac is not None:
            words.append(evidence.Word(inputs, 0, each.ac, outcome.ac))
        elif what in each.core:
            at = answer.address(what)
            own = {place: word for place, word in inputs.items() if place != what}
            words.append(evidence.Word(own, outcome.before[at], each.core[what], outcome.core[at]))
        elif what == "the page" and each.page is not None:
            texts.append(
                evidence.Text([], [ord(one) for one in each.page], [ord(one) for one in outcome.page])
            )
        elif what == "the tape" and each.tape is not None:
            read = each.reader if len(each.reader) > 0 else each.keys
            texts.append(evidence.Text(read, each.tape, _punched(each, outcome)))
    return evidence.of_words(what, words) or evidence.of_characters(texts, what == "the tape")


def _inputs(tried: Trial) -> str:
    """Return the inputs of a trial on one line."""
    said = [
        f"{place} = {word if isinstance(word, str) else f'{word:04o}'}"
        for place, word in tried.deposit.items()
    ]
    if tried.sr:
        said.append(f"switches {tried.sr:04o}")
    if tried.reader:
        said.append(f"tape {_frames(tried.reader)}")
    if tried.keys:
        said.append(f"keys {_frames(tried.keys)}")
    return ", ".join(said)


def _frames(frames: bytes) -> str:
    more = " ..." if len(frames) > 24 else ""
    return " ".join(f"{frame:03o}" for frame in frames[:24]) + more


def _failures(tried: Trial, answer: Answer, outcome: Outcome, whole: Trial) -> Iterator[Failure]:
    stop = outcome.stop
    if tried.stop not in ("any", stop.reason) or stop.reason is Reason.BREAKPOINT:
        happened, got = diagnosis.end(answer, tried, outcome, whole)
        yield Failure("the end", diagnosis.WANTED[tried.stop], got, happened)
    elif tried.done and outcome.printing:
        yield Failure("the end", "a halt when the last character is done", "a halt while it is printed")
    for place, word in tried.core.items():
        found = outcome.core[answer.address(place)]
        if found != word:
            yield Failure(place, f"{word:04o}", f"{found:04o}", diagnosis.word(word, found))
    yield from _registers(tried, outcome)
    for place in tried.changed:
        address = answer.address(place)
        if outcome.core[address] == outcome.before[address]:
            yield Failure(place, "another word", f"{outcome.core[address]:04o}, as before")
    for place in tried.unchanged:
        address = answer.address(place)
        if outcome.core[address] != outcome.before[address]:
            before, after = f"{outcome.before[address]:04o}, as before", f"{outcome.core[address]:04o}"
            yield Failure(place, before, after)
    yield from _products(tried, answer, outcome)
    if tried.instructions is not None and outcome.instructions > tried.instructions:
        yield Failure("instructions", f"at most {tried.instructions:,}", f"{outcome.instructions:,}")
    if tried.takes is not None and not tried.takes[0] <= stop.elapsed <= tried.takes[1]:
        least, most, got = [f"{time:.7f}".rstrip("0").rstrip(".") for time in (*tried.takes, stop.elapsed)]
        yield Failure("the time", f"{least} to {most} s", f"{got} s")


def _registers(tried: Trial, outcome: Outcome) -> Iterator[Failure]:
    if tried.ac is not None and tried.ac != outcome.ac:
        happened = diagnosis.word(tried.ac, outcome.ac)
        yield Failure("AC", f"{tried.ac:04o}", f"{outcome.ac:04o}", happened)
    if tried.link is not None and tried.link != outcome.link:
        yield Failure("L", f"{tried.link}", f"{outcome.link}")


def _products(tried: Trial, answer: Answer, outcome: Outcome) -> Iterator[Failure]:
    if tried.page is not None and tried.page != outcome.page:
        yield Failure("the page", tried.page, outcome.page, diagnosis.sequence(tried.page, outcome.page))
    tape = _program(answer, outcome) if tried.itself else tried.tape
    punched = _punched(tried, outcome)
    if tape is not None and tape != punched:
        yield Failure("the tape", tape, punched, diagnosis.sequence(tape, punched))


def _punched(tried: Trial, outcome: Outcome) -> bytes:
    """Return the frames that were punched, without blank ones if these are ignored."""
    counts = tried.nul != "ignored"
    return bytes(frame for frame in outcome.tape if counts or frame & 0o177)


def _looked_at(answer: Answer, whole: Trial) -> Iterator[Failure]:
    """Yield faults in how an answer works although its results are right."""
    if not (whole.executed or whole.callers or whole.indirect):
        return
    seen = trial.looks(answer, whole)
    for place, times in whole.executed.items():
        done = seen.executed.get(answer.address(place), 0)
        if done < times:
            yield Failure(
                place, f"executed {counted(times, 'times')} at least", f"executed {counted(done, 'times')}"
            )
    for place, times in whole.callers.items():
        places = len(seen.callers.get(answer.address(place), ()))
        if places < times:
            yield Failure(place, f"called from {counted(times, 'places')} at least", f"called from {places}")
    pointers = [answer.address(place) for place in whole.indirect if trial.has(answer, place)]
    if whole.indirect and not any(address in seen.pointers for address in pointers):
        wanted = f"{whole.indirect[0]} to {whole.indirect[-1]}"
        yield Failure("the pointer", f"a word of {wanted}, used by I", "none of them")


def _program(answer: Answer, outcome: Outcome) -> bytes:
    """Return the answer's words before the start as a RIM tape has them, without leader and trailer."""
    words = {address: outcome.before[address] for address in answer.words}
    return bytes(frame for frame in rim.encode(words) if frame < 0o200)


def _compare(question: Question, given: str) -> Mark:
    if question.unmarked:
        failures = () if given else (Failure("answer", "", "nothing"),)
        return Mark(question.name, 0, 0, failures, given=bool(given))
    if values.right(question, given):
        return Mark(question.name, question.points, question.points)
    hint = values.hint(question, given)
    return Mark(question.name, 0, question.points, (Failure("answer", "", given or "nothing"),), hint)
