"""The Teletype at a terminal, on a line, and from slow pipes: what each special key sends, frame by frame."""

import os
import pty
import re
import select
import signal
import subprocess
import sys
import termios
import time
import tty
from pathlib import Path

import pytest

from tests import commands
from tests.commands import Terminal
from tests.conftest import Shell, assert_same_tape
from tests.pdp8.cli.test_run import LINE

KEEP = """*200
	KCC
L,	KSF
	JMP .-1
	KRB
	DCA I 10
	JMP L
*10
	277
$
"""
"""Each frame that comes goes into core, from 300 on."""


def test_the_time_limit_of_a_program_that_waits_for_a_key(tmp_path: Path) -> None:
    (tmp_path / "keep.pal").write_text(KEEP)
    terminal = Terminal("pdp8", "run", tmp_path / "keep.pal", "--keyboard", "--max-time", "1.01")
    seen = terminal.until(b"1971")
    assert b"when --max-time was over" in seen
    assert terminal.ended() == 1


class Other:
    """The other end of a line."""

    def __init__(self) -> None:
        self.end, self.line = pty.openpty()
        tty.setraw(self.line)
        self.name = os.ttyname(self.line)

    def read(self, count: int, seconds: float = 20) -> bytes:
        frames = b""
        give_up = time.monotonic() + seconds
        while len(frames) < count and time.monotonic() < give_up:
            if select.select([self.end], [], [], 0.1)[0]:
                frames += os.read(self.end, 100)
        return frames


def test_a_line_without_its_other_end_is_named_once() -> None:
    other = Other()
    before = termios.tcgetattr(other.line)
    run = commands.start("pdp8", "run", "echo.pal", "--tty", other.name)
    assert commands.eventually(lambda: termios.tcgetattr(other.line)[:6] != before[:6])
    os.close(other.line)
    os.close(other.end)
    time.sleep(0.5)
    run.send_signal(signal.SIGINT)
    said = run.communicate(timeout=20)[1]
    assert said.count(b"nobody is at the other end; the machine goes on, Ctrl-C stops it") == 1
    assert re.search(rb"interrupted at .* [0-9]\.. s in 1971", said), "the machine lost its pace"


def test_the_teletype_is_a_line() -> None:
    """echo.pal prints what comes over the line, seven or eight bits as they are, at ten frames a second."""
    other = Other()
    before = termios.tcgetattr(other.line)
    run = commands.start("pdp8", "run", "echo.pal", "--tty", other.name)
    assert commands.eventually(lambda: termios.tcgetattr(other.line)[:6] != before[:6])
    time.sleep(0.2)
    began = time.monotonic()
    os.write(other.end, b"\xd0\xc1\xcc\x01\xc1\xd0")
    assert other.read(6) == b"\xd0\xc1\xcc\x01\xc1\xd0"
    assert time.monotonic() - began > 0.5
    run.send_signal(signal.SIGINT)
    said = run.communicate(timeout=20)[1]
    assert b"interrupted at" in said
    assert run.returncode == 130
    assert termios.tcgetattr(other.line)[:4] == before[:4]


def test_a_pipe_that_stays_open_is_read_as_it_comes(tmp_path: Path) -> None:
    run = commands.start("pdp8", "run", "eia.pal", stdin=subprocess.PIPE)
    assert run.stdin
    assert run.stdout
    os.write(run.stdin.fileno(), LINE[:6])
    first = os.read(run.stdout.fileno(), 100)
    assert first
    time.sleep(0.5)
    os.write(run.stdin.fileno(), LINE[6:])
    rest, said = run.communicate(timeout=20)
    assert_same_tape(first + rest, whole(tmp_path))
    assert b"21 frames read, 21 frames punched; 2.1 s in 1971" in said
    assert run.returncode == 0


def whole(folder: Path) -> bytes:
    """Return what eia.pal makes of LINE from a file."""
    (folder / "line.asc").write_bytes(LINE)
    return commands.run("pdp8", "run", "eia.pal", "--reader", folder / "line.asc").stdout


