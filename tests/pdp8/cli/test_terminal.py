"""The terminal key by key: prompt_toolkit's raw mode on a pipe, and what differs on Windows."""

import os
import re
import signal
import sys
import time
from collections.abc import Iterator
from contextlib import nullcontext, suppress
from functools import partial
from pathlib import Path
from threading import Timer

import click
import pytest
from click.testing import CliRunner
from prompt_toolkit.application import create_app_session
from prompt_toolkit.input import PipeInput, create_pipe_input
from prompt_toolkit.key_binding import KeyPress
from prompt_toolkit.keys import Keys
from prompt_toolkit.output import DummyOutput

from pdp8 import leaving
from pdp8.cli import monitor
from pdp8.cli.run import run
from pdp8.cli.running import keyboard, pacing
from pdp8.cli.running.feed import Feed
from pdp8.cli.running.keyboard import Terminal, characters, typed
from pdp8.cli.running.outputs import Output
from pdp8.cli.shared import command
from pdp8.cli.shared.arguments import Target
from pdp8.computer.machine import Machine
from pdp8.computer.stop import Reason
from pdp8.computer.use.keys import sent
from pdp8.monitor.commands import do
from pdp8.monitor.prompt import Monitor
from tests.conftest import Call, case
from tests.options.trial import changed, existing, folder


@pytest.fixture
def keys() -> Iterator[PipeInput]:
    """What is typed comes from here."""
    with create_pipe_input() as pipe:
        yield pipe


@pytest.mark.parametrize(
    ("sequence", "frames"),
    [("a", "301"), ("\r", "215"), ("\x7f", "377"), ("\x1b", "375"), ("\x1b[A", ""), ("\x1bOP", "")],
)
def test_a_key_sends_what_the_table_says(keys: PipeInput, sequence: str, frames: str) -> None:
    keys.send_text(sequence)
    seen = typed(keys, 1 if frames else 0.05)
    assert " ".join(f"{frame:03o}" for frame in sent(seen)) == frames


def test_typing_waits_no_longer_than_it_may_and_not_for_a_closed_terminal(keys: PipeInput) -> None:
    for seconds in (0.05, 5.0):
        began = time.monotonic()
        assert typed(keys, seconds) == ""
        assert (seconds == 0.05) * seconds <= time.monotonic() - began < 5
        keys.close()


