"""What eia.pal punches of a part's ASCII tape, without running it: a blank, then the digits, a space as 0."""

from tapes import ascii, eia


def translation(frames: bytes) -> bytes:
    """Return the EIA tape of an ASCII tape of blocks."""
    return b"\0" + eia.encode(ascii.decode(frames).replace(" ", "0"))
