"""The one page: the whole machine live, every bundled tape at hand, and the afternoon that plays on it.

shelf ──► record (JSON: tapes, a program, the BIN loader)  ┐
Afternoon ──► what was measured, and the thesis's figures  │
our Python, bench/ workbench.mjs                           ├──► one HTML file with everything inside
base.css workbench.css bench/desk.css                      ┘

The page does the afternoon itself. What it cannot is bundled: the walls, which nc measures with numpy.
"""

from typing import Any

import pal
from nc.talyrond import talyrond
from nc.talysurf import talysurf
from pdp8.lessons import form, student
from pdp8.replay import Afternoon, replay
from pdp8.replay.figures import COLUMNS, compare
from pdp8.web import bundle, parts
from programs.parts import PARTS
from tapes import rim, shelf

_STYLES = ("workbench.css", "bench/desk.css")
_OPENS_WITH = "hello.pal"
_USUAL = "circle"
_POINTS = 720
"""Of the nominal curve."""


def page(view: tuple[str, bytes] | None = None, afternoon: Afternoon | None = None) -> str:
    """Return the whole page; with `view`, the name and frames of an EIA tape, opened at the Hydra-Point; with
    an `afternoon`, opened at that.
    """
    return bundle.page("PDP-8/L workbench", "bench.html", _STYLES, "workbench", record(view, afternoon))


def record(view: tuple[str, bytes] | None = None, afternoon: Afternoon | None = None) -> dict[str, Any]:
    """Return what the page has at hand, ready for JSON; tapes as text, a character a frame."""
    tapes = {name: shelf.read_bundled(name) for name in shelf.bundled() if not name.endswith(".for")}
    done = afternoon or replay(_USUAL)
    tapes[f"{done.part}.asc"] = done.tapes[f"{done.part}.asc"]
    if view is not None:
        tapes |= {view[0]: view[1]}
    loader = pal.assemble(shelf.read_bundled("bin.pal"))
    return {
        "tapes": {name: frames.decode("latin-1") for name, frames in tapes.items()},
        "loader": rim.encode(loader.words).decode("latin-1"),
        "source": shelf.read_bundled(_OPENS_WITH).decode("ascii"),
        "cutter": PARTS[done.part].cutter * 1000,
        "view": view[0] if view else "",
        "door": "afternoon" if afternoon else "",
        "afternoon": _afternoon(done),
        "parts": parts.declared(),
        "exercises": {name: student.whole(form.read(name)) for name in form.bundled()},
    }


def _afternoon(done: Afternoon) -> dict[str, Any]:
    """Return what the page cannot compute: the last act, the instrument's graph, the curve that was meant."""
    last, inspection = done.acts[-1], done.inspection
    found: dict[str, Any] = {
        "part": done.part,
        "found": [last.name, last.say, last.outcome],
        "figures": {"columns": COLUMNS, "rows": compare(done)},
        "graph": "",
        "nominal": None,
    }
    if inspection is not None:
        curve = inspection.curve
        found["graph"] = (talyrond if curve.closed else talysurf)(inspection)
        points = curve.limit(curve.stations(_POINTS), 0).round(1).tolist()
        nominal = {"points": [*points, points[0]] if curve.closed else points}
        found["nominal"] = nominal | {"tolerance": PARTS[done.part].tolerance * 1000}
    return found
