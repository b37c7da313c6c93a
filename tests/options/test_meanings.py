"""What options mean that many commands have: a file is written, replaced, kept; less is said."""

from collections.abc import Iterator
from functools import cache

import click
import pytest

from pdp8.cli.part_options import Typed
from pdp8.cli.root import pdp8
from pdp8.cli.shared.arguments import Target
from release.reference import commands
from tests.conftest import case
from tests.options import inputs
from tests.options.trial import Outcome, outcome

NAME = "named.out"
MARK = "\ufeff".encode()
"""Excel wants it in a file."""
PAGES = ("workbench", "thesis page", "replay")
"""Of them the tests of the pages know more."""
LEFT_OUT = ("--export-student", "--printer", "--line", "--facsimile")
"""Goes with no other; need a program that prints, a serial line; takes long."""


def _named() -> dict[str, list[click.Option]]:
    """Return the options of each command that name a file to write; those of one part for all."""
    found = {}
    for context in commands(click.Context(pdp8, info_name="pdp8")):
        name = context.command_path.partition(" ")[2]
        options = [
            param
            for param in context.command.params
            if isinstance(param, click.Option) and isinstance(param.type, Target)
            if param.opts[0] not in LEFT_OUT
        ]
        part = name.startswith("part ") and name != "part circle"
        if options and name in inputs.CALLS and name not in PAGES and not part:
            found[name] = options
    return found


NAMED = _named()


def did(command: str, line: str, before: bytes | None = None) -> Outcome:
    """Return what a call does in a folder of the inputs, where a file may be there `before`."""
    files = inputs.FILES if before is None else {**inputs.FILES, NAME: before}
    return outcome(f"{command} {line}", files, inputs.STDIN.get(command, b""))


def written(command: str, option: click.Option) -> tuple[str, Outcome]:
    """Return a call that writes the file of an option, and what it does."""
    calls = (call for call in inputs.CALLS[command] if f" {option.opts[0]} " not in call)
    made = ((call, did(command, f"{option.opts[0]} {NAME} {call}")) for call in calls)
    return next(each for each in made if each[1].files.get(NAME))


@pytest.mark.parametrize("command", NAMED)
def test_a_file_is_written_then_replaced_then_kept(command: str) -> None:
    """The second time it is the same file; what is there is told, and --no-clobber keeps it. On standard
    output it is alone.
    """
    for option in NAMED[command]:
        with case(option.opts[0]):
            call, first = written(command, option)
            content, line = first.files[NAME], f"{option.opts[0]} {NAME} {call}"
            assert first.said.count(b"wrote named.out\n") == 1
            assert b"replaced" not in first.said
            again = did(command, line, content)
            assert again.said == first.said.replace(b"wrote named.out\n", b"replaced named.out\n")
            assert again.files == {name: each for name, each in first.files.items() if name != NAME}
            assert (again.status, again.shown) == (first.status, first.shown)
            kept = did(command, f"{line} --no-clobber", content)
            assert (kept.status, kept.shown, kept.files) == (1, b"", {})
            assert b"named.out exists" in kept.said
            shown = did(command, call if option.default == "-" else f"{option.opts[0]} - {call}")
            if option.opts[0] != "--fast-punch":  # the other punch has standard output
                assert (shown.status, shown.shown) == (first.status, content.removeprefix(MARK))


def _numbers() -> Iterator[tuple[str, str]]:
    """Yield the options that are a number, or left out: a command and its option."""
    kinds = click.types.IntParamType, click.types.FloatParamType, click.types.FuncParamType, Typed
    for context in commands(click.Context(pdp8, info_name="pdp8")):
        name = context.command_path.partition(" ")[2]
        for param in context.command.params:
            if isinstance(param.type, kinds) and not isinstance(param.default, str | int | float | tuple):
                yield name, param.opts[0]


def test_nought_is_not_taken_for_an_option_that_is_left_out() -> None:
    """It acts, or it is refused."""
    without = cache(did)
    for command, option in _numbers():
        calls = [call for call in inputs.CALLS.get(command, ()) if option not in call][:3]
        with case(command, option):
            tried = ((did(command, f"{option} 0 {call}"), call) for call in calls)
            assert not calls or any(now.refused or now != without(command, call) for now, call in tried)


def test_an_empty_file_is_not_replaced_by_a_punched_tape() -> None:
    """A shell may have made it."""
    assert b"wrote named.out" in did("run", f"--punch {NAME} work.pal", b"").said


def test_quiet_leaves_out_messages_alone() -> None:
    """With it the status, product and files are the same, and what has failed is said."""
    for call in inputs.CALLS["run"]:
        with case(call):
            loud, quiet = (did("run", f"{call} {quiet}") for quiet in ("", "--quiet"))
            assert quiet._replace(said=b"") == loud._replace(said=b"")
            assert {*quiet.said.splitlines()} <= {*loud.said.splitlines()}
            assert quiet.said.splitlines()[-1:] == loud.said.splitlines()[-1:] * bool(loud.status)
