"""What the tests of the pages do in a browser, whichever it is."""

from pathlib import Path
from typing import TYPE_CHECKING, Any, Protocol

import pytest

if TYPE_CHECKING:
    from playwright.sync_api import Page


class Tab(Protocol):
    """A page that is opened in some browser."""

    def run(self, script: str) -> Any:
        """Return what a script in the page returns."""

    def until(self, condition: str) -> None:
        """Wait until an expression of the page is true."""

    def press(self, keys: str) -> None:
        """Press a key, "a" or "ArrowDown", or some at once, "Control+a"."""

    def point(self, selector: str, which: int, pointer: str) -> None:
        """Click or tap one of the elements that a selector finds; the pointer is "mouse" or "touch"."""


class ChromiumTab:
    """A page in Chromium."""

    def __init__(self, page: "Page") -> None:
        self.page = page

    def run(self, script: str) -> Any:
        """Return what a script in the page returns."""
        return self.page.evaluate(f"() => {{ {script} }}")

    def until(self, condition: str) -> None:
        """Wait until an expression of the page is true."""
        until(self.page, condition)

    def press(self, keys: str) -> None:
        """Press a key, or some at once."""
        self.page.keyboard.press(keys)

    def point(self, selector: str, which: int, pointer: str) -> None:
        """Click or tap one of the elements that a selector finds."""
        target = self.page.locator(selector).nth(which)
        target.click() if pointer == "mouse" else target.tap()


AXE = Path(__file__).parents[2] / "node" / "node_modules" / "axe-core" / "axe.min.js"
needs_axe = pytest.mark.skipif(
    not AXE.exists(), reason="axe-core is not installed: npm install --prefix tests/node"
)


def serious(page: "Page") -> Any:
    """Return what axe-core finds that is serious or critical: roles, names, contrast."""
    return page.evaluate(
        """async () => (await axe.run()).violations
          .filter(({ impact }) => impact === "serious" || impact === "critical")
          .map(({ id, nodes }) => [id, nodes.slice(0, 3).map(({ html }) => html.slice(0, 120))])"""
    )


def until(page: "Page", condition: str) -> None:
    """Wait until it holds; Playwright's own way evaluates a string, which the page's policy forbids."""
    for _ in range(400):
        if page.evaluate(condition):
            return
        page.wait_for_timeout(25)
    raise AssertionError(condition)


def drawn(page: "Page") -> int:
    """Return how many pictures the page asks for, and how many elements it changes, in half a second."""
    return int(
        page.evaluate(
            """() => new Promise((done) => {
          let changes = 0;
          new MutationObserver((records) => (changes += records.length))
            .observe(document, { subtree: true, childList: true, attributes: true, characterData: true });
          const request = window.requestAnimationFrame;
          window.requestAnimationFrame = (then) => { changes++; return request(then); };
          setTimeout(() => done(changes), 500);
        })"""
        )
    )
