"""A drill at the panel in a terminal: the card, what the coach says, and the kiosk that clears the room."""

from collections.abc import Awaitable, Callable
from functools import partial

import pytest

pytest.importorskip("textual", reason="Textual, the extra `panel`, is not installed")

from textual.binding import Binding
from textual.pilot import Pilot

from pdp8.console.app import PanelFace, Room
from pdp8.console.pages import DrillCard, Paper
from tests.conftest import case
from tests.pdp8.console.pictures import scene, shown

SIZE = (160, 45)
PASSED_OVER = {"app.again", "app.hand(-1)", "app.quit", "app.tape", "app.turn_round"}
"""What would undo the others, or hide them."""
UNSEEN = {"machine", "operator", "history", "_rest"}
"""What a session has that nobody sees, or that is compared otherwise."""


def card(room: Room) -> str:
    return room.screen_stack[0].query_one(DrillCard).render().plain


def stage(room: Room) -> int:
    """Return which step of the card comes next."""
    assert room.coach
    return room.coach.at


@scene(size=SIZE, drill="rim")
async def test_the_card_says_what_is_wrong_and_what_is_next(room: Room, pilot: Pilot[None]) -> None:
    await pilot.press(*"7757l")
    assert "switch 11 should be down: 7756, not 7757" in card(room)
    assert "▸ 7756  LOAD ADD" in card(room)
    await pilot.press(*"7756l", *"6032d")
    assert "✓ 6032  DEP       into 7756" in card(room)
    assert room.session.machine.core[0o7756] == 0o6032
    await pilot.press("r")
    assert not room.session.said.startswith("toggling")
    await pilot.press("n", "n", "b")
    assert (stage(room), room.session.machine.core[0o7756], room.coach and room.coach.wrong) == (2, 0o6032, 1)
    assert not room.session.said.startswith("back")
    await pilot.press("x")
    assert (stage(room), room.session.machine.core[0o7756]) == (0, 0)
    room.session.machine.teletype.punch.frames += b"1"
    await pilot.press("ctrl+q")
    await pilot.pause()
    assert len(room.screen_stack) == 2
    await pilot.press("y")
    assert room._exit


@scene(size=SIZE, drill="rim", left_alone=60)
async def test_a_kiosk_closes_what_a_visitor_left_open(room: Room, pilot: Pilot[None]) -> None:
    await pilot.press(*"7756l", "o")
    await pilot.pause()
    assert len(room.screen_stack) == 2
    room.turn(61)
    await pilot.pause()
    assert (len(room.screen_stack), stage(room)) == (1, 0)
    await pilot.press("q")
    assert room.is_running
    await pilot.press(*"7756l", *"6032d")
    assert stage(room) == 2
    room.session.machine.teletype.punch.frames += b"1"
    await pilot.press("ctrl+q")
    assert room._exit


@scene(drill="rim", left_alone=60)
async def test_who_does_anything_at_a_kiosk_is_there_and_leaves_it_as_new(
    room: Room, pilot: Pilot[None]
) -> None:
    """A key, the Teletype, the mouse, a question; and all that the panel's keys do, with a tape torn off."""
    session = room.session
    every = {key.action for key in PanelFace.BINDINGS if isinstance(key, Binding)} - PASSED_OVER

    async def all_keys() -> None:
        await pilot.press("7")
        session.tear_off("mine")
        room.query_one(Paper).take(0o301)
        for action in sorted(every):
            await room.run_action(action)

    def state() -> object:
        kept = {name: value for name, value in vars(session).items() if name not in UNSEEN}
        return kept, session.machine.values(), room.focused and room.focused.id, shown(room)

    fresh = state()
    steps: list[Callable[[], Awaitable[object]]] = [
        *(partial(pilot.press, keys) for keys in "7tgo"),
        partial(pilot.press, "tab", "h"),
        *(partial(pilot.click, place) for place in ("#sr3", "#stop")),
        all_keys,
    ]
    for do in steps:
        with case(do):
            room.turn(40)
            await do()
            room.turn(40)
            assert state() != fresh
            room.turn(20)
            await pilot.pause()
            room.turn(0)
            assert state() == fresh
