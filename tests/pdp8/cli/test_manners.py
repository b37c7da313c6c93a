"""What all commands do alike: outputs proven first, files kept, streams and names not shared, long input."""

import re
import signal
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


@pytest.mark.parametrize(
    ("number", "left"), [(signal.SIGINT, {"x.trace"}), (signal.SIGTERM, set()), (signal.SIGHUP, set())]
)
def test_a_signal_leaves_no_file_half_written(number: int, left: set[str], tmp_path: Path) -> None:
    (tmp_path / "busy.pal").write_text("*200\nL,\tISZ 10\n\tJMP L\n\tJMP L\n$\n")
    run = commands.start("pdp8", "run", "busy.pal", "--trace", "x.trace", folder=tmp_path)
    assert commands.eventually(lambda: list(tmp_path.glob("*.part")))
    assert commands.signalled(run, number)[0] == 128 + number
    assert {path.name for path in tmp_path.iterdir()} == {"busy.pal", *left}


def test_page_and_table_share_no_stream_and_no_name(call: Call, tmp_path: Path) -> None:
    _, shown, said = call("pdp8 replay drill --html - --out desk")
    assert shown.startswith("<!DOCTYPE html>")
    assert "thesis beside replay" not in shown
    assert "thesis beside replay" in said
    status, _, said = call("pdp8 replay drill --html again/drill.eia --out again")
    assert (status, "is the name of another file of the replay" in said) == (2, True)
    assert not (tmp_path / "again").exists()


def test_errors_on_one_long_line_are_excerpts_and_counted(call: Call, tmp_path: Path) -> None:
    far = ";".join(f"JMP {at * 128 % 4096:o}" for at in range(8000))
    (tmp_path / "long.pal").write_text(f"*200\n{far}\n$\n")
    status, _, said = call("pal long.pal")
    assert status == 1
    assert len(said) < 60_000
    assert max(map(len, said.splitlines())) < 200
    assert "more\n" in said


def test_standard_input_has_one_name(call: Call) -> None:
    assert call("pdp8 dis", shelf.read_bundled("eia.bin"))[1].startswith("*200\n")
    for line in ("pdp8 run - --max-time 1", "pal - -o x.bin"):
        _, _, said = call(line, b"*200\n\tQQ\n$\n")
        assert re.search("^standard input:2:2: ", said, re.M), line


def test_a_shell_is_told_how_to_complete(shell: Shell) -> None:
    assert b"_PDP8_COMPLETE" in shell("_PDP8_COMPLETE=zsh_source pdp8").stdout


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
