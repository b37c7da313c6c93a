"""The nominal curve of each part program that mills one curve, from the constants of its `part(...)`."""

from collections.abc import Callable
from types import SimpleNamespace
from typing import Any, Final

from programs.die import AXES
from programs.points import outline, read
from tapes.nominal import Kind, Nominal


def _circle(given: SimpleNamespace) -> Nominal | None:
    return None if given.outer or given.inner else _oval(given, "circle", given.radius)


def _ellipse(given: SimpleNamespace) -> Nominal | None:
    limits = given.outer_major, given.outer_minor, given.inner_major, given.inner_minor
    return None if any(limits) else _oval(given, "ellipse", given.major, given.minor)


def _die(given: SimpleNamespace) -> Nominal:
    major, minor = AXES[given.cut]
    return _oval(given, "ellipse", given.major or major, given.minor or minor)


def _oval(given: SimpleNamespace, kind: Kind, *axes: int) -> Nominal:
    numbers = (number / 1000 for number in (given.centre_x, given.centre_y, *axes))
    return _made(given, kind, *numbers, tolerance=given.tolerance / 1000)


def _slope(given: SimpleNamespace) -> Nominal:
    return _made(given, "line", given.from_x, given.from_y, given.to_x, given.to_y)


def _fluidic(given: SimpleNamespace) -> Nominal | None:
    """Return the middle of the first slope of the main program, which Chapter 8 measured."""
    if given.program == "control":
        return None
    x, y = given.axis_x, given.base_y
    return _made(given, "line", x + 0.17, y + 2.68, x + 0.59, y + 4.96)


def _curve(given: SimpleNamespace) -> Nominal:
    numbers = given.origin_x, given.origin_y, given.from_, given.to
    return _made(given, "function", *numbers, expression=given.expression)


def _polynomial(given: SimpleNamespace) -> Nominal:
    given.expression = f"{given.a:.15g}*x*(x-{given.b:.15g})*(x-{given.c:.15g})"
    return _curve(given)


def _profile(given: SimpleNamespace) -> Nominal:
    centre, text = (given.centre_x, given.centre_y), given.expression
    if "\n" not in text:
        return _made(given, "profile", *centre, expression=text)
    return _made(given, "profile", *centre, points=tuple(outline(read(text), given.tolerance)))


def _made(given: SimpleNamespace, kind: Kind, *numbers: float, **others: Any) -> Nominal:
    """Return a curve with the tolerance, and the cutter and its side where `given` has them."""
    cutter = getattr(given, "cutter", None)
    others = {"tolerance": given.tolerance, **others}
    return Nominal(kind, numbers, side=given.side if cutter else "", cutter=cutter or 0, **others)


NOMINALS: Final[dict[str, Callable[[SimpleNamespace], Nominal | None]]] = {
    "circle": _circle,
    "ellipse": _ellipse,
    "polynomial": _polynomial,
    "slope": _slope,
    "curve": _curve,
    "profile": _profile,
    "die": _die,
    "fluidic": _fluidic,
}
