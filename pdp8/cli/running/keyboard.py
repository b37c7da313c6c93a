"""A terminal as the Teletype: what is typed is its keyboard (see computer/use/keys), what it prints the page.

A Model 33 prints nothing by itself. Ctrl-] leaves to the monitor, with the machine as it stands. A key
that a Model 33 lacks (an arrow, F1) types nothing. However the program ends, the terminal (prompt_toolkit's
on every system) is put back as it was.
"""

import sys
import time
from collections.abc import Callable, Iterable

import click
from prompt_toolkit.input import Input, create_input
from prompt_toolkit.key_binding import KeyPress

from pdp8.cli.running import pacing
from pdp8.cli.shared import command
from pdp8.computer.hardware.teletype import printed
from pdp8.computer.machine import Machine
from pdp8.computer.stop import Stop
from pdp8.computer.use.keys import sent
from pdp8.computer.use.trace import Listing

ESCAPE = "\x1d"
_LOOK = 0.01  # seconds between two looks at the keys


def sit_down(
    machine: Machine, listing: Listing, max_time: float | None, realtime: bool, pass_on: Callable[[], object]
) -> Stop | None:
    """Run with the terminal as the Teletype until the machine stops or Ctrl-] is typed.

    `pass_on` is called after each slice of the run. Returns how the run ended, or None after the monitor.
    """
    keys = create_input()

    def take(seconds: float) -> bytes | None:
        text = typed(keys, seconds)
        return None if ESCAPE in text or keys.closed else sent(text)

    machine.teletype.printer.on_frame = _Page().print
    try:
        with keys.raw_mode():
            click.echo("Teletype on line; Ctrl-] leaves to the monitor.\r", err=True)
            stop = pacing.live(machine, max_time, pass_on, take, realtime)
    finally:
        machine.teletype.printer.on_frame = None
        command.tell("")
    if stop is None:
        from pdp8.cli.monitor import converse
        from pdp8.monitor.prompt import Monitor

        converse(Monitor(command.echo, machine, listing))
    return stop


def typed(keys: Input, seconds: float) -> str:
    """Return what is typed, waiting at most `seconds` for a key."""
    end = time.monotonic() + seconds
    while True:
        text = characters([*keys.read_keys(), *keys.flush_keys()])
        left = end - time.monotonic()
        if text or keys.closed or left <= 0:
            return text
        time.sleep(min(_LOOK, left))


def characters(presses: Iterable[KeyPress]) -> str:
    """Return the characters of key presses; Backspace is 177 on every system."""
    text = "".join(press.data for press in presses if len(press.data) == 1)
    return text.replace("\b", "\x7f") if sys.platform == "win32" else text


class _Page:
    """The terminal as the page: a line feed goes straight down, as on a Model 33."""

    def __init__(self) -> None:
        self._column = 0

    def print(self, frame: int) -> None:
        """Print a frame as a Model 33 does."""
        character = printed(bytes([frame])).decode()
        if character == "\r":
            self._column = 0
        elif character >= " ":
            self._column += 1
        elif character == "\n" and self._column:  # a terminal may return the carriage too
            character = f"\n\x1b[{self._column + 1}G"
        sys.stdout.write(character)
        sys.stdout.flush()
