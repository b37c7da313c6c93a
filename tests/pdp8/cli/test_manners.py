"""What all commands do alike: outputs proven first, files kept, streams and names not shared, long input."""

import signal
import subprocess
import time
from pathlib import Path

import click
import pytest

from pdp8.cli.root import pdp8
from release.reference import commands as walk
from tapes import binary, shelf
from tests import commands
from tests.conftest import Shell

DRILL = "001 0 00000 00000 0 35 88\n002 9 03000 00000 0 00 00\n"
DIGITS = b"0010000000000003588\n0029030000000000000\n"


@pytest.mark.parametrize("option", ["--trace", "--save", "--fast-punch"])
def test_outputs_are_proven_before_anything_is_emptied(shell: Shell, tmp_path: Path, option: str) -> None:
    (tmp_path / "out.tape").write_bytes(b"kept")
    done = shell(f"pdp8 run hello.pal --punch out.tape {option} /nowhere/x < /dev/null")
    assert done.returncode == 1
    assert done.stderr == b"pdp8 run: /nowhere/x: No such file or directory\n"
    assert (tmp_path / "out.tape").read_bytes() == b"kept"


def test_a_file_keeps_its_mode_and_a_link_its_place(shell: Shell, tmp_path: Path) -> None:
    (tmp_path / "real.bin").write_bytes(b"")
    (tmp_path / "real.bin").chmod(0o640)
    (tmp_path / "link.bin").symlink_to("real.bin")
    assert shell("pal hello.pal -o link.bin").returncode == 0
    assert (tmp_path / "link.bin").is_symlink()
    assert binary.decode((tmp_path / "real.bin").read_bytes()).words
    assert (tmp_path / "real.bin").stat().st_mode & 0o777 == 0o640


@pytest.mark.parametrize("number", [signal.SIGTERM, signal.SIGHUP])
def test_a_signal_leaves_no_file_half_written(tmp_path: Path, number: int) -> None:
    run = commands.start("pdp8", "run", "counter.pal", "--realtime", "--trace", "x.trace", folder=tmp_path)
    assert commands.eventually(lambda: list(tmp_path.glob("*.part")))
    run.send_signal(number)
    said = run.communicate(timeout=20)[1]
    assert run.returncode == 128 + number
    assert b"Traceback" not in said
    assert not list(tmp_path.iterdir())


def test_a_run_under_nohup_outlives_its_terminal(tmp_path: Path) -> None:
    line = ("nohup", "pdp8", "run", "counter.pal", "--realtime", "--trace", "x.trace")
    run = commands.start(*line, folder=tmp_path)
    assert commands.eventually(lambda: list(tmp_path.glob("*.part")))
    run.send_signal(signal.SIGHUP)
    with pytest.raises(subprocess.TimeoutExpired):
        run.wait(timeout=0.3)
    run.send_signal(signal.SIGTERM)
    run.communicate(timeout=20)
    assert run.returncode == 128 + signal.SIGTERM


def test_ctrl_c_ends_a_traced_run_soon(tmp_path: Path) -> None:
    (tmp_path / "busy.pal").write_text("*200\nL,\tISZ 10\n\tJMP L\n\tJMP L\n$\n")
    run = commands.start("pdp8", "run", "busy.pal", "--trace", "x.trace", folder=tmp_path)
    assert commands.eventually(lambda: list(tmp_path.glob("*.part")))
    time.sleep(0.5)
    began = time.monotonic()
    run.send_signal(signal.SIGINT)
    said = run.communicate(timeout=20)[1]
    assert time.monotonic() - began < 10
    assert b"interrupted at" in said
    assert run.returncode == 130


@pytest.mark.parametrize(
    "text",
    [
        "\n" + DRILL,
        DRILL.replace("\n", "\n\n", 1),
        DRILL + "\n",
        DRILL + "   \n",
        DRILL.replace(" ", "") + "\n",
    ],
    ids=["first", "middle", "last", "spaces", "unspaced"],
)
def test_a_blank_line_in_a_typed_program_means_nothing(shell: Shell, text: str) -> None:
    done = shell("pdp8 tape punch --code eia | pdp8 tape convert - --to text", text.encode())
    assert done.stdout == DIGITS


@pytest.mark.parametrize("line", ["002 9 03000 00000 0 00 0", "002 9 03000 00000 0 00 000"])
@pytest.mark.parametrize(("before", "code", "number"), [("", "ascii", 1), ("", "eia", 1), (DRILL, "eia", 3)])
def test_every_line_has_19_digits(shell: Shell, line: str, before: str, code: str, number: int) -> None:
    said = f"line {number}, column 1: a block of {len(line.replace(' ', ''))} digits; it has 19"
    for text in (f"{before}{line}\n", f"{before}{line}\n".replace(" ", "")):
        done = shell(f"pdp8 tape punch --code {code} > x", text.encode())
        assert (done.returncode, said in done.stderr.decode()) == (1, True), done.stderr


