"""A row of holes becomes a tape, a sheet of paper with holes and edges at their places, or is refused."""

from typing import NamedTuple

import numpy as np

from tapes.errors import TapeError
from tapes.photograph.edges import find_edges, find_side
from tapes.photograph.flat import flatten
from tapes.photograph.holes import by_holes, find_holes, grid, row_points
from tapes.photograph.pixels import Array
from tapes.photograph.sheet import Points, Sheet, fit
from tapes.photograph.sprockets import FEWEST, Row, Sizes, follow, measured


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
    """Return the tape whose sprocket holes, or one of whose code tracks, are in a row.

    Raises TapeError, which says what is not as on a tape.
    """
    sheet = by_holes(pictures, row)
    side = find_side(flatten(pictures, sheet), sheet)
    if side.track:
        row = _sprockets(pictures, sheet, side.track)
        sheet = by_holes(pictures, row)
        side = find_side(flatten(pictures, sheet), sheet)
        if side.track:
            raise TapeError("the sprocket holes cannot be told from code holes")
    if side.three > 0:
        row = Row(row.places[::-1], row.seen[::-1])
        sheet = fit(len(row.places), _turned(grid(sheet, side.width), len(row.places)), None)
    elif side.width != 1:
        sheet = fit(len(row.places), grid(sheet, side.width), None)
    for _ in range(3):
        flat = flatten(pictures, sheet)
        edges, edged = find_edges(flat, sheet)
        holes, astray = find_holes(flat, sheet, range(-3, 6))
        sheet = fit(sheet.length, row_points(row).and_(holes, edges), sheet)
    return Found(sheet, row.seen, astray, edged)


def _turned(points: Points, length: int) -> Points:
    return points._replace(u=length - 1 - points.u, v=-points.v)


def _sprockets(pictures: Sizes, sheet: Sheet, track: int) -> Row:
    """Return the row of sprocket holes on a track of the sheet."""
    u = np.arange(sheet.length)
    places = sheet.place(u, np.full_like(u, track))
    steps = np.gradient(places, axis=0)
    depth = [measured(pictures, *hole)[1] for hole in zip(places, steps, strict=True)]
    start = int(np.convolve(depth, np.ones(FEWEST), "valid").argmax())
    return follow(pictures, places[start : start + FEWEST])
