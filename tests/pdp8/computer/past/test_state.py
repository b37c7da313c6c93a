"""A machine saved in the middle and restored goes on as if nothing had happened."""

import copy
import json
from typing import Any

import pytest

from pdp8.computer.hardware.extension import Extension
from pdp8.computer.machine import Machine
from pdp8.computer.past import state
from tests.pdp8.computer.bench import machine
from tests.pdp8.computer.speed.forms import machine_module

PARTS = ("reader", "keyboard", "printer", "punch")
# KCC, RFC, PLS, TLS, HLT, KRB, RRB, ION, KSF, JMP .-1, IOF, JMP 0200; at 0001 KCC, TCF, RRB, PCF, ION...
BUSY = "6032 6014 6026 6046 7402 6036 6016 6001 6031 5210 6002 5200 1/ 6032 6042 6012 6022 6001 5400"
TAPE = b"\215\212\301\302\303"


def busy() -> Machine:
    made = machine(BUSY, TAPE, highspeed=True)
    made.teletype.reader.load(TAPE)
    made.teletype.keyboard.press(b"KEY")
    return made


def given(**fields: Any) -> str:
    return json.dumps({"format": "pdp8 state", "version": 2, **fields})


def test_a_run_is_saved_and_copied_anywhere_in_the_middle() -> None:
    """Also where it has halted and the punches have finished ahead of their time."""
    m = busy()
    for number in range(40):
        m.run(seconds=0.0312, instructions=number * number * 8)
        restored = state.restore(state.save(m))
        copied = copy.deepcopy(m) if number % 2 else copy.copy(m)
        assert state.save(restored) == state.save(m)
        for each in (m, restored, copied):
            each.run(seconds=0.02)
        assert state.save(restored) == state.save(copied) == state.save(m)
    assert min(len(m.highspeed.punch.tape), len(m.teletype.punch.tape)) > 2
    copied.core[0o200] = 0o7402
    assert m.core[0o200] == 0o6032


def test_a_person_can_read_it() -> None:
    m = machine("7402", b"\215\212", ac=0o17)
    saved = json.loads(state.save(m))
    assert (saved["format"], saved["version"]) == ("pdp8 state", 2)
    assert saved["processor"]["lac"] == "00017"
    assert saved["core"] == {"0200": "7402 0000 0000 0000 0000 0000 0000 0000"}
    assert saved["devices"]["03"]["reader"]["tape"] == ["215 212"]
    assert saved["devices"]["04"]["due"] == "never"


def test_a_state_may_name_no_more_than_what_is_wanted() -> None:
    devices = {"03": {"buffer": "301", "active": 1}, "04": {"register": "777"}}
    core = {"0200": "6036 6046 7402"}
    m = state.restore(given(core=core, processor={"pc": "0200"}, devices=devices))
    assert m.teletype.transmitter.due == 1_636_364  # nine units
    m.wait(0.01)
    assert m.teletype.receiver.shifts == 1
    assert m.run().reason == "halt"


def test_every_attribute_of_a_device_is_in_its_fields_or_fixed() -> None:
    """A plain machine has a dictionary of attributes: what `fields` leave out is wired, or not of the run."""
    fixed = {"code", "behind", "bus", "device", "processor", "on_frame", "more", *PARTS}
    fixed |= {"extension", "has_breaks", "enabled", "stored", "core", "_core", "forms", "_words", "first"}
    fixed |= {"endless", "turn_first", "iot", "varies"}
    m = machine_module("plain").Machine()
    m.fit(m.highspeed)
    parts = [m.processor, m.bus, m.waiting, m.waiting.left, *m.bus]
    parts += [getattr(device, name) for device in m.bus for name in PARTS if hasattr(device, name)]
    assert len(parts) == 14
    for part in parts:
        assert set(vars(part)) - fixed == set(part.fields) - fixed, type(part).__name__


