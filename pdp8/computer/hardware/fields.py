"""How the parts of a machine say what its state is, and the one way to take that state and to put it back.

    fields = saved(flag=BIT, due=TICK, buffer="377")

A class has `fields`: the name of each attribute, and how a saved state writes it.

    1, 2, ... an int    a decimal number, the largest it may be
    "377", "7777" ...   an octal number, the largest it may be
    TICK                a time in ticks of 0.05 us, `never`, or -1 for at once
    FRAMES              a tape, or whatever else is frames
    CORE                a copy of core, or none
    MEDIUM              what is on a reel or a disk, which has a `digest`, or none; a state names it by that
    PART                an object with fields of its own

Taken, a state is values in memory: {"processor pc": 0o200, "devices 03 reader position": 5, ...}; what is
frames or a copy of core is bytes.
"""

from array import array
from collections.abc import Iterable, Iterator, Mapping
from typing import Any, Protocol

BIT = 1
COUNT = 1 << 52
TICK, FRAMES, PART, CORE, MEDIUM = "tick", "frames", "part", "core", "medium"

Values = dict[str, Any]
Field = tuple[str, "Part", str, int | str]
"""A field: its key among the values, the part, the attribute there, and how it is written."""
_VALUE = 100
"""About what a value that is no tape takes, in bytes."""


class Part(Protocol):
    """An object with fields."""

    fields: Mapping[str, int | str]


class Medium(Protocol):
    """The content of a reel or disk when it was mounted; it does not change."""

    @property
    def digest(self) -> str:
        """The name under which a saved state knows it."""


def saved(**fields: int | str) -> Mapping[str, int | str]:
    """Return the declaration of a class's fields."""
    return fields


def walk(roots: Iterable[tuple[str, Part]]) -> Iterator[tuple[str, Part]]:
    """Yield each part with its path, and after it the parts within it."""
    for path, part in roots:
        yield path, part
        for name, kind in part.fields.items():
            if kind == PART:
                yield f"{path} {name}", getattr(part, name)


def all_fields(roots: Iterable[tuple[str, Part]]) -> list[Field]:
    """Return all fields that are not parts themselves."""
    return [
        (f"{path} {name}", part, name, kind)
        for path, part in walk(roots)
        for name, kind in part.fields.items()
        if kind != PART
    ]


def take(fields: Iterable[Field]) -> Values:
    """Return the values of `fields`."""
    values: Values = {}
    for key, part, name, kind in fields:
        value = getattr(part, name)
        if kind == FRAMES:
            value = bytes(value)
        elif kind == CORE and value is not None:
            value = value.tobytes()
        values[key] = value
    return values


def put(fields: Iterable[Field], values: Mapping[str, Any]) -> None:
    """Set `fields` to `values`, all or some."""
    for key, part, name, kind in fields:
        if key not in values:
            continue
        value, now = values[key], getattr(part, name)
        if isinstance(now, bytearray):
            now.clear()  # others hold the same bytearray
            now.extend(value)
        elif kind == CORE and value is not None:
            setattr(part, name, array("H", value))
        else:
            setattr(part, name, bool(value) if isinstance(now, bool) else value)


def changed(before: Mapping[str, Any], now: Mapping[str, Any]) -> Values:
    """Return the values of `now` that differ from `before`."""
    return {name: value for name, value in now.items() if before.get(name) != value}


def size(values: Mapping[str, Any]) -> int:
    """Return about how many bytes the values take."""
    return sum(_VALUE + (len(value) if isinstance(value, bytes) else 0) for value in values.values())
