"""A closed profile about a centre: a cam as r(x), x the angle, or an outline through points.

               .-'''-.        r is the part's edge, or without a cutter the path of its centre. A cutter has
             .'   |   '.      its centre on the normal, outside the part or inside a hole, and goes round a
    start > |     +--r--|     corner in an arc. The path is cut clockwise from the side of least X, split
             '.       .'      where it turns along X or along Y; the band is E wide to each side of it,
               '-...-'        square to it.

An edge that bends more sharply than the cutter, on its side, cannot be cut, nor a gap too narrow for it.
In an inner corner the cutter may leave .001 in.

Not of the thesis: its technique, on a curve of ours. Source: thesis, Chapter 3, for the band of a curve.
"""

from bisect import bisect_left
from collections.abc import Callable, Sequence
from itertools import pairwise
from math import atan2, ceil, cos, radians, sin, sqrt
from typing import Annotated, Literal

from programs import points
from programs.format import Overflow
from programs.function import CutterOfSurface, check_cutter
from programs.header import THESIS, Header
from programs.milling import SLOWEST, Milling
from programs.points import Place, length, turn
from programs.stretches import Curve, Point, Side, Stretch, check_tolerance, side_of, sign
from programs.units import INCHES, thousandths, tolerance_units
from tapes.errors import WorkError
from tapes.expression import LANGUAGE, function

_PLACES = 1440
_FURTHEST = 0.1
"""Inches by which the radius changes from place to place."""
_LEFT = 1
"""Thousandths of an inch that a cutter may leave in a corner."""
_STEP = radians(2)
_FLAT = 1e-6
"""Thousandths of an inch; a shorter step along an axis has no direction."""


RoundSide = Annotated[Literal["outside", "inside"], "side of the surface that the cutter is on", "cutter"]


def part(
    expression: Annotated[
        str, f"the radius as a function of the angle x, in inches and radians, x from 0 to 2 pi: {LANGUAGE}"
    ],
    *,
    tolerance: Annotated[float, "half the width of the band", INCHES.below(1)] = 0.005,
    centre_x: Annotated[float, "X of the table where the centre is", INCHES] = 4.0,
    centre_y: Annotated[float, "Y of the table where the centre is", INCHES] = 4.0,
    cutter: CutterOfSurface = None,
    side: RoundSide = "outside",
    milling: Milling = SLOWEST,
    header: Header = THESIS,
    overflow: Overflow = "low-digits",
) -> str:
    """Return the printout of the profile r = `expression`, or of an outline; inches. Raises WorkError."""
    is_outline = "\n" in expression
    edge = points.outline(points.read(expression), tolerance) if is_outline else _polar(expression)
    across, up = thousandths("centre X", centre_x), thousandths("centre Y", centre_y)
    clockwise = [(1000 * x + across, 1000 * y + up) for x, y in reversed(edge)]
    curve = _beside(clockwise, cutter, side, tolerance_units(tolerance))
    return milling.printout(curve, header, overflow)


def beside_oval(x: int, y: int, major: int, minor: int, cutter: float, side: str, tolerance: float) -> Curve:
    """The path of a cutter, inches across, round an ellipse about `x`, `y`; thousandths. Raises WorkError."""
    angles = [radians(360 * place / _PLACES) for place in range(_PLACES, 0, -1)]
    edge = [(x + major * cos(angle), y + minor * sin(angle)) for angle in angles]
    return _beside(edge, cutter, side, tolerance)


def _beside(clockwise: list[Place], cutter: float | None, side: str, tolerance: float) -> Curve:
    if cutter is None:
        return closed(clockwise, tolerance)
    check_cutter(cutter)
    return closed(_offset(clockwise, 500 * cutter * (1 if side == "outside" else -1)), tolerance)


def _polar(expression: str) -> list[Place]:
    """Return places of the profile r = `expression`, counterclockwise; inches. Raises WorkError."""
    radius = function(expression)
    edge: list[Place] = []
    before = 0.0
    for place in range(_PLACES):
        angle = radians(360 * place / _PLACES)
        if not 0 < (r := radius(angle)) < 100:
            raise WorkError(f"at x = {angle:.3f} the radius is {r:g}: it has to be above 0 and on the table")
        edge.append((r * cos(angle), r * sin(angle)))
        if place and abs(r - before) > _FURTHEST:
            raise WorkError(f"at x = {angle:.3f} the radius jumps to {r:g}")
        before = r
    first, last = radius(0), radius(radians(360))
    if abs(last - first) > _FURTHEST:
        raise WorkError(f"the profile is not closed: the radius is {first:g} at 0, {last:g} at 2 pi")
    return edge


