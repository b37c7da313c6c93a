"""The Moog Hydra-Point 83-1000 MC: what each block makes it do, and for how long.

    read the block (2 s) ─► set modes ─► move ─► tool change, stop

    position        quill up, X and Y each at 300 in/min
    mill            quill down to final depth at the Z feed, then X and Y each at its own feed
    drill, bore,    quill up, position, down to the Z feed point at 300 in/min, in to final depth at the
    peck, tap       Z feed, up again: to zero, or to the Z feed point while partial retract is on
    read Z          X and Y of the block are the Z feed point and the final depth; nothing moves

The axes are not interpolated: with two feeds the cutter moves along their slope until one axis arrives, then
only the other moves (thesis, Figure 3.1). X, Y and the quill begin at zero. The operator presses START after
every stop; the operator's time and the time of indexing are not counted.

The thesis does not say the following; this machine assumes it. The quill moves at the positioning speed
outside the work. Where it is in the work already, milling at another final depth, deeper or not, feeds it
there. Bored and tapped holes are left at the Z feed, drilled ones at positioning speed. A peck
withdraws to the Z feed point. The quill goes up for a tool change and for indexing, after the block's moves.
Program stop, end of program and manual tool change each wait for START, and the tape continues after them. An
automatic tool change with tool function 00 selects the next tool of the carousel, 01 after 24: Chapter 2 has
random and sequential tool selection and gives no code for the second. A tool change takes the time given in
the settings, by default none.

Not emulated: pneumatics and hydraulics, backlash, settling, the zero adjustment, the pitch of a tap (it
runs at the Z feed), spindle start and stop, the manual dials, positioning errors of .0003 in.

Source: thesis, Chapters 2 and 3, Tables 2.3 and 2.4; 2 s a block: Chapters 7 and 10.
"""

from collections.abc import Iterator
from dataclasses import dataclass, replace
from math import sqrt

from nc.blocks import BlockError, Row, read
from nc.path import Modes, Move, MoveKind, Path, Position, Step
from tapes.errors import WorkError
from tapes.hydrapoint import (
    CAROUSEL,
    COOLANT,
    FEED_TOLERANCE,
    MISCELLANEOUS,
    NEXT_TOOL,
    POSITIONING_SPEED,
    SPINDLE,
    STOPS,
    XY_FEED,
    Z_FEED,
    Block,
    Miscellaneous,
    Preparatory,
    corner,
)

READ_SECONDS = 2.0
"""Seconds the pneumatic reader takes for a block (Chapters 7 and 10)."""

_UNITS = 1000
_FEED_OUT = frozenset({Preparatory.TAP_FEED, Preparatory.BORE, Preparatory.TAP_PITCH})
_QUILL_UP = frozenset({Miscellaneous.MANUAL_TOOL_CHANGE, Miscellaneous.INDEX, Miscellaneous.TOOL_CHANGE})


@dataclass(frozen=True)
class Settings:
    """How the machine is set: feed errors of X, Y, Z as fractions within +-0.2; a milling `feed_code` in
    place of the tape's; `peck` in thousandths; `read_seconds` a block.
    """

    feed_error: tuple[float, float, float] = (0.0, 0.0, 0.0)
    feed_code: int | None = None
    tool_change_seconds: float = 0.0
    peck: int = 100
    read_seconds: float = READ_SECONDS

    def __post_init__(self) -> None:
        """Raise WorkError for a setting that the machine does not have."""
        for axis, error in zip("XYZ", self.feed_error, strict=True):
            if not abs(error) <= FEED_TOLERANCE:
                raise WorkError(
                    f"{axis} feed error {100 * error:+.0f}%: must be within {100 * FEED_TOLERANCE:.0f}%"
                )
        if self.feed_code is not None and self.feed_code not in XY_FEED:
            raise WorkError(f"unknown feed code {self.feed_code:02}: Table 2.4 has 01 to 18")
        if not self.tool_change_seconds >= 0:
            raise WorkError(f"tool change of {self.tool_change_seconds:g} s: must be 0 or more")
        if self.peck < 1:
            raise WorkError(f"peck of {self.peck} thousandths: must be 1 or more")
        if not self.read_seconds >= 0:
            raise WorkError(f"reading time of {self.read_seconds:g} s a block: must be 0 or more")


