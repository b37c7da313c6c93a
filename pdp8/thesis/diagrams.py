"""Figures 2.1, 6.2, 7.4, 8.1 and 9.1: machine, construction, die, element and test, as the text has them.

The scan has lost all five. Each part that is drawn has its name or its dimension in the text; where things
stand, and how large they are, is ours.
"""

from collections.abc import Iterator
from math import atan, cos, degrees, radians, sin, sqrt

from nc.drawing import FAINT, INK, Sheet, View, Window, around, polyline
from programs import fluidic
from programs.die import AXES, BLOCK

_BLUE, _GREEN, _RED, _PAPER = "#0b4f9e", "#2e7d32", "#c62828", "#f4f4f2"
_CAVITY = "#e3ebf5"

_Places = list[tuple[float, float]]


def machining_centre() -> str:
    """Figure 2.1: the four units of the Hydra-Point Machining Centre."""
    sheet = Sheet(780, 500, "The Moog Hydra-Point Machining Centre")
    _console(sheet)
    _mill(sheet)
    _carousel(sheet)
    _power_supply(sheet)
    return sheet.svg()


def _box(sheet: Sheet, x: float, y: float, width: float, height: float, fill: str = "#ffffff") -> None:
    sheet.draw("rect", x=x, y=y, width=width, height=height, fill=fill, stroke=INK, stroke_width=1.2, rx=2)


def _named(sheet: Sheet, x: float, y: float, words: str, anchor: str = "middle") -> None:
    sheet.text(x, y, words, text_anchor=anchor, font_weight="bold")


def _note(sheet: Sheet, x: float, y: float, words: str, anchor: str = "start") -> None:
    sheet.text(x, y, words, text_anchor=anchor, font_size=10, fill="#444444")


def _console(sheet: Sheet) -> None:
    """The control console: panel, tape reader with its two reels in front, tape punch on the right side."""
    _box(sheet, 40, 110, 170, 320, _PAPER)
    _named(sheet, 125, 96, "CONTROL CONSOLE")
    _box(sheet, 55, 125, 140, 78)
    for column in range(5):
        sheet.draw("circle", cx=73 + 26 * column, cy=148, r=8, fill="none", stroke=INK)
        sheet.draw("circle", cx=73 + 26 * column, cy=184, r=4, fill="none", stroke=INK)
    _note(sheet, 125, 217, "manual dials, controls, indicators", "middle")
    for x in (84, 166):
        sheet.draw("circle", cx=x, cy=275, r=30, fill="#ffffff", stroke=INK)
        sheet.draw("circle", cx=x, cy=275, r=8, fill="none", stroke=INK)
    _box(sheet, 105, 314, 40, 20)
    sheet.draw("path", d="M58 290L104 322M146 322L192 290", fill="none", stroke=INK, stroke_width=2)
    _note(sheet, 125, 350, "tape reader: head and two reels", "middle")
    _box(sheet, 210, 250, 22, 70)
    sheet.draw("path", d="M221 320V336", stroke=INK)
    _note(sheet, 216, 350, "tape punch")
    _note(sheet, 125, 410, "pneumatic relays", "middle")


def _mill(sheet: Sheet) -> None:
    """The Bridgeport mill: head and spindle over table and saddle, which hydraulic cylinders move."""
    _named(sheet, 420, 40, "BRIDGEPORT MILLING MACHINE, MODEL HP")
    _box(sheet, 470, 120, 70, 310, _PAPER)
    _box(sheet, 350, 90, 190, 44, _PAPER)
    _box(sheet, 355, 62, 50, 28)
    _note(sheet, 414, 76, "spindle motor, 1.5 hp, 1730 rpm")
    _box(sheet, 358, 134, 44, 70)
    _box(sheet, 372, 204, 16, 26)
    sheet.draw("rect", x=377, y=230, width=6, height=22, fill=INK)
    _note(sheet, 352, 190, "spindle, Z: 5 in", "end")
    _box(sheet, 280, 262, 200, 20)
    _note(sheet, 284, 256, "table, X: 20 in")
    _box(sheet, 330, 282, 120, 22)
    _note(sheet, 326, 300, "saddle, Y: 10 in", "end")
    _box(sheet, 345, 304, 90, 90, _PAPER)
    _box(sheet, 300, 430, 270, 14, _PAPER)
    sheet.draw("path", d=polyline([(390, 394), (390, 430)]), stroke=INK, stroke_width=10)
    _note(sheet, 300, 460, "table and saddle are moved by hydraulic cylinders")


