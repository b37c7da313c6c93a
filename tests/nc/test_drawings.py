"""The drawings: to scale, in inches, nothing clipped, and the metal drawn is the metal cut."""

import re
from collections.abc import Callable
from dataclasses import replace
from functools import cache
from math import dist
from xml.etree import ElementTree as ET

import numpy as np
import pytest

import nc
from nc.curves import Curve, Ellipse, Graph, StraightLine
from nc.drawing import Sheet, View, Window, round_step
from nc.inspection import _PLACES, Inspection, Walls, _readings, followed, inspect
from nc.plot import plot
from nc.talyrond import _Graph, talyrond
from nc.talysurf import talysurf
from nc.unit import INCH, MM
from pdp8 import shelf
from tapes.errors import WorkError
from tests.nc.tapes_1971 import CIRCLE, FOUR_HOLES, HEADER, milled, milling, staircase, tape
from tests.pictures import assert_looked_at, pixels

SVG = "{http://www.w3.org/2000/svg}"
THE_CIRCLE = Ellipse(4000, 4000, 1750, 1750)


def elements(drawing: str, tag: str) -> list[ET.Element]:
    return list(ET.fromstring(drawing).iter(SVG + tag))


def words(drawing: str) -> list[str]:
    return [str(text.text) for text in elements(drawing, "text")]


@cache
def circle() -> nc.Path:
    return nc.cut(CIRCLE)


@cache
def ellipse() -> nc.Path:
    return nc.cut(shelf.read("ellipse.eia"))


SLOPE = StraightLine(2250, 4000, 2318, 4030)


def slope() -> nc.Path:
    """Return steps as far apart as two numbers at 10:1 have to be."""
    return milled((2250, 4013), (2284, 4013), (2284, 4026), (2318, 4026))


PARABOLA = Graph(4600, 5000, "x*x/4 - .3", -1.6, 1.6)


@cache
def parabola() -> nc.Path:
    """Return steps of .2 in, each begun on the parabola."""
    starts = [(x, round(5000 + (x - 4600) ** 2 / 4000 - 300)) for x in range(3000, 6201, 200)]
    corners = [corner for x, y in starts for corner in ((x, y), (x + 200, y))][:-1]
    return nc.cut(tape(*HEADER[:4], "005 0 03000 05000 0 00 80", HEADER[5], *milling(corners, (3000, 5000))))


def half() -> nc.Path:
    return milled(*staircase(1750, 5)[:330])


def parked(x: int, y: int) -> nc.Path:
    """Return a path that goes to one place and mills nothing."""
    return nc.cut(tape(f"001 0 {x:05} {y:05} 0 00 02"))


LONG_WORDS = tape("001 9 01000 02000 0 18 89", "002 9 01000 02000 0 00 81", "003 8 19000 09000 0 00 00")

DRAWINGS: dict[str, tuple[str, Callable[[], str]]] = {
    "circle": ("9872bc2b", lambda: plot(circle(), THE_CIRCLE)),
    "circle, block 120": ("bf7f47f6", lambda: plot(circle(), THE_CIRCLE, block=120)),
    "block 1": ("13ee1b07", lambda: plot(circle(), THE_CIRCLE, block=1, close_at=(5750, 4000), zoom=(5, 5))),
    "stretched": ("eea7ae47", lambda: plot(circle(), THE_CIRCLE, close_at=(4000, 5735), zoom=(1.5, 15))),
    "slope": ("f22fd575", lambda: plot(slope(), SLOPE)),
    "function of x": ("30516243", lambda: plot(parabola(), PARABOLA, block=20, cutter=400, tolerance=100)),
    "ellipse": ("a5554b20", lambda: plot(ellipse(), Ellipse(4000, 4000, 3000, 2250))),
    "four holes": ("22742d1f", lambda: plot(nc.cut(tape(*FOUR_HOLES)))),
    "long words": ("23d32c07", lambda: plot(nc.cut(LONG_WORDS))),
    "one position": ("3e68bd59", lambda: plot(parked(20000, 10000))),
    "all of the room at 4:1": ("a7095927", lambda: plot(parked(900, 650))),
    "the largest cutter": ("96ba5a8a", lambda: plot(parked(20000, 10000), cutter=10_000)),
    "double size": ("a752b343", lambda: plot(parked(2000, 1000))),
    "half size": ("780bdce9", lambda: plot(parked(13000, 9000))),
    "talyrond, circle": ("a277a7e0", lambda: talyrond(inspect(circle()))),
    "talyrond, ellipse": ("ea043e42", lambda: talyrond(inspect(ellipse()))),
    "talyrond, half": ("db41bbfa", lambda: talyrond(inspect(half(), THE_CIRCLE))),
    "talysurf, circle": ("cc3f5b0d", lambda: talysurf(inspect(circle()))),
    "talysurf, slope": ("c9baca42", lambda: talysurf(inspect(slope(), SLOPE))),
    "talysurf, shaded": ("0689f829", lambda: talysurf(inspect(circle()), (7500, 8900), background=1.2)),
    "talysurf, rough": ("b4024760", lambda: talysurf(inspect(parabola(), PARABOLA, 250), (520, 790), 1.2)),
}
"""Each drawing, with the digest of what was looked at by eye; Figures 7.2 to 7.8 are lost in the scan."""


