"""What the figures of the page that teaches the method compute: a technique's stops, their tape, its path.

    curve ──► cuts ──► printout, a line of 19 characters a block ──► EIA tape ──► Hydra-Point ──► way, minutes
                          └──► ASCII tape ──► eia.pal on the PDP-8/L, character by character

Lengths are thousandths of an inch. A feed's error is a part of it, 0.2 for 20 %.
"""

from collections.abc import Iterable
from dataclasses import dataclass, field
from functools import cached_property
from math import cos, radians, sin
from typing import NamedTuple

from nc.machine import Settings, cut
from nc.path import Path, Position
from pal.isa import jumps_to, tests_flag
from pdp8.computer.machine import Machine
from programs import circle as listed
from programs import drawn as by_hand
from programs import slope as slopes
from programs.header import THESIS
from programs.milling import SLOWEST, Milling
from programs.stretches import Curve, Point, arc, line, oval
from tapes import eia
from tapes.hydrapoint import Preparatory

CENTRE = 4000
RADIUS = 1750
"""The radius of the path of the cutter's centre in the listing of Appendix C."""

SLOPE = [Point(4000, 4000), Point(8330, 6500)]
"""Chapter 3's slope, 30 degrees and 5 in long."""

_KSF, _KRB, _TLS = 0o6031, 0o6036, 0o6046

_MOST = 4_000_000
"""Instructions; a character takes some 17,000."""


@dataclass(frozen=True)
class Made:
    """A printout, and the path of its tape."""

    text: str
    path: Path

    @cached_property
    def way(self) -> list[Position]:
        """The start of milling and the end of each cut."""
        return [self.path.cuts[0].start, *[move.end for move in self.path.cuts]]

    @property
    def stops(self) -> list[Position]:
        """The ends of the milling blocks."""
        return [step.at for step in self.path.steps if step.block.preparatory == Preparatory.MILL]

    @property
    def blocks(self) -> int:
        """How many there are."""
        return len(self.path)

    @property
    def reading(self) -> float:
        """Minutes to read the contour's blocks."""
        return self.path.contour.reading / 60

    @property
    def milling(self) -> float:
        """Minutes in which the cutter cuts."""
        return self.path.contour.milling / 60

    @property
    def minutes(self) -> float:
        """Minutes of the contour, as Chapter 7 gives them."""
        return self.path.contour.total / 60


def _made(text: str, x_error: float = 0.0, y_error: float = 0.0) -> Made:
    """Carry out a printout, in which a space is a zero."""
    settings = Settings(feed_error=(x_error, y_error, 0.0))
    return Made(text, cut(eia.encode(text.replace(" ", "0")), settings=settings))


def _milled(curve: Curve, milling: Milling, x_error: float = 0.0, y_error: float = 0.0) -> Made:
    return _made(milling.printout(curve, THESIS, "low-digits"), x_error, y_error)


def pieces(count: int, x_code: int, y_code: int, x_error: float, y_error: float) -> Made:
    """Mill the slope in `count` equal pieces, at the feeds of two codes of Table 2.4."""
    return _made(slopes.pieces(SLOPE[0], SLOPE[1], count, x_code, y_code), x_error, y_error)


def fewest(frames: list[int], x_error: float, y_error: float) -> Made:
    """Mill the slope by the frames of the proved tape, slope-fewest.eia."""
    return Made("", cut(bytes(frames), settings=Settings(feed_error=(x_error, y_error, 0.0))))


def slope(tolerance: float, x_error: float = 0.0, y_error: float = 0.0, angle: float = 30.0) -> Made:
    """Mill by steps a slope of so many degrees, as long as Chapter 3's."""
    start = SLOPE[0]
    end = Point(start.x + round(5000 * cos(radians(angle))), start.y + round(5000 * sin(radians(angle))))
    return _milled(line(start, end, tolerance), SLOWEST, x_error, y_error)


def drawn(heights: list[float], tolerance: float) -> Made:
    """Mill a curve that was drawn by hand, by steps."""
    return _milled(by_hand.drawn(heights, tolerance), SLOWEST)


def quarter(tolerance: float, feed: int) -> Made:
    """Mill a quarter of the circle by steps, from 9 to 12 o'clock, at a code's feed."""
    curve = arc(Point(CENTRE, CENTRE), RADIUS, 180, -90, tolerance)
    return _milled(curve, Milling("step", feed))


def circle(tolerance: float, close: bool = False) -> Made:
    """Mill the whole circle; without `close` the last cut is missing, as in the listing."""
    if not close:
        return _made(listed.part(radius=RADIUS, tolerance=tolerance))
    inner, outer = RADIUS - tolerance, RADIUS + tolerance
    return _milled(oval(Point(CENTRE, CENTRE), RADIUS, (inner, inner), (outer, outer)), SLOWEST)


class Done(NamedTuple):
    """An instruction that was done: its address and word, and AC after it."""

    address: int
    word: int
    ac: int


@dataclass
class Character:
    """A character that eia.pal has read, what it did until the next one, and the frame it punched."""

    character: int
    rows: list[Done] = field(default_factory=list)
    waited: int = 0
    punched: int | None = None


def characters(words: Iterable[tuple[int, int]], frames: bytes) -> list[Character]:
    """Return what the program `words` does with each of the frames."""
    machine = started(words, frames)
    processor = machine.processor
    done: list[Character] = []
    for _ in range(_MOST):
        address = machine.pc
        processor.instruction()
        word = processor.core[address]
        if word == _KRB:
            done.append(Character(machine.ac))
        if done and (tests_flag(word) or jumps_to(address - 1, word, address)):
            done[-1].waited += 1
        elif done:
            done[-1].rows.append(Done(address, word, machine.ac))
        if done and word == _TLS:
            done[-1].punched = machine.ac & 0o377
        if len(done) == len(frames) and word == _KSF:
            break  # it waits for a character that does not come
    return done


def translated(words: Iterable[tuple[int, int]], frames: bytes) -> Machine:
    """Return the machine that has read all the frames: its punch has the tape."""
    machine = started(words, frames)
    machine.run()
    return machine


def started(words: Iterable[tuple[int, int]], frames: bytes) -> Machine:
    """Return a machine with the program `words`, started, and the frames under its reader."""
    machine = Machine()
    machine.load(words)
    machine.start(0o200)
    machine.teletype.reader.load(frames)
    return machine
