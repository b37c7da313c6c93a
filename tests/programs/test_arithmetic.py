"""Each arithmetic by its rules, from the manuals' words (CPB-1004), or numpy's. The ellipse's nine blocks."""

from fractions import Fraction
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from programs import circle, ellipse
from programs.arithmetic import ARITHMETICS, CDC6400, GE635, IEEE32, PDP8, Exact, Float
from tests.conftest import case
from tests.programs import dec_float

GE, IEEE, CDC, DEC = GE635(), IEEE32(), CDC6400(), PDP8()
ratios = st.tuples(st.integers(-(2**20), 2**20), st.integers(1, 2**20))


def ge(mantissa: int, exponent: int = 0) -> Float:
    return Float(GE, mantissa, exponent)


def test_each_rule_of_the_registers() -> None:
    """Numbers chosen so that one rule alone makes the difference."""
    one, zero, below, tiny = CDC.real(1), Float(CDC, 0, 99), Float(CDC, 2**48 - 1, -48), Float(CDC, -1, -50)
    for rule, ours, exactly in (
        ("FST keeps 27 bits", GE.store(ge(2**27 - 1)), 2**27 - 1),
        ("FST cuts the 28th", GE.store(ge(2**27 + 1)), 2**27),
        ("FST cuts more", GE.store(ge(2**28 + 7)), 2**28 + 4),
        ("-2**27 has 27 bits in two's complement", GE.store(ge(-(2**27))), -(2**27)),
        ("FST cuts towards minus infinity", GE.store(ge(-(2**27) - 1)), -(2**27) - 2),
        ("FDV keeps 35 bits", GE.divide(ge(3), ge(5)), Fraction(3 * 2**35 // 5, 2**35)),
        ("FDV keeps 35 bits of 36", GE.divide(ge(1), ge(3)), Fraction(2**36 // 3, 2**36)),
        ("FDV cuts a magnitude", GE.divide(ge(-1), ge(3)), -Fraction(2**36 // 3, 2**36)),
        ("EAQ has 71 bits", GE.add(ge(2**70), ge(1)), 2**70 + 1),
        ("EAQ has no more", GE.add(ge(1, 71), ge(1)), 2**71),
        ("FAD aligns to 2**71, past the end of AQ", GE.add(ge(1, 71), ge(-1)), 2**71 - 2),
        ("FAD of a zero", GE.add(ge(0, 99), ge(1)), 1),
        ("FAD with a zero", GE.add(ge(1), ge(0, 99)), 1),
        ("FMP cuts before it normalises", GE.multiply(ge(2**70 + 1), ge(1)), 2**70),
        ("SQRT is rounded: 94906265.6", GE.sqrt(ge(2)), Fraction(94906266, 2**26)),
        ("SQRT is of a word: 2**54 - 1 is less when it is stored", GE.sqrt(ge(2**54 - 1)), 2**27 - 1),
        ("a right operand is stored", ge(1) + GE.divide(ge(1), ge(3)), 1 + Fraction(2**28 // 3, 2**28)),
        ("FX keeps the upper half, then normalises", CDC.add(one, tiny), 1 - Fraction(1, 2**47)),
        ("FX loses what is shifted past it", one - below, 0),
        ("FX keeps 48 bits", CDC.add(Float(CDC, 2**48 - 1, 0), Float(CDC, 2**48 - 2, 0)), 2**49 - 4),
        ("FX of a zero", CDC.add(zero, one), 1),
        ("FX with a zero", CDC.add(one, zero), 1),
        ("the CDC cuts towards zero", CDC.real(-1) / CDC.real(3), -Fraction(2**49 // 3, 2**49)),
        ("IEEE: a half goes down to even", IEEE.store(Float(IEEE, 2**24 + 1, 0)), 2**24),
        ("IEEE: a half goes up to even", IEEE.store(Float(IEEE, 2**24 + 3, 0)), 2**24 + 4),
        ("IEEE: half of a place more", IEEE.store(Float(IEEE, 2**25 + 2, 0)), 2**25),
        ("a constant is its digits", IEEE.real(0.2), Fraction(float(np.float32(0.2)))),
    ):
        with case(rule):
            assert ours.exactly == exactly
    assert Exact().real(0.2) == Fraction(1, 5)


@given(ratios, ratios)
def test_ieee_is_numpys(a: tuple[int, int], b: tuple[int, int]) -> None:
    x, y = np.float32(a[0]) / np.float32(a[1]), np.float32(b[0]) / np.float32(b[1])
    p, q = IEEE.real(a[0]) / IEEE.real(a[1]), IEEE.real(b[0]) / IEEE.real(b[1])
    for ours, numpys in ((p, x), (p + q, x + y), (p - q, x - y), (p * q, x * y)):
        assert ours.exactly == Fraction(float(numpys))
    assert IEEE.sqrt(IEEE.real(abs(a[0]))).exactly == Fraction(float(np.sqrt(np.float32(abs(a[0])))))


@pytest.mark.parametrize("name", ARITHMETICS)
def test_the_root_of_every_perfect_square_is_exact(name: str) -> None:
    machine = ARITHMETICS[name]
    for root in range(3000):
        assert int(machine.sqrt(machine.real(root * root))) == root


def test_an_irrational_root_is_within_its_cut() -> None:
    for number in (Fraction(2), Fraction(1, 2), Fraction(2, 3)):
        root = Exact().sqrt(number)
        assert root**2 < number < (root + Fraction(1, 2**63)) ** 2
    assert Exact().sqrt(Fraction(9, 25)) == Fraction(3, 5)


class Rounding(GE635):
    """The GE-635 with FSTR in place of FST."""

    def store(self, value: Float) -> Float:
        dropped = max(0, value.mantissa.bit_length() - self.word)
        return Float(self, (value.mantissa + (1 << dropped >> 1)) >> dropped, value.exponent + dropped)


@pytest.mark.slow("the ellipse in six arithmetics")
def test_truncation_moves_nine_blocks_of_the_ellipse() -> None:
    """So the question of 1971 is truncate or round, not how long the words were."""
    exact, truncated = ellipse.part().splitlines(), ellipse.part(arithmetic=GE).splitlines()
    pairs = enumerate(zip(exact, truncated, strict=True), 1)
    assert [number for number, (one, two) in pairs if one != two] == [*range(587, 596)]
    assert truncated[586] == "5876 6404 2646  585"
    assert ellipse.part(arithmetic=CDC).splitlines() == truncated
    for machine in (IEEE, Rounding(), DEC):
        assert ellipse.part(arithmetic=machine).splitlines() == exact


def test_the_circle_is_the_same_in_all() -> None:
    assert len({circle.part(arithmetic=machine) for machine in ARITHMETICS.values()}) == 1


def float_of(word: int) -> Float:
    """Return a word of FLOAT."""
    mantissa = word & (1 << 27) - 1
    return Float(DEC, -mantissa if word & dec_float.SIGN else mantissa, (word >> 27 & 0o377) - 0o200 - 27)


def test_two_thousand_results_of_decs_float() -> None:
    """Recorded as FLOAT of DEC's 8K FORTRAN II ran on our PDP-8/L (dec_float.py)."""
    recorded = Path(__file__).with_name("float.bin").read_bytes()
    results = (float_of(int.from_bytes(recorded[at : at + 5])).exactly for at in range(0, len(recorded), 5))
    wrong = dict.fromkeys(dec_float.RESULTS, 0)
    for one, other in dec_float.pairs():
        a, b = float_of(one), float_of(other)
        ours = (a + b, a - b, a * b, a / b, DEC.sqrt(float_of(one & ~dec_float.SIGN)))
        for name, made in zip(wrong, ours, strict=True):
            wrong[name] += made.exactly != next(results)
    assert wrong == dict.fromkeys(dec_float.RESULTS, 0)
    assert next(results, None) is None
