"""What the translator knows, a function for each construct: its test calls all of them in Python and in Node.js."""

# ruff: noqa - what is odd is what is tried
# mypy: ignore-errors

import json
import re
from array import array
from bisect import bisect_left
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass, field, replace
from enum import IntEnum, StrEnum
from functools import cached_property
from itertools import pairwise
from math import sqrt
from typing import Any, NamedTuple

ONE, TWO = 1, 2
NEVER = 1 << 62


class Colour(StrEnum):
    RED = "red"
    BLUE = "blue"


class Code(IntEnum):
    MILL = 6
    READ = 9


class Point(NamedTuple):
    x: int
    y: int = 5

    def sum(self) -> int:
        return self.x + self.y


@dataclass(frozen=True)
class Mode:
    feed: float | None = None
    words: list[int] = field(default_factory=list)

    def __post_init__(self) -> None:
        self.words.append(len(self.words))
        self.words.insert(0, 7)


class Wrong(ValueError):
    def __init__(self, message: str, place: int | None = None) -> None:
        super().__init__(message if place is None else f"{place}: {message}")


class Base:
    limit = 7

    def __init__(self, start: int) -> None:
        self.value = start
        self.total = 0
        self.seen: list[str] = []

    @property
    def double(self) -> int:
        return self.value * 2

    @double.setter
    def double(self, value: int) -> None:
        self.value = value // 2

    @cached_property
    def made(self) -> int:
        self.seen.append("made")
        return self.value

    @staticmethod
    def of(value: int) -> "Base":
        return Base(value + 1)

    def __len__(self) -> int:
        return self.value

    def __iter__(self) -> Iterator[int]:
        yield self.value
        yield from range(2)

    @contextmanager
    def noting(self) -> Iterator[None]:
        self.seen.append("in")
        try:
            yield
        except Wrong as error:
            self.seen.append(str(error))
            raise
        finally:
            self.seen.append("out")


class Derived(Base):
    def __init__(self, more: int = 3) -> None:
        super().__init__(more)
        self.more = self.value


class Most(Derived):
    pass


def _note(seen: list[str], value: int) -> int:
    seen.append(str(value))
    return value


def _placed(*values: int, scale: int = 1, add: int = 0) -> list[int]:
    return [value * scale + add for value in values]


def _after(first: int, *rest: int) -> list[int]:
    return [first, len(rest), *rest]


def _named(**fields: int) -> Mapping[str, int]:
    return fields


def _keyed(key: str, at: int = 7, **fields: str) -> str:
    return f"{key} {at} {''.join([f'{name}={fields[name]} ' for name in fields])}"


def wide_numbers() -> Any:
    """Numbers beyond 2^31, up to 2^53, and NEVER."""
    ticks, least = (1 << 52) + 12345, -(1 << 40) - 7
    limit = 3 << 26 | 1
    large = ~ticks & 0x7FFF_FFFF
    before = wide = 1
    for _ in range(4):
        before, wide = wide, wide * 4096
    return [
        ticks >> 26, ticks & 0o17777, ticks % 4093, ticks // 3, -ticks // 3, least >> 3, least & 0xFFFF, least // 7,
        least % 7, limit << 13, limit >> 26, ticks | 1 << 40, ticks ^ (1 << 51), ~ticks, ticks < NEVER,
        min(NEVER, ticks), NEVER == 1 << 62, f"{ticks:o} {ticks:,} {NEVER} {-(ticks & 0):o}", ticks.bit_length(), abs(least),
        large + large >> 1, large * 3 & 0o7777, large << 3 >> 1, large - least >> 1, large + 1 | 1, before >> 3, wide >> 3,
        -large % 1000, ticks >> 4 | 1, ticks & least | 1, large ^ 5_000_000_000, large >> len("x" * 40), [large, ticks][1] >> 3,
    ]  # fmt: skip