def _carousel(sheet: Sheet) -> None:
    """The automatic tool changer: 24 tools in a circle."""
    x, y = 672, 160
    _named(sheet, x, 62, "AUTOMATIC TOOL CHANGER")
    sheet.draw("circle", cx=x, cy=y, r=70, fill=_PAPER, stroke=INK, stroke_width=1.2)
    sheet.draw("circle", cx=x, cy=y, r=14, fill="#ffffff", stroke=INK)
    for tool in range(24):
        angle = radians(15 * tool - 90)
        sheet.draw(
            "circle", cx=x + 57 * cos(angle), cy=y + 57 * sin(angle), r=5.4, fill="#ffffff", stroke=INK
        )
    _note(sheet, x, 246, "carousel of 24 tools,", "middle")
    _note(sheet, x, 259, "random or sequential selection", "middle")


def _power_supply(sheet: Sheet) -> None:
    """The hydraulic power supply, with the pieces the text lists."""
    _named(sheet, 672, 306, "HYDRAULIC POWER SUPPLY")
    _box(sheet, 590, 318, 164, 112, _PAPER)
    listed = ("pump, double-ended motor,", "radiator, fan, reservoir,", "relief valve,")
    for row, words in enumerate(
        (*listed, "supply filter, 20 micron,", "bypass filter, 5 micron", "1500 psig")
    ):
        _note(sheet, 600, 336 + 16 * row, words)
    sheet.draw("path", d="M590 400H540", stroke=_RED, stroke_width=3)
    sheet.draw("path", d="M210 380H345", stroke=_BLUE, stroke_width=1.4, stroke_dasharray="6 4")
    _note(sheet, 236, 375, "air and oil valves")


_RADIUS = 700.0


def _curve(x: float) -> float:
    return 900 + 0.00028 * (x - 600) ** 2


def _angle(x: float) -> float:
    return atan(0.00056 * (x - 600))


def cutter_path() -> str:
    """Figure 6.2: the path g of a cutter's centre, at the distance C from the surface f along its normal."""
    window = Window(-300, 300, 3600, 3300)
    sheet = Sheet(560, 440, "Construction of the exact cutter path")
    view = sheet.view(70, 20, window, 1.2)
    surface = [(float(x), _curve(x)) for x in range(0, 3101, 20)]
    path = [(x - _RADIUS * sin(_angle(x)), y + _RADIUS * cos(_angle(x))) for x, y in surface]
    view.line(surface, stroke=INK, stroke_width=1.8)
    view.line([place for place in path if place[1] < 3300], stroke=_BLUE, stroke_dasharray="8 4")
    x1, y1 = 1900.0, _curve(1900)
    angle = _angle(x1)
    x2, y2 = x1 - _RADIUS * sin(angle), y1 + _RADIUS * cos(angle)
    view.circle(x2, y2, _RADIUS, stroke=_RED)
    for x, y in ((x1, y1), (x2, y2)):
        reach = 900
        ends = [(x + side * reach * cos(angle), y + side * reach * sin(angle)) for side in (-1, 1)]
        view.line(ends, stroke=FAINT)
        view.circle(x, y, 28, fill=INK)
    view.line([(x1, y1), (x2, y2)], stroke=_RED)
    view.line([(x1, y1), (x1, y2), (x2, y2)], stroke=FAINT, stroke_dasharray="3 3")
    view.line([(x1, y1), (x1 + 900, y1)], stroke=FAINT, stroke_dasharray="3 3")
    view.text(x1, y1, "x1, y1", dx=6, dy=18)
    view.text(x2, y2, "x2, y2", dx=-44, dy=-8)
    view.text((x1 + x2) / 2, (y1 + y2) / 2, "C", dx=-18, dy=8, font_weight="bold", fill=_RED)
    view.text(x1 + 480, y1 + 110, "θ", dy=2, font_style="italic")
    view.text(2560, _curve(2560), "y = f(x), the surface", dx=14, dy=10)
    view.text(-200, 1900, "y = g(x), the cutter's centre", fill=_BLUE)
    words = f"at x1 the tangent's slope is tan θ; here θ = {degrees(angle):.0f}°"
    view.text(-150, 420, words, fill="#444444", font_size=10)
    return sheet.svg()


