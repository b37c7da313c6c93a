"""Cards to print and lay beside the machine: a sheet of A4 each, SVG.

Sources: the PDP-8/I instruction card, for the RIM loader and the instructions; tapes/ and pal/ for the codes,
as they are used everywhere here.
"""

from collections.abc import Callable, Iterable, Iterator, Sequence
from html import escape

from pal.symbols import PERMANENT, Permanent
from pdp8.computer.use.operator import RIM, RIM_HIGH_SPEED, RIM_START
from tapes import ascii, eia
from tapes.frames import draw
from tapes.text import lines_of

WIDTH, HEIGHT = 707, 500
"""In units of 0.42 mm; A4 is 297 by 210 mm, and type of 9 is 14 pixels high on it."""

_MARGIN = 30
_STYLE = """<style>
.card { fill: #fffdf6; stroke: #888; }
text { font-family: "DejaVu Sans Mono", Menlo, monospace; font-size: 11px; fill: #111 }
.title { font-size: 19px; font-weight: bold }
.list { font-size: 9px } .head { font-weight: bold } .small { font-size: 9px; fill: #444 }
.up { fill: #111 } .down { fill: #fff; stroke: #111 } .hole { fill: #111 } .sprocket { fill: #888 }
</style>"""


class _Card:
    """A card while it is drawn; x and y are units from its upper left corner."""

    def __init__(self, title: str, below: str = "") -> None:
        self._parts = [
            f'<svg xmlns="http://www.w3.org/2000/svg" width="297mm" height="210mm"'
            f' viewBox="0 0 {WIDTH} {HEIGHT}">',
            _STYLE,
            f'<rect class="card" x="1" y="1" width="{WIDTH - 2}" height="{HEIGHT - 2}" rx="12"/>',
        ]
        self.text(_MARGIN, 40, title, "title")
        self.text(_MARGIN, HEIGHT - 18, below, "small")

    def text(self, x: float, y: float, text: str, kind: str = "") -> None:
        named = f' class="{kind}"' if kind else ""
        self._parts.append(f'<text x="{x:g}" y="{y:g}"{named} xml:space="preserve">{escape(text)}</text>')

    def lines(self, x: float, y: float, lines: Iterable[str], step: float, kind: str = "") -> None:
        """Write lines one below the other; those that end with a colon are headings."""
        for number, line in enumerate(lines):
            heads = f"{kind} head" if line.endswith(":") else kind
            self.text(x, y + number * step, line.removesuffix(":"), heads)

    def circle(self, x: float, y: float, radius: float, kind: str) -> None:
        self._parts.append(f'<circle class="{kind}" cx="{x:g}" cy="{y:g}" r="{radius:g}"/>')

    def svg(self) -> str:
        return "\n".join([*self._parts, "</svg>\n"])


def rim() -> str:
    """Return the RIM loader's card: address, word and switches, up for 1."""
    card = _Card("RIM loader", "In brackets: the word for the high-speed reader, where it is another one.")
    card.text(_MARGIN, 66, "address  word           switches", "head")
    for number, (word, fast) in enumerate(zip(RIM, RIM_HIGH_SPEED, strict=True)):
        y = 84 + number * 22
        other = f"({fast:04o})" if fast != word else ""
        card.text(_MARGIN, y, f"{RIM_START + number:04o}     {word:04o}  {other}")
        _switches(card, _MARGIN + 160, y - 4, word)
    card.lines(430, 66, lines_of(_RIM_STEPS), 20)
    return card.svg()


_RIM_STEPS = """\
How it goes in:
1  MEM PROT down
2  switches 7756, LOAD ADD
3  the first word, DEP
4  the next word, DEP, and so on;
   the address steps by itself

How it is looked over:
5  switches 7756, LOAD ADD
6  EXAM, and MB shows the word;
   EXAM again for the next

How it is used:
7  a RIM tape in the reader, on
   its leader
8  switches 7756, LOAD ADD, START
9  STOP when the tape has run out"""


