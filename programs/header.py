"""The six blocks that open a tape: park, tool, coolant, spindle, start of the contour, depth.

    001  position X 19.000 Y 0     02  end of program: a looped tape stops here, the part out of the way
    002  tool 01                   86  automatic tool change
    003                            08  mist coolant on
    004  code 31                   88  spindle speed, 2000 rpm
    005  position X Y              80  no change: to where the contour starts
    006  read Z 3.000 to 3.500     89  Z feed code 01

Sources: thesis, Appendices C and D, lines 105 to 255, with Tables 2.3 and 2.4 for what the numbers say.
"""

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Annotated

from programs.errors import PartError
from tapes.hydrapoint import CAROUSEL, SPINDLE, X_TRAVEL, Y_TRAVEL, Z_FEED, Z_TRAVEL, Block

_COOLANTS = (7, 8, 9)


@dataclass(frozen=True)
class Header:
    """What the opening blocks say; lengths in thousandths of an inch. Raises PartError for what cannot be."""

    park_x: Annotated[int, "A1: X to park at, for loading, thousandths"] = 19000
    park_y: Annotated[int, "A2: Y to park at, thousandths"] = 0
    tool: Annotated[int, "B4: tool of the carousel, 1 to 24"] = 1
    coolant: Annotated[int, "C4: 7 flood, 8 mist, 9 off"] = 8
    spindle: Annotated[int, "D4: spindle speed code of Table 2.4"] = 31
    z_feed_point: Annotated[int, "G1: Z where the feed begins, thousandths"] = 3000
    z_depth: Annotated[int, "G3: final depth of Z, thousandths"] = 3500
    z_feed: Annotated[int, "G4: Z feed code of Table 2.4"] = 1

    def __post_init__(self) -> None:
        for name, value, limit in (
            ("park X", self.park_x, X_TRAVEL),
            ("park Y", self.park_y, Y_TRAVEL),
            ("Z feed point", self.z_feed_point, Z_TRAVEL),
            ("final Z depth", self.z_depth, Z_TRAVEL),
        ):
            if not 0 <= value <= limit:
                raise PartError(f"{name} {value} is outside the travel, 0 to {limit} thousandths of an inch")
        if self.z_depth < self.z_feed_point:
            raise PartError(f"final Z depth {self.z_depth} is above the Z feed point {self.z_feed_point}")
        if self.tool not in CAROUSEL:
            raise PartError(f"tool {self.tool} is not in the carousel, 1 to {CAROUSEL[-1]}")
        if self.coolant not in _COOLANTS:
            raise PartError(f"coolant {self.coolant} is none of 7 flood, 8 mist, 9 off")
        if self.spindle not in SPINDLE:
            raise PartError(f"spindle code {self.spindle} is not in Table 2.4")
        if self.z_feed not in Z_FEED:
            raise PartError(f"Z feed code {self.z_feed} is not in Table 2.4")

    def blocks(self, x: int, y: int) -> Iterator[Block]:
        """The blocks, for a contour that starts at `x`, `y`."""
        yield Block(1, 0, self.park_x, self.park_y, 0, 0, 2)
        yield Block(2, 0, 0, 0, 0, self.tool, 86)
        yield Block(3, 0, 0, 0, 0, 0, self.coolant)
        yield Block(4, 0, 0, 0, 0, self.spindle, 88)
        yield Block(5, 0, x, y, 0, 0, 80)
        yield Block(6, 9, self.z_feed_point, self.z_depth, 0, self.z_feed, 89)


THESIS = Header()
"""The header of both listings."""
