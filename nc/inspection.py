"""Inspection: the two walls that a round cutter left along a curve, and their errors.

           outer wall   ~~~~~~~~~~~~~   deviation +: too far out
    normal     ↑        ·············   curve + cutter's radius
    station ───┼──────  nominal curve
               ↓        ·············   curve − cutter's radius
           inner wall   ~~~~~~~~~~~~~   deviation +: too far out

The cutter removes everything it passes over: discs at the path's corners, rectangles between them. From each
station the stylus moves out and in along the normal until it meets metal. The intersections are exact: arcs
are not approximated. There is no wall, nan, where the station itself was not cut, and none where a cutter on
the curve would cut it away from elsewhere, as inside a circle smaller than the cutter. Where the curve is the
surface of a part, only the wall on the part's side is measured.

Deviations and lengths are thousandths of an inch.

Not emulated: the stylus's radius, deflection and wear of the cutter, chips, the machine's +-.0003 in.

Sources: thesis, Chapters 6 and 7 (tolerance band, Talyrond: trough to peak at the apexes and at 45 degrees).
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from nc.curves import Curve, Floats, Stations, fitted
from nc.curves import curve as sampled
from nc.path import Move, Path
from nc.unit import INCH, Unit
from tapes.errors import WorkError
from tapes.nominal import Nominal

STATIONS = 36_000
"""One every hundredth of a degree: .0003 in on the thesis's circle."""

_FEWEST_STATIONS = 3_600
_CUTS_AT_FULL = 4_000
_FOLLOWED = 20
_GROUP = 360
_AT_ONCE = 512
_TENTH = 0.1
"""Thousandths: what a verdict is rounded to, whatever the tolerance is a multiple of."""
_TIE = 1e-6
"""At a corner, of two stations equally near, the one whose normal leads to the place is taken."""
_LEFT = 0.05
"""Thousandths by which a wall of the curve may be cut from elsewhere on it."""
_ALONG = 0.1
"""A part of the radius: a normal that further cuts prolong by more goes along a side of the part."""
_EVERY = 8
_TURNS, _FINE = 50, 16
"""How many of the lowest and highest places are looked at closely, and into how many parts a step goes."""
_DISC = 64
"""So many points of a path that follow each other are within a small disc."""
_PIECE = 10.0
"""Thousandths of a cut, from one place of the cutter's centre to the next."""


@dataclass(frozen=True, eq=False)
class Walls:
    """The error of each wall at each station, (n,), thousandths outward or nan; `part_wall` is the part's."""

    stations: Stations
    outer: Floats
    inner: Floats
    part_wall: str = ""

    @property
    def by_name(self) -> dict[str, Floats]:
        """The measured walls by the names that reports and drawings use."""
        both = {"outer": self.outer, "inner": self.inner}
        return {self.part_wall: both[self.part_wall]} if self.part_wall else both


@dataclass(frozen=True)
class Reading:
    """The least and greatest error of a wall, thousandths outward, at normals of `angle` degrees or all."""

    place: str
    angle: float | None
    wall: str
    lowest: float
    highest: float

    @property
    def trough_to_peak(self) -> float:
        """The difference, in thousandths."""
        return self.highest - self.lowest

    @property
    def error(self) -> float:
        """The error furthest from nominal, in thousandths outward."""
        return max(self.lowest, self.highest, key=abs)


@dataclass(frozen=True, eq=False)
class Inspection:
    """A path measured against its nominal curve; the cutter's diameter and the tolerance are in thousandths.

    `centre` is the furthest that the cutter's centre went inside and outside the curve near it. `stepwise`:
    each cut is along one axis. `gap` is how far the milling ends from its start, thousandths.
    """

    curve: Curve
    cutter: float
    tolerance: float
    walls: Walls
    centre: tuple[float, float]
    stepwise: bool
    gap: float
    readings: tuple[Reading, ...]

    @property
    def worst(self) -> Reading:
        """The reading with the greatest trough to peak at one place, or that of the whole curve."""
        places = [reading for reading in self.readings if reading.angle is not None] or self.readings
        return max(places, key=lambda reading: reading.trough_to_peak)

    @property
    def furthest(self) -> Reading:
        """The reading with the greatest error to .0001 in, at one place if possible."""
        return max(
            self.readings, key=lambda reading: (round(abs(reading.error), 1), reading.angle is not None)
        )

    @property
    def within_tolerance(self) -> bool:
        """Whether all of the curve was cut, and no wall is further off than allowed, to .0001 in."""
        return not self.uncut and abs(self.furthest.error) < self.tolerance + _TENTH / 2

    @property
    def uncut(self) -> float:
        """The part of the curve, 0 to 1, that the cutter did not reach."""
        return float(np.isnan([*self.walls.by_name.values()]).all(axis=0).mean())

    @property
    def without(self) -> dict[str, float]:
        """The part of the curve, 0 to 1, along which this wall is missing."""
        uncut = self.uncut
        return {wall: float(np.isnan(error).mean()) - uncut for wall, error in self.walls.by_name.items()}


