"""Every size: nothing that can be pressed is out of reach, and nothing complains."""

from pathlib import Path
from typing import Any

import pytest

from tests.pdp8.web.browsing import Browser, Page, click, until, visit

_SIZES = [
    (240, 320), (280, 653), (300, 180), (320, 256), (320, 480), (320, 568), (341, 192),
    (360, 640), (390, 844), (400, 300), (412, 915), (480, 480), (480, 854), (500, 500), (512, 384), (540, 720),
    (568, 320), (600, 300), (640, 360), (667, 375), (683, 384), (700, 400), (768, 1024), (800, 600),
    (820, 1180), (844, 390), (915, 412), (960, 540), (1024, 600), (1024, 768), (1180, 820),
    (1280, 720), (1366, 768), (1440, 900), (1600, 1200), (1920, 1080), (2160, 3840), (2560, 1440),
    (3440, 1440), (3840, 2160),
]  # fmt: skip
_OUT_OF_REACH = """() => {
  const room = document.querySelector("#room:not([hidden])"), bad = [];
  const all = (room ?? document).querySelectorAll("button, a[href], input, select, textarea, summary");
  for (const each of all) {
    if (!each.checkVisibility({ visibilityProperty: true }) || each.closest("dialog:not([open])")) continue;
    if (each.matches(".skip")) each.focus({ preventScroll: true });
    each.scrollIntoView({ block: "center", inline: "center" });
    const { left, right, top, bottom, width, height } = each.getBoundingClientRect();
    const there = document.elementFromPoint((left + right) / 2, (top + bottom) / 2);
    const hit = each.contains(there) || [...(each.labels ?? [])].some((label) => label.contains(there));
    if (each.matches(".skip")) each.blur();
    const small = room && innerWidth >= 320 && Math.min(width, height) < 23.9;
    const wide = left < -1 || right > innerWidth + 1;
    if ((!hit || wide || small) && !each.matches(".skip:last-child"))
      bad.push([each.id || each.ariaLabel || each.textContent, left, top, width, height, there?.className]);
  }
  const { scrollWidth } = document.documentElement;
  if (scrollWidth > innerWidth + 1) bad.push(["wider", scrollWidth]);
  return bad;
}"""


def _at_rest(page: Page) -> Any:
    until(page, "!workbench.room.camera.moves")
    page.wait_for_timeout(150)
    return page.evaluate(_OUT_OF_REACH)


@pytest.mark.slow("forty windows, in each the room, the panel, the tape, and the desk's tabs, 3 min")
@pytest.mark.parametrize(("width", "height"), _SIZES)
def test_nothing_is_out_of_reach(browser: Browser, file: Path, width: int, height: int) -> None:
    """In the story, at the taken panel, while one types, beside the tape, and at each tab of the desk."""
    with visit(
        browser, file.as_uri(), viewport={"width": width, "height": height}, reduced_motion="reduce"
    ) as page:
        assert _at_rest(page) == []
        click(page, "#take")
        assert _at_rest(page) == []
        while page.locator("#help").is_visible():
            click(page, "#help")
        page.keyboard.type("A")
        until(page, "!document.getElementById('see').hidden")
        assert _at_rest(page) == []
        click(page, "#see")
        until(page, "document.getElementById('tape').open")
        for name in ("Keep the picture", "Back to the machine"):
            page.locator("#tape").get_by_text(name).scroll_into_view_if_needed()
            page.locator("#tape").get_by_text(name).click(trial=True)
        page.keyboard.press("Escape")
        click(page, "#leave")
        for tab in page.get_by_role("tab").all():
            tab.click()
            assert page.evaluate(_OUT_OF_REACH) == [], tab.inner_text()
