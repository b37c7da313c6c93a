"""The program as a table: each block, what it does, and what is in force after it.

    block seq P       X       Y  TF MF  does
        7 007 6   2.250   4.133  01 85  quill to 3.500 at 1.0 in/min, mill Y to 4.133 at 1.0 in/min

P is the preparatory, TF the tool, MF the miscellaneous function. Lengths are inches.
"""

from collections.abc import Iterator
from itertools import pairwise

from nc.path import Move, MoveKind, Path, Position, Step
from tapes.hydrapoint import HOLE_MAKING, MISCELLANEOUS, PREPARATORY, Block, Miscellaneous, Preparatory

HEADING = "block seq P       X       Y  TF MF  does"
MODES_HEADING = "         Z  X feed  Y feed  Z feed   rpm tool coolant retract       time"


def lines(path: Path, modes: bool = False) -> Iterator[str]:
    """Yield the table line by line, without line ends; `modes` adds what is in force and the clock."""
    yield HEADING[: -len("does")] + MODES_HEADING + "  does" if modes else HEADING
    for step, now in zip(path.steps, path.clock(), strict=True):
        block = step.block
        columns = f"{step.number:5} {block.sequence:03} {block.preparatory} {block.x / 1000:7.3f}"
        columns += f" {block.y / 1000:7.3f}  {block.tool:02} {block.miscellaneous:02}  "
        yield f"{columns}{_modes(step, now)}  {does(step)}" if modes else f"{columns}{does(step)}"


def _modes(step: Step, now: float) -> str:
    modes = step.modes
    feeds = "".join(f"{_or_dash(feed, '.1f'):>8}" for feed in (modes.x_feed, modes.y_feed, modes.z_feed))
    minutes, seconds = divmod(round(now, 1), 60)
    return (
        f"{step.at.z / 1000:10.3f}{feeds}{_or_dash(modes.spindle, 'd'):>6}{_or_dash(modes.tool, '02d'):>5}"
        f" {modes.coolant:>7} {'partial' if modes.partial_retract else 'full':>7}"
        f" {minutes:5.0f}:{seconds:04.1f}"
    )


def _or_dash(value: float | None, form: str) -> str:
    return "-" if value is None else format(value, form)


def does(step: Step) -> str:
    """Describe what the block does."""
    return "; ".join(words for words in (_moves(step), _function(step)) if words)


def spaced(block: Block) -> str:
    """Return the 19 digits with spaces between their fields, as the thesis prints them."""
    return " ".join(block.digits[start:end] for start, end in pairwise((0, 3, 4, 9, 14, 15, 17, 19)))


def in_force(step: Step) -> str:
    """Describe the cutter's place after the block and what is in force."""
    modes = step.modes
    feeds = [("X", modes.x_feed), ("Y", modes.y_feed), ("Z", modes.z_feed)]
    fed = ", ".join(f"{axis} feed {feed:.1f}" for axis, feed in feeds if feed is not None)
    parts = (
        f"at {place(step.at)}, {quill(step.at)}",
        fed and f"{fed} in/min",
        modes.spindle and f"spindle {modes.spindle} rpm",
        modes.tool and f"tool {modes.tool:02}",
        f"coolant {modes.coolant}",
        modes.partial_retract and "partial retract",
    )
    return " · ".join(part for part in parts if part)


def place(at: Position | Block) -> str:
    """Return X and Y in inches."""
    return f"X {at.x / 1000:.3f} Y {at.y / 1000:.3f}"


def quill(at: Position) -> str:
    """Return how far the quill is down, inches."""
    return f"quill down {at.z / 1000:.3f}" if at.z else "quill up"


def _moves(step: Step) -> str:
    block, modes = step.block, step.modes
    if block.preparatory == Preparatory.READ_Z:
        return f"read Z: feed point {block.x / 1000:.3f}, final depth {block.y / 1000:.3f}"
    if block.preparatory == Preparatory.POSITION:
        return f"position to {place(block)}"
    if block.preparatory in HOLE_MAKING:
        depths = f"from {(modes.feed_point or 0) / 1000:.3f} to {modes.final_depth / 1000:.3f}"
        return f"{PREPARATORY[block.preparatory]} at {place(block)}, {depths} at {modes.z_feed:.1f} in/min"
    plunge = next((move for move in step.moves if move.kind is MoveKind.FEED_IN), None)
    mills = [_mill(move) for move in step.moves if move.kind is MoveKind.MILL] or ["mill, already there"]
    down = [f"quill to {plunge.end.z / 1000:.3f} at {plunge.speed:.1f} in/min"] if plunge else []
    return ", ".join(down + mills)


def _mill(move: Move) -> str:
    goes = [
        f"{axis} to {end / 1000:.3f}"
        for axis, start, end in (("X", move.start.x, move.end.x), ("Y", move.start.y, move.end.y))
        if start != end
    ]
    return f"mill {' '.join(goes)} at {move.speed:.1f} in/min"


def _function(step: Step) -> str:
    modes, name = step.modes, MISCELLANEOUS[step.block.miscellaneous]
    match step.block.miscellaneous:
        case Miscellaneous.NO_CHANGE:
            return ""
        case Miscellaneous.X_FEED | Miscellaneous.Y_FEED if step.block.preparatory == Preparatory.MILL:
            return ""
        case Miscellaneous.X_FEED:
            return f"X feed {modes.x_feed:.1f} in/min"
        case Miscellaneous.Y_FEED:
            return f"Y feed {modes.y_feed:.1f} in/min"
        case Miscellaneous.Z_FEED:
            return "" if step.block.preparatory in HOLE_MAKING else f"Z feed {modes.z_feed:.1f} in/min"
        case Miscellaneous.SPINDLE_SPEED:
            return f"spindle {modes.spindle} rpm"
        case Miscellaneous.TOOL_CHANGE:
            return f"{name}, tool {modes.tool:02}"
        case Miscellaneous.MANUAL_TOOL_CHANGE if step.block.tool:
            return f"{name}, tool {step.block.tool:02}, waits for START"
    return f"{name}, waits for START" if step.stop else name
