"""Whether the workbench leaks: the circle is translated again and again at full speed, for some seconds.

Before and after, garbage collected, the heap of JavaScript and the nodes of the page are counted.

    python -m tests.pdp8.web.leak [SECONDS]         600 if nothing is said; exit status 1 if it leaks
"""

import sys
import tempfile
import time
from pathlib import Path
from typing import TYPE_CHECKING

from pdp8.web.workbench import page
from tests.pdp8.web.browsing import launched, visit

if TYPE_CHECKING:
    from playwright.sync_api import CDPSession, Page

WARM_UP = 60.0
"""Seconds: what is compiled, cached and kept for steps back is there by then."""
HEAP, NODES = 4e6, 50
"""By how much bytes and nodes may differ: garbage that is not yet collected, code that is compiled later."""

_AGAIN = """() => {
  if (!workbench.machine._out_of_tape() && workbench.machine.processor.run) return false;
  workbench.parts.name = "circle.asc";
  workbench.parts.translate();
  return true;
}"""


def translate(tab: "Page", seconds: float) -> int:
    """Translate the circle until the time is over; return how often."""
    end = time.monotonic() + seconds
    times = 0
    while time.monotonic() < end:
        times += tab.evaluate(_AGAIN)
        tab.wait_for_timeout(100)
    return times


def count(session: "CDPSession") -> tuple[int, int]:
    """Collect garbage; return the bytes of the heap and the nodes of the document."""
    session.send("HeapProfiler.collectGarbage")
    metrics = {each["name"]: each["value"] for each in session.send("Performance.getMetrics")["metrics"]}
    return int(metrics["JSHeapUsedSize"]), int(metrics["Nodes"])


def main(seconds: float) -> int:
    """Measure, say what was found, and return the exit status."""
    with tempfile.TemporaryDirectory() as folder, launched() as browser:
        file = Path(folder) / "page.html"
        file.write_text(page(), encoding="utf-8")
        with visit(browser, file.as_uri()) as tab:
            tab.locator("#speed").select_option(label="as fast as it goes")
            session = tab.context.new_cdp_session(tab)
            session.send("Performance.enable")
            translate(tab, WARM_UP)
            heap, nodes = count(session)
            times = translate(tab, seconds)
            heap_then, nodes_then = count(session)
    print(f"the circle translated {times} times in {seconds:g} s at full speed")
    print(f"heap   {heap / 1e6:8.2f} MB  ->  {heap_then / 1e6:8.2f} MB")
    print(f"nodes  {nodes:8}     ->  {nodes_then:8}")
    return int(heap_then - heap > HEAP or nodes_then - nodes > NODES)


if __name__ == "__main__":
    sys.exit(main(float(sys.argv[1]) if len(sys.argv) > 1 else 600.0))
