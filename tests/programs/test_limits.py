"""Both sides of each limit of a part: the nearest values that are taken and refused."""

from collections.abc import Callable, Sequence
from functools import partial
from math import cos, inf, nan, pi, sin

import pytest

from programs import drawn, points, printout
from programs.function import check_cutter
from programs.header import Header
from programs.least_squares import fit
from programs.piecewise import Technique
from programs.units import thousandths, tolerance_units
from tapes.errors import WorkError
from tests.conftest import case


def around(count: int, radius: float = 2, at: float = 5) -> list[tuple[float, float]]:
    """Return points of a circle, the first of them on its right."""
    return [
        (at + radius * cos(2 * pi * n / count), at + radius * sin(2 * pi * n / count)) for n in range(count)
    ]


def outlined(places: Sequence[tuple[float, float]], tolerance: float = 0.005) -> None:
    points.outline([*places], tolerance)


def field(name: str) -> Callable[[int], Header]:
    return lambda value: Header(**{name: value})


LIMITS: list[tuple[Callable[..., object], list[object], list[object]]] = [
    (partial(printout.check_on_table, "1", "X"), [0, 20_000], [-1, 20_001]),
    (partial(printout.check_on_table, "1", "Y"), [0, 10_000], [-1, 10_001]),
    (printout.check_feed, [1, 18], [0, 19]),
    (lambda number: printout.check_codes(number, 6, 84), [0, 999], [-1, 1000]),
    (lambda code: printout.check_codes(1, code, 84), [0, 9], [-1, 2, 3, 10]),
    (lambda code: printout.check_codes(1, 6, 84, code), [0, 80, 89], [-1, 79, 90]),
    (lambda size: printout.check_band("a", size, 1, 20), [0.001, 10], [0, -1, inf, nan]),
    (lambda inner: printout.check_band("a", 10, inner, 20), [0.001, 18], [0, 18.001, nan]),
    (lambda outer: printout.check_band("a", 10, 9, outer), [11, 20_000], [10.999, 20_000.1, inf]),
    (lambda x: printout.check_start(x, 0, 3, 2), [0, 3], [-0.001, 3.001, nan]),
    (lambda y: printout.check_start(0, y, 3, 2), [0, 2], [-0.001, 2.001, nan]),
    (field("park_x"), [0, 20_000], [-1, 20_001]),
    (field("park_y"), [0, 10_000], [-1, 10_001]),
    (field("z_feed_point"), [0, 3500], [-1, 3501]),
    (field("z_depth"), [3000, 5000], [2999, 5001]),
    (field("tool"), [1, 24], [0, 25]),
    (field("coolant"), [7, 8, 9], [6, 10]),
    (field("spindle"), [21, 38], [20, 39]),
    (field("z_feed"), [1, 18], [0, 19]),
    (Technique, [1, 18], [0, 19]),
    (lambda error: Technique(5, error), [0, 0.999], [-0.001, 1]),
    (check_cutter, [0.001, 10], [0, 10.001, nan]),
    (partial(thousandths, "X"), [0.001, 5], [0.0005, inf, nan]),
    (tolerance_units, [0.0005, 5], [inf, nan]),
    (lambda count: drawn.part("1 " * count), [2], [0, 1]),
    (lambda degree: fit(around(7), degree), [0, 3], [-1, 7]),
    (outlined, [around(5000), around(400)], [around(5001), around(2)]),
    (lambda far: outlined([(0, 0), (far, 0), (far, 1), (0, 1), (0, 0)]), [99.9, -99.9], [100, -100]),
    (lambda number: outlined(around(number), 0.01), [100, 4], [14]),
]


@pytest.mark.parametrize(("made", "taken", "refused"), LIMITS, ids=lambda value: "")
def test_the_nearest_values_are_taken_and_refused(
    made: Callable[[object], object], taken: list[object], refused: list[object]
) -> None:
    for value in taken:
        with case(value):
            made(value)
    for value in refused:
        with case(value), pytest.raises(WorkError):
            made(value)
