"""A tape of 1971 as a program for today's mill: RS-274, safe without a change.

    G0 X2.2500 Y4.0000 (N7)      in X and Y, rapids go at the safe height
    G0 Z0.0500 (N7)              in Z, down to just above the stock
    G1 Z-0.5000 F1.0 (N7)        all else is fed: a linear move for each move of the machine
    G1 Y4.1330 (N7)

Z 0 is the top of the stock, for which the tape's Z feed point is taken, the highest of several. The header
says what an operator has to know, and what is left out: positions where nothing is cut, such as the parking,
stops before the first cut and after the last, the tool, coolant. A stop or another tool between two cuts is
M0, with the cutter lifted and still. A peck withdraws to the safe height and is fed in again.

No tape says the pitch of a tap, and its Z feed fits none, so a tap is refused unless its pitch is given. It
needs a floating holder: fed in at speed x pitch, the spindle reversed (M4) and given a second to turn, fed
out as fast to above the stock, the spindle reversed again. Controllers without G84 have these words too.

Sources: README of grbl 1.1, for its words; RS-274/NGC (T. Kramer, F. Proctor, E. Messina, NIST, 2000);
LinuxCNC's description of G84, for the order of a tap with a floating holder.
"""

from collections.abc import Iterator
from functools import cache
from textwrap import wrap
from typing import NamedTuple

from nc.path import Move, MoveKind, Path, Step
from nc.unit import INCH, Unit
from tapes.errors import WorkError
from tapes.hydrapoint import COOLANT, MISCELLANEOUS, Miscellaneous, Preparatory
from tapes.quantities import counted

_FED = frozenset({MoveKind.FEED_IN, MoveKind.FEED_OUT, MoveKind.MILL})
_TAPS = frozenset({Preparatory.TAP_FEED, Preparatory.TAP_PITCH})
_COOLANT = {"off": [], "mist": ["M7"], "flood": ["M8"]}
_ABOVE_STOCK = 50
REVERSING = ("G4 P1",)
"""A second for the spindle to turn the other way."""


class Output(NamedTuple):
    """How the program is written; lengths in thousandths of an inch.

    `cutter` is its diameter, for the header; `safe` the height of rapids above the stock; `shift` is added to
    X and Y; `pitch` is that of taps, 0 if it is not known. With `tool_change` tools and coolant are written,
    for a controller that has them.
    """

    cutter: float = 500
    safe: float = 250
    shift: tuple[float, float] = (0, 0)
    tool_change: bool = False
    pitch: float = 0
    unit: Unit = INCH


def gcode(path: Path, output: Output = Output()) -> Iterator[str]:  # noqa: B008  # it is frozen
    """Yield the lines. Raises WorkError if nothing is cut, the spindle is off, or a tap has no pitch."""
    cutting = [*filter(_cuts, path.steps)]
    if not cutting:
        raise WorkError("no block of this tape cuts: there is nothing for a mill to do")
    if not cutting[0].modes.spindle:
        raise WorkError(
            f"block {cutting[0].number} cuts with the spindle at rest: a block before it has to set "
            "the spindle speed (miscellaneous function 88)"
        )
    check_taps(path, output.pitch)
    points = sorted({step.modes.feed_point or 0 for step in cutting})
    program = _Program(points[0], output)
    program.left_out += _positions(path, output.unit)
    for step in path.steps:
        program.carry_out(step)
    program.end()
    for words in _header(path, program, points):
        yield from (f"({line})" for line in wrap(words, 90))
    yield f"G17 {output.unit.word} G40 G49 G54 G61 G80 G90 G94"
    yield from program.lines


