"""Expressions, and the exact cutter path of equation 3."""

import math
import re
from contextlib import suppress
from math import atan, cos, hypot, isfinite, pi, sin

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from programs import curve
from programs.function import Range, _at_each_thousandth, offset_path
from programs.stepwise import cuts
from tapes.errors import WorkError
from tapes.expression import function
from tests.conftest import case


def test_an_expression_means_what_it_says() -> None:
    for text, x, y in (
        ("0.2*x*(x-2)*(x-6)", 1.0, 1.0),
        ("-x**2", 3.0, -9.0),
        ("2**-x", 1.0, 0.5),
        ("2**3**x", 2.0, 512.0),
        (" sqrt(abs(x)) + pi/e ", -4.0, 2 + pi / 2.718281828459045),
        ("sin(x)**2 + cos(x)**2", 0.7, 1.0),
        ("1e-3*x", 5.0, 0.005),
        ("x/2/2", 8.0, 2.0),
    ):
        with case(text):
            assert function(text)(x) == pytest.approx(y)


def test_nothing_else_can_be_said() -> None:
    words = "|x +|y|x.real|__import__('os')|().__class__|open('x')|sin|sin(x, x)|sin(x=1)|lambda: 1|[x]"
    signs = "x if x else 1|x < 1|True|'x'|1j|x^2|x; x|sin(*x)|\0"
    for text in (*words.split("|"), *signs.split("|"), "(" * 400, "9" * 400, "x+" * 400 + "x"):
        with case(text), pytest.raises(WorkError):
            function(text)


NOT = "is not an expression in x: numbers, x, pi, e, + - * / ** ( ) and " + (
    "sqrt, exp, log, sin, cos, tan, asin, acos, atan, sinh, cosh, tanh, abs"
)


def test_what_is_not_in_the_language_is_named_with_its_column() -> None:
    for text, said in (
        ("x + y", f"column 5: 'y' {NOT}"),
        ("x^2", f"column 2: '^' {NOT}; a power is written **"),
        (" x +", f"column 4: the end {NOT}"),
        ("sin x", f"column 1: 'sin' {NOT}"),
        ("(x", f"column 3: the end {NOT}"),
        ("2*1e+", f"column 4: 'e' {NOT}"),
        ("1.2.3", f"column 1: '1.2.3' {NOT}"),
        (" " * 500 + "x", "expression of 501 characters: at most 500 are allowed"),
        ("9" * 400, f"a number of '{'9' * 20}'... is too large"),
        ("(" * 400, f"'{'(' * 20}'... is nested too deeply"),
    ):
        with pytest.raises(WorkError, match=f"^{re.escape(said)}$"):
            function(text)


def test_a_function_has_python_s_values_up_to_a_million() -> None:
    for name in ("sqrt", "exp", "log", "sin", "cos", "tan", "asin", "acos", "atan", "sinh", "cosh", "tanh"):
        assert function(f"{name.upper()} ( X )")(0.5) == getattr(math, name)(0.5)
    assert function(" " * 498 + "+x")(999_999) == function("1E+2*X-1e2*x + x")(999_999) == 999_999
    for text, x, said in (
        ("x", 1_000_000, "at x = 1e+06 the expression 'x' is 1e+06: must be within 1e+06"),
        ("1/x", 0.0, "at x = 0 "),
        ("sqrt(x)", -1.0, "at x = -1 "),
        ("log(x)", 0.0, "at x = 0 "),
        ("10**400*x", 1.0, "at x = 1 "),
        ("exp(x)", 14.0, "at x = 14 "),
        ("x**0.5", -2, "at x = -2 "),
    ):
        with case(text), pytest.raises(WorkError, match=f"^{re.escape(said)}"):
            function(text)(x)


@given(st.text(alphabet="x0123456789.+-*/() e", max_size=30))
def test_any_text_is_a_function_or_refused(text: str) -> None:
    with suppress(WorkError):
        assert isfinite(function(text)(1.5))


@pytest.mark.parametrize(("cutter", "side", "radius"), [(5.0, "above", 4.5), (0.5, "below", 1.75)])
def test_the_path_beside_an_arc_is_an_arc(cutter: float, side: str, radius: float) -> None:
    """Beside a circle of radius 2 a cutter of 5 in goes on one of 4.5, one of 1/2 in inside it on 1.75."""
    path = offset_path(function("sqrt(4 - x**2)"), Range(-1.0, 1.0, 0.0, 0.0), 0.001, cutter, side)
    for cut in cuts(path, "boundary"):
        assert hypot(*cut.stop) == pytest.approx(1000 * radius, abs=2.5)


def test_the_centre_is_on_the_normal_of_equation_3() -> None:
    c = 0.25
    path = offset_path(function("x**2/4"), Range(-2.0, 2.0, 3.0, 0.0), 0.002, 2 * c, "above")
    for x1 in (-1.5, -0.5, 0.0, 0.7, 1.9):
        theta = atan(x1 / 2)
        x2, y2 = x1 - c * sin(theta) + 3.0, x1**2 / 4 + c * cos(theta)
        inside = [path.stretches[0].inside(x2 * 1000, y2 * 1000 + off) for off in (-2.1, 0, 2.1)]
        assert inside == [False, True, False]


def test_a_cutter_tighter_than_the_curve_is_refused_where_it_is_too_big() -> None:
    """x**2/4 has its tightest place, a radius of 2, at x = 0."""
    assert curve.part("x**2/4", from_=-2, to=2, cutter=3.9, tolerance=0.01)
    with pytest.raises(WorkError, match=r"too big: at x = 2\.488 "):  # 3 - .512, where it comes to 2.2
        curve.part("(x-3)**2/4", from_=1, to=5, cutter=4.4, tolerance=0.01)
    assert curve.part("x**2/4", from_=-2, to=2, cutter=4.4, side="below", tolerance=0.01, origin_x=6)
    with pytest.raises(WorkError, match=r"too big: at x = 0\.001 "):  # 1.25 sin(atan(4/3)) is 1: x2 rests
        offset_path(lambda x: max(0.0, x - 0.002) * 8 / 3, Range(0, 0.004, 0, 0), 0.002, 0.0025, "above")


def test_between_two_places_the_path_is_straight() -> None:
    across, up = [0.3, 2.1, 2.2, 5.0, 7.9, 10.0], [1.0, 5, 4, 0, 0.5, 8]
    expected = np.interp(range(1, 11), across, up)
    assert list(_at_each_thousandth(across, up)) == pytest.approx(expected)
