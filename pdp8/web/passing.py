"""The block that passes under a head, by its fields: the digits that are read, and those to come.

  130   6   03138  05517  ...     bold as far as the head; "·" for what the tape does not have
sequence prep.  X      Y
"""

from tapes import codes, eia
from tapes.ascii import CR
from tapes.code import Characters, Code
from tapes.hydrapoint import FIELDS, ROWS

_END = "↵"
_SHORT = {"preparatory": "prep.", "x": "X", "y": "Y", "reserved": "res.", "miscellaneous": "misc."}
_WIDTHS = {**FIELDS, "end": 1}

_TEXTS = "<b><i class='read' data-text></i><i data-text></i></b>"
_FIELDS = (f"<span>{_TEXTS}<small>{_SHORT.get(name, name)}</small></span>" for name in _WIDTHS)
BLOCK = f"<p>{''.join(_FIELDS)}</p>"
"""The fields as HTML, each with two texts: what is read, and what is not."""


def passing(frames: bytes, head: int, code: Code) -> list[str]:
    """Return two texts for each field of the block at frame `head`; none if there is no block."""
    if not isinstance(code, Characters):
        return []
    first = max(0, head)
    while first > 0 and _digit(frames[first - 1], code) != _END:
        first -= 1
    digits, read = "", 0
    for at in range(first, len(frames)):
        digit = _digit(frames[at], code)
        digits += digit
        if at <= head:
            read += len(digit)
        if digit == _END or len(digits) == ROWS:
            break
    if digits.removesuffix(_END).strip("0123456789"):
        return []
    texts: list[str] = []
    at = 0
    for width in _WIDTHS.values():
        shown = digits[at : at + width].ljust(width, "·")
        passed = max(0, read - at)
        texts += [shown[:passed], shown[passed:]]
        at += width
    return texts


def _digit(frame: int, code: Code) -> str:
    """Return a digit or end of block; a space is a zero, other ASCII is skipped."""
    if code is codes.EIA:
        return eia.CHARACTERS.get(frame, "").replace("\n", _END)
    character = frame & 0o177
    if character == CR:
        return _END
    return chr(character) if 0o60 <= character <= 0o71 else "0" if character == 0o40 else ""
