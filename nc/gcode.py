"""A tape of 1971 as a program for today's mill: RS-274, inches, safe as it stands.

    G0 X2.2500 Y4.0000 (N7)      in X and Y, rapids go at the safe height
    G0 Z0.0500 (N7)              in Z, down to just above the stock
    G1 Z-0.5000 F1.0 (N7)        all else is fed: a linear move for each move of the machine
    G1 Y4.1330 (N7)

Z 0 is the top of the stock, for which the tape's Z feed point is taken, the highest of several. The header
says what an operator has to know, and what is left out: positions where nothing is cut, such as the parking,
stops before the first cut and after the last, the tool, coolant. A stop or another tool between two cuts is
M0, with the cutter lifted and still. A peck withdraws to the safe height and is fed in again.

Sources: README of grbl 1.1, for its words; RS-274/NGC (T. Kramer, F. Proctor, E. Messina, NIST, 2000).
"""

from collections.abc import Iterator
from textwrap import wrap

from nc.path import Move, MoveKind, Path, Position, Step
from tapes.errors import WorkError
from tapes.hydrapoint import COOLANT, MISCELLANEOUS, Miscellaneous, Preparatory

_FED = frozenset({MoveKind.FEED_IN, MoveKind.FEED_OUT, MoveKind.MILL})
_TAPS = frozenset({Preparatory.TAP_FEED, Preparatory.TAP_PITCH})
_COOLANT = {"off": [], "mist": ["M7"], "flood": ["M8"]}
_ABOVE_STOCK = 50


def gcode(
    path: Path,
    *,
    cutter: float = 500,
    safe: float = 250,
    shift: tuple[float, float] = (0, 0),
    tool_change: bool = False,
) -> Iterator[str]:
    """Yield the program line by line, without line ends; lengths are thousandths of an inch.

    `cutter` is its diameter, for the header; `safe` is the height of rapids above the stock; `shift` is added
    to X and Y. With `tool_change` tools and coolant are written, for a controller that has them. Raises
    WorkError if the tape cuts nothing, or cuts before it starts the spindle.
    """
    cutting = [*filter(_cuts, path.steps)]
    if not cutting:
        raise WorkError("no block of this tape cuts: there is nothing for a mill to do")
    if not cutting[0].modes.spindle:
        raise WorkError(
            f"block {cutting[0].number} cuts with the spindle at rest: a block before it has to set "
            "the spindle speed (miscellaneous function 88)"
        )
    points = sorted({step.modes.feed_point or 0 for step in cutting})
    program = _Program(points[0], safe, shift, tool_change)
    program.left_out += _positions(path)
    for step in path.steps:
        program.carry_out(step)
    program.end()
    for words in _header(path, program, points, cutter):
        yield from (f"({line})" for line in wrap(words, 90))
    yield "G17 G20 G40 G49 G54 G61 G80 G90 G94"
    yield from program.lines


def _header(path: Path, program: "_Program", points: list[int], cutter: float) -> Iterator[str]:
    (left, right), (near, far), (deepest, _) = (
        (min(to), max(to)) for to in zip(*program.places, strict=True)
    )
    feeds, speeds = (" to ".join(f"{to:g}" for to in sorted({min(of), max(of)})) for of in program.rates)
    minutes = (path.times.milling + path.times.z_feed) / 60
    yield f"Moog Hydra-Point tape of 1971, {len(path)} blocks, about {minutes:.0f} min of cutting"
    yield f"X {left:.4f} to {right:.4f}, Y {near:.4f} to {far:.4f}: the path of the cutter's centre"
    yield f"cutter {_inches(cutter)} across, which no tape says: its edge goes {_inches(cutter / 2)} further"
    others = "".join(f", others {_inches(points[0] - point)}" for point in points[1:])
    yield f"Z 0 is the stock's top, set it with the cutter on it: feed point {_inches(points[0])}{others}"
    yield f"depth {-deepest:.4f}, safe Z {_inches(program.safe)}, work offset G54"
    yield f"spindle {speeds} rpm, feeds {feeds} in/min"
    yield from (f"left out: {what}" for what in program.left_out)


def _positions(path: Path) -> list[str]:
    """Return the places to which the table goes, and where the next cut does not begin."""
    passed, following = [], None
    for step in reversed(path.steps):
        if _cuts(step):
            following = next(move.start[:2] for move in step.moves if move.kind in _FED)
        elif step.moves and step.at[:2] != following:
            passed.append(f"position X {_inches(step.at.x)} Y {_inches(step.at.y)} of block {step.number}")
    return passed[::-1]


