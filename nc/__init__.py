"""The Moog Hydra-Point 83-1000 MC: from a tape to the path of its cutter and the part.

    blocks      frames to blocks of 20 rows, or the row that is wrong
    diagnosis   why a tape is refused, said of the tape as a whole
    machine     what each block makes the machine do, and the time it takes
    path        what it did: steps, moves, modes, times
    listing     the program as a table
    curves      the nominal curve: circle, ellipse, line, function of x
    unit        inches, or millimetres of today, for what is said and written
    inspection  the walls a round cutter left, against that curve
    report      the run and the inspection, in words
    drawing     a sheet of paper with inch scales: SVG
    plot        path and cut surface, and the staircase in its band
    talyrond    the polar graph of an inspection
    talysurf    the straight graph of an inspection
    gcode       the path for today's mill, Z 0 on the stock
    gcode_1971  all that the machine did, Z 0 at the quill's top
    dxf         the path as a drawing

It imports tapes and no other package of the project. It draws without a library.
"""

from nc.blocks import BlockError
from nc.machine import CutError, HydraPoint, Settings, cut
from nc.path import Move, Path, Step, Times


def _draw(path: Path) -> str:
    """Return the path and the cut surface as SVG, for a notebook."""
    from nc.plot import plot

    return plot(path)


setattr(Path, "_repr_svg_", _draw)  # noqa: B010  # here, as nc.plot imports nc.path

__all__ = ["BlockError", "CutError", "HydraPoint", "Move", "Path", "Settings", "Step", "Times", "cut"]
