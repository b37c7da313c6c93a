"""The top of the command line: --version, --help, and a command that does not exist."""

import pytest

import pdp8
from pdp8.cli import root
from pdp8.computer.speed import engine
from tests.conftest import Shell


@pytest.mark.parametrize("command", ["pdp8", "pdp8l"])
def test_the_version_says_which_core_runs_and_where(command: str, shell: Shell) -> None:
    path = str(engine.__file__)
    form = "interpreted" if path.endswith(".py") else "compiled"
    done = shell(f"{command} --version")
    assert done.stdout.decode() == f"pdp8, version {pdp8.__version__}, {form} core: {path}\n"
    assert (done.returncode, done.stderr) == (0, b"")


def test_the_version_of_the_assembler(shell: Shell) -> None:
    assert shell("pal --version").stdout.decode() == f"pal, version {pdp8.__version__}\n"


@pytest.mark.parametrize("option", ["--help", "-h"])
def test_the_help_names_every_command_in_one_line_each_in_groups(option: str, shell: Shell) -> None:
    done = shell(f"pdp8 {option}")
    shown = done.stdout.decode()
    assert "pdp8 run eia.pal --reader circle.asc --punch circle.eia" in shown
    groups = shown[shown.index("Run:\n") :].split("\n\n")
    assert [group.partition(":\n")[0] for group in groups] == [
        *("Run", "Assemble", "Tapes", "Parts and machine tool", "Teach", "Research")
    ]
    lines = [group.strip("\n").splitlines()[1:] for group in groups]
    named = [line.split()[0] for group in lines for line in group]
    assert named == root.pdp8.list_commands(None)  # type: ignore[arg-type]


@pytest.mark.parametrize("command", ["pdp8", "pdp8 tape"])
def test_no_command_is_misuse_and_shows_the_help_alone(command: str, shell: Shell) -> None:
    done = shell(command)
    assert done.returncode == 2
    assert done.stdout + done.stderr == shell(f"{command} --help").stdout
