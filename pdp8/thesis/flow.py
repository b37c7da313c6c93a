"""A flow chart from its description: boxes on a grid of columns and rows, arrows with square corners.

    CHART = Chart(
        {"step": Node(PROCESS, "Y = Y + .001", 0, 0), "limit": Node(DECISION, "at the limit?", 0, 1)},
        (Arrow("step", "limit"), Arrow("limit", "step", "NO", out="W", into="W")),
    )

A column is as wide as its widest box, a row as high as its highest. An arrow leaves a box at a side (S, E, W)
and enters one at a side (N, E, W); where both are E, or both W, it goes by a lane beside the columns. Lengths
are hundredths of an inch of paper.
"""

from collections.abc import Mapping
from typing import Final, NamedTuple

from nc.drawing import INK, Sheet, polyline

TERMINAL, PROCESS, DATA, DECISION = "terminal", "process", "data", "decision"

_LINE, _LETTER, _MARGIN = 15.0, 6.1, 24.0
_ROW_GAP, _LANE, _HEAD = 26.0, 23.0, 8.0
_LEAST_WIDTH: Final = {TERMINAL: 70.0, PROCESS: 120.0, DATA: 110.0, DECISION: 0.0}
_FILL: Final = {TERMINAL: "#e8eef6", PROCESS: "#ffffff", DATA: "#f6efdc", DECISION: "#e9f3e9"}

_Place = tuple[float, float]


class Node(NamedTuple):
    """A box: what it is, its text in lines, and where on the grid it stands."""

    kind: str
    text: str
    column: float
    row: float


class Arrow(NamedTuple):
    """An arrow between two boxes; `both` has a head at either end, `lane` counts outward from the boxes."""

    start: str
    end: str
    label: str = ""
    out: str = "S"
    into: str = "N"
    lane: int = 1
    both: bool = False


class Chart(NamedTuple):
    """A flow chart; `gap` is between columns."""

    nodes: Mapping[str, Node]
    arrows: tuple[Arrow, ...]
    gap: float = 50.0


class _Box(NamedTuple):
    """A node laid out: its centre, and half its width and height."""

    node: Node
    x: float
    y: float
    a: float
    b: float

    def port(self, side: str) -> _Place:
        return {
            "N": (self.x, self.y - self.b),
            "S": (self.x, self.y + self.b),
            "E": (self.x + self.a, self.y),
            "W": (self.x - self.a, self.y),
        }[side]


def draw(chart: Chart, title: str) -> str:
    """Return the chart as SVG text."""
    boxes = _laid_out(chart)
    routes = [(arrow, _route(arrow, boxes)) for arrow in chart.arrows]
    corners = [place for _, route in routes for place in route]
    corners += [(box.x + side * box.a, box.y + box.b) for box in boxes.values() for side in (-1, 1)]
    across, down = [x for x, _ in corners], max(y for _, y in corners)
    shift = _MARGIN - min(across)
    sheet = Sheet(max(across) + shift + _MARGIN, down + _MARGIN, title)
    for arrow, route in routes:
        _draw_arrow(sheet, arrow, [(x + shift, y) for x, y in route])
    for box in boxes.values():
        _draw_box(sheet, box._replace(x=box.x + shift))
    return sheet.svg()


def _half_size(node: Node) -> tuple[float, float]:
    lines = node.text.splitlines()
    width = max(map(len, lines)) * _LETTER + 20
    height = len(lines) * _LINE + 14
    if node.kind == DECISION:
        return 0.84 * width, 0.92 * height
    return max(width, _LEAST_WIDTH[node.kind]) / 2 + (8 if node.kind == DATA else 0), height / 2


def _laid_out(chart: Chart) -> dict[str, _Box]:
    sizes = {name: _half_size(node) for name, node in chart.nodes.items()}
    widths: dict[float, float] = {}
    heights: dict[float, float] = {}
    for name, node in chart.nodes.items():
        widths[node.column] = max(widths.get(node.column, 0), 2 * sizes[name][0])
        heights[node.row] = max(heights.get(node.row, 0), 2 * sizes[name][1])
    x, y = _centres(widths, chart.gap), _centres(heights, _ROW_GAP)
    return {name: _Box(node, x[node.column], y[node.row], *sizes[name]) for name, node in chart.nodes.items()}