def comparisons_and_truth() -> Any:
    """Chains look at each operand once; sequences compare item by item. What is empty or zero is false."""
    seen: list[str] = []
    nothing: list[int] = []
    text, some, none = "", [0], None
    chain = 0 <= _note(seen, 5) <= 5 < _note(seen, 9)
    return [
        chain, seen, (1, 2) < (1, 3), [1, 2] == [1, 2], (1, "a") == (1, "b"), bytes([97, 98]) == b"ab", 1 == True,
        Point(1, 2) == (1, 2), Point(1) < Point(2), {1: [2]} == {1: [2]}, {1, 2} == {2, 1}, "b" in "abc", 2 in (1, 2),
        3 not in [1], b"b" in b"abc", 97 in b"abc", Mode(1.0) == Mode(1.0), None is None, Colour.RED == "red",
        min("b", "a"), max((1, 2), (1, 3)),
        [bool(nothing), not nothing, nothing or "else", some and "yes", text or "none", none or b"x" == b"x"],
        [bool(Base(0)), bool(Base(1)), bool({}), bool({0}), bool(b""), 1 if nothing else 2, not text, len(some) or 9],
    ]  # fmt: skip


def assignments() -> Any:
    """Targets of all kinds; what is read is read before anything is set."""
    a, b = 1, 2
    a, b = b, a
    new, default = a, b
    first, (second, third), rest = (1, (2, 3), [4, 5])
    words = array("H", bytes(8))
    words[1] = words[2] = 0o7777
    words[-1] = 5
    turned = words[1:]
    turned.byteswap()
    frames = bytearray(b"abc")
    frames += b"de"
    numbers = [0, 1, 2, 3, 4, 5]
    numbers[-1] = 9
    table = {"a": 1}
    table["a"] += 4
    table |= {"b": 2}
    texts = ["x"]
    other = texts
    texts += ["y"]
    return [
        a, b, new, default, first, second, third, rest, list(words), list(turned), list(frames), numbers, table,
        other, words[:2].tobytes()[1],
    ]  # fmt: skip


def loops() -> Any:
    """for, while, break, continue, unpacking."""
    seen: list[Any] = []
    for number, (name, value) in enumerate([("a", 1), ("b", 2), ("c", 3)], 1):
        if name == "b":
            continue
        seen.append([number, name, value])
    for number in range(3, 0, -1):
        seen.append(number)
    while True:
        number += 1
        for value in (1, 2):
            if value == 2:
                break
        if number > 4:
            break
    for value in range(number):
        number -= 1
    return [seen, number, value, [*range(2, 9, 3)], len(range(3, 30, 4)), [*reversed([1, 2])]]


def switched(op: int = 3) -> Any:
    """A long chain of ifs on one number; break leaves the loop around it."""
    seen: list[str] = []
    for op in (0, ONE, TWO, 3, 4, 6, 5, 0):
        if op == 0:
            seen.append("zero")
        elif op == ONE:
            seen.append("one")
        elif op == TWO:
            continue
        elif op == 3:
            seen.append("three")
        elif op == 4:
            seen.append("four")
        elif op == 5:
            break
        else:
            seen.append("else")
    return seen


def _raised(error: Exception) -> None:
    raise error


def _index() -> None:
    raise IndexError


