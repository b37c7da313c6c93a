"""Tapes for other controls than the Hydra-Point: word address and tab sequential (EIA RS-274).

    N010G01X1.5Y2.5F10      word address: a letter says what each number is
    010 TAB 01500 TAB ...   tab sequential: TABs count the words of a block

Only recognised here: `pdp8 tape convert --to text` gives the G-code to a program that reads it.

Sources: EIA RS-273 and RS-274, as N/C manuals of later controls describe them.
"""

import re

from tapes.code import Characters, Code
from tapes.hydrapoint import DIGITS

_WORDS = re.compile(r"[/%]?(?:[:A-Z]\s*[-+]?(?:\d+\.?\d*|\.\d+)\s*)+(?:\([^)]*\))?%?")
_NAMES = re.compile(r"[NGXYZFMST]")
_SEQUENTIAL = re.compile(r"(?=[-+. ]*\d)[-+.\d ]*\t[-+.\d\t ]*")
_SHARE = 2 / 3


def other_control(frames: bytes, code: Code) -> str:
    """Return the format of a tape that is not the Hydra-Point's: "word address", "tab sequential", or ""."""
    if not isinstance(code, Characters):
        return ""
    labels = code.labels(frames)
    tape = frames[labels[-1].stop :] if labels else frames
    text = code.decode(tape.translate(None, bytes(set(range(256)) - set(code.fitting(tape)))))
    lines = [line.strip(" \b\x0e\x0f") for line in text.upper().split("\n")]
    lines = [line for line in lines if line.strip("%\t ")]
    by_words = sum(bool(_WORDS.fullmatch(line) and _NAMES.search(line)) for line in lines)
    others = [line for line in lines if len(line.replace("\t", "").replace(" ", "")) != DIGITS]
    by_tabs = sum(bool(_SEQUENTIAL.fullmatch(line)) for line in others)
    if lines and by_words >= _SHARE * len(lines):
        return "word address"
    return "tab sequential" if lines and by_tabs >= _SHARE * len(lines) else ""