class CutError(BlockError):
    """A block the machine refuses, with the path of the blocks before it."""

    def __init__(self, error: BlockError, path: Path) -> None:
        super().__init__(error.reason, error.frame or 0, error.block, error.row)
        self.path = path


class HydraPoint:
    """The machine between two blocks: the place of the cutter and what is in force."""

    def __init__(self, settings: Settings | None = None) -> None:
        self.settings = settings or Settings()
        self.modes = Modes()
        self.at = Position(0, 0, 0)

    def carry_out(self, place: Row, block: Block) -> Step:
        """Carry out one block, whole or not at all. Raises BlockError, before anything moves or changes."""
        modes = self._set(block)
        moves = tuple(_Motion(place, block, self.at, modes, self.settings).moves())
        self.modes = modes
        self.at = moves[-1].end if moves else self.at
        changed = block.miscellaneous == Miscellaneous.TOOL_CHANGE
        stop = MISCELLANEOUS[block.miscellaneous] if block.miscellaneous in STOPS else None
        return Step(place.number, place.frames[0], block, moves, modes, self.at, changed, stop)

    def _set(self, block: Block) -> Modes:
        """Return the modes in force with this block: its preparatory and miscellaneous functions set them."""
        modes = self.modes
        if block.preparatory == Preparatory.READ_Z:
            modes = replace(modes, feed_point=block.x, final_depth=block.y)
        function = block.miscellaneous
        if function == Miscellaneous.X_FEED:
            feed = self._xy_feed(block.tool, axis=0)
            return modes if feed == modes.x_feed else replace(modes, x_feed=feed)
        if function == Miscellaneous.Y_FEED:
            feed = self._xy_feed(block.tool, axis=1)
            return modes if feed == modes.y_feed else replace(modes, y_feed=feed)
        if function == Miscellaneous.Z_FEED:
            return replace(modes, z_feed=Z_FEED[block.tool] * (1 + self.settings.feed_error[2]))
        if function == Miscellaneous.SPINDLE_SPEED:
            return replace(modes, spindle=SPINDLE[block.tool])
        if function == Miscellaneous.TOOL_CHANGE:
            following = CAROUSEL[(modes.tool or 0) % len(CAROUSEL)]
            return replace(modes, tool=following if block.tool == NEXT_TOOL else block.tool)
        if function == Miscellaneous.MANUAL_TOOL_CHANGE and block.tool:
            return replace(modes, tool=block.tool)
        if function in COOLANT:
            return replace(modes, coolant=COOLANT[function])
        if function in (Miscellaneous.PARTIAL_RETRACT_ON, Miscellaneous.PARTIAL_RETRACT_OFF):
            return replace(modes, partial_retract=function == Miscellaneous.PARTIAL_RETRACT_ON)
        return modes

    def _xy_feed(self, code: int, axis: int) -> float:
        return XY_FEED[self.settings.feed_code or code] * (1 + self.settings.feed_error[axis])


