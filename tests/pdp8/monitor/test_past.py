"""`back` at the prompt: in every measure, to every event, and what cannot be undone."""

import pytest

from pdp8.monitor.prompt import Monitor
from tapes import ascii
from tapes.errors import WorkError
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


@pytest.mark.parametrize(
    ("line", "complaint"),
    [
        ("back 3 inches", "inches: there are instructions, cycles, characters, blocks and seconds"),
        ("back 777777777777", "instructions cannot be undone: the history goes back"),
        ("back 1000000000000", "not between 000000000000 and 777777777777"),
        ("back 8", "8: neither an octal number"),
        ("back 100 characters", "64 characters cannot be undone: the history goes back 7"),
        ("back until", "expected"),
        ("back until 7000 written", "nothing was written at 7000 as far as the history goes back"),
        ("back until 7000", "nothing was executed at 7000"),
        ("back until 100 flag", "100: not between 00 and 77"),
        ("back until 01 flag", "device 01 is not fitted"),
    ],
)
def test_what_cannot_be_undone_is_said_and_nothing_changes(
    monitor: Monitor, line: str, complaint: str
) -> None:
    stands = monitor.machine.instructions, monitor.machine.teletype.punch.tape
    with pytest.raises(WorkError, match=complaint):
        do(monitor, line)
    assert (monitor.machine.instructions, monitor.machine.teletype.punch.tape) == stands
