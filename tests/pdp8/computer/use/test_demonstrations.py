"""The three demonstration programs do what their comments say."""

import pytest

from pdp8.computer.machine import Machine
from tests.pdp8.computer.use.test_operator import assembly


def started(name: str) -> Machine:
    machine = Machine()
    machine.load(assembly(name).words)
    machine.start(0o200)
    return machine


def test_hello_prints_and_halts() -> None:
    machine = started("hello")
    stop = machine.run()
    printed = bytes(frame & 0o177 for frame in machine.teletype.punch.tape)
    assert printed == b"\r\nHELLO, WORLD.\r\n"
    assert all(frame & 0o200 for frame in machine.teletype.punch.tape)
    assert stop.reason == "halt"
    assert stop.elapsed == pytest.approx(1.7 - 0.0182, abs=0.001)


def test_echo_prints_what_is_typed_while_it_counts() -> None:
    machine = started("echo")
    machine.teletype.keyboard.press(bytes(0o200 | code for code in b"PAL III"))
    machine.run(seconds=1.2)
    assert bytes(frame & 0o177 for frame in machine.teletype.punch.tape) == b"PAL III"
    assert machine.core[assembly("echo").symbols["COUNT"]] > 0


def test_counter_shows_every_count_in_the_lamps() -> None:
    machine = started("counter")
    symbols = assembly("counter").symbols
    for count in range(1, 6):
        while machine.core[symbols["KEEP"]] != count or machine.ac != count:
            machine.run(instructions=1)
        assert machine.panel.lamps.ac == count
    began = machine.ticks
    while machine.ac != 6:
        machine.run(instructions=1)
    assert (machine.ticks - began) / 20_000 == pytest.approx(19.7, abs=0.1)


def test_counter_halts_when_it_is_round() -> None:
    machine = started("counter")
    machine.run(seconds=0.001)
    machine.ac = 0o7775
    machine.pc = assembly("counter").symbols["COUNT"]
    assert machine.run(seconds=1).reason == "halt"
    assert machine.ac == 0
