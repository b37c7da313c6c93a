"""The Step-wise Linear Technique of Chapter 3: along one axis to one limit, along the other to the other.

          E---F       From A along Y until the next thousandth would pass the upper limit: C. From there along
          |           X until it would pass the lower one: D; and so on until B (Figures 3.3 to 3.5). Where a
      C---D           stretch of the curve ends, at a turning point, the cut that is going on goes on into the
      |               next; the last one ends in B itself, by a cut along each axis if need be.
      A

Every stop lies inside the band. The listings of the circle and the ellipse stop at the first thousandth that
reaches a limit instead, which may be outside by less than one; a Stretch says which of the two it wants.

Source: thesis, Chapter 3, Figures 3.3 to 3.5.
"""

from collections.abc import Iterable, Iterator
from typing import NamedTuple

from programs.stretches import Axis, Curve, Point, Stretch
from tapes.errors import WorkError

_OTHER: dict[Axis, Axis] = {"X": "Y", "Y": "X"}


class Cut(NamedTuple):
    """A cut along one axis, and where it stops."""

    axis: Axis
    stop: Point


def cuts(curve: Curve) -> Iterator[Cut]:
    """Yield the cuts along `curve`, from its start to its very end."""
    at = curve.start
    axis: Axis = "Y"
    for cut in staircase(at, axis, curve.stretches):
        yield cut
        at, axis = cut.stop, _OTHER[cut.axis]
    for last in (axis, _OTHER[axis]):
        stop = _along(last, at, curve.end)
        if stop != at:
            yield Cut(last, stop)
        at = stop


def staircase(start: Point, axis: Axis, stretches: Iterable[Stretch]) -> Iterator[Cut]:
    """Yield the cuts from `start`, the first along `axis`, until the last of `stretches` ends.

    The cut in which the last stretch ends is left out. Raises WorkError where a band is too narrow for a
    cut.
    """
    at = done = start
    for stretch in stretches:
        idle = False
        while True:
            at, ended = _cut(stretch, axis, at)
            if ended:
                break
            if at == done and idle:
                raise WorkError(
                    f"at X {at.x / 1000:.3f} Y {at.y / 1000:.3f} the band is too narrow for a cut"
                )
            idle = at == done
            if not idle:
                yield Cut(axis, at)
            done = at
            axis = _OTHER[axis]


def _cut(stretch: Stretch, axis: Axis, at: Point) -> tuple[Point, bool]:
    """Return where a cut along `axis` from `at` stops, and whether the stretch ended there."""
    x, y = at
    taken = 0
    while not stretch.ends(axis, x, y):
        if taken >= stretch.at_least and stretch.over(axis, x, y):
            return Point(x, y), False
        if axis == "X":
            x += stretch.dx
        else:
            y += stretch.dy
        taken += 1
    return Point(x, y), True


def _along(axis: Axis, at: Point, end: Point) -> Point:
    return Point(end.x, at.y) if axis == "X" else Point(at.x, end.y)
