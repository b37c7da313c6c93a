"""The step-wise technique: every stop in its band, one axis a block, and the listings' staircases from it."""

from collections.abc import Callable, Iterator
from fractions import Fraction
from functools import partial
from itertools import groupby, pairwise
from math import dist, hypot

import numpy as np
import pytest
from hypothesis import assume, example, given, settings
from hypothesis import strategies as st

from nc.curves import curve
from programs import ellipse, fluidic, polynomial, stepwise
from programs.arithmetic import ARITHMETICS
from programs.parts import find
from programs.piecewise import Technique
from programs.stretches import Curve, Point, Side, Stretch, arc, graph, line, oval, turning_points
from tapes.errors import WorkError
from tests.programs.printouts import milled

CENTRE = Point(4000, 4000)
places = st.builds(Point, st.integers(0, 3000), st.integers(0, 3000))


@settings(max_examples=25)
@given(st.integers(20, 400), st.integers(20, 400), st.integers(1, 15))
def test_the_general_procedure_makes_the_listings_staircase(major: int, minor: int, tolerance: int) -> None:
    """The boundary rule is that of Appendices C and D; a listing ends before its start, so ours is longer."""
    inner, outer = (major - tolerance, minor - tolerance), (major + tolerance, minor + tolerance)
    part = ellipse.part(major=major, minor=minor, tolerance=tolerance)
    path = oval(CENTRE, major, inner, outer)
    cuts = stepwise.staircase(path.start, "Y", path.stretches[:3], "boundary")
    ours = [(*cut.stop, {"X": 84, "Y": 85}[cut.axis]) for cut in cuts]
    theirs = [(block.x, block.y, block.function) for block in milled(part)[1:]]
    assert ours[: len(theirs)] == theirs[: len(ours)]
    assert len(ours) > 0.7 * len(theirs)


def stops(path: Curve) -> Iterator[Point]:
    """Yield where the cuts inside a band stop: each along one axis, the last at the end of the curve."""
    at = path.start
    for cut in stepwise.cuts(path, "inside"):
        assert (cut.stop.x == at.x, cut.stop.y == at.y) == (cut.axis == "Y", cut.axis == "X")
        at = cut.stop
        yield at
    assert at == path.end


@pytest.mark.parametrize("tolerance", [1, 999.9, 0.999, 1000, float("nan")])
def test_a_band_is_a_thousandth_at_least_and_narrower_than_the_curve(tolerance: float) -> None:
    flat, slope = [0.0] * 1001, [float(at) for at in range(1001)]
    makers: list[Callable[[], Curve]] = [
        lambda: line(Point(0, 0), Point(600, 800), tolerance),
        lambda: arc(CENTRE, 1000, 0, 90, tolerance),
        *(
            partial(graph, 0, [at - tolerance for at in of], [at + tolerance for at in of])
            for of in (flat, slope)
        ),
    ]
    for made in makers:
        if 1 <= tolerance < 1000:
            assert isinstance(made(), Curve)
        else:
            with pytest.raises(WorkError, match=r"^tolerance .*: must be"):
                made()


@settings(max_examples=40)
@given(places, places, st.sampled_from([1.0, 2.5, 3.0, 5.0, 20.0]))
def test_every_stop_of_a_line_is_in_its_band(start: Point, end: Point, tolerance: float) -> None:
    assume(dist(start, end) > tolerance)
    across, up = end.x - start.x, end.y - start.y
    made = [start, *stops(line(start, end, tolerance))]
    for x, y in made if across and up else ():
        assert abs(across * (y - start.y) - up * (x - start.x)) <= tolerance * hypot(across, up) * (1 + 1e-12)
    axes = [before.x == at.x for before, at in pairwise(made)]
    assert all(before != axis for before, axis in pairwise(axes)), "two cuts along one axis in a row"


@settings(max_examples=60)
@given(st.integers(10, 500), st.floats(-360, 360), st.floats(-360, 360), st.sampled_from([1.0, 3.0, 5.0]))
@example(267, 261.0, 2.0, 1.0)  # ends within its first cut
def test_every_stop_of_an_arc_is_in_its_band(
    radius: int, start: float, sweep: float, tolerance: float
) -> None:
    for stop in stops(arc(CENTRE, radius, start, sweep, tolerance)):
        assert abs(dist(stop, CENTRE) - radius) <= tolerance * (1 + 1e-12)


@settings(max_examples=20)
@given(st.lists(st.integers(-3, 3), min_size=12, max_size=200), st.sampled_from([2.0, 2.5, 5.0]))
def test_every_stop_of_a_graph_is_in_its_band(steps: list[int], tolerance: float) -> None:
    heights = [5000 + sum(steps[:place]) for place in range(len(steps))]
    path = graph(100, [height - tolerance for height in heights], [height + tolerance for height in heights])
    for x, y in stops(path):
        assert abs(y - heights[x - 100]) <= tolerance
    assert path.end == Point(100 + len(heights) - 1, heights[-1])