def _switches(card: _Card, x: float, y: float, word: int) -> None:
    for bit in range(12):
        up = word >> 11 - bit & 1
        card.circle(x + bit * 16 + bit // 3 * 9, y, 5.5, "up" if up else "down")


def instructions() -> str:
    """Return the instructions' card."""
    card = _Card("PDP-8/L instructions", _WORD)
    left = (
        *_column("Memory reference, 3.2 us (JMP 1.6); I takes 1.6 more:", PERMANENT[:6]),
        *_column("OPR group 1, 1.6 us: CLA CLL, CMA CML, IAC, rotate:", _between(0o7000, 0o7377)),
        *_column("Combined:", [each for each in PERMANENT if each.mnemonic in _COMBINED]),
    )
    right = (
        *_column("OPR group 2, 1.6 us: skip, CLA, OSR, HLT:", _between(0o7400, 0o7777)),
        *_column("Input and output, 4.25 us:", _between(0o6000, 0o6047)),
    )
    step = (HEIGHT - 110) / max(len(left), len(right))
    card.lines(_MARGIN, 64, left, step, "list")
    card.lines(340, 64, right, step, "list")
    return card.svg()


_WORD = (
    "A memory reference: bits 0-2 operation, 3 I, 4 page (0: page zero), 5-11 address. "
    "Through 0010-0017 I adds 1 first."
)


def _column(title: str, instructions: Sequence[Permanent]) -> Iterator[str]:
    yield title
    yield from (f"{each.mnemonic} {each.octal:04o} {each.meaning}" for each in instructions)
    yield ""


_COMBINED = ("CIA", "LAS", "STL", "GLK", "STA")


def _between(first: int, last: int) -> list[Permanent]:
    """Return these instructions; IOTs only to 6047, which this machine has."""
    return [
        each
        for each in PERMANENT
        if first <= each.octal <= last and not each.memory_reference and each.mnemonic not in _COMBINED
    ]


def ascii_code() -> str:
    """Return ASCII's card, with channel 8 as a Teletype punches it."""
    frames = [*range(0o240, 0o340), 0o212, 0o215, 0o207, 0o377]
    return _codes("ASCII, as a Teletype punches it", [(frame, ascii.name(frame)) for frame in frames], 5)


def eia_code() -> str:
    """Return EIA's card: the digits first, as the Hydra-Point reads them."""
    digits = [eia.CODES[digit] for digit in "0123456789"]
    rest = [code for code in eia.CHARACTERS if code not in digits]
    return _codes("EIA RS-244", [(frame, eia.name(frame)) for frame in [*digits, *rest]], 4)


def _codes(title: str, codes: Sequence[tuple[int, str]], columns: int) -> str:
    card = _Card(title, "Channels 8 7 6 5 4, sprocket hole, 3 2 1. The octal number reads as the row does.")
    rows = -(-len(codes) // columns)
    step = (HEIGHT - 100) / rows
    across = (WIDTH - 2 * _MARGIN) / columns
    for number, (frame, name) in enumerate(codes):
        x, y = _MARGIN + number // rows * across, 68 + number % rows * step
        card.text(x, y, name)
        card.text(x + 46, y, f"{frame:03o}")
        _holes(card, x + 78, y - 4, frame, (across - 94) / 9)
    return card.svg()


def _holes(card: _Card, x: float, y: float, frame: int, pitch: float) -> None:
    for place, mark in enumerate(draw(frame)):
        if mark != " ":
            radius, kind = (0.23, "sprocket") if mark == "." else (0.42, "hole")
            card.circle(x + place * pitch, y, pitch * radius, kind)


def afternoon(slots: Sequence[tuple[str, str, str]], title: str) -> str:
    """Return the timetable's card; a slot is when, what, and its outcome."""
    card = _Card(
        title, "Machine times are exact; the time a person takes is ours. Made by `pdp8 cards afternoon`."
    )
    step = min(52, (HEIGHT - 110) / len(slots))
    for number, (time, what, outcome) in enumerate(slots):
        y = 72 + number * step
        card.text(_MARGIN, y, f"{time:>11}", "head")
        card.text(_MARGIN + 92, y, what)
        card.text(_MARGIN + 92, y + 16, outcome, "small")
    return card.svg()


CARDS: dict[str, Callable[[], str]] = {
    "rim": rim, "instructions": instructions, "ascii": ascii_code, "eia": eia_code,
}  # fmt: skip
"""The cards that need nothing but themselves; the afternoon's needs an afternoon."""
