"""The path and the cut surface on a sheet of paper: the part to scale, and a close view of the staircase.

    ┌───────────────┐   what the cutter removed, the path of its centre up to the current block, the cutter:
    │  part, 1:1    │   milled grey, path blue, later blocks pale, positioning dashed
    └───────────────┘
    ┌───────────────┐
    │  close, 10:1  │   about the current block: the nominal curve, its band, the steps with their blocks
    └───────────────┘   or an inset, one axis stretched: only the steps in their band

The cut surface is the path drawn with the cutter's width and round ends, as an SVG stroke.
"""

from itertools import groupby
from math import ceil, floor, inf
from textwrap import wrap

from nc.curves import Curve, Graph
from nc.drawing import FAINT, INK, Sheet, View, Window, around
from nc.listing import does, in_force, spaced
from nc.path import Move, MoveKind, Path, Position
from nc.unit import INCH, Unit
from tapes.errors import WorkError
from tapes.hydrapoint import HOLE_MAKING, Preparatory
from tapes.quantities import counted

_LEFT, _WIDTH, _TALLEST = 60.0, 720.0, 620.0
_SCALES = (4.0, 2.0, 1.0, 0.5, 0.25, 0.2)
_CLOSE_LOWEST, _CLOSE_HIGHEST, _BELOW = 150.0, 430.0, 90.0
_LINE, _LETTERS = 16.0, 130
_LEGEND = (
    "grey: removed · blue: path of the cutter's centre; pale: later blocks; dashed: positioning",
    "red: the cutter · green: the nominal curve, its band, and dotted its walls",
)
_PATH, _TO_COME, _METAL, _BAND, _NOW = "#0b4f9e", "#9db7d4", "#dfe3e8", "#2e7d32", "#c62828"


def plot(
    path: Path,
    curve: Curve | None = None,
    *,
    block: int | None = None,
    cutter: float = 500,
    tolerance: float = 5,
    zoom: tuple[float, float] = (10, 10),
    close_at: tuple[float, float] | None = None,
    unit: Unit = INCH,
    high: float = inf,
) -> str:
    """Return the drawing as SVG text. `block` is the current one, counted from 1, by default the last.

    `cutter` (diameter), `tolerance` and `close_at`, the centre of the close view if not the current block,
    are thousandths of an inch; `unit` is that of scales and words. `curve`, if given, is drawn with its band.
    `zoom` is the scale of the close view along X and along Y. The close view is made less high for the sheet
    to be at most `high` hundredths of an inch of paper, but not less than 150. Raises WorkError if the tape
    does not have that block, or if the close view is beside the part.
    """
    current = len(path) if block is None else block
    if not 1 <= current <= len(path):
        raise WorkError(f"block {current}: the tape has blocks 1 to {len(path)}")
    heading = _heading(path, curve, current, unit)
    work = [*path.holes, *(place for move in path.cuts for place in (move.start, move.end))]
    window = around(work or [(0, 0), *(step.at for step in path.steps)]).grown(cutter / 2 + 200)
    largest = 10 * min(_WIDTH / window.width, _TALLEST / window.height)
    scale = next((scale for scale in _SCALES if scale <= largest), min(_SCALES))
    top = 66 + _LINE * len(heading)
    close_top = top + window.height * scale / 10 + 90
    close_height = min(max(high - close_top - _BELOW, _CLOSE_LOWEST), _CLOSE_HIGHEST)
    bottom = close_top + close_height
    sheet = Sheet(_LEFT + _WIDTH + 20, bottom + _BELOW, f"Hydra-Point, block {current}")
    cut = f"{counted(len(path), 'blocks')} · {path.times.total / 60:.1f} min"
    title = f"Moog Hydra-Point 83-1000 MC · {cut} · cutter {unit.size(cutter)} {unit.name}"
    sheet.text(_LEFT, 26, title, font_size=15)
    for row, (line, colour) in enumerate(heading):
        sheet.text(_LEFT, 46 + _LINE * row, line, fill=colour)
    sheet.text(_LEFT, top - 8, f"part, scale {_ratio(scale)}", fill=FAINT)
    part = View(sheet, _LEFT, top, window, (scale, scale), unit)
    _draw_part(part, path, current, cutter)
    if isinstance(curve, Graph):
        _draw_axes(part, curve)
    sheet.text(_LEFT, close_top - 8, _close_title(curve, tolerance, zoom, unit), fill=FAINT)
    x, y = close_at or path.steps[current - 1].at[:2]
    seen = Window(x, y, x, y).grown(_WIDTH / zoom[0] * 5, close_height / zoom[1] * 5)
    if close_at and not seen.meets(window):
        ends = (unit.place(window.left, window.bottom), unit.place(window.right, window.top))
        raise WorkError(
            f"the close view at {unit.place(x, y)} shows nothing: the part is drawn from {' to '.join(ends)}"
        )
    close = View(sheet, _LEFT, close_top, seen, zoom, unit)
    _draw_close(close, path, current, curve, cutter, tolerance)
    for row, line in enumerate(_LEGEND):
        sheet.text(_LEFT, bottom + 60 + _LINE * row, line, fill=FAINT)
    return sheet.svg()


