"""An exercise's file, in TOML. docs/lessons.md says what may stand in it, tables.py what each table may have.

The same tables in JSON are a student's form (student.py).
"""

import json
import os
import re
import tomllib
import zlib
from typing import Any

from pdp8 import shelf
from pdp8.lessons import diagnosis, draw, values
from pdp8.lessons.answer import Answer
from pdp8.lessons.exercise import Case, Exercise, Question, Source, Trial
from pdp8.lessons.tables import CASE, EXERCISE, QUESTION, SOURCE, TRIAL, ExerciseError, table, tables
from tapes.errors import called
from tapes.text import lines_of

FOLDER = os.path.join(shelf.beside(__file__), "exercises")
SEED = 1
_DEEP = re.compile(r"\s*\[{0,2}\s*[\w\"'-]+(?:\s*\.\s*[\w\"'-]+){32,}\s*\]{0,2}\s*")
"""A key of so many parts that tomllib, whose time grows with their square, would take too long."""


def bundled() -> list[str]:
    """Return the names of the bundled exercises, sorted."""
    return sorted(name.removesuffix(".toml") for name in os.listdir(FOLDER) if name.endswith(".toml"))


def title(name: str) -> str:
    """Return the title of the bundled exercise `name`."""
    with open(os.path.join(FOLDER, f"{name}.toml"), "rb") as file:
        return str(tomllib.load(file)["title"])


def read(name: str, seed: int = SEED) -> Exercise:
    """The exercise in file `name`, or bundled; `seed` draws its cases. Raises ExerciseError, ShelfError."""
    stem = name.removesuffix(".toml").removesuffix(".json")
    path = name
    if stem in bundled() and (os.path.isdir(name) or not os.path.exists(name)):
        path = os.path.join(FOLDER, f"{stem}.toml")
    if not os.path.exists(path):
        raise ExerciseError(f"{name}: no such file, and no bundled exercise ({', '.join(bundled())})")
    try:
        return parse(shelf.read_text(path), os.path.basename(stem), seed, os.path.dirname(path))
    except ExerciseError as error:
        cure = "; an exercise in TOML is wanted first, then the answers"
        said = f"{called(name)}{str(error).removeprefix(os.path.basename(stem))}"
        raise ExerciseError(said + cure * (not path.endswith((".toml", ".json")))) from error


def variant(name: str, seed: int) -> int:
    """Return the seed of student `name` in a class with `seed`."""
    return zlib.crc32(f"{seed} {name}".encode())


def parse(text: str, name: str, seed: int = SEED, folder: str = "") -> Exercise:
    """Return the exercise in `text`, which may name files in `folder`. Raises ExerciseError."""
    try:
        if any(_DEEP.fullmatch(line.partition("=")[0]) for line in lines_of(text)):
            raise RecursionError
        given = (json if text.lstrip().startswith("{") else tomllib).loads(text)
    except RecursionError:
        raise ExerciseError(f"{name}: nested too deeply") from None
    except ValueError as error:
        raise ExerciseError(f"{name}: {error}") from error
    found = table(given, name, EXERCISE)
    solution = _solution(found.pop("solution", ""), name, folder)
    cases = [_case(case, f"{name}: case {number}") for number, case in enumerate(found.pop("case", ()), 1)]
    cases += [draw.case(random, f"{name}: random {number}", solution, seed, folder)
              for number, random in enumerate(found.pop("random", ()), 1)]  # fmt: skip
    questions = tuple(_question(question, f"{name}: question {number}")
                      for number, question in enumerate(found.pop("question", ()), 1))  # fmt: skip
    if bool(cases) == bool(questions):
        raise ExerciseError(f"{name}: give [[case]] tables for a program, or [[question]] tables for a sheet")
    source = Source(**table(found.pop("program", {}), f"{name}: program", SOURCE))
    made = Exercise(
        name=name, source=source, cases=tuple(cases), questions=questions, solution=solution, **found
    )
    for case in made.cases:
        _check_hints(case, f"{name}: {case.name}")
    for question in questions:
        if [*Answer("", source=f"{question.name}: 1").lines().items()] != [(question.name.lower(), "1")]:
            raise ExerciseError(
                f"{name}: no line of a sheet can begin with {question.name!r}: a question's name is one word"
            )
    names = [each.lower() for each in made.names] if questions else made.names
    twice = next((each for at, each in enumerate(made.names) if names[at] in names[:at]), None)
    if twice is not None:
        raise ExerciseError(f"{name}: two cases or questions are called {twice!r}")
    return made


def _solution(given: object, name: str, folder: str) -> str:
    if isinstance(given, dict) and set(given) == {"file"}:
        return shelf.read_text(os.path.join(folder, str(given["file"])))
    if isinstance(given, str):
        return given
    raise ExerciseError(f"{name}: solution: a text or {{ file = name }} is wanted, not {given!r}")


def _case(given: object, where: str) -> Case:
    found = table(given, where, {**CASE, **TRIAL, "trial": tables, "again": tables})
    trials = [
        _trial(
            table(each, f"{where}: trial {number}", {**TRIAL, "again": tables}), f"{where}: trial {number}"
        )
        for number, each in enumerate(found.pop("trial", ()), 1)
    ]
    single = {key: found.pop(key) for key in (*TRIAL, "again") if key in found}
    if trials and single:
        raise ExerciseError(f"{where}: {next(iter(single))} belongs in its trials")
    return Case(trials=tuple(trials) or (_trial(single, where),), hints=found.pop("hint", {}), **found)


def _check_hints(case: Case, where: str) -> None:
    """Raise ExerciseError for a hint that can never be shown."""
    places = {
        place
        for first in case.trials
        for each in (first, *first.again)
        for place in (*each.core, *each.changed, *each.unchanged, *each.executed, *each.callers)
    }
    known = ["", *diagnosis.ENDS, *diagnosis.RESULTS, *diagnosis.LOOKED_AT, *sorted(places)]
    unknown = next((key for key in case.hints if key not in known), None)
    if unknown is not None:
        raise ExerciseError(f"{where}: hint: nothing is called {unknown!r}; there are {', '.join(known[1:])}")


def _trial(found: dict[str, Any], where: str) -> Trial:
    """Return a trial; each `again` inherits its start, stop and seconds."""
    others = found.pop("again", ())
    common = {key: found[key] for key in ("start", "stop", "seconds") if key in found}
    again = tuple(Trial(**common | table(each, f"{where}: again {number}", TRIAL))
                  for number, each in enumerate(others, 1))  # fmt: skip
    return Trial(**found, again=again)


def _question(given: object, where: str) -> Question:
    found = table(given, where, QUESTION)
    answer = found.pop("answer", ())
    unit = found.get("unit", "")
    if unit == values.OCTAL:
        for each in answer if isinstance(answer, tuple) else [answer]:
            if not re.fullmatch("-?[0-7]+", str(each)):
                raise ExerciseError(
                    f'{where}: answer: octal digits in quotes are wanted, as "-35", not {each!r}'
                )
    if isinstance(answer, tuple):
        return Question(answer=answer, **found)
    if unit and not values.known(unit):
        raise ExerciseError(
            f"{where}: unit: {unit!r} is not one of {', '.join([*values.UNITS, values.OCTAL])}"
        )
    return Question(number=answer, **found)
