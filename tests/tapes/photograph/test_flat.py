"""A sheet as if it lay flat: what is where, at which size, and how dark, against what is computed by hand."""

from statistics import NormalDist

import numpy as np
import pytest

from tapes.photograph.flat import Flat, find_spots, flatten
from tapes.photograph.pixels import Array
from tapes.photograph.sheet import fit, holes_at
from tapes.photograph.sprockets import Sizes
from tests.tapes.photograph import straight


def test_a_sheet_lies_flat_from_the_rows_before_it_to_those_after() -> None:
    light = np.add.outer(np.arange(361.0) ** 2 / 400, np.arange(589.0) ** 2 / 900)
    flat = flatten(straight.pictures(light), straight.sheet(20), 4)
    assert flat.light == pytest.approx(light[132:229, 138:451], abs=0.1)
    columns, lines = flat.at(np.array([-3.5, 22.5]), np.array([-4, 4]))
    assert (columns.tolist(), lines.tolist()) == ([0, 312], [0, 96])


def test_between_samples_is_a_weighted_mean_and_beyond_them_the_last() -> None:
    picture = np.add.outer(np.arange(97.0), 100 * np.arange(313.0))
    flat = Flat(picture, picture, 4)
    places = [(0, 0, 4248), (0.45, -0.05, 4787.4), (-9, 0, 48), (99, 0, 31248), (0, -9, 4200), (0, 9, 4296)]
    for u, v, light in places:
        assert flat.take(picture, np.array(u), np.array(v)) == pytest.approx(light, abs=0.2)


def test_each_24_rows_are_taken_from_the_picture_in_which_a_pitch_is_9_to_13_pixels() -> None:
    """Rows are 9 pixels apart at first and 18 at last, tracks 11 and 22: as their geometric mean is."""
    u, v = (axis.ravel() for axis in np.meshgrid(np.arange(101.0), np.arange(-3.0, 6)))
    places = np.stack([9 * u + 0.045 * u**2, 300 + v * (11 + 0.11 * u)], axis=1)
    sizes = Sizes([np.full((600, 1400), 1, np.float32), np.full((424, 990), 2, np.float32)])
    light = flatten(sizes, fit(101, holes_at(u, v, places)), 4).light
    blocks = [9.95 * (1 + (24 * block + 8.5) / 100) for block in range(5)]
    assert np.rint(light[0, ::288]).tolist() == [1 + (step > 9 * 2**0.5) for step in blocks]
    assert np.nonzero(np.diff(np.rint(light[0])))[0].tolist() == [287]


def edge(at: float, width: float) -> Array:
    """Return how much of a blurred edge is reached at each column."""
    return np.array([NormalDist(at, width).cdf(x) for x in range(313)])


def test_how_dark_it_is_beside_the_brightest_within_a_pitch() -> None:
    """What is within .6 of a pitch of paper lies in its light, which is smoothed by half a pitch."""
    light = np.full((361, 589), 80.0)
    light[:, 300:] = 200
    flat = flatten(straight.pictures(light), straight.sheet(20), 4)
    smooth, paper = 80 + 120 * edge(161.5, 1.2), 80 + 120 * edge(161.5 - 7, np.hypot(6, 1.2))
    assert flat.dark[48] == pytest.approx(1 - smooth / (paper + 2), abs=0.01)
    hole = np.full((361, 589), 200.0)
    hole[180:, 300:] = 0  # a corner: beside an ellipse, not a square
    dark = flatten(straight.pictures(hole), straight.sheet(20), 4).dark
    assert dark[48 + 5, 162 + 5] > 0.9


def test_spots_are_beside_what_is_around_them() -> None:
    dark = np.zeros((160, 313), np.float32)
    dark[:, 162:] = 1
    assert find_spots(dark)[80] == pytest.approx(edge(161.5, 0.84) - edge(161.5, 3.6), abs=0.015)
