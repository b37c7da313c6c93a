"""The page that teaches the method: its numbers are Python's, and every control of it changes its figure."""

import re
from collections.abc import Iterator
from itertools import pairwise
from pathlib import Path
from typing import Any
from urllib.parse import urlsplit

import numpy as np
import pytest

import pal
from nc.curves import Ellipse
from nc.inspection import inspect
from nc.path import Position
from pdp8 import shelf
from pdp8.thesis import chain
from pdp8.web import curve, method, workbench
from programs import drawn
from tapes import ascii, eia
from tests.pdp8.web.browsing import (
    AXE,
    Browser,
    Locator,
    Page,
    click,
    needs_axe,
    serious,
    settled,
    until,
    visit,
)
from tests.pdp8.web.node import in_node, needs_node, plain

_COMPUTED = """async ([words, line]) => {
  const method = await import("@/pdp8/web/method.mjs");
  const { walls } = await import("@/pdp8/web/curve/walls.mjs");
  const { way } = method.circle(5);
  const { outer, inner } = walls(way, { x: 4000, y: 4000, radius: 1750 }, 500, 0, 2 * Math.PI, 3600);
  const shapes = [method.circle(3, true), method.slope(7, 0.2, -0.2), method.quarter(10, 3)];
  shapes.push(method.drawn([5000, 5400, 5300, 5700], 30));
  return [shapes, method.characters(words, line), outer, inner];
}"""
_WORDS = list(pal.assemble(shelf.read_bundled("eia.pal")).words.items())
_LINE = "  76 2250 4133  185\n"


@pytest.mark.slow("computes each figure in both languages")
@needs_node
def test_the_page_computes_what_python_does() -> None:
    """Printouts, minutes, ways, characters; each station of both walls to a millionth of a thousandth."""
    made, characters, *walls = in_node(_COMPUTED, [_WORDS, list(ascii.encode(_LINE))])
    shapes = (
        method.circle(3, close=True),
        method.slope(7, 0.2, -0.2),
        method.quarter(10, 3),
        method.drawn([5000, 5400, 5300, 5700], 30),
    )
    assert made == plain(shapes)
    assert characters == plain(method.characters(_WORDS, ascii.encode(_LINE)))
    found = inspect(chain.path("circle"), Ellipse(4000, 4000, 1750, 1750), tolerance=5).walls
    every = len(found.stations) // 3600
    for there, here in zip(walls, (found.outer, found.inner), strict=True):
        assert np.allclose(there, here[::every], rtol=0, atol=1e-6)


def test_its_numbers_are_those_of_the_thesis() -> None:
    """The very printout of Appendix C, 666 blocks in 35.9 minutes; the frames of one; the last cuts.

    408 blocks by steps, none of which moves when the feeds are wrong; half the band, twice the blocks.
    """
    circle, closed = method.circle(5), method.circle(5, close=True)
    assert circle.text == chain.printout("circle")
    assert (circle.blocks, round(circle.minutes, 1)) == (666, 35.9)
    assert closed.way[-1][:2] == closed.way[0][:2] == (2250, 4000)
    frames = [each.punched for each in method.characters(_WORDS, ascii.encode(_LINE))]
    assert bytes(each for each in frames if each is not None) == eia.encode(_LINE.replace(" ", "0"))
    exact, wrong = method.slope(5), method.slope(5, 0.2, -0.2)
    assert exact.blocks - 6 == 408
    assert wrong.way == exact.way
    assert wrong.minutes != exact.minutes
    tape = list(shelf.read_bundled("slope-fewest.eia"))
    fewest = [method.fewest(tape, error, -error) for error in (-0.2, 0, 0.2)]
    assert {len(each.stops) for each in fewest} == {133}  # proved in tests/programs
    assert all(abs(_off(place)) <= 5 * 5000 for each in fewest for place in each.way)
    assert method.slope(10).blocks - 6 == 210
    fine, coarse = method.quarter(5, 3), method.quarter(10, 3)
    assert 1.8 < (fine.blocks - 6) / (coarse.blocks - 6) < 2


