"""Where a tape lies in a picture, against what is computed by hand: splines, a flat and a slanted sheet."""

import numpy as np
import pytest

from tapes.photograph.holes import grid
from tapes.photograph.pixels import Array
from tapes.photograph.sheet import Spline, fit, holes_at

LENGTH = 60
U, V = (axis.ravel() for axis in np.meshgrid(np.arange(float(LENGTH)), np.arange(-3.0, 6)))


def seen(u: Array, v: Array) -> Array:
    """Return where a slanted plane has its rows and tracks: a projection, 12 pixels a row and more."""
    depth = 1 + 0.002 * u + 0.01 * v
    return np.stack([(100 + 12 * u - 2 * v) / depth, (200 + 1.5 * u + 14 * v) / depth], axis=-1)


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


def test_pitches_are_those_of_the_farther_side() -> None:
    """The picture of a slanted plane, and the same from its other side."""
    for side in (1, -1):
        sheet = fit(LENGTH, holes_at(U, V, seen(U, side * V)))
        sheet = fit(LENGTH, holes_at(U, V, seen(U, side * V)), sheet)
        u = np.arange(float(LENGTH))
        far = np.full_like(u, 3.92)
        steps = (seen(u + 0.5, far) - seen(u - 0.5, far), seen(u, far + 0.5) - seen(u, far - 0.5))
        assert sheet.pitches()[0] == pytest.approx(np.hypot(*steps[0].T), rel=0.01)
        assert sheet.pitches()[1] == pytest.approx(np.hypot(*steps[1].T), rel=0.02)


def test_a_sheet_is_as_stiff_as_it_is_short() -> None:
    """A piece of a spline every six rows; of what crosses the tape every `knots` rows, at least one."""
    points = holes_at(U, V, np.stack([U, V], axis=1))
    assert [fit(60, points, None, knots).soft.pieces for knots in (60, 10)] == [10, 10]
    assert [fit(60, points, None, knots).stiff.pieces for knots in (200, 60, 30, 10)] == [1, 1, 2, 6]


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
    flat = fit(LENGTH, holes_at(U, V, np.stack([10 * U, 50 + 12 * V], axis=1)))
    alone = [((u,), v, True) for u in (-0.95, 59.95) for v in (-5.45, 7.45)]
    alone += [((u,), 0.0, False) for u in (-1.05, 60.05)] + [((30.0,), v, False) for v in (-5.55, 7.55)]
    several = [((0, 30, 59), True), ((30, 99, 99, 99), True), ((30, 99, 99, 99, 99), False)]
    for u, v, covered in (*alone, *((number, 0, covers) for number, covers in several)):
        places = np.stack(np.broadcast_arrays(10 * np.array(u), np.array(50 + 12 * v)), axis=1)
        assert flat.covers(places) is covered
