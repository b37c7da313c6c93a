"""A machine saved and restored at any instant has the same future as the one that was saved, to the tick.

What is compared at the end is the whole state as a file has it: every register, every word, what each device
and each loop waits for.
"""

import copy
import json
from collections.abc import Callable

import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

from pdp8.computer.machine import Machine
from pdp8.computer.past import state
from tests.pdp8.computer.bench import octal

PROGRAMS = {
    "echo": {0o200: "6046 6031 5201 6036 6046 6041 5205 5201"},
    "echo under interrupt": {0o200: "6001 2300 5201 5201", 0: "0 6031 5005 6036 6046 6042 6001 5400"},
    "ION, JMP .": {0o200: "6001 5201", 0: "0 6031 5005 6036 6046 6042 6001 5400"},
    "garbled": {0o200: "7001 6044 2300 5202 5200"},
    "ring of tests": {0o200: "6031 7410 5207 6041 5200 6042 5200 6036 6046 5200"},
    "subroutine": {0o200: "4210 7440 6046 5200", 0o211: "6031 7410 6036 5610"},
    "counter": {0o200: "2300 5200 2301 5200 7402"},
    "round": {0o200: "7200 5200"},
    "rewrites itself": {0o200: "7000 2200 1200 3202 0 5200"},
    "high speed": {0o200: "6014 6011 5201 6016 6026 6021 5205 5201"},
}

Act = Callable[[Machine], object]


def protect(up: bool) -> Act:
    return lambda machine: setattr(machine.panel, "mem_prot", up)


def run_nothing(machine: Machine) -> object:
    return machine.run(seconds=1, instructions=0)


FRAMES = st.binary(max_size=3)
ACTS = st.one_of(
    st.builds(lambda frames: lambda m: m.teletype.keyboard.press(frames), FRAMES),
    st.builds(lambda frames: lambda m: m.teletype.reader.load(frames), FRAMES),
    st.builds(lambda frames: lambda m: m.highspeed.reader.load(frames), FRAMES),
    st.builds(lambda on: lambda m: m.teletype.reader.lever(on), st.booleans()),
    st.builds(lambda seconds: lambda m: m.wait(seconds), st.floats(0, 0.15)),
    st.builds(lambda count: lambda m: m.run(seconds=1, instructions=count), st.integers(0, 2000)),
    st.builds(lambda seconds: lambda m: m.run(seconds=seconds, instructions=3000), st.floats(0, 0.15)),
    st.builds(lambda seconds: lambda m: m.run(seconds=seconds), st.floats(0, 0.15)),
    st.builds(lambda: lambda m: m.processor.cycle()),
    st.builds(lambda: lambda m: m.panel.stop()),
    st.builds(lambda: lambda m: m.panel.cont()),
    st.builds(lambda: lambda m: m.panel.start()),
    st.builds(protect, st.booleans()),
)


def started(words: dict[int, str]) -> Machine:
    machine = Machine(highspeed=True)
    for address, text in words.items():
        machine.load(dict(enumerate(octal(text), address)))
    machine.start(0o200)
    return machine


@settings(max_examples=400, deadline=None)
@example("echo", [protect(True), run_nothing, protect(False)], [protect(True)])
@given(st.sampled_from(list(PROGRAMS)), st.lists(ACTS, max_size=8), st.lists(ACTS, max_size=8))
def test_the_same_future(name: str, before: list[Act], after: list[Act]) -> None:
    machine = started(PROGRAMS[name])
    for act in before:
        act(machine)
    text = state.save(machine)
    restored = state.restore(text)
    assert state.save(restored) == text
    for act in after:
        assert act(machine) == act(restored)
    assert json.loads(state.save(restored)) == json.loads(state.save(machine))


def test_a_switch_set_back_is_as_the_last_run_left_it_in_the_restored_machine_too() -> None:
    machine = started(PROGRAMS["echo"])
    machine.run(instructions=5)
    for name, other in (("mem_prot", 1), ("sr", 0o7070)):
        setattr(machine.processor, name, other)
    restored = state.restore(state.save(machine))
    for each in (machine, restored):
        assert not each.waiting.left.holds(each.processor)
        each.processor.mem_prot = each.processor.sr = 0
        assert each.waiting.left.holds(each.processor)


@pytest.mark.parametrize("name", PROGRAMS)
def test_saving_changes_nothing(name: str) -> None:
    saved, alone = started(PROGRAMS[name]), started(PROGRAMS[name])
    for machine in (saved, alone):
        machine.teletype.reader.load(b"\301\302\303")
    for _ in range(40):
        state.save(saved)
        assert saved.run(seconds=0.01) == alone.run(seconds=0.01)
    assert state.save(saved) == state.save(alone)


def test_a_key_that_waits_is_not_lost_by_saving() -> None:
    machine = started({0o200: "6031 5200 6036 7402"})
    machine.teletype.keyboard.press(b"\301")
    restored = state.restore(state.save(machine))
    for each in (machine, restored):
        each.start(0o200)
        assert each.run().reason == "halt"
        assert f"{each.ac:04o}" == "0301"


@pytest.mark.parametrize("copied", [copy.copy, copy.deepcopy])
def test_a_copy_has_the_same_future(copied: Callable[[Machine], Machine]) -> None:
    machine = started(PROGRAMS["echo"])
    machine.teletype.reader.load(b"\301\302\303")
    machine.run(seconds=0.12)
    other = copied(machine)
    assert machine.run() == other.run()
    assert other.teletype.punch.tape == machine.teletype.punch.tape
    other.core[0o200] = 0o7402
    assert machine.core[0o200] == 0o6046
