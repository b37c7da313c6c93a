"""What a run goes on until, and steps forward: hello.pal, stopped where it should be."""

import pytest

from pdp8.computer.machine import Machine
from pdp8.computer.past import rewind
from pdp8.computer.past.history import History
from pdp8.computer.stop import Reason
from pdp8.computer.use import goals
from pdp8.computer.use.program import read
from tapes import shelf

_PRINTS = [0o7200, 0o1210, 0o6046, 0o6041, 0o5203, 0o3211, 0o2212, 0o5200, 0o0301, 0o0000, 0o7770]
"""CLA, TAD 0210, TLS, TSF, JMP .-1, DCA 0211, ISZ 0212, JMP 0200; an A, what was printed, minus eight."""


@pytest.fixture
def machine() -> Machine:
    """A machine that prints and punches eight times, and is started."""
    machine = Machine()
    machine.load(enumerate(_PRINTS, 0o200))
    machine.start(0o200)
    return machine


@pytest.mark.parametrize(
    ("kind", "address", "reason", "at"),
    [
        ("address", 0o205, Reason.BREAKPOINT, (0o205, 0o0000)),
        ("word", 0o211, Reason.BREAKPOINT, (0o206, 0o0301)),
        ("flag", 0, goals.REACHED, (0o203, 0o0000)),
        ("frame", 0, goals.REACHED, (0o203, 0o0000)),
        ("character", 0, goals.REACHED, (0o203, 0o0000)),
    ],
)
def test_a_run_ends_at_its_goal(
    machine: Machine, kind: str, address: int, reason: str, at: tuple[int, int]
) -> None:
    """And when that is over, nothing is watched that was not before."""
    goal = goals.until(machine, kind, address)
    ended: str = Reason.LIMIT
    while ended == Reason.LIMIT:
        ended = goal.run(machine, 20_000)
    assert (ended, machine.core[0o211]) == (reason, at[1])
    assert machine.pc in (at[0], at[0] + 1)
    goal.over()
    assert not machine.watch.breakpoints | machine.watch.writes


def test_a_word_that_stays_the_same_is_no_goal(machine: Machine) -> None:
    """0211 is written eight times with the same word: after the first the program runs to its end."""
    machine.processor.deposit(0o211, 0o301)
    goal = goals.until(machine, "word", 0o211)
    reasons = {goal.run(machine, 20_000) for _ in range(1000)}
    assert Reason.BREAKPOINT not in reasons


def test_steps_lead_forward_and_back() -> None:
    """By each unit, recorded as one: back leads before what forward came to."""
    machine = Machine()
    machine.load(read(shelf.read_bundled("hello.pal"), "hello.pal").words)
    machine.start(0o200)
    history = History(machine)
    undo = {"cycle": rewind.cycles, "instruction": rewind.instructions, "character": rewind.characters}
    for unit, back in undo.items():
        before = machine.processor.clock
        assert goals.forward(history, unit) == Reason.LIMIT
        after = machine.processor.clock
        back(history)
        assert before <= machine.processor.clock < after
    goals.forward(history, "character")
    assert len(machine.teletype.printer.frames) == 1
