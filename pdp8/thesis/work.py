"""Figures 7.1 to 7.5 and 8.2 to 8.5: the parts as the Hydra-Point cut them, and what the instruments showed.

Plots of the path replace the thesis's photographs; polar graphs and traces are made by the instruments of
nc/. Everything comes from tapes that went through eia.pal.
"""

from collections.abc import Iterable
from dataclasses import replace
from random import Random
from typing import Final

import nc
from nc.curves import StraightLine, curve
from nc.inspection import against, inspect
from nc.path import MoveKind, Position
from nc.plot import plot
from nc.talyrond import talyrond
from nc.talysurf import talysurf
from pdp8.thesis import chain
from programs import fluidic

_CUTTER = 125
_AXIS_X, _BASE_Y = 6.0, 0.25
"""Where the part program has the element on the table, inches."""
PRECISION: Final = 0.3
"""How far a stop may be from the programmed place, thousandths (thesis, Chapter 2)."""
_BACKGROUND: Final = 1.2
"""The roughness of a straight-milled wall in Plexiglas, thousandths (thesis, Chapter 8)."""


def part(name: str, close_at: tuple[float, float], zoom: tuple[float, float]) -> str:
    """Figures 7.1, 7.3 and 7.5: a slot; its close view is about `close_at`, `zoom` its scales of X and Y."""
    nominal = chain.nominal(name)
    cutter, band = 1000 * nominal.cutter, 1000 * nominal.tolerance
    path, followed = chain.path(name), curve(nominal, cutter)
    return plot(path, followed, cutter=cutter, tolerance=band, close_at=close_at, zoom=zoom)


def die_tape() -> bytes:
    """Return the joined tape: opening, rounding, groove, without the blank frames that would be digits 0."""
    cuts = ("opening", "rounding", "groove")
    return b"".join(chain.translated(chain.printout("die", cut=cut)).lstrip(b"\0") for cut in cuts)


def polar_graphs() -> list[str]:
    """Figure 7.2: two circles cut by the same tape, that of the listing with the block that closes it."""
    path = chain.path("circle", close=True)
    names = ("First circle", "Second circle, same tape")
    measured = (against(cut_again(path, seed), chain.nominal("circle")) for seed in (1, 2))
    return [talyrond(found, name=name) for found, name in zip(measured, names, strict=True)]


def cut_again(path: nc.Path, seed: int) -> nc.Path:
    """Return the path cut again, each stop off along its axis by at most the machine's precision."""
    errors, at, steps = Random(seed), path.cuts[0].start, []
    for step in path.steps:
        moves = list(step.moves)
        for number, move in enumerate(moves):
            if move.kind is MoveKind.MILL:
                x, y = (
                    at[axis]
                    if move.start[axis] == move.end[axis]
                    else move.end[axis] + errors.uniform(-PRECISION, PRECISION)
                    for axis in (0, 1)
                )
                moves[number] = replace(move, start=at, end=Position(x, y, move.end.z))
                at = moves[number].end
        steps.append(replace(step, moves=tuple(moves)))
    return replace(path, steps=tuple(steps))


def straight_surface() -> str:
    """Figure 8.4: a wall that was milled straight along X."""
    path = chain.typed("001 0 01000 01000 0 00 80", "002 9 03000 03500 0 01 89", "003 6 02000 01000 0 01 84")
    found = inspect(path, StraightLine(1000, 1000, 2000, 1000), cutter=_CUTTER)
    return talysurf(found, (200, 700), background=_BACKGROUND)


def sloped_surface() -> str:
    """Figure 8.5: half an inch of a wall that was milled step-wise, a slope of the element."""
    x1, y1, x2, y2 = wall()
    band = chain.nominal("fluidic").tolerance
    path = chain.path("slope", from_x=x1, from_y=y1, to_x=x2, to_y=y2, tolerance=band)
    line = StraightLine(*(1000 * place for place in (x1, y1, x2, y2)))
    measured = inspect(path, line, cutter=_CUTTER, tolerance=1000 * band)
    start = 0.3 * float(measured.walls.stations.along[-1])
    return talysurf(measured, (start, start + 500), background=_BACKGROUND)


def wall() -> tuple[float, float, float, float]:
    """Return both ends of the first slope of the element's outline on the table, in inches."""
    (u1, v1), (u2, v2) = oblique(fluidic.outline())[0]
    return _AXIS_X + u1, _BASE_Y + v1, _AXIS_X + u2, _BASE_Y + v2


def oblique(segments: Iterable[fluidic.Segment]) -> list[fluidic.Slope]:
    """Return the straight lines that lie at an angle to both axes."""
    lines = (segment for segment in segments if isinstance(segment, fluidic.Slope))
    return [line for line in lines if line.start[0] != line.end[0] and line.start[1] != line.end[1]]


def element(control: float) -> str:
    """Figures 8.2 and 8.3: the element, its control channels so many inches from the power jet's exit."""
    about = chain.nominal("fluidic")
    x1, y1, x2, y2 = (1000 * place for place in wall())
    return plot(
        chain.path("fluidic", control=control),
        StraightLine(x1, y1, x2, y2),
        cutter=1000 * about.cutter,
        tolerance=1000 * about.tolerance,
        close_at=((x1 + x2) / 2, (y1 + y2) / 2),
        zoom=(60, 10),
    )
