"""The Teletype as a real line: a serial port, a pty or a TCP port, at 110 baud's pace.

What comes over the line is its keyboard and its reader, frame by frame and unchanged; what the program
prints or punches goes out. RTS follows READER RUN where the line has modem signals, so that a reader at the
other end can wait for it.
"""

import fcntl
import os
import re
import select
import socket
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
from pdp8.computer.use.keys import sent
from pdp8.shelf import ShelfError, failing

assert sys.platform != "win32"  # `pdp8 run` says so before it comes here


class Line:
    """A line to somebody at the Teletype: of 7 `bits` as keys and characters, of 8 as frames."""

    def __init__(self, bits: int = 8, full_speed: bool = False) -> None:
        self._bits = bits
        self._full_speed = full_speed

    def run(self, machine: Machine, max_time: float | None, pass_on: Callable[[], object]) -> Stop | None:
        """Run at the pace of 1971 until the program halts; return how it ended, None if interrupted."""
        mask = 0o177 if self._bits == 7 else 0o377
        machine.teletype.printer.on_frame = lambda frame: self.send(frame & mask)
        with pacing.ctrl_c() as interrupt:

            def take(seconds: float) -> bytes:
                if interrupt.pressed:
                    machine.stop()
                self.reader_run(bool(machine.teletype.receiver.reader_run))
                frames = self.received(seconds)
                return sent(self.characters(frames)) if self._bits == 7 else frames

            stop = pacing.live(machine, max_time, pass_on, take, not self._full_speed)
        return None if interrupt.pressed else stop

    def received(self, seconds: float) -> bytes:
        """Return what comes over the line, waiting at most `seconds` for it."""
        raise NotImplementedError

    def characters(self, frames: bytes) -> str:
        """Return the characters of 7 bits that came: the eighth may be a terminal's parity."""
        return bytes(frame & 0o177 for frame in frames).decode("ascii")

    def send(self, frame: int) -> None:
        """Send one frame."""
        raise NotImplementedError

    def reader_run(self, on: bool) -> None:
        """Show whether the reader may move."""

    def close(self) -> None:
        """Leave the line."""
        raise NotImplementedError


class Tcp(Line):
    """A TCP port for one telnet client at a time; frames wait while nobody is connected."""

    def __init__(self, address: str, bits: int, full_speed: bool) -> None:
        super().__init__(bits, full_speed)
        host, _, port = address.rpartition(":")
        if not port.isdecimal() or not 0 < int(port) < 1 << 16:
            raise ShelfError(f"tcp:{address}: tcp:PORT or tcp:ADDRESS:PORT, a port from 1 to 65535")
        self._client: socket.socket | None = None
        self._waiting = bytearray()
        self._telnet = b""
        self._returned = False
        """Whether the last frame was RETURN."""
        host = host or "127.0.0.1"
        bare = host.removeprefix("[").removesuffix("]")
        family = socket.AF_INET6 if ":" in bare else socket.AF_INET
        with failing(f"tcp:{address}"):
            self._server = socket.create_server((bare, int(port)), family=family)
        command.say(f"listens on {host}:{port}, {bits} bits; Ctrl-C stops")

    def close(self) -> None:
        """Close the port, and give who is there five seconds to take the last frames."""
        if self._client is not None:
            with suppress(OSError):
                self._client.settimeout(5)
                self._client.sendall(self._waiting)
        for each in (self._client, self._server):
            if each is not None:
                each.close()

    def characters(self, frames: bytes) -> str:
        """Return the characters of 7 bits; UTF-8's have eight, and no Model 33 has their keys."""
        return frames.decode("latin-1")

    def received(self, seconds: float) -> bytes:
        """Return what the client sends, without the options of telnet."""
        self._pass_on()
        place = self._client or self._server
        if not select.select([place], [], [], seconds)[0]:
            return b""
        if self._client is None:
            self._client, _ = self._server.accept()
            with suppress(OSError):  # it may have left already
                self._client.sendall(_CHARACTER_MODE)
            self._client.setblocking(False)
            self._pass_on()
            return b""
        frames = b""
        with suppress(OSError):
            frames = self._client.recv(256)
        if not frames:
            self._client.close()
            self._client, self._telnet, self._returned = None, b"", False
        return self._without_options(frames)

    def send(self, frame: int) -> None:
        """Send one frame, now or once somebody is there."""
        self._waiting += b"\xff\xff" if frame == _IAC else bytes([frame])
        self._pass_on()

    def _pass_on(self) -> None:
        if self._client is not None:
            with suppress(OSError):
                del self._waiting[: self._client.send(self._waiting)]

    def _without_options(self, frames: bytes) -> bytes:
        """Return the data without telnet's options; an incomplete option waits."""
        rest, found = self._telnet + frames, bytearray()
        while rest:
            option = _OPTION.match(rest)
            if option is None:
                break
            if option[1] and not (self._returned and option[1] == b"\0"):
                found += option[1][:1]
            self._returned = option[1] == b"\r"
            rest = rest[option.end() :]
        self._telnet = rest
        return bytes(found)


_IAC = 0o377
_CHARACTER_MODE = bytes([_IAC, 251, 1, _IAC, 251, 3])
"""WILL ECHO, WILL SUPPRESS GO AHEAD."""
_OPTION = re.compile(
    rb"\xff[\xfb-\xfe].|\xff\xfa(?:[^\xff]|\xff\xff)*\xff\xf0|\xff[\xf1-\xf9]|(\xff\xff|[^\xff])",
    re.DOTALL,
)
"""DO and its like, a subnegotiation, a command; or a frame: IAC is doubled, RETURN may have NUL behind it."""


class Serial(Line):
    """A serial port or a pty at `path`, raw, at 110 baud where it has a speed, until it is closed."""

    def __init__(self, path: str, bits: int, full_speed: bool) -> None:
        super().__init__(bits, full_speed)
        with failing(path):
            self._file = os.open(path, os.O_RDWR | os.O_NOCTTY | os.O_NONBLOCK)
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

    def received(self, seconds: float) -> bytes:
        """Return what comes over the line, waiting at most `seconds` for it."""
        if not select.select([self._file], [], [], seconds)[0]:
            return b""
        frames = b""
        with suppress(OSError):
            frames = os.read(self._file, 256)
        if not frames:
            if not self._gone:
                command.say(f"{self._path}: nobody is at the other end; the machine goes on, Ctrl-C stops it")
            self._gone = True
            time.sleep(seconds)
        return frames

    def send(self, frame: int) -> None:
        """Send one frame; it is lost if the line takes none for a second."""
        with suppress(OSError):
            if select.select([], [self._file], [], 1.0)[1]:
                os.write(self._file, bytes([frame]))

    def reader_run(self, on: bool) -> None:
        """Set RTS to READER RUN, if the line has that signal."""
        if not self._modem:
            return
        try:
            request = termios.TIOCMBIS if on else termios.TIOCMBIC
            fcntl.ioctl(self._file, request, struct.pack("I", termios.TIOCM_RTS))
        except OSError:
            self._modem = False


def opened(name: str, bits: int | None = None, full_speed: bool = False) -> Line:
    """Return the line tcp:PORT or tcp:ADDRESS:PORT, by default of 7 bits; a serial port or pty, of 8."""
    if name.startswith("tcp:"):
        return Tcp(name.removeprefix("tcp:"), bits or 7, full_speed)
    return Serial(name, bits or 8, full_speed)
