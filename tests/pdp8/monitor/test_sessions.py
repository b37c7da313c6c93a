"""Sessions at the prompt: `* command` and what it answers, `? ` what is wrong; a script that fails."""

import shutil
from pathlib import Path

import pytest

from pdp8.monitor.commands import COMMANDS
from pdp8.monitor.prompt import Monitor
from tapes.errors import WorkError
from tests.conftest import Call
from tests.pdp8.monitor import do

FOLDER = Path(__file__).parent


@pytest.fixture(autouse=True)
def files(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    shutil.copy(FOLDER / "dialogue.pal", tmp_path)
    for name in ("line.asc", "a line.asc"):
        (tmp_path / name).write_bytes(bytes(0o200 | code for code in b" 19\r\n"))
    (tmp_path / "text").write_bytes(b"12\n34\n")
    (tmp_path / "bin").write_bytes(bytes([*[0o200] * 16, 0o102, 0, 0o074, 0o002, 0, 1, *[0o200] * 16]))
    (tmp_path / "bin.pal").write_text("HLT\n$\n")


@pytest.mark.parametrize("session", sorted(FOLDER.glob("*.txt")), ids=lambda path: path.stem)
def test_a_session_and_its_answers(session: Path, monitor: Monitor, said: list[str]) -> None:
    lines = session.read_text("utf-8").splitlines()
    for line in lines:
        if line.startswith("* "):
            said.append(line)
            try:
                do(monitor, line.removeprefix("* "))
            except WorkError as error:
                said.append(f"? {error}")
    assert "\n".join(said).split("\n") == lines
    assert monitor.finished == (lines[-1] in ("* exit", "* quit"))


def test_help_has_each_command_beside_its_words(monitor: Monitor, said: list[str]) -> None:
    do(monitor, "help")
    *lines, _ = said
    assert [line.partition(" ")[0] for line in lines if line[0] != " "] == list(COMMANDS)
    assert all(line[:28].isspace() and line[28] != " " for line in lines if line[0] == " ")
    assert max(map(len, lines)) <= 79


def test_what_fails_ends_a_script_with_status_1(call: Call, tmp_path: Path) -> None:
    (tmp_path / "script").write_text("load dialogue.pal\ngo 200 1\nassert pc 0\npage\n")
    status, out, said = call("pdp8 monitor script --echo")
    assert (status, out.splitlines()[-1]) == (1, "* assert pc 0")
    assert said.startswith("pdp8 monitor: script, line 3: PC is 02")
