"""A judge of G-code for a hobbyist's mill: an interpreter of its own, and rules; it knows no exporter.

Z 0 is the top of the stock, which may be anywhere under the path. A rapid in X and Y goes at the safe height
or above it, and a rapid in Z ends above the stock; all that goes lower is fed, with the spindle on. The words
are those that grbl 1.1 knows as it comes; `allowed` adds others.

Sources: README of gnea/grbl 1.1; LinuxCNC's advice on a program's first line.
"""

import re
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field
from typing import NamedTuple

_NEEDED = frozenset({"G17", "G20", "G40", "G49", "G54", "G80", "G90", "G94"})
_GRBL = _NEEDED | {"G0", "G1", "G4", "G61", "M0", "M3", "M4", "M5", "M30"}
_WORD = re.compile(r"([A-Z])\s*([-+]?(?:\d+\.?\d*|\.\d+))")
_UNKNOWN = 1e6
_ANYWHERE = (_UNKNOWN, _UNKNOWN, -_UNKNOWN)
"""Where the mill stands before the program moves it, and after a stop, in which it may be moved by hand."""


class Went(NamedTuple):
    """A straight move: the line that it stands in, its end, and its feed; None for a rapid."""

    line: int
    end: tuple[float, float, float]
    feed: float | None


@dataclass
class Mill:
    """What a controller knows while it runs a program."""

    line: int = 0
    motion: str = ""
    at: tuple[float, float, float] = _ANYWHERE
    feed: float = 0
    speed: float = 0
    turning: bool = False
    ended: bool = False
    modes: set[str] = field(default_factory=set)
    went: list[Went] = field(default_factory=list)
    faults: list[str] = field(default_factory=list)

    def fault(self, what: str) -> None:
        """Note what is wrong with this line."""
        self.faults.append(f"line {self.line}: {what}")


def run(lines: Iterable[str], safe: float, allowed: Iterable[str] = ()) -> Mill:
    """Return the mill after the program, with the moves it made and the faults on the way."""
    mill = Mill()
    known = _GRBL | set(allowed)
    for mill.line, line in enumerate(lines, 1):
        if len(line) > 100:
            mill.fault("longer than 100 characters")
        if not re.fullmatch(r"[^()]*(\([^()]*\)[^()]*)*", line) or not line.isascii():
            mill.fault(f"a comment that does not close: {line}")
        code = re.sub(r"\([^()]*\)", "", line).strip()
        if code:
            _line(mill, code, safe, known)
    if not mill.ended:
        mill.fault("the program has no end")
    if mill.turning:
        mill.fault("the spindle still turns at the end")
    if mill.at[2] < safe:
        mill.fault("the cutter is not lifted at the end")
    return mill


def _line(mill: Mill, code: str, safe: float, known: frozenset[str]) -> None:
    if mill.ended:
        mill.fault("words after the end")
    if _WORD.sub("", code).strip():
        mill.fault(f"not words: {code}")
    words = [(letter, float(number)) for letter, number in _WORD.findall(code)]
    given = {letter: number for letter, number in words if letter not in "GM"}
    codes = [f"{letter}{number:g}" for letter, number in words if letter in "GM"]
    for name in codes:
        if name not in known:
            mill.fault(f"{name} is unknown to the controller")
    mill.modes.update(codes)
    mill.feed = given.get("F", mill.feed)
    mill.speed = given.get("S", mill.speed)
    if {"M3", "M4"} & {*codes}:
        mill.turning = mill.speed > 0
    if "M5" in codes:
        mill.turning = False
    mill.motion = next((name for name in codes if name in ("G0", "G1")), mill.motion)
    if {*"XYZ"} & given.keys():
        x, y, z = (given.get(axis, was) for axis, was in zip("XYZ", mill.at, strict=True))
        _move(mill, (x, y, z), safe)
    if {"M0", "M6"} & {*codes}:
        if mill.at[2] < safe or mill.turning:
            mill.fault("a stop with the cutter down or turning")
        mill.at = _ANYWHERE
    mill.ended = mill.ended or bool({"M2", "M30"} & {*codes})


def _move(mill: Mill, end: tuple[float, float, float], safe: float) -> None:
    missing = _NEEDED - mill.modes
    if missing:
        mill.fault(f"a move before {' '.join(sorted(missing))}")
    start, mill.at = mill.at, end
    aside = start[:2] != end[:2]
    if mill.motion == "G0":
        mill.went.append(Went(mill.line, end, None))
        if aside and min(start[2], end[2]) < safe:
            mill.fault("a rapid in X or Y below the safe height")
        if end[2] <= 0:
            mill.fault("a rapid onto or into the stock")
    elif mill.motion == "G1":
        mill.went.append(Went(mill.line, end, mill.feed))
        if _UNKNOWN in (abs(start[0]), abs(start[1]), abs(start[2])):
            mill.fault("a feed from an unknown place")
        if mill.feed <= 0:
            mill.fault("a feed move without a feed")
        if not mill.turning:
            mill.fault("the cutter is fed, but does not turn")
    else:
        mill.fault("a move without G0 or G1")


class Stock(NamedTuple):
    """What the program may reach: X and Y of the cutter's centre, and how deep."""

    low: tuple[float, float]
    high: tuple[float, float]
    depth: float


def faults(lines: Iterable[str], stock: Stock, safe: float = 0.25, allowed: Iterable[str] = ()) -> list[str]:
    """Return every rule that the program breaks, with its line."""
    mill = run(lines, safe, allowed)
    return [*mill.faults, *_outside(mill.went, stock)]


def _outside(went: list[Went], stock: Stock) -> Iterator[str]:
    if not any(move.feed for move in went):
        yield "nothing is cut"
    for line, (x, y, z), _ in went:
        if _UNKNOWN not in (x, y) and not (
            stock.low[0] <= x <= stock.high[0] and stock.low[1] <= y <= stock.high[1]
        ):
            yield f"line {line}: X {x} Y {y} is outside"
        if z < -stock.depth - 1e-9:
            yield f"line {line}: Z {z} is deeper than {stock.depth}"
