"""Every IOT of the console and the PC8/L, from each state of the flag: AC, skip, flag, time; its pulses.

The tables are those of the PDP-8/I instruction card and the Small Computer Handbook, one line an instruction.
"""

from copy import copy
from typing import NamedTuple

import pytest

from pdp8.computer.hardware.bus import Device
from pdp8.computer.hardware.signals import NEVER
from pdp8.computer.machine import Machine
from tests.conftest import case
from tests.pdp8.computer.bench import machine

AC = 0o5125
BUFFER = 0o252


class Effect(NamedTuple):
    """What an IOT does: does it test the flag, clear it, and what is in AC afterwards."""

    tests: bool
    clears: bool
    ac: int


def effects(device: int, *ac: int, clears: str) -> dict[int, Effect]:
    """Return what the eight IOTs of a device do: odd ones test; those of the pulses in `clears` clear."""
    return {
        0o6000 | device << 3 | pulses: Effect(pulses % 2 == 1, str(pulses) in clears, after)
        for pulses, after in enumerate(ac)
    }


KEYBOARD = effects(3, *(0o5125, 0o5125, 0, 0, 0o5377, 0o5377, 0o0252, 0o0252), clears="2367")
PRINTER = effects(4, *[AC] * 8, clears="2367")
FAST_READER = effects(1, *(0o5125, 0o5125, 0o5377, 0o5377, 0o5125, 0o5125, 0o5377, 0o5377), clears="234567")
FAST_PUNCH = effects(2, *[AC] * 8, clears="2367")


def executed(word: int, flag: int) -> tuple[Machine, Device]:
    """Return the machine after `word` at 0200, every device's flag being `flag`, and the word's device."""
    m = machine(f"{word:o}", highspeed=True, ac=AC)
    m.teletype.receiver.buffer = m.highspeed.reader_control.buffer = BUFFER
    m.teletype.receiver.reader_run = 0
    for each in m.bus:
        each.flag = flag
    m.processor.instruction()
    device = m.bus.device(word >> 3 & 0o77)
    assert device
    return m, device


def test_every_iot() -> None:
    for code, effect in {**KEYBOARD, **PRINTER, **FAST_READER, **FAST_PUNCH}.items():
        for flag in (0, 1):
            with case(f"{code:o}", flag):
                m, device = executed(code, flag)
                assert f"{m.ac:04o}" == f"{effect.ac:04o}"
                assert f"{m.pc:04o}" == ("0202" if effect.tests and flag else "0201")
                assert device.flag == (0 if effect.clears else flag)
                assert (m.ticks, m.bus.actions) == (85, 2 + (code & 6).bit_count())
                assert [other.flag for other in m.bus if other is not device] == [flag] * 3
                assert m.teletype.receiver.reader_run == (code in (0o6032, 0o6033, 0o6036, 0o6037))
    iof = machine("6002")
    iof.processor.instruction()
    assert iof.bus.actions == 2 + 1


# From the pulse that starts it, the tick at which each flag rises. IOP1, IOP2, IOP4 come 29, 47, 65 ticks
# (1.45, 2.35, 3.25 us) into an IOT.
RISES = {
    0o6032: 47 + 1_545_455,  # 8.5 units of 1/110 s after the reader's start unit
    0o6036: 47 + 1_545_455,
    0o6044: 65 + 1_636_364,  # 9 units
    0o6046: 65 + 1_636_364,
    0o6014: 65 + 66_667,  # 1/300 s
    0o6016: 65 + 66_667,
    0o6024: 65 + 400_000,  # 1/50 s
    0o6026: 65 + 400_000,
}


@pytest.mark.parametrize("code", RISES)
def test_the_tick_at_which_the_flag_rises(code: int) -> None:
    teletype = code in (0o6032, 0o6036)
    m = machine(f"{code:o}", highspeed=not teletype)
    if teletype:
        m.teletype.receiver.reader_run = 0
    (m.teletype if teletype else m.highspeed).reader.load(b"\123")
    m.processor.instruction()
    cleared = copy(m)
    device, other = (each.bus.device(code >> 3 & 0o77) for each in (m, cleared))
    assert device
    assert other
    for tick, flag in ((RISES[code] - 1, 0), (RISES[code], 1)):
        assert m.bus.next_event(tick) > tick
        assert device.flag == flag
    other.pulse(2, 0, RISES[code])
    cleared.bus.advance(RISES[code] + 1)
    assert other.flag == 0, "IOP2 finds the flag that rises in its tick"
    reads = code in (0o6032, 0o6036, 0o6014, 0o6016)
    assert (executed(code, 0)[1].due == NEVER) == reads, "there is no tape"


def test_a_code_is_fitted_once() -> None:
    m = Machine(highspeed=True)
    assert (Machine().highspeed.fitted, m.highspeed.fitted) == (False, True)
    with pytest.raises(ValueError, match="device 01 is fitted already"):
        m.highspeed.connect(m.bus)
