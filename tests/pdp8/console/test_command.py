"""`pdp8 panel` as it is typed: what it wants, and what it says where it cannot be."""

import os
import pty
import select
import subprocess
import sys
import time

import pytest

from tests.conftest import BIN, Shell


def test_it_wants_a_terminal(shell: Shell) -> None:
    done = shell("pdp8 panel")
    assert done.returncode == 1
    assert done.stderr == b"pdp8: the panel is drawn on a terminal, and this is none; `pdp8 run` needs none\n"
    assert done.stdout == b""


def at_a_terminal(
    *arguments: str, keys: bytes = b"", hidden: str = "", until: bytes = b""
) -> tuple[int, bytes]:
    """Run `pdp8 panel` at a terminal; press `keys` when `until` is seen; return status and output."""
    code = f"import sys; sys.modules.update({{{hidden!r}: None}} if {hidden!r} else {{}})\n"
    code += "from pdp8.cli import main; sys.argv[0] = 'pdp8'; main()"
    keyboard, terminal = pty.openpty()
    process = subprocess.Popen(
        [sys.executable, "-c", code, "panel", *arguments],
        stdin=terminal,
        stdout=terminal,
        stderr=terminal,
        env={**os.environ, "TERM": "xterm-256color", "COLUMNS": "100", "LINES": "30"},
        cwd=BIN,
    )
    os.close(terminal)
    seen = b""
    end = time.monotonic() + 30
    while time.monotonic() < end:
        if select.select([keyboard], [], [], 0.2)[0]:
            try:
                seen += os.read(keyboard, 65536)
            except OSError:
                break
        if keys and until in seen:
            os.write(keyboard, keys)
            keys = b""
    if process.poll() is None and time.monotonic() >= end:
        process.kill()
    os.close(keyboard)
    return process.wait(), seen


def test_it_opens_at_a_terminal_and_closes() -> None:
    pytest.importorskip("textual", reason="Textual, the extra `panel`, is not installed")
    status, seen = at_a_terminal("eia.pal", keys=b"q", until=b"Teletype")
    assert status == 0
    assert b"MEMORY ADDRESS" in seen
    assert b"Traceback" not in seen


def test_without_textual_it_says_how_to_get_it() -> None:
    status, seen = at_a_terminal(hidden="textual")
    assert status == 1
    assert seen.decode().strip() == "pdp8: the panel needs Textual: pip install 'pdp8[panel]'"


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (("no.pal",), "pdp8: no.pal: no such file"),
        (("eia.pal", "--reader", "no.asc"), "pdp8: no.asc: no such file"),
        (("circle.eia",), "pdp8: circle.eia: "),
        (("/",), "pdp8: /: Is a directory"),
    ],
)
def test_what_cannot_be_loaded_is_named(arguments: tuple[str, ...], said: str) -> None:
    status, seen = at_a_terminal(*arguments)
    assert status == 1
    assert seen.decode().startswith(said)
    assert b"Traceback" not in seen


def test_a_wrong_address_is_misuse() -> None:
    status, seen = at_a_terminal("--start", "8")
    assert status == 2
    assert b"octal" in seen
