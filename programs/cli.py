"""`pdp8 part`: the part programs, each a command whose options are its constants."""

from importlib import import_module
from inspect import signature
from itertools import zip_longest
from typing import Any

import click

from programs import options
from programs.arithmetic import ARITHMETICS
from programs.options import Part
from tapes import ascii, frames, shelf

_PARTS = {
    "circle": (
        "The 4 in circle of Appendix C. Lengths are thousandths of an inch.",
        ["> circle.asc", "--radius 1000 --tolerance 3", "--spindle 35 -o fast.asc"],
    ),
    "ellipse": (
        "The 6 x 4 1/2 in ellipse of Appendix D. Lengths are thousandths of an inch.",
        ["> ellipse.asc", "--arithmetic ge635", "--minor 1500 --technique piece"],
    ),
    "polynomial": (
        "The third degree polynomial of Chapters 6 and 7. Lengths are inches.",
        ["> polynomial.asc", "--b 1.5 --c 5 --to 5", "--cutter 0.5 --side above --technique piece"],
    ),
    "slope": (
        "A slope, Chapter 3's by default: 30 degrees, 5 in long. Lengths are inches.",
        ["> slope.asc", "--to-x 6 --to-y 9", "--technique piece --feed-error 0"],
    ),
    "curve": (
        "Any function of x. Lengths are inches.",
        ["'sin(x)' --to 6.283 > sine.asc", "'x**2/4' --from -2 --to 2 --tolerance 0.01 --cutter 0.5"],
    ),
    "die": (
        "The die of Chapter 7: ellipses of three sets of axes. Lengths are thousandths of an inch.",
        ["> opening.asc", "--cut groove", "--technique piece --fastest 8"],
    ),
    "drill": (
        "The four-hole tape of Chapter 3, or other holes. Lengths are inches.",
        ["> holes.asc", "--holes '1,1 2.5,1 4,1' --z-depth 3.25"],
    ),
    "fluidic": (
        "The fluidic element of Chapter 8, its outline ours. Lengths are inches.",
        ["> element.asc", "--program control --control 0.8", "--tolerance 0.005"],
    ),
}
"""Every part: what it is, and the options of examples of it."""

_SETTINGS = {"help_option_names": ["-h", "--help"], "max_content_width": 100}

_TAPE_OPTIONS: list[click.Parameter] = [
    click.Option(
        ["--fill"],
        type=click.IntRange(0, 1000),
        default=6,
        show_default=True,
        help="RUBOUTs after each line.",
    ),
    click.Option(
        ["--parity"],
        type=click.Choice(list(frames.PARITIES)),
        default="mark",
        show_default=True,
        help="Channel 8.",
    ),
    click.Option(
        ["-o", "--output"], metavar="FILE", default="-", help="Where to; standard output if not given."
    ),
]


class _Parts(click.Group):
    """A command for each part program, which is imported when it is called."""

    def list_commands(self, ctx: click.Context) -> list[str]:
        return [*_PARTS, *super().list_commands(ctx)]

    def get_command(self, ctx: click.Context, cmd_name: str) -> click.Command | None:
        return _command(cmd_name) if cmd_name in _PARTS else super().get_command(ctx, cmd_name)

    def format_commands(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        parts = [(name, _PARTS[name][0].split(". ")[0]) for name in self.list_commands(ctx) if name in _PARTS]
        own = [(name, command.get_short_help_str(limit=70)) for name, command in self.commands.items()]
        with formatter.section("Commands"):
            formatter.write_dl([*parts, *own])


@click.group(cls=_Parts, context_settings=_SETTINGS)
def part() -> None:
    """Run a part program of the thesis: an ASCII tape of blocks, ready for the translation.

    \b
    Examples:
      pdp8 part circle > circle.asc
      pdp8 part ellipse --arithmetic ge635 -o ellipse.asc
      pdp8 part compare ellipse
    """


def _command(name: str) -> click.Command:
    program = _program(name)
    line, examples = _PARTS[name]

    def punch(*, fill: int, parity: str, output: str, **values: Any) -> None:
        text = program(**options.arguments(program, values))
        shelf.write(output, ascii.encode(text, parity, fill))

    return click.Command(
        name,
        callback=punch,
        params=[*options.parameters(program), *_TAPE_OPTIONS],
        help=_help(line, [f"pdp8 part {name} {example}".rstrip() for example in examples]),
        context_settings=_SETTINGS,
    )


class _Compared(_Parts):
    """A command for each part program that can be run in another arithmetic."""

    def list_commands(self, ctx: click.Context) -> list[str]:
        return [name for name in _PARTS if "arithmetic" in signature(_program(name)).parameters]

    def get_command(self, ctx: click.Context, cmd_name: str) -> click.Command | None:
        return _comparison(cmd_name) if cmd_name in self.list_commands(ctx) else None


@part.group(cls=_Compared, short_help="A part in two arithmetics, side by side", context_settings=_SETTINGS)
def compare() -> None:
    """Run a part program in two arithmetics and show the blocks that differ, side by side.

    \b
    Examples:
      pdp8 part compare ellipse
      pdp8 part compare ellipse --arithmetic ge635 --with cdc6400
      pdp8 part compare circle --radius 3000 --with ieee32
    """


def _comparison(name: str) -> click.Command:
    program = _program(name)

    def show(*, other: str, **values: Any) -> None:
        first, second = values["arithmetic"], other
        one = program(**options.arguments(program, values)).splitlines()
        two = program(**options.arguments(program, {**values, "arithmetic": other})).splitlines()
        click.echo(f"block  {first:19}  {second:19}")
        differing = 0
        for number, (left, right) in enumerate(zip_longest(one, two, fillvalue="-"), 1):
            if left != right:
                differing += 1
                click.echo(f"{number:5}  {left:19}  {right:19}")
        click.echo(f"{name}: {len(one)} blocks {first}, {len(two)} {second}, {differing} differ")

    other = click.Option(
        ["--with", "other"],
        type=click.Choice(list(ARITHMETICS)),
        default="ge635",
        show_default=True,
        help="The arithmetic to compare with.",
    )
    examples = [f"pdp8 part compare {name}", f"pdp8 part compare {name} --with cdc6400"]
    return click.Command(
        name,
        callback=show,
        params=[other, *options.parameters(program)],
        help=_help(f"The blocks of {name} that differ between two arithmetics.", examples),
        context_settings=_SETTINGS,
    )


def _program(name: str) -> Part:
    found: Part = import_module(f"programs.{name}").part
    return found


def _help(line: str, examples: list[str]) -> str:
    return "\n".join([line, "", "\b", "Examples:", *(f"  {example}" for example in examples)])
