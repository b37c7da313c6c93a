"""How fast the pages are: their machine in Node.js, Chromium and Firefox; the room as a visitor has it.

    mixed      checksum, software multiplication and sieve (mixed.pal)
    counter    a counter whose loop does something, so that no turn of it is passed over

Each is run for some seconds of machine time by the workbench's own `machine.run`, after one run that lets the
engine compile it; the least of the repeats counts, by `performance.now()`.

    paint      ms until the page's first picture
    alive      ms from it until the machine has moved
    shift      how far what is seen jumps while the page opens (Cumulative Layout Shift), room and desk
    script     ms of JavaScript for a picture of the room, median and 95 %, in calm acts and in busy ones
    frames     pictures a second; a browser without a graphics processor draws them all by itself

The room is opened on a screen of 1366 x 768, and on a telephone whose processor is slowed four times. So is
the page that teaches the method, and read from its top to its end:

    longest    ms of the longest task of the page's own thread: at the opening, and while it is read. Chromium
               tells of none under 50; the least of three visits
    shift      as above, all the way

    python -m benchmarks.pages [--repeat 40] [--room | --curve]
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
from pdp8.web import curve
from pdp8.web.workbench import page
from tests.pdp8.web import firefox
from tests.pdp8.web.browsing import CHROMIUM, DESK, launched, until, visit
from tests.pdp8.web.node import NODE, in_node, modules

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
    imported = 'const { Machine } = await import("@/pdp8/computer/machine.mjs");'
    return in_node(f"async () => {{ {imported} return {call}; }}", folder=modules(checked=False))


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
        tab.until("!!window.workbench?.ready")
        return tab.run(f"const Machine = window.workbench.machine.constructor; return {call};")


_OBSERVED = """() => {  // before the page's own scripts
  window.shift = 0;
  new PerformanceObserver((list) => {
    for (const each of list.getEntries()) if (!each.hadRecentInput) window.shift += each.value;
  }).observe({ type: "layout-shift", buffered: true });
  const request = window.requestAnimationFrame.bind(window);
  window.taken = [];
  window.requestAnimationFrame = (show) => request((now) => {
    const began = performance.now();
    show(now);
    window.taken.push(performance.now() - began);
    const { script } = window.workbench?.afternoon ?? {};
    if (script?.now > window.earliest) window.moved ??= performance.now();
    window.earliest ??= script?.now; // an id of the page would be in window too
  });
}"""
_LONG = """() => {
  window.longest = 0;
  new PerformanceObserver((list) => {
    for (const each of list.getEntries()) window.longest = Math.max(window.longest, each.duration);
  }).observe({ type: "longtask", buffered: true });
}"""
_PAINTED = "performance.getEntriesByName('first-contentful-paint')[0]?.startTime"
_ACT = """(turn) => {
  const { room } = workbench;
  room.go({ value: turn });
  room.playing = true;
  room.show();
}"""
PARTS = {"print": (1, 0.0), "boot": (3, 0.0), "print, in a hurry": (1, 0.85), "cut, in a hurry": (6, 0.8)}
"""The parts of acts that are looked at: two that are calm, two that are busy."""
VISITORS: dict[str, tuple[dict[str, Any], int]] = {
    "1366 x 768": ({"viewport": {"width": 1366, "height": 768}}, 1),
    "telephone, 4 x slower": ({"viewport": {"width": 390, "height": 844}, "device_scale_factor": 2}, 4),
}


def opening(browser: Any, address: str, options: dict[str, Any], slower: int) -> dict[str, str]:
    """Return what a visitor's page takes, by name."""
    context = browser.new_context(**options)
    context.add_init_script(f"({_OBSERVED})()")
    tab = context.new_page()
    tab.context.new_cdp_session(tab).send("Emulation.setCPUThrottlingRate", {"rate": slower})
    tab.goto(address)
    until(tab, "!!window.moved && !!window.workbench?.ready")
    tab.wait_for_timeout(2000)
    painted, moved = tab.evaluate(_PAINTED), tab.evaluate("window.moved")
    found = {
        "paint": f"{painted:.0f}",
        "alive": f"{moved - painted:.0f}",
        "shift, room": f"{tab.evaluate('shift'):.3f}",
    }
    for name, (turn, part) in PARTS.items():
        tab.evaluate(_ACT, turn)
        tab.evaluate(f"workbench.room.tour.go({turn}, {part})")
        tab.wait_for_timeout(700)
        tab.evaluate("taken.length = 0")
        tab.wait_for_timeout(1500)
        taken = sorted(tab.evaluate("taken"))
        middle, most = taken[len(taken) // 2], taken[len(taken) * 95 // 100]
        found[name] = f"{middle:.1f} / {most:.1f} ms, {len(taken) / 1.5:.0f} a second"
    tab.goto("about:blank")
    tab.goto(address + DESK)
    until(tab, "!!window.workbench?.ready")
    tab.wait_for_timeout(2000)
    found["shift, desk"] = f"{tab.evaluate('shift'):.3f}"
    context.close()
    return found


def reading(browser: Any, address: str, options: dict[str, Any], slower: int) -> tuple[float, float, float]:
    """Return the longest tasks at the opening of the page and while it is read, and the shift."""
    context = browser.new_context(**options)
    context.add_init_script(f"({_OBSERVED})(); ({_LONG})()")
    tab = context.new_page()
    tab.context.new_cdp_session(tab).send("Emulation.setCPUThrottlingRate", {"rate": slower})
    tab.goto(address)
    until(tab, "!!window.curve")
    tab.wait_for_timeout(2000)
    opened = tab.evaluate("longest")
    tab.evaluate("window.longest = 0")
    for down in range(0, tab.evaluate("document.documentElement.scrollHeight"), 300):
        tab.evaluate(f"scrollTo(0, {down})")
        tab.wait_for_timeout(250)
    tab.wait_for_timeout(2000)
    found = opened, tab.evaluate("longest"), tab.evaluate("shift")
    assert all(tab.evaluate("[...document.querySelectorAll('.said')].map((said) => said.textContent)"))
    context.close()
    return found


def read() -> Iterator[tuple[str, str, str]]:
    """Yield for each visitor of the page of the method what, and how much of it."""
    with tempfile.TemporaryDirectory() as folder, launched() as browser:
        file = Path(folder) / "curve.html"
        file.write_text(curve.page(), encoding="utf-8")
        for visitor, (options, slower) in VISITORS.items():
            visits = [reading(browser, file.as_uri(), options, slower) for _ in range(3)]
            opening_, reading_, shift = (min(each) for each in zip(*visits, strict=True))
            yield visitor, "longest, opening", f"{opening_:.0f}" if opening_ else "< 50"
            yield visitor, "longest, reading", f"{reading_:.0f}" if reading_ else "< 50"
            yield visitor, "shift", f"{shift:.3f}"


def visited() -> Iterator[tuple[str, str, str]]:
    """Yield for each visitor what, and how much of it."""
    with written() as address, launched() as browser:
        for visitor, (options, slower) in VISITORS.items():
            yield from (
                (visitor, what, said) for what, said in opening(browser, address, options, slower).items()
            )


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
@click.option("--room", is_flag=True, help="The room alone, without the kernels.")
@click.option("--curve", "method", is_flag=True, help="The page of the method alone.")
def main(repeat: int, room: bool, method: bool) -> None:
    """Run the kernels on the pages' machine, visit the room, read the page of the method."""
    console = Console(width=None if sys.stdout.isatty() else 120)
    visits = {"the room": visited, "the page of the method": read}
    if room or method:
        visits.pop("the page of the method" if room else "the room")
    for name, visit_ in visits.items():
        table = Table(title=f"{name}, as a visitor has it")
        for column in ("visitor", "", "measured"):
            table.add_column(column)
        for row in visit_() if CHROMIUM else ():
            table.add_row(*row)
        console.print(table)
    if room or method:
        return
    table = Table(title=f"the pages' machine, least of {repeat}")
    for column in ("", "kernel", "× a real 8/L"):
        table.add_column(column, justify="right" if column.startswith("×") else "left")
    for place, name, ratio in measured(repeat):
        table.add_row(place, name, f"{ratio:,.0f}")
    console.print(table)


if __name__ == "__main__":
    main()
