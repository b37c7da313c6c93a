"""An exercise's file, in TOML. docs/lessons.md says what may stand in it; a table below is each table's keys.

title = "Add two words"
task = "..."                          what the student is asked
solution = '''...'''                  the teacher's own answer, or { file = "add.pal" } beside the exercise
[program]                             words = 40, required = ["TAD"], forbidden = ["ISZ"]
[[case]]                              a program on one set of inputs, or on each [[case.trial]]
[[random]]                            a program on drawn inputs (draw.py)
[[question]]                          a line of a sheet
[mistakes]                            what students do wrong: a piece of the solution, what they write

The same tables in JSON are a student's form (student.py).
"""

import json
import os
import re
import tomllib
from collections.abc import Callable, Mapping
from typing import Any

from pdp8.lessons import values
from pdp8.lessons.exercise import Case, Exercise, Question, Source, Trial
from tapes import ascii, eia, shelf
from tapes.errors import WorkError

FOLDER = os.path.join(os.path.dirname(os.path.abspath(__file__)), "exercises")
SEED = 1
LONGEST = 3600
"""Seconds of machine time a case may be given."""
STOPS = ("halt", "tape out", "idle", "limit", "any")


class ExerciseError(WorkError):
    """An exercise that cannot be used; the message names the place in its file."""


def bundled() -> list[str]:
    """Return the names of the bundled exercises, sorted."""
    return sorted(name.removesuffix(".toml") for name in os.listdir(FOLDER) if name.endswith(".toml"))


def title(name: str) -> str:
    """Return the title of the bundled exercise `name`."""
    with open(os.path.join(FOLDER, f"{name}.toml"), "rb") as file:
        return str(tomllib.load(file)["title"])


def read(name: str, seed: int = SEED) -> Exercise:
    """Return the exercise in file `name`, or the bundled one; random cases by `seed`.

    Raises ExerciseError, ShelfError.
    """
    stem = name.removesuffix(".toml").removesuffix(".json")
    path = name if os.path.exists(name) or stem not in bundled() else os.path.join(FOLDER, f"{stem}.toml")
    if not os.path.exists(path):
        raise ExerciseError(f"{name}: no such file, and no bundled exercise ({', '.join(bundled())})")
    return parse(shelf.read_text(path), os.path.basename(stem), seed, os.path.dirname(path))


def parse(text: str, name: str, seed: int = SEED, folder: str = "") -> Exercise:
    """Return the exercise that `text` says, called `name`; the files it names are in `folder`.

    Raises ExerciseError.
    """
    from pdp8.lessons import draw

    try:
        deep = any(_DEEP.fullmatch(line.partition("=")[0]) for line in text.splitlines())
        given = {} if deep else (json if text.startswith("{") else tomllib).loads(text)
    except RecursionError:
        deep = True
    except ValueError as error:
        raise ExerciseError(f"{name}: {error}") from error
    if deep:
        raise ExerciseError(f"{name}: nested too deeply")
    found = table(given, name, _EXERCISE)
    solution = _solution(found.pop("solution", ""), name, folder)
    cases = [_case(case, f"{name}: case {number}") for number, case in enumerate(found.pop("case", ()), 1)]
    cases += [draw.case(random, f"{name}: random {number}", solution, seed, folder)
              for number, random in enumerate(found.pop("random", ()), 1)]  # fmt: skip
    questions = tuple(_question(question, f"{name}: question {number}")
                      for number, question in enumerate(found.pop("question", ()), 1))  # fmt: skip
    if bool(cases) == bool(questions):
        raise ExerciseError(f"{name}: give [[case]] tables for a program, or [[question]] tables for a sheet")
    source = Source(**table(found.pop("program", {}), f"{name}: program", _SOURCE))
    made = Exercise(
        name=name, source=source, cases=tuple(cases), questions=questions, solution=solution, **found
    )
    twice = next((each for at, each in enumerate(made.names) if each in made.names[:at]), None)
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
    found = table(given, where, {**CASE, **TRIAL, "trial": (_tables, False)})
    trials = [
        Trial(**table(each, f"{where}: trial {number}", TRIAL))
        for number, each in enumerate(found.pop("trial", ()), 1)
    ]
    single = {key: found.pop(key) for key in TRIAL if key in found}
    if trials and single:
        raise ExerciseError(f"{where}: {next(iter(single))} belongs into its trials")
    return Case(trials=tuple(trials) or (Trial(**single),), hints=found.pop("hint", {}), **found)


