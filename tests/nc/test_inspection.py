"""The walls against geometry done by hand and by shapely, and the figures of the thesis's circle."""

from itertools import pairwise, permutations

import numpy as np
import pytest
from shapely import LineString, unary_union
from shapely.geometry import Point as Disc
from shapely.geometry.base import BaseGeometry

import nc
from nc.curves import Curve, Ellipse, Floats, Graph, Stations, StraightLine, fitted, nominal
from nc.inspection import Inspection, followed, inspect, runs, segments, walls
from nc.report import inspection_report
from tapes import shelf
from tapes.errors import WorkError
from tests.nc.tapes_1971 import CIRCLE, CIRCLE_BLOCKS, HEADER, milling, staircase, tape

THE_CIRCLE = Ellipse(4000, 4000, 1750, 1750)


@pytest.fixture(scope="module")
def circle() -> Inspection:
    return inspect(nc.cut(CIRCLE))


def reading(inspection: Inspection, place: str, wall: str) -> float:
    """Return a trough to peak in inches, to the tenth of a thousandth."""
    (found,) = [r for r in inspection.readings if (r.place, r.wall) == (place, wall)]
    return round(found.trough_to_peak / 1000, 4)


def test_a_straight_cut_leaves_walls_a_radius_away() -> None:
    for start, end in permutations([(1000.0, 1000.0), (9000.0, 1000.0), (1000.0, 9000.0)], 2):
        found = walls(np.array([[*start, *end]]), StraightLine(*start, *end).stations(640), radius=250)
        assert found.outer == pytest.approx(0, abs=1e-9)
        assert found.inner == pytest.approx(0, abs=1e-9)


def test_a_single_plunge_leaves_a_hole() -> None:
    """Stations along a line through a hole of radius 50: walls at its chord, nothing beyond it."""
    found = walls(np.array([[0.0, 0, 0, 0]]), StraightLine(-60, 0, 60, 0).stations(13), radius=50)
    chord = [np.sqrt(2500 - x * x) for x in range(-50, 51, 10)]
    assert found.outer[1:-1] == pytest.approx(np.array(chord) - 50)
    assert found.inner[1:-1] == pytest.approx(50 - np.array(chord))
    assert np.isnan(found.outer[[0, -1]]).all()


def test_a_station_that_the_cutter_only_touches_is_cut() -> None:
    """A plunge between two pairs of stations, and the side of a cut that a stylus comes along."""
    plunge, cut = np.array([[0.0, 0, 0, 0]]), np.array([[-100.0, 0, 100, 0]])
    for cuts, line, outer in (
        (plunge, StraightLine(50, 0, 60, 0), 0),
        (plunge, StraightLine(-60, 0, -50, 0), 0),
        (cut, StraightLine(0, 50, 0, 60), 100),
        (cut, StraightLine(0, -60, 0, -50), 100),
    ):
        found = walls(cuts, line.stations(2), radius=50)
        assert np.nanmax(found.outer) + 50 == outer
        assert np.isnan(found.outer).sum() == 1


def test_one_step_leaves_a_cusp_where_the_discs_meet() -> None:
    """Two corners (0, 0) and (80, 0) with nothing milled between: walls meet at 40, sqrt(50² - 40²) high."""
    found = walls(
        np.array([[0.0, 0, 0, 0], [80, 0, 80, 0]]), StraightLine(0, 0, 80, 0).stations(81), radius=50
    )
    assert found.outer.min() == pytest.approx(30 - 50)
    assert found.outer.argmin() == 40


def buffered(cuts: Floats, radius: float) -> BaseGeometry:
    """Return what the cutter took away, cut by cut: a buffered path would lose its smallest kinks."""
    return unary_union([LineString([cut[:2], cut[2:]]).buffer(radius, quad_segs=2048) for cut in cuts])


def stylus(metal: BaseGeometry, stations: Stations, at: int, reach: float) -> tuple[float, float]:
    """Return where the line through a station, along its normal, leaves what was cut: inward, outward."""
    place, normal = stations.points[at], stations.normals[at]
    line = LineString([place - reach * normal, place + reach * normal])
    through = line.intersection(metal)
    parts = getattr(through, "geoms", [through])
    (part,) = [part for part in parts if part.distance(Disc(place)) < 1e-6]
    along = sorted(float((np.array(end) - place) @ normal) for end in part.coords)
    return along[0], along[-1]


