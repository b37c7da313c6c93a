"""Commands run as a user runs them: in a folder, ours first on the PATH; to their end, or at a terminal.

run("pdp8", "nc", "cut", "circle.eia")        to its end
start("pdp8", "run", "echo.pal")              goes on; the test reads, signals and waits
shell("pdp8 part circle | pdp8 run eia.pal")  a line for bash (the fixture of conftest.py)
Terminal("pdp8", "run", "echo.pal")           at a terminal of its own
"""

import os
import re
import select
import subprocess
import sys
import sysconfig
import time
from collections.abc import Callable
from pathlib import Path
from typing import IO

import pytest

BIN = Path(sysconfig.get_path("scripts"))
LONGEST, PATIENCE = 300, 30
"""Seconds in which a command ends, and in which one that goes on shows what a test waits for."""

Word = str | Path
Done = subprocess.CompletedProcess[bytes]
Stream = int | IO[bytes]

STARTED: list["subprocess.Popen[bytes]"] = []
"""What the test that runs has started: conftest.py ends it, should the test fail before."""


def environment(**variables: str) -> dict[str, str]:
    """Return the environment of a command: ours, with `variables`."""
    path = f"{BIN}{os.pathsep}{os.environ['PATH']}"
    return {**os.environ, "PATH": path, "COLUMNS": "100", **variables}


def run(*words: Word, stdin: bytes = b"", folder: Path | None = None, **variables: str) -> Done:
    pipe = subprocess.PIPE
    run = start(*words, folder=folder, stdin=pipe, stdout=pipe, stderr=pipe, **variables)
    out, said = run.communicate(stdin, timeout=LONGEST)
    return Done(run.args, run.returncode, out, said)


def start(
    *words: Word,
    folder: Path | None = None,
    stdin: Stream = subprocess.DEVNULL,
    stdout: Stream = subprocess.PIPE,
    stderr: Stream = subprocess.PIPE,
    **variables: str,
) -> "subprocess.Popen[bytes]":
    given = [str(word) for word in words]
    outside = environment(**variables)
    run = subprocess.Popen(given, stdin=stdin, stdout=stdout, stderr=stderr, cwd=folder, env=outside)
    STARTED.append(run)
    return run


def signalled(run: "subprocess.Popen[bytes]", number: int) -> tuple[int, bytes]:
    """Send a signal to a command; return its exit status and what it said on standard error."""
    run.send_signal(number)
    said = run.communicate(timeout=20)[1]
    return run.returncode, said


def eventually(condition: Callable[[], object]) -> bool:
    """Wait until `condition` holds; return whether it did in time."""
    end = time.monotonic() + PATIENCE
    while not condition():
        if time.monotonic() > end:
            return False
        time.sleep(0.02)
    return True


_ESCAPE = re.compile(rb"\x1b\[[\d;?]*[ -~]")
_CONTROLLING = """
import fcntl, os, sys, termios
os.setsid()
fcntl.ioctl(0, termios.TIOCSCTTY, 0)
os.execvp(sys.argv[1], sys.argv[1:])
"""
"""Makes standard input the controlling terminal, so that Ctrl-C there is a signal; then the command."""


class Terminal:
    """A command at a terminal of its own; `seen` is what it has shown since `until` returned."""

    def __init__(self, *words: Word, folder: Path | None = None, **variables: str) -> None:
        pty, termios = pytest.importorskip("pty"), pytest.importorskip("termios")
        self.file, terminal = pty.openpty()
        self.before = termios.tcgetattr(self.file)
        self.seen = b""
        line = sys.executable, "-c", _CONTROLLING, *words
        variables = {"TERM": "dumb", **variables}
        self.process = start(
            *line, folder=folder, stdin=terminal, stdout=terminal, stderr=terminal, **variables
        )
        os.close(terminal)

    def until(self, text: bytes) -> bytes:
        """Read until `text` appears, escape sequences left out unless it has one; return all since the last
        time.
        """

        def shown() -> bool:
            return text in (self.seen if b"\x1b" in text else _ESCAPE.sub(b"", self.seen))

        self._read(shown)
        assert shown(), self.seen
        seen, self.seen = self.seen, b""
        return seen

    def type(self, keys: bytes) -> None:
        os.write(self.file, keys)

    def restored(self) -> bool:
        """Return whether the terminal has the modes it had before."""
        import termios

        return bool(termios.tcgetattr(self.file)[:4] == self.before[:4])

    def ended(self) -> int:
        """Read to the end; return the exit status."""
        self._read(lambda: False)
        return self.process.wait(timeout=5)

    def _read(self, enough: Callable[[], bool]) -> None:
        end = time.monotonic() + PATIENCE
        while not enough() and time.monotonic() < end:
            if select.select([self.file], [], [], 0.1)[0]:
                try:
                    read = os.read(self.file, 65536)
                except OSError:  # Linux: nobody has the terminal open
                    return
                if not read:
                    return
                self.seen += read