def _centres(sizes: Mapping[float, float], gap: float) -> dict[float, float]:
    centres, edge = {}, _MARGIN
    for place in sorted(sizes):
        centres[place] = edge + sizes[place] / 2
        edge += sizes[place] + gap
    return centres


def _route(arrow: Arrow, boxes: Mapping[str, _Box]) -> list[_Place]:
    """Return the corners of an arrow from port to port."""
    start, end = boxes[arrow.start], boxes[arrow.end]
    (x1, y1), (x2, y2) = start.port(arrow.out), end.port(arrow.into)
    sides = arrow.out + arrow.into
    if sides in ("EE", "WW"):
        x = _lane(arrow, boxes)
        return [(x1, y1), (x, y1), (x, y2), (x2, y2)]
    if x1 == x2 or y1 == y2:
        return [(x1, y1), (x2, y2)]
    if sides == "EW":
        x = x2 - _LANE * arrow.lane
        return [(x1, y1), (x, y1), (x, y2), (x2, y2)]
    if y2 < y1:
        x, y = _lane(arrow, boxes), y1 + _ROW_GAP
        return [(x1, y1), (x1, y), (x, y), (x, y2), (x2, y2)]
    return [(x1, y1), (x1, y2), (x2, y2)]


def _lane(arrow: Arrow, boxes: Mapping[str, _Box]) -> float:
    """Return where beside all boxes of the rows it passes the arrow goes round."""
    start, end = boxes[arrow.start], boxes[arrow.end]
    low, high = sorted((start.y, end.y))
    left, right = sorted((start.node.column, end.node.column))
    passed = [box for box in boxes.values() if low <= box.y <= high and left <= box.node.column <= right]
    if arrow.out == "E":
        return max(box.x + box.a for box in passed) + _LANE * arrow.lane
    return min(box.x - box.a for box in passed) - _LANE * arrow.lane


def _draw_arrow(sheet: Sheet, arrow: Arrow, route: list[_Place]) -> None:
    sheet.draw("path", d=polyline(route), fill="none", stroke=INK, stroke_width=1.1)
    _head(sheet, route[-2], route[-1])
    if arrow.both:
        _head(sheet, route[1], route[0])
    if arrow.label:
        x, y = route[0]
        dx, dy, anchor = {"S": (5, 13, "start"), "E": (4, -5, "start"), "W": (-4, -5, "end")}[arrow.out]
        sheet.label(x + dx, y + dy, arrow.label, font_size=10, text_anchor=anchor)


def _head(sheet: Sheet, before: _Place, tip: _Place) -> None:
    """Draw an arrow's head at `tip`, coming from `before` along X or Y."""
    x, y = tip
    along = (x > before[0]) - (x < before[0]), (y > before[1]) - (y < before[1])
    back = x - _HEAD * along[0], y - _HEAD * along[1]
    aside = _HEAD * 0.42 * along[1], _HEAD * 0.42 * along[0]
    corners = [tip, (back[0] + aside[0], back[1] + aside[1]), (back[0] - aside[0], back[1] - aside[1])]
    sheet.draw("path", d=polyline(corners) + "Z", fill=INK)


def _draw_box(sheet: Sheet, box: _Box) -> None:
    x, y, a, b = box.x, box.y, box.a, box.b
    style: dict[str, object] = {"fill": _FILL[box.node.kind], "stroke": INK, "stroke_width": 1.2}
    corners = {
        DECISION: [(x, y - b), (x + a, y), (x, y + b), (x - a, y)],
        DATA: [(x - a + 12, y - b), (x + a, y - b), (x + a - 12, y + b), (x - a, y + b)],
    }.get(box.node.kind)
    if corners:
        sheet.draw("path", d=polyline(corners) + "Z", **style)
    else:
        rounded = {"rx": b} if box.node.kind == TERMINAL else {}
        sheet.draw("rect", x=x - a, y=y - b, width=2 * a, height=2 * b, **rounded, **style)
    lines = box.node.text.splitlines()
    for number, line in enumerate(lines):
        sheet.text(x, y + 4 + _LINE * (number - (len(lines) - 1) / 2), line, text_anchor="middle")
