"""The terminal key by key: prompt_toolkit's raw mode on a pipe, and what differs on Windows."""

import sys
import time
from collections.abc import Iterator

import pytest
from click.testing import CliRunner
from prompt_toolkit.input import PipeInput, create_pipe_input
from prompt_toolkit.key_binding import KeyPress
from prompt_toolkit.keys import Keys

from pdp8.cli.run import run
from pdp8.cli.running.feed import Feed
from pdp8.cli.running.keyboard import characters, typed
from pdp8.computer.machine import Machine
from pdp8.computer.use.keys import sent


@pytest.fixture
def keys() -> Iterator[PipeInput]:
    """What is typed comes from here."""
    with create_pipe_input() as pipe:
        yield pipe


@pytest.mark.parametrize(
    ("sequence", "frames"),
    [("a", "301"), ("\r", "215"), ("\x7f", "377"), ("\x1b", "375"), ("\x1b[A", ""), ("\x1bOP", "")],
)
def test_a_key_sends_what_the_table_says(keys: PipeInput, sequence: str, frames: str) -> None:
    keys.send_text(sequence)
    seen = typed(keys, 1 if frames else 0.05)
    assert " ".join(f"{frame:03o}" for frame in sent(seen)) == frames


def test_typing_waits_no_longer_than_it_may_and_not_for_a_closed_terminal(keys: PipeInput) -> None:
    for seconds in (0.05, 5.0):
        began = time.monotonic()
        assert typed(keys, seconds) == ""
        assert (seconds == 0.05) * seconds <= time.monotonic() - began < 5
        keys.close()


def test_backspace_is_rubout_on_windows_too(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sys, "platform", "win32")
    presses = [KeyPress(Keys.ControlH, "\b"), KeyPress("x", "x"), KeyPress(Keys.Up, "")]
    assert characters(presses) == "\x7fx"


def test_windows_reads_a_tape_whole(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sys, "platform", "win32")
    reader = Machine().teletype.reader
    assert Feed(reader, ["circle.asc"]).next_tape()
    assert len(reader.tape) == 17982


def test_windows_has_no_line(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sys, "platform", "win32")
    ran = CliRunner().invoke(run, ["hello.pal", "--line", "COM1"])
    assert ran.exit_code == 2
    assert "--line needs the serial lines" in ran.output
