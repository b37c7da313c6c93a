"""A tape as one sees it: as text, a row a frame, and as SVG in true geometry.

As text the tape runs up the page, channel 8 on the left, so that a row reads as the octal number does:

       frame  octal    8 7 6 5 4 . 3 2 1      ^ feed: the top row is read first
           0    301  | o o       .     o |  A

As SVG it runs to the left, the same side up (the text turned a quarter to the left), so that channel 1 is at
the top:

    width 1.000 in, rows 0.100 in apart, channels 0.100 in apart, sprocket holes 0.392 in from the edge beside
    channel 1; code holes 0.072 in and sprocket holes 0.046 in across, their centres on one line

Not emulated: the arrow-head of a torn leader, folds, the advanced sprocket holes of some older tapes.

Sources: thesis, chapter 2 (widths, holes, pitch); ECMA-10 (place of the sprocket track); three holes lie on
one side of the sprocket and five on the other, channel 1 being the outermost of the three.
"""

from collections.abc import Iterator
from html import escape

from tapes import codes, doubts
from tapes.errors import TapeError
from tapes.frames import channels, draw
from tapes.paper import area
from tapes.paper import pages as paged

WIDTH = 1000  # thousandths of an inch, as everything below
PITCH = 100
SPROCKET_TRACK = 392
CODE_HOLE = 72
SPROCKET_HOLE = 46

_MOST = 20_000
"""Frames of a drawing: some 10 MB."""
ON_PAPER = 70
"""Frames of a strip that is printed."""

_Row = tuple[int, int, str]

_MARGIN = 700
_ABOVE = 200
_BELOW = 300
_LETTER = 54


def text(frames: bytes, code: str = "", start: int = 0, stop: int | None = None) -> str:
    """Return frames `start` up to `stop` as rows with number, octal and caption in the code named `code`."""
    rows = [
        "   frame  octal    8 7 6 5 4 . 3 2 1      ^ feed: the top row is read first",
        *(
            f"{number:8}    {frame:03o}  | {' '.join(draw(frame))} |  {caption}".rstrip()
            for number, frame, caption in _rows(frames, code, start, stop)
        ),
    ]
    return "".join(row + "\n" for row in rows)


def svg(
    frames: bytes,
    code: str = "",
    start: int = 0,
    stop: int | None = None,
    strip: int = 80,
    *,
    tracks: bool = False,
) -> str:
    """Frames `start` up to `stop` in true size, in strips; `tracks` numbers all nine, as the thesis does."""
    shown = _rows(frames, code, start, stop)
    check_length(len(shown))
    strips = [shown[at : at + strip] for at in range(0, len(shown), strip)]
    return _drawing(strips, 2 * _MARGIN + PITCH * min(strip, max(len(shown), 1)), tracks)


def pages(frames: bytes, code: str, start: int, stop: int | None, paper: str) -> str:
    """Return frames `start` up to `stop` as SVG pages for `paper`: strips of 70 frames with marks to cut."""
    shown = _rows(frames, code, start, stop)
    check_length(len(shown))
    width, height = area(paper)
    sheets: list[list[list[_Row]]] = [[]]
    for at in range(0, len(shown), ON_PAPER):
        rows = shown[at : at + ON_PAPER]
        if sum(map(_height, sheets[-1])) + _height(rows) + _ABOVE > height * 1000:
            sheets.append([])
        sheets[-1].append(rows)
    drawings = [_drawing(strips, round(width * 1000), marks=True).strip() for strips in sheets]
    return paged(drawings, paper)


def check_length(count: int) -> None:
    """Raise TapeError for more frames than a drawing has."""
    if count > _MOST:
        raise TapeError(f"{count:,} frames: a drawing has {_MOST:,} at most; draw it in pieces")


def _rows(frames: bytes, code: str, start: int, stop: int | None) -> list[_Row]:
    known = codes.named(code)
    said = known.captions(frames)
    for doubt in doubts.find(frames, known):
        said[doubt.frame] += "  ?" if doubt.likely is None else f"  ? likely {known.caption(doubt.likely)}"
    return list(zip(range(len(frames)), frames, said, strict=True))[start:stop]


