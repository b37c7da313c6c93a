"""What the `pdp8 nc` commands take in common, and what becomes of it: a tape cut, a curve that was meant."""

from collections.abc import Callable
from math import isfinite
from typing import TYPE_CHECKING, Any

import click

from tapes import shelf
from tapes.errors import WorkError, named, naming

if TYPE_CHECKING:
    from nc.curves import Curve
    from nc.machine import CutError
    from nc.path import Path

_Decorator = Callable[[Callable[..., Any]], Callable[..., Any]]


def numbers(
    names: str, one_for_all: bool = False
) -> Callable[[click.Context, click.Parameter, str | None], tuple[float, ...] | None]:
    """Return what reads an option's numbers with commas between; one may do for all of them."""
    count = len(names.split(","))

    def read(_: click.Context, __: click.Parameter, value: str | None) -> tuple[float, ...] | None:
        if value is None:
            return None
        try:
            given = tuple(float(part) for part in value.split(","))
        except ValueError:
            given = ()
        if len(given) == 1 and one_for_all:
            return given * count
        if len(given) != count or not all(isfinite(number) for number in given):
            raise click.BadParameter(
                f"{value!r} is not {names}: numbers with commas between, {count} of them"
            )
        return given

    return read


def within(
    low: float, high: float, above: bool = False
) -> Callable[[click.Context, click.Parameter, float], float]:
    """Return what refuses a number that does not lie from low (or above it) to high; nan never does."""

    def check(_: click.Context, __: click.Parameter, value: float) -> float:
        if low <= value <= high and not (above and value == low):
            return value
        start = f"above {low:g}" if above else f"from {low:g}"
        raise click.BadParameter(f"{value:g} is not {start} to {high:g}")

    return check


def tape_options(command: Callable[..., Any]) -> Callable[..., Any]:
    """Give a command the tape and how the machine reads and runs it."""
    options: tuple[_Decorator, ...] = (
        click.argument("tape", metavar="FILE.eia", default="-"),
        click.option("--strict", is_flag=True, help="Read as later controls did: odd parity, no blank rows."),
        click.option(
            "--feed-error",
            callback=numbers("X,Y,Z", one_for_all=True),
            default="0",
            metavar="PERCENT",
            help="Feeds off by so much, within +-20; one number, or X,Y,Z.",
        ),
        click.option(
            "--feed-code",
            type=click.IntRange(1, 18),
            help="Mill at this code of Table 2.4 in place of the tape's.",
        ),
        click.option(
            "--peck",
            type=float,
            callback=within(0.001, 5),
            metavar="INCHES",
            default=0.1,
            show_default=True,
            help="How deep the drill goes between two withdrawals; no source tells.",
        ),
        click.option(
            "--tool-change",
            type=float,
            callback=within(0, 3600),
            default=0.0,
            metavar="SECONDS",
            help="What an automatic tool change takes; no source tells.",
        ),
    )
    for option in reversed(options):
        command = option(command)
    return command


def curve_options(command: Callable[..., Any]) -> Callable[..., Any]:
    """Give a command the cutter and the curve that was meant."""
    options: tuple[_Decorator, ...] = (
        click.option(
            "--circle",
            callback=numbers("X,Y,RADIUS"),
            metavar="X,Y,RADIUS",
            help="The curve meant for the cutter's centre.",
        ),
        click.option(
            "--ellipse",
            callback=numbers("X,Y,A,B"),
            metavar="X,Y,A,B",
            help="The same, with semi-axes along X and Y.",
        ),
        click.option(
            "--line",
            callback=numbers("X1,Y1,X2,Y2"),
            metavar="X1,Y1,X2,Y2",
            help="The same, from one place to another.",
        ),
        click.option(
            "--polynomial",
            callback=numbers("X,Y,A,B,C"),
            metavar="X,Y,A,B,C",
            help="The same: y = Ax(x-B)(x-C), its origin at X,Y, from x = 0 to C.",
        ),
        click.option(
            "--cutter",
            type=float,
            callback=within(0, 10, above=True),
            metavar="INCHES",
            default=0.5,
            show_default=True,
            help="Its diameter.",
        ),
        click.option(
            "--tolerance",
            type=float,
            callback=within(0, 1, above=True),
            metavar="INCHES",
            default=0.005,
            show_default=True,
            help="Half the width of the band.",
        ),
    )
    for option in reversed(options):
        command = option(command)
    return command


def cut_tape(**options: Any) -> "Path":
    """Return the path of a tape that must be good to its end. Raises WorkError."""
    path, error = cut_so_far(**options)
    if error is not None:
        raise error
    return path


def cut_so_far(
    tape: str,
    strict: bool,
    feed_error: tuple[float, float, float],
    feed_code: int | None,
    peck: float,
    tool_change: float,
    **_: Any,
) -> tuple["Path", WorkError | None]:
    """Return the path, and the error that stopped the machine if one did; raise it if nothing was done."""
    from nc import machine

    x, y, z = feed_error
    if not all(abs(error) <= 20 for error in feed_error):
        raise click.BadParameter("the machine keeps its feeds within 20 %", param_hint="--feed-error")
    frames = shelf.read(tape)
    settings = machine.Settings((x / 100, y / 100, z / 100), feed_code, tool_change, round(peck * 1000))
    with naming(tape):
        try:
            return machine.cut(frames, strict=strict, settings=settings), None
        except machine.CutError as error:
            complaint = _not_eia(frames, error) or error
            if not error.path:
                raise complaint from error
            return error.path, named(tape, complaint)


def _not_eia(frames: bytes, error: "CutError") -> WorkError | None:
    """Return the error with what the tape seems to be instead, where that is why its first block is bad."""
    from tapes import kinds

    kind = kinds.classify(frames) if error.block == 1 else kinds.EIA
    if kind not in (kinds.ASCII, kinds.BIN, kinds.RIM):
        return None
    return WorkError(f"{error}; the tape seems to be {kind.upper()}, and the machine reads EIA")


def curve(
    circle: tuple[float, ...] | None,
    ellipse: tuple[float, ...] | None,
    line: tuple[float, ...] | None,
    polynomial: tuple[float, ...] | None,
    **_: Any,
) -> "Curve | None":
    """Return the curve that was named, if one was."""
    from nc.curves import Cubic, Ellipse, Line

    if sum(given is not None for given in (circle, ellipse, line, polynomial)) > 1:
        raise click.UsageError("--circle, --ellipse, --line, --polynomial: one of them, please")
    if circle:
        x, y, radius = thousandths(circle)
        return Ellipse(x, y, radius, radius)
    if ellipse:
        return Ellipse(*thousandths(ellipse))
    if polynomial:
        return Cubic(*thousandths(polynomial[:2]), *polynomial[2:])
    return Line(*thousandths(line)) if line else None


def curve_or_followed(path: "Path", tolerance: float, **options: Any) -> "Curve | None":
    """Return the curve that was named, or else the one the path follows, or none."""
    from nc.inspection import followed

    return curve(**options) or followed(path, tolerance * 1000)


def thousandths(inches: tuple[float, ...]) -> tuple[float, ...]:
    """Return lengths given in inches as the machine's own."""
    return tuple(round(length * 1000, 6) for length in inches)
