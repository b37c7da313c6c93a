"""The page in Node.js, on a small document (dom.mjs), by those of Playwright's methods that need no layout.

Each page is a process of its own; those of a context share what their browser keeps. Time passes only when it
is waited for.
"""

import json
import select
import subprocess
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any, cast

import pytest

from tests.pdp8.web import browsing, node
from tests.pdp8.web.browsing import Page, until

LONGEST = 120
"""Seconds in which an answer comes; more is a loop that does not end."""


BOTH = (
    pytest.param("node", marks=node.needs_node),
    pytest.param("chromium", marks=pytest.mark.slow("in a browser")),
)
"""The parameters of a fixture that is `opened`."""


def opened(request: pytest.FixtureRequest, file: Path, end: str, **options: Any) -> Iterator[Page]:
    """A page on the small document, or in Chromium, as the parameter says."""
    if request.param == "node":
        with visit(file, end) as made:
            yield cast("Page", made)
        return
    options = {"viewport": {"width": 1366, "height": 768}} | options
    with browsing.visit(request.getfixturevalue("browser"), file.as_uri() + end, **options) as page:
        yield page


@contextmanager
def visit(file: Path, end: str = "", **options: Any) -> Iterator["Small"]:
    """A page that knows no other."""
    context = Context(file, **options)
    page = context.new_page()
    try:
        page.goto(file.as_uri() + end)
        until(cast("Page", page), "!!(window.workbench?.ready ?? window.curve)")
        yield page
    finally:
        for other in [*context.pages]:
            other.close()


class Context:
    """A browser, with what it keeps, and its pages."""

    def __init__(self, file: Path, reduced: bool = False, entry: str = "workbench") -> None:
        self.file = file
        self.entry = entry
        self.reduced = reduced
        self.kept: dict[str, str] = {}
        self.pages: list[Small] = []

    def new_page(self) -> "Small":
        return Small(self)

    def tell(self, changes: list[tuple[str, str | None]], by: "Small") -> None:
        """Keep what a page has changed, and tell the others."""
        for key, text in changes:
            if text is None:
                self.kept.pop(key, None)
            else:
                self.kept[key] = text
        for other in self.pages if changes else ():
            if other is not by and other.process:
                other.asked(another=changes)


class Small:
    """A page, by the methods of Playwright's that do not need a layout."""

    def __init__(self, context: Context) -> None:
        self.context = context
        self.own: dict[str, str] = {}
        self.state: Any = None
        self.scripts: list[str] = []
        self.process: subprocess.Popen[str] | None = None
        self.url = "about:blank"
        self.keyboard = Keyboard(self)
        context.pages.append(self)

    def goto(self, address: str, state: Any = None) -> None:
        """Leave the page, and open another; only the end of the address may change."""
        self._leave()
        self.url, self.state = address, state
        if address.startswith("about:"):
            return
        context = self.context
        given = {
            "file": str(context.file), "address": address, "scripts": self.scripts, "kept": context.kept,
            "own": self.own, "reduced": context.reduced, "entry": context.entry, "state": self.state,
        }  # fmt: skip
        self.process = subprocess.Popen(
            [str(node.NODE), str(node.modules() / "served.mjs")],
            stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True, encoding="utf-8",
        )  # fmt: skip
        assert self.process.stdin is not None
        self.process.stdin.write(json.dumps(given) + "\n")

    def reload(self) -> None:
        self.goto(self.url, self.state)

    def close(self, run_before_unload: bool = False) -> None:
        """Close the tab."""
        del run_before_unload
        self._leave()
        if self in self.context.pages:
            self.context.pages.remove(self)

    def _leave(self) -> None:
        if self.process is None:
            return
        if self.process.poll() is None:
            self.evaluate("dispatchEvent(new Event('pagehide'))")
            self.process.kill()
        self.process.communicate()
        self.process = None

    def asked(self, **what: Any) -> Any:
        assert self.process is not None
        assert self.process.stdin is not None
        assert self.process.stdout is not None
        self.process.stdin.write(json.dumps(what) + "\n")
        self.process.stdin.flush()
        if not select.select([self.process.stdout], [], [], LONGEST)[0]:
            self.process.kill()
            raise AssertionError("it does not end")
        line = self.process.stdout.readline()
        assert line, "the page has ended"
        answer = json.loads(line)
        self.url, self.state = answer["address"], answer["state"]
        self.own = answer.get("own", self.own)
        self.context.tell(answer["changes"], self)
        assert not answer["complaints"], answer["complaints"]
        assert "error" not in answer, answer["error"]
        if answer.get("reloaded"):
            self.reload()
        return answer.get("value")

    def evaluate(self, code: str, more: Any = None) -> Any:
        return self.asked(code=code, more=more)

    def wait_for_timeout(self, milliseconds: float) -> None:
        self.asked(**{"pass": milliseconds})

    @contextmanager
    def expect_download(self) -> Iterator["Download"]:
        """A file that is given, in a `value` as Playwright has it."""
        found = Download()
        self.evaluate("void (dom.saved.length = 0)")
        yield found
        self.wait_for_timeout(25)
        name, content = self.evaluate(
            "async () => { const [[name, address]] = dom.saved; return [name, await dom.contents(address)]; }"
        )
        found.suggested_filename, found.content = name, bytes(content)

    def add_init_script(self, script: str) -> None:
        self.scripts.append(script)

    def locator(self, selector: str, has_text: str = "") -> "Locator":
        return Locator(self, selector + (f":has-text({has_text})" if has_text else ""))

    def get_by_role(self, role: str, name: str, exact: bool = True) -> "Locator":
        return Locator(self, "").get_by_role(role, name, exact)