def check_taps(path: Path, pitch: float) -> None:
    """Raise WorkError if the tape taps and the pitch is not known, or if it is known and no block taps."""
    taps = [*filter(is_tap, path.steps)]
    if pitch and not taps:
        raise WorkError("no block of this tape taps: leave out --tap")
    for tap in taps:
        feed, speed = tap.modes.z_feed or 0, tap.modes.spindle
        if not speed:
            raise WorkError(f"block {tap.number} taps with the spindle at rest")
        if not pitch:
            raise WorkError(
                f"block {tap.number} taps, preparatory function {tap.block.preparatory}, at {feed:g} in/min "
                f"and {speed} rpm, {feed / speed:.4f} in a turn: the tape does not say the pitch of the tap, "
                "and a tap fed at another breaks. With a floating tap holder give it: --tap 0.05 for 20 "
                "threads to the inch"
            )


def speed_of(step: Step, move: Move, pitch: float) -> float:
    """Return the speed of a block's move, inches a minute: of a tap by its pitch, in thousandths."""
    return (step.modes.spindle or 0) * pitch / 1000 if is_tap(step) else move.speed


def is_tap(step: Step) -> bool:
    """Whether a block taps."""
    return step.block.preparatory in _TAPS


def _header(path: Path, program: "_Program", points: list[int]) -> Iterator[str]:
    output, unit = program.output, program.output.unit
    (left, near, deepest), (right, far, _) = program.low, program.high
    feeds, speeds = (" to ".join(f"{to:g}" for to in sorted({min(of), max(of)})) for of in program.rates)
    minutes = (path.times.milling + path.times.z_feed) / 60
    across = output.cutter

    def word(thousandths: float) -> str:
        return unit.said(thousandths, 4)

    blocks = counted(len(path), "blocks")
    yield f"Moog Hydra-Point tape of 1971, {blocks}, about {minutes:.0f} min of cutting"
    yield f"X {word(left)} to {word(right)}, Y {word(near)} to {word(far)}: the path of the cutter's centre"
    yield f"cutter {word(across)} across, which no tape says: its edge goes {word(across / 2)} further"
    others = "".join(f", others {word(points[0] - point)}" for point in points[1:])
    yield f"Z 0 is the stock's top, set it with the cutter on it: feed point {word(points[0])}{others}"
    yield f"depth {word(-deepest)}, safe Z {word(output.safe)}, work offset G54"
    yield f"spindle {speeds} rpm, feeds {feeds} {unit.name}/min"
    if output.pitch:
        tap = f"floating tap holder, pitch {word(output.pitch)}, fed at speed x pitch"
        yield f"tapping: {tap}; leave feed and speed override at 100 per cent"
    yield from (f"left out: {what}" for what in program.left_out)


def _positions(path: Path, unit: Unit) -> list[str]:
    """Return the places at which the table stops and the next cut does not begin."""
    passed, following = [], None
    for step in reversed(path.steps):
        if _cuts(step):
            following = next(move.start[:2] for move in step.moves if move.kind in _FED)
        elif step.moves and step.at[:2] != following:
            x, y = unit.said(step.at.x, 4), unit.said(step.at.y, 4)
            passed.append(f"position X {x} Y {y} of block {step.number}")
    return passed[::-1]


