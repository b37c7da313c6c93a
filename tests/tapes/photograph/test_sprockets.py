"""Rows of holes are found and followed: dots of known places and darkness, one beyond each limit."""

import numpy as np
import pytest

from tapes.photograph.pixels import Array
from tapes.photograph.sprockets import Sizes, follow, measured, rows, sizes, starts
from tapes.photograph.sprockets import _spots as spots
from tapes.photograph.sprockets import _straight as straight_rows
from tests.tapes.photograph.straight import FEED, PITCH, at, hole, pictures

S = "1" * 10
"""A start."""


def dots(places: Array, contrast: float | Array = 0.7, light: float = 200.0) -> Array:
    """Return a picture of paper with holes at places in pitches."""
    picture = np.full((500, 1000), light)
    for (u, v), part in zip(places, np.broadcast_to(contrast, len(places)), strict=True):
        hole(picture, u, v, FEED, light * (1 - part))
    return picture


def line(numbers: Array) -> Array:
    return np.stack([numbers, 0 * numbers], axis=1)


def test_a_picture_is_made_smaller_until_it_is_90_pixels() -> None:
    for shape, shapes in (
        ((182, 400), [(182, 400), (129, 283), (91, 200), (64, 141)]),
        ((180, 95), [(180, 95), (127, 67)]),
        ((90, 500), [(90, 500)]),
    ):
        assert [picture.shape for picture in sizes(np.zeros(shape, np.uint8)).pictures] == shapes


def test_of_the_sizes_that_is_taken_in_which_a_step_is_9_to_13_pixels() -> None:
    three = sizes(np.zeros((130, 260), np.uint8))
    assert len(three.pictures) == 3
    for step, number, scale in ((3, 0, 1), (12.7, 0, 1), (12.8, 1, 184 / 260), (18.1, 2, 0.5), (99, 2, 0.5)):
        picture, found = three.for_step(step)
        assert (picture is three.pictures[number], found) == (True, scale)


@pytest.mark.parametrize("step", [(24.0, 0.0), (17.0, 17.0), (-3.0, -24.0)])
@pytest.mark.parametrize("size", [1, 0.5])
def test_a_hole_is_measured_where_it_is_and_as_dark_as_it_is(step: tuple[float, float], size: float) -> None:
    """A blob beneath a Gaussian of .15, less what it darkens of a ring from .3 to .44."""
    y, x = np.mgrid[:300, :300] / size + (1 / size - 1) / 2
    middle, length = np.array([151.3, 148.8]), np.hypot(*step)
    for width, light, around in ((0.12, 200, 0.012), (0.2, 20, 0.182)):
        blob = np.exp(-((x - middle[0]) ** 2 + (y - middle[1]) ** 2) / 2 / (width * length) ** 2)
        picture = (light * (1 - blob)).astype(np.float32)
        scaled = Sizes([np.zeros((int(300 / size),) * 2, np.float32)] * (size < 1) + [picture] * 3)
        deep = (width**2 / (width**2 + 0.15**2) - around) * light / (light + 4)
        for off in ((0, 0), (5, -3), (-6, 7)):
            place, depth = measured(scaled, middle + off, np.array(step))
            assert np.hypot(*(place - middle)) < 0.02 * length
            assert off != (0, 0) or depth == pytest.approx(deep, abs=0.02)
    place, _ = measured(scaled, middle + 0.6 * np.array(step), np.array(step))
    assert np.hypot(*(place - middle)) > 0.14 * length, "no farther than .45"


@pytest.mark.parametrize(
    ("there", "seen"),
    [
        (S, S),
        ("1" + S + "111", "1" + S + "111"),
        (S + "001", S + "001"),
        ("1001" + S, "1001" + S),
        (S + "000111", S),
        (S + "0001111", S + "0001111"),
        (S + "0" * 12 + "1111", S + "0" * 12 + "1111"),
        (S + "0" * 13 + "1111", S),
        (S + "000" + "110" + "1111", S + "000000" + "1111"),
        (S + "000" + "111000000" + "1111", S + "000000000000" + "1111"),
        (S + "000" + "1110000000" + "1111", S),
        (S + "1111" + "000" + "1111" + "001", S + "1111" + "000" + "1111" + "001"),
    ],
)
def test_a_row_is_followed_over_gaps(there: str, seen: str) -> None:
    """Of two holes; or of twelve, if four holes follow it."""
    numbers = np.array([number for number, one in enumerate(there) if one == "1"], float)
    first = there.index(S)
    row = follow(pictures(dots(line(numbers))), at(np.arange(first, first + 10.0), np.array(0)))
    assert "".join("01"[int(one)] for one in row.seen) == seen
    assert row.places == pytest.approx(at(np.arange(float(len(seen))), np.array(0)), abs=0.1)


