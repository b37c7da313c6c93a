"""Figures 2.2, 2.5, 5.1 and 5.4: tapes, and the code of N/C machines.

The tapes are the true ones of tapes/picture; the chart is tapes/eia's table.
"""

from typing import Final

from nc.drawing import FAINT, GRID, INK, Sheet
from pdp8.thesis import chain
from tapes import ascii, eia, frames, picture
from tapes.text import lines_of

_NAMES: Final = {" ": "SPACE", "\n": "CARR. RET.", "\t": "TAB", "\b": "BACKSPACE"} | {
    eia.STOP: "STOP", eia.UPPER_CASE: "UPPER CASE", eia.LOWER_CASE: "LOWER CASE",
}  # fmt: skip

_ROW, _BLOCK, _PITCH = 16.0, 262.0, 13.0
_PER_BLOCK = 18
_BLOCK_OF_THE_CIRCLE = 7


def digits() -> str:
    """Figure 2.2: the digits and the end of block on an inch of tape."""
    return picture.svg(eia.encode("0123456789\n"), "eia", tracks=True)


def drilled_block() -> str:
    """Figure 2.5: one block of 20 rows, the first hole of Chapter 3's drilling program."""
    block = lines_of(chain.printout("drill"))[2].replace(" ", "0")
    return picture.svg(eia.encode(block + "\n"), "eia")


def before_and_after() -> list[str]:
    """Figure 5.4: a block of the circle as the terminal punched it, and as the program left it."""
    text = chain.printout("circle")
    line = lines_of(text)[_BLOCK_OF_THE_CIRCLE - 1] + "\n"
    return [
        picture.svg(ascii.encode(line), "ascii"),
        picture.svg(chain.translated(line).lstrip(b"\0"), "eia"),
    ]


def chart() -> str:
    """Figure 5.1: every character of the EIA code and its holes."""
    codes = list(eia.CODES.items())
    blocks = [codes[at : at + _PER_BLOCK] for at in range(0, len(codes), _PER_BLOCK)]
    sheet = Sheet(_BLOCK * len(blocks) + 30, 60 + _ROW * (_PER_BLOCK + 1), "The EIA code")
    for number, block in enumerate(blocks):
        _chart_block(sheet, 20 + _BLOCK * number, block)
    return sheet.svg()


def _chart_block(sheet: Sheet, left: float, block: list[tuple[str, int]]) -> None:
    holes = left + 86
    for channel in range(8, 0, -1):
        sheet.text(holes + _column(channel), 30, str(channel), text_anchor="middle", fill=FAINT)
    for row, (character, code) in enumerate(block):
        y = 50 + _ROW * row
        sheet.draw("line", x1=left, y1=y + 5, x2=left + _BLOCK - 20, y2=y + 5, stroke=GRID)
        sheet.text(left, y, _NAMES.get(character, character), font_weight="bold")
        sheet.draw("circle", cx=holes + _column(3.5), cy=y - 4, r=1.6, fill=FAINT)
        for channel in frames.channels(code):
            sheet.draw("circle", cx=holes + _column(channel), cy=y - 4, r=4.2, fill=INK)
        sheet.text(left + _BLOCK - 22, y, f"{code:03o}", text_anchor="end", fill=FAINT)


def _column(channel: float) -> float:
    """Return the place of a channel across the tape: 8 first, the sprocket holes between 4 and 3."""
    return _PITCH * (8 - channel if channel > 3.5 else 9 - channel if channel < 3.5 else 5)
