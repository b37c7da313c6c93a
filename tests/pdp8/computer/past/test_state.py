"""A machine saved in the middle and restored goes on as if nothing had happened."""

import copy
import json
from collections.abc import Callable

import pytest

from pdp8.computer.machine import Machine
from pdp8.computer.past import state
from tests.pdp8.computer.speed.forms import machine_module
from tests.pdp8.computer.use.test_operator import assembly

PARTS = ("reader", "keyboard", "printer", "punch")
LINE = bytes(0o200 | code for code in b"  76 2250 4133  185\r\n")


def translating() -> Machine:
    machine = Machine()
    machine.load(assembly("eia").words)
    machine.start(0o200)
    machine.teletype.reader.load(LINE * 2)
    return machine


@pytest.mark.parametrize("seconds", [0, 0.12345, 1.7])
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


def test_a_person_can_read_it() -> None:
    machine = Machine()
    machine.load({0o200: 0o7402})
    machine.ac = 0o17
    machine.teletype.reader.load(b"\215\212")
    saved = json.loads(state.save(machine))
    assert (saved["format"], saved["version"]) == ("pdp8 state", 2)
    assert saved["processor"]["lac"] == "00017"
    assert saved["core"] == {"0200": "7402 0000 0000 0000 0000 0000 0000 0000"}
    assert saved["devices"]["03"]["reader"]["tape"] == ["215 212"]
    assert saved["devices"]["04"]["due"] == "never"


def test_a_state_may_name_no_more_than_what_is_wanted() -> None:
    machine = state.restore(
        json.dumps(
            {
                **{"format": "pdp8 state", "version": 2, "core": {"0200": "6036 6046 7402"}},
                "processor": {"pc": "0200"},
                "devices": {"03": {"buffer": "301", "active": 1}, "04": {"register": "777"}},
            }
        )
    )
    assert machine.teletype.transmitter.due == 1_636_364  # nine units
    machine.wait(0.01)
    assert machine.teletype.receiver.shifts == 1
    assert machine.run().reason == "halt"


def test_every_attribute_of_a_device_is_in_its_fields_or_fixed() -> None:
    """A plain machine has a dictionary of attributes: what `fields` leave out is wired, or not of the run."""
    fixed = {"code", "behind", "reader", "keyboard", "printer", "punch", "device", "on_frame"}
    machine = machine_module("plain").Machine(highspeed=True)
    parts = [machine.processor, machine.bus, machine.waiting, *machine.bus]
    parts += [getattr(device, name) for device in machine.bus for name in PARTS if hasattr(device, name)]
    parts.append(machine.waiting.left)
    assert len(parts) == 14
    fixed |= {
        *("more", "bus", "core", "_core", "forms", "processor", "_words", "first", "endless", "turn_first")
    }
    for part in parts:
        assert set(vars(part)) - fixed == set(part.fields) - fixed, type(part).__name__


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("", 'a saved state begins with {"format": "pdp8 state", "version": 2'),
        ("hello", "a saved state begins with"),
        ("[]", "a saved state begins with"),
        ('{"format": "pdp8 state", "version": 3}', "a saved state begins with"),
        ('{"format": "pdp8 state", "version": 2, ', "cut short or damaged: .* line 1"),
    ],
)
def test_what_is_not_a_state(text: str, message: str) -> None:
    with pytest.raises(state.StateError, match=message):
        state.restore(text)


