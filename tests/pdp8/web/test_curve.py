"""The page that teaches the method: its numbers are Python's, and every control of it changes its figure."""

import re
from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
import pytest

import nc
from nc.curves import nominal
from nc.inspection import inspect
from pdp8.thesis import chain
from pdp8.web import curve
from programs.header import THESIS
from programs.milling import Milling
from programs.printout import Printout
from programs.stretches import Curve, Point, arc, line
from tapes import ascii, eia, shelf
from tests.pdp8.web.browsing import AXE, needs_axe, serious, until
from tests.pdp8.web.node import in_node, needs_node

if TYPE_CHECKING:
    from playwright.sync_api import Browser, Locator, Page

_SLOPE = (Point(1000, 1000), Point(5330, 3500))

_COMPUTED = """async () => {
  const method = await import("@/pdp8/web/curve/method.mjs");
  const { walls } = await import("@/pdp8/web/curve/walls.mjs");
  const plain = ({ text, blocks, minutes, way }) => [text, blocks, minutes, way.map(({ x, y }) => [x, y])];
  const made = {
    circle: method.circle(5), closed: method.circle(5, true), steps: method.slope(7),
    "fine steps": method.slope(5),
    "wrong feeds": method.slope(7, "step", 0.2, -0.2), pieces: method.slope(5, "piece", 0.1, -0.1),
    quarter: method.quarter(5, 3), coarse: method.quarter(10, 3),
  };
  const circle = { x: 4000, y: 4000, radius: 1750 };
  const measured = ({ way }, from, sweep, count) => {
    const { outer, inner } = walls(way, circle, 500, from, sweep, count);
    return [[...outer], [...inner]];
  };
  return {
    ...Object.fromEntries(Object.entries(made).map(([name, each]) => [name, plain(each)])),
    walls: measured(made.circle, 0, 2 * Math.PI, 3600),
  };
}"""


@pytest.fixture(scope="module")
def computed() -> dict[str, Any]:
    """What the figures compute, in Node.js."""
    found: dict[str, Any] = in_node(_COMPUTED)
    return found


def _made(curve: Curve, milling: Milling) -> tuple[str, Curve]:
    printout = Printout()
    printout.header(THESIS, *curve.start)
    milling.print(printout, curve)
    return printout.text, curve


def _cut(text: str, feed_error: tuple[float, float, float] = (0, 0, 0)) -> list[Any]:
    path = nc.cut(eia.encode(text.replace(" ", "0")), settings=nc.Settings(feed_error=feed_error))
    way = [path.cuts[0].start, *(move.end for move in path.cuts)]
    return [text, len(path), path.contour.total / 60, [[place.x, place.y] for place in way]]


@needs_node
def test_the_circle_is_that_of_the_listing(computed: dict[str, Any]) -> None:
    """666 blocks, the very printout of Appendix C, and 35.9 minutes; the closed one has its last cuts."""
    assert computed["circle"] == _cut(chain.printout("circle"))
    assert computed["circle"][1] == 666
    assert round(computed["circle"][2], 1) == 35.9
    assert computed["closed"][3][-1] == computed["closed"][3][0] == [2250, 4000]


@needs_node
def test_slopes_and_curve_are_those_of_the_techniques(computed: dict[str, Any]) -> None:
    """Blocks, minutes and each place, with exact feeds and with wrong ones."""
    steps, _ = _made(line(*_SLOPE, 7), Milling())
    pieces, _ = _made(line(*_SLOPE, 5), Milling("piece", feed_error=0.2))
    assert computed["steps"] == _cut(steps)
    assert computed["wrong feeds"] == _cut(steps, (0.2, -0.2, 0))
    assert computed["wrong feeds"][3] == computed["steps"][3]
    assert [computed[name][1] - 6 for name in ("pieces", "fine steps")] == [174, 408]
    assert computed["pieces"] == _cut(pieces, (0.1, -0.1, 0))
    for name, tolerance in (("quarter", 5), ("coarse", 10)):
        text, _ = _made(arc(Point(4000, 4000), 1750, 180, -90, tolerance), Milling(feed_code=3))
        assert computed[name] == _cut(text)
    assert 1.8 < (computed["quarter"][1] - 6) / (computed["coarse"][1] - 6) < 2


