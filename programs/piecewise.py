"""The Piece-wise Linear Technique of Chapter 3: X and Y run together, at two feeds that follow the slope.

          .---B      From A both axes start, each at its own feed; one arrives, only the other moves on
       .'            (Figure 3.1). A block goes as far as the band allows for any error of the feeds. Of all
     .'              pairs of feeds, the pair with the greatest distance per block is used: a block sets one
    A                feed, so a change of both needs one block more.

A feed is within 20 % of its value in Table 2.4. The path must stay in the band for both extremes, X fast and
Y slow, and X slow and Y fast; all other paths lie between them. With a feed error of 0 the feeds are exact.
Where no pair fits, the block goes along one axis: the limiting case of Chapter 3. The band is checked at
twelve points of the leg on which both run; the bands of stretches are smooth enough for that. The other leg
is along an axis, and in the band where its ends are.

A block is chosen without a look at those after it, so that other choices may need fewer blocks:
tests/reference/fewest.c finds the least there can be with the codes it is given.

Sources: thesis, Chapter 3, Figures 3.1 and 3.2, Tables 2.4 and 10.1. The choice of pairs and stops is ours.
"""

from bisect import bisect_left
from collections.abc import Iterator
from dataclasses import dataclass
from math import ceil, sqrt
from typing import NamedTuple

from programs.printout import check_feed
from programs.stretches import Curve, Point, Stretch
from tapes.errors import WorkError
from tapes.hydrapoint import XY_FEED, corner

_PLACES = 12
_MIDDLE_FIRST = tuple(place / _PLACES for place in (6, 9, 3, 7, 5, 8, 4, 10, 2, 11, 1))
"""Parts of a leg at which it is checked."""


class Feeds(NamedTuple):
    """The feed codes of Table 2.4 that X and Y have; 0 for an axis that does not move."""

    x: int
    y: int


class _Path:
    """The path of two feeds from a stop; a step is a thousandth of the faster axis."""

    def __init__(self, stretch: Stretch, at: Point, feeds: Feeds) -> None:
        x_speed, y_speed = (XY_FEED[code] if code else 0.0 for code in feeds)
        self.stretch, self.at, self.speeds = stretch, at, (x_speed, y_speed)
        fastest = max(x_speed, y_speed)
        self._across, self._up = stretch.dx * x_speed / fastest, stretch.dy * y_speed / fastest
        self._x_is_faster = x_speed == fastest
        self._least = ceil(1 / min(abs(part) for part in (self._across, self._up) if part))
        self._length = sqrt(self._across * self._across + self._up * self._up)

    def beyond(self, distance: float) -> int:
        """Return the fewest steps beyond so many, with which each axis moves."""
        return max(self._least, int(distance / self._length) + 1)

    def stop(self, aside: int, steps: int) -> Point:
        """Return the stop after so many steps, shifted aside of the path."""
        x, y = self.at.x + round(self._across * steps), self.at.y + round(self._up * steps)
        return Point(x, y + aside) if self._x_is_faster else Point(x + aside, y)

    def leads(self, stop: Point) -> bool:
        """Whether the stop is ahead, and in the band."""
        stretch = self.stretch
        ahead = (stop.x - self.at.x) * stretch.dx >= 0 and (stop.y - self.at.y) * stretch.dy >= 0
        return ahead and stretch.inside(stop.x, stop.y)


class Ray(NamedTuple):
    """A block: both axes at their feeds from where the cutter is to `stop`."""

    feeds: Feeds
    stop: Point


