"""Every control of the workbench has a role and a name, and works by mouse, by touch and by keyboard.

The page is asked for its controls: one that is not in CONTROLS, or is no longer there, fails the test.
"""

from typing import TYPE_CHECKING

import pytest

from tests.pdp8.web.browsing import until
from tests.pdp8.web.controls import CONTROLS, CUT, LOADED, OPEN, WRONG

if TYPE_CHECKING:
    from playwright.sync_api import Locator, Page

_ALL = f"() => {{ {CUT} {LOADED} {WRONG} {OPEN} }}"
"""Everything that can be there is there: a listing, messages, blocks, the card."""

_FOUND = """(selectors) => {
  const controls = "button, input:not([hidden]), select, textarea, summary, a[href], [tabindex='0']";
  return [...document.querySelectorAll(controls)].map((control) =>
    selectors.find((selector) => control.matches(selector)) ?? control.outerHTML.slice(0, 100));
}"""


def test_every_control_is_tried(page: "Page") -> None:
    """None is in the page that is not in the table, and none in the table that is not in the page."""
    page.evaluate(_ALL)
    assert set(page.evaluate(_FOUND, list(CONTROLS))) == set(CONTROLS)


def test_every_control_has_a_role_and_a_name(page: "Page") -> None:
    """As the browser tells them to a screen reader, on every tab."""
    session = page.context.new_cdp_session(page)
    page.evaluate(_ALL)
    for name in ("program", "debugger", "mill", "exercises"):
        page.evaluate(f"workbench.tabs.open('{name}')")
        nodes = session.send("Accessibility.getFullAXTree")["nodes"]
        nameless = [
            node
            for node in nodes
            if any(
                each["name"] == "focusable" and each["value"]["value"] for each in node.get("properties", ())
            )
            and node["role"]["value"] != "RootWebArea"
            and (node["role"]["value"] in ("generic", "none") or not node.get("name", {}).get("value"))
        ]
        assert nameless == []


@pytest.mark.parametrize("way", ["mouse", "touch", "keyboard"])
def test_every_control_works(page: "Page", way: str) -> None:
    """What it is there for is seen to happen: 60 controls, so it takes some seconds."""
    idle = []
    for selector, control in CONTROLS.items():
        page.evaluate(f"() => {{ {control.before} workbench.show(); }}")
        page.evaluate(f"() => {{ window.earlier = JSON.stringify({control.watch}); }}")
        target = page.locator(selector).first
        if way == "keyboard":
            page.locator(control.focus or selector).first.focus()
            _press(page, control.keys)
        else:
            target.click() if way == "mouse" else target.tap()
            if _is(target, _FIELDS):
                _press(page, control.keys)
            if _is(target, "select"):
                page.keyboard.press("Enter")  # the list that the pointer has opened
        try:
            until(page, f"JSON.stringify({control.watch}) !== window.earlier")
        except AssertionError:
            idle.append((selector, control.watch, page.evaluate("window.earlier")))
    assert idle == []


def _press(page: "Page", keys: str) -> None:
    for key in keys.split():
        page.keyboard.press(key)


_FIELDS = "select, textarea, input:not([type=checkbox]), [tabindex='0']:not(button)"
"""What a pointer gives the focus to, and keys then work."""


def _is(target: "Locator", selector: str) -> bool:
    return bool(target.evaluate("(control, selector) => control.matches(selector)", selector))
