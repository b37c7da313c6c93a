"""The flow charts of the thesis, redrawn: Figures 3.5, 5.2, 5.3 and 6.1, and the block diagram 4.1.

The scan has lost all five. 3.5 is drawn from Chapter 3's description, 5.2 from Chapter 5's of Program 2, 5.3
from Chapter 5's and the program of Appendix B, 6.1 from the listing of Appendix C, 4.1 from Chapter 4.
"""

from itertools import pairwise
from typing import Final

from pdp8.thesis.flow import DATA, DECISION, PROCESS, TERMINAL, Arrow, Chart, Node, draw
from tapes import eia

STEPWISE = Chart(
    {
        "start": Node(TERMINAL, "START", 0, 0),
        "define": Node(PROCESS, "Define curve, upper limit,\nlower limit; X, Y = A", 0, 1),
        "y": Node(PROCESS, "Y = Y + .001 in", 0, 2),
        "upper": Node(DECISION, "X, Y on the\nupper limit?", 0, 3),
        "print y": Node(DATA, "Print X, Y:\nmill along Y", 0, 4),
        "x": Node(PROCESS, "X = X + .001 in", 0, 5),
        "lower": Node(DECISION, "X, Y on the\nlower limit?", 0, 6),
        "print x": Node(DATA, "Print X, Y:\nmill along X", 0, 7),
        "end": Node(DECISION, "B reached?", 0, 8),
        "stop": Node(TERMINAL, "STOP", 0, 9),
    },
    (
        Arrow("start", "define"),
        Arrow("define", "y"),
        Arrow("y", "upper"),
        Arrow("upper", "y", "NO", out="W", into="W"),
        Arrow("upper", "print y", "YES"),
        Arrow("print y", "x"),
        Arrow("x", "lower"),
        Arrow("lower", "x", "NO", out="W", into="W"),
        Arrow("lower", "print x", "YES"),
        Arrow("print x", "end"),
        Arrow("end", "y", "NO", out="E", into="E"),
        Arrow("end", "stop", "YES"),
    ),
)

COMPUTER = Chart(
    {
        "storage": Node(PROCESS, "STORAGE\nmemory core,\n4096 words of 12 bits", 1, 0),
        "input": Node(PROCESS, "INPUT\nkeyboard,\ntape reader", 0, 1),
        "control": Node(PROCESS, "CONTROL\ninterprets and executes", 1, 1),
        "output": Node(PROCESS, "OUTPUT\nteleprinter,\ntape punch", 2, 1),
        "arithmetic": Node(PROCESS, "ARITHMETIC\nthe accumulator", 1, 2),
    },
    (
        Arrow("input", "control", out="E", into="W"),
        Arrow("control", "output", out="E", into="W"),
        Arrow("storage", "control", both=True),
        Arrow("control", "arithmetic", both=True),
    ),
    gap=70,
)


_KNOWN = (*"0123456789", " ", "\n")
_FIRST_ROW = 3


def _conversion(unknown: Arrow) -> Chart:
    """Return Program 2 or 3: a column of comparisons, each with its new code; `unknown` ends the column."""
    nodes = {
        "start": Node(TERMINAL, "START", 0, 0),
        "accept": Node(DATA, "Accept a character\nfrom keyboard or tape", 0, 1),
        "mask": Node(PROCESS, "Mask: AND with 177", 0, 2),
        "reduce": Node(PROCESS, "Reduce: add -60", 0, 3),
        "punch": Node(DATA, "Punch it", 2, _FIRST_ROW + len(_KNOWN)),
    }
    arrows = [Arrow("start", "accept"), Arrow("accept", "mask"), Arrow("mask", "reduce")]
    for row, character in enumerate(_KNOWN, _FIRST_ROW):
        name = {" ": "SPACE", "\n": "CARRIAGE RETURN"}.get(character, character)
        code = eia.CODES["0" if character == " " else character]
        nodes[f"is {character!r}"] = Node(DECISION, _question(character), 1, row)
        nodes[f"code {character!r}"] = Node(PROCESS, f"{name}: new code {code:03o}", 2, row)
        arrows += [
            Arrow(f"is {character!r}", f"code {character!r}", "YES", out="E", into="W"),
            Arrow(f"code {character!r}", "punch", out="E", into="E"),
        ]
    arrows += [Arrow(f"is {one!r}", f"is {other!r}", "NO") for one, other in pairwise(_KNOWN)]
    arrows += [
        Arrow("reduce", "is '0'", out="E", into="W"),
        Arrow("punch", "accept", out="S", into="W", lane=2),
        unknown,
    ]
    return Chart(nodes, tuple(arrows), gap=64)


