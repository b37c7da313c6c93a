"""The thesis's figures beside the afternoon's.

A thesis figure is quoted with its chapter; nothing here is adjusted to meet one.

Source: thesis (M. S. Wong, McMaster University, 1971), Chapters 7, 8 and 10, Table 10.1.
"""

from typing import TYPE_CHECKING, Final, NamedTuple

if TYPE_CHECKING:
    from pdp8.replay.afternoon import Afternoon

COLUMNS: Final = ("", "thesis", "replay")


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
    times, minutes = afternoon.path.times, afternoon.minutes
    lines = [
        Line("Blocks on the tape", said.blocks or "–", f"{len(afternoon.path)}"),
        Line("Minutes to punch in ASCII", said.punch or "–", f"{minutes['punch']:.1f}"),
        Line("Minutes to translate to EIA", said.translate or "–", f"{minutes['translate']:.1f}"),
        Line("Minutes to machine one pass", said.cut or "–", f"{minutes['cut']:.1f}"),
        Line("of which reading the tape", said.reading or "–", f"{times.reading / 60:.1f}"),
    ]
    return lines + _errors(afternoon, said)


def _errors(afternoon: "Afternoon", said: Thesis) -> list[Line]:
    """Return the lines of the walls' errors, trough to peak, of the outer wall and the inner."""
    inspection = afternoon.inspection
    if inspection is None:
        return []
    lines = []
    for name, thesis, mark in (
        ("Error at the apexes, in", said.apexes, "apex"),
        ("Error at 45°, in", said.diagonals, "45°"),
    ):
        for wall in ("outer", "inner"):
            spans = [
                _inches(reading.trough_to_peak)
                for reading in inspection.readings
                if mark in reading.place and reading.wall == wall
            ]
            if spans:
                lines.append(Line(f"{name}, {wall} wall", thesis or "–", " ".join(spans)))
    return lines


def _inches(thousandths: float) -> str:
    return f"{thousandths / 1000:.4f}".removeprefix("0")
