"""The tapes for the Teletype's reader: files read whole, a pipe frame by frame as it comes.

A run asks for frames when the reader is to read one and has none. So a slow pipe makes the run wait and
changes nothing else: the machine's time is that of the whole tape.
"""

import os
import select
import stat
import sys
from collections.abc import Callable
from io import UnsupportedOperation

from pdp8 import shelf
from pdp8.cli.shared import command
from pdp8.computer.hardware.teletype import Reader, Receiver
from tapes import codes
from tapes.errors import called
from tapes.frames import has_leader
from tapes.quantities import counted

_LOOK = 0.2  # seconds between two looks for Ctrl-C while a pipe is silent
_PIECE = 1 << 16


class Feed:
    """Tapes for `reader`, put in in turn; while a pipe is silent `idle` tells whether to give up."""

    def __init__(self, reader: Reader, names: list[str], quiet: bool = False) -> None:
        self.idle: Callable[[], bool] = lambda: False
        self._reader = reader
        self.names = names
        """The tapes that are not yet put in."""
        self._quiet = quiet
        self._file = -1
        self._name = ""
        self._passed = 0
        self._looked = not names
        self._awaited: bytes | None = None
        """What a silent pipe had given when `idle` gave up."""

    @property
    def read(self) -> int:
        """How many frames were read of all tapes."""
        return self._passed + self._reader.position

    def next_tape(self) -> bool:
        """Put the next tape in. Returns False if there is none. Raises ShelfError."""
        if not self.names:
            return False
        name = self._name = self.names.pop(0)
        self._passed += self._reader.position
        self._file = _pipe(name)
        self._reader.load(b"" if self._file >= 0 else shelf.read(name))
        if self._file >= 0:
            self._reader.more = self._more
            self._reader.device.look()
        else:
            self._warn(self._reader.tape)
        return True

    def resume(self, reader: Reader) -> bool:
        """Wait again for the pipe that `idle` gave up, if it still is what `reader` has; return whether."""
        if reader is not self._reader or reader.tape != self._awaited:
            return False
        self._awaited = None
        reader.more = self._more
        reader.device.look()
        return True

    @property
    def left(self) -> str:
        """The tapes that were never put in."""
        return ", ".join(map(called, self.names))

    def look(self, halted: bool) -> None:
        """Say once that the first frame came in unused: START sets READER RUN before a program clears it."""
        reader, receiver = self._reader, self._reader.device
        if self._looked or reader.position != 1 or not isinstance(receiver, Receiver):
            return
        if receiver.flag or (halted and receiver.step < receiver.edge):
            self._looked = True
            if self._quiet or has_leader(reader.tape):
                return
            command.say(
                f"the first frame of {called(self._name)} came in with START, before the program asked; "
                "a program that clears the reader first loses it. A tape with leader loses none: "
                "pdp8 tape punch --leader 100"
            )

    def announce_next(self) -> bool:
        """Put the next tape in and say so."""
        if not self.next_tape():
            return False
        if not self._quiet:
            after = counted(self._passed, "frames")
            command.say(f"{called(self._name)} goes into the reader after {after}")
        return True

    def _more(self) -> bytes:
        """Wait for the pipe's next frames and return them; none at its end, or where `idle` gives up."""
        try:
            while not select.select([self._file], [], [], 0)[0]:
                if self.idle():
                    self._awaited = self._reader.tape
                    return b""
                select.select([self._file], [], [], _LOOK)
            frames = os.read(self._file, _PIECE)
            if len(self._reader.tape) + len(frames) > shelf.LARGEST:
                raise shelf.ShelfError(
                    f"{called(self._name)}: longer than {shelf.LARGEST:,} frames, the most of a tape"
                )
            if not self._reader.tape:
                self._warn(frames)
            return frames
        except OSError:
            return b""

    def _warn(self, tape: bytes) -> None:
        """Warn about what the tape's owner may not expect."""
        if not self._quiet and (doubt := codes.recognise(tape).doubt(tape)):
            command.say(f"{called(self._name)} {doubt}")


def say_unread() -> None:
    """Say that standard input was not read because the restored machine has its own tape."""
    if _unread():
        command.say(
            "standard input was not read: a restored machine goes on with the tape in its reader; "
            "--reader - takes standard input instead"
        )


def _unread() -> bool:
    """Tell whether standard input is a file or a pipe that holds frames which nobody has read."""
    if sys.platform == "win32":
        return False
    import fcntl
    import termios

    try:
        number = sys.stdin.fileno()
        count = fcntl.ioctl(number, termios.FIONREAD, bytes(4))
    except (OSError, UnsupportedOperation):
        return False
    return not os.isatty(number) and any(count)


def _pipe(name: str) -> int:
    """Return the file number of a pipe, -1 for a tape that is read whole, as all are on Windows."""
    if sys.platform == "win32":
        return -1
    if name == "-":
        try:
            number = sys.stdin.fileno()
        except UnsupportedOperation:  # a stream of Python's own, as in a browser
            return -1
    else:
        path = shelf.find(name)
        if os.path.isfile(path) or os.path.isdir(path):
            return -1
        with shelf.failing(name):
            number = os.open(path, os.O_RDONLY)
    return -1 if stat.S_ISREG(os.fstat(number).st_mode) else number
