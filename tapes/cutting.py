"""A tape for a laser or a plotter that cuts: outline and holes in true size, nothing else, in millimetres.

    SVG   rect and circle with plain attributes: no text, no style, no transform
    DXF   R12: polylines on the layer OUTLINE, circles on HOLES

Strips of 80 frames lie below each other, the first on top; channel 1 is the upper edge.

Sources: DXF reference, AutoCAD R12; geometry as in picture.py.
"""

from collections.abc import Iterator
from typing import NamedTuple

from tapes.frames import channels
from tapes.picture import CODE_HOLE, PITCH, SPROCKET_HOLE, SPROCKET_TRACK, WIDTH, check_length, track

_MM = 0.0254  # of a thousandth of an inch
_STRIP = 80
_APART = 1200  # thousandths of an inch from one strip to the next
_LINE = 'fill="none" stroke="#000000" stroke-width="0.1"'


class _Strip(NamedTuple):
    top: float
    length: float
    holes: list[tuple[float, float, float]]
    """Each as x, y and diameter, in millimetres; y grows downwards."""


def svg(frames: bytes) -> str:
    """Return the frames as SVG. Raises TapeError for too many."""
    strips = list(_strips(frames))
    width, height = max(each.length for each in strips), strips[-1].top + WIDTH * _MM
    lines = []
    for strip in strips:
        size = f'width="{strip.length:.3f}" height="{WIDTH * _MM:.3f}"'
        lines.append(f'<rect x="0" y="{strip.top:.3f}" {size} {_LINE}/>')
        lines += [f'<circle cx="{x:.3f}" cy="{y:.3f}" r="{d / 2:.4f}" {_LINE}/>' for x, y, d in strip.holes]
    size = f'width="{width:.3f}mm" height="{height:.3f}mm" viewBox="0 0 {width:.3f} {height:.3f}"'
    return "\n".join([f'<svg xmlns="http://www.w3.org/2000/svg" {size}>', *lines, "</svg>\n"])


def dxf(frames: bytes) -> str:
    """Return the frames as DXF, the first strip uppermost. Raises TapeError for too many."""
    strips = list(_strips(frames))
    pairs: list[tuple[int, object]] = [
        (0, "SECTION"), (2, "HEADER"), (9, "$ACADVER"), (1, "AC1009"), (9, "$INSUNITS"), (70, 4),
        (0, "ENDSEC"), (0, "SECTION"), (2, "ENTITIES"),
    ]  # fmt: skip
    for strip in strips:
        top, bottom = -strip.top, -strip.top - WIDTH * _MM
        pairs += [(0, "POLYLINE"), (8, "OUTLINE"), (66, 1), (70, 1), (10, 0.0), (20, 0.0), (30, 0.0)]
        for x, y in ((0.0, top), (strip.length, top), (strip.length, bottom), (0.0, bottom)):
            pairs += [(0, "VERTEX"), (8, "OUTLINE"), (10, x), (20, y), (30, 0.0)]
        pairs += [(0, "SEQEND"), (8, "OUTLINE")]
        for x, y, across in strip.holes:
            pairs += [(0, "CIRCLE"), (8, "HOLES"), (10, x), (20, -y), (30, 0.0), (40, across / 2)]
    pairs += [(0, "ENDSEC"), (0, "EOF")]
    said = (f"{value:.4f}" if isinstance(value, float) else f"{value}" for _, value in pairs)
    return "".join(f"{code:3}\n{value}\n" for (code, _), value in zip(pairs, said, strict=True))


def _strips(frames: bytes) -> Iterator[_Strip]:
    check_length(len(frames))
    for number, start in enumerate(range(0, len(frames), _STRIP)):
        piece = frames[start : start + _STRIP]
        holes = []
        for at, frame in enumerate(piece):
            x = PITCH * at + PITCH / 2
            places = [(SPROCKET_TRACK, SPROCKET_HOLE), *((track(one), CODE_HOLE) for one in channels(frame))]
            holes += [(x * _MM, (number * _APART + y) * _MM, across * _MM) for y, across in places]
        yield _Strip(number * _APART * _MM, PITCH * len(piece) * _MM, holes)