def errors() -> Any:
    """raise, try, except in order, finally, a context manager of ours."""
    seen: list[Any] = []
    base = Base(1)
    wrong = [lambda: _raised(Wrong("no")), lambda: _raised(Wrong("no", 4)), _index, lambda: int("x")]
    more = [lambda: {}["x"], lambda: [1][4], lambda: 1 // len(""), lambda: 0, lambda: b"\xff".decode("ascii")]
    for bad in [*wrong, *more]:
        try:
            with base.noting():
                bad()
        except KeyError as error:
            seen.append(f"KeyError {error}")
        except (Wrong, IndexError) as error:
            seen.append(f"{error}" if isinstance(error, Wrong) else "index")
        except (ValueError, ZeroDivisionError) as error:
            seen.append(isinstance(error, ValueError))
        finally:
            seen.append("finally")
    return [seen, base.seen]


def classes() -> Any:
    """Properties, cached ones, methods of all kinds, inheritance, named tuples, dataclasses, enumerations."""
    base, derived = Base(5), Derived()
    base.double = 30
    base.total = 1 << 40
    made = [base.made, base.made, base.seen, base.total >> 3]
    point = Point(1)._replace(y=7)
    mode = replace(Mode(2.0), feed=3.5)
    return [
        made, base.double, len(base), [*base], base.of(9).value, Base.of(2).value, derived.more, Base.limit,
        derived.limit, point.sum(), [*point], point[1], point == (1, 7), Point(y=1, x=2).x, mode.feed, mode.words,
        [*Code], f"{Code.MILL} {Colour.RED}", isinstance(derived, Base), isinstance(base, Derived),
        [isinstance(each, (Mode, Point)) for each in (Mode(), Point(1), base)], isinstance(base, (Mode, Base)),
        [isinstance(each, bool) for each in (1, True)],
        str(Point(1, 2)), sorted([Point(2), Point(1)])[0].x,
    ]  # fmt: skip


def calls() -> Any:
    """Arguments by place and by name, defaults, *, **, functions as values, closures."""
    count = 0

    def more(by: int = 1) -> int:
        nonlocal count
        count += by
        return count

    spent = {"scale": 2, "add": 5}
    more()
    more(4)
    return [
        _placed(1, 2), _placed(1, scale=3), _placed(*[1, 2], add=1), _after(1, 2, 3), Most(more=4).value, _named(a=1, **spent, **{"z": 3}), more(0), _keyed("k"), _keyed("k", 1, b="2"), _keyed("k", b="2", at=3), 
        [*map(len, ["a", "bb"])], (lambda x: x + 1)(2), [f(2) for f in (more, more)],
    ]  # fmt: skip


def comprehensions() -> Any:
    """Lists, sets, dicts, nested, with conditions, with a name that is kept."""
    pairs = [(1, "a"), (2, "b"), (3, "c")]
    return [
        [some for some in ([], [1]) if some],
        [number * 2 for number, _ in pairs if number > 1], {text: number for number, text in pairs}, sorted({n % 2 for n, _ in pairs}),
        [a + b for a in "xy" for b in "12"], sum(number for number, _ in pairs), any(n > 2 for n, _ in pairs), all([]),
        next((t for n, t in pairs if n == 2), ""), next(iter([7])), [double for n in (1, 2) if (double := n * 2) > 2],
        bytes(code + 1 for code in b"abc").decode("ascii"), tuple(x for x in range(3)), max(pairs)[1],
    ]  # fmt: skip


def texts() -> Any:
    """Methods of str and f-strings."""
    text, number, part = "a,b,,c", 0o7402, 2.5
    return [
        text.split(","), "a  b ".split(), ["a", "b"], text.replace(",", ""),
        text.partition(","), "-".join(["x", "y"]), " x ".strip(), "xxaxx".lstrip("x"), "tape.bin".removesuffix(".bin"), "a\tb".expandtabs(8),
        text.find("c"), text.rfind(","), text.count(","), text.count(",", 1, 3), "abc".startswith("a"), "12".isdigit(), "a1".isalnum(), "a-".isalnum(), "a ~".isprintable(), "\x7f".isprintable(), "Ab".lower() + "Ab".upper(),
        "abc"[1:], "abc"[-1], "abc"[0:-1], "abc"[1 : {}.get("x")], f"`${{x}}{number}`", "aZ".translate({ord("a"): "b", ord("Z"): None}), "x" * 3, ord("A"), chr(0o101),
        f"{number:04o} {number:5}|{number:6,}|{-number:06}|{part:+.1f}|{part:g}|{part:8.3f}|{'x':3}|{number:x}",
        f"{part!r} {text!r} {number / 2} {number // 2} {1e20} {1e-7} {True} {None} {[1, 'x']} {0.1 + 0.2} {100.0:,}",
        f"{2.5:.0f} {3.5:.0f} {0.125:.2f} {1e15:.1f} {1234567.0:g} {0.00001:g}", str(5.0), str(5), repr("it's"), int("17", 8), int("fF", 16), int("0b11", 2),
        round(2.5), round(3.5), round(2.675, 2), round(-0.5), f"{5.0:05}", f"{'é'!r}", "{}`${x}",
        [name.endswith((".bin", ".rim")) for name in ("a.rim", "a.eia")], "abc".startswith(("b", "x"), 1),
        "a".startswith(()), "x".ljust(3, "@") + "y".rjust(3),
    ]  # fmt: skip


def frames() -> Any:
    """Methods of bytes and bytearray."""
    tape, roll = b"\0\0AB\x80\0", bytearray(b"xyz")
    roll.append(0o101)
    roll.extend(b"!")
    return [
        list(tape.strip(b"\0")), list(tape.lstrip(b"\0")), tape.rstrip(bytes([0]))[-1], tape.find(0x41), tape.find(b"B"), tape.find(b"Q"),
        tape.count(0), list(tape[2:4] + b"c"), list(bytes(3)), list(b"ab" * 2), list(tape.translate(None, b"\0")), roll.pop(0), len(roll),
        list(b"abc".translate(bytes(range(255, -1, -1)))), b"-".join([b"a", b"b"]).decode("ascii"),
        b"ab".startswith(b"a"), b"ab".endswith(b"b"), b"12".isdigit(), b"\x80".isascii(),
        roll.count(0o101), list(bytes(roll)), tape.rfind(0),
    ]  # fmt: skip


def tables() -> Any:
    """Methods of dict and set, in the order of entry."""
    table = {"7000": 1, "0100": 2}
    table.setdefault("x", 5)
    table.update({"y": 6})
    some, sized = {3, 1}, {"items": 3}
    some.add(2)
    some.discard(9)
    return [
        [*table], [*table.items()], [*table.values()], table.get("q"), table.get("q") is None, sized["items"], table.get("q", 7), table.pop("y"), "x" in table, len(table),
        dict.fromkeys(["a", "b"], 0), {**table, "z": 1}, table | {"w": 2}, sorted(some), sorted(some & {1, 2}), sorted(some - {1}), sorted(some | {8}),
        sorted(frozenset([2, 1])), json.dumps({"b": [1, "x"], "a": None}, indent=1),
        json.dumps({"n": [1, True, None, "\u00e9"]}), json.dumps({}), {None: 1}[None],
    ]  # fmt: skip


def library() -> Any:
    """What is used of Python's library."""
    pattern = re.compile(r"([a-z]*)([,;])")
    points = [Point(2, 1), Point(1, 3)]
    return [
        [*pairwise([1, 2, 3])], 
        [list(pair) for pair in pattern.findall("ab,c;")], re.compile(r"[a-z]+").findall("ab,c"), re.compile(r"([a-z])?[,;]").findall("ab,;"),
        [(m.start(), m.end()) for m in pattern.finditer("ab,c;")], pattern.split("ab,c;"),
        bisect_left([1, 3, 5], 3), sorted(points, key=lambda point: point.x)[0].y, sorted([3, 1], reverse=True),
        [*zip("ab", [1, 2], strict=True)], [*enumerate("a", 3)], divmod(-7, 2), sqrt(3.0), min([4, 2]), sum([0.5, 1]),
        list(array("H", [1, 2])), getattr(points[0], "x"), abs(-2.5),
    ]  # fmt: skip


def _chosen(a: int, b: int) -> str:
    if a == 1:
        return "a 1"
    elif a == 2:
        return "a 2"
    elif a == 3:
        return "a 3"
    elif a == 4:
        return "a 4"
    elif a == 5:
        return "a 5"
    elif b == 6:
        return "b 6"
    else:
        return "none"


def cases_of_two_names() -> list[str]:
    """The last case is of the other name."""
    return [_chosen(1, 6), _chosen(5, 0), _chosen(6, 0), _chosen(0, 6), _chosen(0, 0)]
