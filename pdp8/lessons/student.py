"""The student's form of an exercise, in JSON: no solution, mistakes, hidden cases, nor answers of a sheet,
which it does not mark.

Random cases are written out with their expected results, drawn from another seed than the teacher's: so they
are marked without the solution. The command reads it like TOML, and so do pages.
"""

import json
from collections.abc import Iterable, Mapping
from dataclasses import MISSING, Field, fields
from typing import Any

from pdp8.lessons.exercise import Case, Exercise, Question, Trial

SEED = 0
_SHOWN = 3
"""Trials of a random case that a student gets."""


def form(exercise: Exercise) -> str:
    """Return the JSON of the student's form."""
    cases = [case for case in exercise.cases if not case.hidden]
    questions = [Question(each.name, each.ask, points=each.points) for each in exercise.questions]
    found = tables(exercise, cases, questions, _SHOWN)
    if others := exercise.others + len(exercise.cases) - len(cases):
        found["others"] = others
    return json.dumps(found, indent=1, ensure_ascii=False) + "\n"


def whole(exercise: Exercise) -> dict[str, Any]:
    """Return the tables for marking: every case and every answer of a sheet, but no solution."""
    return tables(exercise, exercise.cases, exercise.questions)


def tables(
    exercise: Exercise, cases: Iterable[Case], questions: Iterable[Question], trials: int | None = None
) -> dict[str, Any]:
    """Return an exercise as its file has it, ready for JSON, with at most `trials` of each case."""
    found = {
        "title": exercise.title,
        "task": exercise.asked,
        "program": _table(exercise.source),
        "case": [{**_table(case), "trial": list(map(_table, case.trials[:trials]))} for case in cases],
        "question": list(map(_table, questions)),
    }
    return {key: value for key, value in found.items() if value}


_CALLED = {"hints": "hint", "number": "answer"}
"""Fields that have another name in a file."""


def _table(of: Any) -> dict[str, Any]:
    """Return the keys of a table whose values are not the default."""
    return {
        _CALLED.get(each.name, each.name): _value(value)
        for each in fields(of)
        if each.name != "trials" and (value := getattr(of, each.name)) != _default(each)
    }


def _default(each: "Field[object]") -> object:
    return each.default_factory() if each.default_factory is not MISSING else each.default


def _value(value: object) -> object:
    """Return a value for JSON; a table as pairs, since JavaScript would put its numbers into order."""
    if isinstance(value, Mapping):
        return [[key, each] for key, each in value.items()]
    if isinstance(value, bytes | tuple):
        return [_table(each) if isinstance(each, Trial) else each for each in value]
    return value
