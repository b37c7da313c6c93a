"""The walls against geometry done by hand and by shapely, and the figures of the thesis's circle."""

from dataclasses import replace
from itertools import pairwise, permutations

import numpy as np
import pytest
import shapely
from shapely import LineString, Polygon, unary_union
from shapely.geometry import Point as Disc

import nc
from nc.curves import Curve, Ellipse, Graph, StraightLine, curve, fitted
from nc.inspection import Inspection, Walls, against, followed, inspect, runs, walls
from nc.machine import Settings
from nc.report import inspection_report
from nc.talysurf import talysurf
from nc.unit import INCH
from programs.parts import PARTS, part
from tapes.errors import WorkError
from tapes.nominal import Nominal
from tests.conftest import case
from tests.nc.tapes_1971 import CIRCLE, CIRCLE_BLOCKS, milled, milled_from, staircase, tape
from tests.programs import printouts

THE_CIRCLE = Ellipse(4000, 4000, 1750, 1750)


@pytest.fixture(scope="module")
def circle() -> Inspection:
    return inspect(nc.cut(CIRCLE))


def reading(inspection: Inspection, place: str, wall: str) -> float:
    """Return a trough to peak in inches, to the tenth of a thousandth."""
    (found,) = [r for r in inspection.readings if (r.place, r.wall) == (place, wall)]
    return round(found.trough_to_peak / 1000, 4)


def walls_along(line: tuple[float, ...], stations: int, *cuts: tuple[float, ...]) -> Walls:
    """Return the walls at the stations of a line that a cutter of radius 50 leaves along cuts."""
    return walls(np.array(cuts, dtype=float), StraightLine(*line).stations(stations), radius=50)


def test_a_straight_cut_leaves_walls_a_radius_away() -> None:
    for start, end in permutations([(1000.0, 1000.0), (9000.0, 1000.0), (1000.0, 9000.0)], 2):
        found = walls_along((*start, *end), 640, (*start, *end))
        assert found.outer == pytest.approx(0, abs=1e-9)
        assert found.inner == pytest.approx(0, abs=1e-9)


def test_a_single_plunge_leaves_a_hole() -> None:
    """Stations along a line through a hole of radius 50: walls at its chord, nothing beyond it."""
    found = walls_along((-60, 0, 60, 0), 13, (0, 0, 0, 0))
    chord = np.array([np.nan, *(np.sqrt(2500 - x * x) for x in range(-50, 51, 10)), np.nan])
    assert found.outer == pytest.approx(chord - 50, nan_ok=True)
    assert found.inner == pytest.approx(50 - chord, nan_ok=True)


@pytest.mark.parametrize(
    ("curve", "radius", "band"),
    [
        (Ellipse(4000, 4000, 300, 300), 62.5, 5),
        (Ellipse(4000, 4000, 300, 300), 62.5, 20),
        (Ellipse(4000, 4000, 300, 300), 125, 5),
        (Ellipse(4000, 4000, 420, 250), 62.5, 5),
    ],
    ids=str,
)
def test_the_walls_are_those_shapely_finds(curve: Ellipse, radius: float, band: int) -> None:
    """Cut by cut: a buffered path would lose its smallest kinks."""
    rough = (np.array(staircase(300, band), dtype=float) - 4000) * [curve.a / 300, curve.b / 300] + 4000
    metal = unary_union([LineString(cut).buffer(radius, quad_segs=2048) for cut in pairwise(rough)])
    stations = curve.stations(180)
    found = walls(np.hstack([rough[:-1], rough[1:]]), stations, radius)
    for at, (place, normal) in enumerate(zip(stations.points, stations.normals, strict=True)):
        line = LineString([place - 2 * radius * normal, place + 2 * radius * normal])
        through = line.intersection(metal)
        parts = [part for part in getattr(through, "geoms", [through]) if part.distance(Disc(place)) < 1e-6]
        if not parts:  # beyond the end of a rough path
            assert np.isnan([found.outer[at], found.inner[at]]).all()
            continue
        (part,) = parts
        inward, *_, outward = sorted((np.array(end) - place) @ normal for end in part.coords)
        with case(at):
            assert found.outer[at] + radius == pytest.approx(outward, abs=0.01)
            assert found.inner[at] - radius == pytest.approx(inward, abs=0.01)


