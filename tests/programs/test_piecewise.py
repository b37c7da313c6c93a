"""The piece-wise technique: the machine's own way, feeds wrong or right, stays in the band."""

from collections.abc import Callable, Iterator
from fractions import Fraction
from functools import cache
from itertools import product
from math import dist

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from programs import circle, die, ellipse, polynomial
from programs.milling import Milling
from programs.piecewise import Technique
from programs.printout import Printout
from programs.stretches import Point, arc, line
from tapes import eia
from tests.nc.tapes_1971 import tape
from tests.programs.printouts import milled
from tests.reference.compiling import compiler
from tests.reference.fewest import SHAPES, TAPES, Shape, search
from tests.reference.hydrapoint import MILL, HydraPoint, blocks

errors = st.sampled_from([0.8, 0.9, 1.0, 1.1, 1.2])
ALLOWED = 0.1
"""Of the band: what rounding a stop, and asking a band at a dozen places of a leg, may add."""


@cache
def piece(part: Callable[..., str]) -> str:
    return part(milling=Milling("piece"))


def places(printout: str, wrong: tuple[float, float]) -> Iterator[tuple[float, float]]:
    """Yield places that the cutter passes as it mills, its feeds off by `wrong`."""
    machine = HydraPoint(errors=[*(Fraction(error) - 1 for error in wrong), Fraction(0)])
    for block in blocks(tape(*printout.replace(" ", "0").splitlines())):
        x, y, _ = map(float, machine.at)
        machine.obey(block)
        for u, v in (map(float, leg.end[:2]) for leg in machine.legs if block.preparatory == MILL):
            yield from ((x + (u - x) * part / 20, y + (v - y) * part / 20) for part in range(1, 21))
            x, y = u, v


def off_the_circle(across: float, up: float) -> float:
    return (dist((across, up), (4000, 4000)) - 1750) / 5


def off_the_polynomial(across: float, up: float) -> float:
    u = (across - 4000) / 1000
    return (up - 6000 - 200 * u * (u - 2) * (u - 6)) / 10


@pytest.mark.slow("the piece-wise technique in three parts, 12 s")
@pytest.mark.parametrize(
    ("part", "off"), [(circle.part, off_the_circle), (polynomial.part, off_the_polynomial)]
)
@settings(max_examples=7)
@given(wrong=st.tuples(errors, errors))
def test_the_path_stays_in_its_band_however_the_feeds_err(
    part: Callable[..., str], off: Callable[..., float], wrong: tuple[float, float]
) -> None:
    assert all(abs(off(*place)) <= 1 + ALLOWED for place in places(piece(part), wrong))


def test_believed_feeds_keep_the_band_only_if_they_are_right() -> None:
    part = circle.part(milling=Milling("piece", feed_error=0))
    assert max(abs(off_the_circle(*place)) for place in places(part, (1, 1))) <= 1 + ALLOWED
    assert max(abs(off_the_circle(*place)) for place in places(part, (1.2, 0.8))) > 4


def test_fewer_blocks_than_step_by_step_and_more_the_worse_the_feeds() -> None:
    counts = [circle.part(milling=Milling("piece", feed_error=error)).count("\n") for error in (0, 0.1)]
    assert [*counts, piece(circle.part).count("\n"), circle.part().count("\n")] == [61, 192, 277, 666]


@pytest.mark.slow("the piece-wise technique round two contours, 11 s")
@pytest.mark.parametrize("part", [circle.part, ellipse.part, die.part])
def test_a_closed_contour_closes(part: Callable[..., str]) -> None:
    path = milled(piece(part))
    assert path[0][2:4] == path[-1][2:4]


def test_a_line_at_a_ratio_of_two_feeds_is_one_ray() -> None:
    rays = list(Technique(fastest=2, feed_error=0).rays(line(Point(0, 0), Point(1900, 1000), 5)))
    assert [ray.stop for ray in rays] == [Point(1900, 1000)]
    assert rays[0].feeds == (2, 1)
    for x, y, feeds in ((700, 0, (1, 0)), (0, 700, (0, 1)), (1900, 4000, (2, 4)), (4000, 1900, (4, 2))):
        assert list(Technique(5, 0).rays(line(Point(0, 0), Point(x, y), 200))) == [(feeds, (x, y))]


def test_a_ray_of_two_feeds_goes_on_until_the_slower_axis_has_moved_a_thousandth() -> None:
    """Else it would be taken from X .565 Y .499 to X .566 Y .500, by 1.0 and 1.9 in/min."""
    rays = Technique(fastest=2).rays(arc(Point(500, 500), 64, 359, 45, 2))
    assert [*rays][:2] == [((1, 0), (565, 499)), ((0, 1), (565, 500))]


def test_a_block_sets_one_feed_and_x_s_moves_or_names_the_one_in_force_again() -> None:
    """An arc of 20 degrees about 9 o'clock is as good as upright: two blocks along Y."""
    for fastest, curve, text in (
        (1, arc(Point(4000, 4000), 100, 190, -20, 5), "  16 3902 4000  185\n  26 3902 4017  185\n"),
        (2, line(Point(0, 0), Point(1900, 1000), 5), "  16    0    0  185\n  26 1900 1000  284\n"),
        (2, line(Point(0, 0), Point(1000, 1900), 5), "  16    0    0  285\n  26 1000 1900  184\n"),
    ):
        printout = Printout()
        Milling("piece", fastest=fastest, feed_error=0).print(printout, curve)
        assert printout.text == text


@pytest.fixture(scope="module")
def proved() -> str:
    if compiler() is None:
        pytest.skip("no C compiler is installed")
    return search(SHAPES["slope"])


@pytest.mark.slow("goes through every stop in the band, with every pair of feeds, in C: 8 s")
def test_no_program_for_the_slope_has_fewer_blocks(proved: str) -> None:
    """133 blocks, 2.7 over 1.0 in all but a few of them. The bundled tape is this one."""
    blocks = proved.splitlines()[6:]
    assert len(blocks) == 133
    assert eia.encode(proved.replace(" ", "0")) == (TAPES / "slope-fewest.eia").read_bytes()
    assert sum(block[14:17] not in ("  3", "  1") for block in blocks) <= 5


@pytest.mark.parametrize(
    ("name", "fewest"), [("slope", 139), ("circle", 227), ("ellipse", 331), ("die", 267)]
)
def test_a_proved_tape_keeps_the_band_however_the_feeds_err(name: str, fewest: int) -> None:
    """On the second machine, not nc's: a place each twentieth of a leg. Feeds 10 points worse leave it."""
    printout = eia.decode((TAPES / f"{name}-fewest.eia").read_bytes())
    assert printout.count("\n") == fewest
    for x_error, y_error in product((0.8, 1, 1.2), repeat=2):
        assert all(in_band(SHAPES[name], x, y) for x, y in places(printout, (x_error, y_error)))
    assert not all(in_band(SHAPES[name], x, y) for x, y in places(printout, (1.3, 0.7)))


def in_band(shape: Shape, across: float, up: float) -> bool:
    x, y, a, b = across - shape.origin.x, up - shape.origin.y, shape.width, shape.height
    if shape.kind == "line":
        return abs(a * y - b * x) <= 5.000001 * dist((0, 0), (a, b))
    ellipses = [(x / (a + off)) ** 2 + (y / (b + off)) ** 2 for off in (5, -5)]
    return ellipses[0] <= 1.000001 and ellipses[1] >= 0.999999
