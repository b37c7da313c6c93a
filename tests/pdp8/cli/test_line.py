"""The Teletype at a terminal, on a line, and from slow pipes: what each special key sends, frame by frame."""

import os
import pty
import re
import select
import shlex
import signal
import socket
import struct
import subprocess
import sys
import termios
import time
import tty
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from contextlib import closing
from functools import partial
from pathlib import Path
from typing import Any

import click
import pytest

from pdp8.cli.running import pacing
from pdp8.cli.running.line import Line, Tcp, opened
from pdp8.computer.machine import Machine
from pdp8.computer.stop import Reason
from pdp8.shelf import ShelfError
from tests import commands
from tests.commands import Terminal
from tests.conftest import Call, Shell, assert_same_tape
from tests.pdp8.cli.test_run import LINE, WHOLE
from tests.pdp8.computer.dectape import reel


@pytest.mark.parametrize("at", ["--keyboard", "--line=/dev/stdin"])
def test_the_time_limit_of_a_program_that_waits_for_a_key(at: str) -> None:
    terminal = Terminal("pdp8", "run", "echo.pal", at, "--max-time", "1.01")
    assert b"when --max-time was over" in terminal.until(b"1971")
    assert terminal.ended() == 1


def on_line(*options: str) -> tuple["subprocess.Popen[bytes]", int, int, list[Any]]:
    """Run echo.pal with its Teletype on a line; return the run, both ends of the line, its modes before."""
    end, line = pty.openpty()
    tty.setraw(line)
    before = termios.tcgetattr(line)
    run = commands.start("pdp8", "run", "echo.pal", "--line", os.ttyname(line), *options)
    assert commands.eventually(lambda: termios.tcgetattr(line)[:6] != before[:6])
    return run, end, line, before


def read(end: int, count: int) -> bytes:
    frames = b""
    while len(frames) < count and select.select([end], [], [], 20)[0]:
        frames += os.read(end, 100)
    return frames


def test_a_line_without_its_other_end_is_named_once() -> None:
    run, end, line, _ = on_line()
    os.close(line)
    os.close(end)
    assert run.stderr is not None
    named = b"nobody is at the other end; the machine goes on, Ctrl-C stops it"
    assert any(named in said for said in run.stderr)
    time.sleep(0.5)
    _, said = commands.signalled(run, signal.SIGINT)
    assert named not in said
    assert re.search(rb"interrupted at .* [0-9]\.. s in 1971", said), "the machine lost its pace"


def test_the_teletype_is_a_line() -> None:
    """echo.pal prints what comes over the line, seven or eight bits as they are, at ten frames a second."""
    run, end, line, before = on_line()
    os.write(end, b"\xd0")
    assert read(end, 1) == b"\xd0"
    began = time.monotonic()
    os.write(end, b"\xc1\xcc\x01\xc1\xd0")
    assert read(end, 5) == b"\xc1\xcc\x01\xc1\xd0"
    assert time.monotonic() - began > 0.25, (
        "half of their time: what a busy host delays, the machine catches up"
    )
    status, said = commands.signalled(run, signal.SIGINT)
    assert (status, b"interrupted at" in said) == (130, True)
    assert termios.tcgetattr(line)[:4] == before[:4]


PARITY: dict[str, Callable[[int], int]] = {"mark": lambda code: 1, "even": lambda code: code.bit_count() & 1}


@pytest.mark.parametrize("parity", PARITY)
def test_a_terminal_that_sends_parity(parity: str) -> None:
    """To 7 bits its eighth is nothing; echo.pal has the same frames whatever it is."""
    run, end, _, _ = on_line("--line-bits", "7", "--line-speed", "full")
    typed = b"ACES 1971"
    os.write(end, bytes(code | PARITY[parity](code) << 7 for code in typed))
    assert read(end, len(typed)) == typed
    assert commands.signalled(run, signal.SIGINT)[0] == 130


