"""What `pdp8 thesis make` leaves: whole sheets, texts with captions, a page that needs nothing else."""

import re
from collections.abc import Callable, Iterator
from itertools import combinations
from math import dist
from xml.etree import ElementTree as ET

import pytest
from shapely.affinity import scale
from shapely.geometry import LineString, Polygon

import nc
from nc.inspection import inspect
from pdp8 import shelf
from pdp8.thesis import chain, codes, diagrams, gallery, listings, slopes, work
from pdp8.thesis.catalogue import Item, catalogue, find
from pdp8.thesis.making import Made, make
from pdp8.thesis.supplied import marked
from programs import fluidic
from programs.die import AXES
from tapes import eia
from tapes.quantities import inches
from tapes.text import lines_of
from tests.pictures import pixels

SVG = "{http://www.w3.org/2000/svg}"
DRAWN = [item for item in catalogue() if item.maker and item.kind == "figure"]
WRITTEN = [item for item in catalogue() if item.maker and item.kind != "figure"]


def texts(svg: str) -> Iterator[str]:
    """Yield what is written; a halo is drawn apart, and is not to be read."""
    for element in ET.fromstring(svg).iter(f"{SVG}text"):
        if "aria-hidden" not in element.attrib:
            yield element.text or ""


def places(path: ET.Element) -> list[tuple[float, ...]]:
    """Return the corners of an SVG path, or nothing of what is none."""
    return [tuple(map(float, at.split())) for at in path.get("d", "").strip("MZ").split("L") if at]


@pytest.fixture(scope="module")
def everything() -> dict[str, Made]:
    """Everything made: about 7 s, most of it inspections and plots."""
    return {item.number: make(item) for item in catalogue() if item.maker}


@pytest.mark.parametrize("item", DRAWN, ids=lambda item: item.number)
def test_a_figure_is_a_sheet_with_title_description_and_caption(
    item: Item, everything: dict[str, Made]
) -> None:
    made = everything[item.number]
    assert made.name == f"figure-{item.number}.svg"
    root = ET.fromstring(made.text)
    assert root.findtext(f"{SVG}title") == f"{item.name.upper()}: {item.title}"
    assert item.note in (root.findtext(f"{SVG}desc") or "")
    assert f"{item.name.upper()}  {item.title}" in list(texts(made.text))
    assert len(root.findall(f".//{SVG}title")) == 1
    assert "nan" not in made.text
    identifiers = re.findall(r'\bid="([^"]+)"', made.text)
    assert len(identifiers) == len(set(identifiers))
    assert set(re.findall(r"url\(#([^)]+)\)", made.text)) <= set(identifiers)


@pytest.mark.parametrize("item", WRITTEN, ids=lambda item: item.number)
def test_a_text_has_its_caption(item: Item, everything: dict[str, Made]) -> None:
    made = everything[item.number]
    first, second, *rest = made.text.splitlines()
    assert first == f"{item.name.upper()}  {item.title}"
    assert item.note in second
    assert len(rest) > 3


def test_the_page_shows_every_item_and_needs_nothing_else(everything: dict[str, Made]) -> None:
    text = gallery.page(everything)
    found = re.findall(r'\bid="([^"]+)"', text)
    assert {f"{item.kind}-{item.number}" for item in catalogue()} <= set(found)
    assert len(found) == len(set(found))
    links = set(re.findall(r'\bhref="([^"]+)"', text))
    files = [name for made in everything.values() for name, _ in made.files]
    assert sorted(link for link in links if not link.startswith("#")) == sorted(files)
    assert {link[1:] for link in links if link.startswith("#")} <= set(found)
    pictures = re.findall(r'<img src="data:image/svg\+xml;base64,[^"]+" alt="[^"]+">', text)
    assert len(pictures) == text.count("<img") == len(DRAWN)
    assert not re.search("<(?:script|link)|{{", text)
    written = [made.text for made in everything.values() if not (made.is_drawn or made.table)]
    shown = re.findall(r"<pre[^>]*>(.*?)</pre>(?:<p>(\d+) more)?", text, re.DOTALL)
    lines = [each.count("\n") + 1 + int(more or 0) for each, more in shown]
    assert lines == [len(lines_of(each)) - 3 for each in written]


@pytest.mark.parametrize(
    ("figure", "said"),
    [
        (slopes.wrong_slope, ["1.9 / 1.0 = 1.90: 27.8°", "4.0 / 2.7 = 1.48: 34.0°"]),
        (diagrams.element, ["POWER CHANNEL", "CONTROL CHANNEL", "VENT", "OUTPUT CHANNEL"]),
        (work.straight_surface, ["outer wall, trough to peak .0000 in"]),
    ],
    ids=["3.1", "8.1", "8.4"],
)
def test_a_figure_says_what_the_chapter_does(figure: Callable[[], str], said: list[str]) -> None:
    words = " ".join(texts(figure()))
    assert [each for each in said if each not in words] == []


