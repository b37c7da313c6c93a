"""A curve made into blocks, by either technique of Chapter 3.

Lengths of the parts that have no listing are inches, as the chapters give them; the tape has thousandths.

Source: thesis, Chapters 3 and 6; sequence numbers follow the header's six.
"""

from math import isfinite
from typing import Annotated, Literal

from programs import stepwise
from programs.errors import PartError
from programs.piecewise import Feeds, Technique
from programs.printout import Printout, check_feed
from programs.stretches import Axis, Curve, Point
from tapes.hydrapoint import RESOLUTION

MILL = 6
POSITION = 0
FEED_FUNCTION: dict[Axis, int] = {"X": 84, "Y": 85}
"""Miscellaneous functions that say whose feed rate the tool function is."""

TechniqueName = Annotated[Literal["step", "piece"], "step-wise or piece-wise linear technique"]
FeedCode = Annotated[int, "feed code of Table 2.4, step-wise technique"]
Fastest = Annotated[int, "fastest feed code used, piece-wise technique"]
FeedError = Annotated[float, "part by which feeds may be wrong, piece-wise technique"]


def thousandths(name: str, inches: float) -> int:
    """Return `inches` in the machine's units. Raises PartError for what is no whole number of them."""
    units = inches / RESOLUTION
    if not isfinite(units) or abs(units - round(units)) > 1e-6:
        raise PartError(f"{name} {inches:g} in is no whole number of thousandths of an inch")
    return round(units)


def tolerance_units(tolerance: float) -> float:
    """Return `tolerance`, inches, in the machine's units, as its digits say. Raises PartError for none."""
    units = round(tolerance / RESOLUTION, 9)
    if not isfinite(units):
        raise PartError(f"a tolerance of {tolerance:g} in is none")
    return units


def mill(
    printout: Printout,
    curve: Curve,
    technique: str = "step",
    feed: int = 1,
    fastest: int = 5,
    feed_error: float = 0.2,
) -> None:
    """Print the blocks that mill along `curve`; the cutter is at its start. Raises PartError."""
    check_feed(feed)
    if technique == "step":
        for cut in stepwise.cuts(curve):
            _print(printout, MILL, cut.stop, feed, cut.axis)
    else:
        _mill_piecewise(printout, curve, Technique(fastest, feed_error))


def position(printout: Printout, stop: Point) -> None:
    """Print a block that goes to `stop` with the spindle up."""
    printout.print_30(printout.blocks + 1, POSITION, *stop, 0, 80)


def _mill_piecewise(printout: Printout, curve: Curve, technique: Technique) -> None:
    at, force = curve.start, Feeds(0, 0)
    for ray in technique.rays(curve):
        changes: list[tuple[Axis, int]] = []
        if ray.feeds.y not in (0, force.y):
            changes.append(("Y", ray.feeds.y))
        if ray.feeds.x not in (0, force.x):
            changes.append(("X", ray.feeds.x))
        if len(changes) > 1:
            axis, code = changes.pop(0)
            _print(printout, MILL, at, code, axis)
        force = Feeds(ray.feeds.x or force.x, ray.feeds.y or force.y)
        axis, code = changes[0] if changes else ("X", force.x) if force.x else ("Y", force.y)
        _print(printout, MILL, ray.stop, code, axis)
        at = ray.stop


def _print(printout: Printout, preparatory: int, stop: Point, code: int, axis: Axis) -> None:
    printout.print_30(printout.blocks + 1, preparatory, *stop, code, FEED_FUNCTION[axis])
