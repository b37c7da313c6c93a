"""A part program's keyword parameters as options of its command: declared once, in its signature.

signature                                                  command
radius: Annotated[int, "RAD: ...", THOUSANDTHS] = 1750     --radius INCHES, its help and default, 1.75
expression: Annotated[str, "..."]                          EXPRESSION, an argument
header: Header = THESIS                                    an option for each field, its default from THESIS
milling: Milling = Milling()                               the same
arithmetic: Arithmetic                                     --arithmetic, by name

A number has a unit, the second note of its annotation: units.py says what the command asks for.
"""

import inspect
import types
from collections.abc import Iterator, Mapping
from dataclasses import fields, is_dataclass, replace
from typing import Any, Literal, get_args, get_origin, get_type_hints

import click

from programs.arithmetic import ARITHMETICS, Arithmetic
from programs.drill import Holes, places
from programs.program import PartProgram
from programs.units import Unit, UnitError


def parameters(part: PartProgram) -> list[click.Parameter]:
    """Return the click parameters of `part`, in the order of its signature."""
    hints = get_type_hints(part, include_extras=True)
    found: list[click.Parameter] = []
    for name, parameter in inspect.signature(part).parameters.items():
        if is_dataclass(hints[name]):
            found += _options(parameter.default)
        elif hints[name] is Arithmetic:
            choice = click.Choice(list(ARITHMETICS))
            found.append(_named("arithmetic", choice, "exact", "The arithmetic of which machine."))
        else:
            found.append(_option(name, hints[name], parameter.default))
    return found


def explained(part: PartProgram) -> str:
    """Return what the arguments of `part` are, a sentence each: "EXPRESSION is y as a function of x"."""
    hints = get_type_hints(part, include_extras=True)
    positional = [
        name
        for name, parameter in inspect.signature(part).parameters.items()
        if parameter.default is inspect.Parameter.empty
    ]
    return " ".join(f"{name.upper()} is {get_args(hints[name])[1]}." for name in positional)


def arguments(part: PartProgram, values: Mapping[str, Any]) -> dict[str, Any]:
    """Return the keywords to call `part` with, for the `values` of its parameters, all or some."""
    keywords: dict[str, Any] = {}
    for name, parameter in inspect.signature(part).parameters.items():
        if is_dataclass(parameter.default) and not isinstance(parameter.default, type):
            own = values.keys() & {field.name for field in fields(parameter.default)}
            keywords[name] = replace(parameter.default, **{each: values[each] for each in own})
        elif name in values:
            keywords[name] = ARITHMETICS[values[name]] if name == "arithmetic" else values[name]
    return keywords


def taken(part: PartProgram, constants: Mapping[str, Any]) -> dict[str, Any]:
    """Return the keywords to call `part` with, for `constants` in the units of its command.

    Raises ValueError for one that it has not, and for a value that its command does not take.
    """
    known = {f"{parameter.name}": parameter for parameter in parameters(part)}
    values = {}
    for name, value in constants.items():
        if name not in known:
            raise ValueError(f"no constant {name!r}; there are {', '.join(known)}")
        try:
            values[name] = known[name].type(_typed(value), known[name])
        except click.UsageError as error:
            raise ValueError(f"{name}: {error.message}") from error
    return arguments(part, values)


def _typed(value: object) -> object:
    """Return a value of a script as it would be typed; a flag, and None, as it is."""
    if isinstance(value, tuple | list):
        return " ".join(f"{x},{y}" for x, y in value)
    return value if isinstance(value, bool | None) else str(value)


def _options(default: Any) -> Iterator[click.Parameter]:
    """Yield an option for each field of a dataclass, with the values of `default`."""
    hints = get_type_hints(type(default), include_extras=True)
    for field in fields(default):
        yield _option(field.name, hints[field.name], getattr(default, field.name))


def _option(name: str, hint: Any, default: Any) -> click.Parameter:
    kind, help_line, *unit = get_args(hint)
    help_line = f"{help_line[0].upper()}{help_line[1:]}."
    if kind is bool:
        return click.Option([f"--{name}"], is_flag=True, default=default, help=help_line)
    if default is inspect.Parameter.empty:
        return click.Argument([name], type=kind)
    return _named(name, _type(kind, *unit), default, help_line)


def _named(name: str, kind: click.ParamType[Any], default: Any, help_line: str) -> click.Option:
    spelling = "--" + name.strip("_").replace("_", "-")
    if default is not None and isinstance(kind, Number | Places):
        default = kind.written(default)
    return click.Option(
        [spelling, name],
        type=kind,
        default=default,
        show_default=default is not None,
        metavar=None if isinstance(kind, click.Choice) else kind.name,
        help=help_line,
    )


def _type(hint: Any, unit: Unit | None = None) -> click.ParamType[Any]:
    if get_origin(hint) is Literal:
        return click.Choice(list(get_args(hint)))
    if hint == Holes:
        return Places()
    kinds = get_args(hint) if get_origin(hint) is types.UnionType else (hint,)
    assert unit is not None, "a number has a unit"
    return Number(unit, whole=int in kinds)


class Number(click.ParamType[float]):
    """A number in the unit that a command asks for; its value is as the part program keeps it."""

    def __init__(self, unit: Unit, whole: bool = False) -> None:
        self.name = unit.metavar
        self.unit = unit
        self.whole = whole

    def written(self, kept: float) -> str:
        """Return what to write for the value `kept`."""
        return self.unit.ask(kept)

    def convert(self, value: str, param: click.Parameter | None, ctx: click.Context | None) -> float:
        try:
            number = self.unit.keep(value, self.whole)
        except UnitError as error:
            self.fail(f"{error}.", param, ctx)
        return int(number) if self.whole else number


class Places(click.ParamType[Holes]):
    """Places on the table, "1,1 1,2 4,2": X and Y of each, inches, with a comma between."""

    name = "X,Y ..."

    def written(self, kept: Holes) -> str:
        """Return what to write for the places `kept`."""
        return " ".join(f"{x:g},{y:g}" for x, y in kept)

    def convert(self, value: str, param: click.Parameter | None, ctx: click.Context | None) -> Holes:
        try:
            return places(value)
        except UnitError as error:
            self.fail(f"{error}.", param, ctx)
