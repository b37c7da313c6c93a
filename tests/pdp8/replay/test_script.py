"""Any instant of a day again: beside a machine that does the day forwards only, and by steps."""

import random

import pytest

from pdp8.computer.hardware.signals import FRAME
from pdp8.replay import Afternoon, replay
from pdp8.replay.day import Kind
from pdp8.replay.script import Script, Unit
from tests.pdp8.web.follower import Follower, state


@pytest.fixture(scope="module")
def script(circle: Afternoon) -> Script:
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


def test_steps_lead_there_and_back() -> None:
    """From an act's begin, into the program after a character, and over what ends an act; the machine is as
    one that goes forwards only, within a cycle too, and on from a snapshot at the tick of each action.
    """
    day = replay("drill")
    script, seen = Script(day.course), dict[int, dict[str, object]]()
    for action in reversed(day.actions):
        script.to(action.at)
    script.to(0)
    for action in day.actions:
        script.to(action.at + FRAME)
        seen[script.now] = state(script.machine)

    def steps(unit: Unit, most: int) -> None:
        instants = [script.now]
        while script.now < script.end and len(instants) < most:
            script.next(unit)
            instants.append(script.now)
            seen[script.now] = state(script.machine)
        assert sorted(set(instants)) == instants
        for before in reversed(instants[1:-1]):
            script.previous(unit)
            assert script.now == before, (script.act.name, unit)
            script.to(before + 5)
            seen[before + 5] = state(script.machine)
            script.to(before)

    for act in day.acts:
        for unit in (Unit.INSTRUCTION, Unit.CYCLE, Unit.CHARACTER):
            script.to(act.ends - 100)
            steps(unit, 6)
        if act.kind in (Kind.LOAD, Kind.TRANSLATE):
            script.to((act.starts + act.ends) // 2)
            script.next(Unit.CHARACTER)
            steps(Unit.INSTRUCTION, 9)
            steps(Unit.CYCLE, 9)
        if act.kind not in (Kind.TOGGLE, Kind.LOAD):
            script.to(act.starts)
            steps(Unit.BLOCK, 3)
    follower = Follower(day)
    for tick in sorted(seen):
        follower.to(tick)
        expected = state(follower.machine)
        for device in ("03", "04"):  # what a run of whole loops has forgotten
            expected[f"devices {device} tested"] = seen[tick][f"devices {device} tested"]
        assert seen[tick] == expected, tick


def test_what_is_in_the_reader_and_what_was_done_last() -> None:
    day = replay("drill")
    script = Script(day.course)
    script.to(0)
    assert (script.mounted, script.action) == ("", None)
    mounts = [action for action in day.actions if action.key == "mount"]
    assert [action.value for action in mounts] == ["bin.rim", "eia.bin", "drill.asc"]
    for before, action in zip(["", "bin.rim", "eia.bin"], mounts, strict=True):
        script.to(action.at - 1)
        assert script.mounted == before
        script.to(action.at)
        assert script.mounted == action.value
    for tick, now in ((-1, 0), (script.end, script.end), (script.end + 1, script.end)):
        script.to(tick)
        assert script.now == now
    script.next(Unit.BLOCK)
    assert script.now == script.end
    script.to(0)
    script.previous(Unit.CYCLE)
    assert script.now == 0
