"""The Talyrond's polar graph: the error of each wall round the work, with only the radius magnified.

The stylus turns about the centre of the curve. The graph has the true angles; its radius is magnified and its
centre suppressed, so that a small division is .001 in as in Figure 7.2, or .02 mm, and a step looks like a
spike. For an ellipse the graph shows the distance from the true ellipse, along its normal.

    dotted ring   the nominal wall        outer wall blue, inner wall red, + outward

Source: thesis, Chapter 7: magnification 100, .001 in a small division.
"""

from math import ceil, cos, floor, radians, sin

import numpy as np

from nc.curves import Floats
from nc.drawing import FAINT, GRID, INK, Sheet, polyline, signed
from nc.inspection import Inspection, runs
from nc.unit import INCH, Unit
from tapes.errors import WorkError

_MAGNIFICATIONS = (100, 50, 20, 10, 5, 2, 1)
_ROOM = 260.0
_HUB = 45.0
COLOURS = {"outer": "#0b4f9e", "inner": "#c62828"}


def talyrond(inspection: Inspection, name: str = "Talyrond", unit: Unit = INCH) -> str:
    """The polar graph as SVG, magnified 100 times or as far as fits. Raises WorkError for an open curve."""
    if not inspection.curve.closed:
        raise WorkError(
            f"the Talyrond measures closed curves; this is a {inspection.curve.said(unit)}: use the Talysurf"
        )
    return _Graph(inspection, name, unit).svg()


class _Graph:
    """The graph on its sheet: errors in small divisions, radii in hundredths of an inch of paper."""

    def __init__(self, inspection: Inspection, name: str, unit: Unit) -> None:
        self.inspection, self.name, self.unit = inspection, name, unit
        both = np.concatenate([inspection.walls.outer, inspection.walls.inner]) / unit.division
        self.low, self.high = 5 * floor(float(np.nanmin(both)) / 5), 5 * ceil(float(np.nanmax(both)) / 5)
        divisions = self.high - self.low
        fitting = (times for times in _MAGNIFICATIONS if divisions * unit.division * times / 10 <= _ROOM)
        self.magnification = next(fitting, min(_MAGNIFICATIONS))
        self.division = self.magnification / 10 * unit.division
        self.rim = _HUB + divisions * self.division
        half = max(self.rim + 95, 370.0)
        self.x, self.y = half, self.rim + 175
        self.sheet = Sheet(2 * half, self.y + self.rim + 90, "Talyrond")

    def svg(self) -> str:
        self._title()
        self._rings()
        self._spokes()
        for wall, deviation in self.inspection.walls.by_name.items():
            self._trace(deviation / self.unit.division, COLOURS[wall])
        for division in range(self.low, self.high + 1, 5):
            x, y = self._at(22.5, division)
            self.sheet.label(x, y + 4, signed(division, self.unit), text_anchor="middle")
        self._readings()
        return self.sheet.svg()

    def _title(self) -> None:
        worst, unit = self.inspection.worst, self.unit
        cutter = f"cutter {unit.size(self.inspection.cutter)} {unit.name}"
        small = f"small division {unit.named_division} {unit.name}"
        scale = f"radial magnification {self.magnification}, centre suppressed · {small}"
        peak = f"worst trough to peak {unit.error(worst.trough_to_peak)} {unit.name}"
        rough = f"{peak}: {worst.wall} wall, {worst.place}"
        self.sheet.text(20, 26, f"{self.name}: {self.inspection.curve.said(unit)}", font_size=15)
        self.sheet.text(20, 46, f"{cutter} · {scale} · outward is +")
        for place, wall in enumerate(self.inspection.walls.by_name):
            self.sheet.text(20 + 60 * place, 64, f"{wall} wall", fill=COLOURS[wall])
        self.sheet.text(20, 82, f"{rough}; the figures round the graph are trough to peak")

    def _radius(self, deviation: float) -> float:
        return _HUB + (deviation - self.low) * self.division

    def _rings(self) -> None:
        for deviation in range(self.low, self.high + 1):
            heavy = deviation % 5 == 0
            self.sheet.draw(
                "circle",
                cx=self.x,
                cy=self.y,
                r=self._radius(deviation),
                fill="none",
                stroke=INK if deviation == 0 else FAINT if heavy else GRID,
                stroke_width=0.8 if heavy else 0.6,
                stroke_dasharray="2 3" if deviation == 0 else "none",
            )

    def _spokes(self) -> None:
        for angle in range(0, 360, 15):
            heavy = angle % 90 == 0
            (x1, y1), (x2, y2) = self._at(angle, self.low), self._at(angle, self.high)
            self.sheet.draw("line", x1=x1, y1=y1, x2=x2, y2=y2, stroke=FAINT if heavy else GRID)

    def _at(self, angle: float, deviation: float) -> tuple[float, float]:
        radius = self._radius(deviation)
        return self.x + radius * cos(radians(angle)), self.y - radius * sin(radians(angle))

    def _trace(self, deviation: Floats, colour: str) -> None:
        """Draw a wall, each station at its angle about the centre."""
        stations = self.inspection.walls.stations
        middle = (stations.points.min(axis=0) + stations.points.max(axis=0)) / 2
        x, y = (stations.points - middle).T
        angle = np.arctan2(y, x)
        radius = _HUB + (deviation - self.low) * self.division
        paper = np.column_stack([self.x + radius * np.cos(angle), self.y - radius * np.sin(angle)])
        for run in runs(deviation, closed=True):
            self.sheet.draw(
                "path", d=polyline(paper[run].tolist()), fill="none", stroke=colour, stroke_width=1.1
            )

    def _readings(self) -> None:
        """Write the trough to peak of each place outside the rim, outer wall above inner."""
        for reading in self.inspection.readings:
            if reading.angle is None:
                continue
            angle = radians(reading.angle)
            x = self.x + (self.rim + 14) * cos(angle)
            y = self.y - (self.rim + 28) * sin(angle) + 4
            anchor = "middle" if abs(cos(angle)) < 0.1 else "start" if cos(angle) > 0 else "end"
            if reading.wall == "outer" or self.inspection.curve.part_wall:
                self.sheet.text(x, y - 13, reading.place, text_anchor=anchor, fill=FAINT)
            else:
                y += 13
            bold = {"text_anchor": anchor, "fill": COLOURS[reading.wall], "font_weight": "bold"}
            self.sheet.text(x, y, self.unit.error(reading.trough_to_peak), **bold)
