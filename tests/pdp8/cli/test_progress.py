"""The bar on long work: at a terminal, after a second, and gone when the work is done."""

import io
import signal
import sys
import time
from collections.abc import Callable
from pathlib import Path
from unittest.mock import Mock

import click
import pytest

from pdp8.cli.running.feed import Feed
from pdp8.cli.running.pacing import _SILENT, _Silence
from pdp8.cli.shared import command
from pdp8.cli.shared.progress import Bar, Busy
from pdp8.computer.hardware.highspeed import HighSpeed
from pdp8.computer.machine import Machine
from tests.commands import Terminal

ERASED = "\x1b[1A\x1b[2K"
Screen = Callable[[bool], io.StringIO]


@pytest.fixture
def screen(monkeypatch: pytest.MonkeyPatch) -> Screen:
    """Return what makes standard error a terminal, or none."""

    def shown(terminal: bool) -> io.StringIO:
        stream = io.StringIO()
        stream.isatty = lambda: terminal  # type: ignore[method-assign]
        monkeypatch.setattr(sys, "stderr", stream)
        monkeypatch.setenv("TERM", "xterm")
        return stream

    return shown


@pytest.fixture
def clock(monkeypatch: pytest.MonkeyPatch) -> list[float]:
    """The time, in seconds, which the test sets."""
    now = [100.0]
    monkeypatch.setattr("pdp8.cli.shared.progress.time.monotonic", lambda: now[0])
    return now


def test_it_appears_after_a_second_and_says_how_far_the_work_is(screen: Screen, clock: list[float]) -> None:
    shown = screen(True)
    with Bar("reading tape", 8) as bar:
        clock[0] += 0.5
        bar.show(1)
        assert shown.getvalue() == ""
        clock[0] += 0.5
        assert list(bar.along("four")) == list("four")
    assert "reading tape" in shown.getvalue()
    assert "50%" in shown.getvalue()
    assert shown.getvalue().endswith(ERASED)


@pytest.mark.parametrize(
    ("terminal", "wanted", "total"), [(False, True, 8), (True, False, 8), (True, True, 0)]
)
def test_it_stays_away(terminal: bool, wanted: bool, total: int, screen: Screen, clock: list[float]) -> None:
    shown = screen(terminal)
    with Bar("reading tape", total, wanted) as bar:
        clock[0] += 5
        bar.show(4)
    assert shown.getvalue() == ""


@pytest.mark.parametrize(("terminal", "wanted"), [(True, True), (False, True), (True, False)])
def test_work_without_steps_shows_one_that_moves(
    terminal: bool, wanted: bool, screen: Screen, monkeypatch: pytest.MonkeyPatch
) -> None:
    timer = Mock()
    monkeypatch.setattr("threading.Timer", timer)
    shown = screen(terminal)
    with Busy("reading it", wanted):
        for delay, show in (call.args for call in timer.call_args_list):
            assert delay == 1
            show()
        assert ("reading it" in shown.getvalue()) == (terminal and wanted)
    ended = ["start", "cancel", "join"] if terminal and wanted else []
    assert [name for name, _, _ in timer.return_value.method_calls] == ended
    assert shown.getvalue().endswith(ERASED if ended else "")


def test_a_command_shows_it_and_ctrl_c_takes_it_away(tmp_path: Path) -> None:
    line = "exec pdp8 run eia.pal --reader circle.asc --realtime > /dev/null"
    terminal = Terminal("bash", "-c", line, folder=tmp_path, TERM="xterm")
    terminal.until(b"reading tape")
    time.sleep(0.2)
    terminal.process.send_signal(signal.SIGINT)
    assert terminal.ended() == 130
    assert b"interrupted" in terminal.seen.split(b"\x1b[2K")[-1]


@pytest.mark.parametrize(("no_color", "shown"), [("", True), ("1", False)])
def test_colours_are_a_terminal_s_unless_no_color_is_set(
    no_color: str, shown: bool, screen: Screen, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("NO_COLOR", no_color)
    said = screen(True)
    command.tell("\x1b[1mA\x1b[0m", styled=True)
    assert said.getvalue() == ("\x1b[1mA\x1b[0m\n" if shown else "A\n")


@pytest.mark.parametrize(("terminal", "wanted"), [(True, True), (False, True), (True, False)])
def test_a_silence_is_said_once_and_begins_again_with_each_frame(
    terminal: bool, wanted: bool, screen: Screen, clock: list[float]
) -> None:
    machine = Machine()
    machine.fit(HighSpeed())
    feed, shown = Feed(machine.teletype.reader, []), screen(terminal)
    silence = _Silence(machine, feed, wanted)
    ways = machine.teletype.punch.frames, machine.highspeed.punch.frames, None
    with click.Context(click.Command("run")):
        for frames in ways:
            for seconds in (0.0, _SILENT):
                clock[0] += seconds
                silence.look()
                assert shown.getvalue() == ""
            if frames is not None:
                clock[0] += 1
                frames.append(0o301)
                silence.look()
                assert shown.getvalue() == ""
        for _ in range(2):
            clock[0] += 0.1
            silence.look()
            assert shown.getvalue().count("nothing is read or punched") == (terminal and wanted)
            clock[0] += _SILENT