def test_standard_input_has_one_name_in_the_errors_of_a_source(shell: Shell) -> None:
    for command in ("run - --max-time 1", "pal - -o x.bin"):
        done = shell(f"printf '*200\\n\\tQQ\\n$\\n' | pdp8 {command}")
        assert b"\nstandard input:2:2: " in b"\n" + done.stderr, command


def test_page_and_table_share_no_stream_and_no_name(shell: Shell, tmp_path: Path) -> None:
    done = shell("pdp8 replay drill --html - --out desk")
    assert done.stdout.startswith(b"<!DOCTYPE html>")
    assert b"thesis beside replay" not in done.stdout
    assert b"thesis beside replay" in done.stderr
    done = shell("touch file; pdp8 replay drill --out file")
    assert (done.returncode, done.stderr) == (1, b"pdp8 replay: file: File exists\n"), "before the first act"
    done = shell("pdp8 replay drill --html again/drill.eia --out again")
    assert done.returncode == 2
    assert b"is the name of another file of the replay" in done.stderr
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


@pytest.mark.parametrize("encoding", ["ascii", "latin-1"])
def test_a_stream_that_is_not_utf8_takes_any_message(shell: Shell, encoding: str) -> None:
    done = shell(f"printf '*200\\n\\tCLÄ\\n$\\n' > x.pal; PYTHONIOENCODING={encoding} pal x.pal -o y")
    assert b"Traceback" not in done.stderr
    done = shell(f"PYTHONIOENCODING={encoding} pdp8 nc plot circle.eia")
    assert done.returncode == 0
    done.stdout.decode("utf-8")


def test_errors_on_one_long_line_are_excerpts_and_counted(shell: Shell, tmp_path: Path) -> None:
    (tmp_path / "long.pal").write_text(
        "*200\n" + ";".join(f"JMP {at * 128 % 4096:o}" for at in range(8000)) + "\n$\n"
    )
    done = shell("pal long.pal")
    assert done.returncode == 1
    assert len(done.stderr) < 60_000
    assert max(map(len, done.stderr.decode().splitlines())) < 200
    assert b"more\n" in done.stderr


def test_a_long_source_shows_a_bar_at_a_terminal(tmp_path: Path) -> None:
    (tmp_path / "long.pal").write_text("*200\n" + "1\n" * 1_000_000 + "$\n")
    terminal = commands.Terminal("pal", "long.pal", folder=tmp_path, TERM="xterm")
    terminal.until(b"assembling")
    assert terminal.ended() == 0


@pytest.mark.parametrize("option", ["--leader", "--fill"])
@pytest.mark.parametrize("count", ["100000000000000000000", "1000000000"])
def test_a_tape_of_miles_is_refused(shell: Shell, option: str, count: str) -> None:
    done = shell(f"echo A | pdp8 tape punch {option} {count} > x")
    assert done.returncode == 2
    assert b"Traceback" not in done.stderr


def test_dis_reads_standard_input(shell: Shell) -> None:
    assert shell("pdp8 dis", shelf.read_bundled("eia.bin")).stdout.startswith(b"*200\n")
    assert shell("pdp8 dis", b"").stderr.startswith(b"pdp8 dis: standard input: ")


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


EVERY = {each.command_path: each.command for each in walk(click.Context(pdp8, info_name="pdp8"))}
"""Each command with its name, `pdp8 tape show`."""


def options(name: str) -> list[tuple[str, click.Option]]:
    """Return each option that takes a value and answers to `name`, or every one, with its command."""
    return [
        (path, option)
        for path, command in EVERY.items()
        for option in command.params
        if isinstance(option, click.Option) and not option.is_flag and (not name or name in option.opts)
    ]


def test_no_clobber_stands_before_help_where_something_is_written() -> None:
    for path, each in EVERY.items():
        names = [param.name for param in each.get_params(click.Context(each))]
        assert ("no_clobber" in names[-2:-1]) >= ("output" in names), path
        assert "no_clobber" not in names[:-2], path


def test_every_option_tells_what_it_takes_in_its_metavar() -> None:
    for path, option in options(""):
        metavar = option.make_metavar(click.Context(pdp8))
        assert not metavar.startswith(("INTEGER", "FLOAT", "TEXT")), f"{path} {option.opts}: {metavar}"


def test_an_option_means_the_same_in_every_command() -> None:
    assert {option.metavar for _, option in options("--feed-code")} == {"CODE"}
    assert {option.metavar for _, option in options("--feed-error")} == {"PERCENT"}
    assert {option.metavar for _, option in options("--cutter")} == {"INCHES"}
    assert {option.metavar for _, option in options("--from")} == {"FRAME", "INCHES"}
    assert [option.opts for _, option in options("--out")] == [["-o", "--out"]] * len(options("-o"))


@pytest.mark.parametrize(
    "path",
    [path for path, each in EVERY.items() for option in each.params if option.required]
    + ["pdp8 nc view circle.eia"],
)
def test_what_is_required_is_asked_for(shell: Shell, path: str) -> None:
    done = shell(path)
    assert done.returncode == 2
    assert b": Missing " in done.stderr