@pytest.mark.parametrize(
    ("fields", "message"),
    [
        ({"devices": {"05": {}}}, "devices 05: this machine has no such device"),
        ({"devices": {"03": {"device": "Clock"}}}, "devices 03: 'Clock' was saved, but 'Receiver' is fitted"),
        ({"devices": {"8": {}}}, 'devices 8: "8" is not an octal number'),
        ({"devices": []}, "devices: .. is not an object with fields"),
        ({"devices": {"03": {"reader": 5}}}, "devices 03 reader: 5 is not an object"),
        ({"devices": {"03": {"reader": {"tape": 5}}}}, "devices 03 reader tape: 5 is not a list of rows"),
        ({"core": {"10000": "0"}}, 'core: "10000" is not an octal number from 0 to 7777'),
        ({"core": {"7777": "0 0"}}, "core 7777: the words go beyond 7777"),
        ({"core": {"0200": 5}}, "core 0200: 5 is not a text of octal numbers"),
        ({"devices": {"03": {"reader": {"tape": [5]}}}}, "reader tape: 5 is not a text of octal numbers"),
        ({"processor": {"clock": True}}, "processor clock: true is not a number"),
        ({"core": {"0200": "10000"}}, 'core 0200: "10000" is not an octal number from 0 to 7777'),
        ({"processor": {"pc": 128}}, "processor pc: 128 is not an octal number from 0 to 7777"),
        ({"processor": {"pc": "9"}}, 'processor pc: "9" is not an octal number from 0 to 7777'),
        ({"processor": {"pc": "10000"}}, 'processor pc: "10000" is not'),
        ({"processor": {"mq": "0"}}, "processor mq: the fields are pc"),
        ({"processor": {"run": "1"}}, 'processor run: "1" is not a number'),
        ({"processor": {"run": 2}}, "processor run: 2 is not a number from 0 to 1"),
        ({"processor": {"next": 7}}, "processor next: 7 is not a number from 0 to 3"),
        ({"processor": {"clock": -5}}, "processor clock: -5 is not a number from -1 to"),
        ({"processor": {"clock": 1 << 56 | 1}}, "clock: 72.*37 is not a number from -1 to 72.*36"),
        ({"devices": {"03": {"shifts": 10}}}, "devices 03 shifts: 10 is not a number from 0 to 9"),
        ({"devices": {"04": {"sent": 1 << 31}}}, "devices 04 sent: 2147483648 is not"),
        ({"devices": {"03": {"reader": {"tape": ["400"]}}}}, 'devices 03 reader tape: "400" is not an octal'),
        ({"devices": {"03": {"reader": {"position": 3}}}}, "stands at frame 3 of a tape of 0"),
        ({"devices": {"3": {}}}, "devices 3: this machine has no such device"),
        ({"devices": {"100": {}}}, 'devices 100: "100" is not an octal number from 0 to 77'),
        ({"core": ["7402"]}, "core: .* is not an object"),
        ({"waiting": {"left": {"ac": "0000"}}}, "waiting left ac: the fields are pc sr"),
        ({"waiting": {"clock": 5}}, "waiting: its clock and instructions lie after"),
        ({"core": {"200": "8"}}, 'core 200: "8" is not an octal number'),
        ({"corre": {"200": "7402"}}, "corre: the parts are core processor bus waiting devices"),
    ],
)
def test_what_a_state_may_not_say(fields: dict[str, object], message: str) -> None:
    with pytest.raises(state.StateError, match=message):
        state.restore(json.dumps({"format": "pdp8 state", "version": 2, **fields}))


def test_a_switch_set_back_is_as_the_last_run_left_it_in_the_restored_machine_too() -> None:
    machine = translating()
    machine.run(instructions=5)
    for name, other in (("mem_prot", 1), ("sr", 0o7070)):
        setattr(machine.processor, name, other)
    restored = state.restore(state.save(machine))
    for each in (machine, restored):
        assert not each.waiting.left.holds(each.processor)
        each.processor.mem_prot = each.processor.sr = 0
        assert each.waiting.left.holds(each.processor)


@pytest.mark.parametrize("copied", [copy.copy, copy.deepcopy])
def test_a_copy_has_the_same_future(copied: Callable[[Machine], Machine]) -> None:
    machine = translating()
    machine.run(seconds=0.12)
    other = copied(machine)
    assert machine.run() == other.run()
    assert other.teletype.punch.tape == machine.teletype.punch.tape
    other.core[0o200] = 0o7402
    assert machine.core[0o200] != 0o7402
