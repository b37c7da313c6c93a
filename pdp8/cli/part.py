"""`pdp8 part`: each part program as a command whose options are its constants."""

import os
import re
from collections.abc import Callable
from itertools import zip_longest
from typing import Any, Literal

import click

from pdp8 import companion, shelf
from pdp8.cli import part_options
from pdp8.cli.shared import command
from pdp8.cli.shared.arguments import Command, Group, Source, Target, output
from pdp8.cli.shared.rules import Option, flag, option
from programs.arithmetic import ARITHMETICS
from programs.constants import Constant, arguments
from programs.parts import PARTS, Part
from programs.units import THOUSANDTHS
from tapes import ascii, eia
from tapes.errors import WorkError, naming
from tapes.nominal import Nominal
from tapes.text import lines_of

_MINUS = re.compile(r"-[^-oh]")
_SETTINGS = {"max_content_width": 100}


class _Program(Command):
    """A part program, whose expression may begin with a minus."""

    def parse_args(self, ctx: click.Context, args: list[str]) -> list[str]:
        """Put a space before a minus that begins neither an option nor the value of one."""
        if any(isinstance(param, click.Argument) for param in self.params):
            flags = [
                name
                for param in self.get_params(ctx)
                if getattr(param, "is_flag", False)
                for name in param.opts
            ]
            valued = [
                (each.startswith("--") and "=" not in each and each not in flags) or each == "-o"
                for each in ("", *args)
            ]
            args = [
                f" {each}" if _MINUS.match(each) and not valued[at] else each for at, each in enumerate(args)
            ]
        return super().parse_args(ctx, args)


class _Parts(Group):
    """A command for each part program, which is imported when it is called."""

    def list_commands(self, ctx: click.Context) -> list[str]:
        return [*PARTS, *super().list_commands(ctx)]

    def get_command(self, ctx: click.Context, cmd_name: str) -> click.Command | None:
        return _command(PARTS[cmd_name]) if cmd_name in PARTS else super().get_command(ctx, cmd_name)

    def lines(self, ctx: click.Context) -> list[tuple[str, str]]:
        own = [(name, f"{made.short_help}") for name, made in self.commands.items()]
        parts = [name for name in self.list_commands(ctx) if name in PARTS]
        return [*((name, PARTS[name].summary.split(". ")[0]) for name in parts), *own]


@click.group(cls=_Parts, context_settings=_SETTINGS)
def part() -> None:
    """Run a part program: an ASCII tape of blocks, ready for the translation.

    Every length at a command is in inches; a listing counts the same in thousandths.

    \b
    Examples:
      pdp8 part circle > circle.asc
      pdp8 part ellipse --arithmetic ge635 -o ellipse.asc
      pdp8 part compare ellipse
    """


_PROVED = ("circle", "ellipse", "slope", "die")
_FEWEST = Option(
    ["--fewest"],
    needs="--technique=piece",
    only="--technique -o",
    is_flag=True,
    help="The fewest blocks there can be with feed codes 01 to 05, feeds 20 % wrong: an exact search.",
)


_MM = Option(["--mm"], is_flag=True, help="The points of the file are millimetres.")


def _command(part: Part) -> click.Command:
    program = part.program()

    def punch(*, output: str, fewest: bool = False, mm: bool = False, **values: Any) -> None:
        source = values.get("expression", "")
        if fewest:
            text = eia.decode(shelf.read_bundled(f"{part.name}-fewest.eia"))
        elif part.file:
            text, values = _from_file(part, values, mm)
        else:
            text = _from_expression(program, values, source)
        command.put(output, ascii.encode(text))
        is_file = output != "-" and os.path.isfile(output)
        if is_file and (nominal := part.nominal(arguments(program, values))):
            _put_beside(output, nominal._replace(source=f"pdp8 part {part.name} {source}".strip()), text)

    made = _Program(
        part.name,
        callback=punch,
        params=part_options.parameters(program, bool(part.file))
        + [_FEWEST] * (part.name in _PROVED)
        + [_MM] * bool(part.file),
        help="\n".join(
            [
                f"{part.summary} Lengths are inches. {part_options.explained(program)}".strip()
                + f" It may also be {part.file}." * bool(part.file),
                "\n\b\nExamples:",
                *(f"  pdp8 part {part.name} {example}" for example in part.examples),
            ]
        ),
        context_settings=_SETTINGS,
    )
    return output(Target("tape"))(made)


def _from_expression(program: Callable[..., str], values: dict[str, Any], source: str) -> str:
    try:
        return program(**arguments(program, values))
    except WorkError as error:
        if not (source and shelf.has(source)):
            raise
        raise WorkError(f"{error}; `pdp8 part fit {source}` makes one of a file's points") from error


