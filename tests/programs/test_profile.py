"""A closed profile beside the edge that it was to have, by shapely."""

from collections.abc import Callable
from itertools import pairwise
from math import cos, pi, radians, sin, tau
from pathlib import Path

import pytest
from shapely import LineString, Polygon, unary_union
from shapely.geometry import Point

from programs import profile
from programs.milling import Milling
from tapes import ascii
from tapes.errors import WorkError
from tests.conftest import Shell
from tests.programs import printouts

CAMS: dict[str, tuple[Callable[[float], float], str]] = {
    "round": (lambda x: 1.5, "1.5"),
    "cam": (lambda x: 1.5 + 0.25 * cos(x), "1.5+0.25*cos(x)"),
    "three lobes": (lambda x: 1.5 + 0.2 * cos(3 * x), "1.5+0.2*cos(3*x)"),
}


@pytest.mark.parametrize(
    ("name", "side", "technique"),
    [
        *((name, side, "step") for name in CAMS for side in ("outside", "inside")),
        *(
            pytest.param(*each, "piece", marks=pytest.mark.slow("piece-wise technique, six seconds"))
            for each in (("three lobes", "outside"), ("cam", "inside"))
        ),
    ],
)
def test_the_path_keeps_to_its_band_and_closes(name: str, side: str, technique: str) -> None:
    radius, expression = CAMS[name]
    made = profile.part(expression, cutter=0.25, side=side, milling=Milling(technique))  # type: ignore[arg-type]
    way = [(block.x, block.y) for block in printouts.milled(made)]
    angles = [2 * pi * place / 7200 for place in range(7200)]
    edge = Polygon([(4000 + 1000 * radius(x) * cos(x), 4000 + 1000 * radius(x) * sin(x)) for x in angles])
    path = edge.buffer(125 if side == "outside" else -125, quad_segs=512).exterior
    assert max(path.distance(Point(place)) for place in way) < 5 + 1
    assert way[0] == way[-1]
    assert LineString(way).length > path.length
    if technique == "step":
        assert all(one[0] == other[0] or one[1] == other[1] for one, other in pairwise(way))


@pytest.mark.parametrize("side", ["outside", "inside"])
def test_the_wall_is_within_the_tolerance_of_the_edge(side: str) -> None:
    """What the cutter leaves of a part, or of a hole: its outline, everywhere."""
    radius, expression = CAMS["three lobes"]
    made = profile.part(expression, cutter=0.25, side=side, milling=Milling(stop="inside"))  # type: ignore[arg-type]
    way = [(block.x, block.y) for block in printouts.milled(made)]
    metal = unary_union([LineString(cut).buffer(125, quad_segs=256) for cut in pairwise(way)])
    angles = [2 * pi * place / 3600 for place in range(3600)]
    edge = Polygon([(4000 + 1000 * radius(x) * cos(x), 4000 + 1000 * radius(x) * sin(x)) for x in angles])
    assert isinstance(metal, Polygon)
    wall = metal.interiors[0] if side == "outside" else metal.exterior
    assert max(edge.exterior.distance(Point(place)) for place in wall.coords) < 5 + 0.05
    assert max(wall.distance(Point(place)) for place in edge.exterior.coords) < 5 + 0.05


@pytest.mark.parametrize(
    ("expression", "cutter", "why"),
    [
        ("1+x/10", None, "the profile is not closed: the radius is 1 at 0, 1.62832 at 2 pi"),
        ("1-2*cos(x)", None, "at x = 0.000 the radius is -1: it has to be above 0 and on the table"),
        ("1+abs(x-3)/(x-3)/4-cos(x)/9", None, "at x = 3.002 the radius jumps to"),
        (
            "0.3+0.25*cos(3*x)",
            1,
            "cutter of 1 in is too big: the profile bends more sharply, or is rough, at X",
        ),
        ("6", None, "leaves the table"),
    ],
)
def test_what_is_no_profile_is_refused(expression: str, cutter: float | None, why: str) -> None:
    with pytest.raises(WorkError, match=why):
        profile.part(expression, cutter=cutter)


def _around(number: int, at: Callable[[float], tuple[float, float]]) -> list[tuple[float, float]]:
    return [at(tau * place / number) for place in range(number)]


def _file(points: list[tuple[float, float]]) -> str:
    return "".join(f"{x:.6f}, {y:.6f}\n" for x, y in points)


ROUND = _around(72, lambda x: (1.5 * cos(x), 1.5 * sin(x)))
SLOT = [
    (middle + 0.5 * cos(radians(angle)), 0.5 * sin(radians(angle)))
    for middle, first in ((1, -90), (-1, 90))
    for angle in range(first, first + 181, 5)
]
BEAN = _around(240, lambda x: (1.7 * cos(x), 0.9 * sin(x) + 0.3 * cos(x) ** 2))
SQUARE = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)]
HEXAGON = _around(6, lambda x: (1.2 * cos(x + 0.2), 1.2 * sin(x + 0.2)))


@pytest.mark.parametrize(
    ("points", "side", "corner"),
    [
        (SLOT, "outside", 1.0),
        ([(y, x) for x, y in SLOT], "inside", 1.0),
        (list(reversed(BEAN)), "outside", 1.0),
        (BEAN, "inside", 1.0),
        (SQUARE, "outside", 2**0.5),
        (HEXAGON, "outside", 2 / 3**0.5),
    ],
)
def test_the_wall_of_an_outline_is_within_the_tolerance_of_its_straight_lines(
    points: list[tuple[float, float]], side: str, corner: float
) -> None:
    """Two walls, each within the tolerance, meet at a corner; its tip is that much further off."""
    made = profile.part(_file(points), cutter=0.25, side=side, milling=Milling(stop="inside"))  # type: ignore[arg-type]
    way = [(block.x, block.y) for block in printouts.milled(made)]
    metal = unary_union([LineString(cut).buffer(125, quad_segs=256) for cut in pairwise(way)])
    edge = Polygon([(4000 + 1000 * x, 4000 + 1000 * y) for x, y in points]).exterior
    assert isinstance(metal, Polygon)
    wall = max(metal.interiors, key=lambda ring: ring.length) if side == "outside" else metal.exterior
    assert max(edge.distance(Point(place)) for place in wall.coords) < 5 + 0.05
    places = edge.segmentize(3).coords
    assert max(wall.distance(Point(place)) for place in places) < 5 * corner + 0.05


