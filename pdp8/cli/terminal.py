"""A terminal key by key, on every system: prompt_toolkit's raw mode, asked for what was typed.

A key that a Model 33 has not (an arrow, F1) types nothing. The terminal is put back as it was, however the
program ends.
"""

import signal
import sys
import time
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from types import FrameType

from prompt_toolkit.input import Input, create_input
from prompt_toolkit.key_binding import KeyPress

_LOOK = 0.01  # seconds between two looks at the keys
_SIGNALS = ("SIGTERM", "SIGHUP")  # Windows has no SIGHUP


class Terminal:
    """The terminal at standard input, or `keys`, once `raw` is entered."""

    def __init__(self, keys: Input | None = None) -> None:
        self._keys = keys or create_input()

    @contextmanager
    def raw(self) -> Iterator[None]:
        """Take every key as it is typed, Ctrl-C too, and show none."""
        names = [name for name in _SIGNALS if hasattr(signal, name)]
        before = {name: signal.signal(getattr(signal, name), _end) for name in names}
        try:
            with self._keys.raw_mode():
                yield
        finally:
            for name, handler in before.items():
                signal.signal(getattr(signal, name), handler)

    @property
    def closed(self) -> bool:
        """Whether the terminal is gone."""
        return self._keys.closed

    def typed(self, seconds: float) -> str:
        """Return what is typed, waiting at most `seconds` for a key."""
        end = time.monotonic() + seconds
        while True:
            text = characters([*self._keys.read_keys(), *self._keys.flush_keys()])
            left = end - time.monotonic()
            if text or self.closed or left <= 0:
                return text
            time.sleep(min(_LOOK, left))


def characters(presses: Iterable[KeyPress]) -> str:
    """Return the characters of key presses; Backspace is 177 on every system."""
    typed = "".join(press.data for press in presses if len(press.data) == 1)
    return typed.replace("\b", "\x7f") if sys.platform == "win32" else typed


def _end(number: int, frame: FrameType | None) -> None:
    sys.exit(128 + number)