def _question(character: str) -> str:
    """Return what tells the character, masked and reduced: the constant, octal, that makes it zero."""
    reduced = (0o15 if character == "\n" else ord(character)) - 0o60
    return f"add {-reduced:o}, zero?" if reduced else "zero?"


def _circle() -> Chart:
    """Return the listing of Appendix C, a column a quadrant."""
    nodes = {
        "start": Node(TERMINAL, "START", 0, 0),
        "header": Node(DATA, "Print the six\nheader blocks", 0, 1),
        "constants": Node(PROCESS, "AS=7, AP=6, AT=1,\nAX=1750, AY=0", 0, 2),
        "stop": Node(TERMINAL, "STOP", 3, 12),
    }
    arrows = [Arrow("start", "header"), Arrow("header", "constants"), Arrow("constants", "quadrant 0")]
    for quadrant in range(4):
        _quadrant(quadrant, nodes, arrows)
    return Chart(nodes, tuple(arrows), gap=100)


def _quadrant(quadrant: int, nodes: dict[str, Node], arrows: list[Arrow]) -> None:
    """Add one quadrant: out to the outer limit along one axis, in to the inner one along the other."""
    x_sign, y_sign = ("-+", "++", "+-", "--")[quadrant]
    out, inward = ("AY", "AX") if quadrant % 2 == 0 else ("AX", "AY")

    def named(what: str) -> str:
        return f"{what} {quadrant}"

    steps = (
        ("quadrant", PROCESS, f"Quadrant {quadrant + 1}: X = 4000{x_sign}AX,\nY = 4000{y_sign}AY"),
        ("out", PROCESS, f"{out} = {out}+1"),
        ("outer", DECISION, "R ≥ 1755?"),
        ("print out", DATA, f"Print: mill {out[1]}"),
        ("in", PROCESS, f"{inward} = {inward}-1"),
        ("axis", DECISION, f"{inward} ≤ 0?"),
        ("inner", DECISION, "R ≤ 1745?"),
        ("print in", DATA, f"Print: mill {inward[1]}"),
        ("end", DECISION, f"{out} ≥ RAD?"),
    )
    for row, (what, kind, text) in enumerate(steps, 3):
        nodes[named(what)] = Node(kind, text, quadrant, row)
    following = f"quadrant {quadrant + 1}" if quadrant < 3 else "stop"
    on = {"outer": "YES", "axis": "NO", "inner": "YES"}
    arrows += [Arrow(named(one[0]), named(other[0]), on.get(one[0], "")) for one, other in pairwise(steps)]
    arrows += [
        Arrow(named("outer"), named("out"), "NO", out="W", into="W"),
        Arrow(named("inner"), named("in"), "NO", out="W", into="W"),
        Arrow(named("end"), named("out"), "NO", out="W", into="W", lane=2),
    ]
    aside = Arrow(named("axis"), following, "YES", out="E", into="W", lane=3)
    if quadrant < 3:
        arrows += [aside, aside._replace(start=named("end"))]
    else:
        arrows += [aside._replace(into="E", lane=1), Arrow(named("end"), following, "YES")]


_CHARTS: Final = {
    "3.5": (STEPWISE, "Flow chart of the Step-wise Linear Technique"),
    "4.1": (COMPUTER, "Block diagram of the PDP-8/L"),
    "5.2": (
        _conversion(Arrow("is '\\n'", "punch", "NO", out="S", into="W")),
        "Flow chart of conversion program 2",
    ),
    "5.3": (
        _conversion(Arrow("is '\\n'", "accept", "NO", out="W", into="W")),
        "Flow chart of conversion program 3",
    ),
    "6.1": (_circle(), "Flow chart of the circle program"),
}
"""Program 2 lets unknown characters through, Program 3 ignores them."""


def chart(figure: str) -> str:
    """Figures 3.5, 4.1, 5.2, 5.3 and 6.1: flow charts, and the computer's units."""
    return draw(*_CHARTS[figure])
