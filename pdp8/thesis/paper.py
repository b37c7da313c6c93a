"""A figure on its sheet: one picture or several, and under them number, title and what is known of it.

    ┌──────────┐ ┌──────────┐
    │ picture  │ │ picture  │     each an SVG of its own, at its own size
    └──────────┘ └──────────┘
    FIGURE 7.2  title
    what the note says

Every sheet has a title and a description for those who cannot see it. Lengths are hundredths of an inch.
"""

import re
from textwrap import wrap
from xml.etree import ElementTree as ET

_SVG = "http://www.w3.org/2000/svg"
_GAP, _MARGIN, _LINE, _LETTER = 20.0, 16.0, 15.0, 5.6
_LEAST_WIDTH = 520.0
_STYLE = "font: {weight} {size}px Helvetica, Arial, sans-serif; fill: {colour}; text-anchor: start"


def framed(pictures: list[str], heading: str, title: str, note: str, *, across: bool = True) -> str:
    """Return one SVG of the pictures, side by side or one above the other, with their caption."""
    ET.register_namespace("", _SVG)
    roots = [_parsed(picture, f"p{number}-") for number, picture in enumerate(pictures)]
    sizes = [_size(root) for root in roots]
    widths, heights = zip(*sizes, strict=True)
    wide = sum(widths) + _GAP * (len(roots) - 1) if across else max(widths)
    high = max(heights) if across else sum(heights) + _GAP * (len(roots) - 1)
    width = max(wide, _LEAST_WIDTH) + 2 * _MARGIN
    lines = wrap(note, int((width - 2 * _MARGIN) / _LETTER))
    height = high + _MARGIN + 34 + _LINE * len(lines) + _MARGIN
    sheet = _sheet(width, height, f"{heading}: {title}", note)
    x, y = (width - wide) / 2, _MARGIN
    for root, (w, h) in zip(roots, sizes, strict=True):
        root.attrib |= {"x": f"{x if across else (width - w) / 2:.2f}", "y": f"{y:.2f}"}
        root.attrib |= {"width": f"{w:.2f}", "height": f"{h:.2f}"}
        sheet.append(root)
        x, y = (x + w + _GAP, y) if across else (x, y + h + _GAP)
    below = _MARGIN + high + 20
    _write(sheet, below, f"{heading}  {title}", "bold", 12.5, "#1b1b1b")
    for number, line in enumerate(lines, 1):
        _write(sheet, below + 4 + _LINE * number, line, "normal", 11, "#444")
    return ET.tostring(sheet, encoding="unicode") + "\n"


def _sheet(width: float, height: float, title: str, description: str) -> ET.Element:
    sizes = (("width", width), ("height", height))
    sheet = ET.Element(f"{{{_SVG}}}svg", {side: f"{of / 100:.4g}in" for side, of in sizes})
    sheet.attrib |= {"viewBox": f"0 0 {width:.2f} {height:.2f}", "role": "img"}
    sheet.attrib |= {"aria-labelledby": "title description"}
    ET.SubElement(sheet, f"{{{_SVG}}}title", {"id": "title"}).text = title
    ET.SubElement(sheet, f"{{{_SVG}}}desc", {"id": "description"}).text = description
    ET.SubElement(sheet, f"{{{_SVG}}}rect", {side: f"{of:.2f}" for side, of in sizes} | {"fill": "#fff"})
    return sheet


def _write(sheet: ET.Element, y: float, words: str, weight: str, size: float, colour: str) -> None:
    style = _STYLE.format(weight=weight, size=size, colour=colour)
    ET.SubElement(sheet, f"{{{_SVG}}}text", {"x": f"{_MARGIN}", "y": f"{y:.2f}", "style": style}).text = words


def _parsed(picture: str, prefix: str) -> ET.Element:
    """Return a picture's root, its identifiers prefixed and its title removed: the sheet has one."""
    named = re.sub(r'(\bid="|url\(#)', rf"\g<1>{prefix}", picture)
    root = ET.fromstring(named)
    for title in root.findall(f"{{{_SVG}}}title"):
        root.remove(title)
    return root


def _size(root: ET.Element) -> tuple[float, float]:
    """Return a picture's width and height on paper."""
    width, height = (float(root.attrib[side].removesuffix("in")) * 100 for side in ("width", "height"))
    return width, height