def test_wrong_feeds_are_those_of_their_own_axes() -> None:
    """X 20 % fast arrives before Y does, and leaves the slope below it; Y fast leaves it above."""
    for x_error, y_error, below in ((0.2, 0.0, True), (0.0, 0.2, False)):
        corner = method.pieces(1, 3, 2, x_error, y_error).way[1]
        exact = method.pieces(1, 3, 2, 0.0, 0.0).way[1]
        assert (_off(corner) < _off(exact)) == below


def test_what_a_tolerance_promises_and_what_it_gives() -> None:
    """No wall of the closed circle is further off than the band and .001; .006 gives less than .005."""
    spans = {}
    for tolerance in (3, 5, 6, 10):
        path = method.circle(tolerance, close=True).path
        found = inspect(path, Ellipse(4000, 4000, 1750, 1750), tolerance=tolerance)
        errors = np.concatenate([found.walls.outer, found.walls.inner])
        assert tolerance < np.abs(errors).max() <= tolerance + 1
        spans[tolerance] = float(np.ptp(found.walls.outer))
    assert [round(spans[tolerance], 1) for tolerance in (5, 6)] == [10.6, 8.6]  # a model that is not ours


_PROMISED = """async ([tolerances, cutters]) => {
  const method = await import("@/pdp8/web/method.mjs");
  const { walls } = await import("@/pdp8/web/curve/walls.mjs");
  return tolerances.map((tolerance) => cutters.map((cutter) => {
    const { way } = method.quarter(tolerance, 1);
    const circle = { x: 4000, y: 4000, radius: 1750 };
    const { outer, inner } = walls(way, circle, (cutter * 1000) / 16, Math.PI, -Math.PI / 2, 1800);
    return Math.max(...[...outer, ...inner].map((error) => Math.abs(error) || 0));
  }));
}"""


@needs_node
def test_the_figure_never_shows_more_than_is_promised() -> None:
    tolerances = [*range(1, 11), 15, 20, 30, 50]
    for tolerance, furthest in zip(tolerances, in_node(_PROMISED, [tolerances, [1, 4, 8, 16]]), strict=True):
        assert max(furthest) <= tolerance + 1


def test_the_ellipse_s_times_are_as_told() -> None:
    times = chain.path("ellipse").contour
    assert (round(times.reading / 60, 1), round(times.milling / 60, 1)) == (32.3, 3.8)
    assert round(100 * times.efficiency) == 11


_TYPED = """["heights", "tolerance"].map((name) =>
  document.querySelector(`#part-options [name=${name}]`).value)"""


_SLIDERS = """[...document.querySelectorAll(".live label:not(.held) [type=range]")].map(
  (input) => [input.closest("figure").id, input.name])"""


def _off(place: Position) -> float:
    return (place.y - 4000) * 4330 - (place.x - 4000) * 2500


@pytest.fixture(scope="module")
def page(browser: Browser, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Page]:
    """The page in Chromium, on a phone; it is under 400 kB."""
    html = curve.page()
    assert len(html) < 400_000
    file = tmp_path_factory.mktemp("curve") / "curve.html"
    file.write_text(html, encoding="utf-8")
    with visit(browser, file.as_uri(), "globalThis.curve", viewport={"width": 390, "height": 800}) as page:
        yield page


def test_a_figure_is_computed_when_it_comes_near(page: Page) -> None:
    said = "[...document.querySelectorAll('.said')].map((each) => each.textContent)"
    drawn = page.evaluate(said)
    assert drawn[-1] == ""  # nobody has been there
    page.locator("#own").scroll_into_view_if_needed()
    until(page, f"{said}.at(-1)")
    page.evaluate("Object.values(curve.figures).forEach((figure) => figure.now())")
    assert all(page.evaluate(said))


