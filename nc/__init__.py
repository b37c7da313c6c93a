"""The Moog Hydra-Point 83-1000 MC, from the tape under its head to the part on the bench.

    blocks      frames to blocks of 20 rows, or the row that is wrong
    machine     what each block makes the machine do, and for how long
    path        what it did: steps, moves, modes, times

It knows tapes and nothing else of ours.
"""

from nc.blocks import BlockError
from nc.machine import CutError, HydraPoint, Settings, cut
from nc.path import Move, Path, Step, Times

__all__ = ["BlockError", "CutError", "HydraPoint", "Move", "Path", "Settings", "Step", "Times", "cut"]
