"""What a terminal shows of the panel, as text: a picture that can be compared line by line."""

from collections.abc import Awaitable, Callable
from pathlib import Path

import pytest
from textual.pilot import Pilot

from pdp8.console.app import Room
from pdp8.console.opening import opening
from pdp8.lessons.drill import Coach, find
from tests.conftest import awaited

PICTURES = Path(__file__).parent / "pictures"


def scene(
    size: tuple[int, int] = (100, 30),
    program: str | None = None,
    reader: str | None = None,
    drill: str = "",
    left_alone: float | None = None,
    memory: int = 0o10000,
) -> Callable[[Callable[[Room, Pilot[None]], Awaitable[None]]], Callable[[], None]]:
    """Make a test of a scene in a room whose terminal has `size` columns and lines, its clock still."""

    def made(act: Callable[[Room, Pilot[None]], Awaitable[None]]) -> Callable[[], None]:
        async def perform() -> None:
            session, programs = opening(program, reader, clock=lambda: 0.0, memory=memory)
            tapes = ("bin.rim", programs[1].words), ("eia.bin", programs[2].words)
            coach = Coach(find(drill, tapes), session.machine, left_alone) if drill else None
            room = Room(session, programs, ticking=False, coach=coach)
            async with room.run_test(size=size) as pilot:
                await pilot.pause()
                await act(room, pilot)

        def test() -> None:
            awaited(perform())

        return test

    return made


def shown(room: Room) -> str:
    """Return what the terminal shows, without colours."""
    lines = room.screen._compositor.render_strips()
    return "\n".join(line.text.rstrip() for line in lines) + "\n"


def assert_shows(room: Room, name: str) -> None:
    """Compare what is shown with the picture of that name; the first line that differs is shown."""
    ours = shown(room)
    path = PICTURES / f"{name}.txt"
    if not path.exists():
        path.write_text(ours)
        pytest.fail(f"there was no picture {path}: look at the one that was drawn")
    for number, (line, expected) in enumerate(
        zip(ours.splitlines(), path.read_text().splitlines(), strict=True), 1
    ):
        assert line == expected, f"{name}, line {number} of the screen"
