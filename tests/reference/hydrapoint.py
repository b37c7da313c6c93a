"""A second Hydra-Point, written from the thesis's Chapters 2 and 3: it shares nothing with nc/ or tapes/.

Lengths are thousandths of an inch, times are exact seconds. What the thesis leaves open is decided here once:
the methods of `HydraPoint` say so with "open:".
"""

from collections.abc import Iterator
from fractions import Fraction
from typing import NamedTuple

SENSED = 0o217  # channels 1-4 and 8; the head masks the others
END_OF_BLOCK = 0o200
ROWS = 20
TRAVEL = (20000, 10000, 5000)
RAPID = Fraction(300)
READING = 2  # seconds a block

# Table 2.4, line by line: code, X and Y feed, Z feed, spindle; code, spindle.
TABLE_2_4 = """\
01 1.0 1.0 65 21 525
02 1.9 2.1 75 22 625
03 2.7 3.6 91 23 760
04 4.0 5.3 105 24 875
05 5.5 8.1 120 25 1015
06 7.2 10.3 140 26 1140
07 9.1 13.3 155 27 1300
08 11.2 16.4 175 28 1450
09 13.3 20 195 29 1610
10 16.0 25 215 30 1800
11 18.6 28 240 31 2000
12 21.5 32 270 32 2225
13 24.7 37 300 33 2470
14 27.9 42 330 34 2740
15 31.5 48 375 35 3100
16 35.6 53 415 36 3450
17 39.7 59 465 37 3830
18 44.0 64 495 38 4090"""
XY_FEEDS = {int(line.split()[0]): Fraction(line.split()[1]) for line in TABLE_2_4.splitlines()}
Z_FEEDS = {int(line.split()[0]): Fraction(line.split()[2]) for line in TABLE_2_4.splitlines()}
SPEEDS = {
    int(line.split()[i]): int(line.split()[i + 1 + 2 * (i == 0)])
    for line in TABLE_2_4.splitlines()
    for i in (0, 4)
}

# Table 2.3.
POSITION, TAP_FEED, PECK, DRILL, MILL, BORE, TAP_PITCH, READ_Z = 0, 1, 4, 5, 6, 7, 8, 9
HOLES = (TAP_FEED, PECK, DRILL, BORE, TAP_PITCH)
PREPARATORY = (POSITION, MILL, READ_Z, *HOLES)
STOPS = (0, 2, 6)
COOLANT = {7: "flood", 8: "mist", 9: "off"}
MISCELLANEOUS = (*STOPS, *COOLANT, *range(80, 87), 88, 89)


class RefusedError(Exception):
    """A tape or block that the machine cannot carry out: the block's place on the tape, from 1, and why."""

    def __init__(self, block: int, why: str) -> None:
        super().__init__(block, why)
        self.block, self.why = block, why


class Block(NamedTuple):
    """What a block's digits say."""

    preparatory: int
    x: int
    y: int
    reserved: int
    tool: int
    miscellaneous: int


class Leg(NamedTuple):
    """A straight piece of the tool's way: its block, its end, its speed (None where rapid), its seconds."""

    block: int
    end: tuple[Fraction, Fraction, Fraction]
    rapid: bool
    seconds: Fraction


def blocks(frames: bytes) -> Iterator[Block]:
    """Yield the blocks of a tape; rows before the first block and blank tape after the last one do not count."""
    rows = [frame & SENSED for frame in frames]
    while rows and not rows[-1]:
        rows.pop()
    if END_OF_BLOCK not in rows:
        raise RefusedError(1, "no end of block")
    start = rows.index(END_OF_BLOCK) - (ROWS - 1)
    if start < 0:
        raise RefusedError(1, "short")
    for number, at in enumerate(range(start, len(rows), ROWS), 1):
        block = rows[at : at + ROWS]
        if len(block) < ROWS or block[-1] != END_OF_BLOCK or any(row > 9 for row in block[:-1]):
            raise RefusedError(number, "rows")
        digits = "".join(map(str, block[:-1]))
        yield Block(*(int(digits[a:b]) for a, b in ((3, 4), (4, 9), (9, 14), (14, 15), (15, 17), (17, 19))))


