"""What the machine did with a tape: a step for each block, its moves, and the time they took.

    Path ── Step ── Block (tapes.hydrapoint)
              ├──── Modes    what is in force after the block
              └──── Move …   straight, at one speed

Lengths are thousandths of an inch, the machine's own unit. Z is how far the quill is down: 0 is fully
retracted.
"""

from bisect import bisect_left
from collections.abc import Iterator
from dataclasses import dataclass
from enum import StrEnum
from functools import cached_property
from math import sqrt
from typing import TYPE_CHECKING, Final, NamedTuple

from tapes.hydrapoint import HOLE_MAKING, ROWS, Block, Preparatory
from tapes.quantities import counted

if TYPE_CHECKING:
    from numpy import float64
    from numpy.typing import NDArray


STEP: Final = 1
"""The least move. A contour that ends so near its start is closed: the listing's circle, with `close`."""


class Position(NamedTuple):
    """Where the cutter's tip is, in thousandths of an inch."""

    x: float
    y: float
    z: float

    def distance(self, other: "Position") -> float:
        """Return the distance between two positions."""
        x, y, z = other.x - self.x, other.y - self.y, other.z - self.z
        return sqrt(x * x + y * y + z * z)


class Knot(NamedTuple):
    """A place that the cutter reaches straight, the second of arrival, and whether it cuts on the way."""

    second: float
    x: float
    y: float
    down: bool


class Place(NamedTuple):
    """Where the cutter is: after which knot, in which block (from 0), and whether it cuts."""

    knot: int
    x: float
    y: float
    down: bool
    block: int


class MoveKind(StrEnum):
    """What a move is for."""

    POSITION = "position"
    APPROACH = "approach"
    FEED_IN = "feed in"
    FEED_OUT = "feed out"
    MILL = "mill"
    RETRACT = "retract"


@dataclass(frozen=True, slots=True)
class Move:
    """A straight move at one speed, in inches a minute."""

    kind: MoveKind
    start: Position
    end: Position
    speed: float
    seconds: float

    @property
    def length(self) -> float:
        """Length in thousandths."""
        return self.start.distance(self.end)


@dataclass(frozen=True, slots=True)
class Modes:
    """What is in force until a block changes it, None if none has: feeds in in/min, depths in .001 in."""

    x_feed: float | None = None
    y_feed: float | None = None
    z_feed: float | None = None
    spindle: int | None = None
    tool: int | None = None
    coolant: str = "off"
    partial_retract: bool = False
    feed_point: int | None = None
    final_depth: int = 0


@dataclass(frozen=True, slots=True)
class Step:
    """One block carried out: its place on the tape, its moves, and the state of the machine after it."""

    number: int
    frame: int
    block: Block
    moves: tuple[Move, ...]
    modes: Modes
    at: Position
    tool_changed: bool = False
    stop: str | None = None


@dataclass(frozen=True)
class Times:
    """Seconds at the machine by activity."""

    reading: float
    positioning: float
    z_feed: float
    milling: float
    tool_changes: float

    @property
    def total(self) -> float:
        """Seconds from the first row read to the end of the last move, without the operator's pauses."""
        return self.reading + self.positioning + self.z_feed + self.milling + self.tool_changes

    @property
    def efficiency(self) -> float:
        """The part of the time, 0 to 1, spent milling (Chapter 10); 0 if no time was taken."""
        return self.milling / self.total if self.total else 0.0


_SPENT = {
    MoveKind.POSITION: "positioning",
    MoveKind.APPROACH: "positioning",
    MoveKind.RETRACT: "positioning",
    MoveKind.FEED_IN: "z_feed",
    MoveKind.FEED_OUT: "z_feed",
    MoveKind.MILL: "milling",
}
"""The activities of Times, in its order."""


