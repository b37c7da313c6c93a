"""What the tests of the replay and of its page share: one afternoon, its page, Node.js and Chromium."""

from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

from pdp8.replay import Afternoon, replay
from pdp8.web.workbench import page
from tests.pdp8.web.chromium import CHROMIUM, launched

if TYPE_CHECKING:
    from playwright.sync_api import Browser


@pytest.fixture(scope="session")
def circle() -> Afternoon:
    """The circle's afternoon."""
    return replay("circle")


@pytest.fixture(scope="session")
def circle_page(circle: Afternoon, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The circle's page on disk."""
    file = tmp_path_factory.mktemp("page") / "page.html"
    file.write_text(page(afternoon=circle), encoding="utf-8")
    return file


@pytest.fixture(scope="session")
def browser() -> "Iterator[Browser]":
    """A headless Chromium."""
    pytest.importorskip("playwright.sync_api", reason="playwright is not installed")
    if CHROMIUM is None:
        pytest.skip("Chromium is not installed")
    with launched() as chromium:
        yield chromium
