"""Random cases: inputs drawn by ranges and kinds, and what the solution, or a Python function, makes of them.

docs/lessons.md says what may stand in a [[random]]. The same seed and name of a case draw the same.
"""

import os
import runpy
from collections.abc import Callable, Sequence
from dataclasses import replace
from random import Random
from typing import Any

from pdp8.computer.stop import Reason
from pdp8.lessons import trial
from pdp8.lessons.answer import Answer, assembled, tag
from pdp8.lessons.exercise import Case, Trial
from pdp8.lessons.tables import (
    CASE,
    TRIAL,
    ExerciseError,
    Field,
    ascend,
    field,
    frames,
    mapping,
    number,
    places,
    table,
    word,
)
from tapes.errors import WorkError

_Function = Callable[[Random, dict[str, Any]], dict[str, Any]]
_EDGES = (0, 1, 0o3777, 0o4000, 0o4001, 0o7777)
"""Words at which programs go wrong: a quarter of those drawn are among them, or are bounds of their range."""
_MOST = 200
"""The most trials of a case. At most 4096 frames or words are drawn at once."""


def case(given: object, where: str, solution: str, seed: int, folder: str) -> Case:
    """Return the case with its trials drawn. Raises ExerciseError."""
    found = table(given, where, _RANDOM)
    own = {key: found.pop(key) for key in CASE if key in found}
    trials, again = found.pop("trials", 20), found.pop("again", False)
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
        drawn, *others = (
            _drawn(found, random, function, f"{where}: drawn trial {count + 1}") for _ in range(1 + again)
        )
        drawn = replace(drawn, again=tuple(others))
        made.append(_expected(drawn, program, compare, within, where) if compare else drawn)
    return Case(trials=tuple(made), hints=own.pop("hint", {}), **own)


def _drawn(given: dict[str, Any], random: Random, function: _Function | None, where: str) -> Trial:
    """Return a trial with random inputs, completed by a function."""
    try:
        found = {key: _DRAWN[key](value, random) if key in _DRAWN else value for key, value in given.items()}
        if function is not None:
            found = function(random, found)
    except (ValueError, TypeError, WorkError) as error:
        raise ExerciseError(f"{where.partition(': drawn')[0]}: {error}") from error
    return Trial(**table(found, where, TRIAL))


def _expected(drawn: Trial, program: Answer, compare: Sequence[str], within: float, where: str) -> Trial:
    """Return the trial with the solution's results as expectations."""
    tags = [tag(item)[0] for item in compare if item not in _WHAT and not item[0].isdigit()]
    missing = next((each for each in tags if each not in program.symbols), trial.missing(program, drawn))
    if missing:
        raise ExerciseError(f"{where}: the solution has no tag {missing}")
    first, *others = trial.run(program, drawn)
    for outcome in (first, *others):
        if drawn.stop not in (outcome.stop.reason, "any") or outcome.stop.reason is Reason.BREAKPOINT:
            end = "leaving the program" if outcome.stop.reason is Reason.BREAKPOINT else outcome.stop.reason
            raise ExerciseError(f"{where}: the solution ends with {end}, not {drawn.stop}")
    again = tuple(_kept(*pair, program, compare, within) for pair in zip(drawn.again, others, strict=True))
    return replace(_kept(drawn, first, program, compare, within), again=again)


def _kept(
    drawn: Trial, outcome: trial.Outcome, program: Answer, compare: Sequence[str], within: float
) -> Trial:
    """Return a trial with the results of one START of the solution."""
    core = {each: outcome.core[program.address(each)] for each in compare if each not in _WHAT}
    found = outcome._replace(instructions=int(outcome.instructions * within))
    kept = {_WHAT[item]: getattr(found, _WHAT[item]) for item in compare if item in _WHAT}
    return replace(drawn, core={**drawn.core, **core}, **kept)


_WHAT = {"AC": "ac", "L": "link", "tape": "tape", "page": "page", "instructions": "instructions"}
"""What may be compared beside words of core, and what a trial calls it."""


def _function(name: str, where: str, folder: str) -> _Function:
    file, _, called = name.partition(":")
    path = os.path.join(folder, file)
    if not (path.endswith(".py") and os.path.isfile(path)):
        raise ExerciseError(f"{where}: python: {file!r} is no Python file beside the exercise")
    function: _Function | None = runpy.run_path(path).get(called)
    if function is None:
        raise ExerciseError(f"{where}: python: {file} has no function {called!r}")
    return function


def _word(given: Any, random: Random) -> int | str:
    """Return a word: as given, drawn from a range, or picked from a list."""
    if not isinstance(given, dict):
        return given if isinstance(given, str) else int(word(given))
    if set(given) == {"pick"}:
        return int(word(random.choice(_some(given["pick"]))))
    if set(given) == {"from", "to"}:
        least, most = _bounds((given["from"], given["to"]), -0o4000, 0o7777)
        edges = [each for word in _EDGES for each in (word, word - 0o10000) if least <= each <= most]
        if random.randrange(4) == 0:
            return random.choice([*edges, least, most]) & 0o7777
        return random.randint(least, most) & 0o7777
    raise ValueError(f"a word, {{ from, to }} or {{ pick = [...] }} is wanted, not {given!r}")


def _some(given: Any) -> list[Any]:
    if not isinstance(given, list) or not given:
        raise ValueError(f"pick: a list of one or more is wanted, not {given!r}")
    return given


def _deposit(given: Any, random: Random) -> dict[str, int | str]:
    return {each: _word(value, random) for at, value in mapping(given).items() for each in places(at)}


def _tape(given: Any, random: Random) -> list[int]:
    """Return frames: as given, or drawn part by part."""
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
    ascend(first, last, first, last)
    return first, last


_DRAWN: dict[str, Callable[[Any, Random], Any]] = {
    "sr": _word, "deposit": _deposit, "reader": _tape, "keys": _tape,
}  # fmt: skip


_compared = field(f"a list of tags, addresses or {', '.join(_WHAT)} is wanted", list, fits=lambda items:
                  items and all(isinstance(item, str) and item for item in items))  # fmt: skip
_RANDOM: dict[str, Field] = {
    **CASE, **dict.fromkeys(TRIAL, lambda value: value), "trials": number(1, _MOST),
    "again": field("true or false is wanted", bool),
    "compare": lambda items: [each for item in _compared(items) for each in places(item)],
    "within": field("a factor above 0 is wanted", int, float, fits=lambda factor: factor > 0),
    "python": field('"file.py:function" is wanted', str, fits=lambda name: ":" in name),
}  # fmt: skip
