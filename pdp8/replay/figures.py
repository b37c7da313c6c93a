"""The thesis's figures beside the afternoon's.

A thesis figure is quoted with its chapter; nothing here is adjusted to meet one.

Source: thesis (M. S. Wong, McMaster University, 1971), Chapters 7, 8 and 10, Table 10.1.
"""

from collections.abc import Iterator
from typing import TYPE_CHECKING, Final, NamedTuple

import nc
from tapes.hydrapoint import FEED_TOLERANCE

if TYPE_CHECKING:
    from pdp8.replay.afternoon import Afternoon

COLUMNS: Final = ("", "thesis", "replay")
NOT_SAID: Final = "–"
MILL, SLOWEST = 6, 1
"""The preparatory function and the feed code."""


class Thesis(NamedTuple):
    """What the thesis says of one part; None: it does not say."""

    blocks: str | None = None
    punch: str | None = None
    translate: str | None = None
    cut: str | None = None
    reading: str | None = None
    apexes: str | None = None
    diagonals: str | None = None


THESIS: Final = {
    "circle": Thesis(
        blocks="about 670 (Ch. 7)",
        punch="30 (Ch. 7)",
        translate="30 (Ch. 7)",
        cut="36 (Ch. 7), 30 (Table 10.1)",
        reading="2 s a block (Ch. 7)",
        apexes=".010 designed, .009 measured (Ch. 7)",
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
    "fluidic": Thesis(blocks="2650 (Table 10.1)", cut="180 (Table 10.1)"),
}


class Line(NamedTuple):
    """One figure: what it is, what the thesis says, what came of the replay."""

    figure: str
    thesis: str
    replay: str


def compare(afternoon: "Afternoon") -> list[Line]:
    """Return the table's lines for this afternoon."""
    said = THESIS.get(afternoon.part, Thesis())
    minutes = afternoon.minutes
    return [
        Line("blocks", said.blocks or NOT_SAID, f"{len(afternoon.path)}"),
        Line("minutes to punch", said.punch or NOT_SAID, f"{minutes['punch']:.1f}"),
        Line("minutes to translate", said.translate or NOT_SAID, f"{minutes['translate']:.1f}"),
        Line("minutes to machine a pass", said.cut or NOT_SAID, f"{minutes['cut']:.1f}"),
        *_machining(afternoon, said),
        *_errors(afternoon, said),
    ]


def _machining(afternoon: "Afternoon", said: Thesis) -> Iterator[Line]:
    """Yield what the minutes at the machine are made of, and what they were at another feed."""
    times = afternoon.path.times
    yield Line("  of these reading the tape", said.reading or NOT_SAID, f"{times.reading / 60:.1f}")
    milled = [step for step in afternoon.path.steps if step.block.preparatory == MILL]
    if milled:
        contour = len(milled) * afternoon.path.read_seconds + times.milling
        yield Line("  of these the contour alone", NOT_SAID, f"{contour / 60:.1f}")
    if any(step.block.tool != SLOWEST for step in milled):
        for error, name in ((0.0, "1.0"), (FEED_TOLERANCE, "1.2")):
            settings = nc.Settings(feed_error=(error, error, 0.0), feed_code=SLOWEST)
            slower = nc.cut(afternoon.tapes[f"{afternoon.part}.eia"], settings=settings).times.total
            yield Line(f"  the pass at {name} in/min", said.cut or NOT_SAID, f"{slower / 60:.1f}")


def _errors(afternoon: "Afternoon", said: Thesis) -> list[Line]:
    """Return the lines of the walls' errors, trough to peak, of the outer wall and the inner."""
    inspection = afternoon.inspection
    if inspection is None:
        return []
    lines = []
    for name, thesis, mark in (
        ("inches off at +X +Y -X -Y", said.apexes, "apex"),
        ("inches off at 45°", said.diagonals, "45°"),
    ):
        for wall in ("outer", "inner"):
            spans = [
                _inches(reading.trough_to_peak)
                for reading in inspection.readings
                if mark in reading.place and reading.wall == wall
            ]
            if spans:
                lines.append(Line(f"{name}, {wall} wall", thesis or NOT_SAID, " ".join(spans)))
    return lines


def _inches(thousandths: float) -> str:
    return f"{thousandths / 1000:.4f}".removeprefix("0")
