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
