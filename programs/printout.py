"""The printout of a part program: a block is a line of 19 characters, its 20th row the end of the line.

    10 FORMAT(1X,I5,I4,I5,I4)       the blocks before the contour, their 19 digits in groups
    30 FORMAT(I3,I1,I5,I5,I3,I2)    sequence, preparatory, X, Y, reserved and tool, miscellaneous

A block beyond the machine's travel is refused, with its number: a minus sign is not a digit, and the
translation would drop it and shift every row after it.

Sources: thesis, Chapter 6 and Appendices C and D; travel from Chapter 2.
"""

from math import isfinite
from typing import SupportsInt

from programs.format import Format, Overflow
from programs.header import Header
from tapes.errors import WorkError
from tapes.hydrapoint import MISCELLANEOUS, PREPARATORY, X_TRAVEL, XY_FEED, Y_TRAVEL, Block, Preparatory

LAST_SEQUENCE = 999

_TRAVEL = {"X": X_TRAVEL, "Y": Y_TRAVEL}

FORMAT_10 = Format("1X,I5,I4,I5,I4")
FORMAT_30 = Format("I3,I1,I5,I5,I3,I2")


class Printout:
    """Collects the lines that a part program prints."""

    def __init__(self, overflow: Overflow = "low-digits") -> None:
        self._overflow = overflow
        self._lines: list[str] = []

    @property
    def blocks(self) -> int:
        """How many blocks have been printed."""
        return len(self._lines)

    @property
    def text(self) -> str:
        r"""The whole printout, its lines ended by "\n"."""
        return "".join(self._lines)

    def header(self, header: Header, x: SupportsInt, y: SupportsInt) -> None:
        """PRINT 10, six times: the opening blocks of a contour that starts at `x`, `y`."""
        for block in header.blocks(*self._on_table(x, y, 5)):
            self.print_10(block)

    def print_10(self, block: Block) -> None:
        """PRINT 10: a block whose first digit is 0, by the digits of its groups."""
        digits = block.digits
        groups = (digits[1:6], digits[6:10], digits[10:15], digits[15:19])
        self._lines.append(FORMAT_10.line(*map(int, groups), overflow=self._overflow))

    def digits(self, block: Block) -> None:
        """A block typed with all its digits. Raises WorkError where it leaves the table."""
        if block.preparatory != Preparatory.READ_Z:
            self._on_table(block.x, block.y, block.sequence)
        self._lines.append(f"{block.digits}\n")

    def print_30(
        self,
        sequence: SupportsInt,
        preparatory: SupportsInt,
        x: SupportsInt,
        y: SupportsInt,
        tool: SupportsInt,
        miscellaneous: SupportsInt,
    ) -> None:
        """PRINT 30: a block of the contour. Raises WorkError where `x`, `y` is off the table."""
        values = (sequence, preparatory, *self._on_table(x, y, int(sequence)), tool, miscellaneous)
        self._lines.append(FORMAT_30.line(*values, overflow=self._overflow))

    @staticmethod
    def _on_table(x: SupportsInt, y: SupportsInt, sequence: int) -> tuple[int, int]:
        x, y = int(x), int(y)
        check_on_table(f"{sequence:03}", "X", x)
        check_on_table(f"{sequence:03}", "Y", y)
        return x, y


def check_on_table(block: str, axis: str, place: int) -> None:
    """Raise a WorkError where the block's place on axis X or Y, in thousandths, is off the table."""
    if not 0 <= place <= _TRAVEL[axis]:
        raise WorkError(
            f"block {block}: {axis} {place / 1000:.3f} leaves the table: 0 to {_TRAVEL[axis] / 1000:g} in"
        )


def check_feed(code: int) -> None:
    """Raise WorkError for a feed code that is not in Table 2.4."""
    if code not in XY_FEED:
        raise WorkError(f"feed code {code} is not in Table 2.4: 1 to {max(XY_FEED)}")


def check_codes(sequence: int, preparatory: int, *functions: int) -> None:
    """Raise WorkError for a first sequence number or a code that the machine does not have."""
    if not 0 <= sequence <= LAST_SEQUENCE:
        raise WorkError(f"sequence number {sequence}: must be 0 to {LAST_SEQUENCE}")
    if preparatory not in PREPARATORY:
        raise WorkError(f"preparatory function {preparatory} is not in Table 2.3")
    for function in functions:
        if function not in MISCELLANEOUS:
            raise WorkError(f"miscellaneous function {function} is not in Table 2.3")


def check_band(name: str, size: float, inner: float, outer: float) -> None:
    """Raise WorkError unless `size` is positive and its limits are two thousandths or more apart."""
    what, least, most = f"{name} {_inches(size)}", _inches(inner), _inches(outer)
    if not (isfinite(size) and isfinite(inner) and isfinite(outer)):
        raise WorkError(f"{what} between {inner:g} and {outer:g}: all have to be finite")
    if size <= 0:
        raise WorkError(f"{what}: must be greater than 0")
    if inner <= 0:
        raise WorkError(f"{what} has an inner limit of {least}: the tolerance must be smaller than the curve")
    if outer > X_TRAVEL:
        raise WorkError(f"{what} has an outer limit of {most}: the table is {_inches(X_TRAVEL)}")
    if outer - inner < 2:
        resolution = "a tolerance must be .001 in, the machine's resolution, or more"
        raise WorkError(f"{what} between {least} and {most}: {resolution}")


def check_start(x: float, y: float, furthest_x: float, furthest_y: float) -> None:
    """Raise WorkError for a contour that starts outside its first quadrant, or outside its outer limit."""
    if not (0 <= x <= furthest_x and 0 <= y <= furthest_y):
        raise WorkError(
            f"start X {_inches(x)}, Y {_inches(y)} from the centre: must be in the first quadrant, at most "
            f"X {_inches(furthest_x)}, Y {_inches(furthest_y)}"
        )


def _inches(thousandths: float) -> str:
    return f"{thousandths / 1000:.7g} in"
