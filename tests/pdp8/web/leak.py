"""Whether the workbench leaks: the circle is translated again and again at full speed, for some seconds.

Before and after, garbage collected, the heap of JavaScript and the nodes of the page are counted.

    python -m tests.pdp8.web.leak [SECONDS]         600 if nothing is said; exit status 1 if it leaks
"""

import sys
import tempfile
import time
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

from pdp8.web.workbench import page
from tests.pdp8.web.chromium import opened

if TYPE_CHECKING:
    from playwright.sync_api import CDPSession, Page

WARM_UP = 60.0
"""Seconds: what is compiled, cached and kept for steps back is there by then."""
HEAP = 4e6
"""Bytes by which the heap may differ: garbage that is not yet collected, code that is compiled later."""
NODES = 50

_AGAIN = """() => {
  if (!workbench.machine._out_of_tape() && workbench.machine.processor.run) return false;
  workbench.parts.name = "circle.asc";
  workbench.parts.translate();
  return true;
}"""


class Count(NamedTuple):
    """Bytes of the heap and nodes of the document, garbage collected."""

    heap: int
    nodes: int


def translate(tab: "Page", seconds: float) -> int:
    """Translate the circle until the time is over; return how often."""
    end = time.monotonic() + seconds
    times = 0
    while time.monotonic() < end:
        times += tab.evaluate(_AGAIN)
        tab.wait_for_timeout(100)
    return times


def count(session: "CDPSession") -> Count:
    """Collect garbage, and count."""
    session.send("HeapProfiler.collectGarbage")
    metrics = {each["name"]: each["value"] for each in session.send("Performance.getMetrics")["metrics"]}
    return Count(int(metrics["JSHeapUsedSize"]), int(metrics["Nodes"]))


def measure(seconds: float) -> tuple[Count, Count, int]:
    """Return the counts before and after, and how often the circle was translated."""
    with tempfile.TemporaryDirectory() as folder, opened(Path(folder), page()) as tab:
        tab.locator("#speed").select_option(label="as fast as it goes")
        session = tab.context.new_cdp_session(tab)
        session.send("Performance.enable")
        translate(tab, WARM_UP)
        before = count(session)
        times = translate(tab, seconds)
        return before, count(session), times


def main(seconds: float) -> int:
    """Measure, say what was found, and return the exit status."""
    before, after, times = measure(seconds)
    print(f"the circle translated {times} times in {seconds:g} s at full speed")
    print(f"heap   {before.heap / 1e6:8.2f} MB  ->  {after.heap / 1e6:8.2f} MB")
    print(f"nodes  {before.nodes:8}     ->  {after.nodes:8}")
    return int(after.heap - before.heap > HEAP or after.nodes - before.nodes > NODES)


if __name__ == "__main__":
    sys.exit(main(float(sys.argv[1]) if len(sys.argv) > 1 else 600.0))
