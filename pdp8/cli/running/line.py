"""The Teletype as a real line: a serial port or a pty, at 110 baud's pace.

What comes over the line is its keyboard and its reader, frame by frame and unchanged; what the program
prints or punches goes out. RTS follows READER RUN where the line has modem signals, so that a reader at the
other end can wait for it.
"""

import fcntl
import os
import select
import struct
import sys
import termios
import time
import tty
from collections.abc import Callable
from contextlib import suppress

from pdp8.cli.running import pacing
from pdp8.cli.shared import command
from pdp8.computer.machine import Machine
from pdp8.computer.stop import Stop
from pdp8.shelf import ShelfError

assert sys.platform != "win32"  # `pdp8 run` says so before it comes here


class Line:
    """A line at `path`, raw, at 110 baud where it has a speed, until it is closed."""

    def __init__(self, path: str) -> None:
        try:
            self._file = os.open(path, os.O_RDWR | os.O_NOCTTY | os.O_NONBLOCK)
        except OSError as error:
            raise ShelfError(f"{path}: {error.strerror}") from error
        if not os.isatty(self._file):
            os.close(self._file)
            raise ShelfError(f"{path}: not a line: a serial port or a pty is needed")
        self._path = path
        self._before = termios.tcgetattr(self._file)
        tty.setraw(self._file)
        settings = termios.tcgetattr(self._file)
        settings[2] |= termios.CSTOPB
        settings[4] = settings[5] = termios.B110
        with suppress(termios.error):
            termios.tcsetattr(self._file, termios.TCSANOW, settings)
        self._modem = True
        self._gone = False

    def close(self) -> None:
        """Put the line back as it was."""
        with suppress(termios.error, OSError):
            termios.tcsetattr(self._file, termios.TCSADRAIN, self._before)
        os.close(self._file)

    def run(self, machine: Machine, max_time: float | None, pass_on: Callable[[], object]) -> Stop | None:
        """Run at the pace of 1971 until the program halts; return how it ended, None if interrupted."""
        machine.teletype.printer.on_frame = self._send
        with pacing.ctrl_c() as interrupt:

            def take(seconds: float) -> bytes:
                if interrupt.pressed:
                    machine.stop()
                self._reader_run(bool(machine.teletype.receiver.reader_run))
                return self._received(seconds)

            stop = pacing.live(machine, max_time, pass_on, take)
        return None if interrupt.pressed else stop

    def _received(self, seconds: float) -> bytes:
        """Return what comes over the line, waiting at most `seconds` for it."""
        if not select.select([self._file], [], [], seconds)[0]:
            return b""
        frames = b""
        with suppress(OSError):
            frames = os.read(self._file, 256)
        if not frames:
            self._say_gone()
            time.sleep(seconds)
        return frames

    def _say_gone(self) -> None:
        """Say once that nobody is at the other end."""
        if not self._gone:
            command.say(f"{self._path}: nobody is at the other end; the machine goes on, Ctrl-C stops it")
        self._gone = True

    def _send(self, frame: int) -> None:
        """Send one frame; a line that takes none for a second has lost it."""
        with suppress(OSError):
            if select.select([], [self._file], [], 1.0)[1]:
                os.write(self._file, bytes([frame]))

    def _reader_run(self, on: bool) -> None:
        """Let RTS follow READER RUN, as far as the line has such a signal."""
        if not self._modem:
            return
        try:
            request = termios.TIOCMBIS if on else termios.TIOCMBIC
            fcntl.ioctl(self._file, request, struct.pack("I", termios.TIOCM_RTS))
        except OSError:
            self._modem = False