@pytest.mark.slow("Shapely cuts a part twice, 18 s")
@pytest.mark.parametrize("side", ["above", "below"])
def test_a_surface_is_measured_where_its_part_has_it(side: str) -> None:
    """The wall of sin(x) + 1 on the part's side, by shapely; a tenth of an inch less at the ends."""
    blocks = printouts.milled(
        part("curve", "sin(x)+1", to=3, cutter=0.25, side=side, tolerance=0.003, stop="inside")
    )
    corners = [(block.x, block.y) for block in blocks]
    found = inspect(
        milled_from(corners),
        curve(Nominal("function", (4, 5, 0, 3), "sin(x)+1", side=side), 250),
        cutter=250,
        tolerance=3,
    )
    assert found.within_tolerance
    metal = unary_union([LineString(cut).buffer(125, quad_segs=2048) for cut in pairwise(corners)])
    walls = {"above": found.walls.inner, "below": found.walls.outer}[side]
    stations = np.linspace(0, 3, len(walls))
    for at in range(0, len(walls), 400):
        x = stations[at]
        slope = np.cos(x)
        place = np.array([4000 + 1000 * x, 6000 + 1000 * np.sin(x)])
        normal = np.array([-slope, 1]) / np.hypot(slope, 1)
        ray = LineString([place - 50 * normal, place + 50 * normal]).intersection(metal)
        ends = sorted((np.array(end) - place) @ normal for end in ray.coords)
        assert walls[at] == pytest.approx(ends[0] if side == "above" else ends[-1], abs=0.02)


def turned(number: int) -> str:
    """Return the file of an outline of equal sides about a circle, none along an axis."""
    angles = 0.507 + 2 * np.pi * np.arange(number) / number
    return "".join(f"{0.4 * np.cos(angle)},{0.4 * np.sin(angle)}\n" for angle in angles)


@pytest.mark.parametrize(
    ("outline", "cutter", "side"),
    [
        (turned(4), 0.0625, "outside"),
        (turned(5), 0.25, "outside"),
        pytest.param("0.6+0.05*cos(3*x)", 0.125, "inside", marks=pytest.mark.slow("many cuts, 4 s")),
    ],
)
def test_the_wall_of_a_profile_is_as_far_off_as_shapely_finds(outline: str, cutter: float, side: str) -> None:
    """Its highest and lowest place beside the outline, at a corner the distance from the nearer side."""
    given = {"tolerance": 0.003, "cutter": cutter, "side": side}
    made = part("profile", outline, stop="inside", **given)
    nominal = PARTS["profile"].nominal({"expression": outline, **given})
    assert nominal is not None
    measured = against(nc.cut(tape(*made.replace(" ", "0").split())), nominal)
    (found,) = (each for each in measured.readings if each.angle is None)
    way = [(block.x, block.y) for block in printouts.milled(made)]
    metal = unary_union([LineString(cut).buffer(500 * cutter, quad_segs=96) for cut in pairwise(way)])
    assert isinstance(metal, Polygon)
    wall = max(metal.interiors, key=lambda ring: ring.length) if side == "outside" else metal.exterior
    angles = np.linspace(0, 2 * np.pi, 20_000, endpoint=False)
    radii = 0.6 + 0.05 * np.cos(3 * angles)
    corners = nominal.points or np.column_stack([radii * np.cos(angles), radii * np.sin(angles)])
    edge = Polygon(1000 * np.array(corners) + 4000)
    places = shapely.get_coordinates(shapely.segmentize(LineString(wall.coords), 0.5))
    away, within = shapely.distance(shapely.points(places), edge.exterior), shapely.contains_xy(edge, places)
    off = np.where(within, -away, away)
    assert (found.lowest, found.highest) == pytest.approx((off.min(), off.max()), abs=0.05)
    for more, passed in ((-0.06, False), (-0.04, True), (0, True)):  # a verdict is to .0001 in
        tolerance = abs(measured.furthest.error) + more
        assert replace(measured, tolerance=tolerance).within_tolerance == passed


