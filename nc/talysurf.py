"""The Talysurf's trace: the error of each wall along a stretch of it, laid out straight.

    outer wall  ──╲╱──╲╱──   magnified more across the wall than along it, as on the instrument's paper
    inner wall  ──╲╱──╲╱──

Source: thesis, Chapter 8, Figures 8.4 and 8.5: .01 in a division along the surface; in mm it is .2.
"""

from math import ceil, floor

import numpy as np

from nc.curves import Floats
from nc.drawing import FAINT, GRID, INK, Sheet, polyline, round_step, signed
from nc.inspection import Inspection, runs
from nc.talyrond import COLOURS
from nc.unit import INCH, Unit
from tapes.errors import WorkError

_LEFT, _WIDTH, _HEIGHT = 80.0, 660.0, 200.0
DIVISION = 10.0
"""Small divisions from one light line to the next, along the surface."""


def talysurf(
    inspection: Inspection,
    stretch: tuple[float, float] | None = None,
    background: float = 0,
    unit: Unit = INCH,
) -> str:
    """Return the traces of both walls as SVG text over a stretch, from and to in thousandths along the curve.

    A closed curve is measured counterclockwise from its +X apex. The default stretch is the quarter about
    the +Y apex of a closed curve, and the whole of any other. `background` is a roughness that the cut does
    not explain, in thousandths: a shaded band about the trace. Raises WorkError if the stretch has no wall,
    or goes beyond the curve by more than a division.
    """
    small = unit.division
    along = inspection.walls.stations.along / small
    first, last = (len(along) // 8, 3 * len(along) // 8) if inspection.curve.closed else (0, -1)
    start, end = (stretch[0] / small, stretch[1] / small) if stretch else (along[first], along[last])
    chosen = np.flatnonzero((along >= start) & (along <= end))
    if len(chosen) < 2 or start < -DIVISION or end > along[-1] + DIVISION:
        raise WorkError(
            f"stretch from {unit.said(start * small)} to {unit.said(end * small)}: the curve runs from 0 to "
            f"{unit.said(along[-1] * small)} {unit.name}"
        )
    sheet = Sheet(_LEFT + _WIDTH + 30, 2 * (_HEIGHT + 60) + 100, "Talysurf")
    sheet.text(_LEFT, 26, f"Talysurf: {inspection.curve.said(unit)}", font_size=15)
    walls = {wall: error[chosen] / small for wall, error in inspection.walls.by_name.items()}
    if np.isnan([*walls.values()]).all():
        raise WorkError("the cutter did not reach this stretch of the curve: there is no wall")
    for row, (wall, seen) in enumerate(walls.items()):
        top = 80 + row * (_HEIGHT + 60)
        if np.isnan(seen).all():
            sheet.text(_LEFT, top - 10, f"no {wall} wall", fill=COLOURS[wall])
            continue
        rough = f"{unit.error(float(np.nanmax(seen) - np.nanmin(seen)) * small)} {unit.name}"
        sheet.text(_LEFT, top - 10, f"{wall} wall, trough to peak {rough}", fill=COLOURS[wall])
        _trace(sheet, top, along[chosen], seen, COLOURS[wall], background / small, unit)
    every = _between(_WIDTH / (along[chosen[-1]] - along[chosen[0]])) * unit.small
    lines = f"a line every {f'{every:.2f}'.lstrip('0')}", f"a line every {unit.named_division}"
    name = "inches" if unit is INCH else unit.name
    said = f"{name} along the curve, {lines[0]}; upward is outward, in {name}, {lines[1]}"
    if background:
        said += f"; shaded, {unit.error(background)} not of the steps"
    sheet.text(_LEFT + _WIDTH / 2, 2 * (_HEIGHT + 60) + 80, said, text_anchor="middle")
    return sheet.svg()


def _numbered(across: float) -> float:
    """Return the distance of a scale's numbered lines, in small divisions, each `across` pixels wide."""
    return round_step(max(DIVISION, 48 / across))


def _between(across: float) -> float:
    """Return the spacing of a scale's lines, in small divisions."""
    return DIVISION if DIVISION * across >= 4 else _numbered(across)


def _trace(
    sheet: Sheet,
    top: float,
    along: Floats,
    deviation: Floats,
    colour: str,
    background: float,
    unit: Unit,
) -> None:
    margin = 0.5 + background / 2
    low, high = floor(float(np.nanmin(deviation)) - margin), ceil(float(np.nanmax(deviation)) + margin)
    start, length = float(along[0]), float(along[-1] - along[0])
    up, across = _HEIGHT / (high - low), _WIDTH / length
    bottom, right = top + _HEIGHT, _LEFT + _WIDTH
    labels = max(1, ceil(14 / up))
    for line in range(low, high + 1):
        y = bottom - (line - low) * up
        sheet.draw("line", x1=_LEFT, y1=y, x2=right, y2=y, stroke=FAINT if line == 0 else GRID)
        if line % labels == 0:
            sheet.text(_LEFT - 8, y + 4, signed(line, unit), text_anchor="end")
    if _between(across) == DIVISION:
        for count in range(ceil(start / DIVISION), floor((start + length) / DIVISION) + 1):
            x = _LEFT + (count * DIVISION - start) * across
            sheet.draw("line", x1=x, y1=top, x2=x, y2=bottom, stroke=GRID, stroke_width=0.6)
    step = _numbered(across)
    for count in range(ceil(start / step), floor((start + length) / step) + 1):
        x = _LEFT + (count * step - start) * across
        sheet.draw("line", x1=x, y1=top, x2=x, y2=bottom, stroke=GRID)
        sheet.text(x, bottom + 16, f"{count * step * unit.small:.2f}", text_anchor="middle")
    sheet.draw("rect", x=_LEFT, y=top, width=_WIDTH, height=_HEIGHT, fill="none", stroke=INK)
    paper = np.column_stack([_LEFT + (along - start) * across, bottom - (deviation - low) * up])
    for run in runs(deviation, closed=False):
        places = paper[run]
        if background:
            half = np.array([0, background / 2 * up])
            band = [*(places - half).tolist(), *(places + half)[::-1].tolist()]
            sheet.draw("path", d=polyline(band) + "Z", fill=colour, fill_opacity=0.15)
        data = polyline(places.tolist())
        sheet.draw("path", d=data, fill="none", stroke=colour, stroke_width=1.2)
