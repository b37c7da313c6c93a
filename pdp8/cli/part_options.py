"""The constants of a part program as the options of its command.

Constant("radius", "RAD: ...", 1750, THOUSANDTHS)     --radius INCHES, its help and default, 1.75
Constant("expression", "y as a function of x")        EXPRESSION, an argument
"""

from collections.abc import Callable
from typing import Any

import click

from pdp8.cli.shared.arguments import Source
from pdp8.cli.shared.rules import Option
from programs.constants import REQUIRED, Constant, constants


class Typed(click.ParamType[Any]):
    """The type of a constant on the command line; values are converted to the program's unit."""

    def __init__(self, constant: Constant) -> None:
        self.name = "X,Y ..." if constant.places else constant.unit.metavar if constant.unit else "TEXT"
        self.constant = constant

    def convert(self, value: str, param: click.Parameter | None, ctx: click.Context | None) -> Any:
        try:
            return self.constant.keep(value)
        except ValueError as error:
            self.fail(f"{error}.", param, ctx)


def parameters(program: Callable[..., str], file: bool = False) -> list[click.Parameter]:
    """Return the click parameters of `program`, in the order of its signature; an argument may be a file."""
    return [_parameter(constant, file) for constant in constants(program) if constant.meaning]


def explained(program: Callable[..., str]) -> str:
    """Return a sentence for each argument of `program`, such as "EXPRESSION is y as a function of x"."""
    return " ".join(
        f"{constant.name.upper()} is {constant.meaning}."
        for constant in constants(program)
        if constant.default is REQUIRED
    )


def _parameter(constant: Constant, file: bool) -> click.Parameter:
    if constant.default is REQUIRED:
        taken = Source() if file else str
        return click.Argument([constant.name], type=taken, callback=lambda _, __, given: given.strip())
    names = [f"--{constant.spelling}", constant.name]
    needs, excludes = (
        " ".join(f"--{word}" for word in words.split()) for words in (constant.needs, constant.excludes)
    )
    if constant.flag:
        return Option(names, needs, excludes, is_flag=True, default=constant.default, help=constant.sentence)
    kind = click.Choice(constant.choices) if constant.choices else Typed(constant)
    return Option(
        names,
        needs,
        excludes,
        type=kind,
        default=constant.ask(constant.default),
        show_default=constant.default is not None,
        metavar=None if constant.choices else kind.name,
        help=constant.sentence,
    )
