"""Where visitors who had never seen the page lost their way: what is typed or pressed at once."""

from pathlib import Path

import pytest

from tests.pdp8.web.browsing import Browser, Page, click, in_chromium, until, visit

_TABLET, _PHONE = {"width": 820, "height": 1180}, {"width": 390, "height": 844}


def _run(page: Page, text: str) -> None:
    page.evaluate("(text) => { workbench.editor.put('own.pal', text); workbench.editor.run(); }", text)


def test_what_goes_wrong_in_the_afternoon_is_read(page: Page) -> None:
    """A program that is not run: that is seen beside what the afternoon says."""
    page.evaluate("workbench.afternoon.go(6e10)")
    _run(page, "*200\n\tTAD FIVEX\n\tHLT\n$\n")
    said = "document.getElementById('said')"
    for _ in range(2):
        until(page, f"{said}.textContent.includes('Not run: line 2, undefined')")
        assert page.evaluate(f"{said}.className") == ""
        page.wait_for_timeout(200)  # longer than the afternoon waits before it says where it is
    assert page.evaluate("workbench.afternoon.on")


def test_a_touched_picture_asks_for_the_name(room: Page) -> None:
    """The keys of the Teletype in the picture look as if they could be pressed."""
    click(room, "#take")
    for _ in range(9):
        if room.evaluate("!document.getElementById('help').hidden"):
            click(room, "#help")
    until(room, "workbench.room.typing")
    room.evaluate("document.activeElement.blur()")
    room.evaluate("document.querySelector('#room canvas').click()")
    assert room.evaluate("document.activeElement.id") == "mine"


@pytest.mark.slow("in a browser")
def test_the_room_on_a_tablet_and_a_phone(browser: Browser, file: Path) -> None:
    """The scene has most of the window, its acts have names; what guides does not push the switches about."""
    for size, part in ((_TABLET, 0.62), (_PHONE, 0.55)):
        with visit(browser, file.as_uri(), viewport=size, reduced_motion="reduce", has_touch=True) as page:
            assert page.evaluate("workbench.room.frame.h / innerHeight") > part
            assert "If nothing follows" not in page.locator("body").aria_snapshot()
            named = page.get_by_role("button", name="Translate").evaluate(
                "(each) => getComputedStyle(each).fontSize"
            )
            assert (named == "0px") == (size is _PHONE)
            click(page, "#take")
            places = set()
            while page.locator("#help").is_visible():
                places.add(page.evaluate("Math.round(workbench.room.frame.h)"))
                click(page, "#help")
            assert len(places) == 1


@in_chromium
def test_a_cut_is_seen_whole(page: Page) -> None:
    """From the end of the page the plate comes into sight, and its blocks are read to their ends."""
    colour = "(id) => getComputedStyle(document.getElementById(id)).backgroundColor"
    click(page, "[data-opens=parts]")
    page.locator("[name=radius]").fill("0.25")
    click(page, "#part-punch")
    until(page, "!document.getElementById('part-translate').disabled")
    assert page.evaluate(colour, "part-translate") == page.evaluate(colour, "play")
    assert page.evaluate(colour, "part-punch") != page.evaluate(colour, "play")
    page.evaluate("scrollTo(0, 1e6)")
    page.evaluate("workbench.mill.cut('circle.eia')")
    bar = "document.getElementById('time').getBoundingClientRect().bottom"
    assert page.evaluate(f"document.getElementById('tabs').getBoundingClientRect().top > {bar}")
    assert (
        page.evaluate(
            "(({ scrollWidth, clientWidth }) => scrollWidth - clientWidth)(document.getElementById('blocks'))"
        )
        <= 0
    )