@pytest.mark.parametrize(
    ("figure", "name", "by"),
    [
        ("near", "near", (40, 30)),
        ("one", "pair", (-40, -60)),
        ("one", "error", (0, 30)),
        ("piecewise", "error", (0, -30)),
        ("piecewise", "pieces", (60, -30)),
        ("stepwise", "tolerance", (0, 90)),
        ("stepwise", "angle", (-20, 60)),
        ("curved", "place", (60, -60)),
        ("curved", "tolerance", (-60, -20)),
        ("curved", "cutter", (30, 20)),
        ("costs", "tolerance", (90, 0)),
        ("costs", "feed", (0, 40)),
        ("whole", "time", (40, 80)),
        ("holes", "block", (-120, 0)),
        ("translating", "character", (60, 0)),
        ("roundness", "times", (10, -10)),
        ("roundness", "cutter", (30, 0)),
        ("own", "place", (60, 0)),
        ("own", "tolerance", (0, -15)),
    ],
)
def test_what_has_a_ring_is_dragged_in_the_drawing(
    page: Page, figure: str, name: str, by: tuple[int, int]
) -> None:
    """And by the keyboard: its input, which is not seen, has the focus."""
    at = page.locator(f"#{figure}")
    at.scroll_into_view_if_needed()
    hold = at.locator(f"[data-hold={name}]")
    hold.wait_for()
    value = at.locator(f"[name={name}]").input_value()
    at.locator("svg").evaluate("(svg) => svg.scrollIntoView({ block: 'center' })")
    until(page, "new Promise((done) => setTimeout(() => done(true), 400))")  # drawn for the last time
    before = _shown(at)
    x, y = _middle(hold)
    page.mouse.move(x, y)
    page.mouse.down()
    page.mouse.move(x + by[0], y + by[1], steps=4)
    page.mouse.up()
    assert _changes(at, before)
    assert at.locator(f"[name={name}]").input_value() != value
    assert page.evaluate("document.activeElement.name") == name


def test_the_ring_of_the_feeds_aims_the_cut(page: Page) -> None:
    """On the slope the nearest pair of Table 2.4 is 27.9 over 16.0; the ring stays under the pointer."""
    one = page.locator("#one")
    one.locator("svg").evaluate("(svg) => svg.scrollIntoView({ block: 'center' })")
    hold = one.locator("[data-hold=pair]")
    hold.wait_for()
    settled(page)
    frame = one.locator("svg").bounding_box()
    assert frame
    slope = re.findall(r"[\d.]+", one.locator(".intended").get_attribute("d") or "")
    (ax, ay), (bx, by) = ((frame["x"] + float(x), frame["y"] + float(y)) for x, y in (slope[:2], slope[2:]))
    x, y = _middle(hold)
    part = np.hypot(x - ax, y - ay) / np.hypot(bx - ax, by - ay)
    aim = ax + (bx - ax) * part, ay + (by - ay) * part
    page.mouse.move(x, y)
    page.mouse.down()
    page.mouse.move(*aim, steps=4)
    page.mouse.up()
    until(page, "document.querySelector('#one output').textContent === '27.9 over 16.0'")
    settled(page)
    assert np.allclose(_middle(hold), aim, atol=2)


def _middle(hold: Locator) -> tuple[float, float]:
    box = hold.bounding_box()
    assert box
    return box["x"] + box["width"] / 2, box["y"] + box["height"] / 2