def _offset(edge: Sequence[Place], beside: float) -> list[Place]:
    """The path `beside` a closed line, to its left; thousandths. Raises WorkError if it crosses itself."""
    too_big = f"cutter of {abs(beside) / 500:g} in is too big: "
    path: list[Place] = []
    end = _about(edge[-2], edge[-1], edge[0], beside)[-1]
    for before, here, after in zip([edge[-1], *edge], edge, [*edge[1:], edge[0]], strict=False):
        places = _about(before, here, after, beside)
        across, up = places[0][0] - end[0], places[0][1] - end[1]
        if (here[0] - before[0]) * across + (here[1] - before[1]) * up <= 0:
            raise WorkError(f"{too_big}the profile bends more sharply, or is rough, at {_at(before)}")
        if len(places) == 1 and (left := length(here, places[0]) - abs(beside)) > _LEFT:
            raise WorkError(f"{too_big}it leaves {left / 1000:.3f} in in the corner at {_at(here)}")
        path += places
        end = path[-1]
    if (place := points.crossing(path)) is not None:
        raise WorkError(f"{too_big}its path crosses itself at {_at(place)}")
    return path


def _about(before: Place, here: Place, after: Place, beside: float) -> list[Place]:
    """Return the path past `here`, `beside` it: a place, or an arc at a corner."""
    angle = turn(before, here, after)
    half = atan2(here[1] - before[1], here[0] - before[0]) + angle / 2 + radians(90)
    if angle * beside >= 0 or abs(angle) < _STEP:
        reach, ways = beside / cos(angle / 2), [half]
    else:
        steps = ceil(abs(angle) / _STEP)
        reach, ways = beside, [half + angle * (step / steps - 0.5) for step in range(steps + 1)]
    return [(here[0] + reach * cos(way), here[1] + reach * sin(way)) for way in ways]


def _at(place: Place) -> str:
    return f"X {place[0] / 1000:.3f} Y {place[1] / 1000:.3f}"


def closed(path: Sequence[Place], tolerance: float) -> Curve:
    """The closed curve through near places, from the one of least X. Raises WorkError for the tolerance."""
    xs, ys = [x for x, _ in path], [y for _, y in path]
    check_tolerance(tolerance, min(max(xs) - min(xs), max(ys) - min(ys)) / 2)
    first = xs.index(min(xs))
    path = [*path[first:], *path[: first + 1]]
    start = Point(round(path[0][0]), round(path[0][1]))
    sides = list(pairwise(path))
    right = _ways([other[0] - one[0] for one, other in sides])
    ways = list(zip(right, _ways([other[1] - one[1] for one, other in sides]), strict=True))
    turns = [at for at, (one, other) in enumerate(pairwise(ways), 1) if one != other]
    stretches = []
    for begin, end in pairwise([0, *turns, len(path) - 1]):
        dx, dy = ways[begin]
        last = Point(round(path[end][0]), round(path[end][1]))
        turns_x = end < len(ways) and ways[end][0] != dx
        last_x = None if turns_x else last.x
        last_y = last.y if turns_x else None
        if end == len(path) - 1:
            last_x, last_y = start
        side = _band(path[begin : end + 1], dx, dy, tolerance)
        stretches.append(Stretch(dx, dy, side, "Y" if dx * dy > 0 else "X", last_x, last_y))
    return Curve(start, tuple(stretches), start)


def _ways(steps: list[float]) -> list[int]:
    """Return the direction of each step, 1 or -1; a zero-length step takes the previous direction."""
    way = next(sign(step) for step in steps if abs(step) > _FLAT)
    ways = []
    for step in steps:
        way = sign(step) if abs(step) > _FLAT else way
        ways.append(way)
    return ways


def _band(path: Sequence[Place], dx: int, dy: int, tolerance: float) -> Callable[[float, float], Side]:
    """Return which side of the band about a piece of a path a point is on; left of the path is above.

    Along the piece X and Y each have one direction.
    """
    ways = [dx * x + dy * y for x, y in path]
    lines = [(*start, end[0] - start[0], end[1] - start[1]) for start, end in pairwise(path)]
    end, reach = len(lines), 2 * tolerance + 2

    def side(x: float, y: float) -> Side:
        along = dx * x + dy * y
        first = min(end, max(1, bisect_left(ways, along - reach)))
        last = max(first, min(end, bisect_left(ways, along + reach)))
        nearest, left = 1e18, True
        for start_x, start_y, across, up in lines[first - 1 : last]:
            right, above = x - start_x, y - start_y
            part = (across * right + up * above) / (across * across + up * up)
            part = 0.0 if part < 0 else 1.0 if part > 1 else part
            aside, beyond = right - part * across, above - part * up
            away = aside * aside + beyond * beyond
            if away < nearest:
                nearest, left = away, across * above >= up * right
        return side_of(sqrt(nearest) if left else -sqrt(nearest), -tolerance, tolerance)

    return side
