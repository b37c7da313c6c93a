"""A row of holes becomes a tape, a sheet of paper with holes and edges at their places, or is refused."""

from typing import NamedTuple

import numpy as np

from tapes.errors import TapeError
from tapes.photograph.edges import find_edges, find_side
from tapes.photograph.flat import SAMPLES, Flat, find_spots, flatten
from tapes.photograph.holes import FULL, by_holes, find_holes, grid, sprocket_points
from tapes.photograph.pixels import Array
from tapes.photograph.sheet import Sheet, fit
from tapes.photograph.sprockets import FEWEST, Row, Sizes, follow, measured_all

_LONGER = 12
"""How many times the ends of a row are searched for further holes."""


class Found(NamedTuple):
    """A tape that was found: its sheet, with channel 1 at v = -3 and 8 at v = 5 and read as u grows; which of
    its sprocket holes were seen; by how many pitches the holes around each row are astray from their places;
    and which rows have both edges of the paper at their places.
    """

    sheet: Sheet
    seen: Array
    astray: Array
    edged: Array


def find(pictures: Sizes, row: Row) -> Found:
    """The tape with sprockets or a code track in the row. Raises TapeError, naming what no tape has."""
    sheet = by_holes(pictures, row)
    side = find_side(flatten(pictures, sheet, FULL), sheet)
    if side.track:
        row = _sprockets(pictures, sheet, side.track)
        sheet = by_holes(pictures, row)
        side = find_side(flatten(pictures, sheet, FULL), sheet)
        if side.track:
            raise TapeError("the sprocket holes cannot be told from code holes")
    known = grid(sheet, side.width)
    if side.three > 0:
        row = Row(row.places[::-1], row.seen[::-1])
        known = known._replace(u=len(row.places) - 1 - known.u, v=-known.v)
    if side.three > 0 or side.width != 1:
        sheet = fit(len(row.places), known)
    for more in reversed(range(_LONGER)):
        sheet, flat, astray, edged = _refined(pictures, sheet, row)
        longer, before = _longer(flat, sheet, row, pictures)
        if len(longer.places) == len(row.places) or not more:
            break
        known = grid(sheet)
        row = longer
        points = sprocket_points(row).and_(known._replace(u=known.u + before))
        sheet = fit(len(row.places), points)
    return Found(sheet, row.seen, astray, edged)


def _refined(pictures: Sizes, sheet: Sheet, row: Row) -> tuple[Sheet, Flat, Array, Array]:
    for _ in range(3):
        flat = flatten(pictures, sheet)
        edges, edged = find_edges(flat, sheet)
        holes, astray = find_holes(flat, sheet, range(-3, 6))
        sheet = fit(sheet.length, sprocket_points(row).and_(holes, edges), sheet)
    return sheet, flat, astray, edged


def _longer(flat: Flat, sheet: Sheet, row: Row, pictures: Sizes) -> tuple[Row, int]:
    """Return the row, lengthened by sprocket holes seen beyond its ends, and how many were added in front."""
    spots = find_spots(flat.dark)
    u = np.arange(sheet.length, dtype=float)
    limit = 0.5 * np.median(flat.take(spots, u, 0 * u))
    near = np.arange(-3, 4) / SAMPLES
    ends: list[list[Array]] = []
    for places in (-1.0 - np.arange(3), sheet.length + np.arange(3.0)):
        ends.append([])
        for place in places:
            depth = flat.take(spots, *np.broadcast_arrays(place + near[:, None], near))
            along, aside = np.unravel_index(int(depth.argmax()), depth.shape)
            there = sheet.place(np.array(place + near[along]), np.array(near[aside]))
            if depth[along, aside] < limit or not pictures.show(there):
                break
            ends[-1].append(there)
    before, after = (np.reshape(end, (-1, 2)) for end in (ends[0][::-1], ends[1]))
    seen = np.concatenate([np.ones(len(before), bool), row.seen, np.ones(len(after), bool)])
    return Row(np.concatenate([before, row.places, after]), seen), len(before)


def _sprockets(pictures: Sizes, sheet: Sheet, track: int) -> Row:
    """Return the row of sprocket holes on a track of the sheet."""
    u = np.arange(sheet.length, dtype=float)
    places = sheet.place(u, np.full_like(u, track))
    _, depths = measured_all(pictures, places)
    start = int(np.convolve(depths, np.ones(FEWEST), "valid").argmax())
    return follow(pictures, places[start : start + FEWEST])
