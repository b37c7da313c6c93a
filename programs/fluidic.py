r"""The fluidic bistable of Chapter 8, ten times full size, for a .125 in cutter.

          .-.       .-.        outputs
          | |  / \  | |        splitter, with a nose
    .-----' '-'   '-' '-----.  vents and bends
    '-----.           .-----'
           \         /         walls
    --------\       /--------  control channels
    ---------\     /---------
              '. .'            nozzle, .2 x .4 in
             .-' '-.
             |_____|           supply

The element's drawing is lost with Figure 8.1. This outline is OURS, of the make-up that the chapter tells: a
main program of 4 slopes (two walls, two sides of the splitter) and 9 arcs (two entries of the nozzle, two
vents, two outer and two inner bends, the splitter's nose), joined by straight milling; and a subprogram of
the control channels, 4 slopes and straight milling, that can be put anywhere downstream of the nozzle's exit.

The nozzle is ten times the chapter's .020 x .040; all else is where the cutter's centre goes. u is X from the
axis of symmetry, v is Y from the end of the supply. The thesis's element took 2050 blocks for the main
program and 600 for the channels, at +-.003; its channels were at the nozzle's exit in one model, .8 in
downstream in the other.

Source: thesis, Chapter 8. All dimensions but the nozzle's, the scale, the cutter and the band are ours.
"""

from itertools import pairwise
from typing import Annotated, Final, Literal, NamedTuple

from programs.format import Overflow
from programs.header import THESIS, Header
from programs.milling import SLOWEST, Milling, position
from programs.printout import Printout
from programs.stretches import Curve, Point, arc, line
from programs.units import thousandths, tolerance_units
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

EXIT: Final = 2.4
"""v of the nozzle's exit."""

_SPLITTER_SIDE, _SPLITTER_TIP = (0.833, 7.25), (0.13, 6.032)

RIGHT: Final[tuple[Segment, ...]] = (
    Slope((0.538, 0.0), (0.538, 1.5)),  # supply
    Bend((0.538, 2.0), 0.5, 270, -90),  # entry of the nozzle
    Slope((0.038, 2.0), (0.038, EXIT)),  # nozzle, .2 wide, to .001, with the cutter's .125
    Slope((0.038, EXIT), (0.1, EXIT)),  # setback
    Slope((0.1, EXIT), (1.1, 5.4)),  # wall
    Bend((1.7, 5.4), 0.6, 180, -90),  # vent
    Slope((1.7, 6.0), (3.0, 6.0)),
    Slope((3.0, 6.0), (3.0, 6.6)),
    Slope((3.0, 6.6), (2.2, 6.6)),
    Bend((2.2, 7.1), 0.5, 270, -90),  # outer bend
    Slope((1.7, 7.1), (1.7, 9.0)),  # output
    Slope((1.7, 9.0), (0.9, 9.0)),
    Slope((0.9, 9.0), (0.9, 7.5)),
    Bend((0.4, 7.5), 0.5, 360, -30),  # inner bend
    Slope(_SPLITTER_SIDE, _SPLITTER_TIP),  # side of the splitter
)
NOSE: Final = Bend((0.0, 6.107), 0.15, -30, -120)
CLOSE: Final = Slope((-0.538, 0.0), (0.538, 0.0))

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
    mouth = round(0.1 + (middle - EXIT) / 3, 3)
    low, high = round(middle - 0.05, 4), round(middle + 0.05, 4)
    bottom, top = round(middle - 0.25, 4), round(middle + 0.25, 4)
    corners = [
        (mouth, low),
        (1.5, bottom),
        (3.0, bottom),
        (3.0, top),
        (1.5, top),
        (mouth, high),
        (mouth, low),
    ]
    return tuple(Slope(start, end) for start, end in pairwise(corners))


def part(
    *,
    program: Annotated[
        Literal["both", "main", "control"], "main program, control channels, or both"
    ] = "both",
    control: Annotated[float, "control channels: inches downstream of the nozzle's exit"] = 0.0,
    tolerance: Annotated[float, "half the width of the band, inches"] = 0.003,
    axis_x: Annotated[float, "X of the axis of symmetry"] = 5.0,
    base_y: Annotated[float, "Y of the end of the supply"] = 0.5,
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
