"""The step-wise technique: every stop in its band, one axis a block, and the listings' staircases from it."""

from fractions import Fraction
from functools import partial
from itertools import pairwise
from math import cos, dist, hypot, radians, sin

import numpy as np
import pytest
from hypothesis import assume, example, given, settings
from hypothesis import strategies as st

from nc.curves import Graph, nominal
from programs import circle, curve, ellipse, fluidic, polynomial, slope, stepwise
from programs.arithmetic import ARITHMETICS
from programs.milling import Milling
from programs.parts import find
from programs.piecewise import Technique
from programs.stretches import Curve, Point, Side, Stretch, arc, graph, line, oval, turning_points
from tapes.errors import WorkError
from tests.programs.printouts import assert_fit_for_the_machine, milled

CENTRE = Point(4000, 4000)
places = st.builds(Point, st.integers(0, 3000), st.integers(0, 3000))


def contour(printout: str) -> list[tuple[int, int, int]]:
    return [(block.x, block.y, block.function) for block in milled(printout)[1:]]


def assert_same_staircase(path: Curve, printout: str) -> None:
    """Compare with a listing, which ends where its last quadrant does, .156 in from its start."""
    ours = [
        (*cut.stop, {"X": 84, "Y": 85}[cut.axis])
        for cut in stepwise.staircase(path.start, "Y", path.stretches[:3], "boundary")
    ]
    theirs = contour(printout)
    for number, (cut, wanted) in enumerate(zip(ours, theirs, strict=False), 7):
        assert cut == wanted, f"block {number:03}"
    assert len(ours) > 0.7 * len(theirs)


@settings(max_examples=25, deadline=None)
@given(st.integers(20, 400), st.integers(20, 400), st.integers(1, 15))
def test_the_general_procedure_makes_the_listings_staircase(major: int, minor: int, tolerance: int) -> None:
    """The boundary rule is that of Appendices C and D."""
    inner, outer = (major - tolerance, minor - tolerance), (major + tolerance, minor + tolerance)
    part = ellipse.part(major=major, minor=minor, tolerance=tolerance)
    assert_same_staircase(oval(CENTRE, major, inner, outer), part)


def test_the_general_procedure_makes_the_thesiss_circle() -> None:
    assert_same_staircase(oval(CENTRE, 1750, (1745, 1745), (1755, 1755)), circle.part())


@settings(max_examples=40, deadline=None)
@given(places, places, st.sampled_from([1.0, 2.5, 3.0, 5.0, 20.0]))
def test_every_stop_of_a_line_is_in_its_band(start: Point, end: Point, tolerance: float) -> None:
    assume(dist(start, end) > tolerance)
    at, axis = start, None
    for cut in stepwise.cuts(line(start, end, tolerance), "inside"):
        x, y = cut.stop
        assert (x == at.x) != (y == at.y)
        assert (cut.axis == "X") == (y == at.y)
        assert cut.axis != axis, "two cuts along one axis in a row"
        across, up = end.x - start.x, end.y - start.y
        if across and up:
            off = abs(across * (y - start.y) - up * (x - start.x)) / hypot(across, up)
            assert off <= tolerance * (1 + 1e-12)
        at, axis = cut.stop, cut.axis
    assert at == end


@settings(max_examples=60, deadline=None)
@given(
    st.integers(10, 500),
    st.floats(-360, 360, allow_nan=False),
    st.floats(-360, 360, allow_nan=False),
    st.sampled_from([1.0, 3.0, 5.0]),
)
@example(267, 261.0, 2.0, 1.0)  # ends within its first cut
def test_every_stop_of_an_arc_is_in_its_band(
    radius: int, start: float, sweep: float, tolerance: float
) -> None:
    path = arc(CENTRE, radius, start, sweep, tolerance)
    at = path.start
    for cut in stepwise.cuts(path, "inside"):
        x, y = cut.stop
        assert (x == at.x) != (y == at.y)
        assert abs(dist((x, y), CENTRE) - radius) <= tolerance * (1 + 1e-12)
        at = cut.stop
    assert at == path.end


