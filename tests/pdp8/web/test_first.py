"""A page where it cannot run: a picture, a sentence, what is needed; never a control that nothing answers."""

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import pytest

from tests.pdp8.web.browsing import DESK, Browser, Page, click, until, visit

_ADDRESS = "http://page.test/"
_CONTROLS = "button, input, select, textarea"
_OLD = {
    "DecompressionStream": "delete globalThis.DecompressionStream",
    "OffscreenCanvas": "delete globalThis.OffscreenCanvas",
    "Map.groupBy": "delete Map.groupBy",
}


@contextmanager
def _opened(
    browser: Browser, file: Path, policy: str = "", gone: str = "", end: str = "", **options: Any
) -> Iterator[Page]:
    """The page as a server sends it with a policy, in a browser in which something is gone."""
    context = browser.new_context(viewport={"width": 1366, "height": 768}, **options)
    page = context.new_page()
    headers = {"Content-Type": "text/html; charset=utf-8"} | (
        {"Content-Security-Policy": policy} if policy else {}
    )
    page.route("**", lambda route: route.fulfill(body=file.read_text(encoding="utf-8"), headers=headers))
    page.add_init_script(gone)
    page.goto(_ADDRESS + end)
    yield page
    context.close()


def _stands(page: Page, needed: str) -> None:
    """A picture, a sentence, and what is needed are on the screen, and no control is."""
    page.wait_for_timeout(200)
    assert page.get_by_role("heading", level=1).is_visible()
    assert page.locator("#first svg").count() == 3
    for picture in page.locator("#first svg").all():
        box = picture.bounding_box()
        assert box is not None
        assert min(box["width"], box["height"]) > 50
        assert box["y"] + box["height"] <= 768
    assert needed in page.locator("body").inner_text()
    assert page.locator(_CONTROLS).count() == 0


def test_without_scripts(browser: Browser, file: Path) -> None:
    with _opened(browser, file, java_script_enabled=False) as page:
        _stands(page, "needs JavaScript")


@pytest.mark.parametrize(
    ("policy", "needed"),
    [
        ("default-src 'none'", "forbids scripts"),
        ("script-src 'none'", "forbids scripts"),
        ("default-src 'none'; script-src 'unsafe-inline'", "forbids its style"),
    ],
)
def test_under_a_servers_policy(browser: Browser, file: Path, policy: str, needed: str) -> None:
    with _opened(browser, file, policy) as page:
        _stands(page, needed)


@pytest.mark.parametrize("name", _OLD)
def test_in_an_old_browser(browser: Browser, file: Path, name: str) -> None:
    """It is named, with the browsers that have it."""
    with _opened(browser, file, gone=_OLD[name]) as page:
        _stands(page, f"This browser has no {name}: the machine needs Firefox")


def test_a_fault_is_said(browser: Browser, file: Path) -> None:
    """In the bar there is a way on from any address; what is told stays on the screen."""
    with _opened(browser, file, end="#t=20") as page:
        until(page, "!!window.workbench?.ready")
        page.evaluate("() => { workbench.room.camera.look = null; workbench.room.show(); }")
        until(page, "!!document.getElementById('stumbled')")
        assert "stumbled: " in page.get_by_role("alert").inner_text()
        assert page.locator("#room .story").is_visible()
        click(page, "#stumbled a")
        until(page, "!!window.workbench?.ready && !document.getElementById('stumbled')")


_EARLY = """
const drop = (name) => {
  const early = new Event("drop", { bubbles: true, cancelable: true });
  early.dataTransfer = { types: ["Files"], files: [new File(["1"], name)] };
  return document.body.dispatchEvent(early);
};
window.early = [];
addEventListener("DOMContentLoaded", () => window.early.push(drop("A.PAL"), "workbench" in window));
new MutationObserver(() => {
  if (window.workbench && window.early.length < 3) window.early.push(drop("b.asc"), workbench.ready);
}).observe(document, { childList: true, subtree: true });
"""


def test_a_file_that_is_dropped_at_once_waits_for_the_desk(browser: Browser, file: Path) -> None:
    """Before there is a page, and before there is a desk: the browser opens none."""
    with _opened(browser, file, gone=_EARLY) as page:
        until(page, "window.workbench?.teletype?.called() === 'b.asc' && workbench.editor.name === 'A.PAL'")
        assert page.evaluate("window.early") == [False] * 4


def test_on_paper(browser: Browser, file: Path) -> None:
    """The room is printed as its first picture; the desk as what it has, on white."""
    with visit(browser, file.as_uri(), viewport={"width": 1366, "height": 768}) as page:
        page.emulate_media(media="print")
        assert page.locator("#first h1").is_visible()
        assert page.locator("#room").is_hidden()
        assert page.locator("#first").evaluate("(first) => getComputedStyle(first).color") == "rgb(0, 0, 0)"
    with visit(browser, file.as_uri() + DESK) as page:
        page.emulate_media(media="print")
        assert page.locator("#first").is_hidden()
        white = page.evaluate("getComputedStyle(document.body).backgroundColor")
        assert white == "rgb(255, 255, 255)"
