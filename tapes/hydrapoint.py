"""What a tape says to the Moog Hydra-Point 83-1000 MC: its block format and its codes.

    rows      1 2 3   4   5 ... 9   10 ... 14   15   16 17   18 19   20
            sequence prep    X          Y       res.  tool   misc.   end of block
              0 0 7   6   0 2 2 5 0  0 4 1 3 3   0    0 1     8 5     CR

A block has 20 rows, told apart by position alone. Lengths are whole thousandths of an inch, the decimal point
is never punched: X 02250 is 2.250 in. After preparatory function 9, X holds the Z feed point and Y the final
depth. Table 2.4 goes to 44 in/min where the machine's specification says 40; the table is followed.

Source: thesis (M. S. Wong, McMaster University, 1971), Chapter 2: specifications, Tables 2.3 and 2.4.
"""

from typing import Final, NamedTuple

from tapes.errors import TextError

ROWS: Final = 20
DIGITS: Final = ROWS - 1

RESOLUTION: Final = 0.001
"""Inches in one unit of X, Y and Z."""

X_TRAVEL, Y_TRAVEL, Z_TRAVEL = 20_000, 10_000, 5_000
"""The travels of table, saddle and spindle in thousandths of an inch."""

POSITIONING_SPEED: Final = 300.0
"""Inches a minute."""

FEED_TOLERANCE: Final = 0.20
"""A feed is within this part, more or less, of what Table 2.4 says."""

CAROUSEL: Final = range(1, 25)
"""The tools of the automatic tool changer."""

PREPARATORY: Final = {
    0: "position",
    1: "tap, feed control",
    4: "peck",
    5: "drill",
    6: "mill",
    7: "bore",
    8: "tap, pitch control",
    9: "read Z",
}
"""Preparatory functions, Table 2.3."""

MISCELLANEOUS: Final = {
    0: "program stop",
    2: "end of program",
    6: "tool change, manual",
    7: "flood coolant on",
    8: "mist coolant on",
    9: "coolant off",
    80: "no change",
    81: "partial retract on",
    82: "partial retract off",
    83: "index work piece",
    84: "X feed rate",
    85: "Y feed rate",
    86: "tool change, automatic",
    88: "spindle speed change",
    89: "Z feed rate",
}
"""Miscellaneous functions, Table 2.3."""


class Rates(NamedTuple):
    """A line of the left half of Table 2.4: feeds in in/min, the spindle in revolutions a minute."""

    xy_feed: float
    z_feed: float
    spindle: int


TOOL_FUNCTION: Final = {
    1: Rates(1.0, 1.0, 65),
    2: Rates(1.9, 2.1, 75),
    3: Rates(2.7, 3.6, 91),
    4: Rates(4.0, 5.3, 105),
    5: Rates(5.5, 8.1, 120),
    6: Rates(7.2, 10.3, 140),
    7: Rates(9.1, 13.3, 155),
    8: Rates(11.2, 16.4, 175),
    9: Rates(13.3, 20.0, 195),
    10: Rates(16.0, 25.0, 215),
    11: Rates(18.6, 28.0, 240),
    12: Rates(21.5, 32.0, 270),
    13: Rates(24.7, 37.0, 300),
    14: Rates(27.9, 42.0, 330),
    15: Rates(31.5, 48.0, 375),
    16: Rates(35.6, 53.0, 415),
    17: Rates(39.7, 59.0, 465),
    18: Rates(44.0, 64.0, 495),
}
"""Table 2.4, codes 01 to 18."""

XY_FEED: Final = {code: rates.xy_feed for code, rates in TOOL_FUNCTION.items()}
"""Feed of X and of Y in inches a minute, by tool function code."""

Z_FEED: Final = {code: rates.z_feed for code, rates in TOOL_FUNCTION.items()}
"""Feed of Z in inches a minute, by tool function code."""

SPINDLE: Final = {code: rates.spindle for code, rates in TOOL_FUNCTION.items()} | {
    21: 525,
    22: 625,
    23: 760,
    24: 875,
    25: 1015,
    26: 1140,
    27: 1300,
    28: 1450,
    29: 1610,
    30: 1800,
    31: 2000,
    32: 2225,
    33: 2470,
    34: 2740,
    35: 3100,
    36: 3450,
    37: 3830,
    38: 4090,
}
"""Spindle speed in revolutions a minute, by tool function code; both halves of Table 2.4."""


class Block(NamedTuple):
    """One block: what its 19 digits say. X and Y are thousandths of an inch."""

    sequence: int
    preparatory: int
    x: int
    y: int
    reserved: int
    tool: int
    miscellaneous: int

    @property
    def digits(self) -> str:
        """The 19 digits as they are punched."""
        return (
            f"{self.sequence:03}{self.preparatory:1}{self.x:05}{self.y:05}"
            f"{self.reserved:1}{self.tool:02}{self.miscellaneous:02}"
        )


def block(digits: str | bytes) -> Block:
    """Return the block that 19 decimal digits say. Raises ValueError where they are not digits."""
    return Block(
        int(digits[0:3]),
        int(digits[3:4]),
        int(digits[4:9]),
        int(digits[9:14]),
        int(digits[14:15]),
        int(digits[15:17]),
        int(digits[17:19]),
    )


def is_printed(text: str) -> bool:
    """Tell whether `text` is a program as the thesis prints one, a block's digits apart for clarity."""
    lines = text.splitlines()
    digits_alone = all(line.replace(" ", "").isdecimal() for line in lines)
    return digits_alone and any(len(line) > DIGITS == len(line.replace(" ", "")) for line in lines)


def check_printed(text: str) -> None:
    """Raise TextError naming the first line of a printed program that has not the digits of a block."""
    at = 0
    for line in text.splitlines(keepends=True):
        digits = len(line.replace(" ", "").rstrip("\n"))
        if digits != DIGITS:
            raise TextError(f"a block of {digits} digits; it has {DIGITS}", text, at)
        at += len(line)
