"""Photographs of one long tape become one tape, by what they have in common.

    a.jpg   |...............|
    b.jpg             |..............|        what both show is compared at every shift of the one
    c.jpg                         |........|

A shift fits if no more than one frame in fifty differs where both are sure, and if the others say enough: a
frame such as one in 2**n is counts for n bits, blank tape for none. A strip is joined where one shift alone
fits. So tape that repeats itself is refused, and strips that have nothing but blank tape in common.

Of a frame that is seen twice, each channel is as it is sure; sure twice and different, it is doubtful.
"""

from collections.abc import Iterator, Sequence
from itertools import accumulate, permutations
from typing import NamedTuple

import numpy as np

from tapes.errors import TapeError
from tapes.photograph.pixels import Array
from tapes.photograph.reader import Frame

_DIFFER = "two pictures of it differ"
_ENOUGH = 80
"""Bits in what two strips have in common."""
_MOST_WRONG = 0.02
_CLEAR = 2
"""So many times as much as any other shift says the one that is right."""
_TWICE = "the photographs overlap in more than one way: the tape repeats itself there"
_APART = "not all photographs overlap: 30 frames, sure and neither blank nor alike, have to be on two of them"


class Piece(NamedTuple):
    """A part of the tape: its frames, each with the number of the strip that shows it, and where each of its
    strips begins, {number: frame}.
    """

    frames: list[tuple[Frame, int]]
    begins: dict[int, int]


def one_after_another(strips: Sequence[Sequence[Frame]]) -> Piece:
    """Return the tape of which the strips are pieces that were cut apart."""
    begins = dict(enumerate(accumulate(map(len, strips), initial=0)))
    return Piece([(frame, at) for at, strip in enumerate(strips) for frame in strip], begins)


def join(strips: Sequence[Sequence[Frame]]) -> Piece:
    """Return the tape that the strips show together. Raises TapeError if there is not one."""
    bits = _bits([frame.holes for strip in strips for frame in strip if not frame.doubtful])
    pieces = [Piece([(frame, at) for frame in strip], {at: 0}) for at, strip in enumerate(strips)]
    while len(pieces) > 1:
        joints = [
            (said, before, after, shift)
            for before, after in permutations(range(len(pieces)), 2)
            for said, shift in _shifts(pieces[before], pieces[after], bits)
            if shift or before < after
        ]
        clear = [joint for joint in joints if _is_clear(joint, joints)]
        if not clear:
            raise TapeError(_TWICE if joints else _APART)
        _, before, after, shift = max(clear)
        joined = _joined(pieces[before], pieces[after], shift)
        pieces = [joined, *(piece for at, piece in enumerate(pieces) if at not in (before, after))]
    return pieces[0]


def _bits(holes: Sequence[int]) -> Array:
    """Return how much each frame says, by how rare it is."""
    count = np.bincount(np.array(holes, dtype=int), minlength=256)
    bits = np.log2(max(1, len(holes)) / np.maximum(count, 1))
    bits[0] = 0
    return np.asarray(bits)


_Joint = tuple[float, int, int, int]
"""How many bits two pieces have in common, which is before and which after, and by how many frames."""


def _is_clear(joint: _Joint, joints: Sequence[_Joint]) -> bool:
    """Tell whether no other shift of the same two pieces says half as much."""
    said, before, after, _ = joint
    others = [other for other in joints if {*other[1:3]} == {before, after} and other != joint]
    return all(said >= _CLEAR * other[0] for other in others)


def _shifts(before: Piece, after: Piece, bits: Array) -> Iterator[tuple[float, int]]:
    """Yield the bits and the shift of each way in which one piece can begin within another."""
    (holes, open), (others, others_open) = (
        np.array([(frame.holes, frame.open) for frame, _ in piece.frames]).T for piece in (before, after)
    )
    for shift in range(len(holes)):
        length = min(len(holes) - shift, len(others))
        one, other = holes[shift : shift + length], others[:length]
        sure = 0o377 & ~(open[shift : shift + length] | others_open[:length])
        agree, wrong = (sure == 0o377) & (one == other), ((one ^ other) & sure) != 0
        said = float(bits[one[agree]].sum())
        if said >= _ENOUGH and wrong.sum() <= _MOST_WRONG * (agree & (one != 0)).sum():
            yield said, shift


def _joined(before: Piece, after: Piece, shift: int) -> Piece:
    frames = before.frames + after.frames[max(0, len(before.frames) - shift) :]
    for at, pair in enumerate(after.frames[: len(before.frames) - shift], shift):
        frames[at] = _fused(frames[at], pair)
    return Piece(frames, before.begins | {at: begin + shift for at, begin in after.begins.items()})


def _fused(one: tuple[Frame, int], other: tuple[Frame, int]) -> tuple[Frame, int]:
    """Return a frame that is seen twice, where it is doubtful least."""
    (frame, at), (second, _) = sorted((one, other), key=lambda pair: pair[0].open.bit_count())
    differ = (frame.holes ^ second.holes) & ~frame.open & ~second.open
    holes = frame.holes & ~frame.open | second.holes & frame.open
    open = frame.open & second.open | differ
    why = _DIFFER if differ else frame.why if open else ""
    return frame._replace(holes=holes, open=open, why=why), at
