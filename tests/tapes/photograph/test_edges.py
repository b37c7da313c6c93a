"""The edges of a sheet say which is the sprocket track, and where the paper is, or that it is no tape."""

from collections.abc import Sequence

import numpy as np
import pytest

from tapes.errors import TapeError
from tapes.photograph.edges import _paper, find_edges, find_side
from tapes.photograph.flat import Flat, flatten
from tapes.photograph.pixels import Array
from tapes.photograph.sheet import FIVE, THREE
from tests.tapes.photograph.straight import CODE, FEED, TRACKS, at, hole, paper, pictures, sheet, tape

LENGTH = 30
PLAIN = (-THREE, FIVE)
CODES = [(u, v) for u in range(LENGTH) for v in TRACKS if (7 * u + 3 * v * v) % 5 < 2]
"""Code holes, 12 rows of 30 on each track."""


def drawn(
    across: tuple[float, float] = PLAIN,
    codes: Sequence[tuple[float, float]] = CODES,
    track: float = 0,
    code: float = CODE,
    feed: int = LENGTH,
    table: int = 60,
) -> Array:
    """Return a tape with its edges at some tracks, its sprocket holes on `track`, and code holes."""
    light = np.full_like(tape(LENGTH), table)
    paper(light, (-0.5, LENGTH - 0.5), across)
    for u in range(feed):
        hole(light, u, track, FEED)
    for along, aside in codes:
        hole(light, along, aside, code)
    return light


def flat(light: Array) -> Flat:
    return flatten(pictures(light), sheet(LENGTH), 12)


ALL = [(u, 0) for u in range(LENGTH)]
"""A code track that is all holes, which the sheet was found by."""


@pytest.mark.parametrize(
    ("light", "side"),
    [
        (drawn(), (0, -1, 1)),
        (drawn((-FIVE, THREE), [(u, -v) for u, v in CODES]), (0, 1, 1)),
        (drawn((-4.92, 5.08), [*ALL, *((u, v - 1) for u, v in CODES[::3])], track=-1), (-1, -1, 1)),
        (drawn((-5.08, 4.92), [*ALL, *((u, 1 - v) for u, v in CODES[::3])], track=1), (1, 1, 1)),
        (drawn((-4.92, 5.08), [*ALL, *((u, v - 1) for u, v in CODES[::3])], track=-1, feed=22), (-1, -1, 1)),
        (drawn(codes=[*CODES, *((u, 2) for u in range(LENGTH))]), (0, -1, 1)),
        (drawn((-THREE * 1.2, FIVE * 1.2), []), (0, -1, 1.2)),
        (drawn((-FIVE * 1.75, THREE * 1.75), []), (0, 1, 1.75)),
        (drawn((-THREE * 0.57, FIVE * 0.57), []), (0, -1, 0.57)),
        (drawn((-THREE * 1.2, FIVE * 1.2), CODES[:12]), (0, -1, 1.2)),
        (drawn(code=FEED * 1.25), (0, -1, 1)),
        (drawn(codes=[(u, 3) for u in range(5, 8)], code=FEED), (0, -1, 1)),
        (drawn(codes=[(u, 4) for u in range(5, 9)], code=FEED), (0, -1, 1)),
        (drawn(codes=[*CODES, *((u, v) for u in (1, 5) for v in (1.5, 2.5))]), (0, -1, 1)),
    ],
)
def test_the_edges_and_the_smaller_holes_say_how_a_tape_lies(
    light: Array, side: tuple[int, int, float]
) -> None:
    found = find_side(flat(light), sheet(LENGTH))
    assert (found.track, found.three) == side[:2]
    assert found.width == pytest.approx(side[2], abs=0.09)
    assert found.share > 0.95


