"""`back` at the prompt: in every measure, to every event, and what cannot be undone."""

import pytest

from pdp8.computer.use import program
from pdp8.monitor.prompt import Monitor
from tapes import ascii
from tapes.errors import WorkError


@pytest.fixture
def monitor() -> Monitor:
    """A monitor that has translated two lines."""
    made = Monitor(lambda line: None)
    made.machine.load(program.find("eia.pal").words)
    made.listing = program.find("eia.pal").listing
    made.operator.mount("two lines", ascii.encode("12\n34\n"))
    made.do("go 200")
    return made


@pytest.mark.parametrize(
    ("line", "left"),
    [
        ("back 1 character", b"\0\1\2\x80\x13\4"),
        ("back 2 characters", b"\0\1\2\x80\x13"),
        ("back 1 block", b"\0\1\2\x80\x13\4"),
        ("back 2 blocks", b"\0\1\2"),
        ("back 1.3 seconds", b"\0\1\2\x80"),
    ],
)
def test_back_in_each_measure(monitor: Monitor, line: str, left: bytes) -> None:
    monitor.do(line)
    assert monitor.machine.teletype.punch.tape == left
    monitor.do("cont")
    assert monitor.machine.teletype.punch.tape == b"\0\1\2\x80\x13\4\x80"


def test_counts_are_octal_and_steps_go_back_too(monitor: Monitor) -> None:
    before = monitor.machine.instructions
    monitor.do("step 12")
    assert monitor.machine.instructions == before + 10
    monitor.do("back 3")
    assert monitor.machine.instructions == before + 7
    monitor.do("back 7")
    assert monitor.machine.instructions == before


def test_back_until(monitor: Monitor) -> None:
    monitor.do("back until CHK+1")
    assert monitor.machine.pc == 0o230
    monitor.do("back until HOLD written")
    assert monitor.machine.pc == 0o205
    monitor.do("back until 4 flag")
    assert monitor.machine.teletype.transmitter.flag == 1


def test_what_is_expected_is_printed_again_after_back() -> None:
    monitor = Monitor(lambda line: None)
    monitor.machine.load(program.find("hello.pal").words)
    monitor.do("go 200 until WORLD.")
    monitor.do("back 4 characters")
    monitor.do("cont until .")
    monitor.do("back 4 characters")
    monitor.do("expect LD.")


def test_what_was_set_goes_back_too(monitor: Monitor) -> None:
    monitor.do("deposit HOLD 1234")
    monitor.do("set sr 7")
    monitor.do("back 1")
    assert (monitor.machine.core[0o100], monitor.machine.sr) != (0o1234, 7)


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
        ("back until 01 flag", "device 01 is not fitted"),
    ],
)
def test_what_cannot_be_undone_is_said_and_nothing_changes(
    monitor: Monitor, line: str, complaint: str
) -> None:
    stands = monitor.machine.instructions, monitor.machine.teletype.punch.tape
    with pytest.raises(WorkError, match=complaint):
        monitor.do(line)
    assert (monitor.machine.instructions, monitor.machine.teletype.punch.tape) == stands