def test_a_program_that_reads_no_tape_does_not_wait_for_an_open_pipe() -> None:
    with commands.start("pdp8", "run", "hello.pal", stdin=subprocess.PIPE) as run:
        assert run.stdin
        os.write(run.stdin.fileno(), b"\x81\x82")
        assert run.stdout
        assert b"\xc8" in run.stdout.read()
        assert run.wait(timeout=20) == 0


def test_a_named_pipe_and_ctrl_c_while_it_is_silent(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "pipe")
    run = commands.start("pdp8", "run", "eia.pal", "--reader", tmp_path / "pipe")
    with open(tmp_path / "pipe", "wb", buffering=0) as pipe:
        pipe.write(LINE[:9])
        assert run.stdout
        seen = b""
        while len(seen) < 5:
            seen += os.read(run.stdout.fileno(), 100)
        run.send_signal(signal.SIGINT)
        said = run.communicate(timeout=20)[1]
    assert run.returncode == 130
    assert b"9 frames read" in said


def test_several_tapes_one_after_another(shell: Shell, tmp_path: Path) -> None:
    (tmp_path / "a.asc").write_bytes(LINE[:11])
    (tmp_path / "b.asc").write_bytes(LINE[11:])
    done = shell("pdp8 run eia.pal --reader a.asc --reader b.asc")
    assert_same_tape(done.stdout, whole(tmp_path))
    assert b"b.asc goes into the reader after 11 frames" in done.stderr
    assert b"21 frames read, 21 frames punched" in done.stderr


def test_switches_and_start_beside_a_restored_state(shell: Shell, tmp_path: Path) -> None:
    (tmp_path / "halt.pal").write_text("*200\n\tHLT\n\tLAS\n\tTLS\n\tTSF\n\tJMP .-1\n\tHLT\n*300\n\tHLT\n$\n")
    assert shell("pdp8 run halt.pal --save s </dev/null >/dev/null").returncode == 0
    assert shell("pdp8 run --restore s --sr 0301").stdout == b"\xc1"
    assert b"HLT at 0300" in shell("pdp8 run --restore s --start 300").stderr
    done = shell("pdp8 run --restore s --fast-reader halt.pal --sr 0301")
    assert b"no frames read, no frames punched at high speed" in done.stderr


@pytest.mark.parametrize("given", ["< b.asc", "< <(cat b.asc)"])
def test_a_restored_machine_keeps_its_tape_and_names_an_input_that_it_does_not_read(
    shell: Shell, tmp_path: Path, given: str
) -> None:
    (tmp_path / "a.asc").write_bytes(LINE[:11])
    (tmp_path / "b.asc").write_bytes(LINE[11:])
    assert shell("pdp8 run eia.pal --reader a.asc --max-time 0.5 --save s > first").returncode == 1
    unread = b"standard input was not read: a restored machine goes on with the tape in its reader"
    done = shell(f"pdp8 run --restore s {given} > rest")
    assert unread in done.stderr
    assert done.returncode == 0
    assert unread not in shell("pdp8 run --restore s < /dev/null > rest").stderr
    done = shell(f"pdp8 run --restore s --reader a.asc --reader - {given}")
    assert unread not in done.stderr


def test_a_long_silence_says_once_where_the_run_is(tmp_path: Path) -> None:
    """A third of a second is long here."""
    script = "from pdp8 import cli; from pdp8.cli import pacing; pacing._SILENT = 0.3; cli.main()"
    (tmp_path / "loop.pal").write_text("*200\n\tISZ 10\n\tJMP .-1\n\tISZ 11\n\tJMP 200\n\tJMP 200\n$\n")
    line = f'{sys.executable} -c "{script}" run loop.pal < /dev/null > /dev/null'
    terminal = Terminal("bash", "-c", line, folder=tmp_path)
    seen = terminal.until(b"--max-time")
    assert b"of machine time, and nothing is read or punched; Ctrl-C ends the run" in seen
    terminal.type(b"\x03")
    assert terminal.ended() == 130
