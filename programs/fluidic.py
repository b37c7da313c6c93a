r"""The fluidic bistable of Chapter 8, ten times full size, for a .125 in cutter.

        .-.     .-.           outputs
       .' |  ^  | '.          outer and inner bends, splitter
    ---' /  / \  \ '---
    ---.'  /   \  '.---       vents
        \  '._.'  /           nose of the splitter
    .----\-     -/----.       control channels, through the walls
    '-----\     /-----'
          '-. .-'             nozzle, .2 in wide
         .-' | '-.            entries of the nozzle
         |_______|            supply

The drawing of the element, Figure 8.1, is lost. This outline is ours. It agrees with every statement of the
chapter:

    "about 1 in by 1 in", ten times scale               10.0 x 9.6 in
    "power nozzle of 0.020 in by 0.040 in"              .2 in wide; .4 in is its depth, which is that of the
                                                        .375 in plate that is cut through
    "4 linear slope segments and 9 circular segments"   2 walls, 2 sides of the splitter; 2 entries, 2 vents,
                                                        2 outer and 2 inner bends, the nose
    "horizontal control channels", "4 linear slope      a channel tapers along both sides, from its port to
    interpolations and some straight milling"           its mouth in the wall
    at the exit of the jet, or .8 in downstream         --control 0 or 0.8
    maximum roughness .0028 in on a slope, +-.003 in    walls and channels have 7 in 38, 10.4 degrees to an
                                                        axis: their scallop is .0027 in
    2050 and 600 blocks                                 radii and lengths that give 2046 and 595

All dimensions except those quoted are inferred from the last two lines, or chosen. u is X from the axis of
symmetry, v is Y from the end of the supply; both are for the cutter's centre.

Source: thesis, Chapter 8.
"""

from itertools import pairwise
from typing import Annotated, Final, Literal, NamedTuple

from programs.format import Overflow
from programs.header import THESIS, Header
from programs.milling import SLOWEST, Milling, position
from programs.printout import Printout
from programs.stretches import Curve, Point, arc, line
from programs.units import INCHES, thousandths, tolerance_units
from tapes.errors import WorkError

Place = tuple[float, float]
"""u and v, in inches."""


class Slope(NamedTuple):
    """A straight line, at an angle or along an axis."""

    start: Place
    end: Place

    def mirrored(self) -> "Slope":
        """The same at the other side of the axis of symmetry, the other way."""
        return Slope((-self.end[0], self.end[1]), (-self.start[0], self.start[1]))


class Bend(NamedTuple):
    """An arc from angle `start` through `sweep`, degrees counterclockwise."""

    centre: Place
    radius: float
    start: float
    sweep: float

    def mirrored(self) -> "Bend":
        """The same at the other side of the axis of symmetry, the other way."""
        return Bend((-self.centre[0], self.centre[1]), self.radius, 180 - self.start - self.sweep, self.sweep)


Segment = Slope | Bend

SCALE: Final = 10
"""How many times the model is larger than the element."""

EXIT: Final = 2.3
"""v of the nozzle's exit."""

TAPER: Final = 7 / 38
"""Slope of the walls to Y, and of the sides of the control channels to X."""

_EDGE, _TOP = 4.938, 9.438
_SPLITTER_SIDE, _SPLITTER_TIP = (1.479, 8.216), (0.141, 4.54)

RIGHT: Final[tuple[Segment, ...]] = (
    Slope((0.938, 0.0), (0.938, 1.0)),  # supply
    Bend((0.938, 1.9), 0.9, 270, -90),  # entry of the nozzle
    Slope((0.038, 1.9), (0.038, EXIT)),  # nozzle, .2 wide, to .001, with the cutter's .125
    Slope((0.038, EXIT), (0.1, EXIT)),  # setback
    Slope((0.1, EXIT), (0.66, 5.34)),  # wall
    Bend((1.56, 5.34), 0.9, 180, -90),  # vent
    Slope((1.56, 6.24), (_EDGE, 6.24)),
    Slope((_EDGE, 6.24), (_EDGE, 7.04)),
    Slope((_EDGE, 7.04), (3.3, 7.04)),
    Bend((3.3, 7.94), 0.9, 270, -90),  # outer bend
    Slope((2.4, 7.94), (2.4, _TOP)),  # output
    Slope((2.4, _TOP), (1.6, _TOP)),
    Slope((1.6, _TOP), (1.6, 8.9)),
    Bend((-0.4, 8.9), 2.0, 360, -20),  # inner bend
    Slope(_SPLITTER_SIDE, _SPLITTER_TIP),  # side of the splitter
)
NOSE: Final = Bend((0.0, 4.591), 0.15, -20, -140)
CLOSE: Final = Slope((-0.938, 0.0), (0.938, 0.0))

_FURTHEST = 2.5


def outline() -> tuple[Segment, ...]:
    """Return the main program: up the right half, round the nose, down the left half, and closed."""
    return (*RIGHT, NOSE, *(segment.mirrored() for segment in reversed(RIGHT)), CLOSE)


def channel(downstream: float) -> tuple[Segment, ...]:
    """Return the right control channel, `downstream` inches past the nozzle's exit. Raises WorkError."""
    if not 0 <= downstream <= _FURTHEST:
        raise WorkError(
            f"control channels {downstream:g} in downstream: must be beside the walls, 0 to {_FURTHEST:g} in"
        )
    middle = EXIT + 0.1 + downstream
    mouth = 0.1 + (middle - EXIT) * TAPER
    low, high, wide = middle - 0.05, middle + 0.05, mouth + 2.736
    bottom, top = low - 0.504, high + 0.504
    corners = [
        (mouth, low),
        (wide, bottom),
        (_EDGE, bottom),
        (_EDGE, top),
        (wide, top),
        (mouth, high),
        (mouth, low),
    ]
    return tuple(Slope(start, end) for start, end in pairwise(corners))


def part(
    *,
    program: Annotated[
        Literal["both", "main", "control"], "main program, control channels, or both"
    ] = "both",
    control: Annotated[float, "control channels, downstream of the nozzle's exit", INCHES] = 0.0,
    tolerance: Annotated[float, "half the width of the band", INCHES.below(1)] = 0.003,
    axis_x: Annotated[float, "X of the axis of symmetry", INCHES] = 6.0,
    base_y: Annotated[float, "Y of the end of the supply", INCHES] = 0.25,
    milling: Milling = SLOWEST,
    header: Header = THESIS,
    overflow: Overflow = "low-digits",
) -> str:
    """Return the printout of the element or one of its programs; lengths are inches. Raises WorkError."""
    right = channel(control)
    left = tuple(segment.mirrored() for segment in reversed(right))
    origin = Point(thousandths("axis X", axis_x), thousandths("base Y", base_y))
    paths = {"main": (outline(),), "control": (right, left), "both": (outline(), right, left)}[program]
    printout = Printout(overflow)
    for number, path in enumerate(paths):
        curves = [_curve(segment, origin, tolerance_units(tolerance)) for segment in path]
        if number:
            position(printout, curves[0].start)
        else:
            printout.header(header, *curves[0].start)
        for curve in curves:
            milling.print(printout, curve)
    return printout.text


def _curve(segment: Segment, origin: Point, tolerance: float) -> Curve:
    """The segment on the table, in thousandths."""

    def place(at: Place) -> Point:
        return Point(origin.x + round(at[0] * 1000), origin.y + round(at[1] * 1000))

    if isinstance(segment, Slope):
        return line(place(segment.start), place(segment.end), tolerance)
    return arc(place(segment.centre), segment.radius * 1000, segment.start, segment.sweep, tolerance)
