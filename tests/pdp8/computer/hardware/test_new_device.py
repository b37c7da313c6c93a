"""A device of one's own in one file: a clock under code 05, with its flag, its interrupt and its saved state.

6051  skip if the flag is up
6052  clear the flag
6054  run with a period of AC 4-11 milliseconds, or stop with 0
"""

import copy
import json

import pytest

from pdp8.computer.hardware.bus import Device
from pdp8.computer.hardware.devices import one_of_each
from pdp8.computer.hardware.fields import BIT, TICK, saved
from pdp8.computer.hardware.signals import NEVER, SKIP
from pdp8.computer.machine import Machine
from pdp8.computer.past import state
from tests.pdp8.computer.bench import core

MILLISECOND = 20_000


class Clock(Device):
    """Raises its flag again and again."""

    CODE = 0o05
    fields = saved(flag=BIT, due=TICK, period=TICK)

    def __init__(self) -> None:
        super().__init__()
        self.period = 0

    def pulse(self, iop: int, ac: int, now: int) -> int:
        if iop == 1:
            return SKIP if self.flag else 0
        if iop == 2:
            self.flag = 0
        else:
            self.period = (ac & 0o377) * MILLISECOND
            self.due = now + self.period if self.period else NEVER
        return 0

    def advance(self, now: int) -> None:
        while self.due <= now:
            self.flag = 1
            self.due += self.period

    def initialize(self, now: int) -> None:
        self.flag = self.period = 0
        self.due = NEVER


@pytest.fixture
def ticking() -> Machine:
    """TAD 20, 6054, ION, JMP .; at 0001: ISZ 10, 6052, ION, JMP I 0."""
    made = Machine()
    made.fit(Clock())
    made.load(core("1020 6054 6001 5203 0/ 0 2010 6052 6001 5400 20/ 24"))
    made.start(0o200)
    made.run(seconds=0.5)
    return made


def test_a_code_is_fitted_once() -> None:
    m = Machine(one_of_each())
    assert (Machine().highspeed.fitted, m.highspeed.fitted) == (False, True)
    with pytest.raises(ValueError, match="device 01 is fitted already"):
        m.fit(m.highspeed)


def test_it_skips_and_interrupts(ticking: Machine) -> None:
    ticking.run(seconds=0.5)
    assert ticking.core[0o10] == 49  # every 20 ms, the first of them after 2 instructions


def test_its_state_is_saved_and_copied(ticking: Machine) -> None:
    text = state.save(ticking)
    due = ticking.bus.next_event(ticking.processor.clock)
    assert json.loads(text)["devices"]["05"] == {"device": "Clock", "flag": 0, "due": due, "period": 400_000}
    restored, copied = state.restore(text, [Clock()]), copy.deepcopy(ticking)
    for each in (ticking, restored, copied):
        each.run(seconds=0.5)
    assert state.save(restored) == state.save(copied) == state.save(ticking)
    with pytest.raises(state.StateError, match="devices 05: the state needs a Clock"):
        state.restore(text)


def with_flag(words: str, code: int, rises: int) -> Machine:
    """Return a machine with a clock whose flag rises once, at a tick."""
    clock, made = type("Coded", (Clock,), {"CODE": code})(), Machine()
    made.fit(clock)
    made.load(core(words))
    made.start(0o200)
    clock.due, clock.period = rises, 1 << 40
    return made


@pytest.mark.parametrize("code", [0o05, 0o37, 0o40, 0o77])
def test_any_code_may_be_waited_for(code: int) -> None:
    m = with_flag(f"{0o6001 | code << 3:o} 5200 7402", code, 1000)
    assert m.run()[:2] == ("halt", 0o203)
    assert 1000 < m.ticks <= 1000 + 117 + 85 + 32


@pytest.mark.parametrize(("rises", "skips"), [(28, 1), (29, 1), (30, 0)])
def test_a_flag_that_rises_in_the_tick_of_iop1_is_seen(rises: int, skips: int) -> None:
    m = with_flag("6051 7000 7000", 0o05, rises)
    m.run(instructions=1)
    assert m.pc == 0o201 + skips
