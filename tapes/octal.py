"""A tape spelled out, for what cannot carry holes: three octal digits a frame, sixteen frames a line.

         0: 200 200 200 102 000 074 002 ...
        16: ...

The number before the colon counts the line's first frame and is not read back, nor is what follows a "/".
"""

from tapes.errors import TextError
from tapes.text import with_ends

_A_LINE = 16


def encode(text: str) -> bytes:
    """Return the frames that `text` spells. Raises TextError for anything but octal numbers from 0 to 377."""
    frames = bytearray()
    start = 0
    for line in with_ends(text):
        spelled = line.partition("/")[0]
        at = spelled.find(":") + 1
        for number in spelled[at:].split():
            at = spelled.index(number, at)
            if number.strip("01234567") or int(number, 8) > 0o377:
                raise TextError(f"{number!r} is no frame: octal, 000 to 377", text, start + at)
            frames.append(int(number, 8))
        start += len(line)
    return bytes(frames)


def decode(frames: bytes) -> str:
    """Return the tape spelled out, sixteen frames a line."""
    lines = (
        f"{start:7}: " + " ".join(f"{frame:03o}" for frame in frames[start : start + _A_LINE])
        for start in range(0, len(frames), _A_LINE)
    )
    return "".join(line + "\n" for line in lines)