@pytest.mark.parametrize(
    ("curve", "cutter"),
    [
        (Ellipse(4000, 4000, 300, 300), 125),
        (Ellipse(4000, 4000, 300, 300), 250),
        (Ellipse(4000, 4000, 420, 250), 125),
    ],
    ids=str,
)
def test_the_walls_are_those_shapely_finds(curve: Ellipse, cutter: float) -> None:
    rough = np.array(staircase(300, 5), dtype=np.float64)
    rough = (rough - 4000) * [curve.a / 300, curve.b / 300] + 4000
    cuts = np.hstack([rough[:-1], rough[1:]])
    stations = curve.stations(180)
    found, metal = walls(cuts, stations, cutter / 2), buffered(cuts, cutter / 2)
    for at in range(len(stations)):
        inward, outward = stylus(metal, stations, at, cutter)
        assert found.outer[at] + cutter / 2 == pytest.approx(outward, abs=0.01), at
        assert found.inner[at] - cutter / 2 == pytest.approx(inward, abs=0.01), at


class TestTheCircle:
    """Chapter 7's circle; the figures were computed twice elsewhere, by polygon offset."""

    def test_the_curve_is_found_from_the_path(self, circle: Inspection) -> None:
        assert circle.curve == THE_CIRCLE
        assert str(circle.curve) == "circle, centre X 4.000 Y 4.000, radius 1.750 in"

    def test_its_apexes(self, circle: Inspection) -> None:
        for place, outer in (("+Y", 0.0106), ("-Y", 0.0106), ("+X", 0.0069), ("-X", 0.0173)):
            assert reading(circle, f"{place} apex", "outer") == outer
        for place, inner in (("+Y", 0.0057), ("+X", 0.0072), ("-X", 0.0144)):
            assert reading(circle, f"{place} apex", "inner") == pytest.approx(inner, abs=0.00011)

    def test_the_centre_kept_to_its_band_and_one_step(self, circle: Inspection) -> None:
        """The limits are +-.005; the first whole thousandth on or beyond them is less than .001 further."""
        low, high = circle.centre
        assert -6 < low <= -5
        assert 5 <= high < 6
        for x, furthest in ((1750, 500), (1749, high)):  # what is a cutter away, and what is further
            aside = tape(*CIRCLE_BLOCKS, "667 6 02251 04000 0 01 85", f"668 6 {x:05} 04000 0 01 84")
            assert inspect(nc.cut(aside), THE_CIRCLE).centre == (low, furthest)

    def test_stations_are_close_enough(self, circle: Inspection) -> None:
        """Five times as many stations find nothing more than .00002 in worse."""
        path = nc.cut(CIRCLE)
        finer = walls(segments(path.cuts), THE_CIRCLE.stations(180_000), 250)
        assert np.nanmin(finer.outer) == pytest.approx(np.nanmin(circle.walls.outer), abs=0.2)
        assert np.nanmax(finer.outer) == pytest.approx(np.nanmax(circle.walls.outer), abs=0.02)


def test_a_larger_cutter_leaves_a_smoother_wall(circle: Inspection) -> None:
    """Chapter 7: a larger cutter smooths out sharp variations."""
    path = nc.cut(CIRCLE)
    rough = [reading(inspect(path, cutter=cutter), "+Y apex", "outer") for cutter in (125, 500, 1000)]
    assert rough == sorted(rough, reverse=True)


def test_what_the_cutter_never_reached_is_said() -> None:
    quarter = nc.cut(tape(*HEADER, *milling(staircase(1750, 5), (2250, 4000))[:165]))
    found = inspect(quarter, curve=THE_CIRCLE)
    assert 0.7 < found.uncut < 0.75
    assert abs(found.furthest.error) < 250
    assert not inspect(quarter, curve=THE_CIRCLE, tolerance=250).within_tolerance
    assert "out of tolerance: not all of the curve is cut; " in [*inspection_report(found)][-1]
    with pytest.raises(WorkError, match="did not reach"):
        inspect(quarter, curve=Ellipse(15000, 5000, 1000, 1000))


