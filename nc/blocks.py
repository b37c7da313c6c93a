"""The tape under the reading head: frames to blocks.

The pneumatic head senses channels 1 to 4 and channel 8. The other channels are masked off: parity is not
checked, and a row without holes is the digit 0, as 040 is. A block is 20 rows. The operator sets the first
row under the head: a blank leader is not read, and blank rows after the last end of block are the trailer.
The first row is the first that is punched; on a tape without parity, where a zero is blank, it is the first
of the 20 that the first end of block closes.

    frame     040 040 001 040 001 031 ... 200        as punched, with parity
    sensed      0   0   1   0   1   9 ... end        & 217

With `strict` a tape is read as later controls did: nothing up to the first end of block is read, a DEL is
passed over, and every other row must be one of the ten EIA digits with odd parity; a blank row is an error.
A block with an error is not returned in part.

Sources: thesis, Chapter 2 (head, block, codes) and Chapter 5 (equal block length); EIA RS-244 for `strict`.
"""

from collections.abc import Collection, Iterator
from typing import NamedTuple

from tapes.errors import TapeError
from tapes.hydrapoint import (
    CAROUSEL,
    DIGITS,
    MISCELLANEOUS,
    NEXT_TOOL,
    PREPARATORY,
    ROWS,
    SPINDLE,
    X_TRAVEL,
    XY_FEED,
    Y_TRAVEL,
    Z_FEED,
    Z_TRAVEL,
    Block,
    Miscellaneous,
    Preparatory,
    block,
)

HEAD = 0o217
END_OF_BLOCK = 0o200

_EIA_DIGITS = (0o040, 0o001, 0o002, 0o023, 0o004, 0o025, 0o026, 0o007, 0o010, 0o031)
_DELETE = 0o177
_END = ord("\r")
_BAD = ord("?")

_LISTED = frozenset({0, *SPINDLE, *CAROUSEL})
_SELECTS: dict[int, tuple[str, Collection[int]]] = {
    Miscellaneous.X_FEED: ("X feed", XY_FEED.keys()),
    Miscellaneous.Y_FEED: ("Y feed", XY_FEED.keys()),
    Miscellaneous.TOOL_CHANGE: ("tool", frozenset({NEXT_TOOL, *CAROUSEL})),
    Miscellaneous.SPINDLE_SPEED: ("spindle speed", SPINDLE.keys()),
    Miscellaneous.Z_FEED: ("Z feed", Z_FEED.keys()),
}
_TOOL_CODES = {function: _SELECTS.get(function, ("tool function", _LISTED)) for function in MISCELLANEOUS}


class BlockError(TapeError):
    """A block that the machine refuses; `block` counts from 1, `row` from 1 to 20, `frame` from 0."""

    def __init__(self, message: str, frame: int, block: int, row: int) -> None:
        super().__init__(f"block {block}, row {row}: {message}", frame)
        self.reason = message
        self.block = block
        self.row = row


class Row(NamedTuple):
    """A block's place: its number from 1, and the frames of its rows."""

    number: int
    frames: list[int]

    def error(self, row: int, message: str) -> BlockError:
        """Return the BlockError for one of this block's rows, 1 to 20."""
        return BlockError(message, self.frames[row - 1], self.number, row)


def read(frames: bytes, strict: bool) -> Iterator[tuple[Row, Block]]:
    """Yield each block with its place until the tape ends. Raises BlockError, or TapeError if blank."""
    end = len(frames.rstrip(b"\0"))
    if not end:
        raise TapeError("no row is punched: the tape is empty or blank")
    if strict:
        kept = [at for at in range(frames.find(END_OF_BLOCK) + 1, end) if frames[at] != _DELETE]
        passed = bytes(frames[at] for at in kept)
        if not kept:
            raise TapeError("no row is read: later controls begin after the first end of block")
    else:  # without parity a zero is blank, in the last block too
        kept = list(range(_first_row(frames), len(frames)))
        passed = frames[kept[0] :]
    sensed = passed.translate(_STRICT if strict else _SENSED)
    for number, at in enumerate(range(0, len(kept), ROWS), 1):
        if kept[at] >= end:
            return
        rows = sensed[at : at + ROWS]
        place = Row(number, kept[at : at + ROWS])
        if len(rows) < ROWS or rows[-1] != _END or not rows[:-1].isdigit():
            raise _fault(place, passed[at : at + ROWS], rows, strict)
        found = block(rows[:-1])
        _check(place, found)
        yield place, found


