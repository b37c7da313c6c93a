"""The commands `pal` and `dis` as processes: the sessions of cli.txt, every source through a pipe, terminals.

A session of cli.txt is a title and commands, each with what it writes on standard output, what it says on
standard error, and its exit status unless that is 0.
"""

import re
import sys
from pathlib import Path

import pytest

import pal
from pal.assembler import HIGH_SPEED_SYMBOLS
from pdp8.cli import assemble
from pdp8.cli.assemble import AssemblyError
from tests import commands
from tests.commands import Terminal
from tests.conftest import Shell, case

HERE = Path(__file__).parent
EXAMPLES = HERE / "examples"
SOURCES = {
    "good": "*200\nA,\tCLA\n\tTAD A\n\tHLT\n$\n",
    "bad": "*200\n\tJMP 400\n$\n",
    "five": "*200\n\tTAD (5)\n\tHLT\n$\n",
}
SESSIONS = (HERE / "cli.txt").read_text("utf-8").removeprefix("== ").split("\n== ")


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    for name, source in SOURCES.items():
        (tmp_path / f"{name}.pal").write_text(source)
    return tmp_path


@pytest.mark.parametrize("session", SESSIONS, ids=lambda session: session.partition("\n")[0])
def test_a_session_goes_as_it_is_shown(session: str, folder: Path, shell: Shell) -> None:
    (folder / "examples").symlink_to(EXAMPLES)
    seen = session.partition("\n")[0]
    for line in re.findall(r"^\$ (.*)", session, re.MULTILINE):
        done = shell(line)
        status = f"[{done.returncode}]" if done.returncode else ""
        seen += f"\n$ {line}\n{(done.stdout + done.stderr).decode()}{status}".rstrip()
    assert seen == session.rstrip()


@pytest.mark.slow("each source is a process")
def test_every_source_through_a_pipe_gives_decs_tape_and_listing(folder: Path) -> None:
    """Our cases, which DEC's assembler did not see, give what the call makes of them."""
    for path in [*sorted(EXAMPLES.glob("*.pal")), *sorted(HERE.glob("cases/*.pal"))]:
        with case(path.stem):
            options = ["-o", "-", "--listing", "x.lst", "--force", "--high-speed-reader", "--dialect", "pal3"]
            done = commands.run("pal", "-", *options, folder=folder, stdin=path.read_bytes())
            listing = (folder / "x.lst").read_text()
            if path.parent == EXAMPLES:
                assert done.stdout == path.with_suffix(".bin").read_bytes()
                assert listing == path.with_suffix(".pass3.txt").read_text()
            else:
                assembly = pal.assemble(path.read_text(), capacity=HIGH_SPEED_SYMBOLS)
                assert (done.stdout, listing) == (assembly.tape, assembly.listing)


def at_a_terminal(line: str, folder: Path, no_color: str = "") -> str:
    """Return what a terminal shows of a command line."""
    terminal = Terminal(*line.split(), folder=folder, TERM="xterm-256color", NO_COLOR=no_color)
    terminal.ended()
    return terminal.seen.decode().replace("\r\n", "\n")


def test_a_terminal_is_shown_colours_that_it_may_have(folder: Path) -> None:
    (folder / "wide.pal").write_text(wide := SOURCES["good"].replace("HLT", f"HLT\t/{'X' * 120}"))
    shown = at_a_terminal("pal wide.pal --listing -", folder)
    assert "\x1b[94mTAD" in shown
    plain = re.sub(r"\x1b\[[0-9;]*m", "", shown)
    assert plain == pal.assemble(wide).listing.expandtabs(8) + "\n"
    for no_color in ("", "1"):
        shown = at_a_terminal("pal five.pal --check", folder, no_color)
        assert ("\x1b[36m" in shown) == (no_color == "")


def test_without_pygls_an_editor_is_told(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delattr(pal, "server", raising=False)
    monkeypatch.setitem(sys.modules, "pal.server", None)
    with pytest.raises(AssemblyError, match=r"^--lsp needs pygls: .*pip install .*\[lsp\]"):
        assemble.pal.main(["--lsp"], standalone_mode=False)


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="no /dev/full")
def test_a_file_that_cannot_be_written_stops_no_other(folder: Path, shell: Shell) -> None:
    done = shell("pal good.pal -o good.bin --listing /dev/full --symbols /dev/full --json good.json")
    assert done.returncode == 1
    said = done.stderr.decode().splitlines()
    assert sorted(said) == ["pal: /dev/full: No space left on device"] * 2 + [
        "wrote good.bin",
        "wrote good.json",
    ]
    assert (folder / "good.bin").read_bytes() == pal.assemble(SOURCES["good"]).tape
