r"""A TU55 transport: the tape that is mounted, and how it moves.

    speed   1 ┌───────────┐                     from rest: 150 ms to full speed, 2250 lines
              /           \                     to rest:   100 ms, 1500 lines
    0 ───────┘             └──── time           to turn:   to rest, then the other way

Along the tape there are lines of three bits, 30 a millisecond at full speed, in this order:

    end zone 49,152 lines | 1474 blocks of 576 | end zone 49,152 lines

The tape can be read while it is faster than half its speed. A transport that is no longer selected keeps
moving, and stops at the end of its tape.

Times are in ticks, places in thousandths of a line.

By convention, as they differ from one transport to another: the times to speed and to rest, with constant
acceleration; 10 feet of end zone; a tape is mounted in the end zone, 3000 lines before block 0.

Sources: DEC TU55 manual (100 and 150 ms); the transport of drovak/verilogpdp, pdp8i/tu55.v (its acceleration,
and signals from half speed).
"""

from array import array
from math import isqrt

from pdp8.computer.hardware.fields import BIT, FRAMES, MEDIUM, TICK, saved
from tapes.dectape import BLOCKS, WORDS, Image

LINE = 1000
"""A line of the tape, in thousandths of it."""
BLOCK_LINES = 576
END_ZONE = 49_152
LINES = 2 * END_ZONE + BLOCKS * BLOCK_LINES
_TO_SPEED, _TO_REST = 3_000_000, 2_000_000
_GAINED = 2250 * LINE
"""How far the tape comes until it is at speed."""
_MOUNTED = (END_ZONE - 3000) * LINE

STOPPED, MOVING, STOPPING = 0, 1, 2


