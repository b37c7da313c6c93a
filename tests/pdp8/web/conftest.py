"""The workbench on disk, and opened in Chromium."""

from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

from pdp8.web.workbench import page as workbench
from tests.pdp8.web.browsing import ChromiumTab, Tab, until
from tests.pdp8.web.firefox import FIREFOX, Firefox, opened

if TYPE_CHECKING:
    from playwright.sync_api import Browser, Page


@pytest.fixture(scope="session")
def file(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The page on disk."""
    path = tmp_path_factory.mktemp("workbench") / "pdp8.html"
    path.write_text(workbench(), encoding="utf-8")
    return path


@pytest.fixture
def page(browser: "Browser", file: Path) -> "Iterator[Page]":
    """The page, offline; the test fails if it complains or asks for anything."""
    context = browser.new_context(viewport={"width": 1366, "height": 768}, has_touch=True, offline=True)
    opened = context.new_page()
    complaints: list[str] = []
    opened.on("console", lambda message: complaints.append(message.text))
    opened.on("pageerror", lambda error: complaints.append(str(error)))
    opened.goto(file.as_uri())
    until(opened, "!!window.workbench")
    yield opened
    context.close()
    assert complaints == []


@pytest.fixture(scope="session")
def firefox(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Firefox]:
    """A Firefox of its own profile, at the workbench."""
    if FIREFOX is None:
        pytest.skip("Firefox is not installed")
    with opened(tmp_path_factory.mktemp("firefox"), workbench()) as driver:
        yield driver


@pytest.fixture(params=["chromium", pytest.param("firefox", marks=pytest.mark.slow)])
def tab(request: pytest.FixtureRequest, file: Path, tmp_path: Path) -> Tab:
    """The workbench as it opens, in each browser; Firefox, which takes seconds for each, in `make check`."""
    if request.param == "chromium":
        return ChromiumTab(request.getfixturevalue("page"))
    driver: Firefox = request.getfixturevalue("firefox")
    fresh = tmp_path / file.name  # at another path Firefox has nothing kept: no programs, no settings
    fresh.write_bytes(file.read_bytes())
    driver.call("WebDriver:Navigate", url=fresh.as_uri())
    driver.until("!!window.workbench")
    return driver