def die() -> str:
    """Figure 7.4: the block with its opening, corner rounding and groove; from above and from the front."""
    window, left = Window(-400, -400, 12400, 8400), 70.0
    sheet = Sheet(left + window.width / 20 + 30, window.height / 20 + 190, "The die")
    view = sheet.view(left, 16, window, 0.5)
    _plate(view, (0, 0, *BLOCK[:2]), fill="#dfe3e8", stroke=INK, stroke_width=1.4)
    for cut, colour in (("groove", "#b9c4d2"), ("rounding", "#cdd5df")):
        a, b = AXES[cut]
        _ellipse(view, a, b, fill="none", stroke=colour, stroke_width=_CUTTER * view.unit)
    a, b = AXES["opening"]
    _ellipse(view, a + _CUTTER / 2, b + _CUTTER / 2, fill="#ffffff", stroke=INK, stroke_width=1.4)
    _ellipse(view, a, b, fill="none", stroke=_BLUE, stroke_dasharray="6 4")
    view.text(6000, 4400, "OPENING", text_anchor="middle", font_weight="bold")
    view.text(
        6000, 4000, f"cutter's path {2 * a / 1000:g} × {2 * b / 1000:g} in", text_anchor="middle", fill=_BLUE
    )
    hole = " × ".join(f"{(2 * axis + _CUTTER) / 1000:g}" for axis in (a, b))
    view.text(6000, 3600, f"hole {hole} in", text_anchor="middle")
    view.text(6000, 6600, "GROOVE", text_anchor="middle", font_size=10)
    view.text(9600, 5700, "ROUNDING", font_size=10)
    view.line([(9560, 5750), (8250, 5150)], stroke=INK)
    view.text(250, 7650, "BLOCK 12 × 8 × 2 in", font_weight="bold")
    top = 16 + view.height + 62
    sheet.text(left, top - 8, "from the front", fill=FAINT)
    x = left + 400 * view.unit
    _box(sheet, x, top, BLOCK[0] * view.unit, BLOCK[2] * view.unit, "#dfe3e8")
    for side in (-1, 1):
        edge = x + (6000 + side * (a + _CUTTER / 2)) * view.unit
        sheet.draw("line", x1=edge, y1=top, x2=edge, y2=top + 100, stroke=INK, stroke_dasharray="6 4")
    sheet.text(x + 300, top + 54, "opening, through", text_anchor="middle")
    return sheet.svg()


_CUTTER = 500


def _plate(view: View, corners: tuple[float, float, float, float], **style: object) -> None:
    (x, y), (right, bottom) = view.at(corners[0], corners[3]), view.at(corners[2], corners[1])
    view.draw("rect", x=x, y=y, width=right - x, height=bottom - y, **style)


def _ellipse(view: View, a: float, b: float, **style: object) -> None:
    """Draw an ellipse of these semi-axes about the middle of the block."""
    cx, cy = view.at(6000, 4000)
    view.draw("ellipse", cx=cx, cy=cy, rx=a * view.unit, ry=b * view.unit, **style)


_SLOT = 125
_FEATURES = (
    (0, 500, "POWER"),
    (0, 300, "CHANNEL"),
    (0, 7300, "SPLITTER"),
    *((side * 3900, 6600, "VENT") for side in (-1, 1)),
    *((side * 3900, v, word) for side in (-1, 1) for v, word in ((2480, "CONTROL"), (2280, "CHANNEL"))),
    *((side * 2000, v, word) for side in (-1, 1) for v, word in ((8900, "OUTPUT"), (8700, "CHANNEL"))),
)


