"""The Moog Hydra-Point 83-1000 MC: what each block makes it do, and for how long.

    read the block (2 s) ─► set modes ─► move ─► tool change, stop

    position        quill up, X and Y each at 300 in/min
    mill            quill down to final depth at the Z feed, then X and Y each at its own feed
    drill, bore,    quill up, position, down to the Z feed point at 300 in/min, in to final depth at the
    peck, tap       Z feed, up again: to zero, or to the Z feed point while partial retract is on
    read Z          X and Y of the block are the Z feed point and the final depth; nothing moves

The axes are not interpolated: with two feeds the cutter runs at their slope until one axis has arrived, and
the other goes on alone (thesis, Figure 3.1). X, Y and the quill begin at zero. The operator presses START
after every stop and nobody counts his time, nor what indexing takes.

What the thesis does not say, and this machine therefore assumes: the quill moves at the positioning speed
outside the work; bored and tapped holes are left at the Z feed, drilled ones at positioning speed; the
quill goes up for a tool change and for indexing; program stop, end of program and manual tool change each
wait for START, and the tape goes on after them. A tool change takes the seconds it is given, none unless
told.

Not emulated: pneumatics and hydraulics, backlash, settling, the zero adjustment, the pitch of a tap (it
runs at the Z feed), spindle start and stop, the manual dials, positioning errors of .0003 in.

Source: thesis, Chapters 2 and 3, Tables 2.3 and 2.4; 2 s a block: Chapters 7 and 10.
"""

from collections.abc import Iterator
from dataclasses import dataclass, replace
from math import copysign, dist, hypot

from nc.blocks import BlockError, Row, read
from nc.path import Kind, Modes, Move, Path, Point, Step
from tapes.errors import WorkError
from tapes.hydrapoint import FEED_TOLERANCE, POSITIONING_SPEED, SPINDLE, XY_FEED, Z_FEED, Block

READ_SECONDS = 2.0
_UNITS = 1000
_STOPS = {0: "program stop", 2: "end of program", 6: "tool change, manual"}
_COOLANT = {7: "flood", 8: "mist", 9: "off"}
_FEED_OUT = frozenset({1, 7, 8})


@dataclass(frozen=True)
class Settings:
    """How the machine stands on the day. Feed errors are parts of one, of X, Y and Z, within +-0.2.

    `feed_code` mills at this code of Table 2.4 in place of the tape's; `peck` is a peck's depth in
    thousandths.
    """

    feed_error: tuple[float, float, float] = (0.0, 0.0, 0.0)
    feed_code: int | None = None
    tool_change_seconds: float = 0.0
    peck: int = 100

    def __post_init__(self) -> None:
        """Raise WorkError for what the machine cannot be."""
        for axis, error in zip("XYZ", self.feed_error, strict=True):
            if not abs(error) <= FEED_TOLERANCE:
                raise WorkError(f"{axis} feed error {error:+.0%}: the machine keeps its feeds within 20 %")
        if self.feed_code is not None and self.feed_code not in XY_FEED:
            raise WorkError(f"unknown feed code {self.feed_code:02}: Table 2.4 has 01 to 18")
        if self.tool_change_seconds < 0:
            raise WorkError("a tool change takes no less than 0 seconds")
        if self.peck < 1:
            raise WorkError("a peck is at least .001 in deep")


class CutError(BlockError):
    """A block the machine refuses, with the path of the blocks before it."""

    def __init__(self, error: BlockError, path: Path) -> None:
        super().__init__(error.reason, error.frame or 0, error.block, error.row)
        self.path = path


class HydraPoint:
    """The machine between two blocks: where the cutter is and what is in force."""

    def __init__(self, settings: Settings | None = None) -> None:
        self.settings = settings or Settings()
        self.modes = Modes()
        self.at = Point(0, 0, 0)

    def carry_out(self, place: Row, block: Block) -> Step:
        """Carry out one block, whole or not at all. Raises BlockError, before anything moves or changes."""
        modes = self._set(block)
        moves = tuple(_Motion(place, block, self.at, modes, self.settings).moves())
        self.modes = modes
        self.at = moves[-1].end if moves else self.at
        changed = block.miscellaneous == 86
        stop = _STOPS.get(block.miscellaneous)
        return Step(place.number, place.frame, block, moves, modes, self.at, changed, stop)

    def _set(self, block: Block) -> Modes:
        """Return the modes in force with this block: its preparatory and miscellaneous functions set them."""
        modes = self.modes
        if block.preparatory == 9:
            modes = replace(modes, feed_point=block.x, final_depth=block.y)
        match block.miscellaneous:
            case 84 if modes.x_feed != (feed := self._xy_feed(block.tool, axis=0)):
                return replace(modes, x_feed=feed)
            case 85 if modes.y_feed != (feed := self._xy_feed(block.tool, axis=1)):
                return replace(modes, y_feed=feed)
            case 89:
                return replace(modes, z_feed=Z_FEED[block.tool] * (1 + self.settings.feed_error[2]))
            case 88:
                return replace(modes, spindle=SPINDLE[block.tool])
            case 86:
                return replace(modes, tool=block.tool)
            case 6 if block.tool:
                return replace(modes, tool=block.tool)
            case 7 | 8 | 9 as coolant:
                return replace(modes, coolant=_COOLANT[coolant])
            case 81 | 82 as retract:
                return replace(modes, partial_retract=retract == 81)
        return modes

    def _xy_feed(self, code: int, axis: int) -> float:
        return XY_FEED[self.settings.feed_code or code] * (1 + self.settings.feed_error[axis])


