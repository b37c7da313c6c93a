"""What the tests of the replay and of its page share: one afternoon, its page."""

from pathlib import Path

import pytest

from pdp8.replay import Afternoon, replay
from pdp8.web.workbench import page


@pytest.fixture(scope="session")
def circle() -> Afternoon:
    return replay("circle")


@pytest.fixture(scope="session")
def circle_page(circle: Afternoon, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The circle's page on disk."""
    file = tmp_path_factory.mktemp("page") / "page.html"
    file.write_text(page(afternoon=circle), encoding="utf-8")
    return file