@pytest.mark.parametrize("name", DRAWINGS)
def test_a_drawing_is_the_one_that_was_looked_at(name: str) -> None:
    digest, drawn = DRAWINGS[name]
    assert_looked_at(name, drawn(), digest)


def test_an_axis_is_marked_within_the_drawing() -> None:
    for x in (4333, 4710):
        drawn = plot(parabola(), Graph(x, 5000, "x*x/4 - .3", -1.6, 1.6), cutter=400, tolerance=100)
        marks = re.findall(r'<text x="([-\d.]+)"[^>]*font-size="10"[^>]*>-?\d<', drawn)
        assert 60 < min(map(float, marks)) < max(map(float, marks)) < 780


def test_the_halo_of_a_label_hides_none_of_its_letters() -> None:
    """CairoSVG makes as many dark pixels of both: it does not know paint-order."""
    dark = []
    for write in (Sheet.text, Sheet.label):
        sheet = Sheet(200, 100, "label")
        write(sheet, 20, 60, "YES C D E", font_size=24)
        dark.append(sum(pixels(sheet.svg()).histogram()[:128]))
    assert dark[0] == dark[1] > 100


def test_what_does_not_close_says_how_far_it_is_open() -> None:
    said = " ".join(words(plot(half(), THE_CIRCLE, tolerance=600)))
    gap = dist(staircase(1750, 5)[329], (2250, 4000)) / 1000
    assert f"the contour ends {gap:.3f} in from its start" in said
    assert "band ±0.600 in about" in said
    fine = " ".join(words(plot(half(), THE_CIRCLE, tolerance=0.2, cutter=62.5)))
    assert "cutter 0.0625 in" in fine
    assert "band ±0.0002 in about" in fine
    assert "guessed" not in said
    assert ", guessed from the path" in " ".join(words(plot(circle(), followed(circle(), 5))))


def test_a_window_holds_its_corners_and_nothing_beyond() -> None:
    held = [(x, y) for x in range(-1, 4) for y in range(-1, 3) if Window(0, 0, 2, 1).holds(x, y)]
    assert held == [(x, y) for x in (0, 1, 2) for y in (0, 1)]
    met = [
        (x, y)
        for x in range(-3, 5)
        for y in range(-3, 4)
        if Window(0, 0, 2, 1).meets(Window(x, y, x + 1, y + 1))
    ]
    assert met == [(x, y) for x in range(-1, 3) for y in range(-1, 2)]


def walled(curve: Curve, outer: float) -> Inspection:
    """Return an inspection of a curve whose outer wall is so far out, and whose inner one is nominal."""
    walls = Walls(curve.stations(2), np.full(2, float(outer)), np.zeros(2))
    return replace(inspect(slope(), SLOPE), curve=curve, walls=walls, cutter=5000)


@pytest.mark.parametrize("beside", [0.0, 250.0, -250.0])
def test_a_talyrond_names_each_wall_and_place_that_is_measured(beside: float) -> None:
    curve = Ellipse(4000, 4000, 1750, 1750, beside)
    measured = Walls(curve.stations(360), np.zeros(360), np.ones(360), curve.part_wall)
    found = replace(walled(curve, 1), walls=measured, readings=tuple(_readings(curve, measured)))
    said, places = words(talyrond(found)), [name for name, *_ in _PLACES]
    assert [word for word in said if word.endswith(" wall")] == [f"{wall} wall" for wall in measured.by_name]
    assert [word for word in said if word in places] == places
    uncut = replace(measured, inner=np.full(360, np.nan), part_wall="")
    assert "no inner wall" in words(talysurf(replace(found, walls=uncut)))


