"""The Piece-wise Linear Technique of Chapter 3: X and Y run together, at two feeds that follow the slope.

          .---B      From A both axes start, each at its own feed; one arrives, the other moves on alone
       .'            (Figure 3.1). A block goes as far as the band allows for any error of the feeds. Of all
     .'              pairs of feeds, the pair with the greatest distance per block is used: a block sets one
    A                feed, so a change of both needs one block more.

A feed is within 20 % of its value in Table 2.4. The path must stay in the band for both extremes, X fast and
Y slow, and X slow and Y fast; all other paths lie between them. With a feed error of 0 the feeds are exact.
Where no pair fits, the block goes along one axis: the limiting case of Chapter 3. The band is checked at
twelve points of each leg; the bands of stretches are smooth enough for that.

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


class Feeds(NamedTuple):
    """The feed codes of Table 2.4 that X and Y have; 0 for an axis that stands still."""

    x: int
    y: int


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
        for feeds in self._choices(force):
            blocks = 1 + all(code and code != now for code, now in zip(feeds, force, strict=True))
            for aside in _asides(stretch, at, feeds) if self.feed_error else (0,):
                stop = self._reach(stretch, at, feeds, aside, most * blocks)
                x, y = stop.x - at.x, stop.y - at.y
                gain = sqrt(x * x + y * y) / blocks
                if gain > most:
                    best, most = Ray(feeds, stop), gain
        if best is None:
            raise WorkError(f"at X {at.x / 1000:.3f} Y {at.y / 1000:.3f} no pair of feeds stays in the band")
        return best

    def _choices(self, force: Feeds) -> Iterator[Feeds]:
        codes = range(1, self.fastest + 1)
        yield Feeds(force.x or 1, 0)
        yield Feeds(0, force.y or 1)
        yield from (Feeds(x, y) for x in codes for y in codes)

    def _reach(self, stretch: Stretch, at: Point, feeds: Feeds, aside: int, beyond: float) -> Point:
        """Return the furthest stop for `feeds`, so much aside of where they lead.

        That is `at` if none is further than `beyond`.
        """
        speeds = tuple(XY_FEED[code] if code else 0.0 for code in feeds)
        fastest = max(speeds)
        across, up = stretch.dx * speeds[0] / fastest, stretch.dy * speeds[1] / fastest
        x, y = (at.x, at.y + aside) if speeds[0] == fastest else (at.x + aside, at.y)

        def stop(steps: int) -> Point:
            return Point(x + round(across * steps), y + round(up * steps))

        def kept(steps: int) -> bool:
            there = stop(steps)
            if (there.x - at.x) * stretch.dx < 0 or (there.y - at.y) * stretch.dy < 0:
                return False
            return not _passes(stretch, at, there) and self._keeps(stretch, at, there, speeds)

        both_move = ceil(1 / min(abs(part) for part in (across, up) if part))
        steps = max(both_move, int(beyond / sqrt(across * across + up * up)) + 1)
        if not kept(steps):
            return at
        far = 2 * steps
        while kept(far):
            steps, far = far, 2 * far
        return stop(bisect_left(range(far), True, lo=steps, key=lambda more: not kept(more)) - 1)

    def _keeps(self, stretch: Stretch, at: Point, stop: Point, speeds: tuple[float, ...]) -> bool:
        """Whether the path is inside the band for both extremes of the feeds, which enclose all others."""
        fast, slow = 1 + self.feed_error, 1 - self.feed_error
        extremes = [(speeds[0] * fast, speeds[1] * slow), (speeds[0] * slow, speeds[1] * fast)]
        if not all(stretch.inside(*corner(at, stop, *extreme)) for extreme in extremes):
            return False  # most paths that leave the band leave it there
        return all(stretch.inside(x, y) for extreme in extremes for x, y in way(at, stop, extreme))


def _asides(stretch: Stretch, at: Point, feeds: Feeds) -> range:
    """Return how far aside of a ray the stops are that are tried: across the band, either way."""
    if 0 in (feeds.x, feeds.y):
        return range(1)
    x, y = (0, 1) if feeds.x >= feeds.y else (1, 0)
    width = _room(stretch, at, x, y) + _room(stretch, at, -x, -y)
    return range(-width, width + 1, max(1, width // 10))


def _room(stretch: Stretch, at: Point, x: int, y: int) -> int:
    """Return how many steps of `x`, `y` from a stop are still in the band, at most 100."""
    room = 0
    while room < 100 and stretch.inside(at.x + x * (room + 1), at.y + y * (room + 1)):
        room += 1
    return room


def way(at: Point, stop: Point, speeds: tuple[float, float]) -> Iterator[tuple[float, float]]:
    """Yield points of the path from `at` to `stop`: both axes at their speeds, then one alone."""
    together = corner(at, stop, *speeds)
    for (x, y), (u, v) in ((at, together), (together, stop)):
        for place in range(1, _PLACES + 1):
            part = place / _PLACES
            yield x + (u - x) * part, y + (v - y) * part


def _passes(stretch: Stretch, at: Point, stop: Point) -> bool:
    """Whether the end of the stretch lies between the two points."""
    x, y = stretch.last_x, stretch.last_y
    return (x is not None and (stop.x - x) * (at.x - x) < 0) or (
        y is not None and (stop.y - y) * (at.y - y) < 0
    )
