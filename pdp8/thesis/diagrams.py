"""Figure 8.1, the element; and the figures drawn by hand, in drawn/, of which nothing is computed.

These are 2.1, 6.2, 7.4 and 9.1 (machine, construction, die, test) and the flow charts 3.5, 4.1, 5.2 (from the
text), 5.3 and 6.1 (from the programs of Appendices B and C). The scan has lost them all. Each part that is
drawn has its name or its dimension in the text; places and sizes are ours.
"""

from collections.abc import Iterator
from math import cos, radians, sin

from nc.drawing import INK, Sheet, View, around, polyline
from pdp8.thesis.table import text_of
from programs import fluidic

_CAVITY = "#e3ebf5"


def drawn(figure: str) -> str:
    """Return a figure that was drawn by hand."""
    return text_of(f"drawn/figure-{figure}.svg")


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
    """Figure 8.1: the element ten times full size, the cutter's path stroked as wide as the cutter."""
    main = [place for segment in fluidic.outline() for place in _points(segment)]
    right = [place for segment in fluidic.channel(0) for place in _points(segment)]
    paths = main, right, [(-x, y) for x, y in right]
    window = around([place for path in paths for place in path]).grown(500)
    scale = 0.7
    sheet = Sheet(window.width * scale / 10 + 100, window.height * scale / 10 + 70, "The bistable element")
    view = View(sheet, 70, 16, window, (scale, scale))
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