@pytest.mark.parametrize(
    ("figure", "stops"), [(slopes.piecewise, "ACDEFB"), (slopes.stepwise, "ACDEFGHB")], ids=["3.2", "3.3"]
)
def test_the_stops_are_those_the_chapter_names(figure: Callable[[], str], stops: str) -> None:
    named = [text for text in texts(figure()) if re.fullmatch("[A-H]", text)]
    assert sorted(named) == sorted(stops)


def test_figures_3_2_and_3_3_share_one_band_and_no_two_stops_of_them_meet() -> None:
    """\"The same slope ... with the same tolerance band\"; stops are at least a tenth of an inch apart."""
    bands = []
    for figure in (slopes.piecewise, slopes.stepwise):
        root = ET.fromstring(figure())
        bands.append([each.get("d") for each in root.iter(f"{SVG}path") if each.get("stroke") == "#2e7d32"])
        dots = [(float(each.get("cx", 0)), float(each.get("cy", 0))) for each in root.iter(f"{SVG}circle")]
        assert min(dist(*pair) for pair in combinations(set(dots), 2)) >= 10
    assert bands[0] == bands[1]


def test_the_codes_and_constants_of_figure_5_3_are_those_stored_in_appendix_b() -> None:
    definitions = shelf.read("eia.pal").decode().partition("/DEFINITIONS:")[2]
    stored = [int(word, 8) for word in re.findall(r"^P(?:\d|CR),\t(\d+)", definitions, re.MULTILINE)]
    constants = re.findall(r"^M(?:[1-9]|SP|CR),\t(-?\d+)", definitions, re.MULTILINE)
    chart = diagrams.drawn("5.3")
    drawn = [int(code, 8) for code in re.findall(r"new code (\d{3})", chart)]
    assert drawn == [*stored[:10], stored[0], stored[10]]
    assert re.findall(r"add (-?\d+), zero", chart) == constants


def test_the_limits_of_figure_6_1_are_those_of_the_listing() -> None:
    listing = listings.source("circle.for")
    for limit in re.findall(r"R [≥≤] (\d+)", diagrams.drawn("6.1")):
        assert f"={limit}." in listing


def test_the_constants_of_figure_6_1_that_the_scan_has_lost_have_another_colour() -> None:
    lost = {
        name
        for row, flags in marked("circle.for")
        if any(flags)
        for name in re.findall(r"(\w+)=\d", row.ours)
    }
    assert lost >= {"AS", "AP", "AX", "ARL"}
    written = ET.fromstring(diagrams.drawn("6.1")).iter(f"{SVG}text")
    coloured = [each.text for each in written if each.get("fill") == "#9a1f6a"]
    assert coloured == ["AS=7, AP=6, AT=1,", "AX=1750, AY=0", *["R ≥ 1755?"] * 4]


def test_figure_5_4_is_one_block_before_and_after() -> None:
    before, after = codes.before_and_after()
    assert (before.count("RUBOUT"), after.count("EOB")) == (6, 1)


def test_the_two_circles_of_figure_7_2_are_cut_by_the_same_tape() -> None:
    """Each stop lies within .0003 in of the tape's, the machine's precision; the circles are not the same."""
    tape = chain.path("circle", close=True)
    stops = [[(move.end.x, move.end.y) for move in work.cut_again(tape, seed).cuts] for seed in (1, 2)]
    assert stops[0] != stops[1]
    for circle in stops:
        for move, (x, y) in zip(tape.cuts, circle, strict=True):
            assert max(abs(x - move.end.x), abs(y - move.end.y)) <= 0.3 + 1e-9
    first, second = (" ".join(texts(graph)) for graph in work.polar_graphs())
    assert first.startswith("First circle: circle")
    assert second.startswith("Second circle, same tape: circle")
    for said in (first, second):
        worst = re.search(r"worst trough to peak (\.\d+) in", said)
        assert worst
        assert 0.0100 < float(worst[1]) < 0.0112  # not the .0173 of a contour that stays open


def test_the_figures_of_the_note_on_the_polar_graphs() -> None:
    for close, worst in ((False, ".0173"), (True, ".0106")):
        assert inches(inspect(chain.path("circle", close=close)).worst.trough_to_peak) == worst
        assert worst in find("7.2").note


