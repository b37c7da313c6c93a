"""A step of the page: forward and back by block, character, instruction and memory cycle."""

from itertools import pairwise

from pdp8.computer.hardware.signals import TICKS_PER_SECOND
from pdp8.replay import Afternoon
from tests.pdp8.conftest import Ask

FRAME = TICKS_PER_SECOND // 10

_THERE_AND_BACK = """(afternoon, walks) => walks.map(({ from, unit, steps }) => {
  afternoon.to(from);
  const there = [], back = [];
  while (there.length < steps && afternoon.now < afternoon.end) {
    afternoon.next(unit);
    there.push(afternoon.now);
  }
  for (const _ of there) { back.push(afternoon.now); afternoon.previous(unit); }
  return [there, back.reverse()];
})"""
"""Step forward, then as often back; the instants of both, in the order of time."""


def _start(afternoon: Afternoon) -> int:
    """Return the tick of the translation's START."""
    return next(action.at for action in reversed(afternoon.actions) if action.key == "start")


def _walk(ask: Ask, begin: int, unit: str, steps: int) -> list[int]:
    """Return where that many steps lead, one after another."""
    there: list[int] = ask(_THERE_AND_BACK, [{"from": begin, "unit": unit, "steps": steps}])[0][0]
    return there


def test_steps_back_lead_where_steps_forward_came_from(circle: Afternoon, ask: Ask) -> None:
    """By every unit, from the beginning of every act and from every START."""
    begins = [act.starts for act in circle.acts] + [
        action.at for action in circle.actions if action.key == "start"
    ]
    walks = [
        {"from": begin, "unit": unit, "steps": 60}
        for begin in begins
        for unit in ("block", "character", "instruction", "cycle")
    ]
    for walk, (there, back) in zip(walks, ask(_THERE_AND_BACK, walks), strict=True):
        assert there == back, walk
        assert there == sorted(set(there)), walk


def test_a_cycle_is_32_ticks_and_an_iot_85(circle: Afternoon, ask: Ask) -> None:
    """TLS, KCC, JMS (two cycles), KSF, JMP: what the first steps of eia.pal take."""
    start = _start(circle)
    there = [start, *_walk(ask, start, "cycle", 6)]
    assert [after - before for before, after in pairwise(there)] == [85, 85, 32, 32, 85, 32]


def test_a_character_is_a_tenth_of_a_second(circle: Afternoon, ask: Ask) -> None:
    """In the translation from the second character on, at the terminal, and a row at the Hydra-Point."""
    for begin in (_start(circle) + 5 * FRAME, 0, circle.mill_starts):
        there = _walk(ask, begin, "character", 19)
        assert {after - before for before, after in pairwise(there)} == {FRAME}


def test_a_block_is_27_frames(circle: Afternoon, ask: Ask) -> None:
    """A line of the part program is 19 characters, CR, LF and 6 RUBOUTs."""
    there = _walk(ask, _start(circle) + 30 * FRAME, "block", 50)
    assert {after - before for before, after in pairwise(there)} == {27 * FRAME}
