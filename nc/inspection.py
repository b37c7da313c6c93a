"""Inspection: the two walls that a round cutter left along a curve, and their errors.

           outer wall   ~~~~~~~~~~~~~   deviation +: too far out
    normal     ↑        ·············   curve + cutter's radius
    station ───┼──────  nominal curve
               ↓        ·············   curve − cutter's radius
           inner wall   ~~~~~~~~~~~~~   deviation +: too far out

The cutter removes everything it passes over: discs at the path's corners, rectangles between them. From each
station the stylus moves out and in along the normal until it meets metal. The intersections are exact: arcs
are not approximated. There is no wall, nan, where the station itself was not cut, and none on the side to
which the curve bends closer than the cutter's radius, as inside a circle smaller than the cutter.

Deviations and lengths are thousandths of an inch.

Not emulated: the stylus's radius, deflection and wear of the cutter, chips, the machine's +-.0003 in.

Sources: thesis, Chapters 6 and 7 (tolerance band, Talyrond: trough to peak at the apexes and at 45 degrees).
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from nc.curves import Curve, Floats, Stations, fitted
from nc.path import Move, Path
from tapes.errors import WorkError

STATIONS = 36_000
"""One every hundredth of a degree: .0003 in on the thesis's circle."""

_FEWEST_STATIONS = 3_600
_CUTS_AT_FULL = 4_000
_FOLLOWED = 20
_GROUP = 360
_AT_ONCE = 512
_ROUND = 0.999
"""The cutter's radius beside that of the curve's bend, from which it leaves nothing within the bend."""


@dataclass(frozen=True, eq=False)
class Walls:
    """The error of each wall at each station, (n,), in thousandths outward; nan where there is none."""

    stations: Stations
    outer: Floats
    inner: Floats

    @property
    def by_name(self) -> dict[str, Floats]:
        """Both, by what they are called in reports and drawings."""
        return {"outer": self.outer, "inner": self.inner}


