"""A drill at the panel in a terminal: the card, what the coach says, and the kiosk that clears the room."""

from collections.abc import Awaitable, Callable

import pytest

pytest.importorskip("textual", reason="Textual, the extra `panel`, is not installed")

from textual.pilot import Pilot

from pdp8.console.app import Room
from pdp8.console.opening import opening
from pdp8.console.pages import DrillCard
from pdp8.lessons.drill import Coach, find
from tests.conftest import Shell, awaited


def drilled(name: str, left_alone: float | None = None) -> tuple[Room, Coach]:
    session, programs = opening(clock=lambda: 0.0)
    tapes = ("bin.rim", programs[1].words), ("eia.bin", programs[2].words)
    coach = Coach(find(name, tapes), session.machine, left_alone)
    return Room(session, programs, ticking=False, coach=coach), coach


def card(room: Room) -> str:
    return room.screen_stack[0].query_one(DrillCard).render().plain


def test_the_card_says_what_is_wrong_and_what_is_next() -> None:
    room, coach = drilled("rim")

    async def scene(pilot: Pilot[None]) -> None:
        await pilot.press(*"7757l")
        assert "switch 11 should be down: 7756, not 7757" in card(room)
        assert "▸ 7756  LOAD ADD" in card(room)
        await pilot.press(*"7756l", *"6032d")
        assert "✓ 6032  DEP       into 7756" in card(room)
        assert room.session.machine.core[0o7756] == 0o6032
        await pilot.press("r")
        assert not room.session.said.startswith("toggling")
        await pilot.press("x")
        assert (coach.at, room.session.machine.core[0o7756]) == (0, 0)

    run(room, scene)


def test_a_kiosk_closes_what_a_visitor_left_open() -> None:
    room, coach = drilled("rim", left_alone=60)

    async def scene(pilot: Pilot[None]) -> None:
        await pilot.press(*"7756l", "o")
        await pilot.pause()
        assert len(room.screen_stack) == 2
        room.turn(61)
        await pilot.pause()
        assert (len(room.screen_stack), coach.at) == (1, 0)
        await pilot.press("q")
        assert room.is_running
        await pilot.press(*"7756l", *"6032d")
        assert coach.at == 2

    run(room, scene)


def test_typing_is_being_there() -> None:
    room, coach = drilled("rim", left_alone=60)

    async def scene(pilot: Pilot[None]) -> None:
        await pilot.press(*"7756l")
        for _ in range(5):
            room.turn(40)
            await pilot.press("7")
        assert coach.at == 1

    run(room, scene)


def run(room: Room, scene: Callable[[Pilot[None]], Awaitable[None]]) -> None:
    async def play() -> None:
        async with room.run_test(size=(160, 45)) as pilot:
            await scene(pilot)

    awaited(play())


@pytest.mark.parametrize(
    ("options", "says"),
    [("--kiosk", b"--kiosk means nothing without --drill"), ("eia.pal --drill rim", b"goes with no PROGRAM")],
)
def test_options_that_mean_nothing_together(options: str, says: bytes, shell: Shell) -> None:
    done = shell(f"pdp8 panel {options}")
    assert (done.returncode, says in done.stderr) == (2, True)
