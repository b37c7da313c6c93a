"""What a tape says to the Moog Hydra-Point 83-1000 MC: its block format, its codes and how its axes move.

    rows      1 2 3   4   5 ... 9   10 ... 14   15   16 17   18 19   20
            sequence prep    X          Y       res.  tool   misc.   end of block
              0 0 7   6   0 2 2 5 0  0 4 1 3 3   0    0 1     8 5     CR

A block has 20 rows; their position alone distinguishes them. Lengths are whole thousandths of an inch; the
decimal point is not punched: X 02250 is 2.250 in. After preparatory function 9, X holds the Z feed point and
Y the final depth. Table 2.4 goes up to 44 in/min, the machine's specification to 40; this follows the table.

Sources: thesis (M. S. Wong, McMaster University, 1971), Chapter 2: specifications, Tables 2.3 and 2.4;
Chapter 3, Figure 3.1: two axes at their own feeds.
"""

from enum import IntEnum
from math import copysign
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

NEXT_TOOL: Final = 0
"""The tool function of an automatic tool change that selects the tools in sequence."""


class Preparatory(IntEnum):
    """Preparatory functions, Table 2.3."""

    POSITION = 0
    TAP_FEED = 1
    PECK = 4
    DRILL = 5
    MILL = 6
    BORE = 7
    TAP_PITCH = 8
    READ_Z = 9


PREPARATORY: Final[dict[int, str]] = {
    Preparatory.POSITION: "position",
    Preparatory.TAP_FEED: "tap, feed control",
    Preparatory.PECK: "peck",
    Preparatory.DRILL: "drill",
    Preparatory.MILL: "mill",
    Preparatory.BORE: "bore",
    Preparatory.TAP_PITCH: "tap, pitch control",
    Preparatory.READ_Z: "read Z",
}
"""What the preparatory functions do, in words."""

HOLE_MAKING: Final = frozenset(PREPARATORY) - {Preparatory.POSITION, Preparatory.MILL, Preparatory.READ_Z}
"""The preparatory functions that make a hole at one place."""


class Miscellaneous(IntEnum):
    """Miscellaneous functions, Table 2.3."""

    PROGRAM_STOP = 0
    END_OF_PROGRAM = 2
    MANUAL_TOOL_CHANGE = 6
    FLOOD_COOLANT = 7
    MIST_COOLANT = 8
    COOLANT_OFF = 9
    NO_CHANGE = 80
    PARTIAL_RETRACT_ON = 81
    PARTIAL_RETRACT_OFF = 82
    INDEX = 83
    X_FEED = 84
    Y_FEED = 85
    TOOL_CHANGE = 86
    SPINDLE_SPEED = 88
    Z_FEED = 89


MISCELLANEOUS: Final[dict[int, str]] = {
    Miscellaneous.PROGRAM_STOP: "program stop",
    Miscellaneous.END_OF_PROGRAM: "end of program",
    Miscellaneous.MANUAL_TOOL_CHANGE: "tool change, manual",
    Miscellaneous.FLOOD_COOLANT: "flood coolant on",
    Miscellaneous.MIST_COOLANT: "mist coolant on",
    Miscellaneous.COOLANT_OFF: "coolant off",
    Miscellaneous.NO_CHANGE: "no change",
    Miscellaneous.PARTIAL_RETRACT_ON: "partial retract on",
    Miscellaneous.PARTIAL_RETRACT_OFF: "partial retract off",
    Miscellaneous.INDEX: "index work piece",
    Miscellaneous.X_FEED: "X feed rate",
    Miscellaneous.Y_FEED: "Y feed rate",
    Miscellaneous.TOOL_CHANGE: "tool change, automatic",
    Miscellaneous.SPINDLE_SPEED: "spindle speed change",
    Miscellaneous.Z_FEED: "Z feed rate",
}
"""What the miscellaneous functions do, in words."""

STOPS: Final = frozenset(
    {Miscellaneous.PROGRAM_STOP, Miscellaneous.END_OF_PROGRAM, Miscellaneous.MANUAL_TOOL_CHANGE}
)
"""The miscellaneous functions after which the machine waits for START."""

COOLANT: Final[dict[int, str]] = {
    Miscellaneous.FLOOD_COOLANT: "flood",
    Miscellaneous.MIST_COOLANT: "mist",
    Miscellaneous.COOLANT_OFF: "off",
}
"""The coolant that a miscellaneous function selects."""


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

_FASTER: Final = (
    525, 625, 760, 875, 1015, 1140, 1300, 1450, 1610, 1800, 2000, 2225, 2470, 2740, 3100, 3450, 3830, 4090,
)  # fmt: skip
"""Spindle speeds of codes 21 to 38, the right half of Table 2.4."""

SPINDLE: Final = {
    **{code: rates.spindle for code, rates in TOOL_FUNCTION.items()},
    **dict(enumerate(_FASTER, 21)),
}
"""Spindle speed in revolutions a minute, by tool function code; both halves of Table 2.4."""


