"""The six blocks that open a tape: park, tool, coolant, spindle, start of the contour, depth.

    001  position X 19.000 Y 0     02  end of program: a looped tape stops here, the part out of the way
    002  tool 01                   86  automatic tool change
    003                            08  mist coolant on
    004  code 31                   88  spindle speed, 2000 rpm
    005  position X Y              80  no change: to where the contour starts
    006  read Z 3.000 to 3.500     89  Z feed code 01

Sources: thesis, Appendices C and D, lines 105 to 255, decoded with Tables 2.3 and 2.4.
"""

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Annotated

from programs.units import CODE, NUMBER, THOUSANDTHS
from tapes.errors import WorkError
from tapes.hydrapoint import (
    CAROUSEL,
    COOLANT,
    SPINDLE,
    X_TRAVEL,
    Y_TRAVEL,
    Z_FEED,
    Z_TRAVEL,
    Block,
    Miscellaneous,
    Preparatory,
)


@dataclass(frozen=True)
class Header:
    """The constants of the opening blocks, lengths in thousandths: A1, A2 the parking place, C4 the coolant
    (7 flood, 8 mist, 9 off), G4 the Z feed. Raises WorkError.
    """

    park_x: Annotated[int, "", THOUSANDTHS] = 19000
    park_y: Annotated[int, "", THOUSANDTHS] = 0
    tool: Annotated[int, "B4: tool of the carousel, 1 to 24", NUMBER] = 1
    coolant: Annotated[int, "", CODE] = Miscellaneous.MIST_COOLANT
    spindle: Annotated[int, "D4: spindle speed code of Table 2.4", CODE] = 31
    z_feed_point: Annotated[int, "G1: Z where the feed begins", THOUSANDTHS] = 3000
    z_depth: Annotated[int, "G3: final depth of Z", THOUSANDTHS] = 3500
    z_feed: Annotated[int, "", CODE] = 1

    def __post_init__(self) -> None:
        for name, value, limit in (
            ("park X", self.park_x, X_TRAVEL),
            ("park Y", self.park_y, Y_TRAVEL),
            ("Z feed point", self.z_feed_point, Z_TRAVEL),
            ("final Z depth", self.z_depth, Z_TRAVEL),
        ):
            if not 0 <= value <= limit:
                raise WorkError(f"{name} {value / 1000:g} in is outside the travel: 0 to {limit / 1000:g} in")
        depth, feed_point = self.z_depth / 1000, self.z_feed_point / 1000
        if depth < feed_point:
            raise WorkError(f"final Z depth {depth:g} in is above the Z feed point, {feed_point:g} in")
        if self.tool not in CAROUSEL:
            raise WorkError(f"tool {self.tool} is not in the carousel: 1 to {CAROUSEL[-1]}")
        if self.coolant not in COOLANT:
            raise WorkError(f"coolant {self.coolant} must be 7 flood, 8 mist or 9 off")
        for name, code, known, codes in (
            ("spindle", self.spindle, SPINDLE, "1 to 18 and 21 to 38"),
            ("Z feed", self.z_feed, Z_FEED, "1 to 18"),
        ):
            if code not in known:
                raise WorkError(f"{name} code {code} is not in Table 2.4: {codes}")

    def blocks(self, x: int, y: int) -> Iterator[Block]:
        """The blocks, for a contour that starts at `x`, `y`."""
        position, read_z = Preparatory.POSITION, Preparatory.READ_Z
        yield Block(1, position, self.park_x, self.park_y, 0, 0, Miscellaneous.END_OF_PROGRAM)
        yield Block(2, position, 0, 0, 0, self.tool, Miscellaneous.TOOL_CHANGE)
        yield Block(3, position, 0, 0, 0, 0, self.coolant)
        yield Block(4, position, 0, 0, 0, self.spindle, Miscellaneous.SPINDLE_SPEED)
        yield Block(5, position, x, y, 0, 0, Miscellaneous.NO_CHANGE)
        yield Block(6, read_z, self.z_feed_point, self.z_depth, 0, self.z_feed, Miscellaneous.Z_FEED)


THESIS = Header()
"""The header of both listings."""