BEGINS = 'a saved state begins with {"format": "pdp8 state", "version": 2'
OBJECT, OCTAL, NUMBER = (
    "is not an object with fields",
    "is not an octal number from 0 to",
    "is not a number from",
)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        *((text, BEGINS) for text in ("", "hello", "[]", r"{\rtf1}", '{"format": "pdp8 state"}')),
        (given()[:-1] + ", ", "the saved state is cut short or damaged: "),
        ('{"format": "pdp8 state", "core": ' + "[" * 100_000, "the saved state is nested too deeply"),
        (given(devices={"05": {}}), "devices 05: the state needs a device of this code"),
        (
            given(devices={"03": {"device": "Clock"}}),
            "devices 03: the state needs a Clock, not a Receiver",
        ),
        (given(devices={"100": {}}), f'devices 100: "100" {OCTAL} 77'),
        (given(devices={"3": {}}), "devices 3: the state needs a device of this code"),
        (given(memory=5000), "memory: 5000 words; 4096, 8192, "),
        *(
            (given(memory=8192, extension={name: field}), f"extension: {field} is not a field of 8192 words")
            for name, kind in Extension.fields.items()
            for field in ("10001", "20000")
            if kind == "70000"
        ),
        (given(memory=4095), f"memory: 4095 {NUMBER} 4096 to 32768"),
        (given(memory=32769), f"memory: 32769 {NUMBER} 4096 to 32768"),
        (given(devices=[]), f"devices: [] {OBJECT}"),
        (given(devices={"03": {"reader": 5}}), f"devices 03 reader: 5 {OBJECT}"),
        (given(devices={"03": {"reader": {"tape": 5}}}), "devices 03 reader tape: 5 is not a list of rows"),
        (
            given(devices={"03": {"reader": {"tape": [5]}}}),
            "devices 03 reader tape: 5 is not a text of octal",
        ),
        (given(devices={"03": {"reader": {"tape": ["400"]}}}), f'devices 03 reader tape: "400" {OCTAL} 377'),
        (given(devices={"03": {"reader": {"position": 3}}}), "the reader stands at frame 3 of a tape of 0"),
        (given(devices={"03": {"shifts": 10}}), f"devices 03 shifts: 10 {NUMBER} 0 to 9"),
        (given(devices={"03": {"pulses": 256}}), f"devices 03 pulses: 256 {NUMBER} 0 to 255"),
        (given(devices={"04": {"unit": 10}}), f"devices 04 unit: 10 {NUMBER} 0 to 9"),
        (given(devices={"04": {"sent": 1 << 31}}), f"devices 04 sent: 2147483648 {NUMBER} 0 to 1073741824"),
        (given(waiting={"tries": 5001}), f"waiting tries: 5001 {NUMBER} 0 to 5000"),
        (given(core={"10000": "0"}), f'core: "10000" {OCTAL} 7777'),
        (given(core={"7777": "0 0"}), "core 7777: the words go beyond 7777"),
        (given(core={"0200": 5}), "core 0200: 5 is not a text of octal numbers"),
        (given(core={"0200": "10000"}), f'core 0200: "10000" {OCTAL} 7777'),
        (given(core=["7402"]), f'core: ["7402"] {OBJECT}'),
        (
            given(corre={"0200": "7402"}),
            "corre: the parts are memory core processor ",
        ),
        (given(processor={"clock": True}), f"processor clock: true {NUMBER} -1 to 72057594037927936"),
        (given(processor={"clock": -5}), f"processor clock: -5 {NUMBER} -1 to 72057594037927936"),
        (given(processor={"clock": 1 << 56 | 1}), f"processor clock: 72057594037927937 {NUMBER} -1 to"),
        (given(processor={"pc": 128}), f"processor pc: 128 {OCTAL} 7777"),
        (given(processor={"pc": ""}), f'processor pc: "" {OCTAL} 7777'),
        (given(processor={"pc": "9"}), f'processor pc: "9" {OCTAL} 7777'),
        (given(processor={"pc": "\u0661"}), f'processor pc: "\\u0661" {OCTAL} 7777'),
        (given(processor={"pc": "10000"}), f'processor pc: "10000" {OCTAL} 7777'),
        (given(processor={"mq": "0"}), "processor mq: the fields are pc ma mb sr run stopping"),
        (given(processor={"run": "1"}), f'processor run: "1" {NUMBER} 0 to 1'),
        (given(processor={"run": 2}), f"processor run: 2 {NUMBER} 0 to 1"),
        (given(processor={"next": 4}), "processor next: must be 4 to 6, as a device has a data break"),
        (given(processor={"next": 7}), f"processor next: 7 {NUMBER} 0 to 6"),
        (given(processor="x" * 76), f'processor: "{"x" * 65} {OBJECT}'),
        (given(waiting={"left": {"ac": "0000"}}), "waiting left ac: the fields are pc sr"),
        (given(processor={"clock": "never"}), 'processor: its clock and started are numbers, not "never"'),
        (given(waiting={"clock": 5}), "waiting: its clock and instructions must not exceed the processor's"),
        (given(waiting={"instructions": 5}), "waiting: its clock and instructions must not exceed"),
    ],
)
def test_what_is_no_state_is_refused_by_its_place(text: str, message: str) -> None:
    with pytest.raises(state.StateError) as refused:
        state.restore(text)
    assert str(refused.value).startswith(message)


def test_the_largest_values_are_taken() -> None:
    fields = dict.fromkeys(("inst_field", "inst_buffer"), "10000")
    processor = {"clock": 1 << 56, "run": 1, "next": 3, "pc": "7777"}
    m = state.restore(given(memory=8192, extension=fields, core={"17777": "7777"}, processor=processor))
    assert (m.processor.clock, m.pc, m.core[0o17777], m.processor.next) == (1 << 56, 0o17777, 0o7777, 3)


def test_five_tapes_of_2_mib_are_not_too_large() -> None:
    m, part = machine(highspeed=True), bytes([0o377]) * (1 << 15)
    for station in (m.teletype, m.highspeed):
        station.reader.load(part)
        station.punch.frames[:] = part
    m.teletype.printer.frames[:] = part
    assert 0.8 * state.LARGEST < 64 * len(state.save(m)) <= state.LARGEST


def test_a_switch_set_back_is_as_the_last_run_left_it_in_the_restored_machine_too() -> None:
    m = busy()
    m.run(instructions=3)
    m.processor.mem_prot, m.processor.sr = 1, 0o7070
    for each in (m, state.restore(state.save(m))):
        assert not each.waiting.left.holds(each.processor)
        each.processor.mem_prot = each.processor.sr = 0
        assert each.waiting.left.holds(each.processor)


def test_what_is_restored_has_the_types_that_it_had() -> None:
    m = busy()
    restored = state.restore(state.save(m)).values()
    assert {name: type(value) for name, value in restored.items()} == {
        name: type(value) for name, value in m.values().items()
    }