@pytest.mark.parametrize(("waves", "band", "least"), [(1, "70", 20), (18, "31", 1500)])
def test_an_own_curve_goes_through_the_whole_chain(page: Page, waves: int, band: str, least: int) -> None:
    """A stroke across the frame: a part program, eia.pal, the Hydra-Point; the workbench opens its tape.

    There it is milled, and the curve is a part program: it punches the same tape. The link is as short for
    many blocks.
    """
    own = page.locator("#own")
    own.locator("[name=tolerance]").fill(band)
    across = (_frame(page)["width"] - 20) / waves
    _stroke(page, (10, 60), *((10 + across * wave, 60 + 90 * (wave % 2)) for wave in range(1, waves + 1)))
    until(page, "document.getElementById('save').disabled")
    until(page, "!document.getElementById('save').disabled")
    said = own.locator(".said").inner_text()
    blocks = int(re.findall(r"^(\d+) blocks", said)[0])
    assert blocks > least
    assert len(page.locator("#open").get_attribute("href") or "") < 1000
    assert f"{20 * blocks + 1} frames" in said
    assert "goes the same way by it" in said
    (Path(urlsplit(page.url).path).parent / "pdp8.html").write_text(workbench.page(), encoding="utf-8")
    with page.context.expect_page() as opened:
        page.locator("#open").click()
    bench = opened.value
    until(bench, "!!window.workbench?.mill?.steps?.length")
    assert bench.evaluate("workbench.mill.steps?.length") == blocks
    tape = bytes(bench.evaluate("[...workbench.shelf.get(workbench.mill.name).frames]"))
    heights, tolerance = bench.evaluate(_TYPED)
    punched = drawn.part(heights, tolerance=float(tolerance))
    assert eia.encode(punched.replace(" ", "0")) == tape.strip(b"\0")
    bench.close()


def test_the_rest_of_a_curve_moves_to_meet_a_short_stroke(page: Page) -> None:
    _stroke(page, (150, 200), (200, 200))
    page.locator("#own .groove").wait_for()
    drawn = page.locator("#own .intended").first.get_attribute("d") or ""
    page.reload()  # it stays
    _frame(page)
    page.locator("#own .groove").wait_for()
    assert page.locator("#own .intended").first.get_attribute("d") == drawn
    heights = [float(y) for y in re.findall(r" ([\d.]+)", drawn)]
    assert 190 < heights[50] < 210
    assert max(abs(one - other) for one, other in pairwise(heights)) < 20


def _frame(page: Page) -> Any:
    """Bring the frame to the middle of the window; return its box."""
    svg = page.locator("#own svg")
    svg.scroll_into_view_if_needed()
    settled(page)
    svg.evaluate("(svg) => svg.scrollIntoView({ block: 'center' })")
    return svg.bounding_box()


def _stroke(page: Page, first: tuple[float, float], *others: tuple[float, float]) -> None:
    """Draw a stroke through places of the frame."""
    box = _frame(page)
    page.mouse.move(box["x"] + first[0], box["y"] + first[1])
    page.mouse.down()
    for x, y in others:
        page.mouse.move(box["x"] + x, box["y"] + y, steps=6)
    page.mouse.up()


def test_a_curve_too_steep_is_refused_and_its_shape_stays(page: Page) -> None:
    own, width = page.locator("#own"), _frame(page)["width"]
    _stroke(page, (20, 20), (width / 2, 20), (width / 2 + 1, 200), (width - 20, 200))
    own.locator("[name=tolerance]").fill("31")
    until(page, "document.querySelector('#own .said').textContent.startsWith('It cannot be cut')")
    assert own.locator(".intended").count() == 1
    assert own.locator(".groove").count() == 0
    assert page.locator("#open").get_attribute("href") is None
    own.locator("[name=tolerance]").fill("70")
    own.locator(".groove").wait_for()


def test_a_curve_drawn_by_hand_stays_in_its_band() -> None:
    """Each stop, and each middle of a cut, is off by no more than the band and a thousandth."""
    heights = [5.0, 5.04, 5.065, 5.03, 5.03, 4.99]  # no steeper than 1
    text = drawn.part(" ".join(map(str, heights)), tolerance=0.006)
    cuts = [(int(line[4:9]), int(line[9:14])) for line in text.splitlines() if line[3] == "6"]
    assert len(cuts) > 15
    middles = [((a + c) / 2, (b + d) / 2) for (a, b), (c, d) in pairwise(cuts)]
    for x, y in cuts + middles:
        assert abs(y - 1000 * np.interp(x, range(2000, 2201, 40), heights)) <= 7