class TestCurves:
    """Curves, and finding the one a path follows."""

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
    def test_stations_lie_on_the_curve_and_normals_are_square_to_it(self, curve: Curve) -> None:
        stations = curve.stations(1000)
        assert curve.deviations(stations.points) == pytest.approx(0, abs=1e-6)
        assert np.hypot(*stations.normals.T) == pytest.approx(1)
        for (before, after), normal in zip(pairwise(stations.points), stations.normals, strict=False):
            way = after - before
            assert abs(way @ normal) / np.hypot(*way) < 0.01
        assert curve.deviations(stations.points + 3 * stations.normals) == pytest.approx(3, abs=0.01)
        limit = curve.limit(stations, -5)
        if isinstance(curve, Graph):
            assert limit == pytest.approx(stations.points - [0, 5])
        else:
            assert curve.deviations(limit) == pytest.approx(-5, abs=0.02)
        if isinstance(curve, Ellipse):
            centre = np.array([[curve.x, curve.y]])
            assert curve.deviations(centre) == -min(curve.a, curve.b)

    @pytest.mark.parametrize(
        "curve",
        [Ellipse(4100, 3900, 700, 700), Ellipse(9000, 4000, 3000, 1500), StraightLine(500, 900, 7000, 2000)],
        ids=str,
    )
    def test_the_curve_is_found_again(self, curve: Curve) -> None:
        stations = curve.stations(900)
        jagged = stations.points + np.where(np.arange(900) % 2, 5, -5)[:, None] * stations.normals
        assert fitted(jagged, within=20) == curve
        assert fitted(stations.points[:500], within=1) == curve or isinstance(curve, StraightLine)

    def test_what_is_rounded_to_a_thousandth_stays_a_curve(self) -> None:
        for a, b, found in ((701, 700, (700, 700)), (702, 700, (702, 700)), (2, 0.4, None)):
            curve = found and Ellipse(0, 0, *found)
            assert fitted(Ellipse(0, 0, a, b).stations(900).points, within=1 if found else 0.1) == curve
        assert fitted(np.array([[0.0, 0], [1000, 0]]), within=0) == StraightLine(0, 0, 1000, 0)

    def test_a_curve_is_named_in_inches(self) -> None:
        assert nominal() is None
        assert nominal(circle=(4, 4, 1.75)) == THE_CIRCLE
        assert nominal(ellipse=(4, 5, 3, 2.25)) == Ellipse(4000, 5000, 3000, 2250)
        assert nominal(line=(0.5, 0.9, 7, 2)) == StraightLine(500, 900, 7000, 2000)
        assert nominal(function="x", origin=(4, 5), range_=(0, 6)) == Graph(4000, 5000, "x", 0, 6)
        assert nominal(function="x", range_=(0, 6)) == Graph(0, 0, "x", 0, 6)
        for a, b in ((2, 0), (0, 2)):
            with pytest.raises(WorkError, match=f"semi-axes {a} and {b} in: each must be greater than 0"):
                nominal(ellipse=(4, 4, a, b))
        with pytest.raises(WorkError, match="3 curves are named; at most one is allowed"):
            nominal(circle=(4, 4, 1), line=(0, 0, 1, 1), function="x", range_=(0, 1))
        with pytest.raises(WorkError, match="function x: its range of x is needed"):
            nominal(function="x")
        with pytest.raises(WorkError, match="column 1: 'y'"):
            nominal(function="y", range_=(0, 1))

    def test_what_follows_no_curve_is_none(self) -> None:
        fine, rough = (nc.cut(tape(*HEADER, *milling(staircase(1750, by), (2250, 4000)))) for by in (19, 22))
        assert followed(fine, 1) == followed(rough, 6) == THE_CIRCLE
        assert followed(rough, 5) is None
        straight = nc.cut(tape(*HEADER, *milling([(3250, 4000), (4250, 4000)], (2250, 4000))))
        assert followed(straight, 5) == StraightLine(2250, 4000, 4250, 4000)
        there_and_back = np.array([[0.0, 0], [1000, 0], [2000, 0], [0, 0]])
        assert fitted(there_and_back, within=5) is fitted(there_and_back[:, ::-1], within=5) is None
        assert fitted(np.array([[0.0, 0], [1000, 0], [1000, 700], [0, 700], [500, 100]]), within=20) is None
        with pytest.raises(WorkError, match=r"within 0\.020 in: name the nominal curve"):
            inspect(nc.cut(tape(*HEADER, "007 6 02250 08000 0 01 85", "008 6 09000 08000 0 01 84")))

    def test_the_ellipse_of_the_thesis(self) -> None:
        found = inspect(nc.cut(shelf.read("ellipse.eia")))
        assert found.curve == Ellipse(4000, 4000, 3000, 2250)
        assert reading(found, "+Y apex", "outer") == reading(found, "-Y apex", "outer") == 0.011


def test_a_graph_goes_through_every_turning_point() -> None:
    deviation = np.array([0.0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, -3, 0, np.nan, 2, 2.5, 1])
    kept = [run.tolist() for run in runs(deviation, closed=False, every=100)]
    assert {0, 1, 12, 13} <= set(kept[0])
    assert kept[1] == [15, 16, 17]


def test_the_centre_is_measured_as_far_off_as_its_cutter_is_wide() -> None:
    path = nc.cut(tape(*HEADER, *milling([(2250, 4500), (2250, 4501)], (2250, 4000))))
    assert inspect(path, StraightLine(2250, 4000, 3250, 4000)).centre == (0, 500)


def test_lengths_of_10_inches_and_more_are_written_whole() -> None:
    """A cut at X 18.5 in inspected against a line at X 8: its centre is 10.5 in off."""
    cut = nc.cut(
        tape(
            *HEADER[2:3],
            "004 9 03000 03500 0 01 89",
            "005 0 18500 01000 0 00 80",
            "006 6 18500 03000 0 01 85",
        )
    )
    found = inspect(cut, StraightLine(8000, 0, 8000, 9000), cutter=40_000)
    said = "\n".join(inspection_report(found))
    assert "cutter    40.000 in; its centre went from 10.5000 right to 10.5000 right of nominal" in said
