"""What `pdp8 run` does beside the main job: booting, tracing, saving, the PC8/L, the live Teletype."""

import re
import signal
import time
from pathlib import Path

import pytest

from tapes import eia
from tests import commands
from tests.commands import Terminal
from tests.conftest import Shell, assert_same_tape

LINE = bytes(0o200 | code for code in b"  76 2250 4133  185\r\n")
WHOLE = b"\0" + eia.encode("  76 2250 4133  185\n".replace(" ", "0"))
"""What eia.pal makes of it."""


@pytest.fixture(autouse=True)
def line(tmp_path: Path) -> None:
    (tmp_path / "line.asc").write_bytes(LINE)


def test_the_pc8_reads_and_punches_files(shell: Shell, tmp_path: Path) -> None:
    source = "*200\n\tRFC\n\tRSF\n\tJMP .-1\n\tRRB RFC\n\tPLS\n\tPSF\n\tJMP .-1\n\tPLS\n\tPSF\n\tJMP .-1\n"
    source += "\tCLA\n\tJMP 201\n$\n"
    (tmp_path / "copy.pal").write_text(source)
    (tmp_path / "in.tape").write_bytes(bytes(range(100)))
    ran = shell("pdp8 run copy.pal --fast-reader in.tape --fast-punch out.tape --punch /dev/null </dev/null")
    twice = bytes(frame // 2 for frame in range(200))
    assert_same_tape((tmp_path / "out.tape").read_bytes(), twice)
    assert b"100 frames read, 200 frames punched at high speed; 4.0 s in 1971" in ran.stderr
    assert ran.returncode == 0


def test_the_live_teletype_and_the_way_to_the_monitor_and_back() -> None:
    terminal = Terminal("pdp8", "run", "echo.pal", "--keyboard")
    terminal.until(b"Ctrl-]")
    terminal.type(b"pal iii")
    terminal.until(b"PAL III")
    assert not terminal.restored()
    terminal.type(b"\x1d")
    terminal.until(b"stop key;")
    terminal.type(b"examine COUNT\r")
    terminal.until(b"COUNT")
    terminal.type(b"cont\r")
    time.sleep(1)
    terminal.type(b"more")
    terminal.until(b"MORE")
    terminal.type(b"\x05")
    terminal.until(b"stop key;")
    terminal.type(b"quit\r")
    assert terminal.ended() == 0


@pytest.mark.parametrize("number", [signal.SIGTERM, signal.SIGHUP])
def test_the_terminal_is_restored_whatever_ends_the_run(number: int) -> None:
    terminal = Terminal("pdp8", "run", "echo.pal", "--keyboard", "--realtime")
    terminal.until(b"Ctrl-]")
    terminal.type(b"x")
    terminal.until(b"X")
    terminal.process.send_signal(number)
    assert (terminal.ended(), terminal.restored()) == (128 + number, True)


def test_ctrl_c_keeps_what_was_punched_and_says_where(tmp_path: Path) -> None:
    (tmp_path / "line.asc").write_bytes(LINE * 10)
    with open(tmp_path / "line.eia", "wb") as tape:
        run = commands.start(
            "pdp8", "run", "eia.pal", "--realtime", "--reader", "line.asc", folder=tmp_path, stdout=tape
        )
        assert commands.eventually(lambda: (tmp_path / "line.eia").stat().st_size > 3)
        status, said = commands.signalled(run, signal.SIGINT)
    assert status == 130
    assert re.fullmatch(rb"pdp8 run: interrupted at 02.*\n", said)
    assert (tmp_path / "line.eia").read_bytes()[:4] == bytes([0, 0o040, 0o040, 0o007])
