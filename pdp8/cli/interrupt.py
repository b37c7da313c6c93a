"""Ctrl-C as the STOP key: the run ends with an instruction, whole, and says where. A second one ends the
process.
"""

import signal
from collections.abc import Iterator
from contextlib import contextmanager
from types import FrameType


class CtrlC:
    """Whether Ctrl-C was pressed."""

    def __init__(self) -> None:
        self.pressed = False

    def press(self, number: int, frame: FrameType | None) -> None:
        """Take the signal; the second one raises KeyboardInterrupt, for whoever does not look."""
        if self.pressed:
            raise KeyboardInterrupt
        self.pressed = True


@contextmanager
def ctrl_c() -> Iterator[CtrlC]:
    """Note Ctrl-C instead of breaking off at once."""
    noted = CtrlC()
    before = signal.signal(signal.SIGINT, noted.press)
    try:
        yield noted
    finally:
        signal.signal(signal.SIGINT, before)
