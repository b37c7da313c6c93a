"""The tables of an exercise's file: which keys each may have, and what becomes of their values."""

import re
from collections.abc import Callable, Mapping
from typing import Any

from pdp8 import shelf
from pdp8.lessons.answer import tag
from tapes import ascii, eia
from tapes.errors import WorkError

LONGEST = 3600
"""Seconds of machine time a case may be given."""
STOPS = ("halt", "tape out", "idle", "limit", "any")


class ExerciseError(WorkError):
    """An exercise that cannot be used; the message names the place in its file."""


_TAG = re.compile(r"[A-Za-z]\w*([+-][0-7]{1,4})?", re.ASCII)
Field = Callable[[Any], Any]
_NEEDED = ("title", "task", "name", "ask")
"""Keys that are required in every table that may have them."""


def table(given: object, where: str, fields: Mapping[str, Field]) -> dict[str, Any]:
    """Return a table's values, each converted by its field; required ones must be present."""
    if not isinstance(given, dict):
        raise ExerciseError(f"{where}: a table is wanted, not {given!r}")
    for key in given:
        if key not in fields:
            raise ExerciseError(f"{where}: no key is called {key!r}; there are {', '.join(fields)}")
    missing = [key for key in _NEEDED if key in fields and key not in given]
    if missing:
        raise ExerciseError(f"{where}: {missing[0]} is missing")
    try:
        return {(at := key): fields[key](value) for key, value in given.items()}
    except (ValueError, WorkError) as error:
        raise ExerciseError(f"{where}: {at}: {error}") from error


def field(wanted: str, *kinds: type, fits: Callable[[Any], bool] = lambda value: True) -> Field:
    """Return a field that accepts values of these types unchanged."""

    def convert(value: Any) -> Any:
        if type(value) not in kinds or not fits(value):
            raise ValueError(f"{wanted}, not {value!r}")
        return value

    return convert


def number(least: int, most: int) -> Field:
    return field(f"a number from {least} to {most} is wanted", int, fits=lambda value: least <= value <= most)


_text = field("a text is wanted", str)
_list = field("a list is wanted", list)
_flag = field("true or false is wanted", bool)
_least_0 = field("a number of 0 or more is wanted", int, float, fits=lambda value: value >= 0)
_seconds = field(f"seconds up to {LONGEST} are wanted", int, float, fits=lambda value: 0 < value <= LONGEST)
tables = field("[[...]] tables is wanted", list)


def mapping(value: Any) -> dict[str, Any]:
    """Return a table; in JSON it may be a list of pairs."""
    try:
        return dict(value)
    except (TypeError, ValueError):
        raise ValueError(f"a table is wanted, not {value!r}") from None


def word(value: Any) -> int:
    found: int = number(-0o4000, 0o7777)(value)
    return found & 0o7777


def _words(value: Any) -> dict[str, int]:
    return {each: word(given) for key, given in mapping(value).items() for each in places(key)}


def _deposits(value: Any) -> dict[str, int | str]:
    return {
        each: place(given) if isinstance(given, str) else word(given)
        for key, given in mapping(value).items()
        for each in places(key)
    }


def _counts(value: Any) -> dict[str, int]:
    return {place(key): number(1, 4096)(given) for key, given in mapping(value).items()}


def _places(value: Any) -> tuple[str, ...]:
    return tuple(each for item in _list(value) for each in places(_text(item)))


def _starts_at(value: Any) -> tuple[str, ...]:
    """Return the allowed start addresses, the likeliest first."""
    return _places(value) if isinstance(value, list) and value else (place(value),)


def places(item: str) -> list[str]:
    """Return a place, or each of a range as "0300-0311" or "TABLE-TABLE+11"."""
    first, dash, last = item.partition("-")
    if not dash or last[:1].isdigit() > item[:1].isdigit():
        return [place(item)]
    ends = [("", int(place(end), 8)) if end[:1].isdigit() else tag(place(end)) for end in (first, last)]
    (name, least), (other, most) = ends
    if name != other:
        raise ValueError(f"{item} is no range of octal addresses, nor of words behind one tag")
    ascend(place(first), place(last), least, most)
    return [place(f"{name}+{at:o}" if name and at else name or at) for at in range(least, most + 1)]


def ascend(first: Any, last: Any, least: int, most: int) -> None:
    """Raise ValueError unless a range, from `first` to `last`, ascends."""
    if least > most:
        raise ValueError(f"nothing lies from {first} to {last}: the lower bound comes first")


def place(value: Any) -> str:
    """Return an address as four octal digits, or a tag as it is, with what is added to it."""
    text = f"{value:o}" if type(value) is int else _text(value)
    if not text[:1].isdigit():
        if not _TAG.fullmatch(text):
            raise ValueError(f"{text!r} is no octal address, no tag and no TAG+1 with an octal number")
        return str(text)
    if not all(digit in "01234567" for digit in text) or int(text, 8) > 0o7777:
        raise ValueError(f"{text} is no octal address from 0000 to 7777")
    return f"{int(text, 8):04o}"


def _one_of(*allowed: str) -> Field:
    def convert(value: Any) -> str:
        if value not in allowed:
            raise ValueError(f"{value!r} is not one of {', '.join(allowed)}")
        return str(value)

    return convert


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
    return {key: _text(hint) for key, hint in mapping(value).items()}


def _pair(wanted: str) -> Field:
    return field(wanted, list, fits=lambda pair: len(pair) == 2)


def _mistakes(value: Any) -> dict[str, tuple[str, ...]]:
    edit = _pair("[piece of the solution, what is written instead] is wanted")
    return {what: _texts(edit(pair)) for what, pair in mapping(value).items()}


def _answer(value: Any) -> float | tuple[str, ...]:
    return float(value) if type(value) in (int, float) else _texts(value)


def _hints(value: Any) -> dict[str, str]:
    return {"": value} if isinstance(value, str) else _slips(value)


def _tolerance(value: Any) -> float:
    return float(_least_0(value))


def _takes(value: Any) -> tuple[float, ...]:
    return tuple(map(_tolerance, _pair("the least and the most seconds are wanted")(value)))


_POINTS = number(0, 1000)
EXERCISE: dict[str, Field] = {
    "title": _text, "task": _text, "solution": lambda value: value, "program": mapping, "case": tables,
    "random": tables, "question": tables, "mistakes": _mistakes,
    "others": number(0, 1000),
}  # fmt: skip
SOURCE: dict[str, Field] = {
    "words": number(1, 4096), "required": _texts, "forbidden": _texts, "spare": _places,
}  # fmt: skip
CASE: dict[str, Field] = {
    "name": _text, "tests": _text, "points": _POINTS, "hint": _hints, "hidden": _flag,
}  # fmt: skip
TRIAL: dict[str, Field] = {
    "start": _starts_at, "starts": number(1, 10), "sr": word, "deposit": _deposits, "reader": frames,
    "keys": frames, "stop": _one_of(*STOPS), "tape": frames, "itself": _flag, "page": _text, "ac": word,
    "seconds": _seconds, "link": number(0, 1), "core": _words, "changed": _places, "unchanged": _places,
    "instructions": number(1, 1 << 40), "takes": _takes, "executed": _counts, "callers": _counts,
    "indirect": _places, "done": _flag, "nul": _one_of("counted", "ignored"),
}  # fmt: skip
QUESTION: dict[str, Field] = {
    "name": _text, "ask": _text, "answer": _answer, "unit": _text, "tolerance": _tolerance,
    "points": _POINTS, "hint": _text, "slips": _slips,
}  # fmt: skip
