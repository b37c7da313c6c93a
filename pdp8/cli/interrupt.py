"""Ctrl-C as the STOP key: the run ends with an instruction, whole, and says where. A second one ends the
process.
"""

import signal
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from types import FrameType


class CtrlC:
    """Whether Ctrl-C was pressed; `on_press` is called as it is."""

    def __init__(self, on_press: Callable[[], object]) -> None:
        self.pressed = False
        self._on_press = on_press

    def press(self, number: int, frame: FrameType | None) -> None:
        """Take the signal; the second one raises KeyboardInterrupt, for code that does not look."""
        if self.pressed:
            raise KeyboardInterrupt
        self.pressed = True
        self._on_press()


@contextmanager
def ctrl_c(on_press: Callable[[], object] = lambda: None) -> Iterator[CtrlC]:
    """Note Ctrl-C instead of breaking off at once."""
    noted = CtrlC(on_press)
    before = signal.signal(signal.SIGINT, noted.press)
    try:
        yield noted
    finally:
        signal.signal(signal.SIGINT, before)