@pytest.mark.parametrize(
    ("light", "why"),
    [
        (drawn((-4.92, 5.08), [*ALL, *((u, v - 1) for u, v in CODES[::3])], track=-1, feed=21), "edges"),
        (drawn((-THREE * 1.2, FIVE * 1.2), CODES[:13]), "edges"),
        (drawn((-THREE - 0.7, FIVE)), "edges"),
        (drawn((-THREE, FIVE + 0.7)), "edges"),
        (drawn((-THREE * 2.2, FIVE * 2.2), []), "edges"),
        (drawn(code=FEED * 1.1), "the holes are all of one size"),
        (drawn(codes=[(u, 3) for u in range(5, 9)], code=FEED), "the holes are all of one size"),
        (drawn(codes=[(u, -3) for u in range(5, 9)], code=FEED), "the holes are all of one size"),
    ],
)
def test_what_is_no_tape_is_refused(light: Array, why: str) -> None:
    with pytest.raises(TapeError, match=why):
        find_side(flat(light), sheet(LENGTH))


@pytest.mark.parametrize(("torn", "share"), [(13, 0.58), (16, 0)])
def test_half_of_the_rows_have_both_edges(torn: int, share: float) -> None:
    """Of 31 places between rows."""
    light = drawn()
    paper(light, (-1, torn - 1), (5, 9), 60)
    if not share:
        with pytest.raises(TapeError, match=r"the paper's edges are not 3\.92 and 6\.08 rows"):
            find_side(flat(light), sheet(LENGTH))
    else:
        assert find_side(flat(light), sheet(LENGTH)).share == pytest.approx(share, abs=0.01)


def test_paper_is_what_is_between_most_holes_of_some_rows() -> None:
    light = drawn()
    paper(light, (9.75, 11.25), (-3, 3), 100)
    paper(light, (20, 21), (-1.75, 0.75), 100)
    there = _paper(flat(light), sheet(LENGTH))
    assert there.u.tolist() == [row - 0.5 for row in range(31)]
    assert there.light[1:-1] == pytest.approx(np.full(29, 202), abs=1)
    assert there.depth == pytest.approx(
        (1 - 60 / 202) * (1 - np.exp(-((FEED * 12 / 1.2) ** 2) / 2)), abs=0.02
    )
    paper(light, (8.75, 11.75), (-3, 3), 100)
    assert _paper(flat(light), sheet(LENGTH)).light[10:13] == pytest.approx([102] * 3, abs=1)


@pytest.mark.parametrize("off", [(0.0, 0.0), (0.2, -0.25), (-0.25, 0.2)])
def test_edges_are_where_they_were_drawn(off: tuple[float, float]) -> None:
    light = drawn((-THREE + off[0], FIVE + off[1]))
    points, both = find_edges(flat(light), sheet(LENGTH))
    u = np.arange(-0.5, LENGTH)
    assert both.all()
    assert points.u.tolist() == [*u, *u]
    assert points.v.tolist() == [-THREE] * 31 + [FIVE] * 31
    away = (points.pixels - at(points.u, points.v + np.repeat(off, 31)))[:, 1]
    assert away[[*range(1, 30), *range(32, 61)]] == pytest.approx(np.zeros(58), abs=0.3)
    assert points.direction == pytest.approx(np.tile([0.0, 1.0], (62, 1)), abs=0.001)
    assert (points.weight == 0.3).all()


@pytest.mark.parametrize(
    ("level", "inside", "edge"), [(140, 200, True), (148, 200, False), (20, 142, True), (20, 120, False)]
)
def test_an_edge_is_less_dark_than_a_hole_and_beside_paper(level: int, inside: int, edge: bool) -> None:
    """.4 of a hole's darkness of .7; .35 of the paper's light, of 202."""
    light = drawn(table=level)
    paper(light, (-0.5, LENGTH - 0.5), (FIVE - 0.8, FIVE), inside)
    _, both = find_edges(flat(light), sheet(LENGTH))
    assert both[1:-1].any() == both[1:-1].all() == edge


def test_a_row_has_edges_where_one_is_before_or_after_it() -> None:
    light = drawn()
    paper(light, (9.42, 11.58), (5, 9))
    paper(light, (19.75, 20.25), (5, 9))
    assert np.nonzero(~find_edges(flat(light), sheet(LENGTH))[1])[0].tolist() == [10, 11]
