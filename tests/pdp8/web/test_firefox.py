"""The workbench in Firefox, opened from disk."""

import time
from collections.abc import Iterator
from pathlib import Path

import pytest

from pdp8.web.workbench import page as workbench
from tapes import shelf
from tests.pdp8.web.firefox import FIREFOX, Firefox, opened

pytestmark = pytest.mark.skipif(FIREFOX is None, reason="Firefox is not installed")


@pytest.fixture
def firefox(tmp_path: Path) -> Iterator[Firefox]:
    """A Firefox of its own profile, at the workbench."""
    with opened(tmp_path, workbench()) as driver:
        yield driver


def test_the_circle_is_translated_in_firefox(firefox: Firefox) -> None:
    """Assembled, loaded and started by its buttons; the tape is circle.eia, and the mill cuts it."""
    firefox.run(
        """const choose = (id, value) => {
          document.getElementById(id).value = value;
          document.getElementById(id).dispatchEvent(new Event("change"));
        };
        const click = (selector) => document.querySelector(selector).click();
        choose("sources", "eia.pal");
        click("#assemble");
        click("#load");
        choose("shelf", "circle.asc");
        document.getElementById("speed").selectedIndex = 3;
        document.getElementById("speed").dispatchEvent(new Event("change"));
        click("[data-key=start]");"""
    )
    firefox.until("window.workbench.machine.outOfTape()")
    time.sleep(0.3)
    punched = firefox.run("return window.workbench.machine.teletype.punch.frames")
    assert bytes(punched) == shelf.read_bundled("circle.eia")
    firefox.run("document.getElementById('to-mill').click()")
    label = firefox.run("return document.getElementById('close-label').textContent")
    assert "circle of 1.750 in about 4.000, 4.000" in label
