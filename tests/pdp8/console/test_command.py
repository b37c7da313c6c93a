"""`pdp8 panel` as it is typed: what it wants, and what it says where it cannot be."""

import sys
from pathlib import Path
from typing import Any

import pytest

from pdp8.lessons.drill import LEFT_ALONE
from tests.commands import BIN, Terminal
from tests.conftest import Call, Shell, assert_same_tape


@pytest.mark.parametrize(
    ("options", "status", "said"),
    [
        ("--kiosk", 2, "--kiosk means nothing without --drill"),
        ("eia.pal --drill rim", 2, "--drill is used with --kiosk only: leave out PROGRAM"),
        ("no.pal", 1, "pdp8 panel: no.pal: no such file"),
        ("eia.pal --reader no.asc", 1, "pdp8 panel: no.asc: no such file"),
        ("circle.eia", 1, "pdp8 panel: circle.eia: "),
        ("/", 1, "pdp8 panel: /: Is a directory"),
    ],
)
def test_options_go_together_and_what_cannot_be_loaded_is_named(
    options: str, status: int, said: str, call: Call
) -> None:
    done, out, error = call(f"pdp8 panel {options}", terminal=True)
    assert (done, out, said in error) == (status, "", True)


def test_it_wants_a_terminal_and_textual(call: Call, monkeypatch: pytest.MonkeyPatch) -> None:
    said = "pdp8 panel: the panel needs a terminal; `pdp8 run` works without one\n"
    assert call("pdp8 panel") == (1, "", said)
    monkeypatch.setitem(sys.modules, "textual", None)
    piped = Terminal("bash", "-c", "pdp8 panel | cat; pdp8 run echo.pal --keyboard | cat")
    assert b"the panel needs a terminal;" in piped.until(b"--keyboard needs a terminal")
    status, _, said = call("pdp8 panel", terminal=True)
    assert (status, said[:31]) == (1, "pdp8 panel: the panel needs Tex")
    assert said.endswith('[panel]"\n')


def test_it_opens_as_its_options_say(call: Call, monkeypatch: pytest.MonkeyPatch) -> None:
    app = pytest.importorskip("pdp8.console.app", reason="Textual, the extra `panel`, is not installed")
    rooms: list[Any] = []

    def run(room: object) -> None:
        rooms.append(room)

    monkeypatch.setattr(app.Room, "run", run)
    for options in ("--sr 1234", "", "--drill rim", "--drill rim --kiosk"):
        with pytest.raises(SystemExit):
            call(f"pdp8 panel {options}", terminal=True)
    assert [room.session.machine.sr for room in rooms[:2]] == [0o1234, 0]
    coaches = [room.coach and (room.coach.drill.name, room.coach.left_alone) for room in rooms]
    assert coaches == [None, None, ("rim", None), ("rim", LEFT_ALONE)]


def test_a_tape_is_translated_at_a_terminal(shell: Shell, tmp_path: Path) -> None:
    """The tape lies in the reader for a while before START; no frame of it is lost."""
    pytest.importorskip("textual", reason="Textual, the extra `panel`, is not installed")
    (tmp_path / "three.asc").write_bytes(b"\xb3\x8d\x8a")
    done = shell("pdp8 run eia.pal --reader three.asc --punch run.eia")
    assert done.returncode == 0, done.stderr
    panel = (BIN / "pdp8", "panel", "eia.pal", "--reader", "three.asc")
    terminal = Terminal(*panel, folder=tmp_path, TERM="xterm-256color", LINES="30")
    seen = b""
    for shown, keys in (
        (b"STOP \xc2\xb7 three.asc", b"ppp"),
        (b"1000", b"s"),
        (b"out of tape", b"w"),
        (b"punched.tape", b"panel.eia\r"),
        (b"frames", b"\x03"),
        (b"stopped before", b"q"),
    ):
        seen += terminal.until(shown)
        terminal.type(keys)
    assert terminal.ended() == 0, terminal.seen
    assert b"Traceback" not in seen + terminal.seen
    assert b"MEMORY ADDRESS" in seen
    assert_same_tape((tmp_path / "panel.eia").read_bytes(), (tmp_path / "run.eia").read_bytes())
