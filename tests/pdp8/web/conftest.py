"""The workbench on disk, and opened in Chromium or Firefox."""

from collections.abc import Iterator
from pathlib import Path

import pytest

from pdp8.web.workbench import page as workbench
from tests.pdp8.web import node, small
from tests.pdp8.web.browsing import DESK, Chromium, Page, Tab
from tests.pdp8.web.firefox import FIREFOX, Firefox, opened

_BROWSERS = ("chromium", "firefox")


@pytest.fixture(scope="session")
def file(pytestconfig: pytest.Config, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The page on disk, made once for all processes; it is under 500 kB and may ask for nothing."""
    own = tmp_path_factory.getbasetemp() / "pdp8.html"
    path = own.parents[hasattr(pytestconfig, "workerinput")] / own.name
    if not path.exists():
        html = node.page("pdp8", workbench)
        assert len(html) < 500_000
        assert "default-src 'none'" in html
        own.write_text(html, encoding="utf-8")
        own.replace(path)
    return path


@pytest.fixture(params=small.BOTH)
def page(request: pytest.FixtureRequest, file: Path) -> Iterator[Page]:
    """The page at the desk: on the small document in Node.js, and in Chromium."""
    yield from small.opened(request, file, DESK, has_touch=True)


@pytest.fixture(params=small.BOTH)
def room(request: pytest.FixtureRequest, file: Path) -> Iterator[Page]:
    """The page as it opens, in the room, in both."""
    yield from small.opened(request, file, "")


@pytest.fixture(scope="session")
def firefox(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Firefox]:
    """A Firefox of its own profile."""
    if FIREFOX is None:
        pytest.skip("Firefox is not installed")
    with opened(tmp_path_factory.mktemp("firefox")) as driver:
        yield driver


@pytest.fixture(params=[pytest.param(name, marks=pytest.mark.slow("in a browser")) for name in _BROWSERS])
def tab(request: pytest.FixtureRequest, file: Path, tmp_path: Path) -> Iterator[Tab]:
    """The workbench as it opens, in each browser."""
    if request.param == "chromium":
        for page in small.opened(request, file, DESK, has_touch=True):
            yield Chromium(page)
        return
    driver: Firefox = request.getfixturevalue("firefox")
    fresh = tmp_path / file.name  # at another path Firefox has nothing kept: no programs, no settings
    fresh.write_bytes(file.read_bytes())
    driver.call("WebDriver:Navigate", url=fresh.as_uri() + DESK)
    driver.until(f"location.href.startsWith({fresh.as_uri()!r}) && window.workbench?.ready")
    yield driver
