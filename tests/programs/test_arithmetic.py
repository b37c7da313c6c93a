"""Each arithmetic against its rules, IEEE against numpy, and the nine blocks of the ellipse."""

from collections.abc import Callable
from fractions import Fraction
from functools import cache

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from programs import circle, ellipse
from programs.arithmetic import ARITHMETICS, CDC6400, GE635, IEEE32, Exact, Float

GE, IEEE, CDC = GE635(), IEEE32(), CDC6400()

wholes = st.integers(-(2**20), 2**20)
ratios = st.tuples(wholes, st.integers(1, 2**20))


PARTS: dict[str, Callable[..., str]] = {"circle": circle.part, "ellipse": ellipse.part}


@cache
def exactly(part: str) -> str:
    return PARTS[part]()


def differing(part: str, arithmetic: str) -> list[int]:
    exact = exactly(part)
    other = PARTS[part](arithmetic=ARITHMETICS[arithmetic])
    assert exact.count("\n") == other.count("\n")
    pairs = zip(exact.splitlines(), other.splitlines(), strict=True)
    return [number for number, (one, two) in enumerate(pairs, 1) if one != two]


@pytest.mark.parametrize("arithmetic", ["ge635", "cdc6400"])
def test_truncation_moves_nine_blocks_of_the_ellipse(arithmetic: str) -> None:
    assert differing("ellipse", arithmetic) == list(range(587, 596))
    block = ellipse.part(arithmetic=ARITHMETICS[arithmetic]).splitlines()[586]
    assert block == "5876 6404 2646  585"


def test_rounding_moves_none() -> None:
    assert differing("ellipse", "ieee32") == []


@pytest.mark.parametrize("arithmetic", ["ge635", "ieee32", "cdc6400"])
def test_the_circle_is_the_same_in_all(arithmetic: str) -> None:
    assert differing("circle", arithmetic) == []


def test_a_ge635_that_rounds_its_stores_moves_none() -> None:
    """So the question of 1971 is truncate or round, not how long the words were."""

    class Rounding(GE635):
        """The GE-635 with FSTR in place of FST."""

        def store(self, value: Float) -> Float:
            dropped = max(0, value.mantissa.bit_length() - self.word)
            half = 1 << dropped >> 1
            return Float(self, (value.mantissa + half) >> dropped, value.exponent + dropped)

    assert ellipse.part(arithmetic=Rounding()) == exactly("ellipse")


def test_a_twenty_four_bit_truncating_machine_makes_978_blocks() -> None:
    class Short(CDC6400):
        """A truncating machine of 24 bits, of which it is known that it breaks elsewhere too."""

        word = register = quotient = 24

        def add(self, a: Float, b: Float) -> Float:
            return super(CDC6400, self).add(a, b)

    assert ellipse.part(arithmetic=Short()).count("\n") == 978 + 6


def test_one_is_less_than_one_where_quotients_are_cut() -> None:
    def one(machine: GE635 | IEEE32 | CDC6400) -> Fraction:
        real = machine.real
        total = real(2404) ** 2 / real(3005) ** 2 + real(1353) ** 2 / real(2255) ** 2
        return machine.store(total).exactly

    assert one(IEEE) == 1
    assert one(GE) == 1 - Fraction(1, 2**27)
    assert one(CDC) == 1 - Fraction(1, 2**48)


def test_the_cdc_loses_what_is_shifted_past_the_upper_half() -> None:
    one = CDC.real(1)
    below = Float(CDC, 2**48 - 1, -48)
    assert below.exactly == 1 - Fraction(1, 2**48)
    assert (one - below).exactly == 0


def test_the_cdc_cuts_towards_zero() -> None:
    assert (CDC.real(-1) / CDC.real(3)).exactly == -Fraction(2**49 // 3, 2**49)


@given(wholes, wholes)
def test_ieee_sums_products_and_roots_are_numpys(a: int, b: int) -> None:
    x, y = np.float32(a), np.float32(b)
    p, q = IEEE.real(a), IEEE.real(b)
    assert (p + q).exactly == Fraction(float(x + y))
    assert (p - q).exactly == Fraction(float(x - y))
    assert (p * q).exactly == Fraction(float(x * y))
    assert IEEE.sqrt(IEEE.real(abs(a))).exactly == Fraction(float(np.sqrt(np.float32(abs(a)))))


@given(ratios, ratios)
def test_ieee_quotients_are_numpys(a: tuple[int, int], b: tuple[int, int]) -> None:
    x, y = np.float32(a[0]) / np.float32(a[1]), np.float32(b[0]) / np.float32(b[1])
    p, q = IEEE.real(a[0]) / IEEE.real(a[1]), IEEE.real(b[0]) / IEEE.real(b[1])
    assert p.exactly == Fraction(float(x))
    assert (p + q).exactly == Fraction(float(x + y))
    assert (p * q).exactly == Fraction(float(x * y))


@given(ratios, ratios, st.sampled_from([GE, CDC]))
def test_a_truncated_result_is_never_larger_and_less_than_a_unit_off(
    a: tuple[int, int], b: tuple[int, int], machine: GE635 | CDC6400
) -> None:
    x, y = machine.store(machine.real(abs(a[0])) / machine.real(a[1])), machine.real(b[1])
    for ours, exact in ((x + y, x.exactly + y.exactly), (x * y, x.exactly * y.exactly)):
        kept = machine.store(ours).exactly
        assert kept <= exact
        assert exact - kept <= exact / 2 ** (machine.word - 1)


@pytest.mark.parametrize("name", ARITHMETICS)
def test_the_root_of_every_perfect_square_is_exact(name: str) -> None:
    machine = ARITHMETICS[name]
    for root in range(3000):
        assert int(machine.sqrt(machine.real(root * root))) == root


def test_an_irrational_root_is_within_its_cut() -> None:
    for number in (Fraction(2), Fraction(2, 3)):
        root = Exact().sqrt(number)
        assert root**2 < number < (root + Fraction(1, 2**63)) ** 2
    assert Exact().sqrt(Fraction(9, 25)) == Fraction(3, 5)


def test_a_constant_is_what_its_digits_say() -> None:
    assert Exact().real(0.2) == Fraction(1, 5)
    assert IEEE.real(0.2).exactly == Fraction(float(np.float32(0.2)))