def _question(given: object, where: str) -> Question:
    found = table(given, where, _QUESTION)
    answer = found.pop("answer", ())
    if isinstance(answer, tuple):
        return Question(answer=answer, **found)
    if (unit := found.get("unit", "")) and not values.known(unit):
        raise ExerciseError(f"{where}: unit: {unit!r} is not one of {', '.join(values.UNITS)}")
    return Question(number=answer, **found)


Field = Callable[[Any], Any]
_DEEP = re.compile(r"\s*\[{0,2}\s*[\w\"'-]+(?:\s*\.\s*[\w\"'-]+){32,}\s*\]{0,2}\s*")
"""A key of so many parts as take tomllib the square of their number."""


def table(given: object, where: str, fields: Mapping[str, tuple[Field, bool]]) -> dict[str, Any]:
    """Return the values of a table, each converted by its field; those that must be there are."""
    if not isinstance(given, dict):
        raise ExerciseError(f"{where}: a table is wanted, not {given!r}")
    for key in given:
        if key not in fields:
            raise ExerciseError(f"{where}: no key is called {key!r}; there are {', '.join(fields)}")
    missing = [key for key, (_, needed) in fields.items() if needed and key not in given]
    if missing:
        raise ExerciseError(f"{where}: {missing[0]} is missing")
    try:
        return {(at := key): fields[key][0](value) for key, value in given.items()}
    except (ValueError, WorkError) as error:
        raise ExerciseError(f"{where}: {at}: {error}") from error


def _of(kind: type, called: str) -> Field:
    def convert(value: Any) -> Any:
        if not isinstance(value, kind):
            raise ValueError(f"{called} is wanted, not {value!r}")
        return value

    return convert


_text = _of(str, "a text")
_list = _of(list, "a list")
_tables = _of(list, "[[...]] tables")


def _mapping(value: Any) -> dict[str, Any]:
    """Return a table, which JSON may have as pairs."""
    try:
        return dict(value)
    except (TypeError, ValueError):
        raise ValueError(f"a table is wanted, not {value!r}") from None


def number(least: int, most: int) -> Field:
    def convert(value: Any) -> int:
        if not isinstance(value, int) or isinstance(value, bool) or not least <= value <= most:
            raise ValueError(f"a number from {least} to {most} is wanted, not {value!r}")
        return value

    return convert


def word(value: Any) -> int:
    found: int = number(-0o4000, 0o7777)(value)
    return found & 0o7777


def _words(value: Any) -> dict[str, int]:
    return {place(key): word(given) for key, given in _mapping(value).items()}


def _deposits(value: Any) -> dict[str, int | str]:
    return {
        place(key): place(given) if isinstance(given, str) else word(given)
        for key, given in _mapping(value).items()
    }


def _places(value: Any) -> tuple[str, ...]:
    return tuple(place(each) for each in _list(value))


def place(value: Any) -> str:
    """Return an address as four octal digits, or a symbol as it is."""
    text = f"{value:o}" if isinstance(value, int) and not isinstance(value, bool) else _text(value)
    if not text[:1].isdigit():
        return str(text)
    if not all(digit in "01234567" for digit in text) or int(text, 8) > 0o7777:
        raise ValueError(f"{text} is no octal address from 0000 to 7777")
    return f"{int(text, 8):04o}"


def _seconds(value: Any) -> float:
    if not isinstance(value, int | float) or isinstance(value, bool) or not 0 < value <= LONGEST:
        raise ValueError(f"seconds up to {LONGEST} are wanted, not {value!r}")
    return value