@settings(max_examples=20, deadline=None)
@given(
    st.lists(st.integers(-3, 3), min_size=12, max_size=200),
    st.sampled_from([2.0, 2.5, 5.0]),
)
def test_every_stop_of_a_graph_is_in_its_band(steps: list[int], tolerance: float) -> None:
    heights = [5000 + sum(steps[:place]) for place in range(len(steps))]
    path = graph(100, [height - tolerance for height in heights], [height + tolerance for height in heights])
    at = path.start
    for cut in stepwise.cuts(path, "inside"):
        x, y = cut.stop
        assert (x == at.x) != (y == at.y)
        assert abs(y - heights[x - 100]) <= tolerance
        at = cut.stop
    assert at == Point(100 + len(heights) - 1, heights[-1])


def test_turning_points_are_where_a_table_turns() -> None:
    assert turning_points([0, 1, 2, 2, 1, 0, 0, 3]) == [3, 6]
    assert turning_points([0, 1, 2, 3]) == turning_points([1, 0]) == []
    assert turning_points([5, 5, 5]) == []


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


def test_a_point_just_outside_the_inner_ellipse_is_inside_the_band() -> None:
    """(5/7)² + (7/10)² = 1 + 1/4900."""
    assert oval(Point(0, 0), 9, (7, 10), (9, 12)).stretches[0].side(5, 7) is Side.INSIDE


def height_above_the_polynomial(x: int, y: int) -> Fraction:
    u = Fraction(x - 4000, 1000)
    return Fraction(y - 6000, 1000) - u * (u - 2) * (u - 6) / 5


def test_the_polynomial_is_fit_for_the_machine_and_passes_through_the_axis_three_times() -> None:
    part = polynomial.part()
    assert_fit_for_the_machine(part)
    path = milled(part)
    assert [(path[0].x, path[0].y), (path[-1].x, path[-1].y)] == [(3250, 3216), (10250, 7328)]
    signs = [block.y > 6000 for block in path]
    assert [after for before, after in pairwise(signs) if before != after] == [True, False, True]


@pytest.mark.parametrize("arithmetic", ARITHMETICS)
def test_the_polynomials_stops_lie_on_the_boundaries_of_its_band(arithmetic: str) -> None:
    """Chapter 6: each is the first thousandth on or beyond its limit; the one before it is inside."""
    error, thousandth = Fraction(1, 100), Fraction(1, 1000)
    part = polynomial.part(arithmetic=ARITHMETICS[arithmetic])
    path = milled(part)[:-2]  # the last two go to the end of the curve
    beyond = [height_above_the_polynomial(block.x, block.y) for block in path]
    for before, block, off in zip(path, path[1:], beyond[1:], strict=False):
        assert abs(off) >= error, block
        back = ((before.x > block.x) - (before.x < block.x), (before.y > block.y) - (before.y < block.y))
        assert abs(height_above_the_polynomial(block.x + back[0], block.y + back[1])) < error, block
    assert max(map(abs, beyond)) < error + 6 * thousandth  # it climbs 5.8 to 1 at its end


def test_the_polynomial_that_is_inspected_is_the_one_that_is_milled() -> None:
    curve = nominal(**find("polynomial").nominal)
    assert isinstance(curve, Graph)
    path = milled(polynomial.part())
    assert [1000 * curve.first + 4000, 1000 * curve.last + 4000] == [path[0].x, path[-1].x]
    off = curve.deviations(np.array([(block.x, block.y) for block in path], dtype=float))
    assert abs(off).max() < 11


def test_the_other_rule_stops_inside() -> None:
    path = milled(polynomial.part(milling=Milling(stop="inside")))[1:-1]
    assert max(abs(height_above_the_polynomial(block.x, block.y)) for block in path) <= Fraction(1, 100)
    assert len(path) > 1183


