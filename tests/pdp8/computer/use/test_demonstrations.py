"""The demonstration programs that go on for ever do what their comments say."""

import pytest

from pdp8.computer.machine import Machine
from tests.pdp8.computer.use.test_operator import assembly


def started(name: str) -> Machine:
    machine = Machine()
    machine.load(assembly(name).words)
    machine.start(0o200)
    return machine


def test_echo_prints_what_is_typed_while_it_counts() -> None:
    machine, typed = started("echo"), bytes(0o200 | code for code in b"PAL III")
    machine.teletype.keyboard.press(typed)
    machine.run(seconds=1.2)
    assert machine.teletype.punch.tape == typed
    assert machine.core[assembly("echo").symbols["COUNT"]] > 0


def test_counter_shows_every_count_in_the_lamps_and_halts_when_it_is_round() -> None:
    machine, symbols = started("counter"), assembly("counter").symbols
    shown = []
    for count in range(1, 7):
        while machine.core[symbols["KEEP"]] != count or machine.ac != count:
            machine.run(instructions=1)
        shown.append(machine.ticks)
        assert machine.panel.lamps.ac == count
    assert (shown[5] - shown[4]) / 20_000 == pytest.approx(19.7, abs=0.1)
    machine.ac, machine.pc = 0o7775, symbols["COUNT"]
    assert machine.run(seconds=1).reason == "halt"
    assert machine.ac == 0
