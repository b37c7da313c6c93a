"""The path as a DXF drawing, in inches: milling as polylines, positioning as lines, holes as circles.

    layer MILL       one polyline for each run of cuts, at the depth it was cut
    layer POSITION   positioning moves, dashed
    layer HOLES      where the quill went down, as wide as the cutter
    layer CURVE      the nominal curve, where it is named
    layer GUESSED    the curve that the path follows, where none is named

Needs ezdxf, the extra `nc`.
"""

from collections.abc import Iterator
from contextlib import contextmanager
from io import StringIO
from itertools import groupby, pairwise
from types import ModuleType
from typing import TYPE_CHECKING

from nc.curves import Curve
from nc.path import MoveKind, Path
from tapes.errors import WorkError

if TYPE_CHECKING:
    from ezdxf.document import Drawing
    from ezdxf.layouts.layout import Modelspace

_INCHES = 1
_LAYERS = (
    ("MILL", 5, "CONTINUOUS"),
    ("POSITION", 8, "DASHED"),
    ("HOLES", 1, "CONTINUOUS"),
    ("CURVE", 3, "DASHED"),
    ("GUESSED", 3, "DASHED"),
)


def dxf(path: Path, curve: Curve | None = None, cutter: float = 500) -> str:
    """Return DXF text; `cutter` is the diameter in thousandths. Raises WorkError where ezdxf is missing."""
    with _ezdxf() as ezdxf:
        drawing: Drawing = ezdxf.new("R2010", setup=["linetypes"])
        _draw(drawing, path, curve, cutter)
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


def _draw(drawing: "Drawing", path: Path, curve: Curve | None, cutter: float) -> None:
    drawing.units = _INCHES
    drawing.header["$MEASUREMENT"] = 0
    for name, colour, linetype in _LAYERS:
        drawing.layers.add(name, color=colour, linetype=linetype)
    space = drawing.modelspace()
    _draw_moves(space, path)
    for hole in path.holes:
        centre = (hole.x / 1000, hole.y / 1000, -hole.z / 1000)
        space.add_circle(centre, cutter / 2000, dxfattribs={"layer": "HOLES"})
    if curve is not None:
        places = (curve.stations(720).points / 1000).tolist()
        layer = "GUESSED" if curve.guessed else "CURVE"
        space.add_lwpolyline(places, close=curve.closed, dxfattribs={"layer": layer})


def _draw_moves(space: "Modelspace", path: Path) -> None:
    """Add the moves across the table; those of the quill alone have no line in a plan."""
    across = [move for move in path.moves if move.start[:2] != move.end[:2]]
    for kind, moves in groupby(across, key=lambda move: move.kind):
        run = list(moves)
        places = [(at.x / 1000, at.y / 1000) for at in (run[0].start, *(move.end for move in run))]
        if kind is MoveKind.MILL:
            elevation = -run[0].start.z / 1000
            space.add_lwpolyline(places, dxfattribs={"layer": "MILL", "elevation": elevation})
            continue
        for here, there in pairwise(places):
            space.add_line(here, there, dxfattribs={"layer": "POSITION"})
