"""Letters punched for the eye: five frames a letter, channel 1 at the top, a blank frame between.

o   o  o o o      H, I: seven channels high, channel 8 is free
o o o    o
o   o  o o o
"""

from typing import Final

from tapes.errors import TextError
from tapes.frames import BLANK

GAP: Final = 20
"""Blank frames between a title and the text."""

_NAMES: Final = "ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789.,-+/*:()=?!'#&"
_COLUMNS: Final = """
    7c1211127c 7f49494936 3e41414122 7f4141413e 7f49494941 7f09090901 3e41495979 7f0808087f 41417f4141
    204041403f 7f08142241 7f40404040 7f020c027f 7f0408107f 3e4141413e 7f09090906 3e4151215e 7f09192946
    2649494932 01017f0101 3f4040403f 1f2040201f 3f4038403f 6314081463 0708700807 6151494543 3e5149453e
    427f40 4261514946 2141494d33 1814127f10 2745454539 3c4a494931 0171090503 3649494936 464949291e
    6060 5030 0808080808 08083e0808 2010080402 14083e0814 3636 1c2241 41221c 1414141414 0201510906 5f
    0503 147f147f14 3649552250
"""
_FONT: Final = {name: bytes.fromhex(each) for name, each in zip(_NAMES, _COLUMNS.split(), strict=True)}
_LETTERS: Final = {columns: letter for letter, columns in _FONT.items()}


def punch(text: str) -> bytes:
    """Return a title as frames, with blank tape after it. Raises TextError for a letter that is not in it."""
    frames = bytearray()
    for at, letter in enumerate(text.upper()):
        if letter != " " and letter not in _FONT:
            raise TextError(f"{letter!r} cannot be punched for the eye: {''.join(_FONT)}", text, at)
        frames += bytes(3) if letter == " " else _FONT[letter] + bytes(1)
    return bytes(frames) + bytes(GAP)


def read(frames: bytes) -> str:
    """Return the title in letters of `punch`, "" for other letters."""
    words = []
    for word in frames.strip(bytes(1)).split(bytes(4)):
        letters = [_LETTERS.get(columns, "") for columns in word.split(bytes([BLANK])) if columns]
        words.append("".join(letters) if all(letters) else "")
    return " ".join(words) if all(words) else ""