FIELDS: Final = {
    "sequence": 3,
    "preparatory": 1,
    "x": 5,
    "y": 5,
    "reserved": 1,
    "tool": 2,
    "miscellaneous": 2,
}
"""The fields of a block in their order, each with its rows; the last row is the end of block."""


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


def corner(
    start: tuple[float, float], stop: tuple[float, float], x_speed: float, y_speed: float
) -> tuple[float, float]:
    """Return where the first axis to arrive leaves the other to go on alone (thesis, Figure 3.1).

    X and Y start together, each at its own speed, greater than 0 for an axis that moves. Where one of them
    does not move, this is the start; where both arrive together, it is the stop.
    """
    across, up = stop[0] - start[0], stop[1] - start[1]
    if not across or not up:
        return start
    x_time, y_time = abs(across) / x_speed, abs(up) / y_speed
    both = min(x_time, y_time)
    return (
        stop[0] if x_time <= y_time else start[0] + copysign(x_speed * both, across),
        stop[1] if y_time <= x_time else start[1] + copysign(y_speed * both, up),
    )


def typed(text: str) -> str | None:
    """Return a program as it is punched, None for text that is no program.

    More than half of its lines are blocks: 19 digits and spaces, or a digit too few or too many, also where
    tabs, commas or semicolons are between the fields or a letter is written for a figure. Where a block's
    digits stand apart, as the thesis prints them, the spaces are for clarity and are left out; else each is a
    zero. Blank lines mean nothing. Raises TextError naming the first other line that is no block, and what
    in a block is neither digit nor space.
    """
    lines = text.split("\n")
    _check_fields(lines, text)
    blocks = [line for line in lines if line.strip()]
    figures = ["".join(_MISTAKEN.get(character, character) for character in line) for line in blocks]
    near = [
        block
        for block in figures
        if block.replace(" ", "").isdecimal() and abs(len(block.replace(" ", "")) - DIGITS) <= 1
    ]
    if 2 * len(near) <= len(blocks):
        return None
    spaced = any(len(block) > DIGITS for block in near)
    at = 0
    for line in lines:
        wrong = next((place for place, each in enumerate(line) if each in _MISTAKEN), None)
        if wrong is not None:
            found = line[wrong]
            raise TextError(f"{_NAMES.get(found, repr(found))} in a block; {_MEANT[found]}", text, at + wrong)
        digits = line.replace(" ", "") if spaced else line
        if line.strip() and not line.replace(" ", "").isdecimal():
            raise TextError(f"{line.strip()[:40]!r} is no block of {DIGITS} digits", text, at)
        if line.strip() and len(digits) != DIGITS:
            raise TextError(f"a block of {len(digits)} digits; it has {DIGITS}", text, at)
        at += len(line) + 1
    return "".join(f"{block.replace(' ', '') if spaced else block}\n" for block in blocks)


def _check_fields(lines: list[str], text: str) -> None:
    """Raise TextError for the first wrong field of a spreadsheet, blocks in more than half of its lines."""
    tables = [_columns(line) for line in lines]
    full = [_is_program(fields) for fields in tables if "".join(fields).strip()]
    if 2 * full.count(True) <= len(full):
        return
    at = 0
    for line, fields in zip(lines, tables, strict=True):
        place = at
        for field, (name, width) in zip(fields, FIELDS.items(), strict=False):
            if cure := _cure(name, width, field.strip()):
                raise TextError(f"{name} {field.strip()} in a block; {cure}", text, place)
            place += len(field) + 1
        at += len(line) + 1


def _cure(name: str, width: int, found: str) -> str:
    """Return what to type for a field of `width` digits, "" if nothing is wrong with it."""
    whole, point, decimals = found.replace(",", ".").partition(".")
    if found.startswith("-"):
        return "no length is below 0"
    if point and (whole + decimals).isdecimal() and name in ("x", "y"):
        return f"type thousandths of an inch, {round(float(f'{whole}.{decimals}') * 1000):05}"
    if not found.isdecimal() or len(found) == width:
        return ""
    digits = f"it has {width} digits"
    return f"{digits}: type {'0' * (width - len(found))}{found}" if len(found) < width else digits


def _is_program(fields: list[str]) -> bool:
    """Whether fields are those of a block: seven, two of them functions that the machine has."""
    if len(fields) != len(FIELDS) or not (fields[1].strip().isdecimal() and fields[6].strip().isdecimal()):
        return False
    return int(fields[1]) in PREPARATORY and int(fields[6]) in MISCELLANEOUS


def _columns(line: str) -> list[str]:
    for mark in ("\t", ";", ","):
        if mark in line:
            return line.split(mark)
    return [line]


_MISTAKEN: Final = {**dict.fromkeys("\t,;", " "), **dict.fromkeys("Oo", "0"), **dict.fromkeys("Il", "1")}
_NAMES: Final = {"\t": "a tab", ",": "a comma", ";": "a semicolon", "O": "the letter O", "l": "the letter l"}
_MEANT: Final = {
    **dict.fromkeys("\t,;", "between its fields are spaces or nothing"),
    **dict.fromkeys("Oo", "a zero is 0"),
    **dict.fromkeys("Il", "a one is 1"),
}
