"""What the tests of tapes share: a tape of DEC's, and why one is refused."""

from collections.abc import Callable

from tapes.errors import TapeError

LEADER = bytes([0o200]) * 64


def octal(text: str) -> bytes:
    return bytes(int(frame, 8) for frame in text.split())


BODY = """
102 000 102 000 000 001 000 002 072 000 071 000 074 002 000 003 000 004 000 005 012 000 012 000
012 000 000 007 002 013 002 013 000 001 000 002 004 035 000 000 102 032 000 006 103 000 000 007
104 000 000 010 012 000 012 051
"""
FORMAT_BIN = bytes(1) + LEADER + octal(BODY) + LEADER
"""A tape that PAL III (DEC-08-ASB1) punched, start-up frame and all; its last two frames are the checksum."""

FORMAT_WORDS = {
    0o200: 0o0001, 0o201: 0o0002, 0o202: 0o7200, 0o203: 0o7100, 0o204: 0o7402, 0o205: 0o0003, 0o206: 0o0004,
    0o207: 0o0005, 0o210: 0o1200, 0o211: 0o1200, 0o212: 0o1200, 0o213: 0o0007, 0o214: 0o0213, 0o215: 0o0213,
    0o216: 0o0001, 0o217: 0o0002, 0o220: 0o0435, 0o221: 0o0000,
    0o232: 0o0006, 0o300: 0o0007, 0o400: 0o0010, 0o401: 0o1200,
}  # fmt: skip
"""What that program's own listing, of pass 3, says of it."""


def refused(read: Callable[[bytes], object], tape: bytes) -> TapeError | None:
    """Return the error with which `read` refuses the tape, or None."""
    try:
        read(tape)
    except TapeError as error:
        return error
    return None