class Transport:
    """One transport; no tape is mounted while `image` is None."""

    fields = saved(
        image=MEDIUM,
        changed=FRAMES,
        phase=STOPPING,
        since=TICK,
        place=LINES * LINE,
        **dict.fromkeys(("locked", "reverse", "turns"), BIT),
    )

    def __init__(self) -> None:
        self.image: Image | None = None
        """The tape as it was mounted."""
        self.blocks: dict[int, array[int]] = {}
        """What was written since, by blocks: their words and checksums."""
        self.locked = 0
        """WRITE LOCK."""
        self.phase = STOPPED
        self.since = 0
        """The tick at which the tape began to move from rest, or will be at rest."""
        self.place = _MOUNTED
        """Where it was or will be then."""
        self.reverse = 0
        """The direction of its motion."""
        self.turns = 0
        """Set while it stops, if it will then move the other way."""

    @property
    def changed(self) -> bytes:
        """The blocks that were written: each its number, words and checksums in two frames each."""
        found = bytearray()
        for number in sorted(self.blocks):
            for word in (number, *self.blocks[number]):
                found += bytes([word >> 8, word & 0o377])
        return bytes(found)

    @changed.setter
    def changed(self, content: bytes) -> None:
        words = [content[at] << 8 | content[at + 1] for at in range(0, len(content) - 1, 2)]
        rows = [words[at : at + WORDS + 2] for at in range(0, len(words), WORDS + 2)]
        if any(len(row) < WORDS + 2 or row[0] >= BLOCKS or max(row) > 0o7777 for row in rows):
            raise ValueError("blocks of a DECtape are expected, a number, 129 words and checksums each")
        self.blocks = {row[0]: array("H", row[1:]) for row in rows}

    def mount(self, image: Image | None, locked: bool = False) -> None:
        """Mount a tape in place of the one before, or none."""
        self.image = image
        self.blocks = {}
        self.locked = 1 if locked else 0
        self._set(STOPPED, _MOUNTED, 0, 0)

    def written(self) -> Image | None:
        """Return the tape as it is now."""
        if self.image is None or not self.blocks:
            return self.image
        words = self.image.words[:]
        for number, row in self.blocks.items():
            for place in range(WORDS):
                words[WORDS * number + place] = row[place]
        return Image(words, self.image.width)

    def read(self, block: int, word: int) -> int:
        """Return a word of a block, or after the last one its two checksums, in front and behind."""
        if block in self.blocks:
            return self.blocks[block][word]
        assert self.image is not None
        return self.image.words[WORDS * block + word] if word < WORDS else 0o77 ^ self.sum(block)

    def write(self, block: int, word: int, value: int) -> None:
        """Write a word of a block, or one of its checksums."""
        if value == self.read(block, word):
            return
        if block not in self.blocks:
            self.blocks[block] = array("H", [self.read(block, place) for place in range(WORDS + 1)])
        self.blocks[block][word] = value

    def sum(self, block: int) -> int:
        """Return the sum without carry of the halves of the block's words."""
        found = 0
        for word in range(WORDS):
            value = self.read(block, word)
            found ^= value >> 6 ^ value
        return found & 0o77

    def position(self, now: int) -> int:
        """Return where the tape is at tick `now`."""
        self._settle(now)
        way = 0
        if self.phase == MOVING:
            way = _gained(now - self.since)
        elif self.phase == STOPPING:
            way = -_left(self.since - now)
        return min(max(self.place + (-way if self.reverse else way), 0), LINES * LINE)

    def go(self, reverse: int, now: int) -> None:
        """Let the tape move, the other way if `reverse`."""
        self._settle(now)
        if self.phase == STOPPED:
            self._set(MOVING, self.place, now, reverse)
        elif self.phase == MOVING and self.reverse != reverse:
            self._brake(now)
            self.turns = 1
        elif self.phase == STOPPING and self.reverse != reverse:
            self.turns = 1
        elif self.phase == STOPPING:
            at, since = self.position(now), now - (self.since - now) * 3 // 2
            way = _gained(now - since)
            self._set(MOVING, at + way if reverse else at - way, since, reverse)

    def stop(self, now: int) -> None:
        """Let the tape come to rest."""
        self._settle(now)
        if self.phase == MOVING:
            self._brake(now)
        self.turns = 0

    def readable_from(self, now: int) -> int:
        """Return the tick from which the tape is fast enough in the direction in which it is to move."""
        self._settle(now)
        return self.since + _TO_SPEED // 2

    def tick_at(self, place: int, now: int) -> int:
        """Return the tick at which the tape, as it moves, comes to `place`."""
        self._settle(now)
        reverse = self.reverse ^ self.turns
        way = self.place - place if reverse else place - self.place
        if way <= _GAINED:
            return self.since + _up(isqrt(max(way, 0) * 4_000_000), max(way, 0) * 4_000_000)
        return self.since + _TO_SPEED + (2 * (way - _GAINED) + 2) // 3

    def _brake(self, now: int) -> None:
        at, rest = self.position(now), min(now - self.since, _TO_SPEED) * 2 // 3
        way = _left(rest)
        self._set(STOPPING, at - way if self.reverse else at + way, now + rest, self.reverse)

    def _set(self, phase: int, place: int, since: int, reverse: int) -> None:
        self.phase, self.since, self.reverse, self.turns = phase, since, reverse, 0
        self.place = min(max(place, 0), LINES * LINE)

    def _settle(self, now: int) -> None:
        """Put the tape to rest, or let it turn, if its time to stop is over."""
        if self.phase == STOPPING and now >= self.since:
            if self.turns:
                self._set(MOVING, self.place, self.since, 1 - self.reverse)
            else:
                self._set(STOPPED, self.place, self.since, self.reverse)


def _gained(ticks: int) -> int:
    """Return how far a tape has come since it began to move."""
    if ticks <= _TO_SPEED:
        return ticks * ticks // 4_000_000
    return _GAINED + (ticks - _TO_SPEED) * 3 // 2


def _left(ticks: int) -> int:
    """Return how far a tape moves until it is at rest, so many ticks from now."""
    return ticks * ticks * 3 // 8_000_000


def _up(root: int, square: int) -> int:
    return root if root * root == square else root + 1
