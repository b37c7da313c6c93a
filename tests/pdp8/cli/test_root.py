"""--version and --help: all commands have a line; their examples can be pasted into a shell, and exist."""

import re
import shlex
from collections.abc import Iterator

import click
import pytest

import pdp8
from pdp8.cli import root
from pdp8.computer.speed import engine
from release.reference import commands
from tests.conftest import Call, Shell, case


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


def test_help_is_a_command_too(call: Call) -> None:
    for words in ("", "tape", "tape show"):
        assert call(f"pdp8 help {words}") == call(f"pdp8 {words} --help")
    assert call("pdp8 help help")[0] == 2


@pytest.mark.parametrize("group", ["", "tape", "nc", "part", "thesis"])
def test_lists_of_commands_have_whole_lines(group: str, call: Call) -> None:
    listed = call(f"pdp8 {group} --help")[1].partition("Commands:\n" if group else "Run:\n")[2]
    assert listed
    assert "..." not in listed


PARENT = click.Context(root.pdp8, info_name="pdp8")
EVERY = {context.command_path: context.command for context in commands(PARENT)}


@pytest.mark.parametrize("path", EVERY)
def test_an_option_without_its_value_is_a_misuse_of_its_command(path: str, call: Call) -> None:
    for param in EVERY[path].params:
        if isinstance(param, click.Option) and not param.is_flag:
            word = max(param.opts, key=len)
            status, _, said = call(f"{path} {word}")
            assert (status, said.partition("\n")[0]) == (2, f"{path}: Option '{word}' requires an argument.")


"""Each command by its name, `pdp8 tape show`."""


def examples(context: click.Context) -> list[str]:
    """Return the lines under `Examples:`."""
    _, _, below = context.get_help().partition("xamples:\n")
    return [line.strip() for line in below.partition("\n\n")[0].splitlines()]


def calls(example: str) -> Iterator[list[str]]:
    """Yield the words of each of our commands in a line for a shell, without what is redirected."""
    for piece in re.split(r" \| |; ", example.partition(" # ")[0]):
        words = shlex.split(re.sub(r" [<>] \S+", "", piece))
        if words[0] in ("pdp8", "pal"):
            yield words[1:] if words[0] == "pdp8" else words


def left_over(words: list[str]) -> list[str]:
    """Return the words that the command does not take; raise a UsageError for an option that it has not."""
    context = PARENT
    while isinstance(context.command, click.Group):
        found = context.command.get_command(context, words[0])
        assert found, f"no command {words[0]}"
        context, words = click.Context(found, info_name=words[0], parent=context), words[1:]
    _, rest, _ = context.command.make_parser(context).parse_args(list(words))
    return rest


PASTED = sorted({(context.command_path, line) for context in commands(PARENT) for line in examples(context)})


def test_every_command_has_examples_and_one_is_taken_as_it_stands() -> None:
    assert EVERY.keys() - {path for path, _ in PASTED} == {"pdp8"}
    for command, example in PASTED:
        with case(command, example):
            assert "  " not in example.partition(" # ")[0].rstrip(), "a remark stands behind #"
            for words in calls(example):
                assert left_over(words) == []


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
        metavar = option.make_metavar(PARENT)
        assert not metavar.startswith(("INTEGER", "FLOAT", "TEXT")), f"{path} {option.opts}: {metavar}"


def test_an_option_means_the_same_in_every_command() -> None:
    metavars = {"--feed-code": {"CODE"}, "--feed-error": {"PERCENT"}, "--from": {"FRAME", "INCHES"}}
    for name, expected in {**metavars, "--cutter": {"INCHES"}}.items():
        found = [option for _, option in OPTIONS if name in option.opts]
        assert {option.metavar or option.type.name.upper() for option in found} == expected
    assert all(option.opts == ["-o", "--out"] for _, option in OPTIONS if "-o" in option.opts)
