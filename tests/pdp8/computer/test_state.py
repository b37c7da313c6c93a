"""A machine saved in the middle and restored goes on as if nothing had happened."""

import pytest

from pdp8.computer import state
from pdp8.computer.machine import Machine
from tests.pdp8.computer.bench import octal
from tests.pdp8.computer.test_operator import assembly

LINE = bytes(0o200 | code for code in b"  76 2250 4133  185\r\n")


def translating() -> Machine:
    machine = Machine()
    machine.load(assembly("eia").words)
    machine.start(0o200)
    machine.teletype.reader.load(LINE * 2)
    return machine


@pytest.mark.parametrize("seconds", [0, 0.0001, 0.05, 0.1, 0.12345, 0.9, 1.7])
def test_a_run_saved_in_the_middle(seconds: float) -> None:
    whole = translating()
    whole.run()
    machine = translating()
    machine.run(seconds=seconds)
    restored = state.restore(state.save(machine))
    assert state.save(restored) == state.save(machine)
    stop = restored.run()
    assert stop.reason == "tape out"
    assert restored.teletype.punch.tape == whole.teletype.punch.tape
    assert (restored.ticks, list(restored.core)) == (whole.ticks, list(whole.core))


def test_in_the_middle_of_an_instruction_and_of_a_garbled_character_with_keys_waiting() -> None:
    machine = Machine(highspeed=True)
    machine.load(
        dict(enumerate(octal("6046 1610 6046 6014 6024 5205"), 0o200)) | {0o210: 0o300, 0o300: 0o123}
    )
    machine.highspeed.reader.load(b"\1\2\3")
    machine.teletype.keyboard.press(b"\301\302")
    machine.start(0o200)
    machine.panel.mem_prot = True
    machine.sr = 0o1234
    machine.processor.cycle()
    machine.processor.cycle()
    restored = state.restore(state.save(machine))
    for m in (machine, restored):
        m.run(seconds=0.5)
    assert state.save(restored) == state.save(machine)
    assert restored.panel.mem_prot
    assert restored.highspeed.reader.position == 1


def test_a_person_can_read_it() -> None:
    machine = Machine()
    machine.load({0o200: 0o7402})
    machine.ac = 0o17
    lines = state.save(machine).splitlines()
    assert lines[0] == "pdp8 state 1"
    assert "processor.lac 0017" in lines
    assert "core 0200 7402 0000 0000 0000 0000 0000 0000 0000" in lines


def test_a_garbled_character_on_the_line() -> None:
    """TLS 210 times without looking at the flag: a character that does not end."""
    machine = Machine()
    machine.load({0o200: 0o6046, 0o201: 0o2210, 0o202: 0o5201, 0o203: 0o5200})
    machine.start(0o200)
    machine.run(seconds=0.13)
    restored = state.restore(state.save(machine))
    for each in (machine, restored):
        each.run(seconds=0.5)
    assert restored.teletype.printer.frames == machine.teletype.printer.frames
    assert state.save(restored) == state.save(machine)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("", "line 1"),
        ("hello", "line 1"),
        ("pdp8 state 1\nprocessor.pc 0200\ncore 0200 72", "cut short"),
        ("pdp8 state 1\nprocessor.run 99999999999\nend", "line 2: not understood"),
        ("pdp8 state 1\nteletype.transmitter.shifts 2147483648\nend", "line 2: not understood"),
        ("pdp8 state 1\nteletype.transmitter.unit -1\nend", "line 2: not understood"),
        ("pdp8 state 1\nprocessor.clock 4611686018427387904\nend", "line 2: not understood"),
        ("pdp8 state 1\nprocessor.mq 0000\nend", "line 2: no part"),
        ("pdp8 state 1\nprocessor.pc 9\nend", "line 2: not understood"),
        ("pdp8 state 1\nprocessor.pc 10000\nend", "line 2: not understood"),
        ("pdp8 state 1\nprocessor.next 7\nend", "line 2: not understood"),
        ("pdp8 state 1\n\ncore 7777 1 2\nend", "line 3: not understood"),
        ("pdp8 state 1\ncore\nend", "line 2: not understood"),
        ("pdp8 state 1\nteletype.reader.tape 400\nend", "line 2: not understood"),
        ("pdp8 state 1\nteletype.reader.position 3\nend", "stands at frame 3"),
        ("pdp8 state 1\nprocessor.clock -5\nend", "line 2: not understood"),
    ],
)
def test_what_is_no_state(text: str, message: str) -> None:
    with pytest.raises(state.StateError, match=message):
        state.restore(text)
