"""Every key and switch, and what the lamps show after each."""

import pytest

from pdp8.computer.hardware.panel import Lamps, Panel, shares
from pdp8.computer.hardware.processor import Processor
from pdp8.computer.machine import Machine


@pytest.fixture
def machine() -> Machine:
    """Return a machine that stands still, with a few words in core."""
    made = Machine()
    made.load({0o200: 0o1250, 0o201: 0o3650, 0o202: 0o7402, 0o250: 0o300, 0o300: 0o1111, 0o7777: 0o4321})
    return made


def load_address(panel: Panel, address: int) -> None:
    panel.sr = address
    panel.load_add()


def test_power_up(machine: Machine) -> None:
    assert set(machine.panel.lamps) == {0, 1}
    assert machine.panel.lamps.fetch == 1
    assert machine.panel.lamps.run == 0


def test_how_often_each_lamp_was_lit(machine: Machine) -> None:
    lamps = machine.panel.lamps
    seen = shares([lamps, lamps._replace(ma=0o6001, run=1)])
    assert tuple(seen) == Lamps._fields
    assert (seen["ma"], seen["run"]) == ((0.5, 0.5, *[0.0] * 9, 0.5), (0.5,))
    assert (len(seen["ir"]), sum(map(len, seen.values()))) == (3, 50)


def test_keys_are_dead_while_running_but_stop(machine: Machine) -> None:
    panel = machine.panel
    load_address(panel, 0o200)
    panel.start()
    before = panel.lamps, machine.pc, list(machine.core)
    panel.sr = 0o300
    for key in (panel.load_add, panel.exam, panel.dep, panel.start, panel.cont):
        key()
    assert (panel.lamps, machine.pc, list(machine.core)) == before
    panel.stop()
    panel.load_add()
    assert machine.pc == 0o300


def test_single_step_shows_each_cycle(machine: Machine) -> None:
    panel = machine.panel
    load_address(panel, 0o200)
    panel.sing_step = True
    panel.start()
    seen = [(panel.lamps, machine.pc)]
    for _ in range(5):
        panel.cont()
        seen.append((panel.lamps, machine.pc))
    shown = [
        ("F" if s.fetch else "D" if s.defer else "E", s.ma, s.mb, s.ir, s.ac, pc, s.run) for s, pc in seen
    ]
    assert shown == [
        ("F", 0o200, 0o1250, 1, 0, 0o201, 0),
        ("E", 0o250, 0o300, 1, 0o300, 0o201, 0),
        ("F", 0o201, 0o3650, 3, 0o300, 0o202, 0),
        ("D", 0o250, 0o300, 3, 0o300, 0o202, 0),
        ("E", 0o300, 0o300, 3, 0, 0o202, 0),
        ("F", 0o202, 0o7402, 7, 0, 0o203, 0),
    ]
    assert machine.ticks == 6 * 32


def test_a_cycle_ends_with_the_switch_or_with_protect() -> None:
    machine = Machine()
    machine.load({0o200: 0o3577, 0o177: 0o7600})
    machine.start(0o200)
    machine.panel.mem_prot = machine.panel.sing_step = True
    assert [machine.run().reason for _ in range(3)] == ["stop key", "stop key", "protect"]


@pytest.mark.parametrize(
    ("word", "core", "ac", "pc"),
    [
        (0o3577, 0o1111, 0, 0o201),  # DCA: AC is cleared all the same
        (0o2577, 0o1111, 0o7070, 0o201),  # ISZ: tests the word as it is
        (0o4577, 0o1111, 0o7070, 0o7601),  # JMS: PC goes there all the same
    ],
)
def test_mem_prot_stops_a_write(word: int, core: int, ac: int, pc: int) -> None:
    machine = Machine()
    machine.load({0o200: word, 0o177: 0o7600, 0o7600: 0o1111})
    machine.start(0o200)
    machine.ac = 0o7070
    machine.panel.mem_prot = True
    assert machine.run().reason == "protect"
    assert (machine.core[0o7600], machine.ac, machine.pc) == (core, ac, pc)
    assert (machine.panel.lamps.protect, machine.panel.lamps.run) == (1, 0)
    machine.panel.load_add()
    assert machine.panel.lamps.protect == 0


@pytest.mark.parametrize("stepped", [0, 1, 2, 3])
def test_stop_comes_before_an_interrupt_of_the_same_instruction(stepped: int) -> None:
    """ION, then TAD I 20 in 3 cycles; the flag is up: STOP in any of them leaves 0000 as it was."""
    machine = Machine()
    machine.load({0o200: 0o6001, 0o201: 0o1420, 0o202: 0o7001, 1: 0o7402, 0o20: 0o30, 0o30: 0o1111})
    machine.start(0o200)
    machine.processor.instruction()
    machine.teletype.transmitter.flag = 1
    for _ in range(stepped):
        machine.processor.cycle()
    machine.panel.stop()
    done = stepped > 0
    assert (machine.panel.lamps.run, machine.pc, machine.ac) == (0, 0o202 if done else 0o201, 0o1111 * done)
    assert (machine.core[0], machine.ion) == (0, 1)
    machine.panel.cont()
    machine.processor.instruction()
    assert (machine.core[0], machine.ac) == (0, 0o1112 if done else 0o1111)
    machine.processor.instruction()
    assert machine.core[0] == (0o203 if done else 0o202)


def test_stop_of_an_observer_ends_the_instruction_and_the_run(machine: Machine) -> None:
    class Stopper:
        def cycle(self, processor: Processor, interrupt: bool) -> None:
            if processor.state == 1:
                processor.stop()

        def waited(self, processor: Processor, instructions: int, ticks: int) -> None:
            pass

    machine.watch.observer = Stopper()
    machine.start(0o200)
    stop = machine.run()
    assert (stop.reason, stop.pc, machine.core[0o300], machine.ticks) == ("stop key", 0o202, 0o300, 64 + 96)


def test_start_initializes_and_cont_clears_nothing(machine: Machine) -> None:
    panel = machine.panel
    load_address(panel, 0o202)
    machine.ac, machine.link = 0o1234, 1
    machine.processor.ion = 1
    machine.teletype.transmitter.flag = machine.teletype.receiver.flag = 1
    machine.teletype.receiver.reader_run = 0
    panel.cont()
    assert machine.run().reason == "halt"
    assert (machine.ac, machine.link, machine.ion, machine.teletype.transmitter.flag) == (0o1234, 1, 1, 1)
    load_address(panel, 0o202)
    panel.start()
    assert (machine.ac, machine.link, machine.ion) == (0, 0, 0)
    assert [device.flag for device in machine.bus] == [0, 0]
    assert machine.teletype.receiver.reader_run == 1
    assert (machine.pc, machine.core[0o202]) == (0o202, 0o7402)


def test_mem_prot_is_the_last_page_alone_and_reading_is_free() -> None:
    machine = Machine()
    machine.load({0o200: 0o3577, 0o201: 0o1576, 0o202: 0o7402, 0o177: 0o7577, 0o176: 0o7600, 0o7600: 0o1111})
    machine.start(0o200)
    machine.ac = 0o7070
    machine.panel.mem_prot = True
    assert machine.run().reason == "halt"
    assert (machine.core[0o7577], machine.ac) == (0o7070, 0o1111)
