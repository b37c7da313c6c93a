"""Foreign text stays text: no link, file, state, source, name or field makes an element or an attribute.

HOSTILE is an element, an attribute for where it stands in one, and a button that deletes a program.
"""

import base64
import json
import zlib
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from pdp8.computer.hardware.devices import one_of_each
from pdp8.computer.machine import Machine
from pdp8.computer.past.state import save
from pdp8.lessons import form, student
from tests.pdp8.web.browsing import Browser, Page, click, until, visit

HOSTILE = (
    '<x-evil data-evil=1>&lt;b\' data-evil=\' x" data-evil="2" y'
    " <button data-click=editor.remove data-evil=3>z"
)
_FOUND = """() => [...document.querySelectorAll("x-evil, [data-evil]")].map((each) => each.outerHTML)"""


def _clean(page: Page) -> None:
    """Nothing of it became an element, in what is shown by then."""
    page.wait_for_timeout(400)
    assert page.evaluate(_FOUND) == []


def _drop(page: Page, name: str, content: str) -> None:
    page.evaluate("([name, content]) => workbench.take(new File([content], name))", [name, content])


def _reopened(page: Page) -> None:
    page.reload()
    until(page, "!!window.workbench?.ready")


def link(shared: Any) -> str:
    """Return what the address of the page has for a link to `shared`."""
    packed = zlib.compress(json.dumps(shared).encode(), wbits=-15)
    return "#s=" + base64.urlsafe_b64encode(packed).decode().rstrip("=")


def _spoilt(of: Any, keys: bool = False) -> Iterator[Any]:
    """Yield copies of a value for JSON, in each another leaf hostile, or another key."""
    if isinstance(of, dict):
        for key, value in of.items():
            yield from ({**of, key: each} for each in _spoilt(value, keys))
            if keys:
                yield {**of, f"{key}{HOSTILE}": value}
    elif isinstance(of, list) and of:
        yield from ([each, *of[1:]] for each in _spoilt(of[0], keys))
    else:
        yield HOSTILE


def _of_other_kinds(of: Any) -> Iterator[Any]:
    """Yield copies of a table or list, in each another part of another kind than it should be."""
    for key, value in of.items() if isinstance(of, dict) else [*enumerate(of)][:1]:
        parts = _of_other_kinds(value) if isinstance(value, dict | list) else ()
        for each in (HOSTILE, 5, None, [5], {"a": 5}, *parts):
            yield {**of, key: each} if isinstance(of, dict) else [each, *of[1:]]


def _exercise(name: str) -> dict[str, Any]:
    tables: dict[str, Any] = json.loads(student.form(form.read(name)))
    return tables


_TAKEN = """async ([name, ...files]) => {
  const { exercises } = workbench, place = document.getElementById("marks"), said = new Set();
  for (const file of files) {
    exercises.open("add");
    await workbench.take(new File([file], name));
    await exercises.markOpen();
    said.add(workbench.why).add(place.textContent);
    if (document.querySelector("x-evil, [data-evil]")) said.add(`undefined: an element by ${file}`);
  }
  return [...said].filter((words) => /is not (a fun|iter)|Cannot |undefined|\\[object|key$/.test(words));
}"""


@pytest.mark.parametrize(
    "given",
    [
        _exercise("add"),
        _exercise("read-a-frame"),
        {"program": {"name": "a.pal", "text": ""}},
        {"part": {"name": "drill", "typed": {"holes": "1,1"}}},
    ],
)
def test_what_is_of_another_kind(page: Page, given: Any) -> None:
    """A file with a number, a text, a list or a table where something else should be is taken, or refused in
    our words; so are the answers to its exercise.
    """
    files = [json.dumps(each) for each in _of_other_kinds(given)]
    assert page.evaluate(_TAKEN, [f"{HOSTILE}.json", *files]) == []


def test_files(page: Page) -> None:
    """By their names and by what is in them, whatever they are: taken or refused."""
    contents = {
        "pal": f"*200\n/{HOSTILE}\n{HOSTILE}\n\tTEXT {HOSTILE}\nA{HOSTILE},\tHLT\n$\n",
        "asc": "1\r\n",
        "eia": "\1\2\x80",
        "toml": HOSTILE,
        "png": "\0\1\2\3" * 9,
        "json": "{" + HOSTILE,
        "state": '{"format": "' + HOSTILE + '"}',
    }
    for ending, content in contents.items():
        _drop(page, f"{HOSTILE.replace('/', ' ')}.{ending}", content)
        page.wait_for_timeout(100)
        click(page, "[data-opens=program]", "#assemble")
        _clean(page)
    put = "workbench.shelf.put(name, new Uint8Array([1, 2, 0o200]))"
    page.evaluate(f"(name) => {{ workbench.mill.cut({put}); workbench.teletype.mount({put}); }}", HOSTILE)
    _clean(page)


@pytest.mark.slow("each word, key and device of a state, 12 s")
def test_a_state(page: Page) -> None:
    """Each word, key and device of one; the message quotes it."""
    state = json.loads(save(Machine(one_of_each())))
    for spoilt in [*_spoilt(state), *_spoilt(state, keys=True)]:
        _drop(page, "noon.state", json.dumps(spoilt))
        page.wait_for_timeout(10)
        assert page.evaluate(_FOUND) == [], spoilt
    assert "evil" in page.locator("#next").inner_text()


@pytest.mark.parametrize(
    "shared",
    [
        {"program": {"name": HOSTILE, "text": HOSTILE}},
        {"exercise": HOSTILE},
        {"exercise": {"name": HOSTILE, "tables": _exercise("add") | {"title": HOSTILE}}},
        {"machine": {"format": HOSTILE}},
        {"machine": {"core": {"$tape": [HOSTILE, 0, 1]}}},
        {HOSTILE: HOSTILE},
        HOSTILE,
    ],
)
def test_a_link(browser: Browser, file: Path, shared: Any) -> None:
    """A link as anybody may send it; a second visit has what the first one kept."""
    with visit(browser, file.as_uri() + link(shared)) as page:
        _clean(page)
        _reopened(page)
        _clean(page)


def test_what_is_typed_and_kept(page: Page) -> None:
    """Into every field of the page; under a hostile name in the browser's own store; in the address."""
    typed = """(fields, text) => fields.forEach((field) => {
      field.value = text;
      for (const kind of ["input", "change"]) field.dispatchEvent(new Event(kind, { bubbles: true }));
    })"""
    page.locator("input[type=text], textarea").evaluate_all(typed, HOSTILE)
    for button in ("#run-it", "#part-punch", "#new-program", "#delete-program"):
        page.locator(button).evaluate("(button) => button.click()")
        _clean(page)
    page.evaluate("(name) => localStorage.setItem(`pdp8 program: ${name}`, name)", HOSTILE)
    page.evaluate("(name) => localStorage.setItem('pdp8 open', name)", HOSTILE)
    _reopened(page)
    _clean(page)
    page.goto(page.url.split("#")[0] + "#exercise=" + HOSTILE.replace(" ", "%20"))
    until(page, "document.getElementById('next')?.textContent.includes('there is no exercise')")
    _clean(page)


def test_only_one_module_writes_html(browser: Browser, file: Path) -> None:
    """The browser refuses a string as HTML: what forgets to escape is an error, not an element."""
    page = browser.new_page()
    page.goto(file.as_uri())
    refused = "() => { try { document.body.innerHTML = '<b>'; } catch (error) { return error.name; } }"
    assert page.evaluate(refused) == "TypeError"
    page.close()