@dataclass
class _Motion:
    """The moves of one block, from where the cutter is."""

    place: Row
    block: Block
    at: Point
    modes: Modes
    settings: Settings

    def moves(self) -> Iterator[Move]:
        match self.block.preparatory:
            case 0:
                yield from self._quill(Kind.RETRACT, min(self.at.z, self._clear()))
                yield from self._table(Kind.POSITION, POSITIONING_SPEED, POSITIONING_SPEED)
            case 6:
                yield from self._mill()
            case 9:
                pass
            case _:
                yield from self._make_hole()
        if self.block.miscellaneous in (6, 83, 86):
            yield from self._quill(Kind.RETRACT, 0)

    def _clear(self) -> int:
        """Return where the quill waits between two places."""
        return (self.modes.feed_point or 0) if self.modes.partial_retract else 0

    def _mill(self) -> Iterator[Move]:
        x_feed, y_feed = self.modes.x_feed, self.modes.y_feed
        if self.block.x != self.at.x and x_feed is None:
            raise self.place.error(4, "X is to be milled, but no X feed has been given")
        if self.block.y != self.at.y and y_feed is None:
            raise self.place.error(4, "Y is to be milled, but no Y feed has been given")
        feed_point, final_depth = self._depths()
        if self.at.z != final_depth:
            yield from self._quill(Kind.APPROACH, max(self.at.z, feed_point))
            yield from self._quill(Kind.FEED_IN, final_depth)
        yield from self._table(Kind.MILL, x_feed or 0, y_feed or 0)

    def _make_hole(self) -> Iterator[Move]:
        feed_point, final_depth = self._depths()
        yield from self._quill(Kind.RETRACT, min(self.at.z, self._clear()))
        yield from self._table(Kind.POSITION, POSITIONING_SPEED, POSITIONING_SPEED)
        yield from self._quill(Kind.APPROACH, feed_point)
        if self.block.preparatory == 4:
            for depth in range(feed_point + self.settings.peck, final_depth, self.settings.peck):
                yield from self._quill(Kind.FEED_IN, depth)
                yield from self._quill(Kind.RETRACT, feed_point)
                yield from self._quill(Kind.APPROACH, depth)
        yield from self._quill(Kind.FEED_IN, final_depth)
        if self.block.preparatory in _FEED_OUT:
            yield from self._quill(Kind.FEED_OUT, feed_point)
        yield from self._quill(Kind.RETRACT, self._clear())

    def _depths(self) -> tuple[int, int]:
        if self.modes.feed_point is None or self.modes.final_depth is None:
            raise self.place.error(4, "the quill is to go down, but no block has read Z")
        if self.modes.z_feed is None:
            raise self.place.error(4, "the quill is to go down, but no Z feed has been given")
        return self.modes.feed_point, self.modes.final_depth

    def _quill(self, kind: Kind, depth: float) -> Iterator[Move]:
        if depth == self.at.z:
            return
        speed = POSITIONING_SPEED
        if kind in (Kind.FEED_IN, Kind.FEED_OUT):
            assert self.modes.z_feed is not None
            speed = self.modes.z_feed
        yield self._move(kind, Point(self.at.x, self.at.y, depth), speed)

    def _table(self, kind: Kind, x_speed: float, y_speed: float) -> Iterator[Move]:
        """Move X and Y to the block's place, each at its own speed: together, then the one left alone."""
        x, y, z = self.at
        dx, dy = self.block.x - x, self.block.y - y
        if dx and dy:
            x_time, y_time = abs(dx) / x_speed, abs(dy) / y_speed
            time = min(x_time, y_time)
            corner = Point(
                self.block.x if x_time <= y_time else x + copysign(x_speed * time, dx),
                self.block.y if y_time <= x_time else y + copysign(y_speed * time, dy),
                z,
            )
            yield self._move(kind, corner, hypot(x_speed, y_speed))
        if self.at.x != self.block.x:
            yield self._move(kind, Point(self.block.x, self.at.y, z), x_speed)
        if self.at.y != self.block.y:
            yield self._move(kind, Point(self.at.x, self.block.y, z), y_speed)

    def _move(self, kind: Kind, end: Point, speed: float) -> Move:
        start, self.at = self.at, end
        return Move(kind, start, end, speed, dist(start, end) / _UNITS / speed * 60)


def cut(frames: bytes, *, strict: bool = False, settings: Settings | None = None) -> Path:
    """Let the machine read the tape and carry out its blocks.

    Raises CutError, with the path so far, at the first block that is refused; TapeError if nothing is
    punched.
    """
    machine = HydraPoint(settings)
    steps: list[Step] = []

    def path() -> Path:
        return Path(tuple(steps), READ_SECONDS, machine.settings.tool_change_seconds)

    try:
        for place, block in read(frames, strict):
            steps.append(machine.carry_out(place, block))
    except BlockError as error:
        raise CutError(error, path()) from error
    return path()
