"""What the lamps show, and why it stopped; the lockstep presses every key."""

import pytest

from pdp8.computer.hardware.panel import Lamps, shares
from pdp8.computer.hardware.processor import Processor
from pdp8.computer.machine import Machine
from tests.pdp8.computer.bench import machine


class Stopper:
    """An observer that presses STOP after a cycle of a major state."""

    def __init__(self, state: int) -> None:
        self.state = state

    def cycle(self, processor: Processor, interrupt: bool) -> None:
        if processor.state == self.state:
            processor.stop()

    def waited(self, processor: Processor, instructions: int, ticks: int) -> None:
        """Nothing is passed over."""


def test_how_often_each_lamp_was_lit() -> None:
    lamps = Machine().panel.lamps
    assert lamps == Lamps(*[0] * 15)
    seen = shares([lamps, lamps._replace(ma=0o6001, run=1)])
    assert tuple(seen) == Lamps._fields
    assert (seen["ma"], seen["run"]) == ((0.5, 0.5, *[0.0] * 9, 0.5), (0.5,))
    assert (len(seen["ir"]), sum(map(len, seen.values()))) == (3, 50)


def test_single_step_shows_each_cycle() -> None:
    """TAD 250, DCA I 250, HLT."""
    standing = machine("1250 3650 7402 250/ 300 300/ 1111")
    panel = standing.panel
    panel.stop()
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


def test_stop_of_an_observer_ends_the_instruction_and_the_run() -> None:
    """TAD 250, then DCA I 250, stopped at its DEFER."""
    m = machine("1250 3650 7402 250/ 300")
    m.watch.observer = Stopper(1)
    assert m.run()[:2] == ("stop key", 0o202)
    assert (m.core[0o300], m.ticks) == (0o300, 64 + 96)


@pytest.mark.parametrize(
    ("word", "reason"),
    [*((word, "halt") for word in ("7402", "7406", "7606", "7412", "7502")), ("7403", "stop key")],
)
def test_only_the_hlt_bit_of_group_2_is_a_halt(word: str, reason: str) -> None:
    """STOP is pressed too; 7403 has the bit, in group 3."""
    m = machine(f"{word} 5200")
    m.watch.observer = Stopper(0)
    assert (m.run().reason, f"{m.mb:o}") == (reason, word)


class Thrower:
    """An observer that throws SING STEP in a cycle of a major state."""

    def __init__(self, thrown: Machine, state: int) -> None:
        self.machine = thrown
        self.state = state

    def cycle(self, processor: Processor, interrupt: bool) -> None:
        if processor.state == self.state:
            self.machine.panel.sing_step = True

    def waited(self, processor: Processor, instructions: int, ticks: int) -> None:
        """Nothing is passed over."""


@pytest.mark.parametrize(("state", "ma"), [(0, 0o200), (1, 0o250), (2, 0o300)])
def test_sing_step_stops_a_running_machine_in_any_cycle(state: int, ma: int) -> None:
    """DCA I 250; then it goes on to its end by CONT."""
    m = machine("3650 5201 250/ 300", ac=0o1234)
    m.watch.observer = Thrower(m, state)
    assert (m.run().reason, m.panel.lamps[5:8].index(1), m.ma) == ("stop key", state, ma)
    for _ in range(2 - state):
        m.panel.cont()
    assert (m.core[0o300], m.pc, m.ticks) == (0o1234, 0o201, 96)


def test_cont_by_the_panel_and_by_the_program_let_the_same_time_pass() -> None:
    """A key is pressed at tick 0; 60,000 cycles of KSF, JMP .-1 under SING STEP see its flag rise."""
    by_panel, by_run = machine("6031 5200 5202"), machine("6031 5200 5202")
    for m, cont in ((by_panel, by_panel.panel.cont), (by_run, by_run.run)):
        m.panel.sing_step = True
        m.teletype.keyboard.press(b"A")
        for _ in range(60_000):
            cont()
    assert by_panel.pc == 0o202
    assert by_panel.values() == by_run.values()