class HydraPoint:
    """The machine while a tape runs: where it is, which modes hold, and every leg so far."""

    def __init__(self) -> None:
        self.at = [Fraction(0)] * 3
        self.feeds: list[Fraction | None] = [None, None, None]
        self.feed_point: int | None = None
        self.depth = 0
        self.partial = False
        self.coolant = "off"
        self.speed = 0
        self.tool = 0
        self.legs: list[Leg] = []
        self.stops: list[int] = []
        self.block = 0
        self.read = 0

    @property
    def seconds(self) -> Fraction:
        """Return the machining time: the reading of every block and every leg."""
        return READING * self.read + sum((leg.seconds for leg in self.legs), Fraction(0))

    def run(self, frames: bytes) -> None:
        """Carry out a tape to its end."""
        for self.block, block in enumerate(blocks(frames), 1):
            self.read += 1
            self._obey(block)

    def _refuse(self, why: str) -> None:
        raise RefusedError(self.block, why)

    def _obey(self, block: Block) -> None:
        if block.preparatory not in PREPARATORY:
            self._refuse("preparatory")
        if block.miscellaneous not in MISCELLANEOUS:
            self._refuse("miscellaneous")
        if block.reserved:
            self._refuse("reserved")
        self._modes(block)
        if block.preparatory == READ_Z:
            self._read_z(block.x, block.y)
        else:
            if block.x > TRAVEL[0] or block.y > TRAVEL[1]:
                self._refuse("travel")
            self._move(block.preparatory, Fraction(block.x), Fraction(block.y))
        if block.miscellaneous in STOPS:
            self.stops.append(self.block)

    def _modes(self, block: Block) -> None:
        """Carry out what the block says beside its motion, before it: the first contour block sets its own feed.

        Open: whether the quill goes up for a tool change or an index; here it does, all the way.
        """
        code = block.tool
        match block.miscellaneous:
            case 7 | 8 | 9 as coolant:
                self.coolant = COOLANT[coolant]
            case 81:
                self.partial = True
            case 82:
                self.partial = False
            case 83 | 86 as function:
                self._quill(Fraction(0), rapid=True)
                if function == 86:
                    if not 1 <= code <= 24:
                        self._refuse("tool")
                    self.tool = code
            case 84 | 85 | 89 as axis:
                table = Z_FEEDS if axis == 89 else XY_FEEDS
                if code not in table:
                    self._refuse("feed")
                self.feeds[{84: 0, 85: 1, 89: 2}[axis]] = table[code]
            case 88:
                if code not in SPEEDS:
                    self._refuse("speed")
                self.speed = SPEEDS[code]

    def _read_z(self, point: int, depth: int) -> None:
        if max(point, depth) > TRAVEL[2]:
            self._refuse("travel")
        if depth < point:
            self._refuse("depth")
        self.feed_point, self.depth = point, depth

    def _move(self, function: int, x: Fraction, y: Fraction) -> None:
        if function == MILL:
            self._plunge()
            self._feed_table(x, y)
            return
        self._retract()
        self._rapid_table(x, y)
        if function in HOLES:
            self._hole(function)

    def _retract(self) -> None:
        """Take the quill out of the work: to the feed point with partial retract, else all the way up."""
        if self.partial and self.feed_point is not None:
            self._quill(min(self.at[2], Fraction(self.feed_point)), rapid=True)
        else:
            self._quill(Fraction(0), rapid=True)

    def _plunge(self) -> None:
        """Go to the final depth: rapidly to the feed point, from there at Z's feed."""
        if self.feed_point is None:
            self._refuse("no depth")
            return
        if self.at[2] > self.depth:
            self._retract()
        if self.at[2] < self.feed_point:
            self._quill(Fraction(self.feed_point), rapid=True)
        self._quill(Fraction(self.depth))

    def _hole(self, function: int) -> None:
        """Make a hole. Open: how deep a peck is, here none; what tapping adds; boring and tapping feed out."""
        self._plunge()
        if function in (BORE, TAP_FEED, TAP_PITCH) and self.feed_point is not None:
            self._quill(Fraction(self.feed_point))
        self._retract()

    def _quill(self, z: Fraction, rapid: bool = False) -> None:
        """Move the quill alone. Open: its rapid speed; here the table's."""
        distance = abs(z - self.at[2])
        if distance:
            self._leg([self.at[0], self.at[1], z], rapid, distance / self._rate(2, rapid))

    def _rate(self, axis: int, rapid: bool) -> Fraction:
        """Return the speed of an axis in thousandths a second."""
        feed = RAPID if rapid else self.feeds[axis]
        if feed is None:
            self._refuse("no feed")
        assert feed is not None
        return feed * 1000 / 60

    def _rapid_table(self, x: Fraction, y: Fraction) -> None:
        """Position: both axes at once, each at full speed. Open: whether one line; here it is drawn as one."""
        distance = max(abs(x - self.at[0]), abs(y - self.at[1]))
        if distance:
            self._leg([x, y, self.at[2]], True, distance / self._rate(0, True))

    def _feed_table(self, x: Fraction, y: Fraction) -> None:
        """Mill: each axis at its own feed until it is there, so that a second axis leaves a bend."""
        goal = (x, y)
        left = {
            axis: abs(goal[axis] - self.at[axis]) / self._rate(axis, False)
            for axis in (0, 1)
            if goal[axis] != self.at[axis]
        }
        for seconds in sorted(set(left.values())):
            spent = seconds - max((s for s in left.values() if s < seconds), default=Fraction(0))
            end = list(self.at)
            for axis, needs in left.items():
                if needs >= seconds:
                    way = self._rate(axis, False) * spent
                    end[axis] += way if goal[axis] > self.at[axis] else -way
            self._leg(end, False, spent)

    def _leg(self, end: list[Fraction], rapid: bool, seconds: Fraction) -> None:
        self.at = list(end)
        self.legs.append(Leg(self.block, (end[0], end[1], end[2]), rapid, seconds))
