"""Signals that ask a program to end, and who takes them."""

import signal
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any

ENDS = "SIGTERM", "SIGHUP"
"""Ends the program, and says that its terminal was closed."""


def heard(*names: str) -> list[int]:
    """Return the signals of these names: Windows lacks some, and `nohup` or a script's `&` ignores some."""
    numbers = [getattr(signal, name) for name in names if hasattr(signal, name)]
    return [number for number in numbers if signal.getsignal(number) is not signal.SIG_IGN]


@contextmanager
def taken(act: Callable[[int, Any], object], *names: str) -> Iterator[None]:
    """Let `act` take the signals of these names, as `signal.signal` has it, and put back who took them."""
    before = {number: signal.signal(number, act) for number in heard(*names)}
    try:
        yield
    finally:
        for number, handler in before.items():
            signal.signal(number, handler)
