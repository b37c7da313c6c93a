"""Where a tape lies in a picture, against what is computed by hand: splines, a flat and a slanted sheet."""

import pytest

pytest.importorskip("cv2", reason="OpenCV is not installed")

import numpy as np

from tapes.photograph.holes import grid
from tapes.photograph.pixels import Array, vertex
from tapes.photograph.sheet import Sheet, Spline, fit, holes_at

LENGTH = 60
U, V = (axis.ravel() for axis in np.meshgrid(np.arange(float(LENGTH)), np.arange(-3.0, 6)))


def seen(u: Array, v: Array) -> Array:
    """Return where a slanted plane has its rows and tracks: a projection, 12 pixels a row and more."""
    depth = 1 + 0.002 * u + 0.01 * v
    return np.stack([(100 + 12 * u - 2 * v) / depth, (200 + 1.5 * u + 14 * v) / depth], axis=-1)


def flat() -> Sheet:
    return fit(LENGTH, holes_at(U, V, np.stack([10 * U, 50 + 12 * V], axis=1)))


def test_splines_are_those_of_the_book() -> None:
    """They add up to one, coefficients on a line make a line, at a knot they are 1, 4, 1 sixths."""
    spline, rows = Spline(61, 10), np.arange(61.0)
    weights = spline.at(rows)
    assert weights.sum(axis=1) == pytest.approx(np.ones(61))
    assert weights @ (np.arange(13.0) - 1) == pytest.approx(rows / 6)
    assert weights[[0, 6, 60]] @ np.eye(13) == pytest.approx(
        np.array([[1, 4, 1] + [0] * 10, [0, 1, 4, 1] + [0] * 9, [0] * 10 + [1, 4, 1]]) / 6
    )
    assert spline.bends() @ np.arange(13.0) ** 2 == pytest.approx(np.full(11, 2))
    assert Spline(1, 1).at(np.zeros(1)) == pytest.approx(np.array([[1, 4, 1, 0]]) / 6)


def test_a_flat_sheet_is_where_its_holes_are() -> None:
    u, v = np.array([-0.5, 0, 30.25, 59]), np.array([-3.9, 0, 2.5, 6])
    assert flat().place(u, v) == pytest.approx(np.stack([10 * u, 50 + 12 * v], axis=1), abs=0.01)
    along, across = flat().pitches()
    assert along == pytest.approx(np.full(LENGTH, 10), abs=0.01)
    assert across == pytest.approx(np.full(LENGTH, 12), abs=0.01)


def test_a_slanted_sheet_is_found_from_its_holes() -> None:
    holes = holes_at(U, V, seen(U, V))
    first = fit(LENGTH, holes)
    again = fit(LENGTH, holes, fit(LENGTH, holes, first))
    places = seen(U + 0.5, V)
    assert abs(first.place(U + 0.5, V) - places).max() > 1, "without narrowing"
    assert abs(again.place(U + 0.5, V) - places).max() < 0.1
    wide = fit(LENGTH, grid(again, width=0.5))
    assert wide.place(U, 2 + 0 * V) == pytest.approx(again.place(U, 1 + 0 * V), abs=1)


def test_a_sheet_covers_what_lies_beneath_it() -> None:
    for u, v, covered in (
        ((0, 30, 59), 0, True),
        ((-0.9, 59.9), (-5.4, 7.4), True),
        ((-1.1, 60.1), 0, False),
        ((30, 30), (-5.6, 7.6), False),
        ((30, 99, 99, 99, 99), 0, False),  # no more than a fifth
        ((30, 99, 99, 99), 0, True),
    ):
        places = np.stack(np.broadcast_arrays(10 * np.array(u), 50 + 12 * np.array(v)), axis=1)
        assert flat().covers(places) is covered


def test_the_top_between_three_places_is_a_parabolas() -> None:
    tops = np.linspace(-0.5, 0.5, 11)
    before, top, after = (5 - 3 * (step - tops) ** 2 for step in (-1, 0, 1))
    assert vertex(before, top, after) == pytest.approx(tops)
    level, higher = np.zeros(1), np.ones(1)
    assert vertex(level, level, level) == 0
    assert vertex(level, level, higher) == 0, "no top"
    assert vertex(level, 1.1 * higher, 2 * higher) == 0.5, "no farther than half way"
