"""FORMAT: the fields of a PRINT statement, as the terminal of 1971 printed them.

    FORMAT(I3,I1,I5,I5,I3,I2)    "  76 2250 4133  185"    19 characters, blanks in front of each number
    FORMAT(1X,I5,I4,I5,I4)       "  1019   0    0   2"    1X is punched as a blank: no carriage control column

An I-field takes a REAL and prints its whole part, as both listings need. A number wider than its field (a
sequence number past 999 in I3) keeps its low digits: the thesis's polynomial had 1200 blocks and was cut, and
stars, which the translation drops, would have made its blocks short. Stars, the other convention of the time,
are an option.

Not emulated: every field but I and X, repeat counts, groups, slashes.

Sources: thesis, Chapter 6 and Appendices C and D.
"""

from typing import Annotated, Literal, SupportsInt

Overflow = Annotated[Literal["low-digits", "stars"], ""]
"""How a number wider than its field is printed."""


class Format:
    """A FORMAT statement's fields: `Format("1X,I5,I4")`."""

    def __init__(self, fields: str) -> None:
        self._fields = fields.split(",")

    def line(self, *values: SupportsInt, overflow: Overflow = "low-digits") -> str:
        r"""Return the line that PRINT gives for `values`, one for each I-field, ended by "\n"."""
        line, numbers = "", iter(values)
        for field in self._fields:
            if field.endswith("X"):
                line += " " * int(field[:-1])
                continue
            digits, width = str(int(next(numbers))), int(field[1:])
            if len(digits) > width:
                digits = "*" * width if overflow == "stars" else digits[-width:]
            line += digits.rjust(width)
        return line + "\n"