def test_each_control_changes_its_figure(page: Page) -> None:
    """Every input by the keyboard: what is drawn or said is another; its ring is seen to have the focus.

    One slider is seen: that of wrong feeds, where nothing drawn changes. Nothing is too wide. A button
    translates the whole tape.
    """
    inputs = page.locator(".live input").all()
    assert len(inputs) > 15
    for control in inputs:
        figure = control.locator("xpath=ancestor::figure")
        before = _shown(figure)
        upper = control.evaluate("({ value, max }) => value > max / 2")
        control.focus()
        if control.evaluate("(input) => !!input.closest('.held')"):
            figure.locator(f"[data-hold={control.get_attribute('name')}].on").wait_for()
        box = control.get_attribute("type") == "checkbox"
        page.keyboard.press("Space" if box else "PageDown" if upper else "PageUp")
        assert _changes(figure, before), control.get_attribute("name")
    assert page.evaluate(_SLIDERS) == [["stepwise", "dx"]]
    assert page.evaluate("document.documentElement.scrollWidth") == 390
    assert not any("<" in each.inner_text() for each in page.locator(".said").all())
    click(page, "#translate")
    until(page, "document.getElementById('translated').textContent")
    assert re.match(r"666 blocks: 30\.0 minutes .*; 13320 frames", page.locator("#translated").inner_text())


def _set(page: Page, name: str, value: int) -> Locator:
    """Set an input of a figure, by its script; return the figure."""
    control = page.locator(name)
    control.scroll_into_view_if_needed()
    put = "(input, to) => { input.value = to; input.dispatchEvent(new Event('input', { bubbles: true })); }"
    control.evaluate(put, value)
    return control.locator("xpath=ancestor::figure")


def test_a_frame_is_counted_from_one(page: Page) -> None:
    """Its input says it to a screen reader: the first of block 1, its last, the first of block 2."""
    for place, named in ((0, "1 of 27 of block 1"), (26, "27 of 27 of block 1"), (27, "1 of 27 of block 2")):
        _set(page, "#translating [name=character]", place)
        says = "document.querySelector('#translating [name=character]').getAttribute('aria-valuetext')"
        until(page, f"{says}?.startsWith({named!r}) ?? false")


def test_the_errors_of_the_step_wise_slope_are_opposite(page: Page) -> None:
    """X 20 % too fast and Y 20 % too slow take the minutes that Python has for them, not those of both."""
    _set(page, "#stepwise [name=angle]", 30)
    figure = _set(page, "#stepwise [name=dx]", 20)
    band = figure.locator("[name=tolerance] ~ output").inner_text()
    thousandths = 1000 * float(re.findall(r"\d*\.\d+", band)[-1])
    opposite, both = method.slope(thousandths, 0.2, -0.2), method.slope(thousandths, 0.2, 0.2)
    assert f"{opposite.minutes:.2f}" != f"{both.minutes:.2f}"
    until(
        page, f"document.querySelector('#stepwise .said').textContent.includes('{opposite.minutes:.2f} min')"
    )


def _changes(figure: Locator, before: str) -> bool:
    """Wait until a figure shows something else than before, and say whether it does."""
    for _ in range(200):
        if _shown(figure) != before:
            return True
        figure.page.wait_for_timeout(30)
    return False


def _shown(figure: Locator) -> str:
    """Return what a figure draws and says, without the names of its clips, which are new each time."""
    drawn = figure.locator(".drawing").inner_html() + figure.locator(".said").inner_html()
    return re.sub(r"clip\d+", "", drawn)


@needs_axe
def test_the_page_is_accessible(page: Page) -> None:
    page.evaluate(AXE.read_text(encoding="utf-8"))
    assert serious(page) == []
