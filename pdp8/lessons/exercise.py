"""An exercise as its file says it, in TOML: a program to write, tried on cases, or a sheet of questions.

title = "Add two words"
task = "..."                          what the student is asked
solution = '''...'''                  the teacher's own answer
[program]                             of a program: bounds and words of its source, all optional
words = 40                            at most so many words of core
required = ["TAD"]                    forbidden = ["ISZ"]
[[case]]
name = "5 + 7"
start = 0o200                         or a symbol of the answer
starts = 2                            press START so often, the last run counts
sr = 0o7777
deposit = { A = 5, "0301" = 7 }       by symbol or octal address; -1 is 7777, "A" is A's address
reader = "12"                         a tape: ASCII with channel 8, or [0o261, 0o262], or { eia = "12" }
keys = "12"                           typed at the Teletype
seconds = 10                          of machine time, the most it may take
stop = "halt"                         how it must end: halt, tape out, idle, limit, or any
tape = "12"                           expected from the punch; page: from the printer, lines end in \\n
ac = 0o14                             link, core = { SUM = 12 }; changed = ["COUNT"]: not as before
instructions = 100                    at most
points = 1                            hint = "..." for whom it fails
[[question]]
name = "a"                            ask, answer = "270" or several, points, hint
slips = { "184" = "that is decimal" } wrong answers that deserve a hint of their own
[mistakes]                            what students do wrong: a piece of the solution, what they write
"the AC is not cleared" = ["CLA CLL", "CLL"]
"""

import os
import re
import tomllib
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any

from tapes import ascii, eia, shelf
from tapes.errors import WorkError

FOLDER = os.path.join(os.path.dirname(os.path.abspath(__file__)), "exercises")
LONGEST = 3600
"""Seconds of machine time a case may be given."""
STOPS = ("halt", "tape out", "idle", "limit", "any")


class ExerciseError(WorkError):
    """An exercise that cannot be used; the message names the place in its file."""


@dataclass(frozen=True)
class Case:
    """One trial of a program: how it is set up, what it must do. None is not looked at."""

    name: str
    start: str = "0200"
    starts: int = 1
    sr: int = 0
    deposit: Mapping[str, int | str] = field(default_factory=dict)
    reader: bytes = b""
    keys: bytes = b""
    seconds: float = 10
    stop: str = "halt"
    tape: bytes | None = None
    page: str | None = None
    ac: int | None = None
    link: int | None = None
    core: Mapping[str, int] = field(default_factory=dict)
    changed: tuple[str, ...] = ()
    instructions: int | None = None
    points: int = 1
    hint: str = ""


@dataclass(frozen=True)
class Question:
    """One line of a sheet: what is asked, which answers are right, what is said to a wrong one."""

    name: str
    ask: str
    answer: tuple[str, ...]
    points: int = 1
    hint: str = ""
    slips: Mapping[str, str] = field(default_factory=dict)


@dataclass(frozen=True)
class Source:
    """What an answer's source must keep to."""

    words: int | None = None
    required: tuple[str, ...] = ()
    forbidden: tuple[str, ...] = ()


@dataclass(frozen=True)
class Exercise:
    """A whole exercise; `mistakes` are by what a student did: a piece of the solution, and what he wrote."""

    name: str
    title: str
    task: str
    solution: str
    source: Source
    cases: tuple[Case, ...]
    questions: tuple[Question, ...]
    mistakes: Mapping[str, tuple[str, str]]

    @property
    def parts(self) -> tuple[Case | Question, ...]:
        """What is marked one by one."""
        return (*self.cases, *self.questions)

    @property
    def points(self) -> int:
        """The most that can be had."""
        return sum(part.points for part in self.parts)


def bundled() -> list[str]:
    """Return the names of the bundled exercises, sorted."""
    return sorted(name.removesuffix(".toml") for name in os.listdir(FOLDER) if name.endswith(".toml"))


def read(name: str) -> Exercise:
    """Return the exercise in file `name`, or the bundled one. Raises ExerciseError, ShelfError."""
    stem = name.removesuffix(".toml")
    path = name if os.path.exists(name) or stem not in bundled() else os.path.join(FOLDER, f"{stem}.toml")
    if not os.path.exists(path):
        raise ExerciseError(f"{name}: no such file, and no bundled exercise ({', '.join(bundled())})")
    return parse(shelf.read_text(path), os.path.basename(stem))


