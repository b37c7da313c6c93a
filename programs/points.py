"""Points of a file, x and y on each line: measured ones, for a fit, or the outline of a part.

An outline's points are joined by straight lines. Where these turn by 30 degrees or less they are taken for a
curve: an arc through three of them has to be within the tolerance of its chord. Where they turn by more, the
outline has a corner there.
"""

from itertools import pairwise
from math import atan2, ceil, degrees, floor, isfinite, sqrt, tan

from tapes.errors import WorkError

Place = tuple[float, float]

_MOST = 5_000
_WIDEST = 100
"""Inches: no machine's table is as wide."""
_CURVED, _SHARPEST = 30, 90
"""Degrees between two sides."""
_ROUNDING = 1e-6
_FINE, _LEAST = 0.0005, 0.002
"""Inches that a line may go back: up to half a step of the machine, or from twice the tolerance plus this."""


def read(text: str) -> list[Place]:
    """The points of a text, x and y on each line, # for comments. Raises WorkError, naming the line."""
    points: list[Place] = []
    for number, line in enumerate(text.split("\n"), 1):
        words = line.partition("#")[0].replace(",", " ").split()
        if not words:
            continue
        try:
            x, y = [float(word) for word in words]
        except ValueError:
            raise WorkError(f"line {number}: {line!r} is not x and y of a point") from None
        if not (isfinite(x) and isfinite(y)):
            raise WorkError(f"line {number}: {line!r} is not finite")
        points.append((x, y))
    if not points:
        raise WorkError("no points: x and y are needed on each line")
    return points


def outline(points: list[Place], tolerance: float) -> list[Place]:
    """Return the corners of the closed line through the points, counterclockwise. Raises WorkError."""
    if len(points) > _MOST:
        raise WorkError(f"{len(points):,} points: at most {_MOST:,} are allowed")
    for x, y in points:
        if max(abs(x), abs(y)) >= _WIDEST:
            raise WorkError(f"{_at((x, y))} is off the table: lengths are inches")
    line = [there for here, there in pairwise([points[-1], *points]) if there != here]
    if len(line) < 3:
        raise WorkError(f"a closed outline has three different points or more, not {len(line) or 1}")
    _check_closed(line)
    for before, here, after in zip([line[-1], *line], line, [*line[1:], line[0]], strict=False):
        _check_turn(before, here, after, tolerance)
    for axis in (0, 1):
        _check_smooth(line, axis, 2 * tolerance + _LEAST)
    if (place := crossing(line)) is not None:
        raise WorkError(f"the outline crosses or touches itself at {_at(place)}")
    around = sum(x * there[1] - there[0] * y for (x, y), there in pairwise([*line, line[0]]))
    return line if around > 0 else list(reversed(line))


def _check_closed(line: list[Place]) -> None:
    gap, widest = length(line[-1], line[0]), max(length(here, there) for here, there in pairwise(line))
    if gap > widest * (1 + _ROUNDING):
        raise WorkError(
            f"the outline is open: its last point, {_at(line[-1])}, is {gap:.3f} in from its first, further "
            "than any two neighbours; to close it by a straight line, repeat the first point at the end"
        )


def _check_turn(before: Place, here: Place, after: Place, tolerance: float) -> None:
    angle = abs(turn(before, here, after))
    around = degrees(angle)
    if round(around) > _SHARPEST:
        raise WorkError(
            f"the outline turns back at {_at(here)}: by {around:.0f} degrees, {_SHARPEST} at most"
        )
    one, other = length(before, here), length(here, after)
    bow = min(one, other) ** 2 / (one + other) * tan(angle / 2) / 2
    if around <= _CURVED and bow > tolerance:
        raise WorkError(
            f"at {_at(here)} the points are too far apart: a curve through them is {bow:.4f} in off the "
            f"straight line, tolerance {tolerance:g} in"
        )


def _check_smooth(line: list[Place], axis: int, least: float) -> None:
    """Raise WorkError where a line turns back by less than `least` along an axis, so that a stop may miss."""
    end: float | None = None
    values = [place[axis] for place in line]
    start = values.index(min(values))
    forth = True
    for here, there in pairwise([*line[start:], *line[: start + 1]]):
        if there[axis] != here[axis] and (there[axis] > here[axis]) != forth:
            forth = not forth
            by = abs(here[axis] - end) if end is not None else 0.0
            if _FINE < by < least:
                raise WorkError(
                    f"the outline is rough at {_at(here)}: along {'XY'[axis]} it turns back by "
                    f"{by:.4f} in; less than {least:g} is too little to cut: smooth it"
                )
            end = here[axis]


def crossing(line: list[Place]) -> Place | None:
    """Return a place near which a closed line crosses or touches itself, or None."""
    sides = list(pairwise([*line, line[0]]))
    cell = max(sum(length(*side) for side in sides) / len(sides), _ROUNDING)
    within: dict[int, list[int]] = {}
    for at, (start, end) in enumerate(sides):
        for place in sorted(_cells(start, end, cell)):
            others = within.setdefault(place, [])
            for other in others:
                if 1 < at - other < len(sides) - 1 and _meet(start, end, *sides[other]):
                    return start
            others.append(at)
    return None


def _cells(start: Place, end: Place, cell: float) -> set[int]:
    """Return the squares of a grid that a side may pass through, each a number."""
    pieces = ceil(length(start, end) / cell) or 1
    across, up = (end[0] - start[0]) / pieces, (end[1] - start[1]) / pieces
    found = set()
    for piece in range(pieces):
        x, y = start[0] + piece * across, start[1] + piece * up
        for column in range(floor(min(x, x + across) / cell), floor(max(x, x + across) / cell) + 1):
            for row in range(floor(min(y, y + up) / cell), floor(max(y, y + up) / cell) + 1):
                found.add(column * 1_000_000 + row)
    return found


def _meet(a: Place, b: Place, c: Place, d: Place) -> bool:
    """Whether two sides have a point in common."""
    apart_x = max(a[0], b[0]) < min(c[0], d[0]) or max(c[0], d[0]) < min(a[0], b[0])
    apart_y = max(a[1], b[1]) < min(c[1], d[1]) or max(c[1], d[1]) < min(a[1], b[1])
    if apart_x or apart_y:
        return False
    return _left(a, b, c) * _left(a, b, d) <= 0 and _left(c, d, a) * _left(c, d, b) <= 0


def _left(a: Place, b: Place, c: Place) -> float:
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def turn(before: Place, here: Place, after: Place) -> float:
    """Return the angle by which a line turns at a point, radians, + to the left."""
    ahead = (after[0] - here[0]) * (here[0] - before[0]) + (after[1] - here[1]) * (here[1] - before[1])
    return atan2(_left(before, here, after), ahead)


def length(here: Place, there: Place) -> float:
    """Return the distance of two points."""
    x, y = there[0] - here[0], there[1] - here[1]
    return sqrt(x * x + y * y)


def _at(place: Place) -> str:
    return f"X {place[0]:g} Y {place[1]:g}"
