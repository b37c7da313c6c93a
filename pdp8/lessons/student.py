"""The student's form of an exercise: its file without solution, mistakes, hidden cases and a sheet's answers.

Random cases stand in it as cases, drawn from a seed of their own and with what is expected: the checker needs
no solution to mark them, and the teacher's are others.
"""

import json
from collections.abc import Iterator, Mapping
from dataclasses import MISSING, Field, fields

from pdp8.lessons.exercise import Case, Exercise, Question, Source, Trial

SEED = 0
_SHOWN = 3
"""Trials of a random case that a student gets."""


def form(exercise: Exercise) -> str:
    """Return the TOML of the student's form."""
    lines = [f"title = {_value(exercise.title)}", f"task = {_value(exercise.task)}"]
    source = list(_keys(exercise.source))
    lines += ["", "[program]", *source] * bool(source)
    for case in exercise.cases:
        if not case.hidden:
            lines += ["", *_case(case)]
    for question in exercise.questions:
        lines += ["", *_question(question)]
    return "\n".join(lines) + "\n"


def _case(case: Case) -> Iterator[str]:
    yield "[[case]]"
    yield f"name = {_value(case.name)}"
    if case.points != 1:
        yield f"points = {case.points}"
    if case.hints:
        yield f"hint = {_value(case.hints)}"
    if len(case.trials) == 1:
        yield from _keys(case.trials[0])
        return
    for trial in case.trials[:_SHOWN]:
        yield "[[case.trial]]"
        yield from _keys(trial)


def _question(question: Question) -> Iterator[str]:
    yield "[[question]]"
    yield f"name = {_value(question.name)}"
    yield f"ask = {_value(question.ask)}"
    if question.points != 1:
        yield f"points = {question.points}"


def _keys(table: Trial | Source) -> Iterator[str]:
    """Yield the keys of a table that are not as they are if not given."""
    for each in fields(table):
        value = vars(table)[each.name]
        if value != _default(each):
            yield f"{each.name} = {_value(value)}"


def _default(each: "Field[object]") -> object:
    return each.default_factory() if each.default_factory is not MISSING else each.default


def _value(value: object) -> str:
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, str):
        return json.dumps(value, ensure_ascii=False).replace("\x7f", "\\u007F")
    if isinstance(value, bytes):
        return "[" + ", ".join(f"0o{frame:03o}" for frame in value) + "]"
    if isinstance(value, Mapping):
        return "{ " + ", ".join(f"{_value(key)} = {_value(each)}" for key, each in value.items()) + " }"
    if isinstance(value, tuple):
        return "[" + ", ".join(map(_value, value)) + "]"
    return repr(value)
