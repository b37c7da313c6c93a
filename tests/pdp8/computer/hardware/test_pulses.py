"""The pulses of an IOT, and a flag that rises in the very tick in which it is tested."""

import pytest

from pdp8.computer.hardware.bus import Device
from pdp8.computer.hardware.signals import NEVER, SKIP
from pdp8.computer.machine import Machine


class Flag(Device):
    """A flag that rises at a tick, and a record of the pulses."""

    def __init__(self, rises: int) -> None:
        super().__init__()
        self.rises = rises
        self.pulses: list[tuple[int, int]] = []

    def pulse(self, iop: int, ac: int, now: int) -> int:
        self.pulses.append((iop, now))
        return SKIP if iop == 1 and self.flag else 0

    def advance(self, now: int) -> None:
        if self.due <= now:
            self.flag, self.due = 1, NEVER

    def initialize(self, now: int) -> None:
        self.flag, self.due = 0, self.rises


def machine(rises: int, *words: int) -> tuple[Machine, Flag]:
    m, flag = Machine(), Flag(rises)
    m.bus.fit(0o05, flag)
    m.load(dict(enumerate(words, 0o200)))
    m.start(0o200)
    return m, flag


def test_three_pulses_29_47_and_65_ticks_after_the_iot_begins() -> None:
    m, flag = machine(NEVER, 0o7000, 0o6057, 0o7000)
    m.run(instructions=3)
    assert flag.pulses == [(1, 32 + 29), (2, 32 + 47), (4, 32 + 65)]


@pytest.mark.parametrize(("rises", "skips"), [(28, 1), (29, 1), (30, 0)])
def test_a_flag_that_rises_with_iop1_is_seen(rises: int, skips: int) -> None:
    m, _ = machine(rises, 0o6051, 0o7000, 0o7000)
    m.run(instructions=1)
    assert m.pc == 0o201 + skips


@pytest.mark.parametrize(("rises", "returns_to"), [(63, 0o202), (64, 0o202), (65, 0o203)])
def test_a_flag_that_rises_as_an_instruction_ends_interrupts_there(rises: int, returns_to: int) -> None:
    """NOPs of 32 ticks; the word at 0000 is the return address."""
    m, _ = machine(rises, *[0o7000] * 8)
    m.core[1] = 0o7402
    m.ion = 1
    m.run(instructions=9)
    assert f"{m.core[0]:04o}" == f"{returns_to:04o}"
