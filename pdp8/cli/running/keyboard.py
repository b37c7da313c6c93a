"""A terminal as the Teletype: what is typed is its keyboard (see computer/use/keys), what it prints the page.

A Model 33 prints nothing by itself. Ctrl-], or Ctrl-E, is STOP and leaves to the monitor, whose `cont` comes
back. A key that a Model 33 lacks (an arrow, F1) types nothing. However the program ends, the terminal
(prompt_toolkit's on every system) is put back as it was.
"""

import sys
import time
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager

from prompt_toolkit.input import Input, create_input
from prompt_toolkit.key_binding import KeyPress

from pdp8.cli.running import pacing
from pdp8.cli.shared import command
from pdp8.computer.hardware.teletype import Reader, printed
from pdp8.computer.machine import Machine
from pdp8.computer.stop import Reason, Stop
from pdp8.computer.use.keys import sent

ESCAPES = "\x1d\x05"
"""Ctrl-] and, as at SIMH, Ctrl-E."""
_LOOK = 0.01  # seconds between two looks at the keys


class Terminal:
    """A terminal as a machine's Teletype, with messages between its lines; `pass_on` is called each slice."""

    def __init__(self, pass_on: Callable[[], object] = lambda: None) -> None:
        self._pass_on = pass_on
        self._page = _Page()
        self._keys: Input | None = None
        """What is typed at a running machine."""
        self._typed = ""
        """What was typed while a tape was awaited."""
        self.resume: Callable[[Reader], bool] = lambda reader: False
        """Waits for further frames of the tape in the reader, if it has not ended."""

    def asked(self) -> bool:
        """Whether something is typed at the running machine."""
        if self._keys is not None and not self._typed:
            self._pass_on()
            self._typed = typed(self._keys, 0)
        return self._keys is not None and (bool(self._typed) or self._keys.closed)

    def run(
        self,
        machine: Machine,
        max_time: float | None = None,
        realtime: bool = False,
        next_tape: Callable[[], object] = lambda: None,
    ) -> tuple[Stop, bool]:
        """Run until a stop or Ctrl-]; return the stop, and whether it was Ctrl-]. `next_tape` adds tapes."""
        keys = create_input()

        def take(seconds: float) -> bytes | None:
            reader = machine.teletype.reader
            text, self._typed = self._typed or typed(keys, seconds), ""
            before = min((text.find(escape) for escape in ESCAPES if escape in text), default=-1)
            if before >= 0:
                machine.teletype.keyboard.press(sent(text[:before]))
            elif reader.empty() and not self.resume(reader):
                next_tape()
            return None if before >= 0 or keys.closed else sent(text)

        self._keys, self._typed = keys, ""
        try:
            with self.printing(machine), keys.raw_mode():
                stop = pacing.live(machine, max_time, self._pass_on, take, realtime)
        finally:
            self._keys = None
        if stop is not None:
            return stop, False
        machine.stop()
        return Stop(Reason.STOP_KEY, machine.pc, machine.elapsed), True

    @contextmanager
    def printing(self, machine: Machine) -> Iterator[None]:
        """Print what the machine prints."""
        before, machine.teletype.printer.on_frame = machine.teletype.printer.on_frame, self._page.print
        try:
            yield
        finally:
            machine.teletype.printer.on_frame = before

    def say(self, line: str) -> None:
        """Say a line, below what is printed."""
        self.end_line()
        command.echo(line)

    def end_line(self) -> None:
        """Go to the beginning of a line."""
        if self._page.column:
            command.echo("")
        self._page.column = 0


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
        self.column = 0

    def print(self, frame: int) -> None:
        """Print a frame as a Model 33 does."""
        character = printed(bytes([frame])).decode()
        if character == "\r":
            self.column = 0
        elif character >= " ":
            self.column += 1
        elif character == "\n" and self.column:  # a terminal may return the carriage too
            character = f"\n\x1b[{self.column + 1}G"
        sys.stdout.write(character)
        sys.stdout.flush()
