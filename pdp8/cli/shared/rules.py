"""An option that was given has an effect or is refused: its declaration says what it needs and excludes.

    flag("--cycles", "...", needs="--trace")              means nothing without --trace
    option("--fill", "...", int, needs="--to=ascii")      means nothing unless --to is ascii
    flag("--boot", "...", excludes="--restore")           does not go with --restore
    flag("--prove", "...", only="EXERCISE --cpu")         goes with these only; only="", with nothing
    flag("--where", "...", writes=True)                   writes files that it names itself

Blanks separate names; one of those that an option `needs` is enough. An argument's name is in capitals; `=`
asks for a value in force, given or by default. `Command` refuses what a declaration forbids before it opens a
file, with status 2; what depends on the tape that is read is checked by the command itself.

`declared` hands a command its options as dataclasses, whose fields declare them:

    @dataclass(frozen=True)
    class Feeding:
        strict: bool = of(flag("--strict", "..."))
"""

import dataclasses
from collections.abc import Callable, Iterable, Sequence
from dataclasses import fields, is_dataclass
from functools import wraps
from inspect import signature
from typing import Any, TypeVar

import click
from click.core import ParameterSource

_Function = TypeVar("_Function", bound=Callable[..., Any])
_ADD = "adds"


class Option(click.Option):
    """An option with the options that it needs, excludes, or may only be combined with."""

    def __init__(
        self,
        declarations: Sequence[str],
        needs: str = "",
        excludes: str = "",
        only: str | None = None,
        writes: bool = False,
        **settings: Any,
    ) -> None:
        super().__init__(declarations, **settings)
        self.needs, self.excludes, self.only, self.writes = needs, excludes, only, writes


def option(names: str, help: str, type: Any = None, **settings: Any) -> Callable[[_Function], _Function]:
    """Return the decorator that adds an option, whose help shows its default.

    `names` are separated by blanks; `settings` are those of click, and of `Option`.
    """
    settings.setdefault("show_default", settings.get("default") not in (None, "") and "[default:" not in help)
    return click.option(*names.split(), cls=Option, help=help, type=type, **settings)


def flag(names: str, help: str, **settings: Any) -> Callable[[_Function], _Function]:
    """Return the decorator that adds an option without a value."""
    return option(names, help, is_flag=True, **settings)


def of(add: Callable[[_Function], _Function]) -> Any:
    """Return a field of a dataclass that `declared` makes an option or argument by the decorator `add`."""
    return dataclasses.field(metadata={_ADD: add})


def field(names: str, help: str, type: Any = None, **settings: Any) -> Any:
    """Return the field of a dataclass for an option, as `option` takes it."""
    return of(option(names, help, type, **settings))


def declared(function: Callable[..., Any]) -> Callable[..., Any]:
    """Return `function` with the options of each parameter that is annotated with a dataclass."""
    groups = {
        name: parameter.annotation
        for name, parameter in signature(function).parameters.items()
        if isinstance(parameter.annotation, type) and is_dataclass(parameter.annotation)
    }

    @wraps(function)
    def call(*arguments: Any, **given: Any) -> Any:
        made = {
            name: group(**{each.name: given.pop(each.name) for each in fields(group)})
            for name, group in groups.items()
        }
        return function(*arguments, **made, **given)

    added: Callable[..., Any] = call
    for group in reversed(groups.values()):
        for each in reversed(fields(group)):
            added = each.metadata[_ADD](added)
    return added


def check(ctx: click.Context) -> None:
    """Raise a UsageError for a given option that its declaration forbids in this call."""
    params = ctx.command.get_params(ctx)
    known = {word: param for param in params for word in words(param)}
    given = [param for param in params if is_given(ctx, param)]

    def holds(word: str) -> bool:
        name, valued, value = word.partition("=")
        if not valued:
            return known[name] in given
        return str(ctx.params[known[name].name or ""]) == value

    for param in given:
        name = words(param)[0]
        needed = getattr(param, "needs", "").split()
        if needed and not any(map(holds, needed)):
            raise click.UsageError(f"{name} means nothing without {_told(needed, 'or')}.")
        barred = [word for word in getattr(param, "excludes", "").split() if holds(word)]
        if barred:
            raise click.UsageError(f"{name} does not go with {_told(barred, 'or')}.")
        only = getattr(param, "only", None)
        if only is not None:
            fitting = [param, known.get("--no-clobber"), *(known[word] for word in only.split())]
            beside = [words(other)[0] for other in given if other not in fitting]
            if beside:
                alone = f"with {_told(only.split(), 'and')} only" if only else "alone"
                raise click.UsageError(f"{name} is used {alone}: leave out {_told(beside, 'and')}.")


def words(param: click.Parameter) -> list[str]:
    """Return a parameter's spellings, the long one first; an argument's name in capitals."""
    if isinstance(param, click.Argument):
        return [(param.name or "").upper()]
    return sorted([*param.opts, *param.secondary_opts], key=lambda spelling: not spelling.startswith("--"))


def is_given(ctx: click.Context, param: click.Parameter) -> bool:
    """Tell whether a parameter was given on the command line."""
    source = ctx.get_parameter_source(param.name or "")
    return source is ParameterSource.COMMANDLINE and ctx.params.get(param.name or "", True) != ()


def _told(names: Iterable[str], joint: str) -> str:
    *most, last = (name.replace("=", " ") for name in names)
    return f"{', '.join(most)} {joint} {last}" if most else last
