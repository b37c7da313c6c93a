"""The Hydra-Point's format and tables, transcribed once more from the thesis."""

from fractions import Fraction

import pytest

from tapes import hydrapoint
from tapes.errors import TextError
from tapes.hydrapoint import Block, block, corner
from tests.reference import hydrapoint as second


def test_a_block_is_told_apart_by_position() -> None:
    """Chapter 3's second block: read Z, feed point 3.000, final depth 3.500, code 01, Z feed."""
    assert block("0029030000350000189") == Block(2, 9, 3000, 3500, 0, 1, 89)
    assert block(b"1234567891123456789") == Block(123, 4, 56789, 11234, 5, 67, 89)
    assert block("0029030000350000189").digits == "0029030000350000189"


TABLE_2_3 = """\
0 position
1 tap, feed control
4 peck
5 drill
6 mill
7 bore
8 tap, pitch control
9 read Z
00 program stop
02 end of program
06 tool change, manual
07 flood coolant on
08 mist coolant on
09 coolant off
80 no change
81 partial retract on
82 partial retract off
83 index work piece
84 X feed rate
85 Y feed rate
86 tool change, automatic
88 spindle speed change
89 Z feed rate"""


def test_table_2_3() -> None:
    ours = [f"{code:01} {name}" for code, name in hydrapoint.PREPARATORY.items()]
    ours += [f"{code:02} {name}" for code, name in hydrapoint.MISCELLANEOUS.items()]
    assert ours == TABLE_2_3.splitlines()


def test_table_2_4() -> None:
    """Line by line, as the second Hydra-Point has it."""
    assert {code: Fraction(str(feed)) for code, feed in hydrapoint.XY_FEED.items()} == second.XY_FEEDS
    assert {code: Fraction(str(feed)) for code, feed in hydrapoint.Z_FEED.items()} == second.Z_FEEDS
    assert second.SPEEDS == hydrapoint.SPINDLE


def test_the_specification() -> None:
    """Chapter 2: travels, positioning speed, tolerance of feeds, resolution, tools, rows of a block."""
    assert (hydrapoint.X_TRAVEL, hydrapoint.Y_TRAVEL, hydrapoint.Z_TRAVEL) == (20000, 10000, 5000)
    assert (hydrapoint.POSITIONING_SPEED, hydrapoint.FEED_TOLERANCE) == (300, 0.2)
    assert [hydrapoint.RESOLUTION, *hydrapoint.CAROUSEL] == [0.001, *range(1, 25)]
    assert dict(zip(Block._fields, (3, 1, 5, 5, 1, 2, 2), strict=True)) == hydrapoint.FIELDS
    assert hydrapoint.ROWS == sum(hydrapoint.FIELDS.values()) + 1 == 20
    assert hydrapoint.COOLANT == second.COOLANT
    assert sorted(hydrapoint.HOLE_MAKING) == sorted(second.HOLES)
    assert [*sorted(hydrapoint.STOPS), hydrapoint.NEXT_TOOL] == [*sorted(second.STOPS), 0]


@pytest.mark.parametrize(
    ("stop", "speeds", "expected"),
    [
        ((17321, 10000), (1.9, 1.0), (17321, 17321 / 1.9)),
        ((-100, 300), (1.0, 1.0), (-100, 100)),
        ((-300, -100), (1.0, 2.0), (-50, -100)),
        ((100, 0), (1.0, 1.0), (0, 0)),
        ((0, 100), (0.0, 1.0), (0, 0)),
    ],
)
def test_the_first_axis_to_arrive_leaves_the_other_alone(
    stop: tuple[float, float], speeds: tuple[float, float], expected: tuple[float, float]
) -> None:
    """Figure 3.1: a slope of 30 degrees with the ratio 1.9 or 2.7 of feeds."""
    x, y = corner((2000, -500), (stop[0] + 2000, stop[1] - 500), *speeds)
    assert (x - 2000, y + 500) == pytest.approx(expected)
    assert corner((0, 0), (1, -1), 49.0, 49.0) == (1, -1), "1 / 49 * 49 is less than 1"


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("1\t9\t1000\t2000\t0\t5\t89\n", "column 1: sequence 1 in a block; it has 3 digits: type 001"),
        ("001;9;1,5;02000;0;05;89\n", "column 7: x 1,5 in a block; type thousandths of an inch, 01500"),
        ("001,9,010000,02000,0,05,89\n", "column 7: x 010000 in a block; it has 5 digits"),
        ("001,9,01000,-0.5,0,05,89\n", "column 13: y -0.5 in a block; no length is below 0"),
        ("001\t9\t01000\t02000\t0\t05\t89\n", "column 4: a tab in a block"),
    ],
)
def test_a_spreadsheets_program(text: str, said: str) -> None:
    with pytest.raises(TextError, match=f"line 1, {said}"):
        hydrapoint.typed(text)


def test_other_columns_are_no_program() -> None:
    assert hydrapoint.typed("1,2,3,4,5,6,7\n1.5,2,3,4,5,6,70\n") is None


def test_more_than_half_of_the_lines_of_a_program_are_blocks() -> None:
    block = "0010000000000003588\n"
    assert hydrapoint.typed(f"{block}XY\n") is None
    with pytest.raises(TextError, match="'XY' is no block"):
        hydrapoint.typed(f"{block}{block}XY\n")
