"""The examples of every --help: each can be pasted into a shell; its commands and options exist."""

import re
import shlex
from collections.abc import Iterator

import click

from pdp8.cli.root import pdp8
from release.reference import commands
from tests.conftest import case

PARENT = click.Context(pdp8, info_name="pdp8")


def examples(context: click.Context) -> list[str]:
    """Return the lines under `Examples:`."""
    _, _, below = context.get_help().partition("xamples:\n")
    return [line.strip() for line in below.partition("\n\n")[0].splitlines()]


def calls(example: str) -> Iterator[list[str]]:
    """Yield the words of each of our commands in a line for a shell, without what is redirected."""
    for piece in example.partition(" # ")[0].split(" | "):
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


def test_an_example_is_taken_as_it_stands() -> None:
    for command, example in PASTED:
        with case(command, example):
            assert "  " not in example.partition(" # ")[0].rstrip(), "a remark stands behind #"
            for words in calls(example):
                assert left_over(words) == []


def test_every_command_has_examples() -> None:
    assert {context.command_path for context in commands(PARENT)} - {path for path, _ in PASTED} == {"pdp8"}