class _Program:
    """The program so far: where it leaves the mill, how far it reaches, its feed and speed (`rates`)."""

    def __init__(self, top: int, output: Output) -> None:
        self.top, self.output = top, output
        self.lines: list[str] = []
        self.left_out: list[str] = []
        self.low, self.high = [1e9, 1e9, 1e9], [-1e9, -1e9, -1e9]
        self.rates: tuple[list[float], list[float]] = [], []
        self._at: list[str] = ["", "", ""]
        self._word = cache(lambda place: output.unit.said(place, 4))
        self._coolant = "off"
        self._turning = 0
        self._waiting: list[tuple[str, str]] = []
        self._go("G0", z=output.safe)

    def carry_out(self, step: Step) -> None:
        """Write the cuts of a block. A stop in it is written before the next cut, if one follows."""
        for move in step.moves:
            if move.kind in _FED:
                self._cut(step, move, f" (N{step.number})")
            elif move.kind == MoveKind.RETRACT:
                self._go("G0", z=self.output.safe)
        function, changes = step.block.miscellaneous, self.output.tool_change
        of_block = f"of block {step.number}"
        if function in COOLANT and step.modes.coolant != "off" and not changes:
            self.left_out.append(f"{step.modes.coolant} coolant {of_block}")
        if step.tool_changed or (function == Miscellaneous.MANUAL_TOOL_CHANGE and step.block.tool):
            what = f"tool {step.modes.tool:02} {of_block}"
            change = f"T{step.modes.tool} M6", what
            self._waiting.append(change if changes else ("M0", f"{what}, set Z 0 with it"))
        elif step.stop or function == Miscellaneous.INDEX:
            self._waiting.append(("M0", f"{MISCELLANEOUS[function]} {of_block}"))

    def end(self) -> None:
        """Lift the cutter, stop the spindle, and end."""
        self._go("G0", z=self.output.safe)
        self.left_out += [what for _, what in self._waiting]
        self.lines += ["M5", *(["M9"] if self._coolant != "off" else []), "M30"]

    def _cut(self, step: Step, move: Move, note: str) -> None:
        safe, (across, up) = self.output.safe, self.output.shift
        (x, y, z), (end_x, end_y, end_z) = move.start, move.end
        x, y, end_x, end_y = x + across, y + up, end_x + across, end_y + up
        if self._waiting:
            self._stop()
        if step.modes.spindle != self._turning or step.modes.coolant != self._coolant:
            self._turn(step)
        if self._at[2] == self._word(safe) or self._at[:2] != [self._word(x), self._word(y)]:
            self._go("G0", z=safe)
            self._go("G0", note, x=x, y=y)
            self._go("G0", note, z=min(safe, _ABOVE_STOCK))
        if move.kind == MoveKind.MILL:
            self._go("G1", note, step.modes.z_feed, z=self.top - z)
        speed, end_z = speed_of(step, move, self.output.pitch), self.top - end_z
        if is_tap(step) and move.kind == MoveKind.FEED_OUT:
            self.lines += [f"M4 S{self._turning}", *REVERSING]
            self._go("G1", note, speed, z=_ABOVE_STOCK)
            self.lines += [f"M3 S{self._turning}", *REVERSING]
        else:
            self._go("G1", note, speed, end_x, end_y, end_z)

    def _stop(self) -> None:
        """Write the stops since the last cut; where the mill is after a stop is not known."""
        for code, what in self._waiting:
            if code == "M0" and not self.rates[0]:
                self.left_out.append(what)
                continue
            self._go("G0", z=self.output.safe)
            self.lines += [*(["M5"] if self._turning else []), f"{code} ({what})"]
            self.lines += ["G43"] if code != "M0" else []
            self._at = ["", "", ""]
            self._turning = 0
            self._go("G0", z=self.output.safe)
        self._waiting.clear()

    def _turn(self, step: Step) -> None:
        speed, coolant = step.modes.spindle or 0, step.modes.coolant if self.output.tool_change else "off"
        if speed != self._turning:
            self.lines += [f"M3 S{speed}", "G4 P3"]
            self.rates[1].append(speed)
        if coolant != self._coolant:
            self.lines += [*(["M9"] if self._coolant != "off" else []), *_COOLANT[coolant]]
        self._turning, self._coolant = speed, coolant

    def _go(
        self,
        code: str,
        note: str = "",
        feed: float | None = None,
        x: float | None = None,
        y: float | None = None,
        z: float | None = None,
    ) -> None:
        """Write a straight move along the axes that change, with its feed where that changes."""
        line = code
        for axis, place in enumerate((x, y, z)):
            if place is not None and (word := self._word(place)) != self._at[axis]:
                self._at[axis] = word
                line += f" {'XYZ'[axis]}{word}"
                self.low[axis], self.high[axis] = min(self.low[axis], place), max(self.high[axis], place)
        if line == code:
            return
        if feed is not None:
            rate = round(self.output.unit.of(1000 * feed), 4)
            if self.rates[0][-1:] != [rate]:
                self.rates[0].append(rate)
                line += f" F{rate}"
        self.lines.append(line + note)


def _cuts(step: Step) -> bool:
    return any(move.kind in _FED for move in step.moves)
