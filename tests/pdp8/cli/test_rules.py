"""What options need and exclude: each declaration names what there is, and `Command` holds a call to it."""

from dataclasses import dataclass

import click
import pytest
from click.testing import CliRunner

from pdp8.cli.shared import rules
from pdp8.cli.shared.arguments import Command
from pdp8.cli.shared.rules import declared, field, flag, option
from tests.pdp8.cli.test_root import EVERY

LEAVES = {path: each for path, each in EVERY.items() if not isinstance(each, click.Group)}


@dataclass(frozen=True)
class Watching:
    """Options of a command, declared as fields."""

    trace: str | None = field("--trace", "")
    cycles: bool = field("--cycles", "", needs="--trace --code=bin", is_flag=True)


@click.command(cls=Command)
@click.argument("tapes", nargs=-1)
@declared
@option("--code", "", default="ascii")
@option("--fill", "", default=6, needs="--code=ascii")
@option("--boot/--no-boot", "", excludes="--trace TAPES")
@flag("--list listed", "", only="TAPES --fill")
@flag("--all whole", "", only="")
def tried(tapes: tuple[str, ...], watching: Watching, **_: object) -> None:
    click.echo(f"{tapes} {watching.trace} {watching.cycles}")


@pytest.mark.parametrize(
    ("line", "refusal"),
    [
        ("a --trace x --cycles", ""),
        ("--code bin --cycles", ""),
        ("--cycles", "--cycles means nothing without --trace or --code bin."),
        ("--fill 6", ""),
        ("--fill 6 --code eia", "--fill means nothing without --code ascii."),
        ("--no-boot", ""),
        ("--no-boot --trace x a", "--boot does not go with --trace or TAPES."),
        ("--list a --fill 1", ""),
        (
            "--list a --trace x --code y",
            "--list is used with TAPES and --fill only: leave out --trace and --code.",
        ),
        ("--all", ""),
        ("--all --code ascii", "--all is used alone: leave out --code."),
    ],
)
def test_a_call_is_held_to_what_its_options_declare(line: str, refusal: str) -> None:
    ran = CliRunner().invoke(tried, line.split())
    assert (ran.exit_code, refusal in ran.output) == (2 if refusal else 0, True), ran.output


def test_a_field_of_a_dataclass_is_an_option() -> None:
    assert CliRunner().invoke(tried, ["a", "b", "--trace", "x"]).output == "('a', 'b') x False\n"


@pytest.mark.parametrize("path", LEAVES)
def test_every_command_holds_its_options_to_their_rules(path: str) -> None:
    found = LEAVES[path]
    assert isinstance(found, Command) or not found.params
    params = found.get_params(click.Context(found))
    known = {word for param in params for word in rules.words(param)}
    sized = [param.type for param in params if param.name == "memory"]
    assert not any(getattr(each, "case_sensitive", False) for each in sized), "8K is 8k too"
    declared = [
        getattr(param, rule, None) or "" for param in params for rule in ("needs", "excludes", "only")
    ]
    assert {word.partition("=")[0] for words in declared for word in words.split()} <= known
