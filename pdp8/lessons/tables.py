"""The tables of an exercise's file: which keys each may have, and what becomes of their values."""

from collections.abc import Callable, Mapping
from typing import Any

from tapes import ascii, eia, shelf
from tapes.errors import WorkError

LONGEST = 3600
"""Seconds of machine time a case may be given."""
STOPS = ("halt", "tape out", "idle", "limit", "any")


class ExerciseError(WorkError):
    """An exercise that cannot be used; the message names the place in its file."""


Field = Callable[[Any], Any]


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
tables = _of(list, "[[...]] tables")


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
EXERCISE: dict[str, tuple[Field, bool]] = {
    "title": (_text, True), "task": (_text, True), "solution": (lambda value: value, False),
    "program": (_mapping, False), "case": (tables, False), "random": (tables, False),
    "question": (tables, False), "mistakes": (_mistakes, False),
}  # fmt: skip
SOURCE: dict[str, tuple[Field, bool]] = {
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
QUESTION: dict[str, tuple[Field, bool]] = {
    "name": (_text, True), "ask": (_text, True), "answer": (_answer, False), "unit": (_text, False),
    "tolerance": (_tolerance, False), "points": (_POINTS, False), "hint": (_text, False),
    "slips": (_slips, False),
}  # fmt: skip