def test_every_stop_of_a_sine_is_in_its_band() -> None:
    part = curve.part("sin(x)", to=6.283)
    assert_fit_for_the_machine(part)
    level = milled(curve.part("1"))
    assert [(block.x, block.y) for block in level] == [(4000, 6000), (8000, 6000)]
    for block in milled(part):
        assert abs((block.y - 5000) / 1000 - sin((block.x - 4000) / 1000)) <= 0.0065


def test_chapter_3s_slope() -> None:
    part = slope.part()
    assert_fit_for_the_machine(part)
    first, last = milled(part)[0], milled(part)[-1]
    assert (first.x, first.y, last.x, last.y) == (4000, 4000, 8330, 6500)
    functions = [block.function for block in milled(part)[1:]]
    assert set(functions[0::2]) == {85}
    assert set(functions[1::2]) == {84}


def ends(segment: fluidic.Segment) -> list[tuple[float, float]]:
    if isinstance(segment, fluidic.Slope):
        return [segment.start, segment.end]
    (x, y), radius, start, sweep = segment
    angles = (radians(start), radians(start + sweep))
    return [(x + radius * cos(angle), y + radius * sin(angle)) for angle in angles]


def test_the_fluidic_element_is_symmetrical_and_of_the_chapters_make_up() -> None:
    outline = fluidic.outline()
    for before, after in pairwise([*outline, outline[0]]):
        assert dist(ends(before)[1], ends(after)[0]) < 0.0015
    slopes = [
        segment
        for segment in outline
        if isinstance(segment, fluidic.Slope)
        and segment.start[0] != segment.end[0]
        and segment.start[1] != segment.end[1]
    ]
    assert len(slopes) == 4
    assert sum(isinstance(segment, fluidic.Bend) for segment in outline) == 9
    channels = [segment for segment in fluidic.channel(0) if isinstance(segment, fluidic.Slope)]
    assert sum(a.start[0] != a.end[0] and a.start[1] != a.end[1] for a in channels) * 2 == 4


@pytest.mark.parametrize("program", ["main", "control", "both"])
def test_the_fluidic_element_is_fit_for_the_machine(program: str) -> None:
    part = fluidic.part(program=program)  # type: ignore[arg-type]
    assert_fit_for_the_machine(part)
    start, last = milled(part)[0], milled(part)[-1]
    if program == "main":
        assert (start.x, start.y) == (last.x, last.y)


def test_the_line_that_is_inspected_is_a_wall_of_the_fluidic_element() -> None:
    x, y, u, v = (1000 * inches for inches in find("fluidic").nominal["line"])
    stops = [(block.x, block.y) for block in milled(fluidic.part(program="main"))]
    for part in (0, 0.25, 0.5, 0.75, 1):
        assert min(dist(stop, (x + (u - x) * part, y + (v - y) * part)) for stop in stops) < 25


def test_the_control_channels_move_downstream_and_nothing_else_does() -> None:
    near, far = fluidic.part(control=0.0), fluidic.part(control=0.8)
    main = fluidic.part(program="main").count("\n")
    assert near.splitlines()[:main] == far.splitlines()[:main]
    ys = [max(block.y for block in milled(fluidic.part(program="control", control=c))) for c in (0.0, 0.8)]
    assert ys[1] - ys[0] == 800


def test_a_sequence_past_999_keeps_its_low_digits_or_prints_stars() -> None:
    low, stars = fluidic.part().splitlines(), fluidic.part(overflow="stars").splitlines()
    assert low[998][:3] == stars[998][:3] == "999"
    assert low[999][:3] == "000"
    assert low[1233][:3] == "234"
    assert stars[999][:3] == "***"
    assert [line[3:] for line in low] == [line[3:] for line in stars]


def test_a_band_that_lets_no_cut_begin_is_named() -> None:
    stuck = Stretch(
        1, 1, lambda x, y: Side.INSIDE if (x, y) == (7000, 8000) else Side.ABOVE, "Y", last_x=9000
    )
    path = Curve(Point(7000, 8000), (stuck,), Point(9000, 9000))
    for technique in (partial(stepwise.cuts, rule="inside"), Technique().rays):
        with pytest.raises(WorkError, match=r"X 7\.000 Y 8\.000"):
            list(technique(path))