def parse(text: str, name: str) -> Exercise:
    """Return the exercise that `text` says, called `name`. Raises ExerciseError."""
    try:
        deep = any(_DEEP.fullmatch(line.partition("=")[0]) for line in text.splitlines())
        given = {} if deep else tomllib.loads(text)
    except RecursionError:
        deep = True
    except ValueError as error:
        raise ExerciseError(f"{name}: {error}") from error
    if deep:
        raise ExerciseError(f"{name}: nested too deeply")
    found = _table(given, name, _EXERCISE)
    cases = tuple(Case(**_table(case, f"{name}: case {number}", _CASE)) for number, case in
                  enumerate(found.pop("case", ()), 1))  # fmt: skip
    questions = tuple(Question(**_table(question, f"{name}: question {number}", _QUESTION))
                      for number, question in enumerate(found.pop("question", ()), 1))  # fmt: skip
    if bool(cases) == bool(questions):
        raise ExerciseError(f"{name}: give [[case]] tables for a program, or [[question]] tables for a sheet")
    source = Source(**_table(found.pop("program", {}), f"{name}: program", _SOURCE))
    found.setdefault("mistakes", {})
    return Exercise(name=name, source=source, cases=cases, questions=questions, **found)


_Field = Callable[[Any], Any]
_DEEP = re.compile(r"\s*\[{0,2}\s*[\w\"'-]+(?:\s*\.\s*[\w\"'-]+){32,}\s*\]{0,2}\s*")
"""A key of so many parts as take tomllib the square of their number."""


def _table(given: object, where: str, fields: Mapping[str, tuple[_Field, bool]]) -> dict[str, Any]:
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


def _of(kind: type, called: str) -> _Field:
    def convert(value: Any) -> Any:
        if not isinstance(value, kind) or isinstance(value, bool):
            raise ValueError(f"{called} is wanted, not {value!r}")
        return value

    return convert


_text = _of(str, "a text")
_list = _of(list, "a list")
_tables = _of(list, "[[...]] tables")
_mapping = _of(dict, "a table")


def _number(least: int, most: int) -> _Field:
    def convert(value: Any) -> int:
        if not isinstance(value, int) or isinstance(value, bool) or not least <= value <= most:
            raise ValueError(f"a number from {least} to {most} is wanted, not {value!r}")
        return value

    return convert


def _word(value: Any) -> int:
    word: int = _number(-0o4000, 0o7777)(value)
    return word & 0o7777


def _words(value: Any) -> dict[str, int]:
    return {_place(key): _word(word) for key, word in _mapping(value).items()}


def _deposits(value: Any) -> dict[str, int | str]:
    return {
        _place(key): _place(word) if isinstance(word, str) else _word(word)
        for key, word in _mapping(value).items()
    }


def _places(value: Any) -> tuple[str, ...]:
    return tuple(_place(place) for place in _list(value))


def _place(value: Any) -> str:
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


def _frames(value: Any) -> bytes:
    r"""Return a tape: a text in ASCII, CR LF for "\n"; frames; {eia = text}; {file = name}."""
    if isinstance(value, str):
        return ascii.encode(value, fill=0)
    if isinstance(value, list):
        return bytes(_number(0, 0o377)(frame) for frame in value)
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


_POINTS = _number(0, 1000)
_EXERCISE: dict[str, tuple[_Field, bool]] = {
    "title": (_text, True), "task": (_text, True), "solution": (_text, True), "program": (_mapping, False),
    "case": (_tables, False), "question": (_tables, False), "mistakes": (_mistakes, False),
}  # fmt: skip
_SOURCE: dict[str, tuple[_Field, bool]] = {
    "words": (_number(1, 4096), False), "required": (_texts, False), "forbidden": (_texts, False),
}  # fmt: skip
_CASE: dict[str, tuple[_Field, bool]] = {
    "name": (_text, True), "start": (_place, False), "starts": (_number(1, 10), False), "sr": (_word, False),
    "deposit": (_deposits, False), "reader": (_frames, False), "keys": (_frames, False),
    "seconds": (_seconds, False), "stop": (_stop, False), "tape": (_frames, False), "page": (_text, False),
    "ac": (_word, False), "link": (_number(0, 1), False), "core": (_words, False),
    "changed": (_places, False),
    "instructions": (_number(1, 1 << 40), False), "points": (_POINTS, False), "hint": (_text, False),
}  # fmt: skip
_QUESTION: dict[str, tuple[_Field, bool]] = {
    "name": (_text, True), "ask": (_text, True), "answer": (_texts, True), "points": (_POINTS, False),
    "hint": (_text, False), "slips": (_slips, False),
}  # fmt: skip
