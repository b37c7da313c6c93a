"""Exercises in the page: what `pdp8 check` says of solutions and wrong answers, the page's marks say too."""

from typing import Any

import pytest

from pdp8.lessons import form, handed, marking, student
from pdp8.lessons.exercise import Exercise
from pdp8.lessons.page import body
from tests.pdp8.web.node import in_node, needs_node

pytestmark = needs_node

_MARKS = """async (asked) => {
  const { marks } = await import("@/pdp8/web/bench/marker.mjs");
  return asked.map(({ tables, name, source }) => marks(tables, name, source));
}"""
_WRONG = 5


def _answers(exercise: Exercise) -> list[str]:
    """Return the solution, five wrong answers, and what does not assemble."""
    answers = [exercise.solution]
    answers += [exercise.solution.replace(*edit) for edit in list(exercise.mistakes.values())[:_WRONG]]
    for question in exercise.questions:
        answers += [f"{question.name}: {slip}\n" for slip in question.slips]
    return [*answers, "*200\n\tTAB A\n$\n"]


def _marks(exercise: Exercise, source: str) -> dict[str, Any]:
    result = marking.mark(exercise, handed.of(source.encode(), "a.pal"))
    said = {"right": result.right, "points": result.points, "of": result.of}
    return {**said, "html": "\n".join(body(result))}


@pytest.mark.slow  # two hundred answers, twice
def test_the_page_marks_as_the_command_does() -> None:
    """Each bundled exercise: its solution, wrong answers, faults; verdicts, hints and what is shown."""
    asked, wanted = [], []
    for name in form.bundled():
        exercise = form.read(name)
        for source in _answers(exercise):
            asked.append({"tables": student.whole(exercise), "name": "a.pal", "source": source})
            wanted.append((name, source, _marks(exercise, source)))
    for (name, source, marks), found in zip(wanted, in_node(_MARKS, asked), strict=True):
        assert found == marks, f"{name}\n{source}"


def test_a_students_form_is_marked_without_what_is_hidden() -> None:
    exercise = form.read("delay", student.SEED)
    given = form.parse(student.form(exercise), "delay")
    asked = {"tables": student.whole(given), "name": "a.pal", "source": exercise.solution}
    (found,) = in_node(_MARKS, [asked])
    assert found == _marks(given, exercise.solution)
    assert found["right"]
    assert found["of"] < exercise.points
