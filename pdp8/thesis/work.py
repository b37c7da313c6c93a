"""Figures 7.1 to 7.5 and 8.2 to 8.5: the parts as the Hydra-Point cut them, and what the instruments showed.

Where the thesis has a photograph stands the plot of the path; polar graphs and traces are the instruments' of
nc/. Everything comes from tapes that went through eia.pal.
"""

from math import hypot
from typing import Any

import nc
from nc.curves import Curve, StraightLine, nominal
from nc.inspection import inspect
from nc.plot import plot
from nc.talyrond import talyrond
from nc.talysurf import talysurf
from pdp8.thesis import chain
from programs import fluidic, parts

_CUTTER = 125
_DOWNSTREAM = 0.8


def circle() -> str:
    """Figure 7.1: the circular slot."""
    return _part("circle", close_at=(4000, 5750))


def ellipse() -> str:
    """Figure 7.3: the elliptical slot."""
    return _part("ellipse", close_at=(4000, 6250))


def polynomial() -> str:
    """Figure 7.5: the slot along the third degree polynomial."""
    return _part("polynomial")


def die() -> str:
    """Figure 7.4: the die, its three tapes joined end to end."""
    return plot(nc.cut(die_tape()), close_at=(6000, 5500))


def die_tape() -> bytes:
    """Return the joined tape: opening, corner rounding, groove.

    The blank frame that each translation begins with is cut off: between two tapes it would be a digit 0.
    """
    cuts = ("opening", "rounding", "groove")
    return b"".join(chain.translated(chain.printout("die", cut=cut)).lstrip(b"\0") for cut in cuts)


def polar_graphs() -> list[str]:
    """Figure 7.2: the circle of the listing, and with one more block that closes the contour."""
    return [talyrond(inspect(chain.path("circle", close=close))) for close in (False, True)]


def at_the_exit() -> str:
    """Figure 8.2: the element with its control channels at the power jet's exit."""
    return _element(0.0)


def downstream() -> str:
    """Figure 8.3: the element with its control channels .8 in downstream."""
    return _element(_DOWNSTREAM)


def straight_surface() -> str:
    """Figure 8.4: a wall that was milled straight along X."""
    path = chain.typed(
        "001 0 01000 01000 0 00 80",
        "002 9 03000 03500 0 01 89",
        "003 6 02000 01000 0 01 84",
    )
    return talysurf(inspect(path, StraightLine(1000, 1000, 2000, 1000), cutter=_CUTTER))


def sloped_surface() -> str:
    """Figure 8.5: an inch of a wall that was milled step-wise, a slope of the element."""
    (x1, y1), (x2, y2) = slope_ends()
    band = parts.find("fluidic").tolerance
    path = chain.path("slope", from_x=x1, from_y=y1, to_x=x2, to_y=y2, tolerance=band)
    curve = StraightLine(*(1000 * place for place in (x1, y1, x2, y2)))
    measured = inspect(path, curve, cutter=_CUTTER, tolerance=1000 * band)
    length = 1000 * hypot(x2 - x1, y2 - y1)
    return talysurf(measured, (0.3 * length, min(0.3 * length + 1000, 0.9 * length)))


def slope_ends() -> tuple[tuple[float, float], tuple[float, float]]:
    """Return the first slope of the element's outline on the table, in inches."""
    for segment in fluidic.outline():
        if isinstance(segment, fluidic.Slope) and all(
            one != other for one, other in zip(segment.start, segment.end, strict=True)
        ):
            (u1, v1), (u2, v2) = segment.start, segment.end
            return (5 + u1, 0.5 + v1), (5 + u2, 0.5 + v2)
    raise AssertionError("the element has slopes")


def _part(name: str, **where: Any) -> str:
    part = parts.find(name)
    path = chain.path(name)
    curve: Curve | None = nominal(**part.nominal) or inspect(path, tolerance=1000 * part.tolerance).curve
    return plot(path, curve, cutter=1000 * part.cutter, tolerance=1000 * part.tolerance, **where)


def _element(control: float) -> str:
    part = parts.find("fluidic")
    return plot(
        chain.path("fluidic", control=control), cutter=1000 * part.cutter, tolerance=1000 * part.tolerance
    )