def test_an_escape_stops_and_what_is_typed_behind_it_is_for_the_monitor(
    keys: PipeInput, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(keyboard, "create_input", lambda: keys)
    terminal = Terminal()
    for text, before in (("AB\x1dC", "AB"), ("\x05A", ""), ("AB\x05\x1d", "AB"), ("AB\x1d\x05", "AB")):
        with case(text):
            machine = Machine()
            machine.load({0o200: 0o5200})
            machine.start(0o200)
            keys.send_text(text)
            stop, left = terminal.run(machine)
            assert (stop.reason, left, machine.panel.lamps.run) == (Reason.STOP_KEY, True, False)
            assert machine.teletype.keyboard.waiting == sent(before)


def test_a_terminal_that_is_closed_stops_the_program(
    keys: PipeInput, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(keyboard, "create_input", lambda: keys)
    machine = Machine()
    machine.load({0o200: 0o5200})
    machine.start(0o200)
    keys.close()
    assert Terminal().run(machine, 1.0)[1]


@pytest.mark.parametrize("tape", [False, True])
@pytest.mark.parametrize(("realtime", "seconds"), [(False, 0.23), (True, 1.18)])
def test_a_program_that_waits_for_a_key_has_it_when_it_comes(
    tape: bool, realtime: bool, seconds: float, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The third look takes a second of the clock: in real time the machine has waited as long."""
    machine, clock, looks = Machine(), [0.0], list[float]()
    machine.load({0o200: 0o6032, 0o201: 0o6031, 0o202: 0o5201, 0o203: 0o6034, 0o204: 0o7402})
    machine.start(0o200)
    if tape:
        machine.teletype.reader.load(b"")
    monkeypatch.setattr("pdp8.cli.running.pacing.time.monotonic", lambda: clock[0])

    def take(seconds: float) -> bytes:
        looks.append(seconds)
        clock[0] += 1.0 if len(looks) == 3 else 0.05
        return b"\x81" if len(looks) == 3 else b""

    stop = pacing.live(machine, None, lambda: None, take, realtime)
    assert stop is not None
    assert (stop.reason, machine.ac, looks[:3]) == (Reason.HALT, 0o201, [0.05] * 3)
    assert machine.elapsed == pytest.approx(seconds, abs=0.01)
    machine.start(0o200)
    limited = pacing.live(machine, machine.elapsed + 0.12, lambda: None, take, realtime)
    assert limited is not None
    assert limited.reason is Reason.LIMIT


def test_the_page_keeps_its_column_and_a_message_has_a_line_of_its_own(
    capsys: pytest.CaptureFixture[str],
) -> None:
    terminal, machine, heard = Terminal(), Machine(), list[int]()
    printer = machine.teletype.printer
    printer.on_frame = before = heard.append
    for _ in range(2):
        with terminal.printing(machine):
            for frame in b"A \n\n\r\nC\7":
                printer.on_frame(frame)
        terminal.say("said")
        terminal.say("more")
        assert capsys.readouterr().out == "A \n\x1b[3G\n\x1b[3G\r\nC\7\nsaid\nmore\n"
    assert (printer.on_frame, heard) == (before, [])


def test_the_prompt_gives_each_answer_a_line_and_takes_the_tapes_off_at_the_end(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    """Of a program that types A: what is behind `wait`, and before a refusal."""
    lines = ["deposit 200 7300 1204 6046 7402 301", "attach ptp out", "go 200", "wait 0.2"]
    more = ["go 200", "expect B 0.1", "examine 200", "quit", "echo no"]
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(command, "tell", print)
    page = "A\nhalt; 0.000011 s; next 0204  0301          AND 0301\n"
    refused = page + "'B' was not printed: the machine is stopped; the page shows 'AA'\n"
    for typed_in, shown in ((lines, f"{page}wrote out: 1 frame\n"), (lines + more, page + refused)):
        terminal = Terminal()
        monkeypatch.setattr(monitor, "_typed", partial(iter, typed_in))
        monitor.converse(Monitor(terminal.say, Machine()), terminal)
        found = capsys.readouterr().out
        assert found.startswith(shown)
        assert (tmp_path / "out").read_bytes() == b"\xc1" * shown.count("A\n")
    assert found == shown + "0200  7300          CLA CLL\nreplaced out: 2 frames\n"

    def closed() -> Iterator[str]:
        yield from lines
        raise SystemExit

    monkeypatch.setattr(monitor, "_typed", closed)
    with pytest.raises(SystemExit):
        monitor.converse(Monitor(print, Machine()), Terminal())
    assert (tmp_path / "out").read_bytes() == b"\xc1"


def test_what_is_typed_is_kept_where_there_is_a_folder_of_states(
    keys: PipeInput, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    """Where its file cannot be read or written, and of what is no text, no error comes between two lines."""
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path / "state"))
    file = tmp_path / "state" / "pdp8-monitor"
    for kept in (False, True, False):
        if file.exists():
            file.unlink()
            file.mkdir()
        keys.send_bytes(b"examine 200\r\4load \xe4\r\4")
        for line in ("examine 200", "load \udce4"):
            with create_app_session(keys, DummyOutput()):
                assert list(monitor._typed()) == [line]
        assert file.is_file() == kept
        file.parent.mkdir(exist_ok=True)


@pytest.mark.parametrize("term", ["xterm", "dumb"])
def test_a_signal_ends_the_prompt_wherever_it_comes(
    term: str, keys: PipeInput, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Also where what a handler raises is lost: in a finaliser, or in a library that catches it. A dumb
    terminal's prompt is there before it listens.
    """

    class Screen(DummyOutput):
        def flush(self) -> None:
            with suppress(SystemExit) if term == "xterm" else nullcontext():
                signal.raise_signal(signal.SIGTERM)

    def end(number: int, _: object) -> None:
        raise SystemExit(128 + number)

    monkeypatch.setenv("TERM", term)
    if term == "xterm":
        keys.send_text("examine 200\r")
    with leaving.taken(end, "SIGTERM"), create_app_session(keys, Screen()):
        with pytest.raises(SystemExit) as left:
            next(monitor._typed())
        assert left.value.code == 128 + signal.SIGTERM
        assert signal.getsignal(signal.SIGTERM) is end


ECHOES = (
    b"*200\n\tKCC\nN,\tKSF\n\tJMP N\n\tKRB\n\tTLS\n\tTSF\n\tJMP .-1\n\tISZ C\n\tJMP N\n\tHLT\nC,\t-4\n$\n"
)
READS = {"a.pal": ECHOES, "b": b"AB", "c": b"CD"}
"""A program that halts after four frames, and two tapes of it."""
_WRITES = [param.opts[0] for param in run.params if isinstance(param.type, Target)]


def test_with_a_user_at_the_teletype_a_run_does_all_else_as_without(
    keys: PipeInput, call: Call, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(keyboard, "create_input", lambda: keys)

    def did(more: str) -> tuple[int, str, dict[str, bytes]]:
        with folder(READS):
            before = existing()
            status, _, said = call(f"pdp8 run a.pal --reader b --reader c {more}", terminal=True)
            names = {name: content * (name == "p") for name, content in changed(before).items()}
        return status, re.sub(r"[\d.]+ s in 1971", "", said), names

    for given in ("", "--quiet", *(f"{option} t" for option in _WRITES if option != "--line")):
        with case(given):
            status, said, names = did(f"--punch p {given}")
            begins = "Teletype on line; Ctrl-] stops, and leaves to the monitor.\n"
            assert did(f"--punch p {given} --keyboard") == (status, begins + said, names)
            assert (status, names.get("p", b"ABCD")) == (0, b"ABCD")
            if "punch" not in given:  # nor does a tape go to standard output
                assert did(f"{given.replace(' t', ' -')} --keyboard")[0] == 0


def test_the_monitor_has_what_the_run_had_and_all_that_it_punches(
    keys: PipeInput, call: Call, monkeypatch: pytest.MonkeyPatch
) -> None:
    made = list[Monitor]()

    def converse(prompt: Monitor, _: Terminal) -> None:
        made.append(prompt)
        for line in ("deposit 300 7240 6046 7402", "set pc 300", "step 3", "wait 0.2"):
            do(prompt, line)

    keys.send_text("\x1d")
    monkeypatch.setattr(keyboard, "create_input", lambda: keys)
    monkeypatch.setattr(monitor, "converse", converse)
    with folder(READS):
        more = "--realtime --reader b --reader c --device dectape --punch p --dialect pal3"
        assert call(f"pdp8 run a.pal --keyboard {more}", terminal=True)[0] == 0
        assert Path("p").read_bytes().endswith(b"\xff")
    assert (made[0].realtime, made[0].waiting_tapes, "dt0" in made[0].reels.places) == (True, ["c"], True)
    assert (made[0].address("N"), made[0].dialect) == (0o201, "pal3")


def test_a_silent_pipe_holds_no_key_up_and_is_whole_after_a_step_back(
    keys: PipeInput, call: Call, monkeypatch: pytest.MonkeyPatch
) -> None:
    end, other = os.pipe()

    def converse(prompt: Monitor, terminal: Terminal) -> None:
        assert prompt.machine.teletype.printer.frames == b"A"
        os.write(other, b"CD")
        os.close(other)
        assert terminal.run(prompt.machine, 2)[0].reason is Reason.HALT
        do(prompt, "back 3 characters")
        assert terminal.run(prompt.machine, 2)[0].reason is Reason.HALT
        assert prompt.machine.teletype.printer.frames == b"ABCD"
        prompts.append(prompt)

    prompts = list[Monitor]()
    monkeypatch.setattr(keyboard, "create_input", lambda: keys)
    monkeypatch.setattr(monitor, "converse", converse)
    os.write(other, b"AB")
    late = Timer(0.7, keys.send_text, "\x1d")
    late.start()
    with folder(READS):
        status, _, said = call(f"pdp8 run a.pal --keyboard --reader /dev/fd/{end}", terminal=True)
    assert (status, len(prompts)) == (0, 1), said
    late.join()
    os.close(end)


def test_of_a_machine_that_was_restored_the_whole_tape_is_written(tmp_path: Path) -> None:
    machine, restored = Machine(), Machine()
    machine.teletype.punch.frames += b"AB"
    restored.teletype.punch.frames += b"ABCE"
    output = Output(machine, str(tmp_path / "p"))
    machine.teletype.punch.frames += b"D"
    for each, tape in ((machine, b"D"), (restored, b"ABCE"), (machine, b"ABD")):
        output.settle(each)
        assert (tmp_path / "p").read_bytes() == tape
    output.close()


def test_echo_is_for_a_script(call: Call) -> None:
    assert call("pdp8 monitor --echo", terminal=True)[0] == 2


def test_a_terminal_is_shown_the_page_and_no_control_codes(call: Call, tmp_path: Path) -> None:
    (tmp_path / "a.pal").write_text("*200\nA,\tLAS / \x1b\n\tTLS\n\tTSF\n\tJMP .-1\n\tHLT\n$\n")
    assert call("pdp8 run a.pal --sr 301", terminal=True)[1] == "A"
    assert call("pdp8 run a.pal --sr 301")[1].encode(errors="surrogateescape") == b"\xc1"
    shown = call("pdp8 run a.pal --sr 301 --punch a.tape --trace -", terminal=True)[1]
    assert "\x1b" not in shown
    assert "␛" in shown


def test_backspace_is_rubout_on_windows_too(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sys, "platform", "win32")
    presses = [KeyPress(Keys.ControlH, "\b"), KeyPress("x", "x"), KeyPress(Keys.Up, "")]
    assert characters(presses) == "\x7fx"


def test_a_feed_of_no_tapes_says_nothing_of_a_first_frame(capsys: pytest.CaptureFixture[str]) -> None:
    """The tape that a restored machine has is at its first frame, which START has read."""
    machine = Machine()
    machine.load({0o200: 0o5200})
    machine.teletype.reader.load(b"AB")
    machine.start(0o200)
    machine.run(seconds=0.15)
    assert (machine.teletype.reader.position, machine.teletype.receiver.flag) == (1, 1)
    for names, said in (([], False), (["in.asc"], True)):
        feed = Feed(machine.teletype.reader, names)
        for _ in range(2):
            with click.Context(click.Command("run")):
                feed.look(False)
        assert capsys.readouterr().err.count("the first frame") == said


def test_what_is_doubtful_about_a_pipe_is_said_at_its_first_piece(capsys: pytest.CaptureFixture[str]) -> None:
    machine, pieces = Machine(), [b"34\n", b"56\n"]
    end, other = os.pipe()
    feed = Feed(machine.teletype.reader, [f"/dev/fd/{end}"])
    feed.idle = lambda: not (pieces and os.write(other, pieces.pop(0)))
    machine.load({0o200: 0o6031, 0o201: 0o5200, 0o202: 0o6036, 0o203: 0o5200})
    os.write(other, b"12\n")
    with click.Context(click.Command("run")):
        assert feed.next_tape()
        machine.start(0o200)
        machine.run(seconds=2)
    assert (feed.read, capsys.readouterr().err.count("no block will end")) == (9, 1)
    os.close(end)
    os.close(other)


def test_windows_reads_a_tape_whole(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sys, "platform", "win32")
    reader = Machine().teletype.reader
    assert Feed(reader, ["circle.asc"]).next_tape()
    assert len(reader.tape) == 17982


def test_windows_has_no_line(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sys, "platform", "win32")
    ran = CliRunner().invoke(run, ["hello.pal", "--line", "COM1"])
    assert ran.exit_code == 2
    assert "--line needs the serial lines" in ran.output
