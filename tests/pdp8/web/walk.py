"""Walks through the page: steps by its controls, and what each changes (walked.txt).

    python -m tests.pdp8.web.walk [NAME...]   writes walked.txt again: look at what differs

    ## NAME: END OF THE ADDRESS               a page that knows no other
    click #new-program                        a step; ~200 before it: no more than 200 ms pass
      #program-name= program.pal; ...         what it changed: words, attributes @, values =, style ~

A step is `click`, `choose`, `fill`, `slide`, `drop`, `key`, `drag`, `do`, `pass` (walk.mjs) or `reload`;
behind `2: ` it is of another tab of the same browser. What a step changes in the others is in their lines.
"""

import re
import sys
import tempfile
from collections.abc import Iterator
from contextlib import ExitStack
from pathlib import Path
from typing import cast

from pdp8.web import curve, workbench
from tests.pdp8.web import node, small
from tests.pdp8.web.browsing import Page, until

CURVE = "a curve"
"""What begins the names of the walks through the other page."""
WALKED = Path(__file__).with_name("walked.txt")
_STEP = re.compile(r"(?:(\d): )?(?:~(\d+) )?(\w+)(?: ([^=]*?(?:\[[^\]]*\][^=]*?)*))?(?: = (.*))?$")


def walks() -> dict[str, list[tuple[str, list[str]]]]:
    """Return {name: [(step, what it changed)]}; the first step of each opens the page."""
    found: dict[str, list[tuple[str, list[str]]]] = {}
    for line in WALKED.read_text(encoding="utf-8").splitlines():
        if line.startswith("## "):
            steps = found.setdefault(line[3:], [])
        elif line.startswith("  "):
            steps[-1][1].append(line[2:])
        elif line:
            steps.append((line, []))
    return found


class Walk:
    """A walk in pages of one browser."""

    def __init__(self, file: Path, end: str, entry: str) -> None:
        self.context = small.Context(file, entry=entry)
        self.end = end
        self.tabs: dict[str, small.Small] = {}

    def tab(self, name: str) -> small.Small:
        """The tab of that name, opened when it is named first."""
        if name not in self.tabs:
            self.tabs[name] = self.context.new_page()
            self._open(self.tabs[name])
            self.tabs[name].evaluate("walk.begin()")
        return self.tabs[name]

    def _open(self, page: small.Small) -> None:
        if page.process:
            page.reload()
        else:
            page.goto(self.context.file.as_uri() + self.end)
        until(cast("Page", page), "!!(window.workbench?.ready ?? window.curve)")
        page.wait_for_timeout(400)

    def step(self, line: str) -> list[str]:
        """Do the step; return what it changed, a line for each page that it changed."""
        match = _STEP.fullmatch(line)
        assert match, line
        name, milliseconds, way, selector, value = match.groups()
        page = self.tab(name or "1")
        if way == "reload":
            before = page.evaluate("walk.state()")
            self._open(page)
            said = page.evaluate("(before) => walk.begin(before) ?? walk.since()", before)
        else:
            given = [way, selector or "", value or ""]
            said = page.evaluate(
                "([given, milliseconds]) => walk.step(given, milliseconds)",
                [given, int(milliseconds) if milliseconds else None],
            )
        others = ((at, each.evaluate("walk.since()")) for at, each in self.tabs.items() if each is not page)
        return [*([said] if said else []), *(f"{at}: {other}" for at, other in others if other)]

    def close(self) -> None:
        for page in [*self.context.pages]:
            page.close()


def walked(file: Path, name: str) -> Iterator[tuple[str, list[str], list[str]]]:
    """Yield each step of a walk, what it has to change, and what it changed."""
    with ExitStack() as stack:
        walk = Walk(file, name.partition(": ")[2], "curve" if name.startswith(CURVE) else "workbench")
        stack.callback(walk.close)
        for step, wanted in walks()[name]:
            try:
                seen = walk.step(step)
            except AssertionError as error:
                seen = [str(error).partition("\n")[0]]
            yield step, wanted, seen


def pages(folder: Path) -> dict[bool, Path]:
    """The workbench and the page of the curve, {whether it is this: its file}."""
    found = {}
    for name, make in (("pdp8", workbench.page), ("curve", curve.page)):
        found[name == "curve"] = folder / f"{name}.html"
        found[name == "curve"].write_text(node.page(name, make), encoding="utf-8")
    return found


def main() -> None:
    """Walk, and write down what is seen."""
    names = sys.argv[1:]
    with tempfile.TemporaryDirectory() as folder:
        files = pages(Path(folder))
        seen = {
            name: [(step, now) for step, _, now in walked(files[name.startswith(CURVE)], name)]
            if not names or name.partition(":")[0] in names
            else steps
            for name, steps in walks().items()
        }
    text = "\n".join(
        f"## {name}\n"
        + "".join(f"{step}\n" + "".join(f"  {line}\n" for line in lines) for step, lines in steps)
        for name, steps in seen.items()
    )
    WALKED.write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main()
