"""Figures 3.1 to 3.4: why a slope needs a technique, and the two techniques.

    3.1        one instruction with two feeds: the wrong slope
    3.2        the Piece-wise Linear Technique on a slope
    3.3, 3.4   the Step-wise Linear Technique on a slope and on a curve

The paths are the Hydra-Point's own, cut from tapes; bands are widened until the steps can be seen.
"""

from collections.abc import Callable
from math import atan2, degrees
from typing import Final

import nc
from nc.drawing import FAINT, INK, Sheet, View, Window, polyline
from nc.path import MoveKind
from pdp8.thesis import chain
from programs.milling import Milling
from tapes.hydrapoint import FEED_TOLERANCE, XY_FEED

_PATH, _LIMIT, _INTENDED = "#0b4f9e", "#2e7d32", "#8a8a8a"
_BAND: Final = 380
"""Half the band of Figures 3.2 and 3.3, "the same slope ... with the same tolerance band"."""
_RATIOS: Final = (("1.9 / 1.0", 2, 1, "#c62828"), ("4.0 / 2.7", 4, 3, "#0b4f9e"))
"""The chapter's two pairs of feeds, X over Y, by their codes in Table 2.4."""

_START, _END = (1000, 1000), (5330, 3500)
RUN: Final = (_END[0] - _START[0], _END[1] - _START[1])
"""Chapter 3's slope: 30 degrees, 5 in long."""

_LEFT, _TOP = 70.0, 74.0

_Places = list[tuple[float, float]]


def wrong_slope() -> str:
    """Figure 3.1: 30 degrees by a single instruction, at either of two ratios of X and Y feed."""
    window = Window(600, 700, 6400, 4300)
    sheet = Sheet(_LEFT + 580 + 30, _TOP + 360 + 50, "A 30 degree slope by a single instruction")
    view = View(sheet, _LEFT, _TOP, window, (1, 1))
    _cone(view)
    view.line([_START, _END], stroke=INK, stroke_width=1, stroke_dasharray="8 4")
    for row, (ratio, x_code, y_code, colour) in enumerate(_RATIOS):
        path = _one_instruction(x_code, y_code)
        view.line(_milled(path), stroke=colour, stroke_width=2)
        x, y, _ = path.cuts[0].end
        angle = degrees(atan2(y - _START[1], x - _START[0]))
        said = f"X/Y = {ratio} = {XY_FEED[x_code] / XY_FEED[y_code]:.2f}: {angle:.1f}° until one axis arrives"
        sheet.text(_LEFT, 20 + 16 * row, said, fill=colour)
    sheet.text(_LEFT + 330, 20, "dashed: the 30° slope intended, 1.732", fill=INK)
    sheet.text(_LEFT + 330, 36, "grey: all that 1.9 / 1.0 may become, feeds ±20 %", fill=FAINT)
    _name(view, _START, "A", -14, 14)
    _name(view, _END, "B", 8, -6)
    return sheet.svg()


def _one_instruction(x_code: int, y_code: int) -> nc.Path:
    x, y = _END
    return chain.typed(
        "001 0 01000 01000 0 00 80",
        "002 9 03000 03500 0 01 89",
        f"003 6 01000 01000 0 {x_code:02} 84",
        f"004 6 {x:05} {y:05} 0 {y_code:02} 85",
    )


def _cone(view: View) -> None:
    """Shade the area between the first ratio's extremes of the feeds."""
    x_feed, y_feed = XY_FEED[2], XY_FEED[1]
    reach = []
    for error in (FEED_TOLERANCE, -FEED_TOLERANCE):
        slope = y_feed * (1 - error) / (x_feed * (1 + error))
        run = min(_END[0] - _START[0], (_END[1] - _START[1]) / slope)
        reach.append((_START[0] + run, _START[1] + run * slope))
    corners = [view.at(*place) for place in (_START, reach[0], _END, reach[1])]
    view.draw("path", d=polyline(corners) + "Z", fill="#eeeeee")


