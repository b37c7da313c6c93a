"""Drawings on paper of one's own, in true size: pages of SVG that a browser prints at 100 %.

    ┌──────────────────┐   a page is as large as the paper and has no margin of the browser's;
    │ strip            │   at its foot is a ruler of 100 mm, to be measured
    │ strip            │
    │ ├──────┤ 100 mm  │
    └──────────────────┘

Sources: ISO 216 (A4); ANSI/ASME Y14.1 (letter); CSS Paged Media (@page).
"""

import re
from math import ceil
from typing import Final

PAPERS: Final = {"a4": (210.0, 297.0), "letter": (215.9, 279.4)}
"""Width and height in millimetres."""

_INCH: Final = 25.4
_PIXEL: Final = 96
"""CSS pixels in an inch. A browser scales a whole drawing to a whole number of them."""
_SIDE, _TOP, _FOOT = 3.0, 8.0, 18.0
_SIZE = re.compile(r'<svg[^>]*? width="([\d.]+)in" height="([\d.]+)in" viewBox="([^"]*)"[^>]*>')


def area(paper: str) -> tuple[float, float]:
    """Return the width and height in inches that a page has for a drawing."""
    width, height = PAPERS[paper]
    return (width - 2 * _SIDE) / _INCH, (height - _TOP - _FOOT) / _INCH


def pages(drawings: list[str], paper: str) -> str:
    """Return an SVG of as many pages as there are drawings: SVG with width and height in inches."""
    across, down = PAPERS[paper]
    width, height = (int(across / _INCH * _PIXEL), int(down / _INCH * _PIXEL * len(drawings)))
    parts = [
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}px" height="{height}px"'
        f' viewBox="0 0 {width} {height}">',
        f"<style>@page {{ size: {across}mm {down}mm; margin: 0 }}</style>",
    ]
    for number, drawing in enumerate(drawings):
        root = _root(drawing)
        wide, high = (float(inches) * _PIXEL for inches in root.groups()[:2])
        top = number * down
        place = f'x="{_pixels(_SIDE)}" y="{_pixels(top + _TOP)}" width="{wide:g}" height="{high:g}"'
        parts += [
            re.sub(r'width="[^"]*" height="[^"]*"', place, root[0], count=1) + drawing[root.end() :],
            _ruler(top + down - _FOOT + 6, f"100 mm: print at 100 %; page {number + 1} of {len(drawings)}"),
        ]
    return "\n".join([*parts, "</svg>\n"])


def sized(svg: str) -> str:
    """Return an SVG that a browser prints on a page of its own size, in whole pixels."""
    root = _root(svg)
    left, top, across, down = map(float, root[3].split())
    width, height = (ceil(round(float(inches) * _PIXEL, 3)) for inches in root.groups()[:2])
    across, down = across * width / _PIXEL / float(root[1]), down * height / _PIXEL / float(root[2])
    box = f"{left:g} {top:g} {across} {down}"
    size = f'width="{width / _PIXEL}in" height="{height / _PIXEL}in" viewBox="{box}"'
    page = f"<style>@page {{ size: {width}px {height}px; margin: 0 }}</style>"
    return re.sub(r'width="[^>]*?viewBox="[^"]*"', size, root[0]) + page + svg[root.end() :]


def tiled(svg: str, paper: str) -> str:
    """Return the pages of an SVG drawing, cut where it is larger than the paper."""
    root = _root(svg)
    width, height = float(root[1]), float(root[2])
    left, top, across, down = map(float, root[3].split())
    wide, high = area(paper)
    tiles = []
    for y in range(ceil(round(height / high, 3))):
        for x in range(ceil(round(width / wide, 3))):
            w, h = min(wide, width - x * wide), min(high, height - y * high)
            box = (left + x * wide * across / width, top + y * high * down / height)
            view = " ".join(f"{each:g}" for each in (*box, w * across / width, h * down / height))
            size = f'width="{w:g}in" height="{h:g}in" viewBox="{view}"'
            tiles.append(re.sub(r'width="[^>]*?viewBox="[^"]*"', size, root[0]) + svg[root.end() :].strip())
    return pages(tiles, paper)


def _root(svg: str) -> re.Match[str]:
    root = _SIZE.match(svg)
    assert root, "a drawing in inches"
    return root


def _pixels(millimetres: float) -> str:
    return f"{millimetres / _INCH * _PIXEL:.4f}".rstrip("0").rstrip(".")


def _ruler(y: float, words: str) -> str:
    foot = _pixels(y)
    ticks = (f"M{_pixels(_SIDE + 10 * tick)} {foot}v{-16 if tick % 5 == 0 else -10}" for tick in range(11))
    path = f"M{_pixels(_SIDE)} {foot}h{_pixels(100)}{''.join(ticks)}"
    line = f'<path d="{path}" fill="none" stroke="#000" stroke-width="0.8"/>'
    style = 'style="font: 11px sans-serif; fill: #000"'
    return f'{line}<text x="{_pixels(_SIDE + 104)}" y="{foot}" {style}>{words}</text>'
