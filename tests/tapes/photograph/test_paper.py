"""A row of holes becomes a tape: the row of another track, turned, too short, or without a hole beside it."""

import numpy as np
import pytest

from tapes.errors import TapeError
from tapes.photograph.flat import flatten
from tapes.photograph.paper import _longer, find
from tapes.photograph.pixels import Array
from tapes.photograph.sprockets import Row
from tests.tapes.photograph.straight import CODE, FEED, TRACKS, at, hole, paper, pictures, row, sheet, tape

LENGTH = 26
CODES = [(u, v) for u in range(LENGTH) for v in TRACKS if (7 * u + 3 * v * v) % 5 < 2 or v == 4]
"""Channel 7 is a hole in every frame."""


def drawn(side: int = 1, width: float = 1, codes: list[tuple[int, int]] = CODES, code: float = CODE) -> Array:
    light = np.full_like(tape(LENGTH), 60)
    across = sorted((-3.92 * side * width, 6.08 * side * width))
    paper(light, (-14, LENGTH + 13), (across[0], across[1]))
    for u in range(LENGTH):
        hole(light, u, 0, FEED)
    for u, v in codes:
        hole(light, u, v * side * width, code)
    return light


@pytest.mark.parametrize(
    ("side", "width", "codes", "track", "rows"),
    [
        (1, 1, CODES, 0, range(LENGTH)),
        (1, 1, CODES, 0, range(4, 19)),
        (1, 1, CODES, 4, range(3, 24)),
        (-1, 1, CODES, 0, range(4, 19)),
        (-1, 1, CODES, -4, range(LENGTH)),
        (1, 1.3, [], 0, range(LENGTH)),
        (-1, 0.75, [], 0, range(LENGTH)),
    ],
)
def test_the_tape_of_a_row_is_found(
    side: int, width: float, codes: list[tuple[int, int]], track: int, rows: range
) -> None:
    light = drawn(side, width, codes)
    start = Row(at(np.array(rows, float), np.array(float(track))), np.ones(len(rows), dtype=bool))
    found = find(pictures(light), start)
    assert found.seen.tolist() == [True] * LENGTH
    assert found.edged.all()
    assert found.astray.max() < 0.05
    u, v = np.arange(float(LENGTH)), np.arange(-3.0, 6)[:, None]
    away = found.sheet.place(u, v) - at(u if side > 0 else LENGTH - 1 - u, v * side * width)
    assert abs(away[..., 1]).max() < 0.6
    assert not codes or abs(away).max() < 0.6, "without codes the slant is not known"


def test_a_row_in_which_holes_were_put_is_turned_with_them() -> None:
    start = row(LENGTH)._replace(seen=np.arange(LENGTH) != 3)
    assert np.nonzero(~find(pictures(drawn()), start).seen)[0].tolist() == [3]
    assert np.nonzero(~find(pictures(drawn(-1)), start).seen)[0].tolist() == [LENGTH - 4]


def test_holes_of_one_size_are_no_tape() -> None:
    with pytest.raises(TapeError, match="the holes are all of one size"):
        find(pictures(drawn(code=FEED)), row(LENGTH))


@pytest.mark.parametrize(
    ("holes", "faint", "before", "after"),
    [
        ({}, 0, 0, 0),
        ({-1: 0, -2: 0, 20: 0, 21: 0, 22: 0, 23: 0}, 0, 2, 3),
        ({-1: 0.23, -2: -0.23, 20: 0.23}, 0, 2, 1),
        ({-2: 0, -3: 0, 21: 0}, 0, 0, 0),
        ({-1: 0, 20: 0}, 0.54, 1, 1),
        ({-1: 0, 20: 0}, 0.46, 0, 0),
        ({-1: 0.45, 20: -0.45}, 0, 0, 0),
    ],
)
def test_a_row_is_longer_by_the_holes_beyond_its_ends(
    holes: dict[int, float], faint: float, before: int, after: int
) -> None:
    light = np.full_like(tape(20), 200)
    for place in range(20):
        hole(light, place, 0, FEED)
    for number, away in holes.items():
        hole(light, number - away, away, FEED, 200 - 140 * (faint or 1))
    seen = np.arange(20) != 7
    found, first = _longer(
        flatten(pictures(light), sheet(20)), sheet(20), row(20)._replace(seen=seen), pictures(light)
    )
    assert first == before
    assert found.seen.tolist() == [True] * before + seen.tolist() + [True] * after
    u = np.arange(-before, 20.0 + after)
    off = np.array([holes.get(int(number), 0) for number in u])
    assert found.places == pytest.approx(at(u - off, off), abs=0.75)
