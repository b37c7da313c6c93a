"""Every control of the workbench works by mouse, by touch and by keyboard; axe holds its role and its name.

The page is asked for its controls: one that is not in CONTROLS, or is no longer there, fails the test.
"""

import json

import pytest

from tests.pdp8.web.browsing import Page, Tab
from tests.pdp8.web.controls import CONTROLS, CUT, LOADED, OPEN, WRONG, Control

_ALL = f"{CUT} {LOADED} {WRONG} {OPEN}"
"""Everything that can be there is there: a listing, messages, blocks, the card."""
_OF_A_FAMILY = 12
"""How many are tried of those that are alike: all the switches, some of the words of core."""
_FIELDS = "select, textarea, input:not([type=checkbox]), [tabindex='0']:not(button)"
"""What a pointer gives the focus to, and keys then work."""
_FOUND = """(selectors) => {
  const controls = "button, input:not([hidden]), select, textarea, summary, a[href], [tabindex='0']";
  return [...document.querySelectorAll(controls)].map((control) =>
    selectors.find((selector) => control.matches(selector)) ?? control.outerHTML.slice(0, 100));
}"""
_NAMED = """() => ["click", "change", "input", "submit"].flatMap((kind) =>
  [...document.querySelectorAll(`[data-${kind}]`)].map((control) => control.dataset[kind]))
  .filter((path) => typeof path.split(".").reduce((of, name) => of?.[name], workbench) !== "function")"""


def test_every_control_is_tried(page: Page) -> None:
    """The page and the table have the same controls; what the HTML names is there to be called."""
    page.evaluate(f"() => {{ {_ALL} }}")
    assert set(page.evaluate(_FOUND, list(CONTROLS))) == set(CONTROLS)
    assert page.evaluate(_NAMED) == []


@pytest.mark.slow  # ten seconds and more each: some 100 controls, in each browser
@pytest.mark.parametrize("way", ["mouse", "touch", "keyboard"])
def test_every_control_works(tab: Tab, way: str) -> None:
    """What it is there for is seen to happen."""
    idle = []
    tab.run(f"workbench.afternoon.go(0); {_ALL}")
    tab.until("workbench.afternoon.script")
    for selector, control in CONTROLS.items():
        count = tab.run(f"return document.querySelectorAll({json.dumps(selector)}).length")
        for which in range(min(count, _OF_A_FAMILY)):
            tab.run(f"{control.before} workbench.show();")
            tab.run(f"window.earlier = JSON.stringify({control.watch});")
            # twice: on a busy machine a list is not open yet when its key comes
            if not any(_works(tab, control, selector, which, way) for _ in range(2)):
                idle.append((selector, which, control.watch, tab.run("return window.earlier")))
                assert len(idle) < 3, idle  # each takes a minute
    assert not idle, "\n".join(map(str, idle))


def _works(tab: Tab, control: Control, selector: str, which: int, way: str) -> bool:
    """Work a control; tell whether what it is there for is seen."""
    first = f"document.querySelector({json.dumps(selector)})"
    if way == "keyboard":
        focus = json.dumps(control.focus or selector)
        tab.run(f"document.querySelectorAll({focus})[{0 if control.focus else which}].focus()")
    else:
        tab.point(selector + control.within, which, way)
    if way == "keyboard" or tab.run(f'return {first}.matches("{_FIELDS}")'):
        for keys in control.keys.split():
            tab.press(keys)
        if way != "keyboard" and tab.run(f"return {first}.matches('select')"):
            tab.press("Enter")  # the list that the pointer has opened
    try:
        tab.until(f"JSON.stringify({control.watch}) !== window.earlier")
    except AssertionError:
        return False
    return True
