"""What the tests of the pages do in a browser: open a page, wait, and work it in whichever browser it is."""

import shutil
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any

import pytest

from tests.pdp8.web.firefox import Firefox

if TYPE_CHECKING:
    from playwright.sync_api import Browser, Locator, Page
else:
    Browser = Locator = Page = object  # Playwright may not be there
__all__ = ["Browser", "Locator", "Page"]

CHROMIUM = shutil.which("chromium") or shutil.which("chromium-browser")
DESK = "#workbench"
"""Behind the address of the page: it opens at the desk, not in the room."""
PATIENCE = 45
"""Seconds in which what is waited for has to come, also where much else runs."""
AXE = Path(__file__).parents[2] / "node" / "node_modules" / "axe-core" / "axe.min.js"
needs_axe = pytest.mark.skipif(
    not AXE.exists(), reason="axe-core is not installed: npm ci --prefix tests/node"
)

_CHROMIUM = pytest.param("chromium", marks=pytest.mark.slow("in a browser"))
in_chromium = pytest.mark.parametrize("page", [_CHROMIUM], indirect=True)
"""For a test that looks where things lie, or at what a browser alone does."""
room_in_chromium = pytest.mark.parametrize("room", [_CHROMIUM], indirect=True)


@contextmanager
def launched() -> Iterator[Browser]:
    """A headless Chromium."""
    from playwright.sync_api import sync_playwright

    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=CHROMIUM, args=["--disable-gpu"])
        yield browser
        browser.close()


_FIFTEEN_PICTURES = """(() => {
  const [next, cancel, asked] = [requestAnimationFrame, cancelAnimationFrame, new Map()];
  const after = (pictures, act, number) => asked.set(number, next((now) =>
    pictures ? after(pictures - 1, act, number) : asked.delete(number) && act(now)));
  let last = 0;
  window.requestAnimationFrame = (act) => (after(3, act, ++last), last);
  window.cancelAnimationFrame = (number) => cancel(asked.get(number));
})()"""
"""A display of fifteen pictures a second: painting sixty takes most of the time."""


@contextmanager
def visit(
    browser: Browser, address: str, condition: str = "!!window.workbench?.ready", **options: Any
) -> Iterator[Page]:
    """A page that knows no other, offline; it may not complain, nor ask for anything."""
    context = browser.new_context(offline=True, **options)
    context.set_default_timeout(PATIENCE * 1000)
    context.add_init_script(_FIFTEEN_PICTURES)
    page = context.new_page()
    complaints: list[str] = []
    page.on("console", lambda message: complaints.append(message.text))
    page.on("pageerror", lambda error: complaints.append(str(error)))
    page.goto(address)
    until(page, condition)
    yield page
    context.close()
    assert complaints == [], complaints


def until(page: Page, condition: str) -> None:
    """Wait until it holds; Playwright's own way evaluates a string, which the page's policy forbids."""
    for _ in range(PATIENCE * 40):
        if page.evaluate(condition):
            return
        page.wait_for_timeout(25)
    raise AssertionError(condition)


def settled(page: Page) -> None:
    """Wait until nothing of the page has changed or moved for a while."""
    page.evaluate(
        """async () => {
          const look = () => document.body.innerHTML + scrollY, pause = () => new Promise((done) =>
            requestAnimationFrame(() => setTimeout(done, 100)));
          for (let before = ""; before !== look(); await pause()) before = look();
        }"""
    )


def click(page: Page, *selectors: str) -> None:
    """Click what is there, one after the other."""
    for selector in selectors:
        page.locator(selector).click()


def serious(page: Page) -> Any:
    """Return what axe-core finds that is serious or critical: roles, names, contrast."""
    return page.evaluate(
        """async () => (await axe.run()).violations
          .filter(({ impact }) => impact === "serious" || impact === "critical")
          .map(({ id, nodes }) => [id, nodes.slice(0, 3).map(({ html }) => html.slice(0, 120))])"""
    )


class Chromium:
    """A page in Chromium, worked by the methods of a Firefox."""

    def __init__(self, page: Page) -> None:
        self.page = page

    def run(self, script: str) -> Any:
        return self.page.evaluate(f"() => {{ {script} }}")

    def until(self, condition: str) -> None:
        until(self.page, condition)

    def press(self, keys: str) -> None:
        self.page.keyboard.press(keys)

    def point(self, selector: str, which: int, pointer: str) -> None:
        target = self.page.locator(selector).nth(which)
        target.click() if pointer == "mouse" else target.tap()


Tab = Chromium | Firefox
