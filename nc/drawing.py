"""A sheet of drawing paper: SVG in hundredths of an inch of paper, with views of the part on it, to scale.

Sheet                title, notes, views; width and height in inches, so that it prints at its true size
  └─ View            a window on the part: inch scales along two sides, what is drawn in it is clipped
       └─ at(x, y)   the part's thousandths of an inch, Y up  →  the paper's hundredths, Y down
"""

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from math import ceil, floor, log10
from xml.etree import ElementTree as ET

from nc.unit import INCH, Unit

INK, FAINT, GRID = "#1b1b1b", "#8a8a8a", "#e4e4e4"
_FONT = "Helvetica, Arial, sans-serif"
_APART = 45
"""Hundredths of an inch of paper between two figures of a scale, at the least."""


@dataclass(frozen=True)
class Window:
    """A part of the plane, in thousandths of an inch."""

    left: float
    bottom: float
    right: float
    top: float

    @property
    def width(self) -> float:
        """Width in thousandths."""
        return self.right - self.left

    @property
    def height(self) -> float:
        """Height in thousandths."""
        return self.top - self.bottom

    def grown(self, across: float, up: float | None = None) -> "Window":
        """Return the window with a margin all round, or with one at its sides and another above and below."""
        up = across if up is None else up
        return Window(self.left - across, self.bottom - up, self.right + across, self.top + up)

    def holds(self, x: float, y: float) -> bool:
        """Whether the place is in it."""
        return self.left <= x <= self.right and self.bottom <= y <= self.top

    def meets(self, other: "Window") -> bool:
        """Whether some place is in both."""
        across = self.left <= other.right and self.right >= other.left
        return across and self.bottom <= other.top and self.top >= other.bottom


def around(points: Iterable[Sequence[float]]) -> Window:
    """Return the smallest window that holds all the points; there must be one."""
    xs, ys = zip(*((point[0], point[1]) for point in points), strict=True)
    return Window(min(xs), min(ys), max(xs), max(ys))


def number(value: float) -> str:
    """Return a coordinate on paper in as few characters as possible."""
    return f"{value:.2f}".rstrip("0").rstrip(".")


def signed(divisions: int, unit: Unit) -> str:
    """Return an error, in small divisions, as the scale of a graph shows it."""
    return f"{divisions * unit.small:+.{unit.places}f}" if divisions else "0"


def round_step(least: float) -> int:
    """Return the least of 1, 2, 5, 10, 20, 50, ... that is at least `least`, which is 1 or more."""
    decade: int = 10 ** floor(log10(least))
    return next(step * decade for step in (1, 2, 5, 10) if step * decade >= least)


def polyline(points: Iterable[tuple[float, float]]) -> str:
    """Return SVG path data through places on paper."""
    return "M" + "L".join(f"{number(x)} {number(y)}" for x, y in points)


class Sheet:
    """A sheet of paper; sizes in hundredths of an inch."""

    def __init__(self, width: float, height: float, title: str) -> None:
        self.root = ET.Element(
            "svg",
            {
                "xmlns": "http://www.w3.org/2000/svg",
                "width": f"{width / 100:g}in",
                "height": f"{height / 100:g}in",
                "viewBox": f"0 0 {number(width)} {number(height)}",
                "font-family": _FONT,
                "font-size": "11",
                "fill": INK,
            },
        )
        ET.SubElement(self.root, "title").text = title
        self.draw("rect", x=0, y=0, width=width, height=height, fill="#ffffff")
        self.views = 0

    def draw(self, tag: str, parent: ET.Element | None = None, /, **attributes: object) -> ET.Element:
        """Add an element; underscores in attribute names become hyphens."""
        named = {
            name.replace("_", "-"): number(value) if isinstance(value, int | float) else str(value)
            for name, value in attributes.items()
        }
        return ET.SubElement(self.root if parent is None else parent, tag, named)

    def text(self, x: float, y: float, words: str, **attributes: object) -> None:
        """Write a line of text from (x, y)."""
        self.draw("text", x=x, y=y, **attributes).text = words

    def label(
        self, x: float, y: float, words: str, parent: ET.Element | None = None, **attributes: object
    ) -> None:
        """Write text over a white halo: two elements, as some renderers lack paint-order."""
        halo = attributes | {"fill": "#ffffff", "stroke": "#ffffff", "stroke-width": 3, "aria-hidden": "true"}
        for shown in (halo, attributes):
            self.draw("text", parent, x=x, y=y, **shown).text = words

    def svg(self) -> str:
        """Return the sheet as an SVG document."""
        return ET.tostring(self.root, encoding="unicode") + "\n"


