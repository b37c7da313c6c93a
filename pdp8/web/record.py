"""What the workbench has at hand: bundled tapes, a program, the BIN loader, parts, exercises, an afternoon.

shelf ──► tapes, a program, the BIN loader                 ┐
Afternoon ──► what was measured, and the thesis's figures  ├──► one record, ready for JSON
parts, exercises                                           ┘

The page has any instant of the afternoon again (replay/script.py). In the record is what it needs for that:
what the operator did, and the machine in the midst and at the end of the translation, so that nothing has to
be done before the first picture; and what only Python can measure, with numpy: the walls.
"""

import re
from collections.abc import Mapping
from html import escape
from typing import Any

import numpy as np

from nc.curves import Curve
from nc.inspection import Inspection
from nc.talyrond import talyrond
from nc.talysurf import talysurf
from pdp8 import shelf
from pdp8.lessons import form, student
from pdp8.lessons.course import COURSE
from pdp8.replay import Afternoon, replay
from pdp8.replay.day import Kind
from pdp8.replay.figures import COLUMNS, compare
from pdp8.replay.script import Script
from pdp8.replay.story import story
from pdp8.web import parts
from pdp8.web.translation import translation
from programs.parts import PARTS
from tapes.quantities import inches

_USUAL = "circle"
_READ = ("bin.rim", "eia.bin")
"""The tapes of the afternoon's programs."""
_POINTS = 360
"""Points of the nominal curve."""
_CLOSE = 250.0
"""Thousandths along the curve that are looked at to either side of its worst place."""


def record(afternoon: Afternoon | None = None) -> dict[str, Any]:
    """Return the record with `afternoon` or the usual one; tapes are texts, a character a frame, or None:
    the translation of the ASCII tape of that name.
    """
    tapes = {name: shelf.read_bundled(name) for name in shelf.bundled() if not name.endswith(".for")}
    done = afternoon or replay(_USUAL)
    tapes |= {f"{done.part}.{code}": done.tapes[f"{done.part}.{code}"] for code in ("asc", "eia")}
    return {
        "tapes": {name: _at_hand(name, tapes) for name in tapes},
        "cutter": PARTS[done.part].cutter * 1000,
        "view": "",
        "opens": 1 if afternoon else 0,
        "afternoon": _afternoon(done, tapes),
        "figures": _table(done),
        "graph": _graph(done.inspection),
        "parts": parts.declared(),
        "exercises": _exercises(),
    }


def _at_hand(name: str, tapes: Mapping[str, bytes]) -> str | None:
    typed = tapes.get(name.replace(".eia", ".asc"))
    made = name.endswith(".eia") and typed and tapes[name] == translation(typed)
    return None if made else tapes[name].decode("latin-1")


def _exercises() -> dict[str, Any]:
    """Return the bundled exercises in the order of a class, each with its level."""
    return {
        name: {"level": level, **student.whole(form.read(name))}
        for level, names in COURSE.items()
        for name in names.split()
    }


def _afternoon(done: Afternoon, tapes: Mapping[str, bytes]) -> dict[str, Any]:
    """Return what the page needs to restore any instant and cannot compute itself."""
    inspection = done.inspection
    found: dict[str, Any] = {
        "part": done.part,
        "story": story(done),
        "acts": [act._replace(real=0.0) for act in done.acts],
        "actions": done.actions,
        "millStarts": done.mill_starts,
        "machines": _machines(done, tapes),
        "read": {name: done.tapes[name].decode("latin-1") for name in _READ},
        "band": None,
        "wall": None,
    }
    if inspection is not None:
        curve = inspection.curve
        tolerance = inspection.tolerance
        sides = {"inner": -tolerance, "nominal": 0, "outer": tolerance}
        found["band"] = {name: _limit(curve, off) for name, off in sides.items()}
        found["wall"] = _wall(inspection)
    return found


def _graph(inspection: Inspection | None) -> str:
    """Return the graph of the walls, in SVG, to a tenth of a pixel."""
    graph = (talyrond if inspection.curve.closed else talysurf)(inspection) if inspection else ""
    return re.sub(' d="(M[^"A-KN-Y]*)"', lambda path: f' d="{_steps(path[1])}"', graph)


def _steps(path: str) -> str:
    """Return an SVG path of M, L and Z with relative steps, which compress to half."""
    found, x, y, last = "", 0, 0, ""
    for command, *place in re.findall(r"([ML])(-?[\d.]+) (-?[\d.]+)|(Z)", path):
        if command:
            right, down = (round(float(each) * 10) for each in place[:2])
            step = (right, down) if command == "M" else (right - x, down - y)
            found += (" " if command == last == "L" else command.replace("L", "l")) + " ".join(
                f"{each / 10:g}" for each in step
            )
            x, y = right, down
        else:
            found += "Z"
        last = command
    return re.sub(r"(?<!\d)0\.", ".", found).replace(" -", "-")


def _machines(done: Afternoon, tapes: Mapping[str, bytes]) -> list[tuple[int, dict[str, Any]]]:
    """Return the machine's values amid and after the translation, each with its tick; a piece of a tape
    is written as the tape's name, the first frame and the end.
    """
    act = next(act for act in done.acts if act.kind == Kind.TRANSLATE)
    script = Script(done.course)
    found = []
    for tick in ((act.starts + act.ends) // 2, act.ends):
        script.to(tick)
        values = script.machine.values().items()
        found.append((tick, {name: _written(value, tapes) for name, value in values}))
    return found


def _written(value: Any, tapes: Mapping[str, bytes]) -> Any:
    if not isinstance(value, bytes):
        return value
    called = next((called for called, tape in tapes.items() if value and value in tape), None)
    at = tapes[called].index(value) if called else 0
    return [called, at, at + len(value)] if called else value.decode("latin-1")


def _wall(inspection: Inspection) -> dict[str, Any]:
    """Where a wall goes furthest from trough to peak: the place, outward, and the two lines around it."""
    worst, walls = inspection.worst, inspection.walls
    stations, error = walls.stations, walls.by_name[worst.wall]
    low, high = (int(np.nanargmin(abs(error - level))) for level in (worst.lowest, worst.highest))
    apart = abs(stations.along[high] - stations.along[low])
    middle = (low + high) // 2 if apart < _CLOSE else high
    near = abs(stations.along - stations.along[middle]) <= _CLOSE
    off = inspection.cutter / 2 * (1 if worst.wall == "outer" else -1)
    place, normal = stations.points[middle], stations.normals[middle]
    points, normals = stations.points[near], stations.normals[near]
    some = slice(None, None, max(1, len(points) // 60))
    return {
        "place": (place + off * normal).round(1).tolist(),
        "normal": normal.round(4).tolist(),
        "off": inches(worst.trough_to_peak),
        "lines": [
            (points + (off + level) * normals)[some].round(2).tolist()
            for level in (worst.lowest, worst.highest)
        ],
    }


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
