"""Every size: nothing that can be pressed is out of reach, and nothing complains."""

from pathlib import Path

import pytest

from tests.pdp8.web.browsing import Browser, Page, click, until, visit

_SIZES = [
    (240, 320), (280, 653), (300, 180), (320, 256), (320, 480), (320, 568), (341, 192), (360, 640),
    (390, 844), (400, 300), (412, 915), (480, 480), (480, 854), (500, 500), (512, 384), (540, 720),
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


_FRAMES = "(async () => { for (let n = 4; n--; ) await new Promise(requestAnimationFrame); })()"
"""The window is laid out, what is told measured, the camera moved, what it looks at laid out."""
_GROUPS = 5
"""The page is opened at so many sizes; from each the window becomes others."""


@pytest.mark.slow("24 windows, in each the room, the panel, the tape, and the desk's tabs; 40 by WHOLE=1")
@pytest.mark.parametrize(
    "group", [*range(3), *(pytest.param(n, marks=pytest.mark.rare("30 s each")) for n in range(3, _GROUPS))]
)
def test_nothing_is_out_of_reach(browser: Browser, file: Path, group: int) -> None:
    """In the story, at the taken panel, while one types, beside the tape, and at each tab of the desk."""
    sizes = _SIZES[group::_GROUPS]
    width, height = sizes[0]
    viewport = {"width": width, "height": height}
    with visit(browser, file.as_uri(), viewport=viewport, reduced_motion="reduce") as page:
        _all_in_reach(page, sizes)
        click(page, "#take")
        _all_in_reach(page, sizes)
        while page.locator("#help").is_visible():
            click(page, "#help")
        page.keyboard.type("A")
        until(page, "!document.getElementById('see').hidden")
        _all_in_reach(page, sizes)
        click(page, "#see")
        until(page, "document.getElementById('tape').open")
        for size in sizes:
            _window(page, size)
            for name in ("Keep the picture", "Back to the machine"):
                page.locator("#tape").get_by_text(name).scroll_into_view_if_needed()
                page.locator("#tape").get_by_text(name).click(trial=True)
        page.keyboard.press("Escape")
        click(page, "#leave")
        for tab in page.get_by_role("tab").all():
            tab.click()
            _all_in_reach(page, sizes)


def _window(page: Page, size: tuple[int, int]) -> None:
    page.set_viewport_size({"width": size[0], "height": size[1]})
    page.evaluate(_FRAMES)


def _all_in_reach(page: Page, sizes: list[tuple[int, int]]) -> None:
    """What can be pressed is within reach in windows of these sizes; the window has the first again then."""
    for size in sizes:
        _window(page, size)
        until(page, "!(workbench.room.open && workbench.room.camera.moves)")
        assert page.evaluate(_OUT_OF_REACH) == [], size
    _window(page, sizes[0])