def element() -> str:
    """Figure 8.1: the outline of the element, ten times full size.

    The outline lies half a cutter outside of the path of the cutter's centre: the path is stroked as wide as
    the cutter in ink, and again, a line narrower, in the colour of the cavity.
    """
    right = [place for segment in fluidic.channel(0) for place in _points(segment)]
    paths = (
        [place for segment in fluidic.outline() for place in _points(segment)],
        right,
        [(-x, y) for x, y in right],
    )
    window = around([place for path in paths for place in path]).grown(500)
    scale = 0.7
    sheet = Sheet(window.width * scale / 10 + 100, window.height * scale / 10 + 70, "The bistable element")
    view = sheet.view(70, 16, window, scale)
    for colour, line in ((INK, 1.4), (_CAVITY, 0.0)):
        for path in paths:
            wide = {"stroke_width": _SLOT * view.unit + line * 2, "stroke_linejoin": "round"}
            data = polyline(view.at(x, y) for x, y in path) + "Z"
            view.draw("path", d=data, fill=colour, stroke=colour, **wide)
    for u, v, words in _FEATURES:
        view.text(u, v, words, text_anchor="middle", font_size=10, font_weight="bold")
    view.line([(0, 2100), (900, 1500)], stroke=INK)
    view.text(900, 1500, "POWER NOZZLE, .20 wide: .020 of the element", dx=4, dy=4, font_size=10)
    return sheet.svg()


def _points(segment: "fluidic.Slope | fluidic.Bend") -> Iterator[tuple[float, float]]:
    """Yield places along a segment, in thousandths."""
    if isinstance(segment, fluidic.Slope):
        yield from ((1000 * u, 1000 * v) for u, v in (segment.start, segment.end))
        return
    (u, v), steps = segment.centre, 24
    for step in range(steps + 1):
        angle = radians(segment.start + segment.sweep * step / steps)
        yield 1000 * (u + segment.radius * cos(angle)), 1000 * (v + segment.radius * sin(angle))


def test_rig() -> str:
    """Figure 9.1: how power, switching and output were measured."""
    sheet = Sheet(620, 430, "Static test of the bistable element")
    _box(sheet, 230, 110, 160, 210, _PAPER)
    _named(sheet, 310, 215, "BISTABLE")
    _named(sheet, 310, 230, "ELEMENT")
    ports = (("P", 310, 320, 310, 352), ("C1", 230, 260, 190, 260), ("C2", 390, 260, 430, 260))
    outputs = (("O1", 270, 110, 270, 80), ("O2", 350, 110, 350, 80))
    for name, x1, y1, x2, y2 in (*ports, *outputs):
        sheet.draw("path", d=polyline([(x1, y1), (x2, y2)]), stroke=INK, stroke_width=2)
        sheet.label(max(x1, x2) + 6 if x1 == x2 else (x1 + x2) / 2 - 7, (y1 + y2) / 2 - 4, name)
    for x, y, words in (
        (270, 62, "output pressure"),
        (350, 62, "output pressure"),
        (172, 260, "control pressure"),
        (448, 260, "control pressure"),
        (380, 372, "supply pressure"),
    ):
        _gauge(sheet, x, y)
        anchor = "end" if x < 300 else "start"
        _note(sheet, x + (-22 if x < 300 else 22), y + 4, words, anchor)
    _box(sheet, 280, 352, 60, 40)
    _note(sheet, 310, 376, "Flowrator", "middle")
    sheet.draw("path", d="M340 372H362M310 392V416", stroke=INK, stroke_width=2, fill="none")
    _note(sheet, 318, 412, "air supply, increased by degrees")
    return sheet.svg()


def _gauge(sheet: Sheet, x: float, y: float) -> None:
    sheet.draw("circle", cx=x, cy=y, r=18, fill="#ffffff", stroke=INK, stroke_width=1.2)
    end = 11 / sqrt(2)
    sheet.draw("path", d=polyline([(x, y), (x + end, y - end)]), stroke=_GREEN, stroke_width=2)
