"""How long a page keeps its thread: the longest task of each part of a visit, in headless Chromium.

A task is what runs before the page has its turn again; a visitor feels one of over 50 ms. Processor time,
from Chromium's trace, beside a task that adds ten million numbers, in the same run.

    python -m benchmarks.tasks [--repeat 5]
"""

import json
import sys
import tempfile
from pathlib import Path
from typing import TYPE_CHECKING

import click
from rich.console import Console
from rich.table import Table

from pdp8.replay import replay
from pdp8.web.workbench import page
from tests.pdp8.web.browsing import launched, until

if TYPE_CHECKING:
    from playwright.sync_api import Browser, Page

_ADD = "() => { let sum = 0; for (let at = 0; at < 1e7; at++) sum = (sum + at) & 0o7777; return sum; }"
_COUNT = """() => {  // a loop that has no end, and no turn of it is like the one before
  const { processor } = workbench.machine;
  [0o2205, 0o7000, 0o5200, 0o5200].forEach((word, at) => processor.deposit(0o200 + at, word));
  processor.pc = 0o200;
}"""


def add(tab: "Page") -> None:
    """Add ten million numbers in one task."""
    tab.evaluate(_ADD)


def opening(tab: "Page") -> None:
    """Let the page open at an instant of the afternoon."""
    tab.reload()
    until(tab, "window.workbench?.ready && workbench.afternoon.on")


def afternoon(tab: "Page") -> None:
    """Play 34 minutes at their quickest."""
    tab.locator("#speed").select_option(label="5 minutes a second")
    tab.locator("#play").click()
    until(tab, "workbench.afternoon.script.now > 4e10")


def taking_over(tab: "Page") -> None:
    """Flip a switch, and let the translation end at full speed."""
    tab.locator(".rocker").first.click()
    tab.locator("#speed").select_option(label="as fast as it goes")
    until(tab, "workbench.machine._out_of_tape()")


def full_speed(tab: "Page") -> None:
    """Run a hundred million instructions."""
    tab.locator("[data-key=stop]").click()
    tab.evaluate(_COUNT)
    tab.locator("[data-key=cont]").click()
    begun = tab.evaluate("workbench.machine.processor.instructions")
    until(tab, f"workbench.machine.processor.instructions > {begun} + 1e8")


def longest(trace: bytes) -> float:
    """Return the milliseconds of the processor that the longest task of the page's thread took."""
    events = json.loads(trace)["traceEvents"]
    threads = {each["tid"] for each in events if each.get("args", {}).get("name") == "CrRendererMain"}
    tasks = (each for each in events if each["name"].endswith("RunTask") and each["tid"] in threads)
    return float(max(task.get("tdur", 0) for task in tasks)) / 1000


def visit(browser: "Browser", file: Path) -> dict[str, float]:
    """Return the longest task of each part of a visit, in milliseconds."""
    tab = browser.new_page()
    tab.goto(file.as_uri() + "#t=0")
    taken = {}
    for part in (add, opening, afternoon, taking_over, full_speed):
        browser.start_tracing(page=tab, categories=["toplevel"])
        part(tab)
        taken[part.__name__.replace("_", " ")] = longest(browser.stop_tracing())
    tab.close()
    return taken


@click.command()
@click.option("--repeat", type=click.IntRange(min=1), default=5, show_default=True, help="Visits.")
def main(repeat: int) -> None:
    """Visit the page some times and show the longest tasks."""
    with tempfile.TemporaryDirectory() as folder, launched() as browser:
        file = Path(folder) / "page.html"
        file.write_text(page(afternoon=replay("circle")), encoding="utf-8")
        visits = [visit(browser, file) for _ in range(repeat)]
    table = Table(title=f"longest task, ms of the processor, {repeat} visits")
    for head in ("part", "least", "most", "× adding ten million"):
        table.add_column(head, justify="left" if head == "part" else "right")
    for part in visits[0]:
        tasks = [each[part] for each in visits]
        ratio = min(each[part] / each["add"] for each in visits)
        table.add_row(part, f"{min(tasks):.0f}", f"{max(tasks):.0f}", f"{ratio:.1f}")
    Console(width=None if sys.stdout.isatty() else 120).print(table)


if __name__ == "__main__":
    main()
