"""An I field takes the whole part of a REAL: cut towards zero, never rounded."""

from fractions import Fraction

import pytest

from programs.arithmetic import ARITHMETICS
from programs.format import Format


@pytest.mark.parametrize(("value", "printed"), [(2.9, "  2"), (-2.9, " -2"), (0.9999, "  0"), (99.5, " 99")])
@pytest.mark.parametrize("arithmetic", ARITHMETICS)
def test_the_whole_part(arithmetic: str, value: float, printed: str) -> None:
    assert Format("I3").line(ARITHMETICS[arithmetic].real(value)) == f"{printed}\n"
    assert Format("I3").line(Fraction(str(value))) == f"{printed}\n"
