"""What the thesis says of each part: blocks, minutes and errors, with the place where it says so.

No figure of the programs depends on these; they are for comparison.

Source: thesis (M. S. Wong, McMaster University, 1971), Chapters 7, 8 and 10, Table 10.1.
"""

from typing import Final, NamedTuple


class Thesis(NamedTuple):
    """The figures of one part, quoted; None: the thesis gives none. Times in minutes, errors in inches."""

    blocks: str | None = None
    punch: str | None = None
    translate: str | None = None
    cut: str | None = None
    reading: str | None = None
    worst: str | None = None
    diagonals: str | None = None


THESIS: Final = {
    "circle": Thesis(
        blocks="about 670 (Ch. 7)",
        punch="30 (Ch. 7)",
        translate="30 (Ch. 7)",
        cut="36 (Ch. 7), 30 (Table 10.1)",
        reading="2 s a block (Ch. 7)",
        worst=".010 designed, .009 measured (Ch. 7)",
        diagonals="about .001 (Ch. 7)",
    ),
    "ellipse": Thesis(
        blocks="about 1000 (Ch. 7)",
        punch="46 (Ch. 7)",
        translate="45 (Ch. 7)",
        cut="50 (Ch. 7)",
        reading="about 33 (Ch. 10)",
    ),
    "die": Thesis(blocks="800 (Table 10.1)", cut="40 a pass (Table 10.1)"),
    "polynomial": Thesis(blocks="1200 (Ch. 7)", punch="60 (Ch. 7)", translate="50 (Ch. 7)", cut="55 (Ch. 7)"),
    "fluidic": Thesis(
        blocks="2650 (Table 10.1)", cut="180 (Table 10.1)", worst=".003 designed, .0028 measured (Ch. 8)"
    ),
}
"""The thesis's figures, by part."""


class Timed(NamedTuple):
    """Three cells of Table 10.1: blocks in the tape, machining minutes a pass and in all."""

    blocks: int
    minutes: float
    total: float


class Row(NamedTuple):
    """A row of Table 10.1; None: N.A."""

    part: str
    step: Timed
    piece: Timed | None


TABLE_10_1: Final = {
    "circle": Row('4" dia. circle in aluminum', Timed(670, 30, 30), Timed(200, 9, 9)),
    "ellipse": Row('6" x 4½" ellipse in aluminum', Timed(1000, 50, 50), Timed(400, 18, 18)),
    "die": Row('6" x 3" elliptical steel die', Timed(800, 40, 200), Timed(350, 16, 120)),
    "polynomial": Row("Third degree polynomial", Timed(1200, 55, 55), None),
    "fluidic": Row("Fluidic model", Timed(2650, 180, 180), None),
}
"""Table 10.1 as printed, by part; both techniques at +-.005. The die's totals are through 2 in of steel; the
120 minutes are marked "approximate value"."""
