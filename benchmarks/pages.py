"""How fast the machine of the pages is: in Node.js, in headless Chromium, in headless Firefox.

    mixed      checksum, software multiplication and sieve (mixed.pal)
    counter    a counter whose loop does something, so that no turn of it is passed over

Each is run for some seconds of machine time by the workbench's own `machine.run`, after one run that lets the
engine compile it; the least of the repeats counts, by `performance.now()`.

    python -m benchmarks.pages [--repeat 40]
"""

import json
import sys
import tempfile
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import click
from rich.console import Console
from rich.table import Table

import pal
from benchmarks.kernels import kernel
from pdp8.web.workbench import page
from tests.pdp8.web import firefox
from tests.pdp8.web.browsing import CHROMIUM, launched, visit
from tests.pdp8.web.node import NODE, in_node

COUNTER = (
    "*200\nLOOP,\tTAD SUM\n\tIAC\n\tDCA SUM\n\tISZ COUNT\n\tJMP LOOP\n\tJMP LOOP\nCOUNT,\t0\nSUM,\t0\n$\n"
)
SECONDS = 1.0
"""Machine time of one run: some 15 ms, short enough to be left alone on a busy machine."""

_RUN = """(Machine, kernels, seconds, repeat) => Object.entries(kernels).map(([name, words]) => {
  const times = [];
  for (let run = 0; run <= repeat; run++) {
    const machine = new Machine();
    machine.load(words);
    machine.processor.pc = 0o200;
    machine.panel.start();
    const began = performance.now();
    machine.run(seconds);
    if (run) times.push(performance.now() - began);
    if (machine.elapsed < seconds) throw new Error(`${name} ended`);
  }
  return [name, Math.min(...times) / 1000];
})"""


def kernels() -> dict[str, list[tuple[int, int]]]:
    """Return the words of each kernel."""
    return {"mixed": list(kernel("mixed").items()), "counter": list(pal.assemble(COUNTER).words.items())}


def in_modules(call: str) -> Any:
    """Return what `call` returns in Node.js, with the page's modules as they are."""
    return in_node(
        f'async () => {{ const {{ Machine }} = await import("@/pdp8/computer/machine.mjs"); return {call}; }}'
    )


@contextmanager
def written() -> Iterator[str]:
    """The address of the workbench on disk."""
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "pdp8.html"
        file.write_text(page(), encoding="utf-8")
        yield file.as_uri()


def in_chromium(call: str) -> Any:
    """Return what `call` returns in the workbench in Chromium."""
    with written() as address, launched() as browser, visit(browser, address) as tab:
        return tab.evaluate(f"() => {{ const Machine = workbench.machine.constructor; return {call}; }}")


def in_firefox(call: str) -> Any:
    """Return what `call` returns in the workbench in Firefox."""
    with tempfile.TemporaryDirectory() as profile, written() as address, firefox.opened(Path(profile)) as tab:
        tab.call("WebDriver:Navigate", url=address)
        tab.until("!!window.workbench")
        return tab.run(f"const Machine = window.workbench.machine.constructor; return {call};")


def measured(repeat: int) -> Iterator[tuple[str, str, float]]:
    """Yield where, which kernel, and how many times as fast as a real 8/L."""
    call = f"({_RUN})(Machine, {json.dumps(kernels())}, {SECONDS}, {repeat})"
    places: tuple[tuple[str, str | None, Callable[[str], Any]], ...] = (
        ("Node.js", NODE, in_modules),
        ("Chromium", CHROMIUM, in_chromium),
        ("Firefox", firefox.FIREFOX, in_firefox),
    )
    for name, installed, run in places:
        if installed:
            yield from ((name, label, SECONDS / taken) for label, taken in run(call))


@click.command()
@click.option("--repeat", type=click.IntRange(min=1), default=40, show_default=True, help="Runs of each.")
def main(repeat: int) -> None:
    """Run the kernels on the pages' machine."""
    table = Table(title=f"the pages' machine, least of {repeat}")
    for column in ("", "kernel", "× a real 8/L"):
        table.add_column(column, justify="right" if column.startswith("×") else "left")
    for place, name, ratio in measured(repeat):
        table.add_row(place, name, f"{ratio:,.0f}")
    Console(width=None if sys.stdout.isatty() else 120).print(table)


if __name__ == "__main__":
    main()
