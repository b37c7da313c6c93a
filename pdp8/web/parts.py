"""The part programs as a page asks for them: the options of `pdp8 part`, ready for JSON.

An option has its name, help and default as they are written, and what it takes: `choices`, `unit` (the fields
of programs.units.Unit), `flag`, or `places`; `required` if there is no part without it. An argument of the
program is an option, or a record of several.
"""

from dataclasses import is_dataclass
from typing import Any, get_type_hints

import click

from programs import options
from programs.parts import PARTS, Part

_OURS = "arithmetic"
"""The arithmetic of 1971's machines stays with the command: a page computes exactly."""


def declared() -> list[dict[str, Any]]:
    """Return the parts that a page runs."""
    return [_declared(part) for part in PARTS.values()]


def _declared(part: Part) -> dict[str, Any]:
    program = part.program()
    asked = [option for option in options.parameters(program) if option.name != _OURS]
    arguments = [
        [name, hint.__name__, list(get_type_hints(hint))]
        if isinstance(hint, type) and is_dataclass(hint)
        else [name]
        for name, hint in get_type_hints(program).items()
        if name != "return"
    ]
    return {
        "name": part.name, "summary": part.summary, "arguments": arguments,
        "cutter": part.cutter, "options": list(map(_option, asked)),
    }  # fmt: skip


def _option(option: click.Parameter) -> dict[str, Any]:
    found: dict[str, Any] = {"name": option.name, "required": option.required}
    if isinstance(option, click.Option):
        found |= {
            "default": option.default,
            "help": option.help,
            "spelling": option.opts[0].removeprefix("--"),
            "flag": option.is_flag,
        }
    match option.type:
        case click.Choice(choices=choices):
            found["choices"] = list(choices)
        case options.Number(unit=unit, whole=whole):
            found |= {"unit": list(unit), "whole": whole}
        case options.Places():
            found["places"] = True
    return {key: value for key, value in found.items() if isinstance(value, str | list) or value}
