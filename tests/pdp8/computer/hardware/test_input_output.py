"""Every IOT of the console, the PC8/L and device 00, from each state of the flag: AC, skip, flag, time.

The tables are those of the PDP-8/I instruction card and the Small Computer Handbook, one line an instruction.
"""

from typing import NamedTuple

import pytest

from pdp8.computer.hardware.bus import Device
from pdp8.computer.hardware.signals import NEVER
from pdp8.computer.machine import Machine
from tests.conftest import case

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


def executed(word: int, flag: int) -> Machine:
    """Return the machine after `word` at 0200, every device's flag being `flag`."""
    machine = Machine(highspeed=True)
    machine.teletype.receiver.buffer = BUFFER
    machine.highspeed.reader_control.buffer = BUFFER
    machine.start(0o200)
    for device in machine.bus:
        device.flag = flag
    machine.teletype.receiver.reader_run = 0
    machine.highspeed.reader_control.buffer = BUFFER
    machine.core[0o200] = word
    machine.ac = AC
    machine.processor.instruction()
    return machine


def test_every_iot() -> None:
    for flag in [0, 1]:
        for code in [*KEYBOARD, *PRINTER, *FAST_READER, *FAST_PUNCH]:
            with case(code, flag):
                effect = {**KEYBOARD, **PRINTER, **FAST_READER, **FAST_PUNCH}[code]
                machine = executed(code, flag)
                device = machine.bus.device(code >> 3 & 0o77)
                assert device is not None
                assert f"{machine.ac:04o}" == f"{effect.ac:04o}"
                assert f"{machine.pc:04o}" == ("0202" if effect.tests and flag else "0201")
                assert device.flag == (0 if effect.clears else flag)
                assert machine.ticks == 85
                assert machine.bus.actions == 2 + (code & 6).bit_count()
                others = [other.flag for other in machine.bus if other is not device]
                assert others == [flag] * 3
                assert machine.teletype.receiver.reader_run == (
                    1 if code in (0o6032, 0o6033, 0o6036, 0o6037) else 0
                )


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
    machine = executed(code, 0)
    device = machine.bus.device(code >> 3 & 0o77)
    assert device is not None
    if code in (0o6032, 0o6036):
        assert device.due == NEVER  # there is no tape
        machine = Machine()
        machine.core[0o200] = code
        machine.start(0o200)
        machine.teletype.receiver.reader_run = 0
        machine.teletype.reader.load(b"\123")
    else:
        machine = Machine(highspeed=True)
        machine.core[0o200] = code
        machine.highspeed.reader.load(b"\123")
        machine.start(0o200)
    machine.processor.instruction()
    device = machine.bus.device(code >> 3 & 0o77)
    assert device is not None
    machine.bus.advance(RISES[code] - 1)
    assert device.flag == 0
    machine.bus.advance(RISES[code])
    assert device.flag == 1


def test_a_code_is_fitted_once() -> None:
    machine = Machine(highspeed=True)
    with pytest.raises(ValueError, match="device 01 is fitted already"):
        machine.highspeed.connect(machine.bus)


class Empty(Device):
    """A device that waits for a tape that has run out."""

    def pulse(self, iop: int, ac: int, now: int) -> int:
        return 0

    def advance(self, now: int) -> None:
        pass

    def initialize(self, now: int) -> None:
        pass

    def out_of_tape(self) -> bool:
        return True


@pytest.mark.parametrize("code", [0o05, 0o37, 0o40, 0o77])
def test_any_code_may_be_waited_for(code: int) -> None:
    machine = Machine()
    machine.bus.fit(code, Empty())
    machine.load({0o200: 0o6001 | code << 3, 0o201: 0o5200})
    machine.start(0o200)
    assert machine.run().reason == "tape out"
