"""The Moog Hydra-Point 83-1000 MC, from the tape under its head to the part on the bench.

    blocks      frames to blocks of 20 rows, or the row that is wrong
    machine     what each block makes the machine do, and for how long
    path        what it did: steps, moves, modes, times
    listing     the program as a table
    curves      the curve that was meant: circle, ellipse, line, polynomial
    inspection  the walls a round cutter left, against that curve
    report      the day at the machine and the part on the bench, in words
    drawing     a sheet of paper with inch scales: SVG
    plot        path and cut surface, and the staircase in its band
    talyrond    the polar graph
    talysurf    the straight one
    gcode       the path for today's controllers
    dxf         the path as a drawing
    cli         pdp8 nc
    options     what its commands take in common

It knows tapes and nothing else of ours. Pictures of it are drawn without any library.
"""

from nc.blocks import BlockError
from nc.machine import CutError, HydraPoint, Settings, cut
from nc.path import Move, Path, Step, Times

__all__ = ["BlockError", "CutError", "HydraPoint", "Move", "Path", "Settings", "Step", "Times", "cut"]
