"""What the pages cost while they are looked at: the share of a processor that headless Chromium takes.

The renderer's processor time over some seconds, everything in it: scripts, layout, painting in software.

    python -m benchmarks.share [--seconds 20]
"""

import sys
import tempfile
import time
from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING

import click
from rich.console import Console
from rich.table import Table

from pdp8.web import workbench
from tests.pdp8.web.browsing import launched, until

if TYPE_CHECKING:
    from playwright.sync_api import Browser, CDPSession

_GO = """async ([kind, speed]) => {
  const { afternoon } = workbench;
  await afternoon.go(0);
  const act = afternoon.script.day.acts.find((each) => each.kind === kind);
  afternoon.go(act.starts + 2e9);
  if (!speed) return;
  workbench.time.setSpeed(speed);
  afternoon.play(true);
}"""
_TRANSLATE = """(tab) => {
  workbench.parts.name = "circle.asc";
  workbench.parts.translate();
  workbench.time.setSpeed(1);
  workbench.tabs.open(tab);
}"""
_WAIT = """() => {
  workbench.editor.text = "*200\\n\\tKSF\\n\\tJMP .-1\\n$\\n";
  workbench.editor.assemble();
  workbench.editor.load();
  workbench.switches.press("start");
}"""
_PAUSED, _AS_IT_WAS, _QUICKEST = 0, 1, 300

CASES: dict[str, tuple[str, object]] = {
    "afternoon, paused": (_GO, ["translate", _PAUSED]),
    "afternoon as it was, translation": (_GO, ["translate", _AS_IT_WAS]),
    "afternoon as it was, Hydra-Point": (_GO, ["mill", _AS_IT_WAS]),
    "afternoon at its quickest, translation": (_GO, ["translate", _QUICKEST]),
    "afternoon at its quickest, Hydra-Point": (_GO, ["mill", _QUICKEST]),
    "workbench, standing still": ("() => {}", None),
    "workbench, waiting for a key": (_WAIT, None),
    "workbench as it was, translation": (_TRANSLATE, "program"),
    "workbench as it was, with its debugger": (_TRANSLATE, "debugger"),
}


def rendering(session: "CDPSession") -> float:
    """Return the processor's seconds that the renderers have taken."""
    processes = session.send("SystemInfo.getProcessInfo")["processInfo"]
    return float(sum(process["cpuTime"] for process in processes if process["type"] == "renderer"))


def share(browser: "Browser", file: Path, script: str, given: object, seconds: float) -> float:
    """Return the share of a processor that a page takes after `script`, a second after it."""
    session = browser.new_browser_cdp_session()
    tab = browser.new_page(viewport={"width": 1366, "height": 768})
    tab.goto(file.as_uri())
    until(tab, "!!window.workbench?.ready")
    tab.evaluate(script, given)
    tab.wait_for_timeout(1000)
    used, began = rendering(session), time.monotonic()
    tab.wait_for_timeout(seconds * 1000)
    used, passed = rendering(session) - used, time.monotonic() - began
    tab.close()
    return used / passed


def measured(seconds: float) -> Iterator[tuple[str, float]]:
    """Yield what was done and its share."""
    with tempfile.TemporaryDirectory() as folder, launched() as browser:
        file = Path(folder) / "page.html"
        file.write_text(workbench.page(), encoding="utf-8")
        for label, (script, given) in CASES.items():
            yield label, share(browser, file, script, given, seconds)


@click.command()
@click.option("--seconds", type=click.FloatRange(min=1), default=20, show_default=True, help="Of each.")
def main(seconds: float) -> None:
    """Measure each case and show the shares."""
    table = Table(title=f"share of a processor, Chromium's renderer, {seconds:g} s")
    table.add_column("page")
    table.add_column("share", justify="right")
    for label, part in measured(seconds):
        table.add_row(label, f"{part:.1%}")
    Console(width=None if sys.stdout.isatty() else 120).print(table)


if __name__ == "__main__":
    main()