def test_a_guessed_nominal_is_round_and_feeds_do_not_move_it() -> None:
    """The piece-wise circle keeps to its band whatever the feeds do, and so does what is guessed from it."""
    made = part("circle", radius=0.5, technique="piece", close=True)
    frames = tape(*made.replace(" ", "0").split())
    around = Ellipse(4000, 4000, 500, 500)
    for x, y in ((0.0, 0.0), (-0.2, 0.2), (0.2, -0.2), (0.2, 0.2)):
        found = inspect(nc.cut(frames, settings=Settings(feed_error=(x, y, 0))))
        with case(f"{x}, {y}"):
            assert (found.curve, found.curve.guessed, found.within_tolerance) == (around, True, True)
    assert "guessed" in next(inspection_report(found))
    assert "guessed" in [*inspection_report(found)][-1]
    assert "guessed" not in "".join(inspection_report(inspect(nc.cut(frames), around)))
    odd = Ellipse(4003, 3998, 1742, 1742)
    for band, around in ((2, odd), (6, Ellipse(4005, 4000, 1740, 1740))):
        assert fitted(odd.stations(900).points, within=20, band=band) == around


def test_the_apexes_of_the_thesiss_circle(circle: Inspection) -> None:
    """Chapter 7's circle; the figures were computed twice elsewhere, by polygon offset."""
    assert circle.curve == THE_CIRCLE
    for place, outer in (("+Y", 0.0106), ("-Y", 0.0106), ("+X", 0.0069), ("-X", 0.0173)):
        assert reading(circle, f"{place} apex", "outer") == outer
    for place, inner in (("+Y", 0.0057), ("+X", 0.0072), ("-X", 0.0144)):
        assert reading(circle, f"{place} apex", "inner") == pytest.approx(inner, abs=0.00011)


def test_the_centre_kept_to_its_band_and_one_step(circle: Inspection) -> None:
    """The limits are +-.005; the first whole thousandth on or beyond them is less than .001 further."""
    low, high = circle.centre
    assert -6 <= low <= -5
    assert 5 <= high < 6
    for x, furthest in ((1750, 500), (1739, pytest.approx(495, abs=5))):  # what is more than a cutter away
        aside = tape(*CIRCLE_BLOCKS, "667 6 02251 04000 0 01 85", f"668 6 {x:05} 04000 0 01 84")
        assert inspect(nc.cut(aside), THE_CIRCLE).centre == (low, furthest)
    path = milled((2250, 4500), (2250, 4501))
    assert inspect(path, StraightLine(2250, 4000, 3250, 4000)).centre == (0, 500)


def test_a_larger_cutter_leaves_a_smoother_wall() -> None:
    """Chapter 7: a larger cutter smooths out sharp variations."""
    path = nc.cut(CIRCLE)
    rough = [reading(inspect(path, cutter=cutter), "+Y apex", "outer") for cutter in (125, 500, 1000)]
    assert rough == sorted(rough, reverse=True)


def test_what_the_cutter_never_reached_is_said() -> None:
    quarter = milled(*staircase(1750, 5)[:165])
    found = inspect(quarter, curve=THE_CIRCLE)
    assert 0.7 < found.uncut < 0.75
    assert abs(found.furthest.error) < 250
    assert not inspect(quarter, curve=THE_CIRCLE, tolerance=250).within_tolerance
    assert found.stepwise
    assert not inspect(milled((2250, 4010), (2261, 4020)), THE_CIRCLE).stepwise
    assert "out of tolerance: not all of the curve is cut; " in [*inspection_report(found)][-1]
    with pytest.raises(WorkError, match="did not reach"):
        inspect(quarter, curve=Ellipse(15000, 5000, 1000, 1000))


