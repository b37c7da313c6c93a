"""Exercises in the page: what `pdp8 check` says of solutions and wrong answers, the page's marks say too."""

import json
import random

import pytest

from pdp8.computer.past.state import save
from pdp8.lessons import form, handed, marking, student, where
from pdp8.lessons.answer import assembled
from pdp8.lessons.exercise import Exercise
from pdp8.lessons.page import body
from tests.pdp8.web.node import called, modules, needs_node
from tests.sampling import WHOLE, some


def _answers(exercise: Exercise) -> list[str]:
    """Return the solution, some wrong answers, and what does not assemble."""
    wrong = [
        exercise.solution.replace(*edit) for edit in list(exercise.mistakes.values())[: 5 if WHOLE else 2]
    ]
    slips = [f"{question.name}: {slip}\n" for question in exercise.questions for slip in question.slips]
    return [exercise.solution, *wrong, *slips, "*200\n\tTAB A\n$\n"]


@needs_node
@pytest.mark.slow  # two hundred answers, twice
def test_the_page_marks_as_the_command_does() -> None:
    """Each bundled exercise: its solution, wrong answers, faults; verdicts, hints and what is shown;
    of two the student's form too.
    """
    wholes = map(form.read, form.bundled())
    answers = [(each, student.whole(each), source) for each in wholes for source in _answers(each)]
    for name in ("echo", "read-a-frame"):
        text = student.form(whole := form.read(name))
        answers.append((form.parse(text, name), json.loads(text), whole.solution))
    marker = "pdp8/web/bench/marker"
    asked = ((marker, "marks", tables, "a.pal", source) for _, tables, source in answers)
    there = called(*asked, folder=modules(checked=False))
    for (exercise, _, source), marks in zip(answers, there, strict=True):
        result = marking.mark(exercise, handed.of(source.encode(), "a.pal"))
        said = {"right": result.right, "points": result.points, "of": result.of}
        wrong = ["" if mark.hidden else mark.name for mark in result.marks if mark.failures]
        assert marks == {**said, "said": "\n".join(body(exercise, result)), "wrong": wrong}, source


@needs_node
def test_the_page_finds_the_place_that_the_command_finds() -> None:
    """Of a wrong answer to each of some exercises: what it says, the machine at START, also a second
    one, and how far from there it is.
    """
    asked, wanted = [], []
    for name in ("add", "echo", "larger", "message", "multiply", "step-wise"):
        exercise = form.read(name)
        source = exercise.solution.replace(*next(iter(exercise.mistakes.values())))
        answer = assembled(handed.of(source.encode(), "a.pal"))
        marks = marking.mark(exercise, answer).marks
        case = next(case for case, mark in zip(exercise.cases, marks, strict=False) if mark.failures)
        whole, failed = next(
            (each, found) for each in case.trials if (found := marking.first_failed(answer, each))
        )
        place = where.find(answer, whole, failed)
        asked.append(
            ("pdp8/web/bench/marker", "located", student.whole(exercise), "a.pal", source, case.name)
        )
        machine = where.standing(answer, whole, failed.outcome.number)
        wanted.append((place.says, place.instructions, json.loads(save(machine))))
    there = [(each["says"], each["until"], json.loads(each["state"])) for each in called(*asked)]
    assert there == wanted


_ODD = (
    "\f",
    "\v",
    "\x1c",
    "\x85",
    "\u2028",
    "\r",
    "\r\n",
    "\n",
    "\xa0",
    "é",
    "€",
    "\U0001f600",
    "\x7f",
    "\t",
    "\x01",
    "\x0e",
    "\x12",
    "\x1d",
    "\ufeff",
)


def _odd(draw: random.Random, source: str) -> str:
    """Return a source with a few odd characters put in, most of them in comments."""
    for _ in range(draw.choice((1, 2, 5, 20))):
        at = draw.randrange(len(source) + 1)
        if draw.random() < 0.6:
            at = source.find("\n", at) if source.find("\n", at) >= 0 else len(source)
            source = f"{source[:at]} / {draw.choice(_ODD)}{draw.choice('AL5')} {source[at:]}"
        else:
            source = source[:at] + draw.choice(_ODD) + source[at:]
    return source


@needs_node
@pytest.mark.slow("marks 500 answers twice by WHOLE=1")
def test_odd_characters_and_line_ends_have_the_same_marks() -> None:
    draw = random.Random(53)
    wholes = [form.read(name) for name in form.bundled()]
    exercises = [(each, student.whole(each)) for each in wholes]
    answers = [(*draw.choice(exercises),) for _ in range(some(500))]
    sources = [_odd(draw, exercise.solution) for exercise, _ in answers]
    asked = zip(answers, sources, strict=True)
    calls = (("pdp8/web/bench/marker", "marks", tables, "a.pal", text) for (_, tables), text in asked)
    there = called(*calls, folder=modules(checked=False))
    for (exercise, _), source, marks in zip(answers, sources, there, strict=True):
        result = marking.mark(exercise, handed.of(source.encode(), "a.pal"))
        assert (marks["right"], marks["points"]) == (result.right, result.points), (exercise.name, source)