def test_a_row_is_followed_to_the_edge_of_the_picture_and_round_a_bend() -> None:
    row = follow(pictures(dots(line(np.arange(-15, 69.0)))), at(np.arange(10.0), np.array(0)))
    assert row.seen.tolist() == [True] * 84
    turns = np.arange(-14, 47) / 100
    bent = np.stack([100 * np.sin(turns), 100 - 100 * np.cos(turns)], axis=1)
    for gap in (set(), {30, 31, 32, 33, 34, 35}):
        there = np.array([number for number in range(61) if number not in gap])
        row = follow(pictures(dots(bent[there])), (bent[14:24] + 15) * PITCH)
        assert np.nonzero(row.seen)[0].tolist() == there.tolist()
        assert row.places[there] == pytest.approx((bent[there] + 15) * PITCH, abs=0.15)


@pytest.mark.parametrize(
    ("off", "contrast", "seen"),
    [
        ((0.31, 0), 0.7, True),
        ((0, -0.31), 0.7, True),
        ((0.33, 0), 0.7, False),
        ((0.24, 0.24), 0.7, False),
        ((0, 0), 0.7 * 0.36, True),
        ((0, 0), 0.7 * 0.34, False),
    ],
)
def test_the_next_hole_is_within_a_third_of_a_row_and_a_third_as_dark(
    off: tuple[float, float], contrast: float, seen: bool
) -> None:
    places = np.concatenate([line(np.arange(10.0)), [[10 + off[0], off[1]]]])
    row = follow(pictures(dots(places, np.array([0.7] * 10 + [contrast]))), at(np.arange(10.0), np.array(0)))
    assert len(row.seen) == 10 + seen


@pytest.mark.parametrize(("fading", "length"), [(0.9, 30), (0.8, 17)])
def test_a_row_may_fade(fading: float, length: int) -> None:
    """What is known of it is a fifth the last hole's: at .8 it is 1.25, 1.5, ..., 2.75, 3 of the next."""
    contrast = 0.9 * fading ** np.maximum(np.arange(30) - 9, 0)
    row = follow(pictures(dots(line(np.arange(30.0)), contrast)), at(np.arange(10.0), np.array(0)))
    assert len(row.seen) == length


@pytest.mark.parametrize(
    ("steps", "found"),
    [
        ([(4, 2)] * 9, 0),
        ([(4, 3)] * 9, 1),
        ([(0, 5)] * 9, 1),
        ([(7, -7)] * 9, 1),
        ([(-7, -7)] * 9, 1),
        ([(10, 3)] * 9, 1),
        ([(10, 4)] * 9, 0),
        ([(7.5, -7.5)] * 9, 0),
        ([(7, 0)] * 8, 0),
        ([(7, 0)] * 10, 2),
        ([(6, 0)] * 4 + [(7, 1)] + [(6, 0)] * 4, 1),
        ([(5, 0)] * 4 + [(6, 1)] + [(5, 0)] * 4, 0),
        ([(round(8 * 0.96**number), number // 2) for number in range(9)], 1),
    ],
)
def test_ten_spots_in_a_row_are_a_start(steps: list[tuple[float, float]], found: int) -> None:
    places = np.cumsum([(100, 100), *steps], axis=0)
    assert len(straight_rows(np.concatenate([places, [[0, 0], [250, 250]]]), (251, 251))) == found


def test_spots_are_as_deep_as_a_blurred_blob_is() -> None:
    """A blob of variance 4, in a difference of blurs of variances 1.1**2 and 2.1**2."""
    y, x = np.mgrid[:120, :120]
    blob = 20 * np.exp(-((x - 60) ** 2 + (y - 60) ** 2) / 8)
    light = 30 - blob
    places, depths = spots(light.astype(np.float32))
    around = 30 + 4 - blob.sum() / 41**2
    assert places[-1].tolist() == [60, 60]
    assert depths[-1] == pytest.approx(20 / around * (4 / (4 + 1.21) - 4 / (4 + 4.41)), rel=0.01)


def test_the_clearest_row_is_first_and_is_found_at_each_size() -> None:
    for step, most in ((2 / 3, 0.01), (2, 2.2)):
        clear, faint = (np.stack([np.arange(12.0) * step, 0 * np.arange(12) + v], axis=1) for v in (0, 20))
        picture = np.full((600, 1000), 200.0)
        for places, level in ((faint, 150), (clear, 100)):
            for u, v in places:
                hole(picture, u, v, FEED * step, level)
        found = starts(sizes(picture))
        away = [
            [abs(start[:, None] - (row + 15) * PITCH).max(axis=2).min(axis=1).max() for start in found]
            for row in (clear, faint)
        ]
        assert min(away[0]) <= most
        assert min(away[1]) <= most
        assert away[0][0] < 2 * PITCH


def test_rows_are_found_once_the_longest_first() -> None:
    places = [(u, v) for v, length in ((0, 11), (4, 16), (8, 9)) for u in range(length)]
    found = rows(sizes(dots(np.array(places))))
    assert [len(row.seen) for row in found] == [16, 11]
    beside = [(u, v) for v, length in ((0, 12), (0.9, 12)) for u in range(length)]
    assert len(rows(sizes(dots(np.array(beside))))) >= 2