@needs_node
def test_the_walls_are_those_of_the_inspection(computed: dict[str, Any]) -> None:
    """Each station of both walls to a millionth of a thousandth; none is where nothing was cut."""
    inspection = inspect(chain.path("circle"), nominal(circle=(4, 4, 1.75)), tolerance=5)
    every = len(inspection.walls.stations) // 3600
    for there, here in zip(computed["walls"], (inspection.walls.outer, inspection.walls.inner), strict=True):
        assert np.allclose(there, here[::every], rtol=0, atol=1e-6)


_TRANSLATED = """async ({ words, line, tape }) => {
  const { punchedTape, translated } = await import("@/pdp8/web/curve/computer.mjs");
  const frames = translated(words, line).map(({ punched }) => punched).filter((frame) => frame !== null);
  const whole = punchedTape(words, tape);
  return [frames, [...whole.tape], whole.seconds];
}"""


@needs_node
def test_the_computer_punches_the_bundled_tape() -> None:
    """A block frame by frame, and the whole circle: 30 minutes."""
    text = "  76 2250 4133  185\n"
    tape = list(shelf.read_bundled("circle.asc"))
    given = {"words": curve.record()["words"], "line": list(ascii.encode(text)), "tape": tape}
    frames, whole, seconds = in_node(_TRANSLATED, given)
    assert bytes(frames) == eia.encode(text.replace(" ", "0"))
    assert bytes(whole) == shelf.read_bundled("circle.eia")
    assert round(seconds / 60) == 30


@pytest.fixture(scope="module")
def page(browser: "Browser", tmp_path_factory: pytest.TempPathFactory) -> Iterator["Page"]:
    """The page in Chromium, from disk, on a phone; `errors` of it are kept in the page."""
    file = tmp_path_factory.mktemp("curve") / "curve.html"
    file.write_text(curve.page(), encoding="utf-8")
    found = browser.new_page(viewport={"width": 390, "height": 800})
    found.add_init_script("errors = []; addEventListener('error', ({ message }) => errors.push(message))")
    found.goto(file.as_uri())
    until(found, "[...document.querySelectorAll('.said')].every((each) => each.textContent)")
    yield found
    found.close()


def test_each_control_changes_its_figure(page: "Page") -> None:
    """Every slider by the keyboard, every box: what is drawn or said is another. Nothing is too wide."""
    inputs = page.locator(".live input").all()
    assert len(inputs) > 15
    for control in inputs:
        figure = control.locator("xpath=ancestor::figure")
        before = _shown(figure)
        upper = control.evaluate("({ value, max }) => value > max / 2")
        control.focus()
        box = control.get_attribute("type") == "checkbox"
        page.keyboard.press("Space" if box else "PageDown" if upper else "PageUp")
        until(page, "new Promise((done) => setTimeout(() => done(true), 30))")
        assert _shown(figure) != before, control.get_attribute("name")
    assert page.evaluate("document.documentElement.scrollWidth") == 390
    assert page.evaluate("errors") == []


def _shown(figure: "Locator") -> str:
    """Return what a figure draws and says, without the names of its clips, which are new each time."""
    drawn = figure.locator(".drawing").inner_html() + figure.locator(".said").inner_html()
    return re.sub(r"clip\d+", "", drawn)


def test_the_button_translates_the_whole_tape(page: "Page") -> None:
    """All 666 blocks, in the page."""
    page.locator("#translate").click()
    said = page.locator("#translated")
    assert re.match(r"666 blocks: 30\.0 minutes .*; 13320 frames", said.inner_text())


def test_the_page_answers_its_questions(page: "Page") -> None:
    """Why a staircase, what the tolerance buys, why 36 minutes: once in the text, once at the end."""
    text = page.locator("main").text_content() or ""
    for question in ("why a staircase", "What a narrower tolerance buys", "Why 36 minutes"):
        assert question in text
    assert page.locator("main > details").count() == 3


@needs_axe
def test_the_page_is_accessible(page: "Page") -> None:
    """Nothing that axe-core finds serious."""
    page.evaluate(Path(AXE).read_text(encoding="utf-8"))
    assert serious(page) == []


def test_the_file_is_whole(tmp_path: Path) -> None:
    """Nothing to fetch, and under 400 kB."""
    html = curve.page()
    assert len(html) < 400_000
    assert not re.search(r"(?:src|href)=\"(?!data:)", html)
