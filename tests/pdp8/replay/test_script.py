"""Any instant of a day again: beside a machine that does the day forwards only, and by steps."""

import random

import pytest

from pdp8.computer.hardware.signals import FRAME
from pdp8.replay import Afternoon
from pdp8.replay.script import Script, Unit
from tests.pdp8.web.follower import Follower, state


@pytest.fixture(scope="module")
def script(circle: Afternoon) -> Script:
    """The circle's day."""
    return Script(circle.course)


def test_any_instant_in_any_order(script: Script, circle: Afternoon) -> None:
    """Thirty of the whole afternoon, thirty of the translation, to the cycle."""
    draw, act = random.Random(5), circle.acts[4]
    ticks = [draw.randrange(*of) for of in ((0, script.end), (act.starts, act.ends)) for _ in range(30)]
    follower, expected = Follower(circle), {}
    for tick in sorted(ticks):
        follower.to(tick)
        expected[tick] = state(follower.machine)
    for tick in ticks:
        script.to(tick)
        assert state(script.machine) == expected[tick], tick


@pytest.mark.parametrize(
    ("unit", "most"), [(Unit.CYCLE, 117), (Unit.INSTRUCTION, 250), (Unit.CHARACTER, FRAME + 5000)]
)
def test_a_step_back_leads_to_where_the_step_began(
    script: Script, circle: Afternoon, unit: Unit, most: int
) -> None:
    """While characters are translated, wherever the first step leads."""
    draw = random.Random(6)
    for _ in range(10):
        script.to(draw.randrange(circle.acts[4].starts + 60 * 10 * FRAME, circle.acts[4].ends - 10 * FRAME))
        script.next(unit)
        before = script.now
        script.next(unit)
        assert 0 < script.now - before <= most
        script.previous(unit)
        assert script.now == before


def test_blocks_and_rows(script: Script, circle: Afternoon) -> None:
    """A block of the terminal's is a line of 27 frames; of the Hydra-Point's, its reading and its move."""
    script.to(100 * FRAME)
    script.next(Unit.BLOCK)
    first = script.now
    script.next(Unit.BLOCK)
    assert script.now - first == 27 * FRAME
    script.to(circle.mill_starts)
    script.next(Unit.CHARACTER)
    assert script.now - circle.mill_starts == FRAME
    script.next(Unit.BLOCK)
    script.previous(Unit.BLOCK)
    assert script.now == circle.mill_starts