def test_turning_points_are_where_a_table_turns() -> None:
    assert turning_points([0, 1, 2, 2, 1, 0, 0, 3]) == [3, 6]
    for level in ([0, 1, 2, 3], [1, 0], [5, 5, 5]):
        assert turning_points(level) == []


@pytest.mark.parametrize("low", [-361, -181, -180, -90.5, 0, 89, 90])
@pytest.mark.parametrize("sweep", [1, 1.5, 90, 91, 181, 360])
def test_an_arc_is_parted_at_each_right_angle_within_it(low: float, sweep: float) -> None:
    between = sum(low < 90 * turn < low + sweep for turn in range(-9, 9))
    assert len(arc(CENTRE, 100, low, sweep, 3).stretches) == 1 + between
    assert len(arc(CENTRE, 100, low + sweep, -sweep, 3).stretches) == 1 + between


def test_a_limit_is_a_side_of_its_own() -> None:
    """Of a rising graph, which has no band beyond its ends, and of a ring between two circles."""
    rising = graph(100, [0, 2, 4, 6], [4, 6, 8, 10]).stretches[0].side
    ring = oval(Point(0, 0), 9, (5, 5), (13, 13)).stretches[0].side
    for x, low in ((100, 0), (100.5, 1), (102, 4), (103, 6)):
        sides = [rising(x, low + up) for up in (-0.1, 0, 2, 4, 4.1)]
        assert sides == [Side.BELOW, Side.LOWER_LIMIT, Side.INSIDE, Side.UPPER_LIMIT, Side.ABOVE]
    assert rising(99, 2) is rising(103.5, 9) is rising(104, 10) is Side.BELOW
    assert [ring(x, y) for x, y in ((3, 3), (3, 4), (6, 6), (5, 12), (12, 12))] == sides
    just_outside = oval(Point(0, 0), 9, (7, 10), (9, 12)).stretches[0].side(5, 7)
    assert just_outside is Side.INSIDE, "(5/7)² + (7/10)² = 1 + 1/4900"


def height_above_the_polynomial(x: int, y: int) -> Fraction:
    u = Fraction(x - 4000, 1000)
    return Fraction(y - 6000, 1000) - u * (u - 2) * (u - 6) / 5


@pytest.mark.parametrize("arithmetic", ARITHMETICS)
def test_the_polynomials_stops_lie_on_the_boundaries_of_its_band(arithmetic: str) -> None:
    """Chapter 6: each is the first thousandth on or beyond its limit; the one before it is inside."""
    error, thousandth = Fraction(1, 100), Fraction(1, 1000)
    path = milled(polynomial.part(arithmetic=ARITHMETICS[arithmetic]))[:-2]  # the last two go to the end
    beyond = [height_above_the_polynomial(block.x, block.y) for block in path]
    for before, block, off in zip(path, path[1:], beyond[1:], strict=False):
        assert abs(off) >= error, block
        back = [int(np.sign(before[axis] - block[axis])) for axis in (2, 3)]
        assert abs(height_above_the_polynomial(block.x + back[0], block.y + back[1])) < error, block
    assert max(map(abs, beyond)) < error + 6 * thousandth  # it climbs 5.8 to 1 at its end


def test_the_polynomial_that_is_inspected_is_the_one_that_is_milled() -> None:
    """It passes through the axis three times."""
    path = milled(polynomial.part())
    above = [block.y > 6000 for block in path]
    assert [side for side, _ in groupby(above)] == [False, True, False, True]
    inspected = find("polynomial").nominal()
    assert inspected is not None
    ends = curve(inspected, 500).stations(2).points
    assert ends == pytest.approx(np.array([path[0][2:4], path[-1][2:4]]), abs=0.5)


def test_a_sequence_past_999_keeps_its_low_digits_or_prints_stars() -> None:
    low, stars = fluidic.part().splitlines(), fluidic.part(overflow="stars").splitlines()
    assert [low[at][:3] for at in (998, 999, 1233)] == ["999", "000", "234"]
    assert [stars[at][:3] for at in (998, 999, 1233)] == ["999", "***", "***"]
    assert [line[3:] for line in low] == [line[3:] for line in stars]


def test_a_band_that_lets_no_cut_begin_is_named() -> None:
    stuck = Stretch(
        1, 1, lambda x, y: Side.INSIDE if (x, y) == (7000, 8000) else Side.ABOVE, "Y", last_x=9000
    )
    path = Curve(Point(7000, 8000), (stuck,), Point(9000, 9000))
    for technique in (partial(stepwise.cuts, rule="inside"), Technique().rays):
        with pytest.raises(WorkError, match=r"X 7\.000 Y 8\.000"):
            list(technique(path))