@pytest.mark.parametrize("trap", ["", "trap '' INT; "])
def test_a_pipe_that_stays_open_is_read_as_it_comes(trap: str) -> None:
    """Ctrl-C is not for what runs in a script's background, where SIGINT is ignored."""
    run = commands.start("bash", "-c", f"{trap}exec pdp8 run eia.pal", stdin=subprocess.PIPE)
    assert run.stdin
    assert run.stdout
    os.write(run.stdin.fileno(), LINE[:6])
    first = os.read(run.stdout.fileno(), 100)
    assert first
    time.sleep(0.5)
    if trap:
        run.send_signal(signal.SIGINT)
    os.write(run.stdin.fileno(), LINE[6:])
    rest, said = run.communicate(timeout=20)
    assert_same_tape(first + rest, WHOLE)
    assert b"21 frames read, 21 frames punched; 2.1 s in 1971" in said
    assert run.returncode == 0


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
        assert len(run.stdout.read(5)) == 5
        status, said = commands.signalled(run, signal.SIGINT)
    assert (status, b"9 frames read" in said) == (130, True)


@pytest.fixture
def halves(tmp_path: Path) -> None:
    """LINE on two tapes."""
    (tmp_path / "a.asc").write_bytes(LINE[:11])
    (tmp_path / "b.asc").write_bytes(LINE[11:])


def test_channel_8_is_explained_where_frames_go_down_a_pipe(shell: Shell, tmp_path: Path) -> None:
    (tmp_path / "plain.pal").write_text("*200\n\tLAS\n\tTLS\n\tTSF\n\tJMP .-1\n\tHLT\n$\n")
    done = shell(
        "pdp8 run hello.pal --save s; pdp8 run hello.pal --punch x; pdp8 run plain.pal --sr 101; "
        "pdp8 run --restore s --start 205"
    )
    assert done.stderr.count(b"the frames have channel 8") == 1


WRITES = "*20\n\t240\n*200\n\tCLA\n\tTAD 20\n\t6766\n\t6771\n\tJMP .-1\n\tHLT\n*7754\n\t7777\n\t0777\n$\n"
"""Writes a word into block 0 of the reel on drive 0."""