def test_a_closed_contour_that_ends_elsewhere_is_not_closed() -> None:
    """The machine's least move is .001 in."""
    found, line = inspect(nc.cut(CIRCLE), THE_CIRCLE), StraightLine(500, 900, 7000, 2000)
    for each, gap, said in ((THE_CIRCLE, 1, False), (THE_CIRCLE, 1.5, True), (line, 1500, False)):
        with case(each, gap):
            report = inspection_report(replace(found, curve=each, gap=gap))
            assert any("not closed" in text for text in report) == said


def test_a_wide_cutter_leaves_no_wall_within_a_bend() -> None:
    """A circle as wide as the cutter has no inside, a square none in its corners.

    y = x² is .5 (1 + 4x²)^1.5 in round, its centre above.
    """
    for cutter, without in ((3480, 0), (3481, 1)):
        found = inspect(nc.cut(CIRCLE), cutter=cutter)
        assert (found.without, found.uncut) == ({"outer": 0, "inner": without}, 0)
        assert {each.wall for each in found.readings} == {"outer"} | ({"inner"} if not without else set())
        assert ("no inner wall" in talysurf(found)) == without
    assert "no wall   inner, along 100.0% of the curve" in "\n".join(inspection_report(found))
    corners = [(4000, 4004), (6004, 4004), (6004, 4996), (3996, 4996), (3996, 4004), (4000, 4004)]
    square = Nominal("profile", (4, 4), points=((0, 0), (2, 0), (2, 1), (0, 1)))
    assert max(abs(each.error) for each in against(milled_from(corners), square).readings) < 5
    x = np.arange(-0.8, 0.8, 0.01)
    way = np.stack([x, x * x], axis=1) * 1000 + (4000, 5000)
    places = [(way[0], way[0]), *pairwise(way.round())]
    cuts = np.array([[*start, *end] for start, end in places])
    stations = Graph(4000, 5000, "x*x", -0.7, 0.7).stations(1401)
    left = walls(cuts, stations, radius=600)
    line = LineString(stations.points)
    closer = [line.distance(Disc(place)) < 599.95 for place in stations.points + 600 * stations.normals]
    assert np.count_nonzero(np.isnan(left.outer) != closer) <= 2 * 8
    assert not np.isnan(left.inner).any()


@pytest.mark.parametrize(
    "curve",
    [
        THE_CIRCLE,
        Ellipse(4000, 4000, 3000, 2250),
        StraightLine(500, 900, 7000, 2000),
        Graph(4000, 6000, "0.2*x*(x-2)*(x-6)", 0, 6),
    ],
    ids=str,
)
def test_stations_lie_on_the_curve_and_normals_are_square_to_it(curve: Curve) -> None:
    stations = curve.stations(1000)
    assert np.hypot(*stations.normals.T) == pytest.approx(1)
    ways = np.diff(stations.points, axis=0)
    assert (ways * stations.normals[:-1]).sum(axis=1) / np.hypot(*ways.T) == pytest.approx(0, abs=0.01)
    limit = curve.limit(stations, -5)
    if isinstance(curve, Graph):
        x, y = (stations.points.T - np.array([[4000], [6000]])) / 1000
        assert y == pytest.approx(0.2 * x * (x - 2) * (x - 6), abs=1e-9)
        assert limit == pytest.approx(stations.points - [0, 5])
    elif isinstance(curve, Ellipse | StraightLine):
        assert curve.deviations(stations.points) == pytest.approx(0, abs=1e-6)
        assert curve.deviations(stations.points + 3 * stations.normals) == pytest.approx(3, abs=0.01)
        assert curve.deviations(limit) == pytest.approx(-5, abs=0.02)
    if isinstance(curve, Ellipse):
        assert curve.deviations(np.array([[4000, 4000]])) == -min(curve.a, curve.b)


