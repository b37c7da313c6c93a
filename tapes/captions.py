"""What each frame says, in a few letters beside its row: a character, an origin, a word with its address.

Whatever is on the tape gets a caption, damaged tapes and wrong guesses included; what makes no sense in the
code asked for is "?".
"""

from collections.abc import Callable

from tapes import ascii, binary, eia, rim
from tapes.errors import TapeError
from tapes.frames import BLANK, LEADER, RUBOUT

_Captions = Callable[[bytes], list[str]]

CODES = ("ascii", "eia", "bin", "rim")


def captions(frames: bytes, code: str) -> list[str]:
    """Return one caption a frame, in `code`, one of CODES; in any other code they are empty."""
    by_code: dict[str, _Captions] = {
        "ascii": lambda frames: [ascii.name(frame) for frame in frames],
        "eia": lambda frames: [eia.name(frame) for frame in frames],
        "bin": lambda frames: _between_labels(frames, code, _binary),
        "rim": lambda frames: _between_labels(frames, code, _rim),
    }
    return by_code.get(code, _none)(frames)


def labels(frames: bytes, code: str) -> tuple[range, ...]:
    """Return the frames of the labels of a BIN or RIM tape, () for any other."""
    if code not in ("bin", "rim"):
        return ()
    try:
        return binary.read(frames).labels if code == "bin" else rim.read(frames).labels
    except TapeError:
        return ()


def _none(frames: bytes) -> list[str]:
    return [""] * len(frames)


def _binary(frames: bytes) -> list[str]:
    said = [_single(frame) for frame in frames]
    address = None
    at = 0
    while at < len(frames):
        if frames[at] == RUBOUT:
            at = _message(frames, at, said)
        elif frames[at] == BLANK and address is None:
            at += 1
        elif frames[at] == LEADER:
            address = None
            at += 1
        elif _is_pair(frames, at):
            value = (frames[at] & 0o77) << 6 | frames[at + 1]
            if frames[at] >> 6:
                said[at], address = f"origin {value:04o}", value
            elif address is None or frames[at + 2 : at + 3] == bytes([LEADER]):
                said[at], address = f"checksum {value:04o}", None
            else:
                said[at], address = f"{address:04o}: {value:04o}", address + 1 & 0o7777
            said[at + 1] = '"'
            at += 2
        else:
            at += 1
    return said


def _rim(frames: bytes) -> list[str]:
    said = [_single(frame) for frame in frames]
    at = 0
    while at < len(frames):
        group = frames[at : at + 4]
        if [frame >> 6 for frame in group] == [1, 0, 0, 0]:
            address = (group[0] & 0o77) << 6 | group[1]
            said[at : at + 4] = [f"address {address:04o}", '"', f"{group[2] << 6 | group[3]:04o}", '"']
            at += 4
        else:
            at += 1
    return said


def _single(frame: int) -> str:
    if frame == LEADER:
        return "leader"
    if frame == RUBOUT:
        return "rubout"
    if frame == BLANK:
        return "blank"
    return f"field {frame >> 3 & 7}" if frame >> 6 == 3 else "?"


def _is_pair(frames: bytes, at: int) -> bool:
    return frames[at] >> 6 < 2 and at + 1 < len(frames) and frames[at + 1] >> 6 == 0


def _message(frames: bytes, at: int, said: list[str]) -> int:
    """Caption what stands between two rubouts as the characters it is; return the frame after it."""
    closing = frames.find(RUBOUT, at + 1)
    if closing == -1:
        return at + 1
    said[at + 1 : closing] = [f"({ascii.name(frame)})" for frame in frames[at + 1 : closing]]
    return closing + 1


def _between_labels(frames: bytes, code: str, body: _Captions) -> list[str]:
    """Caption the labels as such, and what is between by `body`."""
    said: list[str] = []
    for label in (*labels(frames, code), range(len(frames), len(frames))):
        said += body(frames[len(said) : label.start]) + ["label"] * len(label)
    return said
