"""The steel die for sheet metal bulging: the ellipse's program with three sets of axes (Chapter 7).

      .------------------------------.       the opening and its clearance    6 x 3 in, the thesis's
      |     .-- - groove - --.       |       the rounding of its corner       ours: 1/4 in wider all round
      |   .'   .-opening-.    '.     |       the groove                       ours: 7 1/2 x 4 1/2 in
      |   '.   '---------'    .'     |
      |     '-- - - - - - --'        |       The block is about 12 x 8 x 2 in; its corner lies at the table's
      '------------------------------'       zero, the ellipses in its middle. Axes are the cutter centre's.

The thesis gives only the opening; the two other sets are our choice, such that they lie round it and in the
block.

Source: thesis, Chapter 7 and Table 10.1.
"""

from typing import Annotated, Final, Literal

from programs import ellipse
from programs.arithmetic import EXACT, WHICH, Arithmetic
from programs.format import Overflow
from programs.function import CutterOfSurface
from programs.header import THESIS, Header
from programs.milling import AS_LISTED, NO_CUTTER, SLOWEST, Milling
from programs.profile import RoundSide
from programs.units import THOUSANDTHS

AXES: Final = {"opening": (3000, 1500), "rounding": (3125, 1625), "groove": (3750, 2250)}
"""Semi-axes of the three programs, thousandths of an inch."""

BLOCK: Final = (12000, 8000, 2000)
"""The block along X, Y and Z, thousandths of an inch."""


def part(
    *,
    cut: Annotated[Literal["opening", "rounding", "groove"], "which of the three"] = "opening",
    major: Annotated[int | None, "semi-major axis, else that of the cut", THOUSANDTHS] = None,
    minor: Annotated[int | None, "semi-minor axis, else that of the cut", THOUSANDTHS] = None,
    tolerance: Annotated[float, "half the width of the band", THOUSANDTHS.below(1)] = 5,
    centre_x: Annotated[int, "X of the centre", THOUSANDTHS] = 6000,
    centre_y: Annotated[int, "Y of the centre", THOUSANDTHS] = 4000,
    cutter: CutterOfSurface = None,
    side: RoundSide = "outside",
    milling: Milling = SLOWEST,
    header: Header = THESIS,
    arithmetic: Annotated[Arithmetic, WHICH, *AS_LISTED, NO_CUTTER] = EXACT,
    overflow: Overflow = "low-digits",
) -> str:
    """Return the printout of one of the die's three tapes; lengths are thousandths. Raises WorkError."""
    return ellipse.part(
        major=AXES[cut][0] if major is None else major,
        minor=AXES[cut][1] if minor is None else minor,
        tolerance=tolerance,
        centre_x=centre_x,
        centre_y=centre_y,
        cutter=cutter,
        side=side,
        milling=milling,
        header=header,
        arithmetic=arithmetic,
        overflow=overflow,
    )