def _first_row(frames: bytes) -> int:
    """Return the frame at which the first row of the first block is read."""
    punched = len(frames) - len(frames.lstrip(b"\0"))
    zeros_are_punched = any(frame & ~HEAD for frame in set(frames))
    closed = frames.find(END_OF_BLOCK) - DIGITS
    return punched if zeros_are_punched or closed < 0 else min(punched, closed)


def _head(frame: int) -> int:
    value = frame & HEAD
    return _END if value == END_OF_BLOCK else ord("0") + value if value <= 9 else _BAD


_SENSED = bytes(_head(frame) for frame in range(0o400))
_STRICT = bytes(
    _head(frame) if frame in _EIA_DIGITS or frame == END_OF_BLOCK else _BAD for frame in range(0o400)
)


def _fault(place: Row, frames: bytes, rows: bytes, strict: bool) -> BlockError:
    """Return what is wrong with a block that is not 19 digits and an end of block."""
    for row, (frame, digit) in enumerate(zip(frames, rows, strict=True), 1):
        if digit == _BAD:
            return place.error(row, _why_bad(frame, strict))
        if digit == _END:
            return place.error(row, f"the block ends in row {row}; a block has {ROWS} rows")
    if len(rows) < ROWS:
        return place.error(len(rows), f"the tape ends after {len(rows)} of the block's {ROWS} rows")
    return place.error(ROWS, f"no end of block in row {ROWS}, but the digit {chr(rows[-1])}")


def _why_bad(frame: int, strict: bool) -> str:
    value = frame & HEAD
    if strict and frame == 0:
        return "a blank row within the block"
    if strict and frame.bit_count() % 2 == 0:
        return f"wrong parity: {frame:03o} has {frame.bit_count()} holes, EIA frames have an odd number"
    if value > END_OF_BLOCK:
        return f"an end of block with digit holes beside it: {frame:03o}"
    if 9 < value < END_OF_BLOCK:
        return f"{frame:03o} is {value}, not a decimal digit"
    return f"{frame:03o} is not an EIA digit"


def _check(place: Row, found: Block) -> None:
    if found.preparatory not in PREPARATORY:
        raise place.error(4, f"unknown preparatory function {found.preparatory}")
    if found.reserved:
        raise place.error(15, f"the reserved digit is {found.reserved}; it must be 0")
    if found.miscellaneous not in MISCELLANEOUS:
        raise place.error(18, f"unknown miscellaneous function {found.miscellaneous:02}")
    selects, codes = _TOOL_CODES[found.miscellaneous]
    if found.tool not in codes:
        raise place.error(16, f"unknown {selects} code {found.tool:02}")
    depths = found.preparatory == Preparatory.READ_Z
    for row, name, length, travel in (
        (5, "Z feed point" if depths else "X", found.x, Z_TRAVEL if depths else X_TRAVEL),
        (10, "final depth" if depths else "Y", found.y, Z_TRAVEL if depths else Y_TRAVEL),
    ):
        if length > travel:
            raise place.error(row, f"{name} {length / 1000:.3f} is beyond the travel of {travel // 1000} in")
    if depths and found.y < found.x:
        said = f"final depth {found.y / 1000:.3f} is above the Z feed point {found.x / 1000:.3f}"
        raise place.error(10, said)
