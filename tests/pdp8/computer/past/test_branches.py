"""A machine that was copied, saved and restored, or taken back goes on as the one that was left alone: with
breakpoints, keys and SING STEP, to the same tick, through waits and to the same end.
"""

import copy
import random
from collections.abc import Sequence

import pytest

from pal.isa import FETCH
from pdp8.computer.hardware.fields import Values
from pdp8.computer.past import rewind, state
from pdp8.computer.past.history import History
from tests.pdp8.computer.bench import machine
from tests.pdp8.computer.lockstep.sides import InPython
from tests.pdp8.computer.lockstep.situations import Act, Situation, at_the_panel, situation
from tests.sampling import some

AT_ONCE = 40
LONGEST = 20_000
DONE_TO_THE_HISTORY = ("record", "back", "save_and_restore", "watch")


def begun(seed: int) -> tuple[InPython, Sequence[Act]]:
    """Return a machine in the middle of its situation, and what is still done to it."""
    draw = random.Random(seed)
    chosen = at_the_panel(seed) if seed % 2 else situation(seed, LONGEST)
    places = frozenset(draw.choices([*chosen.words], k=draw.choice((0, 1, 3, 40))))
    acts = [act for act in chosen.acts if act.name not in (*DONE_TO_THE_HISTORY, "breakpoints")][:80]
    side = InPython("compiled", Situation(chosen.fast, chosen.words, ()))
    side.marks = places
    middle = draw.randrange(len(acts))
    for act in acts[:middle]:
        side.do(act)
    while side.machine.processor.next != FETCH:  # a step back undoes whole instructions
        side.machine.run(cycles=1)
    return side, (Act("run", (None, 1)), *acts[middle:])


def another(side: InPython, machine: object) -> InPython:
    """Return the same operator at another machine."""
    other = copy.copy(side)
    other.machine = machine
    return other


def take_back(side: InPython, acts: Sequence[Act]) -> None:
    """Do the acts, and undo them."""
    history, before = History(side.machine), side.machine.instructions
    for act in acts:
        side.do(act)
    rewind.instructions(history, side.machine.instructions - before)
    history.close()


def went_on(side: InPython, acts: Sequence[Act]) -> list[Values]:
    """Do the acts; return the whole state after each, and why a run ended."""
    return [{"reason": side.do(act), **side.machine.values()} for act in acts]


def different(ours: Values, theirs: Values) -> Values:
    """Return what differs, but for core."""
    return {
        name: (ours[name], theirs[name]) for name in ours if ours[name] != theirs[name] and name != "core"
    }


@pytest.mark.parametrize(
    "seeds",
    [
        range(AT_ONCE),
        pytest.param(range(40, 40 + some(1960)), marks=pytest.mark.slow("2,000 cases by WHOLE=1")),
    ],
)
def test_a_branch_goes_on_as_the_trunk(seeds: Sequence[int]) -> None:
    for seed in seeds:
        trunk, acts = begun(seed)
        branches = {
            "copied": another(trunk, copy.deepcopy(trunk.machine)),
            "restored": another(trunk, state.restore(state.save(trunk.machine))),
            "taken back": another(trunk, copy.deepcopy(trunk.machine)),
        }
        take_back(branches["taken back"], acts[:9])
        expected = went_on(trunk, acts)
        for how, branch in branches.items():
            for at, (ours, theirs) in enumerate(zip(went_on(branch, acts), expected, strict=True)):
                assert ours == theirs, f"seed {seed}, {how}: {acts[at]}, {different(ours, theirs)}"


@pytest.mark.parametrize("before", [3000, 7000, 11_000])
def test_a_branch_that_waits_for_ever_says_so_at_the_same_instruction(before: int) -> None:
    """NOP, NOP, JMP .-2, with a breakpoint elsewhere: its turns are compared every 10 ms."""
    trunk = machine("7000 7000 5200")
    trunk.watch.breakpoints.add(0o300)
    trunk.run(instructions=before)
    branches = [copy.deepcopy(trunk), state.restore(state.save(trunk)), copy.deepcopy(trunk)]
    history = History(branches[2])
    for each in branches:
        each.watch.breakpoints.add(0o300)
    branches[2].run(instructions=500)
    branches[2].run()
    rewind.instructions(history, branches[2].instructions - before)
    ended = [(each.run().reason, each.instructions, each.ticks) for each in (trunk, *branches)]
    assert ended == [ended[0]] * 4
    assert ended[0][0] == "idle"