def piecewise() -> str:
    """Figure 3.2: X by itself and X with Y by turns, stopping at the limits of the band."""
    path = chain.path("slope", tolerance=_BAND / 1000, milling=Milling("piece", fastest=1, feed_error=0.1))
    said = "X, or X and Y together, at 1 in/min"
    return _technique(path, _line, _BAND, "Piece-wise Linear Technique", said)


def stepwise() -> str:
    """Figure 3.3: Y to the upper limit, X to the lower one."""
    path = chain.path("slope", tolerance=_BAND / 1000)
    return _technique(
        path, _line, _BAND, "Step-wise Linear Technique", "Y to the upper limit, X to the lower"
    )


def stepwise_curve() -> str:
    """Figure 3.4: the same on a curve."""
    path = chain.path("curve", expression="2.4*sqrt(x/4)", from_=0.3, to=4.0, tolerance=0.3)
    said = "the same on a curve that is defined mathematically"
    return _technique(path, _root, 300, "Step-wise Linear Technique", said)


def _line(offset: float) -> _Places:
    """Chapter 3's slope on the table, moved by `offset` at right angles."""
    (x1, y1), (x2, y2) = (4000, 4000), (8330, 6500)
    length = ((x2 - x1) ** 2 + (y2 - y1) ** 2) ** 0.5
    dx, dy = -(y2 - y1) / length * offset, (x2 - x1) / length * offset
    return [(x1 + dx, y1 + dy), (x2 + dx, y2 + dy)]


def _root(offset: float) -> _Places:
    """The curve of Figure 3.4 on the table, moved by `offset` along Y."""
    places = range(300, 4001, 50)
    return [(4000 + x, 5000 + 2400 * (x / 4000) ** 0.5 + offset) for x in places]


def _technique(
    path: nc.Path, band: Callable[[float], _Places], tolerance: float, title: str, said: str
) -> str:
    """Return a path in its band, with its stops named A, C, D ... B as the thesis names them."""
    run = _milled(path)
    xs, ys = zip(*run, strict=True)
    window = Window(min(xs) - 500, min(ys) - 600, max(xs) + 500, max(ys) + 600)
    sheet = Sheet(_LEFT + window.width / 10 + 30, _TOP + window.height / 10 + 50, title)
    sheet.text(_LEFT, 22, title, font_size=15)
    legend = (("intended path", _INTENDED), ("tolerance band", _LIMIT), ("actual path", _PATH))
    sheet.text(_LEFT, 42, said, fill=FAINT)
    for place, (words, colour) in enumerate(legend):
        sheet.text(_LEFT + 100 * place, 62, words, fill=colour)
    view = View(sheet, _LEFT, _TOP, window, (1, 1))
    view.line(band(0), stroke=_INTENDED, stroke_dasharray="8 4")
    for side in (-tolerance, tolerance):
        view.line(band(side), stroke=_LIMIT)
    view.line(run, stroke=_PATH, stroke_width=2)
    stops = _stops(path)
    for number, stop in enumerate(stops, 1):
        name = "B" if number == len(stops) else "CDEFGHIJKLMN"[number - 1]
        view.circle(*stop, 28, fill=_PATH)
        beside = (9, 2) if number == len(stops) - 1 else (-14, -7) if number % 2 else (7, 16)
        _name(view, stop, name, *beside)
    view.circle(*run[0], 28, fill=_PATH)
    _name(view, run[0], "A", -15, 14)
    return sheet.svg()


def _name(view: View, at: tuple[float, float], name: str, dx: float, dy: float) -> None:
    view.text(*at, name, dx=dx, dy=dy, font_weight="bold", font_size=13)


def _milled(path: nc.Path) -> _Places:
    first = path.cuts[0].start
    return [(first.x, first.y), *((move.end.x, move.end.y) for move in path.cuts)]


def _stops(path: nc.Path) -> _Places:
    """Return the ends of the milling blocks."""
    return [
        (step.at.x, step.at.y)
        for step in path.steps
        if any(move.kind is MoveKind.MILL and move.length for move in step.moves)
    ]
