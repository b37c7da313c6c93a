"""`pdp8 panel` as it is typed: what it wants, and what it says where it cannot be."""

import re
import sys
from collections.abc import Sequence
from pathlib import Path

import pytest

from tests.commands import BIN, Terminal
from tests.conftest import Call, Shell, assert_same_tape


@pytest.mark.parametrize(
    ("options", "status", "said"),
    [
        ("", 1, "pdp8 panel: the panel needs a terminal; `pdp8 run` works without one\n"),
        ("--kiosk", 2, "--kiosk means nothing without --drill"),
        ("eia.pal --drill rim", 2, "goes with no PROGRAM"),
    ],
)
def test_it_wants_a_terminal_and_options_that_go_together(
    options: str, status: int, said: str, call: Call
) -> None:
    done, out, error = call(f"pdp8 panel {options}")
    assert (done, out, said in error) == (status, "", True)


Step = tuple[bytes, bytes]
"""What is to be seen on the terminal since the last step, and the keys that are pressed then."""


def at_a_terminal(
    *arguments: str, steps: Sequence[Step] = (), before: str = "", folder: Path = BIN
) -> tuple[int, bytes]:
    """Run `pdp8 panel` at a terminal, Python `before` it; take the steps; return status and output."""
    code = f"{before}\nimport sys; from pdp8.cli import main; sys.argv[0] = 'pdp8'; main()"
    terminal = Terminal(
        *(sys.executable, "-c", code, "panel", *arguments), folder=folder, TERM="xterm-256color", LINES="30"
    )
    seen = b""
    for shown, keys in steps:
        seen += terminal.until(shown)
        terminal.type(keys)
    status = terminal.ended()
    return status, seen + terminal.seen


def test_a_tape_is_translated_at_a_terminal(shell: Shell, tmp_path: Path) -> None:
    """The tape lies in the reader for a while before START; no frame of it is lost."""
    pytest.importorskip("textual", reason="Textual, the extra `panel`, is not installed")
    (tmp_path / "three.asc").write_bytes(b"\xb3\x8d\x8a")
    done = shell("pdp8 run eia.pal --reader three.asc --punch run.eia")
    assert done.returncode == 0, done.stderr
    status, seen = at_a_terminal(
        *("eia.pal", "--reader", "three.asc"),
        steps=[
            (b"STOP \xc2\xb7 three.asc", b"ppp"),
            (b"1000", b"s"),
            (b"out of tape", b"w"),
            (b"punched.tape", b"panel.eia\r"),
            (b"frames", b"\x03"),
            (b"stopped before", b"q"),
        ],
        folder=tmp_path,
    )
    assert status == 0, seen[-2000:]
    assert b"Traceback" not in seen
    assert b"MEMORY ADDRESS" in seen
    assert_same_tape((tmp_path / "panel.eia").read_bytes(), (tmp_path / "run.eia").read_bytes())


def test_without_textual_it_says_how_to_get_it() -> None:
    status, seen = at_a_terminal(before="import sys; sys.modules['textual'] = None")
    assert status == 1
    assert re.fullmatch(r'pdp8 panel: the panel needs Textual: .*install .*\[panel\]"', seen.decode().strip())


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (("no.pal",), "pdp8 panel: no.pal: no such file"),
        (("eia.pal", "--reader", "no.asc"), "pdp8 panel: no.asc: no such file"),
        (("circle.eia",), "pdp8 panel: circle.eia: "),
        (("/",), "pdp8 panel: /: Is a directory"),
    ],
)
def test_what_cannot_be_loaded_is_named(arguments: tuple[str, ...], said: str) -> None:
    status, seen = at_a_terminal(*arguments)
    assert status == 1
    assert seen.decode().startswith(said)
    assert b"Traceback" not in seen
