"""How every command ends: by whatever is raised in it, and with a standard stream that its caller closed."""

import importlib
import os
import signal
import sys
from collections.abc import Callable, Iterator
from errno import ENOENT, ENOSPC, EPIPE
from functools import partial
from io import BytesIO, TextIOWrapper
from unicodedata import category

import click
import pytest

from pdp8.cli.root import pdp8
from pdp8.cli.running import pacing
from pdp8.cli.shared import command
from tapes.errors import TapeError, visible


@pytest.mark.parametrize(
    ("raised", "status", "said"),
    [
        (TapeError("torn", 3), 1, "own part: frame 3: torn"),
        (click.UsageError("no"), 2, "own part: no\nown part --help shows what there is"),
        (click.ClickException("no"), 1, "own: no\nown --help shows what there is"),
        (KeyboardInterrupt(), 130, "\nown part: interrupted"),
        (RecursionError(), 1, "own part: nested too deeply"),
        (MemoryError(), 1, "own part: out of memory"),
        (OSError(ENOSPC, "full", "x"), 1, "own part: x: full"),
        (OSError(ENOSPC, "full"), 1, "own part: standard output: full"),
        (FileNotFoundError(ENOENT, "gone"), 1, "own part: the current folder: gone"),
        (OSError("odd"), 1, "own part: standard output: odd"),
        (BrokenPipeError(EPIPE, "closed"), 0, ""),
        (BrokenPipeError(), 0, ""),
    ],
)
def test_what_is_raised_is_said_in_a_line(
    raised: BaseException,
    status: int,
    said: str,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    @click.group()
    def own() -> None: ...

    @own.command()
    @click.argument("file")
    def part(file: str) -> None:
        raise raised

    monkeypatch.setattr(sys, "stdout", sys.stdout)  # click puts another one there
    assert command.status(own, "own", ["part", "own"]) == status
    assert capsys.readouterr() == ("", said and f"{said}\n")


def test_a_fault_of_the_program_is_shown_as_one(monkeypatch: pytest.MonkeyPatch) -> None:
    """Whether or not the module is there that tells a device's."""
    for known in (True, False):
        if known:
            importlib.import_module("pdp8.fitting")
        else:
            monkeypatch.delitem(sys.modules, "pdp8.fitting")
        with pytest.raises(ZeroDivisionError):
            command.status(click.Command("own", callback=lambda: 1 // 0), "own", [])


@pytest.mark.parametrize(("returned", "status"), [(3, 3), (None, 0), ("3", 0)])
def test_what_a_command_returns_is_its_status_if_it_is_a_number(returned: object, status: int) -> None:
    assert command.status(click.Command("own", callback=lambda: returned), "own", []) == status


def test_what_standard_output_still_holds_is_written(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    def failing() -> None:
        print("x")
        raise TapeError("torn")

    for callback, said in (
        (lambda: print("x"), "standard output: No space left on device"),
        (failing, "torn"),
    ):
        with open("/dev/full", "w", encoding="utf-8") as full:
            monkeypatch.setattr(sys, "stdout", full)
            assert command.status(click.Command("own", callback=callback), "own", []) == 1
        assert capsys.readouterr().err == f"own: {said}\n"


@pytest.fixture(autouse=True)
def signals() -> Iterator[None]:
    """Have the signals after each test as they were."""
    numbers = [getattr(signal, name) for name in ("SIGINT", "SIGTERM", "SIGHUP") if hasattr(signal, name)]
    before = [signal.getsignal(number) for number in numbers]
    yield
    for number, handler in zip(numbers, before, strict=True):
        signal.signal(number, handler)


@pytest.mark.parametrize("name", ["SIGINT", "SIGTERM", "SIGHUP"])
def test_a_signal_that_is_ignored_stays_so(name: str) -> None:
    """In the background, under nohup."""
    number = getattr(signal, name)
    signal.signal(number, signal.SIG_IGN)

    def inside() -> int:
        with pacing.ctrl_c():  # as in a run
            return int(signal.getsignal(number) is signal.SIG_IGN)

    with pytest.raises(SystemExit, match="1"):
        command.run(click.Command("own", callback=inside), "own", [])
    assert signal.getsignal(number) is signal.SIG_IGN


def test_a_stream_that_is_not_utf8_takes_any_character(monkeypatch: pytest.MonkeyPatch) -> None:
    kept = BytesIO()
    monkeypatch.setattr(sys, "stdout", TextIOWrapper(kept, encoding="latin-1"))
    with pytest.raises(SystemExit, match="0"):
        command.run(click.Command("own", callback=lambda: command.echo("→")), "own", [])
    command.put("-", "→")
    assert kept.getvalue() == b"?\n" + "→".encode(), "a drawing is UTF-8"


@pytest.mark.parametrize("closed", ["stdin", "stdout", "stderr"])
def test_a_closed_standard_stream_is_no_traceback(
    closed: str, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(sys, closed, None)
    said = "pdp8 tape info: standard output: Bad file descriptor\n" if closed == "stdout" else ""
    with pytest.raises(SystemExit, match="1" if said else "0"):
        command.run(pdp8, "pdp8", ["tape", "info", "-" if closed == "stdin" else "circle.asc"])
    getattr(sys, closed).close()
    assert signal.getsignal(signal.SIGINT) is signal.default_int_handler
    assert capsys.readouterr().err == said


@pytest.mark.parametrize(
    ("name", "write"),
    [("stderr", command.tell), ("stdout", command.echo), ("stdout", partial(command.put, "-"))],
)
def test_a_stream_that_nobody_reads_is_pointed_at_nothing(
    name: str, write: Callable[[str], None], monkeypatch: pytest.MonkeyPatch
) -> None:
    reader, writer = os.pipe()
    os.close(reader)
    with os.fdopen(writer, "w") as stream:
        monkeypatch.setattr(sys, name, stream)
        write("x")
        print("what Python writes at exit", file=stream, flush=True)


def test_a_conversation_has_the_standard_streams_for_itself(
    monkeypatch: pytest.MonkeyPatch, capfd: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(sys, "stdin", sys.stdin)
    with command.conversation() as (reader, writer), reader, writer:
        assert os.path.samestat(os.fstat(reader.fileno()), os.fstat(0))
        writer.write(f"{sys.stdin.read()}answer".encode())
        print("noise")
    assert capfd.readouterr() == ("answer", "noise\n")


def test_control_codes_are_shown_as_pictures_or_escapes() -> None:
    """By Unicode's own categories, of what a tape or a name can hold."""
    for character in map(chr, (*range(0x300), 0xFFFD, 0xFFFE, 0xFFFF, 0xDCFF)):
        plain = category(character) not in ("Cc", "Cn", "Cs") or character in "\t\n"
        assert (visible(character) == character) == plain, ascii(character)
    assert visible("\0\x1b\x7f\x80\x9f\ufffe\uffff\udcff") == r"␀␛␡\x80\x9f\ufffe\uffff\udcff"


@pytest.mark.parametrize("terminal", [False, True])
def test_a_terminal_is_shown_the_control_codes_that_a_file_is_given(
    terminal: bool, monkeypatch: pytest.MonkeyPatch, capsysbinary: pytest.CaptureFixture[bytes]
) -> None:
    monkeypatch.setattr(sys.stdout, "isatty", lambda: terminal)
    command.put("-", "A\x1b[2J\n")
    command.echo("B\x1b[2J")
    assert capsysbinary.readouterr().out == b"A\x1b[2J\nB\x1b[2J\n".replace(
        b"\x1b", "␛".encode() if terminal else b"\x1b"
    )
