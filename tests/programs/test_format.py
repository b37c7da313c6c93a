"""FORMAT fields, the header, and the two tapes that are written down in full."""

from fractions import Fraction

import pytest

from programs import drill
from programs.arithmetic import ARITHMETICS
from programs.format import Format, Overflow
from programs.printout import Printout
from tapes.hydrapoint import Block
from tests.nc.tapes_1971 import FOUR_HOLES


@pytest.mark.parametrize(
    ("fields", "values", "overflow", "line"),
    [
        ("1X,I5,I4,I5,I4", [1019, 0, 0, 2], "low-digits", "  1019   0    0   2"),
        ("I5", [-12], "low-digits", "  -12"),
        ("2X,I2", [5], "low-digits", "   5"),
        ("I3,I5", [1000, 23456], "low-digits", "00023456"),
        ("I3,I5", [1000, 23456], "stars", "***23456"),
    ],
)
def test_a_line_as_format_has_it(fields: str, values: list[int], overflow: Overflow, line: str) -> None:
    assert Format(fields).line(*values, overflow=overflow) == f"{line}\n"


def test_an_i_field_takes_the_whole_part_of_a_real() -> None:
    for value, printed in ((2.9, "  2"), (-2.9, " -2"), (0.9999, "  0"), (99.5, " 99")):
        for real in (Fraction(str(value)), *(machine.real(value) for machine in ARITHMETICS.values())):
            assert Format("I3").line(real) == f"{printed}\n"


def test_a_block_by_the_digits_of_its_groups() -> None:
    printout = Printout()
    printout.print_10(Block(76, 0, 19234, 4321, 0, 31, 88))
    assert printout.text == " 760192340432103188\n"


def test_the_drilling_tape_is_chapter_3s() -> None:
    assert drill.part().splitlines() == [digits.replace(" ", "") for digits in FOUR_HOLES]