@dataclass(frozen=True)
class Technique:
    """The feeds that may be used, up to code `fastest`, and the fraction by which they may be wrong."""

    fastest: int = 5
    feed_error: float = 0.2

    def __post_init__(self) -> None:
        """Raise WorkError for a code that is not in Table 2.4 and for an error that is not a fraction."""
        check_feed(self.fastest)
        if not 0 <= self.feed_error < 1:
            raise WorkError(f"feed error {100 * self.feed_error:.0f}%: must be from 0 to less than 100 %")

    def rays(self, curve: Curve) -> Iterator[Ray]:
        """Yield the blocks along `curve`, from its start to its very end. Raises WorkError if none fits."""
        at, force = curve.start, Feeds(0, 0)
        for stretch in curve.stretches:
            while at.x != stretch.last_x and at.y != stretch.last_y:
                ray = self._furthest(stretch, at, force)
                yield ray
                at = ray.stop
                force = Feeds(ray.feeds.x or force.x, ray.feeds.y or force.y)
        if at.x != curve.end.x:
            at = Point(curve.end.x, at.y)
            yield Ray(Feeds(force.x or 1, 0), at)
        if at.y != curve.end.y:
            yield Ray(Feeds(0, force.y or 1), curve.end)

    def _furthest(self, stretch: Stretch, at: Point, force: Feeds) -> Ray:
        """Return the ray from `at` of the greatest distance per block."""
        best, most = None, 0.0
        along_x, along_y = _asides(stretch, at, 1, 0), _asides(stretch, at, 0, 1)
        for feeds in self._choices(force):
            blocks = 1 + all(code and code != now for code, now in zip(feeds, force, strict=True))
            path = _Path(stretch, at, feeds)
            steps = path.beyond(most * blocks)
            tried = along_y if feeds.x >= feeds.y else along_x
            for aside in tried if self.feed_error and 0 not in feeds else (0,):
                if not self._kept(path, aside, steps):
                    continue
                stop = path.stop(aside, self._reach(path, aside, steps))
                x, y = stop.x - at.x, stop.y - at.y
                gain = sqrt(x * x + y * y) / blocks
                if gain > most:
                    best, most = Ray(feeds, stop), gain
                    steps = path.beyond(most * blocks)
        if best is None:
            raise WorkError(f"at X {at.x / 1000:.3f} Y {at.y / 1000:.3f} no pair of feeds stays in the band")
        return best

    def _choices(self, force: Feeds) -> Iterator[Feeds]:
        codes = range(1, self.fastest + 1)
        yield Feeds(force.x or 1, 0)
        yield Feeds(0, force.y or 1)
        yield from (Feeds(x, y) for x in codes for y in codes)

    def _reach(self, path: "_Path", aside: int, steps: int) -> int:
        """Return how many steps the path may go, if it may go at all."""
        far = 2 * steps
        while self._kept(path, aside, far):
            steps, far = far, 2 * far
        longer = range(far)
        return bisect_left(longer, True, lo=steps, key=lambda more: not self._kept(path, aside, more)) - 1

    def _kept(self, path: "_Path", aside: int, steps: int) -> bool:
        """Whether the band is kept by a path of so many steps with both extremes of the feeds."""
        stretch, at, stop, speeds = path.stretch, path.at, path.stop(aside, steps), path.speeds
        if not path.leads(stop) or _passes(stretch, at, stop):  # most do not
            return False
        fast, slow = 1 + self.feed_error, 1 - self.feed_error
        extremes = [(speeds[0] * fast, speeds[1] * slow), (speeds[0] * slow, speeds[1] * fast)]
        corners = [corner(at, stop, *extreme) for extreme in extremes]
        if not all(stretch.inside(x, y) for x, y in corners):
            return False  # most paths that leave the band leave it there
        x, y = at
        for u, v in corners:  # from there along one axis to the stop, which is in the band too
            for place in _MIDDLE_FIRST:
                if not stretch.inside(x + (u - x) * place, y + (v - y) * place):
                    return False
        return True


def _asides(stretch: Stretch, at: Point, x: int, y: int) -> range:
    """Return the shifts to try beside a path: across the band along X or Y, both ways."""
    width = _steps_inside(stretch, at, x, y) + _steps_inside(stretch, at, -x, -y)
    return range(-width, width + 1, max(1, width // 10))


def _steps_inside(stretch: Stretch, at: Point, x: int, y: int) -> int:
    """Return how many steps of `x`, `y` from a stop are still in the band, at most 100."""
    steps = 0
    while steps < 100 and stretch.inside(at.x + x * (steps + 1), at.y + y * (steps + 1)):
        steps += 1
    return steps


def _passes(stretch: Stretch, at: Point, stop: Point) -> bool:
    """Whether the end of the stretch lies between the two points."""
    x, y = stretch.last_x, stretch.last_y
    passes_x = x is not None and (stop.x - x) * (at.x - x) < 0
    return passes_x or (y is not None and (stop.y - y) * (at.y - y) < 0)
