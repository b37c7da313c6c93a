"""What the workbench has at hand: bundled tapes, a program, the BIN loader, parts, exercises, an afternoon.

shelf ──► tapes, a program, the BIN loader                 ┐
Afternoon ──► what was measured, and the thesis's figures  ├──► one record, ready for JSON
parts, exercises                                           ┘

The page does the afternoon itself. What it cannot is in the record: the walls, which nc measures with numpy.
"""

from html import escape
from typing import Any

import pal
from nc.curves import Curve
from nc.talyrond import talyrond
from nc.talysurf import talysurf
from pdp8 import shelf
from pdp8.lessons import form, student
from pdp8.lessons.course import COURSE
from pdp8.replay import Afternoon, replay
from pdp8.replay.figures import COLUMNS, compare
from pdp8.web import parts
from programs.parts import PARTS
from tapes import rim

_OPENS_WITH = "hello.pal"
_USUAL = "circle"
_POINTS = 360
"""Of the nominal curve."""


def record(afternoon: Afternoon | None = None) -> dict[str, Any]:
    """Return it with `afternoon`, or the usual one; tapes as text, a character a frame."""
    tapes = {name: shelf.read_bundled(name) for name in shelf.bundled() if not name.endswith(".for")}
    done = afternoon or replay(_USUAL)
    tapes[f"{done.part}.asc"] = done.tapes[f"{done.part}.asc"]
    loader = pal.assemble(shelf.read_bundled("bin.pal"))
    return {
        "tapes": {name: frames.decode("latin-1") for name, frames in tapes.items()},
        "loader": rim.encode(loader.words).decode("latin-1"),
        "source": shelf.read_bundled(_OPENS_WITH).decode("ascii"),
        "cutter": PARTS[done.part].cutter * 1000,
        "view": "",
        "door": "afternoon" if afternoon else "",
        "afternoon": _afternoon(done),
        "parts": parts.declared(),
        "exercises": _exercises(),
    }


def _exercises() -> dict[str, Any]:
    """Return the bundled exercises in the order of a class, each with its level."""
    return {
        name: {"level": level, **student.whole(form.read(name))}
        for level, names in COURSE.items()
        for name in names.split()
    }


def _afternoon(done: Afternoon) -> dict[str, Any]:
    """Return what the page cannot compute: the last act, the instrument's graph, the curve that was meant."""
    last, inspection = done.acts[-1], done.inspection
    found: dict[str, Any] = {
        "part": done.part,
        "found": [last.name, last.say, last.outcome],
        "figures": _table(done),
        "graph": "",
        "band": None,
    }
    if inspection is not None:
        curve = inspection.curve
        found["graph"] = (talyrond if curve.closed else talysurf)(inspection)
        tolerance = PARTS[done.part].tolerance * 1000
        sides = {"inner": -tolerance, "nominal": 0, "outer": tolerance}
        found["band"] = {name: _limit(curve, off) for name, off in sides.items()}
    return found


def _limit(curve: Curve, off: float) -> list[list[float]]:
    """Return the curve, or a limit of its band, as points, the first one again where it is closed."""
    points: list[list[float]] = curve.limit(curve.stations(_POINTS), off).round(1).tolist()
    return points + points[:1] * curve.closed


def _table(done: Afternoon) -> str:
    """Return the thesis's figures beside those of an afternoon, as the rows of a table in HTML."""
    head = "".join(f'<th scope="col">{escape(column)}</th>' for column in COLUMNS)
    rows = ""
    for figure, *said in compare(done):
        cells = "".join(f"<td>{escape(each)}</td>" for each in said)
        rows += f'<tr><th scope="row">{escape(figure)}</th>{cells}</tr>'
    return f"<thead><tr>{head}</tr></thead><tbody>{rows}</tbody>"
