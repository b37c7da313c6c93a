"""All that a tape made the machine of 1971 do, as RS-274; Z 0 is the quill's top, high above the work.

    N7 G1 Z-3.5000 F1.0
    N7 G1 Y4.1330 F1.0 (007 6 02250 04133 0 01 85)

One linear move for each move of the machine, so the path is the same on a controller that interpolates: where
the Hydra-Point's axes move at unequal feeds, each corner is written out, and G61 (exact path) prevents the
controller from rounding it. The quill's depth becomes a negative Z with zero at the top, where it goes first.
Program stop, end of program and manual tool change are M0, as they wait for START; a manual tool change stops
the spindle too. A tape that ends in the work, as the thesis's do, leaves the cutter there until its block 001
is run again; here Z goes to the top first. M2 ends the program. The feeds are those the path was cut with.
RS-274's M6 stops the spindle, so M3 follows it; RS-274 can have both coolants on, so M9 comes between them.
A tap comes out of its hole with the spindle reversed, M4, as in a floating holder; at the Z feed of the tape
it would break, so it is fed by its pitch or refused.

Source: RS-274/NGC (T. Kramer, F. Proctor, E. Messina, NIST, 2000), the common part of every dialect.
"""

from collections.abc import Iterator

from nc.gcode import REVERSING, check_taps, is_tap, speed_of
from nc.listing import spaced
from nc.path import Modes, Move, MoveKind, Path, Step
from nc.unit import INCH, Unit
from tapes.hydrapoint import Miscellaneous

_RAPID = frozenset({MoveKind.POSITION, MoveKind.APPROACH, MoveKind.RETRACT})
_COOLANT = {"mist": "M7", "flood": "M8", "off": "M9"}


def gcode_1971(path: Path, pitch: float = 0, unit: Unit = INCH) -> Iterator[str]:
    """Yield the lines; `pitch` of taps is in thousandths. Raises WorkError if the tape taps and it is 0."""
    check_taps(path, pitch)
    yield "(Moog Hydra-Point 83-1000 MC, 20-row block tape)"
    if path.moves and not any(step.modes.spindle for step in path.steps):
        yield "(the tape starts no spindle)"
    yield f"{unit.word} G90 G17 G94 G40 G80 G61"
    yield "G0 Z0.0000 (the quill is up)"
    before = Modes()
    for step in path.steps:
        yield from _numbered(step, [*_changes(before, step), *_moves(step, pitch, unit), *_stops(step)])
        before = step.modes
    if path.steps[-1].at.z:
        yield "G0 Z0.0000 (the tape ends here)"
    yield from ("M5", "M9", "M2")


def _numbered(step: Step, lines: list[str]) -> Iterator[str]:
    """Give each line its block's number, within RS-274's five digits, and the block's digits as a comment."""
    number = f"N{step.number} " if step.number <= 99_999 else ""
    *first, last = lines or [""]
    for line in first:
        yield f"{number}{line}"
    yield f"{number}{last} ({spaced(step.block)})".replace("  ", " ")


def _changes(before: Modes, step: Step) -> Iterator[str]:
    modes = step.modes
    if modes.spindle != before.spindle:
        yield f"S{modes.spindle} M3"
    if modes.coolant != before.coolant:
        if "off" not in (modes.coolant, before.coolant):
            yield _COOLANT["off"]
        yield _COOLANT[modes.coolant]


def _moves(step: Step, pitch: float, unit: Unit) -> Iterator[str]:
    for move in step.moves:
        backs_out = move.kind == MoveKind.FEED_OUT and is_tap(step)
        if backs_out:
            yield from ["M4", *REVERSING]
        feed = round(unit.of(1000 * speed_of(step, move, pitch)), 4)
        words = _words(move, unit)
        yield f"G0 {words}" if move.kind in _RAPID else f"G1 {words} F{feed}"
        if backs_out:
            yield from ["M3", *REVERSING]


def _words(move: Move, unit: Unit) -> str:
    """The words of the axes that move; a position has both X and Y, as a controller may start anywhere."""
    whole = "XY" if move.kind == MoveKind.POSITION else ""
    return " ".join(
        f"{axis}{unit.said(sign * to, 4)}"
        for axis, sign, was, to in zip("XYZ", (1, 1, -1), move.start, move.end, strict=True)
        if was != to or axis in whole
    )


def _stops(step: Step) -> Iterator[str]:
    turning = ["M3"] if step.modes.spindle else []
    if step.tool_changed:
        yield from [f"T{step.modes.tool} M6", *turning]
    elif step.block.miscellaneous == Miscellaneous.MANUAL_TOOL_CHANGE:
        yield from ["M5", f"M0 (tool {step.block.tool:02} by hand)", *turning]
    elif step.stop or step.block.miscellaneous == Miscellaneous.INDEX:
        yield "M0"
