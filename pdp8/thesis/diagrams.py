"""Figures 2.1, 6.2, 7.4, 8.1 and 9.1: machine, construction, die, element and test, as the text has them.

The scan has lost all five. Each part that is drawn has its name or its dimension in the text; where things
stand, and how large they are, is ours. drawn/ has the figures that nothing is computed for: 2.1 and 9.1, and
the flow charts 3.5, 4.1, 5.2 (from the text) and 5.3, 6.1 (from the programs of Appendices B and C).
"""

from collections.abc import Iterator
from importlib.resources import files
from math import atan, cos, degrees, radians, sin

from nc.drawing import FAINT, INK, Sheet, View, Window, around, polyline
from programs import fluidic
from programs.die import AXES, BLOCK

_BLUE, _RED, _CAVITY = "#0b4f9e", "#c62828", "#e3ebf5"


def drawn(figure: str) -> str:
    """Return a figure that was drawn by hand."""
    return (files("pdp8.thesis") / "drawn" / f"figure-{figure}.svg").read_text(encoding="utf-8")


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
        view.line([(x + reach * cos(angle), y + reach * sin(angle)) for reach in (-900, 900)], stroke=FAINT)
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
    x, y = view.at(0, BLOCK[1])
    size = {"width": BLOCK[0] * view.unit, "height": BLOCK[1] * view.unit}
    view.draw("rect", x=x, y=y, **size, fill="#dfe3e8", stroke=INK, stroke_width=1.4)
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
    size["height"] = BLOCK[2] * view.unit
    sheet.draw("rect", x=x, y=top, **size, fill="#dfe3e8", stroke=INK, stroke_width=1.2, rx=2)
    for side in (-1, 1):
        edge = x + (6000 + side * (a + _CUTTER / 2)) * view.unit
        sheet.draw("line", x1=edge, y1=top, x2=edge, y2=top + 100, stroke=INK, stroke_dasharray="6 4")
    sheet.text(x + 300, top + 54, "opening, through", text_anchor="middle")
    return sheet.svg()


_CUTTER = 500


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
    main = [place for segment in fluidic.outline() for place in _points(segment)]
    right = [place for segment in fluidic.channel(0) for place in _points(segment)]
    paths = main, right, [(-x, y) for x, y in right]
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
