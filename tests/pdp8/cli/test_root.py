"""The top of the command line: --version, --help, and a command that does not exist."""

import pytest

import pdp8
from pdp8.cli import root
from pdp8.computer.speed import engine
from tests.conftest import Call, Shell


def test_the_version_says_which_core_runs_and_where(shell: Shell) -> None:
    path = str(engine.__file__)
    form = "interpreted" if path.endswith(".py") else "compiled"
    said = f"pdp8, version {pdp8.__version__}, {form} core: {path}\n"
    for name, expected in (("pdp8", said), ("pdp8l", said), ("pal", f"pal, version {pdp8.__version__}\n")):
        done = shell(f"{name} --version")
        assert (done.returncode, done.stdout.decode(), done.stderr) == (0, expected, b"")


@pytest.mark.parametrize("option", ["--help", "-h"])
def test_the_help_names_every_command_in_one_line_each_in_groups(option: str, shell: Shell) -> None:
    shown = shell(f"pdp8 {option}").stdout.decode()
    assert "pdp8 run eia.pal --reader circle.asc --punch circle.eia" in shown
    groups = shown[shown.index("Run:\n") :].split("\n\n")
    assert [group.partition(":\n")[0] for group in groups] == [
        *("Run", "Assemble", "Tapes", "Parts and machine tool", "Teach", "Research")
    ]
    lines = [group.strip("\n").splitlines()[1:] for group in groups]
    named = [line.split()[0] for group in lines for line in group]
    assert named == root.pdp8.list_commands(None)  # type: ignore[arg-type]


@pytest.mark.parametrize("command", ["pdp8", "pdp8 tape"])
def test_no_command_is_misuse_and_shows_the_help_alone(command: str, call: Call) -> None:
    status, shown, said = call(command)
    assert status == 2
    assert shown + said == call(f"{command} --help")[1]


@pytest.mark.parametrize("group", ["", "tape", "nc", "part", "thesis"])
def test_lists_of_commands_have_whole_lines(group: str, call: Call) -> None:
    listed = call(f"pdp8 {group} --help")[1].partition("Commands:\n" if group else "Run:\n")[2]
    assert listed
    assert "..." not in listed
