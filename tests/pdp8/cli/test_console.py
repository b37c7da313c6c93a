"""The monitor with the Teletype attached, on a pty, to the character."""

import os
import re
import select
import sys
import time
from pathlib import Path

import pytest

pytestmark = pytest.mark.slow("a person at a pty, who looks before typing")

pty = pytest.importorskip("pty", reason="a pty is of POSIX")

_MOST = 60.0
_STYLE = re.compile(rb"\x1b\[[0-9;?]*[A-Za-z]|\x1b[=>]")


class Terminal:
    """A terminal with a command at it."""

    def __init__(self, *command: str) -> None:
        self.process, self.file = pty.fork()
        if self.process == 0:
            os.environ |= {"TERM": "xterm", "XDG_STATE_HOME": "/nowhere"}
            os.execv(
                sys.executable, [sys.executable, "-c", "from pdp8.cli.root import pdp8; pdp8()", *command]
            )
        self.shown = b""

    def read(self, until: str) -> str:
        """Return what is shown as far as `until`, but for cursor movements and empty lines."""
        end = time.monotonic() + _MOST
        while until.encode() not in _STYLE.sub(b"", self.shown):
            assert time.monotonic() < end, self.shown
            if select.select([self.file], [], [], 0.1)[0]:
                self.shown += os.read(self.file, 4096)
                if b"\x1b[6n" in self.shown:  # where is the cursor?
                    self.shown = self.shown.replace(b"\x1b[6n", b"")
                    os.write(self.file, b"\x1b[1;1R")
        before, _, rest = _STYLE.sub(b"", self.shown).partition(until.encode())
        self.shown = rest
        return "\n".join(line for line in before.decode().replace("\r", "").split("\n") if line.strip())

    def type(self, keys: str) -> None:
        time.sleep(1)  # a person looks first
        os.write(self.file, keys.encode())

    def close(self) -> None:
        os.close(self.file)
        os.waitpid(self.process, 0)


@pytest.mark.parametrize("escape", ["\x1d", "\x05"], ids=["Ctrl-]", "Ctrl-E"])
def test_into_the_program_out_and_in_again(escape: str, tmp_path: Path) -> None:
    terminal = Terminal("monitor")
    terminal.read("pdp8>")
    terminal.type("load echo.pal\r")
    terminal.read(" words")
    terminal.read("pdp8>")
    terminal.type("go 200\r")
    terminal.type("HELLO")
    assert terminal.read("HELLO").endswith("go 200")
    terminal.type(escape)
    assert re.search(r"^stop key; [\d.]+ s; next 02", terminal.read("pdp8>"), re.MULTILINE)
    terminal.type("cont\r")
    terminal.type("AGAIN")
    assert terminal.read("AGAIN").endswith("cont")
    terminal.type(escape)
    terminal.read("pdp8>")
    terminal.type("quit\r")
    terminal.close()


def test_the_keyboard_of_run_is_the_same_console() -> None:
    terminal = Terminal("run", "echo.pal", "--keyboard")
    assert terminal.read("monitor.") == "Teletype on line; Ctrl-] stops, and leaves to the "
    terminal.type("AB")
    terminal.read("AB")
    terminal.type("\x1d")
    terminal.read("pdp8>")
    terminal.type("examine 200/2\r")
    terminal.read("0200  6046")
    terminal.type("c\r")
    terminal.type("CD")
    terminal.read("CD")
    terminal.type("\x1d")
    terminal.read("pdp8>")
    terminal.type("exit\r")
    terminal.close()
