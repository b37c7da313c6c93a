"""The thesis's figures beside the afternoon's."""

from collections.abc import Iterator
from typing import Final, NamedTuple

from nc.inspection import Inspection, against
from pdp8.replay.afternoon import Afternoon
from pdp8.replay.implied import SLOWEST, machined
from programs import circle
from programs.parts import PARTS
from programs.thesis import THESIS, Thesis
from tapes.hydrapoint import FEED_TOLERANCE, Preparatory
from tapes.quantities import inches

COLUMNS: Final = ("", "thesis", "replay")
NOT_SAID: Final = "–"


class Figure(NamedTuple):
    """One figure: its name, the thesis's value, the replay's value."""

    figure: str
    thesis: str
    replay: str


def compare(afternoon: Afternoon) -> list[Figure]:
    """Return the table's lines for this afternoon."""
    said = THESIS.get(afternoon.part, Thesis())
    found = [*_minutes(afternoon, said), *_errors(afternoon, said)]
    return [Figure(name, thesis or NOT_SAID, replayed) for name, thesis, replayed in found]


def _minutes(afternoon: Afternoon, said: Thesis) -> Iterator[tuple[str, str | None, str]]:
    """Yield blocks and minutes, the parts of the machine time, and the minutes at another feed."""
    minutes, times = afternoon.minutes, afternoon.path.times
    yield "blocks", said.blocks, f"{len(afternoon.path)}"
    before = {name: own for name, own in minutes.items() if name not in ("punch", "translate", "cut")}
    for name, own in before.items():
        yield f"minutes: {name}", None, f"{own:.1f}"
    yield "minutes to punch", said.punch, f"{minutes['punch']:.1f}"
    if before:
        yield "minutes until it is punched", said.punch, f"{minutes['punch'] + sum(before.values()):.1f}"
    yield "minutes to translate", said.translate, f"{minutes['translate']:.1f}"
    yield "minutes to machine a pass", said.cut, f"{minutes['cut']:.1f}"
    yield "  of these reading the tape", said.reading, f"{times.reading / 60:.1f}"
    milled = [step for step in afternoon.path.steps if step.block.preparatory == Preparatory.MILL]
    if milled:
        yield "  of these the contour alone", None, f"{afternoon.path.contour.total / 60:.1f}"
    if any(step.block.tool != SLOWEST for step in milled):
        for error, name in ((0.0, "1.0"), (FEED_TOLERANCE, "1.2")):
            slower = machined(afternoon.text, SLOWEST, error).times.total
            yield f"  the pass at {name} in/min", said.cut, f"{slower / 60:.1f}"


def _errors(afternoon: Afternoon, said: Thesis) -> Iterator[tuple[str, str | None, str]]:
    """Yield the walls' errors, trough to peak; for the circle also with its contour closed."""
    if afternoon.inspection is None:
        return
    gap, open_ = afternoon.inspection.gap, not afternoon.inspection.curve.closed
    yield "trough to peak at most, in", said.worst if open_ else None, _worst(afternoon.inspection)
    if afternoon.part == "circle" and (nominal := PARTS["circle"].nominal()):
        closed = against(machined(circle.part(close=True)), nominal)
        yield f"  the listing ends {inches(gap)} in short of its start; closed", said.worst, _worst(closed)
    for name, thesis, mark in (
        ("trough to peak at +X +Y -X -Y", None, "apex"),
        ("trough to peak at 45°", said.diagonals, "45°"),
    ):
        for wall in ("outer", "inner"):
            spans = [
                inches(reading.trough_to_peak)
                for reading in afternoon.inspection.readings
                if mark in reading.place and reading.wall == wall
            ]
            if spans:
                yield f"{name}, {wall} wall", thesis, " ".join(spans)


def _worst(inspection: Inspection) -> str:
    worst = inspection.worst
    return f"{inches(worst.trough_to_peak)}, {worst.wall} wall, {worst.place}"