class Download:
    """A file that the page has given."""

    suggested_filename = ""
    content = b""

    @property
    def value(self) -> "Download":
        return self

    def path(self) -> "Download":
        return self

    def read_bytes(self) -> bytes:
        return self.content

    def read_text(self) -> str:
        return self.content.decode()


class Keyboard:
    """Keys, pressed where the focus is."""

    def __init__(self, page: Small) -> None:
        self.page = page

    def press(self, keys: str) -> None:
        *held, key = keys.split("+") if len(keys) > 1 else [keys]
        more = {f"{name.lower().replace('control', 'ctrl')}Key": True for name in held}
        key = " " if key == "Space" else key
        self.page.evaluate("([key, more]) => document.activeElement.press(key, more)", [key, more])

    def type(self, text: str) -> None:
        for key in text:
            self.press(key)


class Locator:
    """Elements by a selector: all, or one of them."""

    def __init__(self, page: Small, selector: str, at: int | None = None) -> None:
        selector, _, number = selector.partition(" >> nth=")
        self.page = page
        self.selector = selector
        self.at = int(number) if number else at

    def get_by_role(self, role: str, name: str, exact: bool = True) -> "Locator":
        """What has a name: a button, a link."""
        del exact
        tag = {"link": "a", "img": "img"}.get(role, role)
        return Locator(self.page, f"{self.selector} {tag}:named({name})".strip())

    @property
    def first(self) -> "Locator":
        return self.nth(0)

    @property
    def last(self) -> "Locator":
        return self.nth(-1)

    def nth(self, at: int) -> "Locator":
        return Locator(self.page, self.selector, at)

    def evaluate_all(self, code: str, more: Any = None) -> Any:
        """Return what a function says of all, of those that there are."""
        return self.page.evaluate(
            f"([selector, at, more]) => ({code})([...document.querySelectorAll(selector)]"
            ".slice(...(at === null ? [0] : [at, at + 1 || undefined])), more)",
            [self.selector, self.at, more],
        )

    def evaluate(self, code: str, more: Any = None) -> Any:
        """Return what a function says of the one that there is, or comes soon."""
        for _ in range(200):
            if self.count():
                break
            self.page.wait_for_timeout(25)
        return self.evaluate_all(
            f"(all, more) => {{ if (all.length !== 1) throw new Error(`${{all.length}} of them`);"
            f" return ({code})(all[0], more); }}",
            more,
        )

    def _at_hand(self, code: str, more: Any = None) -> Any:
        return self.evaluate(
            "(it, more) => { if (it.disabled || !it.checkVisibility())"
            " throw new Error(`${it.outerHTML} cannot be used`);"
            f" return ({code})(it, more); }}",
            more,
        )

    def click(self) -> None:
        self._at_hand("(it) => it.point()")

    def fill(self, text: str) -> None:
        self._at_hand("(it, text) => it.fill(text)", text)

    def press(self, key: str) -> None:
        self.evaluate("(it) => it.focus()")
        self.page.keyboard.press(key)

    def focus(self) -> None:
        self._at_hand("(it) => it.focus()")

    def check(self) -> None:
        self._at_hand("(it) => it.checked || it.click()")

    def select_option(self, value: str = "", label: str = "", index: int = -1) -> None:
        self._at_hand(
            "(it, [value, label, index]) => it.choose((it.options[index] ?? it.options.find((each) =>"
            " label ? each.label.trim() === label : each.value === value)).value)",
            [value, label, index],
        )

    def count(self) -> int:
        return int(self.evaluate_all("(all) => all.length"))

    def is_visible(self) -> bool:
        return bool(self.evaluate_all("(all) => all.some((each) => each.checkVisibility())"))

    def is_hidden(self) -> bool:
        return not self.is_visible()

    def inner_text(self) -> str:
        return str(self.evaluate("(it) => it.innerText"))

    def all_inner_texts(self) -> list[str]:
        return list(self.evaluate_all("(all) => all.map((each) => each.innerText)"))

    def input_value(self) -> str:
        return str(self.evaluate("(it) => it.value"))

    def get_attribute(self, name: str) -> str | None:
        found: str | None = self.evaluate("(it, name) => it.getAttribute(name)", name)
        return found
