"""What a run goes on until, and steps forward: a program that prints, stopped where it should be."""

from itertools import product

import pytest

from pdp8.computer.machine import Machine
from pdp8.computer.past import rewind
from pdp8.computer.past.history import History
from pdp8.computer.stop import Reason
from pdp8.computer.use import goals
from tests.pdp8.computer.bench import machine


@pytest.fixture
def printing() -> Machine:
    """CLA, TAD 210, TLS, TSF, JMP .-1, DCA 211, ISZ 212, JMP 200: it prints and punches 301 eight times."""
    return machine("7200 1210 6046 6041 5203 3211 2212 5200 301 0 7770")


@pytest.mark.parametrize(
    ("kind", "address", "reason", "at", "word"),
    [
        ("address", 0o205, Reason.BREAKPOINT, 0o205, 0),
        ("word", 0o211, goals.REACHED, 0o206, 0o301),
        ("flag", 0, goals.REACHED, 0o203, 0),
        ("frame", 0, goals.REACHED, 0o203, 0),
        ("character", 0, goals.REACHED, 0o203, 0),
    ],
)
@pytest.mark.parametrize("ticks", [0, 1, 20_000])
def test_a_run_ends_at_its_goal(
    printing: Machine, kind: str, address: int, reason: str, at: int, word: int, ticks: int
) -> None:
    """By cycles, by single instructions and by longer runs; it says what happened. When that is over, nothing
    is watched that was not before.
    """
    goal = goals.until(printing, kind, address)
    ended: str = Reason.LIMIT
    while ended == Reason.LIMIT and printing.elapsed < 3:
        ended = goal.run(printing, ticks) if ticks else goal.cycle(printing)
    assert bool(goal.said) == (reason == goals.REACHED)
    assert (ended, printing.core[0o211]) == (reason, word)
    assert printing.pc in (at, at + 1)
    goal.over()
    assert not printing.watch.breakpoints | printing.watch.writes


def test_the_flag_that_rises_is_named(printing: Machine) -> None:
    reading = machine("6031 5200")  # KSF, JMP 200
    reading.teletype.keyboard.press(b"A")
    for running, named in ((printing, "printer"), (reading, "keyboard")):
        goal = goals.until(running, "flag", 0)
        while goal.run(running, 2_000_000) == Reason.LIMIT:
            assert running.elapsed < 3
        assert named in str(goal.said)


def test_a_character_is_one_that_is_read_or_typed_or_printed(printing: Machine) -> None:
    """KSF, JMP 200: of a tape, and of a key."""
    typed = machine("6031 5200")
    typed.teletype.keyboard.press(b"A")
    for running, counted in (
        (printing, printing.teletype.printer.frames),
        (machine("6031 5200", tape=b"A"), b"-"),
        (typed, b"-"),
    ):
        goal = goals.until(running, "character", 0)
        while not goal.said:
            goal.run(running, 2_000)
            assert running.elapsed < 0.2
        assert len(counted) == 1


def test_no_breakpoint_is_stepped_over() -> None:
    """Whatever the length of a slice: a loop's own, a JMS's, and beside another goal; in field 1 too."""
    kinds = (0, ""), (0, "word"), (0, "frame"), (1, "")
    for (field, kind), ticks in product(kinds, range(1, 200)):
        m = machine("7001 4204 5200 7402 0 5604", field=field)  # IAC, JMS 204, JMP 200; 204: JMP I 204
        goal = goals.until(m, kind, 0o300) if kind else goals.Goal()
        for breakpoint in (0o200, 0o204, 0o205):
            m.watch.breakpoints = {field << 12 | breakpoint}
            reasons = []
            while Reason.BREAKPOINT not in reasons:
                reasons.append(goal.run(m, ticks))
                assert m.ac < 5, (field, kind, ticks, breakpoint)
            m.ac = 0


@pytest.mark.parametrize("ticks", [0, 10_000])
def test_a_run_says_why_it_ended(ticks: int) -> None:
    """MEM PROT, HLT and a breakpoint, also while a word is waited for."""
    for words, reason in (("3300 7402", Reason.HALT), ("3610 5201 0 0 0 0 0 0 7700", Reason.PROTECT)):
        m = machine(words)
        m.panel.mem_prot = True
        goal = goals.until(m, "word", 0o377)
        ended: str = Reason.LIMIT
        while ended == Reason.LIMIT and m.elapsed < 1:
            ended = goal.run(m, ticks) if ticks else goal.cycle(m)
        assert ended == reason


def test_a_word_that_stays_the_same_is_no_goal(printing: Machine) -> None:
    """0211 is written eight times with the same word: the program runs to its end."""
    printing.core[0o211] = 0o301
    goal = goals.until(printing, "word", 0o211)
    reasons = {goal.run(printing, 20_000) for _ in range(1000)}
    assert Reason.BREAKPOINT not in reasons


def test_steps_lead_forward_and_back(printing: Machine) -> None:
    """By each unit, recorded as one: back leads before what forward came to."""
    printing.core[0o210] = 0o200  # an end of block
    history = History(printing)
    for unit, back, most in (
        ("cycle", rewind.cycles, 32),
        ("instruction", rewind.instructions, 64),
        ("character", rewind.characters, 2_000_000),
        ("block", rewind.blocks, 2_000_000),
    ):
        before = printing.processor.clock
        assert goals.forward(history, unit) == Reason.LIMIT
        after = printing.processor.clock
        assert before < after <= before + most
        assert printing.recorder is history
        back(history)
        assert before <= printing.processor.clock < after
    goals.forward(history, "character")
    assert len(printing.teletype.printer.frames) == 1


@pytest.mark.parametrize(("unit", "seconds"), [("character", 3), ("block", 30)])
def test_a_step_that_finds_nothing_ends(unit: str, seconds: int) -> None:
    """ISZ 210, JMP .-1, JMP .-2."""
    m = machine("2210 5200 5200")
    assert goals.forward(History(m), unit) == Reason.LIMIT
    assert m.elapsed == pytest.approx(seconds, abs=1e-4)


def test_a_cycle_that_halts_says_so() -> None:
    m = machine("7402")
    assert goals.forward(History(m), "cycle") == Reason.HALT
