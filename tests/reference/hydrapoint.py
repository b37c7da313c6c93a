"""A second Hydra-Point, written from the thesis's Chapters 2 and 3: it shares nothing with nc/ or tapes/.

Lengths are thousandths of an inch; times are exact, in seconds. Where the thesis leaves something open, the
assumptions of nc/machine.py hold here too, marked "open": there the two cannot judge each other.
"""

from collections.abc import Iterator, Sequence
from fractions import Fraction
from typing import NamedTuple

SENSED = 0o217  # channels 1-4 and 8; the head masks the others
END_OF_BLOCK = 0o200
ROWS = 20
TRAVEL = (20000, 10000, 5000)
RAPID = Fraction(300)
READING = 2  # seconds a block
THOUSANDTHS_A_SECOND = Fraction(1000, 60)  # for each inch a minute

# Table 2.4, line by line: code, X and Y feed, Z feed, spindle; code, spindle.
TABLE_2_4 = [
    line.split()
    for line in """\
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
18 44.0 64 495 38 4090""".splitlines()
]
XY_FEEDS = {int(code): Fraction(feed) for code, feed, *_ in TABLE_2_4}
Z_FEEDS = {int(code): Fraction(feed) for code, _, feed, *_ in TABLE_2_4}
SPEEDS = {int(row[at]): int(row[speed]) for row in TABLE_2_4 for at, speed in ((0, 3), (4, 5))}

# Table 2.3.
POSITION, TAP_FEED, PECK, DRILL, MILL, BORE, TAP_PITCH, READ_Z = 0, 1, 4, 5, 6, 7, 8, 9
HOLES = (TAP_FEED, PECK, DRILL, BORE, TAP_PITCH)
PREPARATORY = (POSITION, MILL, READ_Z, *HOLES)
STOPS = (0, 2, 6)
QUILL_UP = (6, 83, 86)  # open: for these the quill goes up after the block's moves
COOLANT = {7: "flood", 8: "mist", 9: "off"}
MISCELLANEOUS = (*STOPS, *COOLANT, *range(80, 87), 88, 89)
SELECTS = {84: (*XY_FEEDS,), 85: (*XY_FEEDS,), 86: (*range(25),), 88: (*SPEEDS,), 89: (*Z_FEEDS,)}
"""The tool functions of those that have one: a feed, a tool, 00 for the next, or a speed."""


class RefusedError(Exception):
    """What the machine cannot carry out: the block's number, the rows to blame, from 1, and their frames."""

    def __init__(self, block: int, frame: int, *rows: int) -> None:
        super().__init__(block, rows)
        self.places = [(block, row, frame + row - 1) for row in rows]


class Block(NamedTuple):
    """The frame of a block's first row, and what its digits say."""

    frame: int
    sequence: int
    preparatory: int
    x: int
    y: int
    reserved: int
    tool: int
    miscellaneous: int


class Leg(NamedTuple):
    """A straight piece of the cutter's way: where it ends, whether at 300 in/min, its seconds."""

    end: tuple[Fraction, ...]
    rapid: bool
    seconds: Fraction


def blocks(frames: bytes) -> Iterator[Block]:
    """Yield the blocks of a tape, blank leader and trailer left out.

    Zeros are punched 040 or, on a tape without parity, not at all: only there do blank rows before the first
    hole belong to the first block, as many as it needs.
    """
    rows = [frame & SENSED for frame in frames]
    start = next(at for at, frame in enumerate(frames) if frame)
    if not any(frame & ~SENSED for frame in frames) and END_OF_BLOCK in rows:
        start = min(start, max(rows.index(END_OF_BLOCK) - (ROWS - 1), 0))
    for number, at in enumerate(range(start, len(frames.rstrip(b"\0")), ROWS), 1):
        block = rows[at : at + ROWS]
        for row, value in enumerate(block, 1):
            if value > 9 and (value != END_OF_BLOCK or row < ROWS):
                raise RefusedError(number, at, row)
        if block[-1] != END_OF_BLOCK or len(block) < ROWS:
            raise RefusedError(number, at, len(block))
        digits = "".join(map(str, block[:-1]))
        fields = ((0, 3), (3, 4), (4, 9), (9, 14), (14, 15), (15, 17), (17, 19))
        yield Block(at, *(int(digits[first:last]) for first, last in fields))


