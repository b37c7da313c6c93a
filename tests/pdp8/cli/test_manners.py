"""What all commands do alike: outputs proven first, files kept, streams and names not shared, long input."""

import re
import signal
import subprocess
import time
from pathlib import Path

import click
import pytest

from pdp8.cli.root import pdp8
from tapes import binary, shelf
from tests import commands
from tests.conftest import Call, Shell
from tests.pdp8.cli.test_refusals import EVERY


@pytest.mark.parametrize("option", ["--trace", "--save", "--fast-punch"])
def test_outputs_are_proven_before_anything_is_emptied(call: Call, tmp_path: Path, option: str) -> None:
    (tmp_path / "out.tape").write_bytes(b"kept")
    done = call(f"pdp8 run hello.pal --punch out.tape {option} /nowhere/x")
    assert done == (1, "", "pdp8 run: /nowhere/x: No such file or directory\n")
    assert (tmp_path / "out.tape").read_bytes() == b"kept"


def test_a_file_keeps_its_mode_and_a_link_its_place(call: Call, tmp_path: Path) -> None:
    (tmp_path / "real.bin").write_bytes(b"")
    (tmp_path / "real.bin").chmod(0o640)
    (tmp_path / "link.bin").symlink_to("real.bin")
    assert call("pal hello.pal -o link.bin")[0] == 0
    assert (tmp_path / "link.bin").is_symlink()
    assert binary.decode((tmp_path / "real.bin").read_bytes()).words
    assert (tmp_path / "real.bin").stat().st_mode & 0o777 == 0o640


def traced(folder: Path, *before: str) -> "subprocess.Popen[bytes]":
    """Start a run that does not end, which has begun a file when this returns."""
    (folder / "busy.pal").write_text("*200\nL,\tISZ 10\n\tJMP L\n\tJMP L\n$\n")
    run = commands.start(*before, "pdp8", "run", "busy.pal", "--trace", "x.trace", folder=folder)
    assert commands.eventually(lambda: list(folder.glob("*.part")))
    return run


@pytest.mark.parametrize("number", [signal.SIGTERM, signal.SIGHUP])
def test_a_signal_leaves_no_file_half_written(tmp_path: Path, number: int) -> None:
    assert commands.signalled(traced(tmp_path), number) == (128 + number, b"")
    assert [path.name for path in tmp_path.iterdir()] == ["busy.pal"]


def test_a_run_under_nohup_outlives_its_terminal(tmp_path: Path) -> None:
    run = traced(tmp_path, "nohup")
    run.send_signal(signal.SIGHUP)
    with pytest.raises(subprocess.TimeoutExpired):
        run.wait(timeout=0.3)
    assert commands.signalled(run, signal.SIGTERM)[0] == 128 + signal.SIGTERM


def test_ctrl_c_ends_a_traced_run_soon(tmp_path: Path) -> None:
    run = traced(tmp_path)
    time.sleep(0.5)
    began = time.monotonic()
    status, said = commands.signalled(run, signal.SIGINT)
    assert time.monotonic() - began < 10
    assert (status, b"interrupted at" in said) == (130, True)


def test_page_and_table_share_no_stream_and_no_name(call: Call, tmp_path: Path) -> None:
    _, shown, said = call("pdp8 replay drill --html - --out desk")
    assert shown.startswith("<!DOCTYPE html>")
    assert "thesis beside replay" not in shown
    assert "thesis beside replay" in said
    (tmp_path / "file").touch()
    assert call("pdp8 replay drill --out file") == (1, "", "pdp8 replay: file: File exists\n")
    status, _, said = call("pdp8 replay drill --html again/drill.eia --out again")
    assert status == 2
    assert "is the name of another file of the replay" in said
    assert not (tmp_path / "again").exists()


@pytest.mark.parametrize(
    "line",
    ["run eia.pal --reader circle.asc", "part ellipse", "nc list circle.eia", "cards all", "thesis list"],
)
def test_a_closed_pipe_is_no_error(shell: Shell, line: str) -> None:
    line = f"pdp8 {line} 2> said | head -c 1 > /dev/null; echo ${{PIPESTATUS[0]}}"
    done = shell(f"{line}; grep -i pipe said")
    assert done.stdout == b"0\n"


