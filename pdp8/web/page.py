"""The afternoon as one page: a self-contained HTML file in which every instant can be looked at.

    Afternoon ──► record (JSON: tapes, actions, blocks)  ┐
    our Python, afternoon.mjs ... page.mjs             ├──► page.html with everything inside
    page.css                                           ┘

The page is no film. Its record holds what was done and what was punched; our own
PDP-8/L, translated to JavaScript, makes every instant again, from the actions.
"""

from collections.abc import Iterator
from itertools import accumulate, pairwise
from typing import Any

import pal
from nc.curves import Curve
from nc.path import MoveKind as Move
from nc.talyrond import talyrond
from nc.talysurf import talysurf
from pdp8.computer.hardware.signals import TICKS_PER_SECOND
from pdp8.replay.afternoon import Afternoon
from pdp8.replay.day import OPENS, Act, Kind
from pdp8.replay.figures import COLUMNS, compare
from pdp8.web import bundle
from programs.parts import PARTS
from tapes.hydrapoint import FIELDS

_CODES = {"asc": "ascii", "eia": "eia", "bin": "bin", "rim": "rim"}
_CUTTING = (Move.MILL, Move.FEED_IN, Move.FEED_OUT)
_CURVE_POINTS = 1440


def page(afternoon: Afternoon) -> str:
    """Return the whole page."""
    return bundle.page("An afternoon in 1971", "page.html", ("page.css",), "page", record(afternoon))


def record(afternoon: Afternoon) -> dict[str, Any]:
    """Return what the page needs to make every instant again, ready for JSON."""
    return {
        "title": afternoon.part,
        "subject": f"{afternoon.part.capitalize()}: a part program of M. S. Wong's thesis, McMaster "
        "University, from its punched tape through a PDP-8/L to the Hydra-Point",
        "about": _ABOUT,
        "opens": OPENS,
        "acts": [_act(act) for act in afternoon.acts],
        "actions": [_without_none(action._asdict()) for action in afternoon.actions],
        "tapes": {_key(name): _tape(name, frames) for name, frames in afternoon.tapes.items()},
        "sheets": _sheets(afternoon),
        "mill": _mill(afternoon),
        "figures": {"columns": COLUMNS, "rows": compare(afternoon)},
    }


def _without_none(fields: dict[str, Any]) -> dict[str, Any]:
    kept = {name: value for name, value in fields.items() if value is not None}
    if isinstance(kept.get("value"), str):
        kept["value"] = _key(kept["value"])
    return kept


def _key(name: str) -> str:
    """Return what the page calls a tape: the part's two by their codes, the loaders' by name."""
    return {"asc": "ascii", "eia": "eia"}.get(name.rpartition(".")[2], name)


def _tape(name: str, frames: bytes) -> dict[str, str]:
    code = _CODES[name.rpartition(".")[2]]
    return {"label": name, "code": code, "frames": frames.decode("latin-1")}


_SHEETS = {Kind.TERMINAL: "page", Kind.INSPECT: "graph"}


def _act(act: Act) -> dict[str, Any]:
    sheet = act.program or _SHEETS.get(act.kind, "blocks")
    return {
        "kind": act.kind,
        "name": act.name,
        "say": act.say,
        "from": act.starts,
        "to": act.ends,
        "sheet": sheet,
    }


_TITLES = {
    "rim.pal": "The RIM loader, rim.pal",
    "bin.pal": "The BIN loader, bin.pal",
    "eia.pal": "Appendix B: eia.pal",
}


def _sheets(afternoon: Afternoon) -> dict[str, Any]:
    sheets: dict[str, Any] = {
        "page": {
            "title": "The terminal's page",
            "kind": "page",
            "lines": [[None, None, line] for line in afternoon.text.splitlines()],
        },
        "blocks": {
            "title": "The blocks on the EIA tape",
            "kind": "blocks",
            "lines": [[None, None, _block(step.block.digits)] for step in afternoon.path.steps],
        },
    }
    sheets["graph"] = _graph(afternoon) or sheets["blocks"]
    for name, assembly in afternoon.programs.items():
        sheets[name] = {"title": _TITLES[name], "kind": "listing", "lines": list(_listing(assembly))}
    return sheets


