"""`back` at the prompt: in every measure, to every event."""

import pytest

from pdp8.monitor.prompt import Monitor
from tapes import ascii
from tests.pdp8.monitor import do


@pytest.fixture(autouse=True)
def translated(monitor: Monitor) -> None:
    """Two lines have been translated."""
    do(monitor, "load eia.pal")
    monitor.operator.mount("two lines", ascii.encode("12\n34\n"))
    do(monitor, "go 200")


@pytest.mark.parametrize(
    ("line", "left"),
    [
        ("back 1 character", b"\0\1\2\x80\x13\4"),
        ("back 2 characters", b"\0\1\2\x80\x13"),
        ("back 1 block", b"\0\1\2\x80\x13\4"),
        ("back 2 blocks", b"\0\1\2"),
        ("back 1.3 second", b"\0\1\2\x80"),
    ],
)
def test_back_in_each_measure(monitor: Monitor, line: str, left: bytes) -> None:
    do(monitor, line)
    assert monitor.machine.teletype.punch.tape == left
    do(monitor, "cont")
    assert monitor.machine.teletype.punch.tape == b"\0\1\2\x80\x13\4\x80"


def test_counts_are_octal_and_steps_go_back_too(monitor: Monitor) -> None:
    before = monitor.machine.instructions
    do(monitor, "step 12")
    assert monitor.machine.instructions == before + 10
    do(monitor, "back 2", "back")
    assert monitor.machine.instructions == before + 7
    do(monitor, "back 7")
    assert monitor.machine.instructions == before


def test_back_until(monitor: Monitor) -> None:
    do(monitor, "back until CHK+1", "assert pc 230", "back until HOLD written", "assert pc 205")
    do(monitor, "back until 4 flag")
    assert monitor.machine.teletype.transmitter.flag == 1
