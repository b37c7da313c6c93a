"""Sessions at the prompt, each a line `* command` and what it answers; and scripts that fail."""

import shutil
from pathlib import Path

import pytest

from tests.conftest import Shell

FOLDER = Path(__file__).parent


@pytest.mark.parametrize("session", sorted(FOLDER.glob("*.txt")), ids=lambda path: path.stem)
def test_a_session_and_its_answers(session: Path, shell: Shell, tmp_path: Path) -> None:
    shutil.copy(FOLDER / "dialogue.pal", tmp_path)
    for name in ("line.asc", "a line.asc"):
        (tmp_path / name).write_bytes(bytes(0o200 | code for code in b" 19\r\n"))
    lines = session.read_text().split("\n")
    script = [line.removeprefix("* ") for line in lines if line.startswith("* ")]
    (tmp_path / "script").write_text("\n".join(script))
    ran = shell("pdp8 monitor script --echo")
    assert ran.stdout.decode().split("\n") == lines
    assert (ran.stderr, ran.returncode) == (b"", 0)


@pytest.mark.parametrize(
    ("line", "message"),
    [
        ('expect "READY" 5', "'READY' was not printed: idle; the page shows 'PROCEED.'"),
        ("expect BEL 5", "BEL was not printed: idle; the page shows 'PROCEED.'"),
        ("assert pc 0", "PC is 02"),
        ("assert 200 1", "200 is 7300, not 0001"),
        ('until "04" 2 times 5', "'04' was printed no times of 2: idle; the page shows ''"),
    ],
)
def test_what_fails_ends_a_script_with_status_1(
    line: str, message: str, shell: Shell, tmp_path: Path
) -> None:
    shutil.copy(FOLDER / "dialogue.pal", tmp_path)
    (tmp_path / "script").write_text(f"load dialogue.pal\ngo 200 1\n{line}\npage\n")
    done = shell("pdp8 monitor script")
    assert done.returncode == 1
    assert done.stderr.decode().startswith(f"pdp8 monitor: script, line 3: {message}")