def test_an_outline_without_a_cutter_is_the_path_wherever_its_points_begin() -> None:
    for points in (SQUARE, HEXAGON, SLOT, [*SLOT[50:], *SLOT[:51]]):
        way = [(block.x, block.y) for block in printouts.milled(profile.part(_file(points), centre_x=5))]
        edge = Polygon([(5000 + 1000 * x, 4000 + 1000 * y) for x, y in points]).exterior
        assert max(edge.distance(Point(place)) for place in way) < 5 + 1
        assert way[0] == way[-1]
        assert max(LineString(way).distance(Point(place)) for place in edge.segmentize(3).coords) < 6 * 2**0.5


def test_a_step_too_low_for_the_cutter_is_refused_wherever_its_points_begin() -> None:
    step = [(0.0, 0.0), (2.0, 0.0), (2.0, 1.0), (1.0, 1.0), (1.0, 1.03), (0.0, 1.03)]
    for first in (0, 2, 3, 4, 5):  # from 1 on its last side is too long to be left out
        with pytest.raises(WorkError, match="the profile bends more sharply, or is rough, at X"):
            profile.part(_file([*step[first:], *step[:first]]), cutter=0.25, milling=Milling())


@pytest.mark.parametrize(
    ("text", "cutter", "why"),
    [
        ("\n", None, "no points: x and y are needed on each line"),
        ("1,2\n", None, "a closed outline has three different points or more, not 1"),
        ("1,2\n2,3\n1,2\n", None, "three different points or more, not 2"),
        ("1,2\n2,a\n", None, "line 2: '2,a' is not x and y of a point"),
        ("1,2\nnan,2\n", None, "line 2: 'nan,2' is not finite"),
        ("0,0\n150,0\n0,150\n", None, "X 150 Y 0 is off the table: lengths are inches"),
        ("1,2\n" * 5001, None, "5,001 points: at most 5,000 are allowed"),
        (
            _file(ROUND[:60]),
            None,
            "the outline is open: its last point, X 0.6.* Y -1.3.*, is 1.612 in from its first",
        ),
        (_file(ROUND[::3]), None, "at X 1.5 Y 0 the points are too far apart: a curve .* is 0.0129 in off"),
        ("0,0\n2,0\n1,0.1\n", None, "the outline turns back at X 0 Y 0: by 174 degrees, 90 at most"),
        ("0,0\n1,1\n1,0\n0,1\n0,0\n", None, "the outline turns back at X 1 Y 1: by 135 degrees, 90 at most"),
        (
            _file(_around(200, lambda x: (2 * sin(x), sin(2 * x)))),
            None,
            "the outline crosses or touches itself",
        ),
        (
            _file(_around(400, lambda x: (1.5 * cos(x), 1.5 * sin(x) + 0.001 * cos(200 * x)))),
            None,
            "the outline is rough at X .*: along Y it turns back by 0.00.* in; less than 0.012 is too little",
        ),
        (_file(SQUARE), 4, "cutter of 4 in is too big: the profile bends more sharply"),
        (
            _file(HEXAGON[:1] + HEXAGON),
            0.25,
            "cutter of 0.25 in is too big: it leaves 0.019 in in the corner",
        ),
    ],
)
def test_what_is_no_outline_is_refused(text: str, cutter: float | None, why: str) -> None:
    with pytest.raises(WorkError, match=why):
        profile.part(text, cutter=cutter, side="inside")


def test_a_cutter_does_not_pass_a_gap_that_is_too_narrow() -> None:
    """A waist between two rounds, 1 in wide: each bend is wide enough, the gap is not."""
    waist = _file(_around(360, lambda x: ((1.5 * cos(x)), sin(x) * (0.14 + 0.8 * cos(x) ** 2))))
    profile.part(waist, cutter=0.25, side="inside")
    with pytest.raises(WorkError, match=r"cutter of 0.5 in is too big: its path crosses itself at X 3"):
        profile.part(waist, cutter=0.5, side="inside")


def test_the_command_takes_a_file_in_place_of_an_expression(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, shell: Shell
) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "slot.csv").write_bytes(b"\xef\xbb\xbf" + _file(SLOT).replace("\n", "\r\n").encode())
    made = ascii.encode(profile.part(_file(SLOT), cutter=0.25))
    assert shell("pdp8 part profile slot.csv --cutter 0.25").stdout == made
    assert shell("pdp8 part profile - --cutter 0.25", _file(SLOT).encode()).stdout == made
    (tmp_path / "one.txt").write_text("1 1")
    (tmp_path / "folder.csv").mkdir()
    for name, why in (
        ("one.txt", "one.txt: a closed outline has three different points or more, not 1"),
        ("folder.csv", "folder.csv: Is a directory"),
        ("none.csv", "none.csv: no such file, here or among the bundled ones"),
        ("x+", "column 3: the end is not an expression in x"),
    ):
        done = shell(f"pdp8 part profile {name}")
        assert done.returncode == 1
        assert why in done.stderr.decode()
