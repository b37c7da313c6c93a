"""FORMAT fields, the header, and the two tapes that are written down in full."""

from fractions import Fraction

import pytest

from programs import drill
from programs.arithmetic import ARITHMETICS
from programs.format import Format, Overflow
from programs.printout import Printout
from tapes.errors import WorkError
from tapes.hydrapoint import Block, block


@pytest.mark.parametrize(
    ("fields", "values", "line"),
    [
        ("I3", [7], "  7"),
        ("I3,I1", [76, 6], " 766"),
        ("1X,I5,I4,I5,I4", [1019, 0, 0, 2], "  1019   0    0   2"),
        ("I5", [-12], "  -12"),
        ("I5", [4133.0], " 4133"),
        ("2X,I2", [5], "   5"),
    ],
)
def test_a_line_as_format_has_it(fields: str, values: list[float], line: str) -> None:
    assert Format(fields).line(*values) == line + "\n"


@pytest.mark.parametrize(("overflow", "line"), [("low-digits", "00023456\n"), ("stars", "***23456\n")])
def test_a_number_too_wide(overflow: Overflow, line: str) -> None:
    assert Format("I3,I5").line(1000, 23456, overflow=overflow) == line


@pytest.mark.parametrize(("value", "printed"), [(2.9, "  2"), (-2.9, " -2"), (0.9999, "  0"), (99.5, " 99")])
def test_an_i_field_takes_the_whole_part_of_a_real(value: float, printed: str) -> None:
    for real in (Fraction(str(value)), *(arithmetic.real(value) for arithmetic in ARITHMETICS.values())):
        assert Format("I3").line(real) == f"{printed}\n"


def test_a_block_by_the_digits_of_its_groups() -> None:
    printout = Printout()
    printout.print_10(Block(76, 0, 19234, 4321, 0, 31, 88))
    assert printout.text == " 760192340432103188\n"


def test_the_drilling_tape_is_chapter_3s() -> None:
    assert drill.part().splitlines() == [
        "0010000000000003588",
        "0029030000350000189",
        "0035010000100000189",
        "0045010000200000189",
        "0055040000200000189",
        "0065040000100000189",
    ]
    assert block(drill.part().splitlines()[3]).y == 2000


def test_a_hole_off_the_table_is_refused_with_its_block() -> None:
    with pytest.raises(WorkError, match=r"block 004: Y 10\.001"):
        drill.part(holes=((1, 1), (2, 10.001)))
