"""Random cases: inputs drawn by ranges and kinds, and what the solution, or a Python function, makes of them.

docs/lessons.md says what may stand in a [[random]]. The same seed and name of a case draw the same.
"""

import os
import runpy
from collections.abc import Callable, Sequence
from dataclasses import replace
from random import Random
from typing import Any

from pdp8.lessons import trial
from pdp8.lessons.answer import Answer, assembled
from pdp8.lessons.exercise import Case, Trial
from pdp8.lessons.tables import (
    CASE,
    TRIAL,
    ExerciseError,
    Field,
    field,
    frames,
    mapping,
    number,
    place,
    table,
    word,
)
from tapes.errors import WorkError

_MOST = 200
"""Frames or words drawn at once are at most 4096, trials so many."""


def case(given: object, where: str, solution: str, seed: int, folder: str) -> Case:
    """Return the case with its trials drawn. Raises ExerciseError."""
    found = table(given, where, _RANDOM)
    own = {key: found.pop(key) for key in CASE if key in found}
    trials = found.pop("trials", 20)
    compare, within = found.pop("compare", ()), found.pop("within", 1.0)
    function = _function(found.pop("python"), where, folder) if "python" in found else None
    if not compare and function is None and not found.get("itself"):
        raise ExerciseError(f"{where}: compare or python is missing: nothing says what is right")
    if compare and not solution:
        raise ExerciseError(f"{where}: solution is missing; compare asks what it leaves")
    program = assembled(Answer("the solution", source=solution)) if compare else Answer("")
    if program.fault:
        raise ExerciseError(f"{where}: {program.fault}")
    made = []
    for count in range(trials):
        random = Random(f"{seed} {own['name']} {count}")
        try:
            inputs = {
                key: _DRAWN[key](value, random) if key in _DRAWN else value for key, value in found.items()
            }
            if function is not None:
                inputs = function(random, inputs)
        except (ValueError, TypeError, WorkError) as error:
            raise ExerciseError(f"{where}: {error}") from error
        drawn = Trial(**table(inputs, f"{where}: drawn trial {count + 1}", TRIAL))
        made.append(_expected(drawn, program, compare, within, where) if compare else drawn)
    return Case(trials=tuple(made), hints=own.pop("hint", {}), **own)


def _expected(drawn: Trial, program: Answer, compare: Sequence[str], within: float, where: str) -> Trial:
    """Return the trial with what the solution made of it."""
    missing = [name for name in (*trial.needs(drawn), *_tags(compare)) if name not in program.symbols]
    if missing:
        raise ExerciseError(f"{where}: the solution has no tag {missing[0]}")
    outcome = trial.run(program, drawn)
    if drawn.stop not in (outcome.stop.reason, "any"):
        raise ExerciseError(f"{where}: the solution ends with {outcome.stop.reason}, not {drawn.stop}")
    core = {each: outcome.core[program.address(each)] for each in compare if each not in _WHAT}
    found = outcome._replace(instructions=int(outcome.instructions * within))
    kept = {_WHAT[item]: getattr(found, _WHAT[item]) for item in compare if item in _WHAT}
    return replace(drawn, core={**drawn.core, **core}, **kept)


_WHAT = {"AC": "ac", "L": "link", "tape": "tape", "page": "page", "instructions": "instructions"}
"""What may be compared beside words of core, and what a trial calls it."""


def _tags(compare: Sequence[str]) -> list[str]:
    return [item for item in compare if item not in _WHAT and not item[0].isdigit()]


def _places(item: str) -> list[str]:
    """Return a place, or each address of a range as "0300-0311"."""
    first, dash, last = item.partition("-")
    if not dash or not item[0].isdigit():
        return [item]
    if not last[:1].isdigit():
        raise ValueError(f"{item} is no range of octal addresses")
    _ascend(first := place(first), last := place(last))
    return [f"{address:04o}" for address in range(int(first, 8), int(last, 8) + 1)]


def _function(name: str, where: str, folder: str) -> Callable[[Random, dict[str, Any]], dict[str, Any]]:
    file, _, called = name.partition(":")
    path = os.path.join(folder, file)
    if not (path.endswith(".py") and os.path.isfile(path)):
        raise ExerciseError(f"{where}: python: {file!r} is no Python file beside the exercise")
    function: Callable[[Random, dict[str, Any]], dict[str, Any]] | None = runpy.run_path(path).get(called)
    if function is None:
        raise ExerciseError(f"{where}: python: {file} has no function {called!r}")
    return function


def _word(given: Any, random: Random) -> int | str:
    """Return a word: as given, of a range, or one of a list."""
    if not isinstance(given, dict):
        return given if isinstance(given, str) else int(word(given))
    if set(given) == {"pick"}:
        return int(word(random.choice(_some(given["pick"]))))
    if set(given) == {"from", "to"}:
        return random.randint(*_bounds((given["from"], given["to"]), -0o4000, 0o7777)) & 0o7777
    raise ValueError(f"a word, {{ from, to }} or {{ pick = [...] }} is wanted, not {given!r}")


def _some(given: Any) -> list[Any]:
    if not isinstance(given, list) or not given:
        raise ValueError(f"pick: a list of one or more is wanted, not {given!r}")
    return given


def _deposit(given: Any, random: Random) -> dict[str, int | str]:
    return {each: _word(value, random) for at, value in mapping(given).items() for each in _places(at)}


def _tape(given: Any, random: Random) -> list[int]:
    """Return the frames of a tape: as given, or its parts one after the other, each drawn."""
    if isinstance(given, list):
        return [frame for part in given for frame in _tape(part, random)]
    if isinstance(given, int):
        return [given]
    if not isinstance(given, dict) or "length" not in given:
        return list(frames(given))
    length = given["length"]
    count = random.randint(*_bounds(length if isinstance(length, list) else (length, length), 0, 4096))
    if set(given) == {"length", "pick"}:
        among = _some(list(frames(given["pick"])))
    elif set(given) == {"length", "from", "to"}:
        first, last = _bounds((given["from"], given["to"]), 0, 0o377)
        among = list(range(first, last + 1))
    else:
        raise ValueError(f"{{ length, pick }} or {{ length, from, to }} is wanted, not {given!r}")
    return [random.choice(among) for _ in range(count)]


def _bounds(pair: Sequence[Any], least: int, most: int) -> tuple[int, int]:
    first, last = map(number(least, most), pair if len(pair) == 2 else (pair, pair))
    _ascend(first, last)
    return first, last


def _ascend(first: Any, last: Any) -> None:
    if first > last:
        raise ValueError(f"nothing lies from {first} to {last}: the lower bound comes first")


_DRAWN: dict[str, Callable[[Any, Random], Any]] = {
    "sr": _word, "deposit": _deposit, "reader": _tape, "keys": _tape,
}  # fmt: skip


_compared = field(f"a list of tags, addresses or {', '.join(_WHAT)} is wanted", list, fits=lambda items:
                  items and all(isinstance(item, str) and item for item in items))  # fmt: skip
_RANDOM: dict[str, Field] = {
    **CASE, **dict.fromkeys(TRIAL, lambda value: value), "trials": number(1, _MOST),
    "compare": lambda items: [each for item in _compared(items) for each in _places(item)],
    "within": field("a factor above 0 is wanted", int, float, fits=lambda factor: factor > 0),
    "python": field('"file.py:function" is wanted', str, fits=lambda name: ":" in name),
}  # fmt: skip
