"""ITA2, the five-level code of telex machines: LTRS and FIGS shift between letters and figures.

    channel 5 4 . 3 2 1      037 is LTRS, 033 FIGS, 010 CR, 002 LF, 004 a space

Figures F, G and H, which each country assigned for itself, are here !, & and #.

Sources: CCITT Recommendation F.1, International Telegraph Alphabet No. 2.
"""

from collections.abc import Collection
from typing import Final

from tapes.code import MOSTLY, Characters, Row, Rule, lined, nearly_all
from tapes.errors import TextError
from tapes.frames import BLANK, skip

FIGURES, LETTERS = 0o33, 0o37

_LETTERS: Final = "\0E\nA SIU\rDRJNFCKTZLWHYPQOBG\x0eMXV\x0f"
_FIGURES: Final = "\0003\n- '87\r\x054\a,!:(5+)2#6019?&\x0e./=\x0f"
_NAMES: Final = {
    "\0": "blank", "\n": "LF", "\r": "CR", " ": "space", "\x0e": "FIGS", "\x0f": "LTRS", "\x05": "WRU",
    "\a": "BELL",
}  # fmt: skip
_LINE_END: Final = bytes([0o10, 0o02])
_FIVE: Final = bytes(range(0o40))


class _Ita2(Characters):
    def encode(self, text: str, parity: str = "mark", fill: int = 6) -> bytes:
        frames = bytearray([LETTERS])
        shifted, other = _LETTERS, _FIGURES
        line = text.upper().replace("\n", "\r\n")
        for at, character in enumerate(line):
            if character not in shifted:
                if character not in other:
                    raise TextError(f"{character!r} has no code in ITA2", line, at)
                shifted, other = other, shifted
                frames.append(LETTERS if shifted == _LETTERS else FIGURES)
            frames.append(shifted.index(character))
        return bytes(frames)

    def decode(self, frames: bytes) -> str:
        text = "".join(said for said in _shifted(frames) if said not in ("\0", "\x0e", "\x0f"))
        return text.replace("\r\n", "\n").replace("\r", "\n")

    def caption(self, frame: int) -> str:
        if frame >= len(_LETTERS):
            return "?"
        letter, figure = _LETTERS[frame], _FIGURES[frame]
        name = _NAMES.get(letter, letter)
        return name if letter == figure else f"{name} {_NAMES.get(figure, figure)}"

    def captions(self, frames: bytes) -> list[str]:
        """Return the character of each frame in the shift that it is in."""
        return [_NAMES.get(said, said) for said in _shifted(frames)]

    def likelihood(self, frames: bytes) -> float:
        """Just under MOSTLY if it begins with a shift or has line ends and no frame has a sixth channel; in a
        tape of several lines nine in ten frames have none.
        """
        first = frames[skip(frames, 0, BLANK) :][:1]
        begun = first in (bytes([LETTERS]), bytes([FIGURES])) or _LINE_END in frames
        fits = not frames.translate(None, _FIVE)
        fits = fits or (self.sense(frames) > 2 and nearly_all(frames.translate(None, bytes([BLANK])), _FIVE))
        return 0.9 * MOSTLY if begun and fits else 0.0

    def rule(self, frames: bytes, doubtful: Collection[int] = ()) -> Rule:
        """Return the rule that no frame has a sixth channel."""
        return Rule("ITA2's five channels", lambda _, frame: frame in _FIVE)

    def sense(self, frames: bytes) -> float:
        return frames.count(_LINE_END)

    def report(self, frames: bytes) -> list[Row]:
        return [("lines", lined([len(line) for line in self.decode(frames).split("\n")], "characters"))]


def _shifted(frames: bytes) -> list[str]:
    said: list[str] = []
    table = _LETTERS
    for frame in frames:
        if frame in (LETTERS, FIGURES):
            table = _LETTERS if frame == LETTERS else _FIGURES
        said.append(table[frame] if frame < len(table) else "?")
    return said


ITA2: Final = _Ita2("ita2", "five-level, ITA2 (telex)", "an ITA2 tape", "#f0e2b6", BLANK, _LINE_END[1])
