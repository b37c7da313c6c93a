"""The Step-wise Linear Technique of Chapter 3: along one axis to one limit, along the other to the other.

          E---F       From A along Y until the next thousandth would pass the upper limit: C. From there along
          |           X until it would pass the lower one: D; and so on until B (Figures 3.3 to 3.5). Where a
      C---D           stretch of the curve ends, at a turning point, the cut that is going on goes on into the
      |               next; the last one ends in B itself, by a cut along each axis if need be.
      A

A cut stops at the first thousandth that reaches its limit or passes it: "the points which lie on the
boundaries of the error band will be taken" (Chapter 6), and so do the listings of the circle and the ellipse.
A stop may be outside the band by less than .001 in. With `Stop.INSIDE` a cut stops at the last thousandth in
the band, which is our own rule.

Source: thesis, Chapter 3, Figures 3.3 to 3.5.
"""

from collections.abc import Iterable, Iterator
from typing import Literal, NamedTuple

from programs.stretches import Axis, Curve, Point, Stretch
from tapes.errors import WorkError

_OTHER: dict[Axis, Axis] = {"X": "Y", "Y": "X"}


class Cut(NamedTuple):
    """A cut along one axis, and where it stops."""

    axis: Axis
    stop: Point


Stop = Literal["boundary", "inside"]


def cuts(curve: Curve, rule: Stop) -> Iterator[Cut]:
    """Yield the cuts along `curve`, from its start to its very end."""
    at = curve.start
    axis: Axis = "Y"
    for cut in staircase(at, axis, curve.stretches, rule):
        yield cut
        at, axis = cut.stop, _OTHER[cut.axis]
    if rule == "inside" and curve.stretches and not curve.stretches[-1].inside(*_along(axis, at, curve.end)):
        axis = _OTHER[axis]
    for last in (axis, _OTHER[axis]):
        stop = _along(last, at, curve.end)
        if stop != at:
            yield Cut(last, stop)
        at = stop


def staircase(start: Point, axis: Axis, stretches: Iterable[Stretch], rule: Stop) -> Iterator[Cut]:
    """Yield the cuts from `start`, the first along `axis`, but the last. Raises WorkError."""
    at = done = start
    for stretch in stretches:
        idle = False
        while True:
            at, ended = _cut(stretch, axis, at, rule)
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


def _cut(stretch: Stretch, axis: Axis, at: Point, rule: Stop) -> tuple[Point, bool]:
    """Return where a cut along `axis` from `at` stops, and whether the stretch ended first."""
    x, y = at
    while not stretch.ends(axis, x, y):
        if rule == "boundary":
            stops = (x, y) != at and stretch.reached(axis, x, y)
        else:
            stops = stretch.leaves(axis, x, y)
        if stops:
            return Point(x, y), False
        x, y = (x + stretch.dx, y) if axis == "X" else (x, y + stretch.dy)
    return Point(x, y), True


def _along(axis: Axis, at: Point, end: Point) -> Point:
    return Point(end.x, at.y) if axis == "X" else Point(at.x, end.y)