@pytest.mark.slow("measures some parts")
def test_the_talyrond_magnifies_as_much_as_its_divisions_leave_room_for() -> None:
    """100 times in Figure 7.2."""
    said = "cutter 5.000 in · radial magnification 100, centre suppressed · small division .001 in"
    assert said in talyrond(walled(THE_CIRCLE, 25))
    for divisions, times in zip(
        (25, 30, 50, 55, 130, 135, 260, 265, 520, 525, 1300, 1305, 2605),
        (100, 50, 50, 20, 20, 10, 10, 5, 5, 2, 2, 1, 1),
        strict=True,
    ):
        graph = _Graph(walled(THE_CIRCLE, divisions), "", INCH)
        assert (graph.magnification, graph.rim) == (times, 45 + divisions * times / 10), divisions


def test_a_graph_in_millimetres_has_a_scale_of_them() -> None:
    """.1 mm at 100 times is 10 mm of paper; 25.4 mm of a wall are all of the trace."""
    for drawing, one, other, apart in (
        (talyrond(walled(THE_CIRCLE, 20), unit=MM), "0", "+0.100", 1000 / 25.4),
        (talysurf(walled(StraightLine(0, 0, 1000, 0), 1), unit=MM), "2.00", "20.00", 660 * 18 / 25.4),
    ):
        texts = elements(drawing, "text")
        at = {f"{each.text}": (float(each.attrib["x"]), float(each.attrib["y"])) for each in texts}
        assert dist(at[one], at[other]) == pytest.approx(apart, abs=0.02)
        assert not re.search(r"\d in\b|inch", " ".join(at))


def test_the_figures_of_a_scale_have_room() -> None:
    """.45 in of paper to each; along a Talysurf .48, and .04 to a light line."""
    assert [*map(round_step, (1, 1.1, 2, 2.1, 5, 5.1, 10, 11, 450))] == [1, 2, 2, 5, 5, 10, 10, 20, 500]
    for scale, figure in ((0.09, "5.0"), (4.5, "0.1"), (45, "0.01"), (450, "0.001")):
        sheet = Sheet(100, 100, "scale")
        View(sheet, 0, 0, Window(0, 0, 450 / scale, 450 / scale), (scale, scale))
        zero = f"{0:.{len(figure) - 2}f}"
        assert words(sheet.svg()) == [zero, figure, zero, figure, "X, inches", "Y, inches"]
    for length, figure in ((137, "0.01"), (138, "0.02"), (1650, "0.20"), (1651, "0.20")):
        drawing = talysurf(walled(StraightLine(0, 0, length, 0), 1))
        assert re.findall(r'middle">([\d.]+)<', drawing)[1] == figure
        assert ('stroke-width="0.6"' in drawing) == (length <= 1650)


def test_work_that_an_instrument_does_not_take() -> None:
    for block in (0, 667):
        with pytest.raises(WorkError, match=f"block {block}: the tape has blocks 1 to 666"):
            plot(circle(), block=block)
    with pytest.raises(WorkError, match="use the Talysurf"):
        talyrond(inspect(slope(), SLOPE))
    found = walled(StraightLine(0, 0, 2000, 0), 1)
    for stretch, said in (((3000, 3100), r"from 3\.000 to 3\.100"), ((0, 1999), r"from 0\.000 to 1\.999")):
        with pytest.raises(WorkError, match=rf"stretch {said}: the curve runs from 0 to 2\.000 in"):
            talysurf(found, stretch)
    assert talysurf(found, (0, 2000)).startswith("<svg"), "two stations"


def test_a_hole_is_removed_metal_once_it_is_drilled() -> None:
    """Two of the four after the third block: filled in both views; the later ones are not."""
    path = nc.cut(tape(*FOUR_HOLES))
    second = [step.number for step in path.steps if step.block.preparatory == 5][1]
    filled = [circle.get("fill") for circle in elements(plot(path, block=second), "circle")]
    assert filled.count("#dfe3e8") == 3  # two on the part, and the second again in the close view
    assert {*filled} == {"#dfe3e8", "none"}
    assert [float(circle.get("r", "0")) for circle in elements(plot(path), "circle")].count(250) == 2