def test_a_reel_that_was_written_is_left_beside_its_file_or_in_the_state(
    call: Call, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Also after a second Ctrl-C, which ends the process."""
    (tmp_path / "writes.pal").write_text(WRITES)
    reel.file(tmp_path / "a.tu56")
    for options, left in (("--save s", []), ("--save-dectape 0=b.tu56", []), ("", ["a-changed.tu56"])):
        status, _, said = call(f"pdp8 run writes.pal --dectape 0=a.tu56 {options}")
        assert (status, [path.name for path in tmp_path.glob("*-changed*")]) == (0, left), said

    def interrupted(machine: Machine, *more: object) -> None:
        machine.run()
        raise KeyboardInterrupt

    monkeypatch.setattr(pacing, "run", interrupted)
    assert call("pdp8 run writes.pal --dectape 0=a.tu56")[0] == 130
    assert (tmp_path / "a-changed-2.tu56").exists()


def test_switches_and_start_beside_a_restored_state(call: Call, tmp_path: Path) -> None:
    (tmp_path / "halt.pal").write_text("*200\n\tHLT\n\tLAS\n\tTLS\n\tTSF\n\tJMP .-1\n\tHLT\n*300\n\tHLT\n$\n")
    assert call("pdp8 run halt.pal --save s")[0] == 0
    assert call("pdp8 run --restore s --sr 0301")[1].encode(errors="surrogateescape") == b"\xc1"
    assert "HLT at 0300" in call("pdp8 run --restore s --start 300")[2]
    said = call("pdp8 run --restore s --fast-reader halt.pal --sr 0301")[2]
    assert "no frames read, no frames punched at high speed" in said


@pytest.mark.usefixtures("halves")
@pytest.mark.parametrize("given", ["< b.asc", "< <(cat b.asc)"])
def test_a_restored_machine_keeps_its_tape_and_names_an_input_that_it_does_not_read(
    shell: Shell, given: str
) -> None:
    first = shell("pdp8 run eia.pal --reader a.asc --max-time 0.5 --save s")
    assert first.returncode == 1
    unread = b"standard input was not read: a restored machine goes on with the tape in its reader"
    done = shell(f"pdp8 run --restore s {given}")
    assert (done.returncode, unread in done.stderr) == (0, True)
    assert_same_tape(first.stdout + done.stdout, WHOLE[:12])
    others = f"--reader a.asc --reader - {given}", f"--reader a.asc {given}", f"--quiet {given}"
    for line in ("< /dev/null", "< <(:)", *others):
        assert unread not in shell(f"pdp8 run --restore s {line} > rest").stderr


def test_a_long_silence_says_once_where_the_run_is(tmp_path: Path) -> None:
    """A third of a second is long here."""
    script = "from pdp8 import cli; from pdp8.cli.running import pacing; pacing._SILENT = 0.3; cli.main()"
    (tmp_path / "loop.pal").write_text("*200\n\tISZ 10\n\tJMP .-1\n\tISZ 11\n\tJMP 200\n\tJMP 200\n$\n")
    line = f'{shlex.quote(sys.executable)} -c "{script}" run loop.pal < /dev/null > /dev/null'
    terminal = Terminal("bash", "-c", line, folder=tmp_path)
    seen = terminal.until(b"--max-time")
    assert b"of machine time, and nothing is read or punched; Ctrl-C ends the run" in seen
    terminal.type(b"\x03")
    assert terminal.ended() == 130


def test_a_tcp_port_is_a_line_and_who_comes_back_loses_nothing() -> None:
    """Options of telnet are no characters; what is printed while nobody is there is kept."""
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        port = free.getsockname()[1]
    run = commands.start("pdp8", "run", "echo.pal", "--line", f"tcp:{port}", "--line-speed", "full")
    assert run.stderr is not None
    assert f"listens on 127.0.0.1:{port}, 7 bits".encode() in run.stderr.readline()
    with socket.create_connection(("127.0.0.1", port)) as client:
        client.settimeout(20)
        assert client.recv(6) == b"\xff\xfb\x01\xff\xfb\x03"
        client.sendall(b"\xff\xfd\x01\xff\xfa\x18\x00vt100\xff\xf0ab")
        assert b"".join(client.recv(1) for _ in range(2)) == b"AB"
    time.sleep(0.5)
    with socket.create_connection(("127.0.0.1", port)) as client:
        client.settimeout(20)
        client.recv(6)
        client.sendall(b"e")
        assert client.recv(1) == b"E"
    commands.signalled(run, signal.SIGINT)


@pytest.mark.parametrize("port", ["0", "65536", "-1", "x", "", "1.5", "1", "65535"])
def test_a_port_is_from_1_to_65535(port: str) -> None:
    with pytest.raises(ShelfError) as refused:  # nobody here has this address
        opened(f"tcp:192.0.2.1:{port}")
    assert ("a port from 1 to 65535" in str(refused.value)) == (port not in ("1", "65535"))


def test_a_line_has_what_is_printed_until_the_program_halts() -> None:
    class Kept(Line):
        def __init__(self, bits: int) -> None:
            super().__init__(bits, full_speed=True)
            self.sent = bytearray()

        def received(self, seconds: float) -> bytes:
            return b""

        def send(self, frame: int) -> None:
            self.sent.append(frame)

    for bits in (7, 8):
        machine, line = Machine(), Kept(bits)
        machine.load({0o200: 0o7604, 0o201: 0o6046, 0o202: 0o6041, 0o203: 0o5202, 0o204: 0o7402})
        machine.sr = 0o301
        machine.start(0o200)
        stop = line.run(machine, 1.0, lambda: None)
        assert stop is not None
        assert (stop.reason, bytes(line.sent)) == (Reason.HALT, b"A" if bits == 7 else b"\xc1")


@pytest.mark.parametrize(("host", "bare"), [("localhost", "localhost"), ("[::1]", "::1")])
def test_a_tcp_port_of_8_bits_has_an_address_and_doubles_what_is_telnets(
    host: str, bare: str, capsys: pytest.CaptureFixture[str]
) -> None:
    with socket.socket(socket.AF_INET6 if ":" in bare else socket.AF_INET) as free:
        try:
            free.bind((bare, 0))
        except OSError:
            pytest.skip("no IPv6 here")
        port = free.getsockname()[1]
    with click.Context(click.Command("run")):
        line = opened(f"tcp:{host}:{port}", 8)
    assert capsys.readouterr().err == f": listens on {host}:{port}, 8 bits; Ctrl-C stops\n"
    with socket.create_connection((bare, port)) as rude:  # it leaves before it is looked at
        rude.setsockopt(socket.SOL_SOCKET, socket.SO_LINGER, struct.pack("ii", 1, 0))
    with closing(line), socket.create_connection((bare, port)) as client:
        client.settimeout(20)
        assert [line.received(20) for _ in range(3)] == [b""] * 3
        line.send(0o377)
        line.send(0o301)
        assert b"".join(client.recv(1) for _ in range(9)) == b"\xff\xfb\x01\xff\xfb\x03\xff\xff\xc1"


def test_telnets_options_are_taken_out_wherever_a_packet_ends() -> None:
    line = Tcp.__new__(Tcp)
    line._waiting = bytearray()
    line._client, there = socket.socketpair()
    line._telnet, line._returned = b"\xff", True
    there.close()
    assert (line.received(5), line._telnet, line._returned) == (b"", b"", False), "it left within an option"
    for packets, frames in (
        ((b"A\r\0B\0",), b"A\rB\0"),
        ((b"\r", b"\0B\r"), b"\rB\r"),
        ((b"\xff\xffA",), b"\xffA"),
        ((b"\xff\xfd\x03A",), b"A"),
        ((b"\xff", b"\xfd", b"\x03A"), b"A"),
        ((b"\xff\xfa\x18\x00\xff\xff\xff\xf0A",), b"A"),
        ((b"\xff\xf1A\r\n",), b"A\r\n"),
    ):
        assert b"".join(map(line._without_options, packets)) == frames


def test_a_client_has_the_last_frames_though_it_takes_them_slowly() -> None:
    line, last = Tcp.__new__(Tcp), bytes(range(255)) * 40_000
    line._client, there = socket.socketpair()
    line._server, line._waiting = socket.socket(), bytearray(last)
    line._client.setblocking(False)
    line._pass_on()
    with there, ThreadPoolExecutor(1) as thread:
        taken = thread.submit(lambda: b"".join(iter(partial(there.recv, 1 << 16), b"")))
        line.close()
        assert taken.result(20) == last


def test_what_is_no_line_is_closed_again() -> None:
    before = len(os.listdir("/dev/fd"))
    for _ in range(3):
        with pytest.raises(ShelfError, match="not a line"):
            opened("/dev/null")
    assert len(os.listdir("/dev/fd")) == before


def test_rts_is_reader_run_until_the_line_says_that_it_has_none(monkeypatch: pytest.MonkeyPatch) -> None:
    asked: list[tuple[int, bytes]] = []
    end, other = pty.openpty()
    before = termios.tcgetattr(other)
    line = opened(os.ttyname(other))
    now = termios.tcgetattr(other)
    assert (now[2] & termios.CSTOPB, now[4:6]) == (termios.CSTOPB, [termios.B110] * 2)
    monkeypatch.setattr("fcntl.ioctl", lambda file, request, bits: asked.append((request, bits)))
    line.reader_run(True)
    line.reader_run(False)
    rts = termios.TIOCM_RTS.to_bytes(4, sys.byteorder)
    assert asked == [(termios.TIOCMBIS, rts), (termios.TIOCMBIC, rts)]

    def refused(*_: object) -> None:
        asked.append((0, b""))
        raise OSError

    monkeypatch.setattr("fcntl.ioctl", refused)
    line.reader_run(True)
    line.reader_run(True)
    assert asked[2:] == [(0, b"")]
    line.close()
    assert termios.tcgetattr(other)[:6] == before[:6]
    for file in (end, other):
        os.close(file)


def test_in_real_time_it_waits_as_long_as_the_machine_takes(
    call: Call, monkeypatch: pytest.MonkeyPatch
) -> None:
    clock = [100.0]
    monkeypatch.setattr("pdp8.cli.running.pacing.time.monotonic", lambda: clock[0])
    monkeypatch.setattr(
        "pdp8.cli.running.pacing.time.sleep", lambda seconds: clock.append(clock.pop() + seconds)
    )
    status, _, said = call("pdp8 run hello.pal --realtime --max-time 1")
    assert (status, "still running" in said) == (1, True)
    assert 0.9 < clock[0] - 100 < 1.1