def _put_beside(tape: str, nominal: Nominal, text: str) -> None:
    """Write the nominal curve beside a tape for `pdp8 nc`, but replace no other file."""
    name = companion.beside(tape)
    if os.path.exists(name) and command.keeps(click.get_current_context()):
        command.say(f"{name} is there already, and is kept for --no-clobber")
        return
    if os.path.exists(name) and not _is_ours(name):
        command.say(f"{name} is there, and is no nominal curve: it is kept, and `pdp8 nc` needs --profile")
        return
    command.put(name, companion.written(nominal, text))


def _is_ours(name: str) -> bool:
    """Whether a file is a nominal curve, which may be replaced, by its first 1,000 characters."""
    if not os.path.isfile(name):
        return False
    with open(name, encoding="utf-8", errors="replace") as file:
        return companion.is_one(file.read(1000))


def _from_file(part: Part, values: dict[str, Any], mm: bool) -> tuple[str, dict[str, Any]]:
    """Return the printout for an expression, or a file of points that it names, and the values used."""
    program, given = part.program(), values["expression"]
    if given == "-" or shelf.is_name(given):
        lines = (f"{x!r},{y!r}\n" for x, y in _points(given, mm))
        with naming(given):
            values = values | {"expression": "".join(lines)}
            return program(**arguments(program, values)), values
    if mm:
        raise click.UsageError("--mm is for a file of points, and an expression is in inches.")
    return program(**arguments(program, values)), values


def _points(name: str, mm: bool) -> list[tuple[float, float]]:
    """Return the points of a file, inches, and say what was skipped or assumed."""
    from programs import table

    content = shelf.read(name, wide=True)
    with naming(name):
        found = table.read(content, mm)
    command.say_of(name, found.notes)
    return found.places


_ARITHMETIC = click.Choice(list(ARITHMETICS))
_COMPARED = ("circle", "ellipse", "polynomial", "die")
"""The parts that can be run in another arithmetic."""


@part.command(short_help="A part in two arithmetics, side by side.")
@click.argument("name", type=click.Choice(_COMPARED), metavar="PART")
@option("--arithmetic", "The one.", _ARITHMETIC, default="exact")
@option("--with other", "The other.", _ARITHMETIC, default="ge635")
def compare(name: str, arithmetic: str, other: str) -> None:
    """Run PART, one of circle, ellipse, polynomial and die, in two arithmetics; show the blocks that differ.

    \b
    Examples:
      pdp8 part compare ellipse
      pdp8 part compare ellipse --arithmetic ge635 --with cdc6400
    """
    program = PARTS[name].program()
    one, two = (lines_of(program(arithmetic=ARITHMETICS[each])) for each in (arithmetic, other))
    command.echo(f"block  {arithmetic:19}  {other:19}")
    differing = 0
    for number, (left, right) in enumerate(zip_longest(one, two, fillvalue="-"), 1):
        if left != right:
            differing += 1
            command.echo(f"{number:5}  {left:19}  {right:19}")
    command.echo(f"{name}: {len(one)} blocks {arithmetic}, {len(two)} {other}, {differing} differ")


@part.command(short_help="A function from measured points.")
@click.argument("points", type=Source(), metavar="[POINTS]", default="-")
@option("--degree", "Of the polynomial.", click.IntRange(0), metavar="NUMBER", default=3)
@flag("--mm", "The points are millimetres; the polynomial is for inches.")
def fit(points: str, degree: int, mm: bool) -> None:
    """Reduce measured points to a polynomial by least squares, for `pdp8 part curve`.

    POINTS is a file with x and y of a point on each line, as a spreadsheet or CAD program writes it. The
    polynomial goes to standard output, its greatest distance from a point to standard error.

    \b
    Examples:
      pdp8 part fit points.txt --degree 3
      pdp8 part curve "$(pdp8 part fit points.txt)" --to 4 -o curve.asc
    """
    from programs import least_squares

    places = _points(points, mm)
    with naming(points):
        found = least_squares.fit(places, degree)
    command.echo(found.expression)
    command.tell(f"at most {found.worst:.4f} in from a point")


@part.command(short_help="The mirror image of a part.")
@click.argument("tape", type=Source(), metavar="[FILE.asc]", default="-")
@option("--across", "The axis to reflect.", click.Choice(["x", "y"]), default="x")
@option(
    "--about",
    "Where the mirror is; the middle of the part by default.",
    part_options.Typed(Constant("about", "", unit=THOUSANDTHS)),
    metavar="INCHES",
)
@output(Target("tape"))
def mirror(tape: str, across: Literal["x", "y"], about: float | None, output: str) -> None:
    """Mirror a part: the same blocks, X or Y reflected (Appendix A). FILE.asc is the tape of a part program.

    \b
    Examples:
      pdp8 part slope | pdp8 part mirror > other.asc
      pdp8 part mirror part.asc --across y --about 5 -o other.asc
    """
    from programs.mirror import mirrored
    from tapes import codes
    from tapes.convert import convert

    content = shelf.read(tape)
    with naming(tape):
        text = convert(content, codes.recognise(content).name, "text").decode()
        other = mirrored(text, across, about)
    command.put(output, ascii.encode(other))
