"""The GE-635's registers bit by bit: numbers chosen so that each rule alone makes the difference.

The expected values are worked out here with whole numbers, from the manual's words (CPB-1004).
"""

from fractions import Fraction

import pytest

from programs.arithmetic import CDC6400, GE635, IEEE32, Float

GE, CDC, IEEE = GE635(), CDC6400(), IEEE32()


def ge(mantissa: int, exponent: int = 0) -> Float:
    return Float(GE, mantissa, exponent)


@pytest.mark.parametrize(
    ("value", "stored"),
    [
        (2**27 - 1, 2**27 - 1),  # 27 bits
        (2**27 + 1, 2**27),  # 28 bits
        (2**28 + 7, 2**28 + 4),
        (-(2**27), -(2**27)),  # in two's complement 27 bits
        (-(2**27) - 1, -(2**27) - 2),  # cut towards minus infinity
    ],
)
def test_a_word_keeps_27_bits(value: int, stored: int) -> None:
    assert GE.store(ge(value)).exactly == stored


def test_a_quotient_keeps_35_bits_of_its_magnitude() -> None:
    assert GE.divide(ge(3), ge(5)).exactly == Fraction(3 * 2**35 // 5, 2**35)
    third = Fraction(2**36 // 3, 2**36)
    assert GE.divide(ge(1), ge(3)).exactly == third
    assert GE.divide(ge(-1), ge(3)).exactly == -third


def test_the_register_has_71_bits() -> None:
    assert GE.add(ge(2**70), ge(1)).exactly == 2**70 + 1
    assert GE.add(ge(1, 71), ge(1)).exactly == 2**71


def test_fad_loses_what_is_shifted_past_aq() -> None:
    """2**71 - 1 has 71 bits; but -1 is aligned to the exponent of 2**71 first, and cut downwards."""
    assert GE.add(ge(1, 71), ge(-1)).exactly == 2**71 - 2


@pytest.mark.parametrize("machine", [GE, CDC])
def test_nothing_is_lost_beside_a_zero(machine: GE635 | CDC6400) -> None:
    """Whatever exponent the zero has."""
    zero, one = Float(machine, 0, 99), Float(machine, 1, 0)
    assert machine.add(zero, one).exactly == machine.add(one, zero).exactly == 1


def test_fmp_cuts_before_it_normalises() -> None:
    """1.0 times a number of 71 bits: the product as it stands begins with a zero."""
    assert GE.multiply(ge(2**70 + 1), ge(1)).exactly == 2**70


def test_sqrt_is_rounded_from_a_word() -> None:
    """The root of 2 is 94906265.6 times 2**-26; 2**54 - 1 is a word less than 2**54 when it is stored."""
    assert GE.sqrt(ge(2)).exactly == Fraction(94906266, 2**26)
    assert GE.sqrt(ge(2**54 - 1)).exactly == 2**27 - 1


def test_an_operand_that_is_an_expression_was_stored() -> None:
    """1 + 1/3, a quotient of 35 bits: 27 of them come from memory."""
    assert (ge(1) + GE.divide(ge(1), ge(3))).exactly == 1 + Fraction(2**28 // 3, 2**28)


def test_the_cdc_keeps_the_upper_half_before_it_normalises() -> None:
    small = Float(CDC, -1, -50)
    assert CDC.add(Float(CDC, 1, 0), small).exactly == 1 - Fraction(1, 2**47)


@pytest.mark.parametrize(
    ("value", "rounded"), [(2**24 + 1, 2**24), (2**24 + 3, 2**24 + 4), (2**25 + 2, 2**25)]
)
def test_ieee_rounds_a_half_to_even(value: int, rounded: int) -> None:
    assert IEEE.store(Float(IEEE, value, 0)).exactly == rounded
