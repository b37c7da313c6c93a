"""Photographs of one long tape become one tape, by what they have in common.

    a.jpg   |...............|
    b.jpg             |..............|        what both show is compared at every shift of the one
    c.jpg                         |........|

A shift fits if no more than one frame in fifty differs where both are sure. The evidence for it is the
longest run of frames that agree, in bits: a frame as rare as one in 2**n counts n bits; one that is blank, or
like the one before, counts none. Two strips are joined if that is half as much again as any other run that
agrees, of the one with the other or with itself. If strips fit in a second way too, the tape repeats itself,
and nothing is joined.

In a frame that is seen twice, each channel is taken from where it is sure; if both are sure and differ, it is
doubtful.
"""

from collections.abc import Mapping, Sequence
from itertools import combinations
from typing import NamedTuple

import numpy as np
from numpy.lib.stride_tricks import sliding_window_view

from tapes.errors import TapeError
from tapes.photograph.pixels import Array
from tapes.photograph.reader import Frame

_DIFFER = "two pictures of it differ"
_ENOUGH = 40
"""Bits in what two strips have in common."""
_CLEAR = 1.5
"""The best shift has so many times the bits of any other likeness in the strips."""
_MOST_WRONG = 0.02
_TWICE = "the tape repeats itself where they overlap: let them overlap by more"
_APART = "two have to have 30 frames in common that are sure, not blank, and unlike the one before"

Strips = Mapping[int, Sequence[Frame]]
"""The frames of strips, by the strips' numbers."""


class Piece(NamedTuple):
    """A part of the tape: its frames, each with the strip that shows it, and {strip: where it begins}."""

    frames: list[tuple[Frame, int]]
    begins: dict[int, int]


def one_after_another(strips: Strips) -> Piece:
    """Return the tape of which the strips are pieces that were cut apart."""
    piece = Piece([], {})
    for number, strip in strips.items():
        piece.begins[number] = len(piece.frames)
        piece.frames.extend((frame, number) for frame in strip)
    return piece


def join(strips: Strips) -> Piece:
    """Return the tape that the strips show together. Raises TapeError if there is not one."""
    begins = _begins(strips)
    frames: list[tuple[Frame, int]] = []
    for begin, number in sorted((begin, number) for number, begin in begins.items()):
        for at, frame in enumerate(strips[number], begin):
            here = (frame, number)
            frames[at : at + 1] = [_fused(frames[at], here) if at < len(frames) else here]
    return Piece(frames, begins)


def _begins(strips: Strips) -> dict[int, int]:
    """Return where on the tape each strip begins."""
    seen = _seen(strips)
    repeats = {number: _match(strip, strip).other for number, strip in seen.items()}
    matches = {(one, other): _match(seen[one], seen[other]) for one, other in combinations(seen, 2)}
    whole = {number: {number: 0} for number in strips}
    for (one, other), match in matches.items():
        if match.shifts and match.said >= _CLEAR * max(match.other, repeats[one], repeats[other]):
            piece, more = whole[one], whole[other]
            off = piece[one] + match.shifts[0] - more[other]
            piece.update({number: begin + off for number, begin in more.items() if number not in piece})
            whole.update(dict.fromkeys(more, piece))
    for (one, other), match in matches.items():
        placed = [whole[other][other] - whole[one][one]] if whole[one] is whole[other] else []
        if not {*match.shifts} <= {*placed} or not all(map(match.fits, placed)):
            raise TapeError(f"strips {one} and {other} cannot be joined: {_TWICE}")
    (begins, *apart) = {id(piece): piece for piece in whole.values()}.values()
    if apart:
        said = "; ".join(", ".join(map(str, sorted(piece))) for piece in (begins, *apart))
        raise TapeError(f"strips {said} cannot be joined: {_APART}")
    first = min(begins.values())
    return {number: begin - first for number, begin in begins.items()}


class _Seen(NamedTuple):
    """The frames of a strip: their holes, channels in doubt, and how many bits each says."""

    holes: Array
    open: Array
    bits: Array


def _seen(strips: Strips) -> dict[int, _Seen]:
    sure = [frame.holes for strip in strips.values() for frame in strip if not frame.doubtful]
    bits = np.log2(max(1, len(sure)) / np.bincount(np.array(sure, dtype=int), minlength=256).clip(1))
    bits[0] = 0
    found = {}
    for number, strip in strips.items():
        holes, open = np.array([(frame.holes, frame.open) for frame in strip]).T
        found[number] = _Seen(holes, open, bits[holes] * np.append(True, holes[1:] != holes[:-1]))
    return found


class _Match(NamedTuple):
    """Agreeing bits at the best shift and the next best; shifts with enough; whether each is fitting."""

    said: float
    other: float
    shifts: list[int]
    longest: int
    fitting: Array

    def fits(self, shift: int) -> bool:
        """Tell whether the other strip may begin `shift` frames after the one."""
        at = self.longest - shift
        return not 0 <= at < len(self.fitting) or bool(self.fitting[at])


def _match(one: _Seen, other: _Seen) -> _Match:
    longest = len(one.holes) - 1
    holes, open = (
        sliding_window_view(np.pad(of, longest, constant_values=filled), longest + 1)
        for of, filled in ((other.holes, 0), (other.open, 0o377))
    )
    sure = 0o377 & ~(one.open | open)
    differ = (one.holes ^ holes) & sure != 0
    alike = (sure == 0o377) & ~differ
    bits = (alike * one.bits).cumsum(axis=1)
    runs = (bits - np.maximum.accumulate(differ * bits, axis=1)).max(axis=1)
    fitting = differ.sum(axis=1) <= _MOST_WRONG * (alike & (holes != 0)).sum(axis=1)
    likely = runs * fitting
    at = int(likely.argmax())
    shifts = (longest - np.nonzero(likely >= _ENOUGH)[0]).tolist()
    return _Match(float(likely[at]), float(np.delete(runs, at).max(initial=0)), shifts, longest, fitting)


def _fused(one: tuple[Frame, int], other: tuple[Frame, int]) -> tuple[Frame, int]:
    """Return a frame that is seen twice, as it is where fewest channels are in doubt."""
    (frame, at), (second, _) = sorted((one, other), key=lambda pair: pair[0].open.bit_count())
    differ = (frame.holes ^ second.holes) & ~frame.open & ~second.open
    holes = frame.holes & ~frame.open | second.holes & frame.open
    open = frame.open & second.open | differ
    why = _DIFFER if differ else frame.why if open else ""
    return frame._replace(holes=holes, open=open, why=why), at
