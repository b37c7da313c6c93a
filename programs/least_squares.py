"""A curve from measured points: "experimental or design curves ... can always be reduced to some mathematical
functions by the Least Square Method" (Chapter 6).

The result is an expression, for `pdp8 part curve` and `pdp8 nc inspect --function`. A polynomial of degree n
passes through n + 1 points.

Source: thesis, Chapter 6.
"""

from collections.abc import Sequence
from typing import NamedTuple

from tapes.errors import WorkError

LARGEST_DEGREE = 12

Points = Sequence[tuple[float, float]]


class Fit(NamedTuple):
    """A polynomial as an expression in x, and its greatest distance from a point, along y; inches."""

    expression: str
    worst: float


def fit(points: Points, degree: int) -> Fit:
    """The polynomial nearest to the points along y. Raises WorkError for a degree that they do not give."""
    from numpy.polynomial import Polynomial  # only a fit needs it

    distinct = len({x for x, _ in points})
    highest = min(LARGEST_DEGREE, distinct - 1)
    if not 0 <= degree <= highest:
        raise WorkError(f"degree {degree} with {distinct} different x: must be 0 to {highest}")
    x, y = zip(*points, strict=True)
    polynomial = Polynomial.fit(x, y, degree).convert()
    worst = max(abs(float(polynomial(place)) - height) for place, height in points)
    return Fit(_expression([float(coefficient) for coefficient in polynomial.coef]), worst)


def _expression(coefficients: list[float]) -> str:
    """Return the polynomial, highest power first, to twelve digits."""
    powers = ["", "*x", *(f"*x**{power}" for power in range(2, len(coefficients)))]
    terms = [f"{c:+.12g}{p}" for c, p in zip(coefficients, powers, strict=False) if c or p == ""]
    return "".join(reversed(terms)).removeprefix("+")