@dataclass(frozen=True)
class Reading:
    """The lowest and highest error of one wall about one place, in thousandths outward.

    `angle` is the direction of the normal there, in degrees; None for the whole curve.
    """

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
    each cut is along one axis.
    """

    curve: Curve
    cutter: float
    tolerance: float
    walls: Walls
    centre: tuple[float, float]
    stepwise: bool
    readings: tuple[Reading, ...]

    @property
    def worst(self) -> Reading:
        """The reading of the greatest trough to peak at one place, or of the whole if there is no other."""
        places = [reading for reading in self.readings if reading.angle is not None] or self.readings
        return max(places, key=lambda reading: reading.trough_to_peak)

    @property
    def furthest(self) -> Reading:
        """The reading of the greatest error, at a place if it is at one."""
        return max(self.readings, key=lambda reading: (abs(reading.error), reading.angle is not None))

    @property
    def within_tolerance(self) -> bool:
        """Whether all of the curve was cut, and no wall is further off than allowed, to .0001 in."""
        return not self.uncut and round(abs(self.furthest.error), 1) <= self.tolerance

    @property
    def uncut(self) -> float:
        """The part of the curve, 0 to 1, that the cutter did not reach."""
        return float((np.isnan(self.walls.outer) & np.isnan(self.walls.inner)).mean())

    @property
    def without(self) -> dict[str, float]:
        """The part of the curve, 0 to 1, along which the cutter left no such wall."""
        uncut = self.uncut
        return {wall: float(np.isnan(error).mean()) - uncut for wall, error in self.walls.by_name.items()}


def inspect(path: Path, curve: Curve | None = None, cutter: float = 500, tolerance: float = 5) -> Inspection:
    """Measure the walls that the path left against `curve`, else the circle, ellipse or line it follows.

    `cutter` is the diameter, `tolerance` half the width of the band, both in thousandths. A path follows a
    curve if it stays within .020 in of it, or four times the tolerance if that is more. Raises WorkError if
    nothing was milled, no such curve is found, or it was not cut at all.
    """
    cuts = segments(path.cuts)
    if not len(cuts):
        raise WorkError("no block of this tape mills: there is no surface to inspect")
    curve = curve or followed(path, tolerance)
    if curve is None:
        raise WorkError(
            f"the milled path follows no circle, ellipse or line within {_follows(tolerance) / 1000:.3f} in: "
            "name the nominal curve"
        )
    corners = _corners(cuts)
    count = max(_FEWEST_STATIONS, STATIONS * _CUTS_AT_FULL // max(_CUTS_AT_FULL, len(corners)))
    measured = walls(cuts, curve.stations(count), cutter / 2)
    if np.isnan([measured.outer, measured.inner]).all():
        raise WorkError(f"the cutter did not reach the curve: {curve}")
    centre = curve.deviations(corners[_beside(corners, measured.stations, cutter)])
    readings = tuple(_readings(curve, measured))
    stepwise = bool((cuts[:, :2] == cuts[:, 2:]).any(axis=1).all())
    limits = float(centre.min()), float(centre.max())
    return Inspection(curve, cutter, tolerance, measured, limits, stepwise, readings)


def _corners(cuts: Floats) -> Floats:
    return np.unique(np.concatenate([cuts[:, :2], cuts[:, 2:]]), axis=0)


def _beside(corners: Floats, stations: Stations, reach: float) -> NDArray[np.bool_]:
    """Return which of the corners (n, 2) lie within reach of the curve; all of them if none does."""
    some = stations.points[:: len(stations) // 500]
    apart = np.hypot(*(corners[:, None, :] - some).transpose(2, 0, 1)).min(axis=1)
    near = np.asarray(apart <= reach)
    return near if near.any() else np.ones(len(corners), dtype=np.bool_)


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


def walls(cuts: Floats, stations: Stations, radius: float) -> Walls:
    """Return the walls that a cutter of this radius leaves along the cuts (n, 4), at the stations.

    Exact; the time is in proportion to the stations times the cuts within reach of each.
    """
    outer, inner = np.full(len(stations), -np.inf), np.full(len(stations), np.inf)
    corners = _corners(cuts)
    sides = np.unique(cuts[(cuts[:, :2] != cuts[:, 2:]).any(axis=1)], axis=0)
    low, high = np.minimum(sides[:, :2], sides[:, 2:]), np.maximum(sides[:, :2], sides[:, 2:])
    for first in range(0, len(stations), _GROUP):
        group = slice(first, first + _GROUP)
        here = stations.part(group)
        floor, ceiling = here.points.min(axis=0) - radius, here.points.max(axis=0) + radius
        near_corners = corners[((corners >= floor) & (corners <= ceiling)).all(axis=1)]
        near_sides = sides[((high >= floor) & (low <= ceiling)).all(axis=1)]
        for through, near in ((_through_discs, near_corners), (_through_sides, near_sides)):
            for at in range(0, len(near), _AT_ONCE):
                enter, leave = through(here, near[at : at + _AT_ONCE], radius)
                cut = (enter <= 0) & (leave >= 0)
                inner[group] = np.minimum(inner[group], np.where(cut, enter, np.inf).min(axis=1))
                outer[group] = np.maximum(outer[group], np.where(cut, leave, -np.inf).max(axis=1))
    bend = np.where(np.isfinite(outer), radius * stations.bend, np.nan)
    return Walls(
        stations,
        np.where(bend > -_ROUND, outer - radius, np.nan),
        np.where(bend < _ROUND, inner + radius, np.nan),
    )


def runs(deviation: Floats, closed: bool, every: int = 10) -> list[NDArray[np.intp]]:
    """Return the stations that a graph of this wall needs, a list for each stretch that has a wall.

    They are the turning points and one station in `every`; a closed graph ends at its first station.
    """
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
    along, across = way / length[:, None], np.column_stack([-way[:, 1], way[:, 0]]) / length[:, None]
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
    missed = enter > leave
    return np.where(missed, np.nan, enter), np.where(missed, np.nan, leave)


WHOLE = "whole length"
_APEXES = (("+X apex", 0), ("+Y apex", 90), ("-X apex", 180), ("-Y apex", 270))
_DIAGONALS = (("45° +X+Y", 45), ("45° -X+Y", 135), ("45° -X-Y", 225), ("45° +X-Y", 315))
_APEX_REACH = 10.0
_DIAGONAL_REACH = 5.0


def _readings(curve: Curve, measured: Walls) -> Iterator[Reading]:
    """Yield the readings of both walls: of the whole, and of a closed curve at the apexes and 45 degrees.

    A place is where the normal has that direction, within 10 degrees at an apex and 5 at 45 degrees.
    """
    yield from _readings_at(WHOLE, None, measured, np.ones(len(measured.stations), dtype=np.bool_))
    if not curve.closed:
        return
    angles = measured.stations.angles
    for places, reach in ((_APEXES, _APEX_REACH), (_DIAGONALS, _DIAGONAL_REACH)):
        for name, angle in places:
            off = np.abs((angles - angle + 180) % 360 - 180)
            yield from _readings_at(name, angle, measured, off <= reach)


def _readings_at(
    name: str, angle: float | None, measured: Walls, chosen: NDArray[np.bool_]
) -> Iterator[Reading]:
    for wall, deviation in measured.by_name.items():
        seen = deviation[chosen]
        seen = seen[~np.isnan(seen)]
        if len(seen):
            yield Reading(name, angle, wall, float(seen.min()), float(seen.max()))