def _drawing(strips: list[list[_Row]], width: int, tracks: bool = False, marks: bool = False) -> str:
    height = sum(map(_height, strips)) + _ABOVE
    parts = [
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{width / 1000}in" height="{height / 1000}in"'
        f' viewBox="0 0 {width} {height}">',
        _STYLE,
        f'<rect class="page" width="{width}" height="{height}"/>',
    ]
    top = _ABOVE
    for rows in strips:
        parts += _strip(rows, top, tracks)
        if marks:
            parts.append(_marks(PITCH * len(rows), top))
        top += _height(rows)
    return "\n".join([*parts, "</svg>\n"])


def _marks(length: int, top: int) -> str:
    """Return the lines beside a strip's corners along which it is cut."""
    lines = "".join(
        f"M{x} {y}m{across * 30} 0h{across * 90}M{x} {y}m0 {up * 110}v{up * 60}"
        for x, across in ((_MARGIN, -1), (_MARGIN + length, 1))
        for y, up in ((top, -1), (top + WIDTH, 1))
    )
    return f'<path d="{lines}" fill="none" stroke="#000" stroke-width="5"/>'


_STYLE = """<style>
.page { fill: #fff } .paper { fill: #f3e7c3; stroke: #b9a873; stroke-width: 6 }
.hole { fill: #fff; stroke: #3c3524; stroke-width: 5 }
text { font: 90px monospace; fill: #222 } .track { text-anchor: end } .count { text-anchor: middle }
.arrow { fill: #222 }
</style>"""


def _height(rows: list[_Row]) -> int:
    longest = max(len(caption) for _, _, caption in rows)
    return _ABOVE + WIDTH + _BELOW + _LETTER * longest


def _strip(rows: list[_Row], top: int, tracks: bool) -> Iterator[str]:
    """Draw one strip whose upper edge is at `top`: paper, track numbers, arrow, frames and their words."""
    numbered = {channel: (channel + (channel > 3) if tracks else channel) for channel in range(1, 9)}
    places = [(track(channel), number) for channel, number in numbered.items()]
    if tracks:
        places.append((SPROCKET_TRACK, 4))
    yield f'<rect class="paper" x="{_MARGIN}" y="{top}" width="{PITCH * len(rows)}" height="{WIDTH}"/>'
    yield f'<text x="80" y="{top + track(1) - 50}">{"track" if tracks else "channel"}</text>'
    for place, number in places:
        yield f'<text class="track" x="{_MARGIN - 60}" y="{place + top + 31}">{number}</text>'
    arrow = f"M 80 {top + SPROCKET_TRACK} l 120 -60 v 40 h 160 v 40 h -160 v 40 z"
    yield f'<path class="arrow" d="{arrow}"/>'
    yield f'<text x="80" y="{top + SPROCKET_TRACK + 170}">feed</text>'
    for place, row in enumerate(rows):
        yield from _frame(row, _MARGIN + PITCH * place + PITCH // 2, top)


def _frame(row: _Row, x: int, top: int) -> Iterator[str]:
    number, frame, caption = row
    if number % 10 == 0:
        yield f'<text class="count" x="{x}" y="{top - 40}">{number}</text>'
    yield _hole(x, top + SPROCKET_TRACK, SPROCKET_HOLE)
    for channel in reversed(channels(frame)):
        yield _hole(x, top + track(channel), CODE_HOLE)
    words = escape(f"{frame:03o} {caption}".rstrip())
    yield f'<text transform="translate({x - 30} {top + WIDTH + 50})rotate(90)">{words}</text>'


def track(channel: int) -> int:
    """Return the distance of a channel's holes from the edge beside channel 1."""
    return SPROCKET_TRACK + PITCH * (channel - 4 if channel < 4 else channel - 3)


def _hole(x: int, y: int, across: int) -> str:
    return f'<circle class="hole" cx="{x}" cy="{y}" r="{across // 2}"/>'
