"""The part programs as a page asks for them: the options of `pdp8 part` for JSON, their fields as HTML.

An option has its name, help and default as they are written, and what it takes: `choices`, `unit` (the fields
of programs.units.Unit), `flag`, or `places`; `required` if there is no part without it. An argument of the
program is an option, or a record of several.
"""

from dataclasses import is_dataclass
from html import escape
from typing import Any, get_type_hints

from pdp8.web.translator import MODULES
from programs.constants import REQUIRED, Constant, constants
from programs.parts import PARTS, Part

_OURS = "arithmetic"
"""The arithmetic of 1971's machines stays with the command: a page computes exactly."""

DRAWN = Part("drawn", "A curve drawn by hand.", ())
"""Only pages have it: the command has nothing to draw with."""


def declared() -> list[dict[str, Any]]:
    """Return the parts that a page runs: those whose program is translated."""
    translated = MODULES["programs"].split()
    return [_declared(part) for part in (*PARTS.values(), DRAWN) if part.name in translated]


def _declared(part: Part) -> dict[str, Any]:
    program = part.program()
    asked = [each for each in constants(program) if each.meaning and each.name != _OURS]
    arguments = [
        [name, hint.__name__, list(get_type_hints(hint))]
        if isinstance(hint, type) and is_dataclass(hint)
        else [name]
        for name, hint in get_type_hints(program).items()
        if name != "return"
    ]
    return {
        "name": part.name, "summary": part.summary, "arguments": arguments,
        "cutter": part.cutter, "options": list(map(_option, asked)), "form": _form(asked, arguments),
    }  # fmt: skip


def _option(constant: Constant) -> dict[str, Any]:
    found: dict[str, Any] = {
        "name": constant.name, "required": constant.default is REQUIRED, "help": constant.sentence
    }  # fmt: skip
    if constant.default is not REQUIRED:
        found |= {
            "default": constant.ask(constant.default),
            "spelling": constant.spelling,
            "flag": constant.flag,
        }
    found |= {"choices": list(constant.choices), "places": constant.places}
    if constant.unit is not None:
        found |= {"unit": list(constant.unit), "whole": constant.whole}
    return {key: value for key, value in found.items() if isinstance(value, str) or value}


def _form(asked: list[Constant], arguments: list[list[Any]]) -> str:
    """Return all options' fields; those that parts share are folded."""
    shared = {name for argument in arguments for name in argument[2:] and argument[2]}
    own, others = (
        "".join(_field(_option(each)) for each in asked if (each.name in shared) == more)
        for more in (False, True)
    )
    door = f"<details><summary>Milling and header</summary><div>{others}</div></details>"
    return own + door if others else own


def _field(option: dict[str, Any]) -> str:
    """Return the field of an option: a box, a list, or a line with its default."""
    name, default, unit = option["name"], option.get("default", ""), option.get("unit")
    about = f'name="{name}" title="{escape(option["help"])}"'
    if option.get("flag"):
        field = f'<input type="checkbox" {about}>'
    elif choices := option.get("choices"):
        given = (f"<option{' selected' * (each == default)}>{each}</option>" for each in choices)
        field = f"<select {about}>{''.join(given)}</select>"
    else:
        field = f'<input type="text" {about} placeholder="{escape(default)}" size="{8 if unit else 24}">'
    inches = "in" if unit and unit[0] == "INCHES" else ""
    return f"<label>{option.get('spelling', name).replace('-', ' ')} {field}<small>{inches}</small></label>"
