"""Where the frames of a punch go as they are punched; at a terminal, the printed page instead."""

import os
import sys
from collections.abc import Iterable
from contextlib import suppress
from typing import BinaryIO

from pdp8 import shelf
from pdp8.cli.shared import command
from pdp8.computer.hardware.teletype import Punch, printed
from pdp8.computer.machine import Machine


class Output:
    """The tape of a punch, `fast` the PC8/L's, on its way into file `name` or to standard output."""

    def __init__(self, machine: Machine, name: str | None, fast: bool = False) -> None:
        self._fast = fast
        self._punch = punch = _punch(machine, fast)
        self._name = name or "standard output"
        self._first = self._sent = len(punch.frames)
        self._gone = False
        self._replaced = name is not None and os.path.isfile(name) and os.path.getsize(name) > 0
        self._page = name is None and sys.stdout.isatty()
        self._stream: BinaryIO = sys.stdout.buffer if self._page else shelf.open_punch(name or "-")

    def close(self) -> None:
        """Close the file; standard output stays open. What `send` could not write is lost."""
        if self._stream is not sys.stdout.buffer:
            with suppress(OSError):
                self._stream.close()

    def tell(self) -> None:
        """Name the file that was written, if every frame is in it."""
        if self._stream is not sys.stdout.buffer and not self._gone:
            command.tell_written(self._name, self._replaced)

    def send(self) -> None:
        """Pass on what was punched since the last time. Raises BrokenPipeError once where nobody reads it."""
        fresh = bytes(self._punch.frames[self._sent :])
        if not fresh or self._gone:
            return
        try:
            self._stream.write(printed(fresh) if self._page else fresh)
            self._stream.flush()
        except BrokenPipeError:
            self._gone = True
            raise
        except OSError as error:
            self._gone = True
            raise shelf.ShelfError(f"{self._name}: {error.strerror} after {self._sent:,} frames") from error
        self._sent += len(fresh)

    def settle(self, machine: Machine) -> None:
        """Make a file the tape that is in the punch of `machine` now, from where the run began.

        In the monitor some of it may have been undone, or taken off, or another machine was restored: then
        its tape is written whole. What has gone down a pipe stays so. Raises ShelfError.
        """
        if self._gone or self._stream is sys.stdout.buffer or not os.path.isfile(self._name):
            self.send()
            return
        punch = _punch(machine, self._fast)
        if punch is not self._punch or len(punch.frames) < self._first:
            self._first = 0
        self._punch, self._sent = punch, self._first
        self._stream.seek(0)
        self.send()
        self._stream.truncate()


def _punch(machine: Machine, fast: bool) -> Punch:
    return machine.highspeed.punch if fast else machine.teletype.punch


def send(outputs: Iterable[Output]) -> None:
    """Pass on what each punch has punched since the last time."""
    for output in outputs:
        output.send()