def _graph(afternoon: Afternoon) -> dict[str, Any] | None:
    """Return the instrument's graph, if the part could be inspected."""
    inspection = afternoon.inspection
    if inspection is None:
        return None
    instrument = PARTS[afternoon.part].instrument
    draw = talyrond if inspection.curve.closed else talysurf
    title = f"The {instrument}'s graph" if instrument else "The walls, computed"
    return {"title": title, "kind": "picture", "svg": draw(inspection)}


def _block(digits: str) -> str:
    cuts = list(accumulate(FIELDS.values(), initial=0))
    return " ".join(digits[start:end] for start, end in pairwise(cuts))


def _listing(assembly: pal.Assembly) -> Iterator[list[Any]]:
    """Yield [address, word, source line, mark] of pass 3's lines, up to the symbol table."""
    for line in assembly.lines:
        text = line.source.expandtabs(8)
        yield [line.address, line.word, text, _mark(text)]


def _mark(text: str) -> str:
    """Return the class of a line whose source is restored, by the comment that says so."""
    return "source restored" if text.partition("/")[2][:2].rstrip() == "R" else "source"


def _mill(afternoon: Afternoon) -> dict[str, Any]:
    """Return the blocks and the knots of the path, [tick, x, y, whether it cut on the way], Z left out."""
    path = afternoon.path
    now = float(afternoon.mill_starts)
    start = path.moves[0].start if path.moves else None
    knots: list[list[Any]] = [[round(now), start.x if start else 0, start.y if start else 0, False]]
    blocks = []
    reading = round(path.read_seconds * TICKS_PER_SECOND)
    for step in path.steps:
        blocks.append({"at": round(now), "reading": reading})
        now += reading + step.tool_changed * path.tool_change_seconds * TICKS_PER_SECOND
        if step.moves:
            knots.append([round(now), step.moves[0].start.x, step.moves[0].start.y, False])
        for move in step.moves:
            now += move.seconds * TICKS_PER_SECOND
            knots.append([round(now), move.end.x, move.end.y, move.kind in _CUTTING])
    curve = afternoon.inspection.curve if afternoon.inspection else None
    made = PARTS[afternoon.part]
    return {
        "blocks": blocks,
        "path": knots,
        "diameter": made.cutter * 1000,
        "band": _band(curve, made.tolerance * 1000),
    }


def _band(curve: Curve | None, tolerance: float) -> dict[str, Any] | None:
    """Return the nominal curve and the two limits of its band, as closed or open outlines."""
    if curve is None:
        return None
    stations = curve.stations(_CURVE_POINTS)
    outlines = {}
    for name, offset in (("inner", -tolerance), ("nominal", 0), ("outer", tolerance)):
        points = curve.limit(stations, offset).round(1).tolist()
        outlines[name] = [*points, points[0]] if curve.closed else points
    return outlines


_ABOUT = (
    "Every instant is computed, not filmed: the page holds a small PDP-8/L that starts with an empty core "
    "and does again what the operator did. Lamps, registers and tapes are those of that instant, to the "
    "memory cycle of 1.6 µs.",
    "The times of the terminal, the Teletype, the processor and the Hydra-Point are the machines' own. The "
    "minutes for walking, mounting, setting switches and measuring are not in the thesis; they are ours.",
    "Beside a tape: ␣ space, ↵ carriage return or end of block, ↓ line feed, × rubout. In the listing of "
    "Appendix B a line in italics stood on the lost page and is restored from the pattern of its neighbours; "
    "a comment /R, /D or /W says what the scan shows of a line.",
)