@dataclass
class _Motion:
    """The moves of one block, from where the cutter is."""

    place: Row
    block: Block
    at: Position
    modes: Modes
    settings: Settings

    def moves(self) -> Iterator[Move]:
        preparatory = self.block.preparatory
        if preparatory == Preparatory.POSITION:
            yield from self._quill(MoveKind.RETRACT, min(self.at.z, self._clear()))
            yield from self._table(MoveKind.POSITION, POSITIONING_SPEED, POSITIONING_SPEED)
        elif preparatory == Preparatory.MILL:
            yield from self._mill()
        elif preparatory != Preparatory.READ_Z:
            yield from self._make_hole()
        if self.block.miscellaneous in _QUILL_UP:
            yield from self._quill(MoveKind.RETRACT, 0)

    def _clear(self) -> int:
        """Return the depth of the quill between two places."""
        return (self.modes.feed_point or 0) if self.modes.partial_retract else 0

    def _mill(self) -> Iterator[Move]:
        x_feed, y_feed = self.modes.x_feed, self.modes.y_feed
        if self.block.x != self.at.x and x_feed is None:
            raise self._unset("milling along X needs an X feed (miscellaneous function 84)", "one")
        if self.block.y != self.at.y and y_feed is None:
            raise self._unset("milling along Y needs a Y feed (miscellaneous function 85)", "one")
        feed_point, final_depth = self._depths()
        if self.at.z != final_depth:
            yield from self._quill(MoveKind.APPROACH, max(self.at.z, feed_point))
            yield from self._quill(MoveKind.FEED_IN, final_depth)
        yield from self._table(MoveKind.MILL, x_feed or 0, y_feed or 0)

    def _make_hole(self) -> Iterator[Move]:
        feed_point, final_depth = self._depths()
        yield from self._quill(MoveKind.RETRACT, min(self.at.z, self._clear()))
        yield from self._table(MoveKind.POSITION, POSITIONING_SPEED, POSITIONING_SPEED)
        yield from self._quill(MoveKind.APPROACH, feed_point)
        if self.block.preparatory == Preparatory.PECK:
            for depth in range(feed_point + self.settings.peck, final_depth, self.settings.peck):
                yield from self._quill(MoveKind.FEED_IN, depth)
                yield from self._quill(MoveKind.RETRACT, feed_point)
                yield from self._quill(MoveKind.APPROACH, depth)
        yield from self._quill(MoveKind.FEED_IN, final_depth)
        if self.block.preparatory in _FEED_OUT:
            yield from self._quill(MoveKind.FEED_OUT, feed_point)
        yield from self._quill(MoveKind.RETRACT, self._clear())

    def _depths(self) -> tuple[int, int]:
        if self.modes.feed_point is None:
            raise self._unset("the quill needs depths (preparatory function 9)", "them")
        if self.modes.z_feed is None:
            raise self._unset("the quill needs a Z feed (miscellaneous function 89)", "one")
        return self.modes.feed_point, self.modes.final_depth

    def _unset(self, need: str, what: str) -> BlockError:
        return self.place.error(4, f"{need}; no block has set {what}")

    def _quill(self, kind: MoveKind, depth: float) -> Iterator[Move]:
        if depth == self.at.z:
            return
        is_fed = kind in (MoveKind.FEED_IN, MoveKind.FEED_OUT)
        speed = (self.modes.z_feed or 0) if is_fed else POSITIONING_SPEED
        yield self._move(kind, Position(self.at.x, self.at.y, depth), speed)

    def _table(self, kind: MoveKind, x_speed: float, y_speed: float) -> Iterator[Move]:
        """Move X and Y to the block's place, at their own speeds: both, until one arrives, then the other."""
        x, y, z = self.at
        together = corner((x, y), (self.block.x, self.block.y), x_speed, y_speed)
        if together != (x, y):
            yield self._move(kind, Position(*together, z), sqrt(x_speed * x_speed + y_speed * y_speed))
        if self.at.x != self.block.x:
            yield self._move(kind, Position(self.block.x, self.at.y, z), x_speed)
        if self.at.y != self.block.y:
            yield self._move(kind, Position(self.at.x, self.block.y, z), y_speed)

    def _move(self, kind: MoveKind, end: Position, speed: float) -> Move:
        start, self.at = self.at, end
        return Move(kind, start, end, speed, start.distance(end) / _UNITS / speed * 60)


def cut(frames: bytes, *, strict: bool = False, settings: Settings | None = None) -> Path:
    """Carry out the tape. Raises CutError, with the path so far, at a bad block, or TapeError."""
    machine = HydraPoint(settings)
    steps: list[Step] = []

    failure: BlockError | None = None
    try:
        for place, block in read(frames, strict):
            steps.append(machine.carry_out(place, block))
    except BlockError as error:
        failure = error
    path = Path(tuple(steps), machine.settings.read_seconds, machine.settings.tool_change_seconds)
    if failure:
        raise CutError(failure, path) from failure
    return path