def test_a_closed_standard_output_is_one_error(shell: Shell) -> None:
    done = shell("pdp8 run hello.pal >&-")
    assert done.returncode == 1
    assert done.stderr == b"pdp8 run: standard output: Bad file descriptor after 0 frames\n"


def test_a_drawing_is_utf8_whatever_the_stream_is(shell: Shell) -> None:
    done = shell("PYTHONIOENCODING=latin-1 pdp8 nc plot circle.eia")
    assert done.returncode == 0
    assert done.stdout.decode("utf-8")


def test_errors_on_one_long_line_are_excerpts_and_counted(call: Call, tmp_path: Path) -> None:
    far = ";".join(f"JMP {at * 128 % 4096:o}" for at in range(8000))
    (tmp_path / "long.pal").write_text(f"*200\n{far}\n$\n")
    status, _, said = call("pal long.pal")
    assert status == 1
    assert len(said) < 60_000
    assert max(map(len, said.splitlines())) < 200
    assert "more\n" in said


def test_a_long_source_shows_a_bar_at_a_terminal(tmp_path: Path) -> None:
    (tmp_path / "long.pal").write_text("*200\n" + "1\n" * 1_000_000 + "$\n")
    terminal = commands.Terminal("pal", "long.pal", folder=tmp_path, TERM="xterm")
    terminal.until(b"assembling")
    assert terminal.ended() == 0


def test_standard_input_has_one_name(call: Call) -> None:
    assert call("pdp8 dis", shelf.read_bundled("eia.bin"))[1].startswith("*200\n")
    for line in ("pdp8 run - --max-time 1", "pal - -o x.bin"):
        _, _, said = call(line, b"*200\n\tQQ\n$\n")
        assert re.search("^standard input:2:2: ", said, re.M), line


@pytest.mark.parametrize("kind", ["bash", "zsh", "fish"])
def test_completion(shell: Shell, kind: str) -> None:
    done = shell(f"_PDP8_COMPLETE={kind}_source pdp8")
    if kind == "bash" and done.returncode:
        pytest.skip("this bash is too old for completion")
    assert b"_PDP8_COMPLETE" in done.stdout


@pytest.mark.parametrize("columns", ["20", "40"])
def test_narrow_terminals_and_no_colour(columns: str, tmp_path: Path) -> None:
    line = "pdp8 run --help; pal hello.pal -o x.bin --listing -"
    variables = {"COLUMNS": columns, "NO_COLOR": "1", "TERM": "xterm-256color"}
    terminal = commands.Terminal("bash", "-c", line, folder=tmp_path, **variables)
    assert terminal.ended() == 0
    assert b"Traceback" not in terminal.seen
    assert b"\x1b[3" not in terminal.seen
    assert b"--max-time" in terminal.seen


OPTIONS = [
    (path, option)
    for path, command in EVERY.items()
    for option in command.params
    if isinstance(option, click.Option) and not option.is_flag
]
"""Each option that takes a value, with its command."""


def test_no_clobber_stands_before_help_where_something_is_written() -> None:
    for path, each in EVERY.items():
        names = [param.name for param in each.get_params(click.Context(each))]
        assert ("no_clobber" in names[-2:-1]) >= ("output" in names), path
        assert "no_clobber" not in names[:-2], path


def test_every_option_tells_what_it_takes_in_its_metavar() -> None:
    for path, option in OPTIONS:
        metavar = option.make_metavar(click.Context(pdp8))
        assert not metavar.startswith(("INTEGER", "FLOAT", "TEXT")), f"{path} {option.opts}: {metavar}"


def test_an_option_means_the_same_in_every_command() -> None:
    metavars = {"--feed-code": {"CODE"}, "--feed-error": {"PERCENT"}, "--from": {"FRAME", "INCHES"}}
    for name, expected in {**metavars, "--cutter": {"INCHES"}}.items():
        assert {option.metavar for _, option in OPTIONS if name in option.opts} == expected
    assert all(option.opts == ["-o", "--out"] for _, option in OPTIONS if "-o" in option.opts)
