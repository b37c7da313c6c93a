"""The path as a DXF drawing in the plane: milling as polylines, positioning as lines, holes as circles.

    layer MILL       a polyline for each run of cuts, closed where it ends within .001 in of its start
    layer POSITION   from the end of a run to the start of the next, dashed
    layer HOLES      where the quill went down, as wide as the cutter
    layer CURVE      the nominal curve, or the edge of the part if that is known

The positions at which nothing is cut, such as the parking of 1971, are left out, as in the G-code. Z is 0, or
with `depth` how deep the cut is below the stock's top, for which the tape's Z feed point is taken.

Needs ezdxf, the extra `nc`.
"""

from collections.abc import Iterator
from contextlib import contextmanager
from io import StringIO
from math import dist
from types import ModuleType
from typing import TYPE_CHECKING

import numpy as np

from nc.curves import Curve
from nc.path import STEP, Move, MoveKind, Path
from nc.unit import INCH, Unit
from tapes.errors import WorkError

if TYPE_CHECKING:
    from ezdxf.document import Drawing

_LAYERS = (
    ("MILL", 5, "CONTINUOUS"),
    ("POSITION", 8, "DASHED"),
    ("HOLES", 1, "CONTINUOUS"),
    ("CURVE", 3, "DASHED"),
)


def dxf(
    path: Path,
    curve: Curve | None = None,
    cutter: float = 500,
    *,
    shift: tuple[float, float] = (0, 0),
    depth: bool = False,
    unit: Unit = INCH,
) -> str:
    """Return DXF text; lengths are thousandths. Raises WorkError without ezdxf, or if nothing is cut."""
    if not (path.cuts or path.holes):
        raise WorkError("no block of this tape cuts: there is nothing to draw")
    with _ezdxf() as ezdxf:
        drawing: Drawing = ezdxf.new("R2010", setup=["linetypes"])
        _Drawing(drawing, path, shift, depth, unit).draw(curve, cutter)
        for name in sorted(drawing.entitydb.dxf_types_in_use()):  # a set's order differs between processes
            drawing.classes.add_class(name)
        text = StringIO()
        drawing.write(text)
    return text.getvalue()


@contextmanager
def _ezdxf() -> Iterator[ModuleType]:
    """Yield the library, set to write the same bytes for the same drawing."""
    try:
        import ezdxf
    except ImportError as error:
        raise WorkError("a DXF drawing needs ezdxf, of the extra `nc`") from error
    options = getattr(ezdxf, "options")  # noqa: B009 -- exported by documentation, not by its types
    before = options.write_fixed_meta_data_for_testing
    options.write_fixed_meta_data_for_testing = True
    try:
        yield ezdxf
    finally:
        options.write_fixed_meta_data_for_testing = before


class _Drawing:
    """The drawing, in its unit, and what has been drawn."""

    def __init__(
        self, drawing: "Drawing", path: Path, shift: tuple[float, float], depth: bool, unit: Unit
    ) -> None:
        self._path, self._shift, self._depth, self._unit = path, shift, depth, unit
        points = [step.modes.feed_point for step in path.steps if step.modes.feed_point is not None]
        self._top = min(points, default=0)
        self._space = drawing.modelspace()
        drawing.units = unit.dxf
        drawing.header["$MEASUREMENT"] = int(unit is not INCH)
        for name, colour, linetype in _LAYERS:
            drawing.layers.add(name, color=colour, linetype=linetype)
        self._places: list[tuple[float, float, float]] = []

    def draw(self, curve: Curve | None, cutter: float) -> None:
        """Draw everything and set the extents."""
        end = None
        for run in self._runs():
            start = run[0].start
            if end is not None and end != start[:2]:
                here, there = self._at(*end), self._at(*start[:2])
                self._space.add_line(here, there, dxfattribs={"layer": "POSITION"})
            self._outline([start[:2], *(move.end[:2] for move in run)], start.z)
            end = run[-1].end[:2]
        radius = cutter / 2
        for x, y, z in self._path.holes:
            attributes = {"layer": "HOLES"}
            self._space.add_circle(self._at(x, y, z), self._unit.of(radius), dxfattribs=attributes)
            self._places += [self._at(x - radius, y - radius, z), self._at(x + radius, y + radius, z)]
        if curve is not None:
            edge, _ = curve.surface(np.linspace(0, 1, 720, endpoint=not curve.closed))
            places = [self._at(x, y)[:2] for x, y in edge.tolist()]
            self._space.add_lwpolyline(places, close=curve.closed, dxfattribs={"layer": "CURVE"})
            self._places += [self._at(x, y) for x, y in edge.tolist()]
        low, high = (tuple(map(edge, zip(*self._places, strict=True))) for edge in (min, max))
        self._space.reset_extents(low, high)

    def _runs(self) -> Iterator[list[Move]]:
        """Yield the cuts that join end to end at one depth."""
        run: list[Move] = []
        for move in self._path.moves:
            if run and move.kind is not MoveKind.MILL:
                yield run
                run = []
            if move.kind is MoveKind.MILL and move.start != move.end:
                run.append(move)
        if run:
            yield run

    def _outline(self, places: list[tuple[float, float]], z: float) -> None:
        closed = len(places) > 2 and dist(places[0], places[-1]) <= STEP
        line = [self._at(x, y, z) for x, y in places[: -1 if places[0] == places[-1] else None]]
        attributes = {"layer": "MILL", "elevation": line[0][2]}
        self._space.add_lwpolyline([at[:2] for at in line], close=closed, dxfattribs=attributes)
        self._places += line

    def _at(self, x: float, y: float, z: float | None = None) -> tuple[float, float, float]:
        """Return the drawing's coordinates of a place on the table, in thousandths."""
        down = self._top - z if self._depth and z is not None else 0.0
        return self._unit.of(x + self._shift[0]), self._unit.of(y + self._shift[1]), self._unit.of(down)
