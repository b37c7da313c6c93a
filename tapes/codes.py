"""Every tape code, and which of them a tape is in, by its frames.

Most of the frames decide, so that a damaged tape keeps its code, and the reader of that code can name the
frame that is wrong. Where two codes are as likely, the first in CODES has it.

To add a code, write its file beside eia.py, and name its object here.
"""

from typing import Final

from tapes import ascii, eia, ita2, loaders
from tapes.code import PERHAPS, Characters, Code, nearly_all
from tapes.frames import BLANK, label_before, leader_start, skip
from tapes.loaders import Words

BIN: Final = loaders.BIN
RIM: Final = loaders.RIM
ASCII: Final = ascii.ASCII
EIA: Final = eia.EIA
ITA2: Final = ita2.ITA2

CODES: Final[tuple[Code, ...]] = (BIN, RIM, ASCII, EIA, ITA2)

_SIX_LEVELS = bytes(range(0o100))
_FEW = 20

BLANK_TAPE: Final = Code("blank", "blank", "a blank tape")
SIX_LEVEL: Final = Code("six-level", "five or six levels, such as of an LGP-21: not read", "a six-level tape")
UNKNOWN: Final = Code(
    "unknown", f"unknown: none of {', '.join(code.name.upper() for code in CODES)}", "a tape of no known code"
)


def recognise(frames: bytes) -> Code:
    """Return the likeliest code of a tape; BLANK_TAPE, SIX_LEVEL or UNKNOWN if none fits."""
    body = frames[skip(frames, 0, BLANK) :]
    if not body:
        return BLANK_TAPE
    found, most = UNKNOWN, 0.0
    for code in CODES:
        likelihood = code.likelihood(body)
        if likelihood > most:
            found, most = code, likelihood
    if most >= PERHAPS:
        return found
    titled = next((code for code in CODES if isinstance(code, Characters) and code.labels(frames)), found)
    if titled is not UNKNOWN:
        return titled
    if len(body) >= _FEW and nearly_all(body.translate(None, bytes([BLANK])), _SIX_LEVELS):
        return SIX_LEVEL
    return UNKNOWN


def named(name: str) -> Code:
    """Return the code of this name; UNKNOWN, in which frames have no captions, if there is none."""
    return next((code for code in (*CODES, BLANK_TAPE) if code.name == name), UNKNOWN)


def start(frames: bytes) -> int:
    """Return the frame on which an operator sets the tape: a loader tape's leader, any other's first."""
    code = recognise(frames)
    if isinstance(code, Words):
        return code.known(frames).start
    leader = leader_start(frames)
    return 0 if leader is None or label_before(frames, leader) else leader
