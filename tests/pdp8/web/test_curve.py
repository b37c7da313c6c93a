"""The page that teaches the method: its numbers are Python's, and every control of it changes its figure."""

import re
from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
import pytest

import pal
from nc.curves import nominal
from nc.inspection import inspect
from pdp8.thesis import chain
from pdp8.web import curve, method
from programs.milling import Milling
from tapes import ascii, eia, shelf
from tests.pdp8.web.browsing import AXE, needs_axe, serious, until
from tests.pdp8.web.node import in_node, needs_node

if TYPE_CHECKING:
    from playwright.sync_api import Browser, Locator, Page

_COMPUTED = """async ({ words, line }) => {
  const method = await import("@/pdp8/web/method.mjs");
  const { walls } = await import("@/pdp8/web/curve/walls.mjs");
  const plain = ({ text, minutes, way }) => [text, minutes, way.map(({ x, y }) => [x, y])];
  const { way } = method.circle(5);
  const { outer, inner } = walls(way, { x: 4000, y: 4000, radius: 1750 }, 500, 0, 2 * Math.PI, 3600);
  return {
    made: [method.circle(3, true), method.slope(7, 0.2, -0.2), method.quarter(10, 3)].map(plain),
    walls: [[...outer], [...inner]],
    characters: method.characters(words, line).map(
      ({ rows, punched, waited }) => [rows.map((row) => [...row]), punched, waited]),
  };
}"""
_WORDS = list(pal.assemble(shelf.read_bundled("eia.pal")).words.items())
_LINE = "  76 2250 4133  185\n"


@pytest.fixture(scope="module")
def computed() -> dict[str, Any]:
    """What the figures compute, in Node.js."""
    found: dict[str, Any] = in_node(_COMPUTED, {"words": _WORDS, "line": list(ascii.encode(_LINE))})
    return found


@needs_node
def test_the_page_computes_what_python_does(computed: dict[str, Any]) -> None:
    """Printouts, minutes and ways; what eia.pal does with each character of a block."""
    made = (method.circle(3, close=True), method.slope(7, 0.2, -0.2), method.quarter(10, 3))
    ways = [[[place.x, place.y] for place in each.way] for each in made]
    expected = [[each.text, each.minutes, way] for each, way in zip(made, ways, strict=True)]
    assert computed["made"] == expected
    done = method.characters(_WORDS, ascii.encode(_LINE))
    rows = [[[list(row) for row in each.rows], each.punched, each.waited] for each in done]
    assert computed["characters"] == rows


@needs_node
def test_the_walls_are_those_of_the_inspection(computed: dict[str, Any]) -> None:
    """Each station of both walls to a millionth of a thousandth; none is where nothing was cut."""
    inspection = inspect(chain.path("circle"), nominal(circle=(4, 4, 1.75)), tolerance=5)
    every = len(inspection.walls.stations) // 3600
    for there, here in zip(computed["walls"], (inspection.walls.outer, inspection.walls.inner), strict=True):
        assert np.allclose(there, here[::every], rtol=0, atol=1e-6)


def test_the_circle_is_that_of_the_listing() -> None:
    """666 blocks, the very printout of Appendix C, and 35.9 minutes; the closed one has its last cuts."""
    circle, closed = method.circle(5), method.circle(5, close=True)
    assert circle.text == chain.printout("circle")
    assert (circle.blocks, round(circle.minutes, 1)) == (666, 35.9)
    assert closed.way[-1][:2] == closed.way[0][:2] == (2250, 4000)


def test_slopes_and_curve_are_what_the_page_says() -> None:
    """408 blocks by steps, none of which moves when the feeds are wrong; half the band, twice the blocks."""
    exact, wrong = method.slope(5), method.slope(5, 0.2, -0.2)
    assert exact.blocks - 6 == 408
    assert wrong.way == exact.way
    assert wrong.minutes != exact.minutes
    assert chain.printout("slope", milling=Milling("piece", feed_error=0.2)).count("\n") - 6 == 174
    fine, coarse = method.quarter(5, 3), method.quarter(10, 3)
    assert 1.8 < (fine.blocks - 6) / (coarse.blocks - 6) < 2


def test_the_computer_punches_the_bundled_tape() -> None:
    """A block frame by frame, and the whole circle: 30 minutes."""
    frames = [each.punched for each in method.characters(_WORDS, ascii.encode(_LINE))]
    assert bytes(each for each in frames if each is not None) == eia.encode(_LINE.replace(" ", "0"))
    machine = method.translated(_WORDS, shelf.read_bundled("circle.asc"))
    assert machine.teletype.punch.tape == shelf.read_bundled("circle.eia")
    assert round(machine.elapsed / 60) == 30


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
