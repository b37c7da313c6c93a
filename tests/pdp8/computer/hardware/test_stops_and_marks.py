"""Why a run stops, what the PROTECT lamp shows, where breakpoints and watched words stop it."""

from typing import cast

import pytest

from pdp8.computer.machine import Machine
from pdp8.computer.watch import Observer
from tests.pdp8.computer.bench import core, machine


@pytest.mark.parametrize("word", ["7402", "7406", "7606", "7412", "7502"])
def test_every_word_with_the_hlt_bit_of_group_2_is_a_halt(word: str) -> None:
    assert machine(word).run().reason == "halt"


def test_a_stop_after_a_word_of_group_3_is_no_halt() -> None:
    """7403 has HLT's bit, in group 3."""

    class Stopper:
        def cycle(self, processor: object, interrupt: bool) -> None:
            m.stop()

    m = machine("7403 5200")
    m.watch.observer = cast(Observer, Stopper())
    assert (m.run().reason, m.mb) == ("stop key", 0o7403)


@pytest.mark.parametrize("by", ["instructions", "cycles", "load_add", "exam", "dep"])
def test_protect_goes_out_with_the_next_cycle_or_key(by: str) -> None:
    """MEM PROT stops the machine at DCA I 20; a NOP follows."""
    m = machine("3420 7000 7000 5203 20/ 7700")
    m.panel.mem_prot = True
    assert m.run().reason == "protect"
    assert m.panel.lamps.protect == 1
    m.panel.sing_step = by == "cycles"
    if by in ("instructions", "cycles"):
        m.run(instructions=1)
    else:
        getattr(m.panel, by)()
    assert m.panel.lamps.protect == 0


@pytest.mark.parametrize(
    ("words", "reason"),
    [
        ("3021", "breakpoint"),  # DCA 21
        ("2021", "breakpoint"),  # ISZ 21
        ("4021", "breakpoint"),  # JMS 21
        ("1021", "limit"),  # TAD 21 reads
        ("0021", "limit"),  # AND 21 reads
        ("1421", "limit"),  # TAD I 21 reads the pointer
        ("1410", "breakpoint"),  # TAD I 10 increments it
        ("3410", "breakpoint"),  # DCA I 10 writes the pointer first, then another word
    ],
)
def test_a_watched_word_stops_once_where_it_is_written(words: str, reason: str) -> None:
    m = machine(f"{words} 7000 7000 7000 7000 5205 10/ 300")
    m.watch.writes = {0o10, 0o21}
    assert m.run(instructions=3).reason == reason
    assert m.instructions == (1 if reason == "breakpoint" else 3)
    assert m.run(instructions=3).reason != "breakpoint"


@pytest.mark.parametrize("observed", [False, True])
def test_a_jms_to_a_breakpoint_stops(observed: bool) -> None:
    """JMS 210: its first word, where the return address goes, is never executed."""
    m = machine("4210 7000 211/ 7000 5212")
    m.watch.breakpoints = {0o210}
    m.watch.writes = {0o7777} if observed else set()
    assert m.run(instructions=5)[:2] == ("breakpoint", 0o211)


@pytest.mark.parametrize("at", [0o203, 0o7775, 0o7776, 0o7777])
@pytest.mark.parametrize("skip", [0o7410, 0o7440, 0o2020, 0o7610])
def test_a_breakpoint_after_a_skip_stops(skip: int, at: int) -> None:
    """NOP, the skip, and past the word it skips the breakpoint; after 7777 comes 0000."""
    m = Machine()
    m.load(core(f"{at - 1:o}/ 7000 {skip:o} 7001 7001 7001 20/ 7777"))
    m.start(at - 1)
    m.watch.breakpoints = {at + 2 & 0o7777}
    assert m.run(seconds=0.01).reason == "breakpoint"
    assert (m.pc, m.instructions, m.ac) == (at + 2 & 0o7777, 2, 0)


def test_setting_pc_begins_with_a_fetch() -> None:
    """In the middle of TAD I 20."""
    m = machine("1420 20/ 30 30/ 5 300/ 7402")
    m.panel.sing_step = True
    m.run()
    m.panel.sing_step = False
    m.pc = 0o300
    assert m.run().reason == "halt"
    assert (m.ac, m.mb) == (0, 0o7402)


def test_a_protected_write_writes_nothing() -> None:
    m = machine("3420 7000 20/ 7700")
    m.panel.mem_prot = True
    m.watch.writes = {0o7700}
    m.watch.instruction(m.processor)
    assert not m.watch.reached
