"""A part program's keyword parameters as options of its command: declared once, in its signature.

signature                                     command
radius: Annotated[int, "RAD: ..."] = 1750     --radius INTEGER, its help and default
expression: Annotated[str, "..."]             EXPRESSION, an argument
header: Header = THESIS                       an option for each field, its default from THESIS
milling: Milling = Milling()                  the same
arithmetic: Arithmetic                        --arithmetic, by name
"""

import inspect
import types
from collections.abc import Iterator, Mapping
from dataclasses import fields, is_dataclass
from enum import IntEnum
from math import isfinite
from typing import Any, Literal, get_args, get_origin, get_type_hints

import click

from programs.arithmetic import ARITHMETICS, Arithmetic
from programs.drill import Holes
from programs.parts import PartProgram


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


def arguments(part: PartProgram, values: Mapping[str, Any]) -> dict[str, Any]:
    """Return the keywords to call `part` with, for the `values` that click has of its parameters."""
    hints = get_type_hints(part)
    keywords = {name: values[name] for name in hints if name in values}
    for name, hint in hints.items():
        if is_dataclass(hint) and isinstance(hint, type):
            keywords[name] = hint(**{field.name: values[field.name] for field in fields(hint)})
    if "arithmetic" in hints:
        keywords["arithmetic"] = ARITHMETICS[values["arithmetic"]]
    return keywords


def _options(default: Any) -> Iterator[click.Parameter]:
    """Yield an option for each field of a dataclass, with the values of `default`."""
    hints = get_type_hints(type(default), include_extras=True)
    for field in fields(default):
        yield _option(field.name, hints[field.name], getattr(default, field.name))


def _option(name: str, hint: Any, default: Any) -> click.Parameter:
    kind, help_line = get_args(hint)
    if kind is bool:
        return _flag(name, default, help_line)
    if default is inspect.Parameter.empty:
        return click.Argument([name], type=_type(kind))
    return _named(name, _type(kind), default, f"{help_line[0].upper()}{help_line[1:]}.")


def _flag(name: str, default: bool, help_line: str) -> click.Option:
    help_line = f"{help_line[0].upper()}{help_line[1:]}."
    return click.Option([f"--{name}"], is_flag=True, default=default, help=help_line)


def _named(name: str, kind: Any, default: Any, help_line: str) -> click.Option:
    spelling = "--" + name.strip("_").replace("_", "-")
    default = int(default) if isinstance(default, IntEnum) else default  # as a number in the help
    shown: bool | str = default is not None
    if isinstance(kind, _Places):
        shown = " ".join(f"{x:g},{y:g}" for x, y in default)
    return click.Option([spelling, name], type=kind, default=default, show_default=shown, help=help_line)


def _type(hint: Any) -> Any:
    if get_origin(hint) is Literal:
        return click.Choice(list(get_args(hint)))
    if get_origin(hint) is types.UnionType:
        return _type(next(kind for kind in get_args(hint) if kind is not types.NoneType))
    if hint == Holes:
        return _Places()
    return _FINITE if hint is float else hint


class _Finite(click.types.FloatParamType):
    """A finite number with a decimal point."""

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> Any:
        number = super().convert(value, param, ctx)
        if not isfinite(number):
            self.fail(f"{value!r} is not a finite number.", param, ctx)
        return number


class _Places(click.ParamType[Holes]):
    """Places on the table, "1,1 1,2 4,2": X and Y of each with a comma between."""

    name = "places"

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> Holes:
        if not isinstance(value, str):
            return tuple(value)
        try:
            places = tuple((float(x), float(y)) for x, y in (place.split(",") for place in value.split()))
        except ValueError:
            self.fail(f"{value!r} is not a list of places such as '1,1 1,2 4,2'.", param, ctx)
        return places


_FINITE = _Finite()