class HydraPoint:
    """The machine while a tape runs: where it is, what is in force, and for each block its legs."""

    def __init__(self, peck: int = 100, errors: Sequence[Fraction] = (Fraction(0),) * 3) -> None:
        self.peck = peck
        self.right = [1 + error for error in errors]
        self.at = [Fraction(0)] * 3
        self.feeds: list[Fraction | None] = [None, None, None]
        self.feed_point: int | None = None
        self.depth = 0
        self.partial = False
        self.coolant = "off"
        self.speed: int | None = None
        self.tool: int | None = None
        self.legs: list[Leg] = []
        self.done: list[list[Leg]] = []
        self.stops: list[int] = []

    @property
    def seconds(self) -> Fraction:
        """Return the machining time: the reading of every block and every leg."""
        legs = sum((leg.seconds for legs in self.done for leg in legs), Fraction(0))
        return READING * len(self.done) + legs

    @property
    def state(self) -> tuple[object, ...]:
        """Return what is in force, feeds in inches a minute."""
        return (*self.feeds, self.speed, self.tool, self.coolant, self.partial, self.feed_point, self.depth)

    def obey(self, block: Block) -> None:
        """Carry out one block. Raises RefusedError; then the machine is not to be used any more."""
        number = len(self.done) + 1
        if wrong := _unknown(block):
            raise RefusedError(number, block.frame, *wrong)
        self._set(block)
        if self._lacks(block):
            raise RefusedError(number, block.frame, 4)
        self.legs = []
        if block.preparatory == READ_Z:
            self.feed_point, self.depth = block.x, block.y
        else:
            self._move(block)
        if block.miscellaneous in QUILL_UP:
            self._quill(0)
        if block.miscellaneous in STOPS:
            self.stops.append(number)
        self.done.append(self.legs)

    def _set(self, block: Block) -> None:
        """Carry out the miscellaneous function; a feed holds for its own block.

        Open: an automatic tool change with 00 takes the next tool of the carousel, a manual one any tool.
        """
        match block.miscellaneous:
            case 7 | 8 | 9 as coolant:
                self.coolant = COOLANT[coolant]
            case 81 | 82 as retract:
                self.partial = retract == 81
            case 84 | 85:
                axis = block.miscellaneous - 84
                self.feeds[axis] = XY_FEEDS[block.tool] * self.right[axis]
            case 89:
                self.feeds[2] = Z_FEEDS[block.tool] * self.right[2]
            case 88:
                self.speed = SPEEDS[block.tool]
            case 86:
                self.tool = block.tool or (self.tool or 0) % 24 + 1
            case 6 if block.tool:
                self.tool = block.tool

    def _lacks(self, block: Block) -> bool:
        """Tell whether no block has set what this one needs.

        Open: the quill needs a Z feed even where it stands at the final depth already.
        """
        goes = (block.x != self.at[0], block.y != self.at[1], True)
        lacking = [moves and feed is None for moves, feed in zip(goes, self.feeds, strict=True)]
        if block.preparatory == MILL:
            return any(lacking) or self.feed_point is None
        return block.preparatory in HOLES and (lacking[2] or self.feed_point is None)

    def _move(self, block: Block) -> None:
        """Open: from within the work the quill is fed to another final depth, deeper or not."""
        point = self.feed_point or 0
        up = point if self.partial else 0
        if block.preparatory == MILL:
            if self.at[2] != self.depth:
                self._quill(max(self.at[2], Fraction(point)))
                self._quill(self.depth, self.feeds[2])
            self._table((block.x, block.y), self.feeds[0], self.feeds[1])
            return
        self._quill(min(self.at[2], Fraction(up)))
        self._table((block.x, block.y), RAPID, RAPID)
        if block.preparatory in HOLES:
            self._hole(block.preparatory, point)
            self._quill(up)

    def _hole(self, function: int, point: int) -> None:
        """Make a hole. Open: how deep a peck is, that it leaves to the feed point; a tap's feed, here Z's."""
        self._quill(point)
        depth = point
        while function == PECK and depth + self.peck < self.depth:
            depth += self.peck
            self._quill(depth, self.feeds[2])
            self._quill(point)
            self._quill(depth)
        self._quill(self.depth, self.feeds[2])
        if function in (BORE, TAP_FEED, TAP_PITCH):
            self._quill(point, self.feeds[2])

    def _quill(self, z: Fraction | int, feed: Fraction | None = None) -> None:
        """Open: the quill's rapid speed, without a feed; here the table's."""
        seconds = abs(z - self.at[2]) / THOUSANDTHS_A_SECOND / (feed or RAPID)
        self._leg((*self.at[:2], Fraction(z)), feed is None, seconds)

    def _table(self, goal: tuple[int, int], x_speed: Fraction | None, y_speed: Fraction | None) -> None:
        """Move X and Y, each at its own speed: the first to arrive leaves the other to go on alone."""
        ways = [goal[axis] - self.at[axis] for axis in (0, 1)]
        speeds = (x_speed or RAPID, y_speed or RAPID)  # an axis without a feed stands still
        needs = [abs(way) / THOUSANDTHS_A_SECOND / speed for way, speed in zip(ways, speeds, strict=True)]
        start, spent = self.at, Fraction(0)
        for now in sorted({need for need in needs if need}):
            part = [min(now / need, Fraction(1)) if need else Fraction(0) for need in needs]
            x, y = (start[axis] + part[axis] * ways[axis] for axis in (0, 1))
            self._leg((x, y, start[2]), x_speed == RAPID, now - spent)
            spent = now

    def _leg(self, end: tuple[Fraction, ...], rapid: bool, seconds: Fraction) -> None:
        if seconds:
            self.legs.append(Leg(end, rapid, seconds))
        self.at = list(end)


def _unknown(block: Block) -> list[int]:
    """Return the first row of each field that Tables 2.3 and 2.4 and the travels do not have.

    Open: a tool function that the block does not use has to be 00, a code of Table 2.4 or a tool.
    """
    reads_z = block.preparatory == READ_Z
    wrong = {
        4: block.preparatory not in PREPARATORY,
        5: block.x > TRAVEL[2 if reads_z else 0],
        10: block.y > TRAVEL[2 if reads_z else 1] or (reads_z and block.y < block.x),
        15: block.reserved != 0,
        16: block.tool not in SELECTS.get(block.miscellaneous, (*SPEEDS, *range(25))),
        18: block.miscellaneous not in MISCELLANEOUS,
    }
    return [row for row, is_wrong in wrong.items() if is_wrong]