def _heading(path: Path, curve: Curve | None, current: int, unit: Unit) -> list[tuple[str, str]]:
    """Return the description of the current block, in lines that fit the sheet, each with its colour."""
    step = path.steps[current - 1]
    inches = ", in inches" * (unit is not INCH)
    said = [(f"block {current}{inches}: {spaced(step.block)} — {does(step)}", _NOW), (in_force(step), INK)]
    if curve is not None and curve.closed and path.gap:
        said.append((f"the contour ends {unit.said(path.gap)} {unit.name} from its start", FAINT))
    return [(line, colour) for words, colour in said for line in wrap(words, _LETTERS)]


def _ratio(scale: float) -> str:
    return f"{scale:g}:1" if scale >= 1 else f"1:{1 / scale:g}"


def _close_title(curve: Curve | None, tolerance: float, zoom: tuple[float, float], unit: Unit) -> str:
    band = f"; band ±{unit.size(tolerance)} {unit.name} about the {curve.said(unit)}" if curve else ""
    along, up = map(_ratio, zoom)
    return f"close, scale {along}{band}" if along == up else f"stretched, X {along}, Y {up}{band}"


def _halves(path: Path, current: int) -> list[list[Move]]:
    """Return the moves up to the current block, and the later ones."""
    halves = path.steps[:current], path.steps[current:]
    return [[move for step in steps for move in step.moves] for steps in halves]


def _draw_part(view: View, path: Path, current: int, cutter: float) -> None:
    done, to_come = _halves(path, current)
    _draw_metal(view, done, cutter)
    _draw_holes(view, path, current, cutter)
    for moves, colour in ((to_come, _TO_COME), (done, _PATH)):
        for run in _runs(moves, milling=False):
            view.line(run, stroke=colour, stroke_dasharray="5 4", stroke_width=0.8)
        for run in _runs(moves, milling=True):
            view.line(run, stroke=colour, stroke_width=1.2)
    _draw_cutter(view, path.steps[current - 1].at, cutter)


def _draw_axes(view: View, curve: Graph) -> None:
    """Draw the axes of a function of x through its origin, a mark each inch along X."""
    window = view.window
    for ends in (
        [(window.left, curve.y), (window.right, curve.y)],
        [(curve.x, window.bottom), (curve.x, window.top)],
    ):
        view.line(ends, stroke=INK, stroke_width=1)
    view.text(window.right, curve.y, "X", dx=-16, dy=-6, font_weight="bold", font_size=13)
    view.text(curve.x, window.top, "Y", dx=7, dy=15, font_weight="bold", font_size=13)
    arm = 4 / view.unit
    for inch in range(ceil((window.left - curve.x) / 1000), floor((window.right - curve.x) / 1000) + 1):
        x = curve.x + 1000 * inch
        view.line([(x, curve.y - arm), (x, curve.y + arm)], stroke=INK)
        view.text(x, curve.y, str(inch), dx=3, dy=13, font_size=10)