def _stop(value: Any) -> str:
    if value not in STOPS:
        raise ValueError(f"{value!r} is not one of {', '.join(STOPS)}")
    return str(value)


def frames(value: Any) -> bytes:
    r"""Return a tape: a text in ASCII, CR LF for "\n"; frames; {eia = text}; {file = name}."""
    if isinstance(value, str):
        return ascii.encode(value, fill=0)
    if isinstance(value, list):
        return bytes(number(0, 0o377)(each) for each in value)
    if isinstance(value, dict) and set(value) == {"eia"}:
        return eia.encode(_text(value["eia"]))
    if isinstance(value, dict) and set(value) == {"file"}:
        return shelf.read(_text(value["file"]))
    raise ValueError(f"a text, a list of frames, {{ eia = text }} or {{ file = name }} is wanted: {value!r}")


def _texts(value: Any) -> tuple[str, ...]:
    return tuple(_text(item) for item in ([value] if isinstance(value, str) else _list(value)))


def _slips(value: Any) -> dict[str, str]:
    return {key: _text(hint) for key, hint in _mapping(value).items()}


def _mistakes(value: Any) -> dict[str, tuple[str, str]]:
    def edit(pair: Any) -> tuple[str, str]:
        texts = _texts(pair)
        if len(texts) != 2:
            raise ValueError(f"[piece of the solution, what is written instead] is wanted, not {pair!r}")
        return texts[0], texts[1]

    return {what: edit(pair) for what, pair in _mapping(value).items()}


def _answer(value: Any) -> float | tuple[str, ...]:
    if isinstance(value, int | float) and not isinstance(value, bool):
        return float(value)
    return _texts(value)


def _hints(value: Any) -> dict[str, str]:
    return {"": value} if isinstance(value, str) else _slips(value)


def _tolerance(value: Any) -> float:
    if not isinstance(value, int | float) or isinstance(value, bool) or not value >= 0:
        raise ValueError(f"a number of 0 or more is wanted, not {value!r}")
    return float(value)


def _takes(value: Any) -> tuple[float, float]:
    if not isinstance(value, list) or len(value) != 2:
        raise ValueError(f"the least and the most seconds are wanted, not {value!r}")
    return _tolerance(value[0]), _tolerance(value[1])


_POINTS = number(0, 1000)
_EXERCISE: dict[str, tuple[Field, bool]] = {
    "title": (_text, True), "task": (_text, True), "solution": (lambda value: value, False),
    "program": (_mapping, False), "case": (_tables, False), "random": (_tables, False),
    "question": (_tables, False), "mistakes": (_mistakes, False),
}  # fmt: skip
_SOURCE: dict[str, tuple[Field, bool]] = {
    "words": (number(1, 4096), False), "required": (_texts, False), "forbidden": (_texts, False),
}  # fmt: skip
CASE: dict[str, tuple[Field, bool]] = {
    "name": (_text, True), "points": (_POINTS, False), "hint": (_hints, False),
    "hidden": (_of(bool, "true or false"), False),
}  # fmt: skip
TRIAL: dict[str, tuple[Field, bool]] = {
    "start": (place, False), "starts": (number(1, 10), False), "sr": (word, False),
    "deposit": (_deposits, False), "reader": (frames, False), "keys": (frames, False),
    "seconds": (_seconds, False), "stop": (_stop, False), "tape": (frames, False),
    "itself": (_of(bool, "true or false"), False), "page": (_text, False),
    "ac": (word, False), "link": (number(0, 1), False), "core": (_words, False), "changed": (_places, False),
    "instructions": (number(1, 1 << 40), False), "takes": (_takes, False),
}  # fmt: skip
_QUESTION: dict[str, tuple[Field, bool]] = {
    "name": (_text, True), "ask": (_text, True), "answer": (_answer, False), "unit": (_text, False),
    "tolerance": (_tolerance, False), "points": (_POINTS, False), "hint": (_text, False),
    "slips": (_slips, False),
}  # fmt: skip
