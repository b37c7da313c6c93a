"""That an exercise does its work: the solution has all points, and every mistake it knows is noticed."""

from collections.abc import Iterator

from pdp8.lessons import handed
from pdp8.lessons.exercise import Exercise
from pdp8.lessons.marking import Result, mark
from pdp8.lessons.tables import ExerciseError


def solution(exercise: Exercise) -> Result:
    """Return the marks of the exercise's own solution. Raises ExerciseError where it has no answers."""
    for question in exercise.questions:
        if question.unmarked:
            raise ExerciseError(f"{exercise.name}: question {question.name!r}: answer is missing")
    return _marked(exercise, exercise.solution, "the solution")


def mistakes(exercise: Exercise) -> Iterator[tuple[str, Result]]:
    """Yield each wrong answer the exercise knows with its marks: the solution after one mistake, or a sheet
    after one slip. Raises ExerciseError where a mistake does not change one place of the solution.
    """
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