def test_the_outline_of_figure_8_1_lies_half_a_cutter_outside_of_the_path() -> None:
    """Shapely's buffer of the path against CairoSVG's pixels: dark along its boundary, light beside it."""
    right = Polygon([at for segment in fluidic.channel(0) for at in diagrams._points(segment)])
    main = Polygon([at for segment in fluidic.outline() for at in diagrams._points(segment)])
    centre = main.union(right).union(scale(right, -1, 1, origin=(0, 0)))
    cavity = centre.buffer(62.5, quad_segs=64)
    left, bottom, right_end, top = cavity.bounds
    assert (round(right_end - left), round(top - bottom)) == (10001, 9563)
    nozzle = cavity.intersection(LineString([(-500, 2050), (500, 2050)]))
    assert nozzle.length == pytest.approx(201, abs=0.5)  # .020 x 10, to .001 of the cutter's path
    svg = diagrams.element()
    width = 4 * float(ET.fromstring(svg).get("viewBox", "").split()[2])
    picture, frame = pixels(svg, round(width)), centre.buffer(500).bounds

    def dark(shape: Polygon) -> float:
        """Return how much of a shape's boundary, at 70 units of paper an inch, is drawn in ink."""
        places = [shape.exterior.interpolate(at) for at in range(0, int(shape.exterior.length), 50)]
        greys = [
            picture.getpixel(
                (int(4 * (70 + (at.x - frame[0]) * 0.07)), int(4 * (16 + (frame[3] - at.y) * 0.07)))
            )
            for at in places
        ]
        return sum(isinstance(grey, int) and grey < 100 for grey in greys) / len(greys)

    assert dark(cavity.buffer(10)) > 0.99
    assert dark(cavity.buffer(-20)) < 0.01
    assert dark(cavity.buffer(40)) < 0.01


def test_the_die_s_block_and_opening_are_to_scale() -> None:
    """Half size: the block 12 x 8 in is 600 x 400, 2 in thick 100; the path 6 x 3, the hole 1/2 in wider."""
    root = ET.fromstring(diagrams.drawn("7.4"))
    sizes = [(float(box.get("width", 0)), float(box.get("height", 0))) for box in root.iter(f"{SVG}rect")]
    assert (600, 400) in sizes
    assert (600, 100) in sizes
    axes = {(float(e.get("rx", 0)), float(e.get("ry", 0))) for e in root.iter(f"{SVG}ellipse")}
    assert {(150, 75), (162.5, 87.5)} <= axes
    assert {(a / 20, b / 20) for a, b in AXES.values()} <= axes
    assert (len(chain.path("die")), len(chain.path("die", major=2750, minor=1250))) == (778, 674)
    assert "778 blocks" in find("7.4").note
    assert "674" in find("7.4").note


def test_the_axes_of_figure_7_5_cross_where_the_curve_does() -> None:
    """The curve's zeros, .2 x (x-2) (x-6), lie on the axis where its marks say 0, 2 and 6."""
    root = ET.fromstring(work.part(**find("7.5").given))
    half = 50  # units of paper an inch, at 1:2
    part = next(group for group in root.iter(f"{SVG}g"))
    marks = {
        t.text: float(t.get("x", 0)) - 3 for t in part.iter(f"{SVG}text") if "aria-hidden" not in t.attrib
    }
    assert marks["2"] - marks["0"] == pytest.approx(2 * half)
    assert marks["6"] - marks["0"] == pytest.approx(6 * half)
    axis = next(float(t.get("y", 0)) - 13 for t in part.iter(f"{SVG}text") if t.text == "0")
    lines = list(map(places, part))
    level = {line[0][1] for line in lines if len(line) == 2 and line[0][1] == line[1][1]}
    upright = {line[0][0] for line in lines if len(line) == 2 and line[0][0] == line[1][0]}
    assert min(abs(y - axis) for y in level) < 0.1
    assert min(abs(x - marks["0"]) for x in upright) < 0.1
    path = max(lines, key=len)
    for mark in ("0", "2", "6"):
        assert min(max(abs(x - marks[mark]), abs(y - axis)) for x, y in path) < 1.5


@pytest.mark.parametrize("figure", [work.straight_surface, work.sloped_surface], ids=["8.4", "8.5"])
def test_the_background_of_the_talysurf_is_0012_high(figure: Callable[[], str]) -> None:
    """Its height on paper against the scale beside it, where a line is .001 in."""
    root = ET.fromstring(figure())
    shaded = [places(path) for path in root.iter(f"{SVG}path") if path.get("fill-opacity")]
    lines = list(root.iter(f"{SVG}line"))
    level = sorted({float(line.get("y1", 0)) for line in lines if line.get("y1") == line.get("y2")})
    assert len(shaded) == 2
    for (left, top), *_, (end, bottom) in shaded:
        assert left == end
        assert bottom - top == pytest.approx(1.2 * (level[1] - level[0]), abs=0.05)
    across = sorted({float(line.get("x1", 0)) for line in lines if line.get("stroke-width") == "0.6"})
    assert across[1] - across[0] == pytest.approx(660 * 0.01 / 0.5, abs=0.02)  # "+ 0.01"/div."


def test_the_die_s_tape_is_its_three_tapes() -> None:
    tape = work.die_tape()
    assert tape.count(eia.EOB) == listings.die().count("\n")
    assert len(tape) == 20 * tape.count(eia.EOB)
    assert nc.cut(tape).gap > 0
