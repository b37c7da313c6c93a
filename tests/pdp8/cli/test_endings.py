"""A command at a terminal ends as a signal asks, or as the terminal is closed: with its files, never raw."""

import os
import signal
from pathlib import Path

import pytest

from tests.commands import Terminal, eventually
from tests.pdp8.cli.test_line import WRITES
from tests.pdp8.computer.dectape import reel

COMMANDS = {
    "run": (("run", "echo.pal", "--keyboard", "--punch", "out.tape"), b"Ctrl-]"),
    "monitor": (("monitor",), b"help tells"),
    "panel": (("panel", "eia.pal"), b"MEMORY ADDRESS"),
}
"""Each command that takes a terminal over, and what it shows when it has."""
_MODES = (b"1049", b"1000", b"2004")
"""The second screen, the mouse, brackets around a paste: what is switched on is switched off."""


def _assert_put_back(terminal: Terminal, seen: bytes) -> None:
    assert terminal.restored()
    for mode in _MODES:
        assert seen.rfind(b"\x1b[?" + mode + b"l") >= seen.rfind(b"\x1b[?" + mode + b"h"), mode
    assert seen.rfind(b"\x1b[?25h") >= seen.rfind(b"\x1b[?25l"), "the cursor is hidden"
    assert b"Traceback" not in seen


def _assert_ended(terminal: Terminal, closed: bool) -> None:
    """End a command by SIGTERM, or by closing its terminal; its status says which."""
    if closed:
        os.close(terminal.file)
        assert terminal.process.wait(timeout=20) == 128 + signal.SIGHUP
    else:
        terminal.process.send_signal(signal.SIGTERM)
        assert terminal.ended() == 128 + signal.SIGTERM


@pytest.mark.parametrize("name", COMMANDS)
@pytest.mark.parametrize("number", [signal.SIGTERM, signal.SIGHUP, signal.SIGINT, 0])
def test_a_terminal_is_never_left_raw(name: str, number: int, tmp_path: Path) -> None:
    if name == "panel":
        pytest.importorskip("textual", reason="Textual, the extra `panel`, is not installed")
    if name == "monitor" and number == signal.SIGINT:
        pytest.skip("Ctrl-C leaves the line, not the monitor: test_sessions.py")
    words, shown = COMMANDS[name]
    terminal = Terminal("pdp8", *words, folder=tmp_path, TERM="xterm-256color", LINES="30")
    seen = terminal.until(shown)
    assert eventually(lambda: not terminal.restored())
    if name == "run":
        terminal.type(b"ABC")
        assert eventually(lambda: (tmp_path / "out.tape").read_bytes() == b"\xc1\xc2\xc3")
    if number:
        terminal.process.send_signal(number)
        assert terminal.ended() == 128 + number
        seen += terminal.seen
        _assert_put_back(terminal, seen)
    else:
        os.close(terminal.file)
        assert terminal.process.wait(timeout=20) == 128 + signal.SIGHUP
    if name == "run":
        assert (tmp_path / "out.tape").read_bytes() == b"\xc1\xc2\xc3"


@pytest.mark.parametrize("closed", [False, True])
def test_what_the_monitor_has_is_left_as_it_ends(closed: bool, tmp_path: Path) -> None:
    """On a dumb terminal, as Emacs has one: the reel that was written, and what was punched."""
    (tmp_path / "writes.pal").write_text(WRITES)
    (tmp_path / "lines").write_text("attach dt0 a.tu56\nattach ptp out\nload writes.pal\ngo 200\n")
    reel.file(tmp_path / "a.tu56")
    terminal = Terminal("pdp8", "monitor", folder=tmp_path)
    terminal.until(b"pdp8> ")
    terminal.type(b"do lines\r")
    terminal.until(b"AND 0000\r\npdp8> ")
    assert eventually(lambda: not terminal.restored())
    _assert_ended(terminal, closed)
    if not closed:
        assert b"1 block of a.tu56 changed, and not saved: wrote a-changed.tu56" in terminal.seen
    assert {"a-changed.tu56", "out"} <= {path.name for path in tmp_path.iterdir()}


@pytest.mark.parametrize("closed", [False, True])
@pytest.mark.parametrize(("name", "first"), [("monitor", b"\x1b[?2004h"), ("panel", b"\x1b[?1049h")])
def test_it_ends_properly_while_it_takes_the_terminal_over(
    name: str, first: bytes, closed: bool, tmp_path: Path
) -> None:
    if name == "panel":
        pytest.importorskip("textual", reason="Textual, the extra `panel`, is not installed")
    terminal = Terminal("pdp8", *COMMANDS[name][0], folder=tmp_path, TERM="xterm-256color", LINES="30")
    seen = terminal.until(first)
    _assert_ended(terminal, closed)
    if not closed:
        _assert_put_back(terminal, seen + terminal.seen)
