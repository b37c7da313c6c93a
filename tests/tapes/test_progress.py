"""The bar on long work: at a terminal, after a second, and gone when the work is done."""

import io
import signal
import time
from collections.abc import Callable

import pytest

from tapes import command
from tapes.progress import Bar, Busy
from tests.commands import Terminal


class Screen(io.StringIO):
    """Standard error at a terminal, or not."""

    def __init__(self, terminal: bool) -> None:
        super().__init__()
        self._terminal = terminal

    def isatty(self) -> bool:
        return self._terminal


@pytest.fixture
def clock(monkeypatch: pytest.MonkeyPatch) -> list[float]:
    """The time, in seconds, which the test sets."""
    now = [100.0]
    monkeypatch.setattr("tapes.progress.time.monotonic", lambda: now[0])
    return now


def screen(monkeypatch: pytest.MonkeyPatch, terminal: bool = True) -> Screen:
    shown = Screen(terminal)
    monkeypatch.setattr("sys.stderr", shown)
    monkeypatch.setenv("TERM", "xterm")
    return shown


def test_it_appears_after_a_second_and_says_how_far_the_work_is(
    monkeypatch: pytest.MonkeyPatch, clock: list[float]
) -> None:
    shown = screen(monkeypatch)
    with Bar("reading tape", 8) as bar:
        clock[0] += 0.5
        bar.show(1)
        assert shown.getvalue() == ""
        clock[0] += 0.5
        assert list(bar.along("four")) == list("four")
    assert "reading tape" in shown.getvalue()
    assert "50%" in shown.getvalue()
    assert shown.getvalue().endswith("\x1b[1A\x1b[2K")  # the line is erased


@pytest.mark.parametrize(
    ("terminal", "wanted", "total"), [(False, True, 8), (True, False, 8), (True, True, 0)]
)
def test_it_stays_away(
    terminal: bool, wanted: bool, total: int, monkeypatch: pytest.MonkeyPatch, clock: list[float]
) -> None:
    shown = screen(monkeypatch, terminal)
    with Bar("reading tape", total, wanted) as bar:
        clock[0] += 5
        bar.show(4)
    assert shown.getvalue() == ""


@pytest.mark.parametrize(("terminal", "wanted"), [(True, True), (False, True), (True, False)])
def test_work_without_steps_shows_one_that_moves(
    terminal: bool, wanted: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    started: list[float] = []

    class Timer:
        def __init__(self, delay: float, show: Callable[[], None]) -> None:
            started.append(delay)
            self.start = show

        def cancel(self) -> None:
            started.append(-1)

        def join(self) -> None:
            started.append(-2)

    monkeypatch.setattr("threading.Timer", Timer)
    shown = screen(monkeypatch, terminal)
    with Busy("reading it", wanted):
        assert ("reading it" in shown.getvalue()) == (terminal and wanted)
    assert started == ([1, -1, -2] if terminal and wanted else [])
    assert shown.getvalue().endswith("\x1b[1A\x1b[2K" if terminal and wanted else "")


def test_a_run_shows_it_and_ctrl_c_takes_it_away() -> None:
    line = "pdp8 run eia.pal --reader circle.asc --realtime > /dev/null"
    terminal = Terminal("bash", "-c", f"exec {line}", TERM="xterm")
    terminal.until(b"reading tape")
    time.sleep(0.2)
    terminal.process.send_signal(signal.SIGINT)
    assert terminal.ended() == 130
    assert b"interrupted at" in terminal.seen.split(b"\x1b[2K")[-1]


def test_colours_are_a_terminal_s_unless_no_color_is_set(monkeypatch: pytest.MonkeyPatch) -> None:
    bold = "\x1b[1mA\x1b[0m"
    for no_color, color, said in (("", None, bold), ("1", None, "A"), ("1", True, bold)):
        monkeypatch.setenv("NO_COLOR", no_color)
        shown = screen(monkeypatch)
        command.tell(bold, styled=True, color=color)
        assert shown.getvalue() == f"{said}\n"
