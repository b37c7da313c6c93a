"""What is refused at the panel leaves machine, tapes and files as they were: every question, in every way."""

from contextlib import chdir
from pathlib import Path
from tempfile import TemporaryDirectory

import pytest

pytest.importorskip("textual", reason="Textual, the extra `panel`, is not installed")

from textual.pilot import Pilot
from textual.widgets import Input

from pdp8.computer.past import state
from pdp8.console.app import Room
from tests.conftest import case
from tests.pdp8.console.pictures import scene
from tests.pdp8.console.test_room import press

REFUSED = {
    "o": ("nowhere.asc", ".", "-", "no/in", "", "\u00e9", "x" * 300),
    "w": ("", ".", "no/out", "kept", "own.pal", "soft", "/dev/full", "-", "x" * 300),
}
"""What each question of the panel refuses: the tape for the reader, the name of the tape that is torn off."""


@pytest.mark.slow("each name is typed into the panel, 10 s")
@scene(program="eia.pal", reader="circle.asc")
async def test_a_name_that_is_refused_changes_nothing(room: Room, pilot: Pilot[None]) -> None:
    session = room.session
    session.machine.teletype.punch.frames += b"abc"
    with TemporaryDirectory() as folder, chdir(folder):
        Path("kept").write_bytes(b"kept")
        Path("kept").chmod(0o444)
        Path("own.pal").write_text("*200\n")
        Path("soft").symlink_to("own.pal")
        before = kept(room)
        for question, names in REFUSED.items():
            for name in names:
                with case(f"{question} {name}"):
                    await press(pilot, question)
                    await answer(room, pilot, name)
                    while len(room.screen_stack) > 1:
                        await press(pilot, "escape")
                    assert kept(room) == before
        await press(pilot, "w")
        await answer(room, pilot, "out")
        assert Path("out").read_bytes() == b"abc", "what was refused can still be torn off"


async def answer(room: Room, pilot: Pilot[None], name: str) -> None:
    """Write a name on the line of a question, and press ENTER."""
    room.screen.query_one("Input", Input).value = name
    await press(pilot, "enter")


def kept(room: Room) -> object:
    """Return what a refusal must not change: the machine, the tapes at hand, every file."""
    session = room.session
    files = {path.name: path.read_bytes() for path in Path().iterdir()}
    return state.save(session.machine), session.reader_tape, list(session.tapes), files
