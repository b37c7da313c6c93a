"""The reports of `nc cut` and `nc inspect`.

The report on the thesis's circle also gives the thesis's figures (Chapter 7), for comparison; no other figure
depends on them.
"""

from collections.abc import Iterator

from nc.curves import Ellipse
from nc.inspection import Inspection, Reading
from nc.listing import place, quill
from nc.path import STEP, Path, Position
from nc.unit import INCH, Unit
from tapes.hydrapoint import POSITIONING_SPEED
from tapes.quantities import counted

THESIS_CIRCLE = (Ellipse(4000, 4000, 1750, 1750), 500)
"""The test circle of Chapter 7: 4 in across, 1/2 in cutter."""

_WORST_1971 = ".009"
_DIAGONALS_1971 = "about .001"
"""What the Talyrond showed of it (Chapter 7): the maximum, at the apexes, and the roughness at 45 degrees."""


def cut_report(path: Path, passes: int = 1) -> Iterator[str]:
    """Yield what the machine did with the tape, and the time of `passes` of it, line by line."""
    yield from _what(path)
    yield ""
    yield from _times(path)
    if passes > 1:
        total = path.times.total
        yield f"{f'{passes} passes':14}{_minutes(passes * total)}   {total / 60:.1f} each"


def _what(path: Path) -> Iterator[str]:
    yield f"blocks        {len(path)}"
    for step in path.steps:
        if step.stop:
            yield f"stop          block {step.number}: {step.stop}, waits for START"
    if path.holes:
        yield f"holes         {len(path.holes)}"
    if path.cuts:
        length = sum(move.length for move in path.cuts)
        ends = [at for move in path.cuts for at in (move.start, move.end)]
        yield f"milled        {length / 1000:.3f} in, {counted(path.milling_blocks, 'blocks')}"
        low, high = (Position(*map(end, zip(*ends, strict=True))) for end in (min, max))
        yield f"extent        {place(low)} to {place(high)}"
        closes = f"{path.gap / 1000:.3f} in from its start" if path.gap else "at its start"
        yield f"milling ends  {place(path.cuts[-1].end)}, {closes}"
    last = path.steps[-1].at
    yield f"cutter        {place(last)}, {quill(last)}"


def _times(path: Path) -> Iterator[str]:
    times = path.times
    changes, seconds = sum(step.tool_changed for step in path.steps), path.tool_change_seconds
    each = f"{changes} at {seconds:g} s" if seconds else f"{changes}, time not counted"
    blocks = counted(len(path), "blocks")
    yield f"reading       {_minutes(times.reading)}   {blocks} at {path.read_seconds:g} s"
    yield f"positioning   {_minutes(times.positioning)}   at {POSITIONING_SPEED:g} in/min"
    yield f"Z feed        {_minutes(times.z_feed)}"
    feeds = sorted({round(move.speed, 3) for move in path.cuts})
    fed = f"   at {' to '.join(f'{feed:g}' for feed in feeds[:1] + feeds[1:][-1:])} in/min" if feeds else ""
    yield f"milling       {_minutes(times.milling)}{fed}"
    yield f"tool changes  {_minutes(times.tool_changes)}   {each}"
    yield f"machining     {_minutes(times.total)}"
    if path.cuts:
        contour = path.contour
        yield (
            f"contour alone {_minutes(contour.total)}   {counted(path.milling_blocks, 'milling blocks')}: "
            f"reading {contour.reading / 60:.1f}, cutting {contour.milling / 60:.1f}, "
            f"efficiency {contour.efficiency:.0%}"
        )


def _minutes(seconds: float) -> str:
    return f"{seconds / 60:7.1f} min"


def inspection_report(inspection: Inspection, source: str = "", unit: Unit = INCH) -> Iterator[str]:
    """Yield the readings of the instruments, line by line; `source` is where the nominal curve is from."""
    yield f"nominal   {inspection.curve.said(unit)}"
    if source:
        yield f"known by  {source}"
    yield (
        f"cutter    {unit.size(inspection.cutter)} {unit.name}; its centre went "
        f"from {_side(inspection, 0, unit)} to {_side(inspection, 1, unit)} of nominal"
    )
    yield f"stations  {len(inspection.walls.stations)}"
    if inspection.curve.closed and inspection.gap > STEP:
        gap = f"{unit.error(inspection.gap)} {unit.name}"
        yield f"open      the milling ends {gap} from its start: the contour is not closed"
    if inspection.uncut:
        yield f"not cut   {inspection.uncut:.1%} of the curve was not reached by the cutter"
    for wall, part in inspection.without.items():
        if part:
            yield f"no wall   {wall}, along {part:.1%} of the curve: it bends more sharply than the cutter"
    yield ""
    yield from _readings(inspection, unit)
    yield ""
    worst, inches = inspection.worst, " in" * (unit is not INCH)
    yield (
        f"worst trough to peak {unit.error(worst.trough_to_peak)} {unit.name}: {worst.wall} wall, "
        f"{worst.place}, from {unit.signed(worst.lowest)} to {unit.signed(worst.highest)}"
        + (f"; thesis {_WORST_1971}{inches}" if _is_of_the_thesis(inspection) else "")
    )
    diagonal = [each.trough_to_peak for each in inspection.readings if _is_diagonal(each)]
    if diagonal:
        yield f"at 45 degrees {unit.error(min(diagonal))} to {unit.error(max(diagonal))} {unit.name}"
    yield _verdict(inspection, unit)


def _side(inspection: Inspection, end: int, unit: Unit) -> str:
    sides = ("inside", "outside") if inspection.curve.closed else ("right", "left")
    return f"{unit.error(inspection.centre[end])} {sides[inspection.centre[end] > 0]}"


def _verdict(inspection: Inspection, unit: Unit) -> str:
    furthest = inspection.furthest
    sign = 1 if furthest.error > 0 else -1
    most = max(sign * each.error for each in inspection.readings if each.wall == furthest.wall)
    off = f"{unit.signed(sign * most)} off nominal at most, {furthest.wall} wall, {furthest.place}"
    if inspection.curve.guessed:
        return f"no verdict, as the nominal is guessed: {off}"
    judged = "within" if inspection.within_tolerance else "out of"
    uncut = "not all of the curve is cut; " if inspection.uncut else ""
    return f"{judged} tolerance: {uncut}{off}; {unit.error(inspection.tolerance)} is allowed"


def _readings(inspection: Inspection, unit: Unit) -> Iterator[str]:
    is_thesis = _is_of_the_thesis(inspection)
    heading = f"{'place':14}{'wall':7}{'lowest':>9}{'highest':>9}  trough to peak"
    yield f"{heading}   thesis{', in' * (unit is not INCH)}" if is_thesis else heading
    for reading in inspection.readings:
        errors = f"{unit.signed(reading.lowest):>9}{unit.signed(reading.highest):>9}"
        line = f"{reading.place:14}{reading.wall:7}{errors}{unit.error(reading.trough_to_peak):>16}"
        yield f"{line}   {_DIAGONALS_1971}" if is_thesis and _is_diagonal(reading) else line


def _is_diagonal(reading: Reading) -> bool:
    return reading.angle is not None and reading.angle % 90 == 45


def _is_of_the_thesis(inspection: Inspection) -> bool:
    """Whether this is the circle that the thesis measured: cut step-wise, by its cutter."""
    return inspection.stepwise and (inspection.curve, inspection.cutter) == THESIS_CIRCLE
