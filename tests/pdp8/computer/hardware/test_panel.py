"""Every key and switch, what the lamps show after each, and why it stopped."""

import pytest

from pdp8.computer.hardware.panel import Lamps, Panel, shares
from pdp8.computer.hardware.processor import Processor
from pdp8.computer.machine import Machine
from tests.pdp8.computer.bench import core, machine


class Stopper:
    """An observer that presses STOP after a cycle of a major state."""

    def __init__(self, state: int) -> None:
        self.state = state

    def cycle(self, processor: Processor, interrupt: bool) -> None:
        if processor.state == self.state:
            processor.stop()

    def waited(self, processor: Processor, instructions: int, ticks: int) -> None:
        """Nothing is passed over."""


@pytest.fixture
def standing() -> Machine:
    """A machine that stands still: TAD 250, DCA I 250, HLT."""
    made = Machine()
    made.load(core("1250 3650 7402 250/ 300 300/ 1111 7777/ 4321"))
    return made


def load_address(panel: Panel, address: int) -> None:
    panel.sr = address
    panel.load_add()


def test_how_often_each_lamp_was_lit() -> None:
    lamps = Machine().panel.lamps
    assert lamps == Lamps(*[0] * 15)._replace(fetch=1)
    seen = shares([lamps, lamps._replace(ma=0o6001, run=1)])
    assert tuple(seen) == Lamps._fields
    assert (seen["ma"], seen["run"]) == ((0.5, 0.5, *[0.0] * 9, 0.5), (0.5,))
    assert (len(seen["ir"]), sum(map(len, seen.values()))) == (3, 50)


def test_keys_are_dead_while_running_but_stop(standing: Machine) -> None:
    panel = standing.panel
    load_address(panel, 0o200)
    panel.start()
    before = panel.lamps, standing.pc, list(standing.core)
    panel.sr = 0o300
    for key in (panel.load_add, panel.exam, panel.dep, panel.start, panel.cont):
        key()
    assert (panel.lamps, standing.pc, list(standing.core)) == before
    panel.stop()
    panel.load_add()
    assert standing.pc == 0o300


def test_single_step_shows_each_cycle(standing: Machine) -> None:
    panel = standing.panel
    load_address(panel, 0o200)
    panel.sing_step = True
    seen = []
    for key in (panel.start, *[panel.cont] * 5):
        key()
        s = panel.lamps
        state = "F" if s.fetch else "D" if s.defer else "E"
        seen.append(f"{state} {s.ma:04o} {s.mb:04o} {s.ir} {s.ac:04o} {standing.pc:04o} {s.run}")
    assert seen == [
        "F 0200 1250 1 0000 0201 0",
        "E 0250 0300 1 0300 0201 0",
        "F 0201 3650 3 0300 0202 0",
        "D 0250 0300 3 0300 0202 0",
        "E 0300 0300 3 0000 0202 0",
        "F 0202 7402 7 0000 0203 0",
    ]
    assert standing.ticks == 6 * 32


def test_a_cycle_ends_with_the_switch_or_with_protect() -> None:
    m = machine("3577 177/ 7600")
    m.panel.mem_prot = m.panel.sing_step = True
    assert [m.run().reason for _ in range(3)] == ["stop key", "stop key", "protect"]


@pytest.mark.parametrize(
    ("word", "ac", "pc"),
    [
        ("3577", 0, 0o201),  # DCA: AC is cleared all the same
        ("2577", 0o7070, 0o201),  # ISZ: tests the word as it is
        ("4577", 0o7070, 0o7601),  # JMS: PC goes there all the same
    ],
)
def test_mem_prot_stops_a_write(word: str, ac: int, pc: int) -> None:
    m = machine(f"{word} 177/ 7600 7600/ 1111", ac=0o7070)
    m.panel.mem_prot = True
    assert m.run().reason == "protect"
    assert (m.core[0o7600], m.ac, m.pc) == (0o1111, ac, pc)
    assert (m.panel.lamps.protect, m.panel.lamps.run) == (1, 0)


def test_mem_prot_is_the_last_page_alone_and_reading_is_free() -> None:
    m = machine("3577 1576 7402 176/ 7600 7577 7600/ 1111", ac=0o7070)
    m.panel.mem_prot = True
    assert m.run().reason == "halt"
    assert (m.core[0o7577], m.ac) == (0o7070, 0o1111)


@pytest.mark.parametrize("stepped", [0, 1, 2, 3])
def test_stop_comes_before_an_interrupt_of_the_same_instruction(stepped: int) -> None:
    """ION, then TAD I 20 in 3 cycles; the flag is up: STOP in any of them leaves 0000 as it was."""
    m = machine("6001 1420 7001 1/ 7402 20/ 30 30/ 1111")
    m.processor.instruction()
    m.teletype.transmitter.flag = 1
    for _ in range(stepped):
        m.processor.cycle()
    m.panel.stop()
    done = stepped > 0
    assert (m.panel.lamps.run, m.pc, m.ac) == (0, 0o202 if done else 0o201, 0o1111 * done)
    assert (m.core[0], m.ion) == (0, 1)
    m.panel.cont()
    m.processor.instruction()
    assert (m.core[0], m.ac) == (0, 0o1112 if done else 0o1111)
    m.processor.instruction()
    assert m.core[0] == (0o203 if done else 0o202)


def test_stop_of_an_observer_ends_the_instruction_and_the_run() -> None:
    """TAD 250, then DCA I 250, stopped at its DEFER."""
    m = machine("1250 3650 7402 250/ 300")
    m.watch.observer = Stopper(1)
    assert m.run()[:2] == ("stop key", 0o202)
    assert (m.core[0o300], m.ticks) == (0o300, 64 + 96)


def test_start_initializes_and_cont_clears_nothing() -> None:
    m = machine("7402", ac=0o1234, link=1, ion=1)
    transmitter, receiver = m.teletype.transmitter, m.teletype.receiver
    transmitter.flag = receiver.flag = 1
    receiver.reader_run = 0
    assert m.run().reason == "halt"
    assert (m.ac, m.link, m.ion, transmitter.flag) == (0o1234, 1, 1, 1)
    load_address(m.panel, 0o200)
    m.panel.start()
    assert (m.ac, m.link, m.ion, transmitter.flag, receiver.flag) == (0, 0, 0, 0, 0)
    assert (receiver.reader_run, m.pc, m.core[0o200]) == (1, 0o200, 0o7402)


@pytest.mark.parametrize("word", ["7402", "7406", "7606", "7412", "7502"])
def test_every_word_with_the_hlt_bit_of_group_2_is_a_halt(word: str) -> None:
    assert machine(word).run().reason == "halt"


def test_a_stop_after_a_word_of_group_3_is_no_halt() -> None:
    """7403 has HLT's bit, in group 3."""
    m = machine("7403 5200")
    m.watch.observer = Stopper(0)
    assert (m.run().reason, m.mb) == ("stop key", 0o7403)