@dataclass(frozen=True, repr=False)
class Path:
    """Everything a tape made the machine do, in the order of its blocks."""

    steps: tuple[Step, ...]
    read_seconds: float
    tool_change_seconds: float

    def __len__(self) -> int:
        return len(self.steps)

    def __repr__(self) -> str:
        return f"<{type(self).__name__}: {counted(len(self), 'blocks')}, {self.times.total / 60:.1f} min>"

    @property
    def blocks(self) -> tuple[Block, ...]:
        """The blocks in the order of the tape."""
        return tuple(step.block for step in self.steps)

    @cached_property
    def moves(self) -> tuple[Move, ...]:
        """Every move, in order."""
        return tuple(move for step in self.steps for move in step.moves)

    @cached_property
    def times(self) -> Times:
        """The time it takes, without the operator's pauses."""
        spent = dict.fromkeys(_SPENT.values(), 0.0)
        for move in self.moves:
            spent[_SPENT[move.kind]] += move.seconds
        changes = self.tool_change_seconds * sum(step.tool_changed for step in self.steps)
        positioning, z_feed, milling = spent.values()
        return Times(self.read_seconds * len(self.steps), positioning, z_feed, milling, changes)

    def array(self) -> "NDArray[float64]":
        """Return X, Y, Z of the tip, thousandths, before the first move and after each: (moves + 1, 3)."""
        import numpy

        places = [move.start for move in self.moves[:1]] + [move.end for move in self.moves]
        return numpy.array(places, dtype=numpy.float64).reshape(len(places), 3)

    @property
    def milling_blocks(self) -> int:
        """How many blocks mill."""
        return sum(step.block.preparatory == Preparatory.MILL for step in self.steps)

    @property
    def contour(self) -> Times:
        """The time to read and mill the blocks of the contour, which Chapter 7 gives."""
        return Times(self.read_seconds * self.milling_blocks, 0, 0, self.times.milling, 0)

    def clock(self) -> Iterator[float]:
        """Yield for each step the second at which it ends."""
        now = 0.0
        for step in self.steps:
            now += self.read_seconds + step.tool_changed * self.tool_change_seconds
            now += sum(move.seconds for move in step.moves)
            yield now

    @cached_property
    def starts(self) -> list[float]:
        """The second at which each block begins to be read."""
        return [0.0, *self.clock()][:-1]

    @cached_property
    def knots(self) -> list[Knot]:
        """The cutter's path from the parking place on."""
        found = [Knot(0.0, 0.0, 0.0, False)]
        for start, step in zip(self.starts, self.steps, strict=True):
            now = start + self.read_seconds + step.tool_changed * self.tool_change_seconds
            found += [Knot(now, move.start.x, move.start.y, False) for move in step.moves[:1]]
            for move in step.moves:
                now += move.seconds
                found.append(Knot(now, move.end.x, move.end.y, _SPENT[move.kind] != "positioning"))
        return found

    @cached_property
    def _seconds(self) -> list[float]:
        return [knot.second for knot in self.knots]

    def at(self, second: float) -> Place:
        """Return where the cutter is at a second."""
        knot = max(0, bisect_left(self._seconds, second) - 1)
        block = bisect_left(self.starts, second) - 1
        since, x, y, _ = self.knots[knot]
        if knot == len(self.knots) - 1 or second <= since:
            return Place(knot, x, y, False, block)
        following = self.knots[knot + 1]
        part = (second - since) / (following.second - since)
        x, y = x + (following.x - x) * part, y + (following.y - y) * part
        return Place(knot, x, y, following.down, block)

    @property
    def first(self) -> Place:
        """The cutter's place before it first cuts, as if no block had been read."""
        cuts = (at for at, knot in enumerate(self.knots) if knot.down)
        knot = max(1, next(cuts, 1)) - 1
        return Place(knot, self.knots[knot].x, self.knots[knot].y, False, -1)

    def row(self, second: float) -> int:
        """Return the row that is under the reader's head at a second, counted from the first one punched."""
        block = bisect_left(self.starts, second) - 1
        if block < 0:
            return 0
        passed = int((second - self.starts[block]) / self.read_seconds * ROWS)
        return block * ROWS + min(ROWS - 1, passed)

    @cached_property
    def cuts(self) -> tuple[Move, ...]:
        """The milling moves, in order."""
        return tuple(move for move in self.moves if move.kind is MoveKind.MILL)

    @property
    def gap(self) -> float:
        """The distance from the end of the milling to its start, in thousandths; 0 if nothing is milled."""
        if not self.cuts:
            return 0.0
        return self.cuts[0].start.distance(self.cuts[-1].end)

    @cached_property
    def holes(self) -> tuple[Position, ...]:
        """Where the cutter was fed to its full depth without milling: drilled, bored or tapped."""
        return tuple(
            Position(step.block.x, step.block.y, step.modes.final_depth)
            for step in self.steps
            if step.block.preparatory in HOLE_MAKING
        )