class _Program:
    """The program so far, and where it has left the mill; `rates` are its feeds and spindle speeds."""

    def __init__(self, top: int, safe: float, shift: tuple[float, float], tool_change: bool) -> None:
        self.top, self.safe, self.shift, self.tool_change = top, safe, shift, tool_change
        self.lines: list[str] = []
        self.left_out: list[str] = []
        self.places: list[tuple[float, ...]] = []
        self.rates: tuple[list[float], list[float]] = [], []
        self._at: dict[str, str] = {}
        self._coolant = "off"
        self._turning = 0
        self._waiting: list[tuple[str, str]] = []
        self._go("G0", Z=safe)

    def carry_out(self, step: Step) -> None:
        """Write what a block cuts; what it stops for waits until another cut follows."""
        for move in step.moves:
            if move.kind in _FED:
                self._cut(step, move, f" (N{step.number})")
            elif move.kind == MoveKind.RETRACT:
                self._go("G0", Z=self.safe)
        function, of_block = step.block.miscellaneous, f"of block {step.number}"
        if function in COOLANT and step.modes.coolant != "off" and not self.tool_change:
            self.left_out.append(f"{step.modes.coolant} coolant {of_block}")
        if step.tool_changed or (function == Miscellaneous.MANUAL_TOOL_CHANGE and step.block.tool):
            what = f"tool {step.modes.tool:02} {of_block}"
            change = f"T{step.modes.tool} M6", what
            self._waiting.append(change if self.tool_change else ("M0", f"{what}, set Z 0 with it"))
        elif step.stop or function == Miscellaneous.INDEX:
            self._waiting.append(("M0", f"{MISCELLANEOUS[function]} {of_block}"))

    def end(self) -> None:
        """Lift the cutter, stop the spindle, and end."""
        self._go("G0", Z=self.safe)
        self.left_out += [what for _, what in self._waiting]
        self.lines += ["M5", *(["M9"] if self._coolant != "off" else []), "M30"]

    def _cut(self, step: Step, move: Move, note: str) -> None:
        start, end = (
            Position(at.x + self.shift[0], at.y + self.shift[1], self.top - at.z)
            for at in (move.start, move.end)
        )
        self._stop()
        self._turn(step)
        if self._stands(Z=self.safe) or not self._stands(X=start.x, Y=start.y):
            self._go("G0", Z=self.safe)
            self._go("G0", note, X=start.x, Y=start.y)
            self._go("G0", note, Z=min(self.safe, _ABOVE_STOCK))
        if move.kind == MoveKind.MILL:
            self._go("G1", note, step.modes.z_feed, Z=start.z)
        backs_out = move.kind == MoveKind.FEED_OUT and step.block.preparatory in _TAPS
        self.lines += ["M4"] * backs_out
        self._go("G1", note, move.speed, X=end.x, Y=end.y, Z=end.z)
        self.lines += ["M3"] * backs_out

    def _stop(self) -> None:
        """Write what waits for this cut; afterwards the mill may be anywhere, at rest."""
        for code, what in self._waiting:
            if code == "M0" and not self.places:
                self.left_out.append(what)
                continue
            self._go("G0", Z=self.safe)
            self.lines += [*(["M5"] if self._turning else []), f"{code} ({what})"]
            self.lines += ["G43"] if code != "M0" else []
            self._at.clear()
            self._turning = 0
            self._go("G0", Z=self.safe)
        self._waiting.clear()

    def _turn(self, step: Step) -> None:
        speed, coolant = step.modes.spindle or 0, step.modes.coolant if self.tool_change else "off"
        if speed != self._turning:
            self.lines += [f"M3 S{speed}", "G4 P3"]
            self.rates[1].append(speed)
        if coolant != self._coolant:
            self.lines += [*(["M9"] if self._coolant != "off" else []), *_COOLANT[coolant]]
        self._turning, self._coolant = speed, coolant

    def _stands(self, **at: float) -> bool:
        return {axis: _inches(place) for axis, place in at.items()}.items() <= self._at.items()

    def _go(self, code: str, note: str = "", feed: float | None = None, **to: float) -> None:
        """Write a straight move along the axes that change, with its feed where that changes."""
        words = [f"{axis}{_inches(place)}" for axis, place in to.items() if not self._stands(**{axis: place})]
        if not words:
            return
        self._at |= {word[0]: word[1:] for word in words}
        if feed is not None and self.rates[0][-1:] != [round(feed, 4)]:
            self.rates[0].append(round(feed, 4))
            words.append(f"F{self.rates[0][-1]}")
        self.lines.append(f"{code} {' '.join(words)}{note}")
        if len(self._at) == len("XYZ"):
            self.places.append(tuple(float(self._at[axis]) for axis in "XYZ"))


def _cuts(step: Step) -> bool:
    return any(move.kind in _FED for move in step.moves)


def _inches(thousandths: float) -> str:
    return f"{round(thousandths / 1000, 4) + 0.0:.4f}"