def test_what_is_rounded_to_a_thousandth_stays_a_curve() -> None:
    for a, b, found in ((701, 700, (700, 700)), (702, 700, (702, 700)), (2, 0.4, None)):
        curve = found and Ellipse(4100, 3900, *found)
        assert fitted(Ellipse(4100, 3900, a, b).stations(900).points, within=1 if found else 0.1) == curve
    assert fitted(np.array([[0.0, 0], [1000, 0]]), within=0) == StraightLine(0, 0, 1000, 0)


def test_what_follows_no_curve_is_none() -> None:
    fine, rough = (milled(*staircase(1750, band)) for band in (19, 22))
    assert followed(fine, 1) == followed(rough, 6) == THE_CIRCLE
    assert followed(rough, 5) is None
    assert followed(milled((3250, 4000), (4250, 4000)), 5) == StraightLine(2250, 4000, 4250, 4000)
    there_and_back = np.array([[0.0, 0], [1000, 0], [2000, 0], [0, 0]])
    assert fitted(there_and_back, within=5) is fitted(there_and_back[:, ::-1], within=5) is None
    assert fitted(np.array([[0.0, 0], [1000, 0], [1000, 700], [0, 700], [500, 100]]), within=20) is None
    stations = Ellipse(4000, 4000, 3000, 2250).stations(36)
    assert fitted(stations.points[:10], within=5) == Ellipse(4000, 4000, 3000, 2250)
    assert fitted(stations.points[5:11], within=5) is None  # a sixth of it, as near to others
    for tolerance, within in ((4, r"0\.020"), (250, r"1\.000")):
        with pytest.raises(WorkError, match=f"within {within} in: name the nominal curve"):
            inspect(milled((2250, 8000), (9000, 8000)), tolerance=tolerance)


@pytest.mark.parametrize(
    ("nominal", "made"),
    [
        (Nominal("circle", (4, 5, 3)), Ellipse(4000, 5000, 3000, 3000)),
        (Nominal("circle", (4, 5, 3), side="inside"), Ellipse(4000, 5000, 3000, 3000, -250)),
        (Nominal("ellipse", (4, 5, 3, 2.25)), Ellipse(4000, 5000, 3000, 2250)),
        (Nominal("line", (0.5, 0.9, 7, 2)), StraightLine(500, 900, 7000, 2000)),
        (Nominal("function", (4, 5, 0, 6), "x"), Graph(4000, 5000, "x", 0, 6)),
        (Nominal("function", (4, 5, 0, 6), "x", side="above"), Graph(4000, 5000, "x", 0, 6, 250)),
        (Nominal("ellipse", (4, 4, 2, 0)), "a radius or semi-axis must be greater than 0"),
        (Nominal("function", (4, 5, 0, 0), "x"), "range from 0 to 0: must go from less to more"),
        (Nominal("function", (4, 5, 0, 1), "y"), "column 1: 'y'"),
    ],
)
def test_a_curve_is_named_in_inches(nominal: Nominal, made: Curve | str) -> None:
    if isinstance(made, str):
        with pytest.raises(WorkError, match=f"^{made}"):
            curve(nominal, 500)
    else:
        assert curve(nominal, 500) == made


def test_a_graph_goes_through_every_turning_point() -> None:
    deviation = np.array([0.0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, -3, 0, np.nan, 2, 2.5, 1])
    kept = [run.tolist() for run in runs(deviation, closed=False, every=100)]
    assert {0, 1, 12, 13} <= set(kept[0])
    assert kept[1] == [15, 16, 17]
    assert runs(np.full(9, np.nan), closed=True) == []


def test_a_point_that_comes_twice_in_a_row_changes_no_outline() -> None:
    square = ((-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0))
    twice = (*square[:2], *square[1:], square[0])
    one, two = (curve(Nominal("profile", (4, 4), points=points), 500) for points in (square, twice))
    assert np.array_equal(one.stations(80).points, two.stations(80).points)
    assert one.said(INCH) == two.said(INCH)