def _draw_close(
    view: View, path: Path, current: int, curve: Curve | None, cutter: float, tolerance: float
) -> None:
    reach = view.window.grown(cutter)
    done, to_come = ([move for move in moves if _near(move, reach)] for moves in _halves(path, current))
    stretched = view.unit != view.rise
    if not stretched:
        _draw_metal(view, done, cutter)
        _draw_holes(view, path, current, cutter)
    if curve is not None:
        _draw_band(view, curve, cutter, tolerance)
    for moves, colour in ((to_come, _TO_COME), (done, _PATH)):
        for run in _runs(moves, milling=True):
            view.line(run, stroke=colour, stroke_width=1.8)
    if not stretched:
        _draw_cutter(view, path.steps[current - 1].at, cutter)
    _number_steps(view, path, current)


def _near(move: Move, reach: Window) -> bool:
    return around([move.start, move.end]).meets(reach)


def _draw_metal(view: View, moves: list[Move], cutter: float) -> None:
    wide = {"stroke_width": cutter * view.unit, "stroke_linecap": "round", "stroke_linejoin": "round"}
    for run in _runs(moves, milling=True):
        view.line(run, stroke=_METAL, **wide)


def _draw_holes(view: View, path: Path, current: int, cutter: float) -> None:
    """Draw the holes whose middle is in view: filled up to the current block, pale later ones."""
    for step in path.steps:
        x, y = step.at[:2]
        if step.block.preparatory not in HOLE_MAKING or not view.window.holds(x, y):
            continue
        done = step.number <= current
        view.circle(x, y, cutter / 2, fill=_METAL if done else "none", stroke=FAINT if done else _TO_COME)
        view.line([(x - cutter / 3, y), (x + cutter / 3, y)], stroke=FAINT)
        view.line([(x, y - cutter / 3), (x, y + cutter / 3)], stroke=FAINT)


def _draw_band(view: View, curve: Curve, cutter: float, tolerance: float) -> None:
    """Draw the curve, the band's two limits, and the walls that a cutter exactly on the curve leaves."""
    stations, reach = curve.stations(7_200), view.window.grown(10)
    wall = cutter / 2 * stations.normals
    walls = {"inner": (stations.points - wall, "2 3"), "outer": (stations.points + wall, "2 3")}
    for line, dashes in (
        (curve.limit(stations, -tolerance), "none"),
        (stations.points, "8 4"),
        (curve.limit(stations, tolerance), "none"),
        *([walls[curve.part_wall]] if curve.part_wall else walls.values()),
    ):
        places = line.tolist()
        if curve.closed:
            places.append(places[0])
        for seen, run in groupby(places, key=lambda place: reach.holds(*place)):
            if seen:
                view.line(list(run), stroke=_BAND, stroke_width=0.9, stroke_dasharray=dashes)


def _draw_cutter(view: View, at: Position, cutter: float) -> None:
    arm = 9 / view.unit
    view.circle(at.x, at.y, cutter / 2, stroke=_NOW, stroke_width=1.2)
    view.line([(at.x - arm, at.y), (at.x + arm, at.y)], stroke=_NOW)
    view.line([(at.x, at.y - arm), (at.x, at.y + arm)], stroke=_NOW)


def _number_steps(view: View, path: Path, current: int) -> None:
    """Write block numbers beside the ends of their moves where they do not overlap, the current one first."""
    written: list[tuple[float, float]] = []
    inside = view.window.grown(-30 / view.unit, -30 / view.rise)
    for step in sorted(path.steps, key=lambda step: abs(step.number - current)):
        if step.block.preparatory != Preparatory.MILL or not inside.holds(step.at.x, step.at.y):
            continue
        x, y = view.at(step.at.x, step.at.y)
        if not any(abs(x - other_x) < 34 and abs(y - other_y) < 13 for other_x, other_y in written):
            written.append((x, y))
            colour = _NOW if step.number == current else INK
            view.text(step.at.x, step.at.y, str(step.number), dx=5, dy=-4, fill=colour)


def _runs(moves: list[Move], milling: bool) -> list[list[tuple[float, float]]]:
    """Return the moves joined end to end into lines of (x, y); moves of the quill are left out."""
    runs: list[list[tuple[float, float]]] = []
    end = None
    for move in moves:
        if (move.kind is MoveKind.MILL) != milling or move.start[:2] == move.end[:2]:
            continue
        if move.start != end:
            runs.append([move.start[:2]])
        runs[-1].append(move.end[:2])
        end = move.end
    return runs
