"""The constants of a part program, read from its signature, for commands and forms.

signature                                                  constant
radius: Annotated[int, "RAD: ...", THOUSANDTHS] = 1750     radius, INCHES, by default 1.75
expression: Annotated[str, "..."]                          expression, without a default
header: Header = THESIS                                    each field of Header, with the defaults of THESIS
milling: Milling = Milling()                               the same
arithmetic: Annotated[Arithmetic, "..."]                   arithmetic, by name

A number has a unit, the second note of its annotation; units.py says what is asked for. A note without a
sentence, Annotated[int, "", CODE], makes a keyword of `part(...)` that no command offers. A text behind the
sentence names the constant, or its value, without which this one means nothing: "technique=piece", "cutter";
or, after "not", with which: "not stop=inside".
"""

import inspect
import types
from collections.abc import Callable, Mapping
from dataclasses import fields, is_dataclass, replace
from typing import Any, Literal, NamedTuple, get_args, get_origin, get_type_hints

from programs.arithmetic import ARITHMETICS, Arithmetic
from programs.drill import Holes, places
from programs.units import Unit

_NOT = "not "
REQUIRED = inspect.Parameter.empty
"""The default of a constant that has none."""


class Constant(NamedTuple):
    """A constant as one asks for it.

    `meaning` is a sentence without its full stop, or empty for one that no command offers. A number has a
    `unit`, and may have to be `whole`; a name is one of `choices`; a `flag` is set or not; `places` are X,Y
    pairs; all others are text. `default` is as the part program keeps it. It means nothing without what it
    `needs`, nor with what it `excludes`.
    """

    name: str
    meaning: str
    default: Any = REQUIRED
    unit: Unit | None = None
    whole: bool = False
    choices: tuple[str, ...] = ()
    flag: bool = False
    places: bool = False
    needs: str = ""
    excludes: str = ""

    @property
    def spelling(self) -> str:
        """The name as an option has it, without its dashes."""
        return self.name.strip("_").replace("_", "-")

    @property
    def sentence(self) -> str:
        """What it means, as a sentence of help."""
        return f"{self.meaning[0].upper()}{self.meaning[1:]}."

    def keep(self, value: str) -> Any:
        """Return the value that the part program keeps for `value` as typed. Raises ValueError."""
        if self.unit is not None:
            number = self.unit.keep(value, self.whole)
            return int(number) if self.whole else number
        if self.places:
            return places(value)
        if self.choices and value not in self.choices:
            raise ValueError(f"{value!r} is not one of {', '.join(self.choices)}")
        return value

    def ask(self, kept: Any) -> Any:
        """Return the value as a user types it, from what is `kept`; None, a flag and a name are unchanged."""
        if kept is not None and self.unit is not None:
            return self.unit.ask(kept)
        if self.places:
            return " ".join(f"{x:g},{y:g}" for x, y in kept)
        return kept


def constants(program: Callable[..., str]) -> list[Constant]:
    """Return the constants of `program`, in the order of its signature."""
    hints = get_type_hints(program, include_extras=True)
    found: list[Constant] = []
    for name, parameter in inspect.signature(program).parameters.items():
        if is_dataclass(record := parameter.default):
            own = get_type_hints(type(record), include_extras=True)
            found += [
                _constant(each.name, own[each.name], getattr(record, each.name)) for each in fields(record)
            ]
        else:
            found.append(_constant(name, hints[name], parameter.default))
    return found


def arguments(program: Callable[..., str], values: Mapping[str, Any]) -> dict[str, Any]:
    """Return the keywords to call `program` with, for some or all of its constants, as it keeps them."""
    keywords: dict[str, Any] = {}
    for name, parameter in inspect.signature(program).parameters.items():
        if is_dataclass(parameter.default) and not isinstance(parameter.default, type):
            own = values.keys() & {field.name for field in fields(parameter.default)}
            keywords[name] = replace(parameter.default, **{each: values[each] for each in own})
        elif name in values:
            keywords[name] = ARITHMETICS[values[name]] if name == "arithmetic" else values[name]
    return keywords


def taken(program: Callable[..., str], asked: Mapping[str, Any]) -> dict[str, Any]:
    """Return the keywords for `program` from constants in command units. Raises ValueError."""
    known = {constant.name: constant for constant in constants(program)}
    values = {}
    for name, value in asked.items():
        if name not in known:
            raise ValueError(f"no constant {name!r}; there are {', '.join(known)}")
        try:
            values[name] = _typed(known[name], value)
        except ValueError as error:
            raise ValueError(f"{name}: {error}") from error
    return arguments(program, values)


def _typed(constant: Constant, value: object) -> Any:
    """Return what is kept for a script's value: a number, a flag or a list of places."""
    if value is None:
        return None
    if constant.flag or isinstance(value, bool):
        if not (constant.flag and isinstance(value, bool)):
            raise ValueError(f"{value!r} is not {'True or False' if constant.flag else 'a number'}")
        return value
    if isinstance(value, tuple | list):
        return constant.keep(" ".join(f"{x},{y}" for x, y in value))
    return constant.keep(str(value))


def _constant(name: str, hint: Any, default: Any) -> Constant:
    kind, meaning, *notes = get_args(hint)
    unit = next((note for note in notes if isinstance(note, Unit)), None)
    words = [note for note in notes if isinstance(note, str)]
    constant = Constant(
        name,
        meaning,
        default,
        needs=" ".join(word for word in words if not word.startswith(_NOT)),
        excludes=" ".join(word.removeprefix(_NOT) for word in words if word.startswith(_NOT)),
    )
    if kind is Arithmetic:
        exact = next(known for known, arithmetic in ARITHMETICS.items() if arithmetic is default)
        return constant._replace(choices=tuple(ARITHMETICS), default=exact)
    if kind is bool:
        return constant._replace(flag=True)
    if get_origin(kind) is Literal:
        return constant._replace(choices=get_args(kind))
    if kind == Holes:
        return constant._replace(places=True)
    if kind is str:
        return constant
    assert unit, f"{name}: a number has a unit"
    kinds = get_args(kind) if get_origin(kind) is types.UnionType else (kind,)
    return constant._replace(unit=unit, whole=int in kinds)
