"""A closed profile beside the edge that it was to have, by shapely."""

from collections.abc import Callable
from itertools import pairwise
from math import cos, pi, sin

import pytest
from shapely import LineString, Polygon, unary_union
from shapely.geometry import Point

from programs import profile
from programs.milling import Milling
from tapes.errors import WorkError
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
        ("0.3+0.25*cos(3*x)", 1, "cutter of 1 in is too big: the profile bends closer at X"),
        ("6", None, "leaves the table"),
    ],
)
def test_what_is_no_profile_is_refused(expression: str, cutter: float | None, why: str) -> None:
    with pytest.raises(WorkError, match=why):
        profile.part(expression, cutter=cutter)
