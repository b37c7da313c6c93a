"""The holes of a sheet are where they were drawn, and a sheet is found by them; what is astray is known."""

from itertools import pairwise, product

import numpy as np
import pytest

from tapes.photograph.flat import flatten
from tapes.photograph.holes import _first, _likeliest, by_holes, find_holes, grid, sprocket_points
from tapes.photograph.pixels import Array
from tests.tapes.photograph.straight import CODE, FEED, TRACKS, at, hole, pictures, row, sheet

LENGTH = 30
Holes = list[tuple[float, float]]


def found(
    codes: Holes, off: Holes, contrast: float = 0.7, feed: Holes | None = None
) -> tuple[Array, Array, Array, Array]:
    """Return of paper with sprocket holes, and code holes beside their places: rows, tracks and pixels of the
    first half of the points, weights, and how far astray each row is.
    """
    light = np.full((361, 709), 200.0)
    for u, v in feed or [(u, 0) for u in range(LENGTH)]:
        hole(light, u, v, FEED)
    for (u, v), (along, aside) in zip(codes, off, strict=True):
        hole(light, u + along, v + aside, FEED, 200 * (1 - contrast))
    points, astray = find_holes(flatten(pictures(light), sheet(LENGTH), 8), sheet(LENGTH), range(-3, 6))
    half = slice(None, len(points.u) // 2)
    return np.stack([points.u, points.v], axis=1)[half], points.pixels[half], points.weight[half], astray


CODES: Holes = [(3, 1), (4, -3), (4, 5), (14, 2), (15, 2), (20, -1)]


def test_holes_are_where_they_were_drawn_and_count_as_they_are_near() -> None:
    off = [(0.1, 0.0), (0.0, -0.2), (-0.15, 0.1), (0.24, 0.0), (0.05, 0.05), (0.0, 0.0)]
    places, seen, weight, astray = found(CODES, off)
    drawn = {(u, 0): (0.0, 0.0) for u in range(LENGTH)} | dict(zip(CODES, off, strict=True))
    assert {tuple(place) for place in places.tolist()} == set(drawn)
    away = np.array([drawn[u, v] for u, v in places.tolist()])
    assert seen == pytest.approx(at(*(places + away).T), abs=0.13)
    squares = (away**2).sum(axis=1)
    near = abs(places[:, :1] - np.arange(LENGTH)) <= 3
    expected = np.sqrt((squares[:, None] * near).sum(axis=0) / near.sum(axis=0))
    assert astray == pytest.approx(expected, abs=0.004)
    trust = 1 / (1 + (expected[places[:, 0].astype(int)] / 0.07) ** 4)
    assert weight == pytest.approx(trust / (1 + squares / 0.01), abs=0.03)


@pytest.mark.parametrize(
    ("off", "contrast", "seen"),
    [
        ((0.25, 0.0), 0.7, True),
        ((0.0, -0.25), 0.7, True),
        ((0.31, 0.0), 0.7, False),
        ((0.0, -0.31), 0.7, False),
        ((0.0, 0.0), 0.7 * 0.62, True),
        ((0.0, 0.0), 0.7 * 0.58, False),
    ],
)
def test_a_hole_is_near_its_place_and_nearly_as_dark(
    off: tuple[float, float], contrast: float, seen: bool
) -> None:
    places, _, _, _ = found([(9, 2)], [off], contrast)
    assert ([9, 2] in places.tolist()) == seen


def test_where_no_hole_is_nothing_is_astray() -> None:
    places, _, _, astray = found([], [], feed=[(u, 0) for u in range(LENGTH) if not 8 <= u <= 18])
    assert places[:, 0].tolist() == [u for u in range(LENGTH) if not 8 <= u <= 18]
    assert astray.max() < 0.004


@pytest.mark.parametrize(
    ("u", "v", "rows", "far"),
    [
        (10, 2.5, range(8, 13), 0.5),
        (10 + 4 / 12, 2, range(8, 13), 4 / 12),
        (10, 2 + 5 / 12, range(8, 13), 5 / 12),
        (1 - 5 / 12, 2, range(4), 5 / 12),
        (-5 / 12, 2, range(3), 5 / 12),
        (-7 / 12, 2, range(0), 0),
        (29 + 5 / 12, 2, range(27, 30), 5 / 12),
        (29 + 7 / 12, 2, range(0), 0),
        (10.5 - 1 / 12, -38 / 12, range(8, 13), 5 / 12),
        (10.5 - 1 / 12, -39 / 12, range(0), 0),
        (10.5 - 1 / 12, 64 / 12, range(8, 13), 5 / 12),
        (10.5 - 1 / 12, 65 / 12, range(0), 0),
    ],
)
def test_a_spot_between_the_places_makes_the_rows_around_astray(
    u: float, v: float, rows: range, far: float
) -> None:
    _, _, _, astray = found([(u, v)], [(0, 0)])
    assert np.nonzero(astray > 0.3)[0].tolist() == [*rows]
    assert astray.max() == pytest.approx(far, abs=0.01)


def test_of_spots_that_touch_the_darkest_counts() -> None:
    """And what is fainter than holes does not."""
    _, _, _, astray = found([(10, 2), (10.4, 2), (20.5, 2.5)], [(0, 0)] * 3, 0.7 * 0.55)
    assert astray.max() < 0.01
    assert found([(9.9, 2), (10.3, 2)], [(0, 0)] * 2)[3].max() < 0.2


def test_points_of_a_row_and_a_grid_hold_a_sheet_where_it_is() -> None:
    seen = np.arange(4) != 2
    points = sprocket_points(row(4)._replace(seen=seen))
    assert points.weight.tolist() == [1, 1, 0.05, 1] * 2
    assert points.pixels[:4].tolist() == at(np.arange(4.0), np.array(0)).tolist()
    assert (points.v == 0).all()
    held = grid(sheet(20), 1.5, 0.3)
    assert set(held.weight) == {0.3}
    assert sorted(set(held.u)) == [*range(20)]
    assert (held.v.min(), held.v.max()) == (-3, 5)
    assert held.pixels == pytest.approx(at(held.u, 1.5 * held.v), abs=0.01)


def test_the_likeliest_path_is_the_best_of_all() -> None:
    """Every fourth of 19 rows: of 4**5 paths that which gathers most, less how far it moves."""
    random = np.random.default_rng(1)
    states = np.array([[0, 0], [1, 0], [2, 1], [0, 3]])
    different = 0
    for _ in range(8):
        depth = random.normal(size=(19, 4)).cumsum(axis=0)
        around = np.pad(depth, ((8, 8), (0, 0)), mode="symmetric")
        gathered = np.array([around[at : at + 17].mean(axis=0) for at in range(0, 19, 4)])
        score = (gathered - np.median(gathered)) / np.ptp(np.append(np.median(gathered), gathered.max()))

        def worth(path: tuple[int, ...], score: Array = score) -> float:
            moved = sum(((states[one] - states[other]) ** 2).sum() for one, other in pairwise(path))
            return float(sum(score[at, state] for at, state in enumerate(path)) - 0.03 * moved)

        best = max(product(range(4), repeat=5), key=worth)
        different += len(set(best)) > 1
        assert _likeliest(depth, states).tolist() == [best[at // 4] for at in range(19)]
    assert different > 3


def slanted(skew: float, width: float) -> Array:
    """Return a tape whose tracks lie so far apart, and each so far along from the one before."""
    light = np.full((361, 829), 200.0)
    for u in range(40):
        hole(light, u, 0, FEED)
        for v in TRACKS:
            if (7 * u + 3 * v * v) % 5 < 2:
                hole(light, u + skew * v * width, v * width, CODE)
    return light


@pytest.mark.parametrize(("skew", "width"), [(0, 1), (0.6, 1.65), (-0.6, 0.63), (0.2, 1.1)])
def test_a_sheet_is_found_by_the_holes_beside_its_row(skew: float, width: float) -> None:
    light = pictures(slanted(skew, width))
    u, v = (axis.ravel() for axis in np.meshgrid(np.arange(40.0), np.arange(-3.0, 6)))
    places = at(u + skew * v * width, v * width)
    assert np.hypot(*(_first(light, row(40)).place(u, v) - places).T).max() < 3
    assert np.hypot(*(by_holes(light, row(40)).place(u, v) - places).T).max() < 1.5