def against(path: Path, nominal: Nominal) -> Inspection:
    """Measure the walls against the curve, with its cutter and tolerance. Raises WorkError as `inspect`."""
    cutter = 1000 * nominal.cutter
    return inspect(path, sampled(nominal, cutter), cutter, 1000 * nominal.tolerance)


def inspect(
    path: Path, curve: Curve | None = None, cutter: float = 500, tolerance: float = 5, unit: Unit = INCH
) -> Inspection:
    """Measure the walls that the path left against `curve`, else the circle, ellipse or line it follows.

    `cutter` is the diameter, `tolerance` half the width of the band, both in thousandths. A path follows a
    curve if it stays within .020 in of it, or four times the tolerance if that is more. Raises WorkError if
    nothing was milled, no such curve is found, or it was not cut at all.
    """
    cuts = np.unique(segments(path.cuts), axis=0)  # a tape may go the same way many times
    if not len(cuts):
        raise WorkError("no block of this tape mills: there is no surface to inspect")
    curve = curve or followed(path, tolerance)
    if curve is None:
        raise WorkError(
            "the milled path follows no circle, ellipse or line within "
            f"{unit.said(_follows(tolerance))} {unit.name}: name the nominal curve"
        )
    corners = len(np.unique(cuts.reshape(-1, 2), axis=0))
    count = max(_FEWEST_STATIONS, STATIONS * _CUTS_AT_FULL // max(_CUTS_AT_FULL, corners))
    stations = curve.stations(count)
    found = walls(cuts, stations, cutter / 2, curve.part_wall, tolerance=tolerance)
    measured = _met(_to_edge(curve, found, stations))
    if np.isnan([measured.outer, measured.inner]).all():
        raise WorkError(f"the cutter did not reach the curve: {curve.said(unit)}")
    finer = walls(cuts, _finer(measured), cutter / 2, curve.part_wall, stations.points, tolerance)
    readings = tuple(_readings(curve, measured, _to_edge(curve, finer, stations)))
    stepwise = bool((cuts[:, :2] == cuts[:, 2:]).any(axis=1).all())
    centre = _centre(cuts, stations, cutter)
    return Inspection(curve, cutter, tolerance, measured, centre, stepwise, path.gap, readings)


def _centre(cuts: Floats, stations: Stations, reach: float) -> tuple[float, float]:
    """Return the furthest that the path of the centre is inside and outside of the curve, near it."""
    pieces = np.maximum(1, np.ceil(np.abs(cuts[:, 2:] - cuts[:, :2]).max(axis=1) / _PIECE)).astype(np.intp)
    which = np.repeat(np.arange(len(cuts)), pieces)
    part = (np.arange(len(which)) - np.repeat(np.cumsum(pieces) - pieces, pieces)) / pieces[which]
    ways = cuts[which, :2] + part[:, None] * (cuts[which, 2:] - cuts[which, :2])
    places = np.unique(np.concatenate([ways, cuts[:, 2:]]), axis=0)
    off = _off(places, stations.part(slice(None, None, _EVERY)), reach)
    return float(np.nanmin(off)), float(np.nanmax(off))


def _off(places: Floats, stations: Stations, reach: float) -> Floats:
    """Return how far outside of the curve the places (n, 2) are, (n,); nan further away than `reach`."""
    nearest, off = np.full(len(places), reach * reach + _TIE), np.full(len(places), np.nan)
    for here in _groups(stations):
        for near in _about(here.points, reach, places, places):
            x = places[near, :1] - here.points[:, 0]
            y = places[near, 1:] - here.points[:, 1]
            square, along = x * x + y * y, x * here.normals[:, 0] + y * here.normals[:, 1]
            at = np.arange(len(near)), (square - _TIE * along * along).argmin(axis=1)
            closer = square[at] < nearest[near]
            nearest[near[closer]], off[near[closer]] = square[at][closer], along[at][closer]
    return off


def _groups(stations: Stations) -> Iterator[Stations]:
    for first in range(0, len(stations), _GROUP):
        yield stations.part(slice(first, first + _GROUP))


def _about(points: Floats, reach: float, low: Floats, high: Floats) -> Iterator[NDArray[np.intp]]:
    """Yield, in groups, the indices of boxes (n, 2) within `reach` of the points' bounding box."""
    floor, ceiling = points.min(axis=0) - reach, points.max(axis=0) + reach
    near = np.flatnonzero(((high >= floor) & (low <= ceiling)).all(axis=1))
    for first in range(0, len(near), _AT_ONCE):
        yield near[first : first + _AT_ONCE]


def followed(path: Path, tolerance: float) -> Curve | None:
    """Return the circle, ellipse or line that the milled path follows."""
    cuts = segments(path.cuts)
    if not len(cuts):
        return None
    starts, ends = cuts[:, :2], cuts[:, 2:]
    points = np.vstack([starts[0], (starts + ends) / 2, ends])
    return fitted(points, within=_follows(tolerance), band=tolerance + 1)


def _follows(tolerance: float) -> float:
    return max(_FOLLOWED, 4 * tolerance)


def segments(moves: Sequence[Move]) -> Floats:
    """Return the milling moves as (n, 4): x and y of the start, x and y of the end."""
    ends = [(*move.start[:2], *move.end[:2]) for move in moves]
    return np.array(ends, dtype=np.float64).reshape(len(moves), 4)


def walls(
    cuts: Floats,
    stations: Stations,
    radius: float,
    part_wall: str = "",
    path: Floats | None = None,
    tolerance: float = 0,
) -> Walls:
    """Return the exact walls that a cutter of this radius leaves at the stations along the cuts (n, 4),
    which are about as far off the curve's `path` as the tolerance.

    An error is infinite where the normal goes along a cut and meets no wall.
    """
    low, high = np.minimum(cuts[:, :2], cuts[:, 2:]), np.maximum(cuts[:, :2], cuts[:, 2:])
    ends = np.full((2, len(stations)), np.nan)
    reach = 2 * radius if part_wall else radius  # beyond a tip, as far as a normal may go on
    for number, here in enumerate(_groups(stations)):
        through = [_through(here, cuts[near], radius) for near in _about(here.points, reach, low, high)]
        if through:
            enter, leave = (np.concatenate(each, axis=1) for each in zip(*through, strict=True))
            ends[:, number * _GROUP : (number + 1) * _GROUP] = _cut_through(enter, leave, radius, part_wall)
    path = stations.points if path is None else path
    found = {}
    for wall, error, sign in (("outer", ends[1] - radius, 1), ("inner", ends[0] + radius, -1)):
        stands = np.full(len(stations), wall == part_wall)
        if not part_wall:  # one out of tolerance, only where no cut from elsewhere comes near
            stands, wrong = _stands(stations, sign * radius, path[::_EVERY]), np.abs(error) > tolerance
            if (stands & wrong).any():
                stands &= ~wrong | _stands(stations, sign * (radius + 2 * tolerance), path[::_EVERY])
        found[wall] = np.where(stands, error, np.nan)
    return Walls(stations, found["outer"], found["inner"], part_wall)


def _cut_through(enter: Floats, leave: Floats, radius: float, part_wall: str) -> Floats:
    """How far each station's normal is within cuts inward and outward, (2, stations), by where it enters and
    leaves each, (stations, cuts); nan where it starts in none, infinite along a side of the part.

    Of a slot only the cuts that it starts in count: another cut may cross it.
    """
    first = ends = np.zeros((2, len(enter)))
    while True:
        within = (enter <= ends[1][:, None]) & (leave >= ends[0][:, None])
        further = np.array(
            [np.where(within, enter, np.inf).min(axis=1), np.where(within, leave, -np.inf).max(axis=1)]
        )
        if first is ends:
            first = np.where(within.any(axis=1), further, np.nan)
        ends, before = np.where(np.isnan(first), np.nan, further), ends
        if not part_wall:
            return ends
        if np.array_equal(ends, before, equal_nan=True):
            return np.where(np.abs(ends - first) > _ALONG * radius, np.copysign(np.inf, ends), ends)


def _stands(stations: Stations, off: float, path: Floats) -> NDArray[np.bool_]:
    """Whether a wall so far `off` the curve remains after a cutter of that radius has gone along `path`."""
    some = np.unique(np.append(np.arange(0, len(stations), _EVERY), len(stations) - 1))
    wall = stations.points[some] + off * stations.normals[some]
    left = ~_reached(wall, path, abs(off) - _LEFT)
    return np.asarray(np.interp(np.arange(len(stations)), some, left) == 1)


def _reached(places: Floats, path: Floats, reach: float) -> NDArray[np.bool_]:
    """Whether a point of the path (m, 2) is within `reach` of each of the places (n, 2), (n,).

    A disc around some points that follow each other tells it of most places.
    """
    pieces = [path[first : first + _DISC] for first in range(0, len(path), _DISC)]
    middles = np.array([(each.min(axis=0) + each.max(axis=0)) / 2 for each in pieces])
    radii = np.sqrt([_squares(each, middle).max() for each, middle in zip(pieces, middles, strict=True)])
    away = _squares(places[:, None], middles)
    within = np.where(radii <= reach, (reach - radii) ** 2, -1)
    found = np.asarray((away <= within).any(axis=1))
    for piece, near in zip(pieces, (away <= (reach + radii) ** 2).T, strict=True):
        unsure = np.flatnonzero(near & ~found)
        found[unsure] = (_squares(places[unsure, None], piece) <= reach * reach).any(axis=1)
    return found


def _squares(one: Floats, other: Floats) -> Floats:
    """Return the squares of the distances between points (..., 2)."""
    x, y = one[..., 0] - other[..., 0], one[..., 1] - other[..., 1]
    return x * x + y * y


def _to_edge(curve: Curve, measured: Walls, stations: Stations) -> Walls:
    """Measure the part's wall from the edge's nearest point: near a cut-off tip it is not on the normal."""
    if not (measured.part_wall and len(curve.tips)):
        return measured
    edge, here = (
        Stations(each.points - curve.beside * each.normals, each.normals, each.along)
        for each in (stations, measured.stations)
    )
    off = measured.by_name[measured.part_wall].copy()
    reach = 3 * float(np.abs(off[np.isfinite(off)]).max(initial=0)) + 1
    near = np.flatnonzero(np.isfinite(off) & _reached(here.points, curve.tips, reach))
    off[near] = _off(here.points[near] + off[near, None] * here.normals[near], edge, 2 * reach)
    return replace(measured, outer=off) if curve.beside < 0 else replace(measured, inner=off)


def _met(measured: Walls) -> Walls:
    """The walls, with the error of the neighbours where a normal meets none."""

    def filled(error: Floats) -> Floats:
        met = np.flatnonzero(np.isfinite(error))
        neighbours = np.interp(np.arange(len(error)), met, error[met]) if len(met) else np.nan
        return np.where(np.isinf(error), neighbours, error)

    return replace(measured, outer=filled(measured.outer), inner=filled(measured.inner))


def _finer(measured: Walls) -> Stations:
    """Return more stations close to the innermost and outermost turning points of the walls."""
    turns: set[int] = set()
    for error in measured.by_name.values():
        for level in (error, -error):
            with_walls = np.where(np.isnan(level), -np.inf, level)
            higher = (with_walls >= np.roll(with_walls, 1)) & (with_walls >= np.roll(with_walls, -1))
            tops = np.flatnonzero(higher & np.isfinite(with_walls))
            turns.update(tops[np.argsort(with_walls[tops])[-_TURNS:]].tolist())
    at = np.array(sorted({turn - side for turn in turns for side in (0, 1)} - {-1}), dtype=np.intp)
    at = at[at + 1 < len(measured.stations)][:, None]
    part = np.arange(1, _FINE)[:, None] / _FINE
    points, normals = (
        (each[at] + part * (each[at + 1] - each[at])).reshape(-1, 2)
        for each in (measured.stations.points, measured.stations.normals)
    )
    return Stations(points, normals / np.hypot(*normals.T)[:, None], np.zeros(len(points)))


def runs(deviation: Floats, closed: bool, every: int = 10) -> list[NDArray[np.intp]]:
    """What a graph of this wall needs: for each stretch, its turning points and one station in `every`."""
    there = np.flatnonzero(~np.isnan(deviation))
    if not len(there):
        return []
    turns = np.zeros(len(deviation), dtype=np.bool_)
    steps = np.diff(deviation[there])
    turns[there[1:-1][np.sign(steps[:-1]) != np.sign(steps[1:])]] = True
    turns[::every] = True
    gaps = np.flatnonzero(np.diff(there) > 1)
    turns[there[[0, -1, *gaps, *gaps + 1]]] = True
    kept = [stretch[turns[stretch]] for stretch in np.split(there, gaps + 1)]
    if closed and len(there) == len(deviation):
        kept[0] = np.append(kept[0], 0)
    return kept


def _through(stations: Stations, cuts: Floats, radius: float) -> tuple[Floats, Floats]:
    """Return where each normal enters and leaves what a cut removes, (stations, cuts); nan if it misses."""
    ends = [_through_discs(stations, corners, radius) for corners in (cuts[:, :2], cuts[:, 2:])]
    enter, leave = zip(_through_sides(stations, cuts, radius), *ends, strict=True)
    return np.fmin.reduce(enter), np.fmax.reduce(leave)


def _through_discs(stations: Stations, centres: Floats, radius: float) -> tuple[Floats, Floats]:
    """Return where each station's normal enters and leaves each disc, (stations, discs); nan if it misses."""
    x = centres[:, 0] - stations.points[:, :1]
    y = centres[:, 1] - stations.points[:, 1:]
    towards = x * stations.normals[:, :1] + y * stations.normals[:, 1:]
    aside = x * stations.normals[:, 1:] - y * stations.normals[:, :1]
    square = radius * radius - aside * aside
    half = np.sqrt(square, out=np.full_like(square, np.nan), where=square >= 0)
    return towards - half, towards + half


def _through_sides(stations: Stations, sides: Floats, radius: float) -> tuple[Floats, Floats]:
    """Return where each normal enters and leaves the rectangle swept along each side; nan if it misses."""
    way = sides[:, 2:] - sides[:, :2]
    length = np.hypot(way[:, 0], way[:, 1])
    along = way / np.where(length, length, np.inf)[:, None]
    across = np.column_stack([-along[:, 1], along[:, 0]])
    middle = (sides[:, :2] + sides[:, 2:]) / 2
    x = stations.points[:, :1] - middle[:, 0]
    y = stations.points[:, 1:] - middle[:, 1]
    enter, leave = np.full(x.shape, -np.inf), np.full(x.shape, np.inf)
    for axis, half in ((along, length / 2), (across, np.full(len(sides), radius))):
        place = x * axis[:, 0] + y * axis[:, 1]
        speed = stations.normals @ axis.T
        still = np.abs(speed) < 1e-12
        speed = np.where(still, 1.0, speed)
        one, other = (-half - place) / speed, (half - place) / speed
        inside = np.abs(place) <= half
        enter = np.maximum(enter, np.where(still, np.where(inside, -np.inf, np.inf), np.minimum(one, other)))
        leave = np.minimum(leave, np.where(still, np.where(inside, np.inf, -np.inf), np.maximum(one, other)))
    missed = (enter > leave) | (length == 0)  # a plunge has no sides
    return np.where(missed, np.nan, enter), np.where(missed, np.nan, leave)


WHOLE = "whole length"
_PLACES = (
    *(("+X apex", 0, 10), ("+Y apex", 90, 10), ("-X apex", 180, 10), ("-Y apex", 270, 10)),
    *(("45° +X+Y", 45, 5), ("45° -X+Y", 135, 5), ("45° -X-Y", 225, 5), ("45° +X-Y", 315, 5)),
)
"""Where a closed curve is read: by normals of this angle, and so many degrees to each side."""


def _readings(curve: Curve, *measured: Walls) -> Iterator[Reading]:
    """Yield the readings of both walls: of all, and of a closed curve at the apexes and at 45 degrees."""
    off = np.concatenate([each.stations.angles for each in measured]) + 180
    walls = {wall: np.concatenate([each.by_name[wall] for each in measured]) for wall in measured[0].by_name}
    for name, angle, reach in ((WHOLE, None, 180), *(_PLACES if curve.closed else ())):
        chosen = np.abs((off - (angle or 0)) % 360 - 180) <= reach
        for wall, deviation in walls.items():
            seen = deviation[chosen & np.isfinite(deviation)]
            if len(seen):
                yield Reading(name, angle, wall, float(seen.min()), float(seen.max()))
