"""The Hydra-Point's format and tables, against the thesis's text and the shape of such tables."""

from itertools import pairwise

import pytest

from tapes.hydrapoint import (
    MISCELLANEOUS,
    PREPARATORY,
    SPINDLE,
    TOOL_FUNCTION,
    XY_FEED,
    Z_FEED,
    Block,
    block,
    corner,
)


def test_a_block_is_told_apart_by_position() -> None:
    """Chapter 3's second block: read Z, feed point 3.000, final depth 3.500, code 01, Z feed."""
    assert block("0029030000350000189") == Block(2, 9, 3000, 3500, 0, 1, 89)
    assert block(b"0076022500413300185") == Block(7, 6, 2250, 4133, 0, 1, 85)


@pytest.mark.parametrize("digits", ["0029030000350000189", "9999999999999999999", "0" * 19])
def test_a_block_gives_back_its_digits(digits: str) -> None:
    assert block(digits).digits == digits


def test_the_codes_are_those_of_table_2_3() -> None:
    assert sorted(PREPARATORY) == [0, 1, 4, 5, 6, 7, 8, 9]
    assert sorted(MISCELLANEOUS) == [0, 2, 6, 7, 8, 9, 80, 81, 82, 83, 84, 85, 86, 88, 89]


def test_table_2_4_agrees_with_the_text() -> None:
    """Chapter 3: 18 discrete feeds, 1 in/min the slowest, ratios 1.9/1.0 and 4.0/2.7; 35 is 3100 rpm."""
    assert len(XY_FEED) == len(Z_FEED) == 18
    assert XY_FEED[1] == Z_FEED[1] == 1.0
    assert XY_FEED[2] / XY_FEED[1] == 1.9
    assert round(XY_FEED[4] / XY_FEED[3], 2) == 1.48
    assert SPINDLE[35] == 3100
    assert max(Z_FEED.values()) == 64
    assert 1730 < SPINDLE[31] == 2000


def test_table_2_4_climbs_without_a_jump() -> None:
    """A misread digit would show: every column climbs, and its steps get no larger in proportion."""
    columns: list[list[float]] = [
        [rates.xy_feed for rates in TOOL_FUNCTION.values()],
        [rates.z_feed for rates in TOOL_FUNCTION.values()],
        [SPINDLE[code] for code in sorted(SPINDLE)],
    ]
    for column in columns:
        ratios = [after / before for before, after in pairwise(column)]
        assert all(1 < ratio < 2.2 for ratio in ratios), ratios
        assert all(ratio <= 1.25 for ratio in ratios[6:]), ratios


def test_spindle_codes_leave_out_19_and_20() -> None:
    assert sorted(SPINDLE) == [*range(1, 19), *range(21, 39)]


@pytest.mark.parametrize(
    ("stop", "speeds", "expected"),
    [
        ((17321, 10000), (1.9, 1.0), (17321, 17321 / 1.9)),
        ((17321, 10000), (2.7, 1.0), (17321, 17321 / 2.7)),
        ((-100, 300), (1.0, 1.0), (-100, 100)),
        ((100, -100), (1.0, 1.0), (100, -100)),
        ((100, 0), (1.0, 1.0), (0, 0)),
        ((0, 100), (0.0, 1.0), (0, 0)),
    ],
)
def test_the_first_axis_to_arrive_leaves_the_other_alone(
    stop: tuple[float, float], speeds: tuple[float, float], expected: tuple[float, float]
) -> None:
    """Figure 3.1: a slope of 30 degrees with the ratio 1.9 or 2.7 of feeds."""
    assert corner((0, 0), stop, *speeds) == pytest.approx(expected)
