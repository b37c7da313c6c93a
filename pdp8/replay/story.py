"""The story of an afternoon for somebody who has never seen one: a name and a sentence for each act.

The figures are the afternoon's own. That all of it was done in one afternoon is our arrangement: the opening
says so. The last sets what the thesis measured beside ours, and says why ours is larger.
"""

from typing import Final, NamedTuple

from pdp8.replay.afternoon import Afternoon
from tapes.quantities import inches

_MADE: Final = {
    "circle": "a circle",
    "ellipse": "an ellipse",
    "polynomial": "a cubic curve",
    "slope": "a slope",
    "die": "a die",
    "drill": "four holes",
    "fluidic": "a fluidic element",
}
_MEASURED: Final = {"circle": ".009"}
"""The largest trough to peak that the thesis measured, inches."""

_WORDS: Final = {2: "two", 17: "seventeen"}
"""Numbers of the story that are words; others are figures."""


class Chapter(NamedTuple):
    """The name of a part of the story, and its sentences."""

    name: str
    words: str


def story(afternoon: Afternoon) -> list[Chapter]:
    """Return the opening, and a chapter for each act."""
    made = _MADE.get(afternoon.part, "a part")
    opening = (
        f"McMaster University, 1971: for his thesis, Moses Wong cuts {made} in metal by computer. "
        "That it was one afternoon is our arrangement."
    )
    return [
        Chapter("", opening),
        Chapter("Print", _print(afternoon, made)),
        Chapter("Toggle", _toggle(afternoon)),
        Chapter("Boot", "Those words read in a better loader, one row of holes at a time."),
        Chapter("Load", "That loader reads the translator, and halts. Accumulator dark: its sum is right."),
        Chapter(
            "Translate", "One tape goes in, another comes out: the same numbers, in the mill’s own code."
        ),
        Chapter("Cut", _cut(afternoon)),
        Chapter("Measure", _measure(afternoon)),
    ]


def _print(afternoon: Afternoon, made: str) -> str:
    lines = afternoon.text.count("\n")
    return f"FORTRAN has worked out {made} in {_number(lines)} lines. The Teletype types and punches them."


def _toggle(afternoon: Afternoon) -> str:
    words = sum(action.key == "dep" for action in afternoon.actions)
    taught = f"{_number(words).capitalize()} words, set by hand, teach it to read a tape."
    return f"The computer’s memory is empty. {taught}"


def _cut(afternoon: Afternoon) -> str:
    path = afternoon.path
    reads = f"The mill reads for {_number(round(path.read_seconds))} seconds"
    if not path.milling_blocks:
        return f"{reads}, drills a hole, and reads again."
    return f"{reads}, cuts one short straight line, and reads again: {path.milling_blocks:,} times."


def _measure(afternoon: Afternoon) -> str:
    if afternoon.inspection is None:
        path = afternoon.path
        minutes = path.times.total / 60
        return f"{len(path.holes)} holes in {minutes:.1f} minutes at the mill. No wall was measured."
    worst = afternoon.inspection.worst
    if afternoon.part in _MEASURED:
        off = f"At worst {inches(worst.trough_to_peak)} inch, trough to peak, {worst.wall} wall"
        return f"{off}, where the contour is left open. The thesis measured {_MEASURED[afternoon.part]}."
    off = f"at worst {inches(worst.trough_to_peak)} inch from trough to peak"
    return f"Up close the curve is a staircase: {off}, on the {worst.wall} wall."


def _number(count: int) -> str:
    return _WORDS.get(count, f"{count:,}")
