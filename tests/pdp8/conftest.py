"""What the tests of the replay and of its page share: one afternoon, its page, Node.js and Chromium."""

from collections.abc import Callable, Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Any

import pytest

from pdp8.replay import Afternoon, replay
from pdp8.web.page import page, record
from tests.pdp8.web.chromium import CHROMIUM, launched
from tests.pdp8.web.node import NODE, in_node

if TYPE_CHECKING:
    from playwright.sync_api import Browser

Ask = Callable[[str, Any], Any]


@pytest.fixture(scope="session")
def circle() -> Afternoon:
    """The circle's afternoon."""
    return replay("circle")


@pytest.fixture(scope="session")
def circle_page(circle: Afternoon, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The circle's page on disk."""
    file = tmp_path_factory.mktemp("page") / "page.html"
    file.write_text(page(circle), encoding="utf-8")
    return file


@pytest.fixture(scope="session")
def browser() -> "Iterator[Browser]":
    """A headless Chromium."""
    pytest.importorskip("playwright.sync_api", reason="playwright is not installed")
    if CHROMIUM is None:
        pytest.skip("Chromium is not installed")
    with launched() as chromium:
        yield chromium


@pytest.fixture(scope="session")
def ask(circle: Afternoon, circle_page: Path, request: pytest.FixtureRequest) -> Ask:
    """Ask the page's afternoon: `ask("(afternoon, given) => ...", given)`, in Node.js or else in Chromium."""
    if NODE:
        return _of_node(record(circle))
    opened = request.getfixturevalue("browser").new_page()
    opened.goto(circle_page.as_uri())

    def asked(function: str, given: Any) -> Any:
        return opened.evaluate(f"(given) => ({function})(replay.afternoon, given)", given)

    return asked


_ASKED = """async ({ record, given }) => {
  const { Afternoon, unpacked } = await import("@/afternoon.mjs");
  return (FUNCTION)(new Afternoon(unpacked(record)), given);
}"""


def _of_node(data: dict[str, Any]) -> Ask:
    def asked(function: str, given: Any) -> Any:
        return in_node(_ASKED.replace("FUNCTION", function), {"record": data, "given": given})

    return asked