class View:
    """A window on the part at (x, y) of a sheet, with scales along two sides, its contents clipped.

    `scale` is inches of paper per inch of the part, along X and along Y.
    """

    def __init__(
        self, sheet: Sheet, x: float, y: float, window: Window, scale: tuple[float, float], unit: Unit = INCH
    ) -> None:
        self.sheet, self.window, self.scale = sheet, window, scale
        self.x, self.y = x, y
        self.unit, self.rise = scale[0] / 10, scale[1] / 10
        self.width, self.height = window.width * self.unit, window.height * self.rise
        sheet.views += 1
        name = f"view{sheet.views}"
        clip = sheet.draw("clipPath", id=name)
        sheet.draw("rect", clip, x=x, y=y, width=self.width, height=self.height)
        self._scales(unit)
        self._body = sheet.draw("g", clip_path=f"url(#{name})")
        sheet.draw("rect", x=x, y=y, width=self.width, height=self.height, fill="none", stroke=INK)

    def at(self, x: float, y: float) -> tuple[float, float]:
        """Return where on paper the part's (x, y) lies."""
        return self.x + (x - self.window.left) * self.unit, self.y + (self.window.top - y) * self.rise

    def draw(self, tag: str, **attributes: object) -> ET.Element:
        """Add an element, in paper coordinates, clipped by the window."""
        return self.sheet.draw(tag, self._body, **attributes)

    def line(self, points: Iterable[tuple[float, float]], **attributes: object) -> None:
        """Draw a line through places of the part."""
        self.draw("path", fill="none", d=polyline(self.at(x, y) for x, y in points), **attributes)

    def circle(self, x: float, y: float, radius: float, fill: str = "none", **attributes: object) -> None:
        """Draw a circle of the part, in a view that stretches neither axis."""
        cx, cy = self.at(x, y)
        self.draw("circle", cx=cx, cy=cy, r=radius * self.unit, fill=fill, **attributes)

    def text(
        self, x: float, y: float, words: str, dx: float = 0, dy: float = 0, **attributes: object
    ) -> None:
        """Write beside a place of the part, `dx` and `dy` on paper away from it, legible over lines."""
        px, py = self.at(x, y)
        self.sheet.label(px + dx, py + dy, words, self._body, **attributes)

    def _scales(self, unit: Unit) -> None:
        bottom, window = self.y + self.height, self.window
        for value, words in _scale(window.left, window.right, self.scale[0], unit):
            x, _ = self.at(value, value)
            self.sheet.draw("line", x1=x, y1=self.y, x2=x, y2=bottom, stroke=GRID)
            self.sheet.draw("line", x1=x, y1=bottom, x2=x, y2=bottom + 5, stroke=INK)
            self.sheet.text(x, bottom + 17, words, text_anchor="middle")
        for value, words in _scale(window.bottom, window.top, self.scale[1], unit):
            _, y = self.at(value, value)
            self.sheet.draw("line", x1=self.x, y1=y, x2=self.x + self.width, y2=y, stroke=GRID)
            self.sheet.draw("line", x1=self.x - 5, y1=y, x2=self.x, y2=y, stroke=INK)
            self.sheet.text(self.x - 8, y + 4, words, text_anchor="end")
        name = "inches" if unit is INCH else unit.name
        self.sheet.text(self.x + self.width / 2, bottom + 33, f"X, {name}", text_anchor="middle")
        x, y = self.x - 42, self.y + self.height / 2
        turned = f"rotate(-90 {number(x)} {number(y)})"
        self.sheet.text(x, y, f"Y, {name}", text_anchor="middle", transform=turned)


def _scale(low: float, high: float, scale: float, unit: Unit) -> Iterator[tuple[float, str]]:
    """Yield the marks of a scale, in thousandths of an inch, with their figures."""
    thousandth = 1000 * unit.scale
    figure = round_step(max(1, 10 * _APART / scale * thousandth))
    step, places = figure / thousandth, 1 if figure >= 100 else 2 if figure >= 10 else 3
    for count in range(ceil(low / step), floor(high / step) + 1):
        yield step * count, f"{unit.of(step * count):.{places}f}"
