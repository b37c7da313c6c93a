"""The options that the `pdp8 nc` commands share: the tape and the machine, the cutter and the curve."""

from collections.abc import Callable
from math import isfinite
from typing import TYPE_CHECKING, Any

import click

from pdp8 import shelf
from pdp8.cli.shared.arguments import Source
from pdp8.cli.shared.rules import option
from tapes.errors import WorkError, named, naming

if TYPE_CHECKING:
    from nc.curves import Curve
    from nc.machine import CutError
    from nc.path import Path

_Decorator = Callable[[Callable[..., Any]], Callable[..., Any]]


class Within(click.types.FloatParamType):
    """A number from `low` (`above`: greater than it) to `high`."""

    def __init__(self, low: float, high: float, above: bool = False) -> None:
        self.low, self.high, self.above = low, high, above

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> float:
        """Return the number."""
        number = float(super().convert(value, param, ctx))
        if self.low <= number <= self.high and not (self.above and number == self.low):
            return number
        start = f"above {self.low:g}" if self.above else f"from {self.low:g}"
        self.fail(f"{number:g} is not {start} to {self.high:g}", param, ctx)


class Inches(Within):
    """A length in inches, with its unit or without, as `pdp8 part` takes it."""

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> float:
        """Return the number of inches."""
        try:
            number = float(value.removesuffix("in") if isinstance(value, str) else value)
        except ValueError:
            self.fail(f"{value!r} is not a length in inches, such as .005 or .005in", param, ctx)
        return super().convert(number, param, ctx)


def numbers(
    names: str, one_for_all: bool = False
) -> Callable[[click.Context, click.Parameter, str | None], tuple[float, ...] | None]:
    """Return a callback that reads numbers separated by commas; `one_for_all`: one may stand for all."""
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
            raise click.BadParameter(f"{value!r} is not {names}: {count} numbers separated by commas")
        return given

    return read


def _adding(*options: _Decorator) -> _Decorator:
    """Return the decorator that adds options to a command, in their order."""

    def add(command: Callable[..., Any]) -> Callable[..., Any]:
        for adds in reversed(options):
            command = adds(command)
        return command

    return add


TAPE = _adding(
    click.argument("tape", type=Source(), metavar="[FILE.eia]", default="-"),
    click.option("--strict", is_flag=True, help="Read as later controls did: odd parity, no blank rows."),
    click.option(
        "--feed-error",
        callback=numbers("X,Y,Z", one_for_all=True),
        default="0",
        metavar="PERCENT",
        help="Error of the feeds, within +-20; one number, or X,Y,Z.",
    ),
    click.option(
        "--feed-code",
        type=click.IntRange(1, 18),
        metavar="CODE",
        help="Mill at this code of Table 2.4 in place of the tape's.",
    ),
)
"""The tape, and how the machine reads and feeds."""

PECK = click.option(
    "--peck",
    type=Inches(0.001, 5),
    callback=lambda _, __, inches: round(inches * 1000),
    metavar="INCHES",
    default=0.1,
    show_default=True,
    help="Depth the drill goes between two withdrawals; not in the thesis.",
)

TIMES = _adding(
    click.option(
        "--tool-change",
        "tool_change_seconds",
        type=Within(0, 3600),
        default=0.0,
        show_default=True,
        metavar="SECONDS",
        help="Time of an automatic tool change; not in the thesis.",
    ),
    click.option(
        "--read-seconds",
        type=Within(0, 3600),
        default=2.0,
        show_default=True,
        metavar="SECONDS",
        help="Time to read a block; an electronic reader takes less (Chapter 10).",
    ),
)
"""What only the time of a cut depends on."""

_TIMES = ("peck", "tool_change_seconds", "read_seconds")

CURVE = _adding(
    click.option(
        "--circle",
        callback=numbers("X,Y,RADIUS"),
        metavar="X,Y,RADIUS",
        help="Nominal curve of the cutter's centre, inches.",
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
        "--function",
        metavar="EXPRESSION",
        help="The same: y as a function of x, as `pdp8 part curve` has it.",
    ),
    click.option(
        "--origin",
        callback=numbers("X,Y"),
        metavar="X,Y",
        default="4,5",
        show_default=True,
        help="Origin of --function on the table, inches.",
    ),
    click.option(
        "--range",
        "range_",
        callback=numbers("FROM,TO"),
        metavar="FROM,TO",
        help="Range of x of --function, inches.",
    ),
    option(
        "--side",
        type=click.Choice(["above", "below"]),
        needs="--function",
        help="The function is the surface, and the cutter is on this side, as `pdp8 part curve` has it.",
    ),
    click.option(
        "--cutter",
        type=Inches(0, 10, above=True),
        metavar="INCHES",
        default=0.5,
        show_default=True,
        help="Diameter of the cutter.",
    ),
    click.option(
        "--tolerance",
        type=Inches(0, 1, above=True),
        metavar="INCHES",
        default=0.005,
        show_default=True,
        help="The most that a wall may be off nominal, either way; half the width of the band.",
    ),
)
"""The nominal curve, the cutter and the band."""

_CURVES = ("circle", "ellipse", "line", "function")


def cut_tape(**options: Any) -> "Path":
    """Return the path of the whole tape. Raises WorkError at its first bad block."""
    path, error = cut_so_far(**options)
    if error is not None:
        raise error
    return path


def cut_so_far(
    tape: str,
    strict: bool,
    feed_error: tuple[float, float, float],
    feed_code: int | None,
    **options: Any,
) -> tuple["Path", WorkError | None]:
    """Return the path and the error that stopped the machine, if any; raise it if the path is empty."""
    from nc import machine

    x, y, z = feed_error
    for error in feed_error:
        if not abs(error) <= 20:
            raise click.BadParameter(f"{error:g} %: -20 to 20 is allowed", param_hint="--feed-error")
    frames = shelf.read(tape)
    times = {name: options[name] for name in _TIMES if name in options}
    settings = machine.Settings((x / 100, y / 100, z / 100), feed_code, **times)
    with naming(tape):
        try:
            return machine.cut(frames, strict=strict, settings=settings), None
        except machine.CutError as error:
            complaint = _not_eia(frames, error) or error
            if not error.path:
                raise complaint from error
            return error.path, named(tape, complaint)


def _not_eia(frames: bytes, error: "CutError") -> WorkError | None:
    """Return an error that adds the kind of the tape, if its first block is bad because it is not EIA."""
    from tapes import kinds

    kind = kinds.classify(frames) if error.block == 1 else kinds.EIA
    if kind not in (kinds.ASCII, kinds.BIN, kinds.RIM):
        return None
    cure = ""
    if kind == kinds.ASCII and kinds.ends_blocks(frames):
        cure = "; `pdp8 run eia.pal` translates it"
    elif kind == kinds.ASCII:
        cure = "; `pdp8 tape punch --code eia` punches typed blocks"
    return WorkError(f"{error}; the tape seems to be {kind.upper()}, and the machine reads EIA{cure}")


def curve(
    origin: tuple[float, ...],
    range_: tuple[float, ...] | None,
    side: str | None,
    cutter: float,
    **options: Any,
) -> "Curve | None":
    """Return the curve that is named, if one is."""
    from nc.curves import nominal

    named = {name: options[name] for name in _CURVES if options[name] is not None}
    if len(named) > 1:
        raise click.UsageError("give one of --circle, --ellipse, --line and --function")
    if ("function" in named) != (range_ is not None):
        raise click.UsageError("--function and --range go together")
    beside = {None: 0.0, "above": cutter / 2, "below": -cutter / 2}[side]
    return nominal(**named, origin=origin, range_=range_, beside=beside)


def curve_or_followed(path: "Path", tolerance: float, **options: Any) -> "Curve | None":
    """Return the curve that is named, or else the one that the path follows, or None."""
    from nc.inspection import followed

    return curve(**options) or followed(path, tolerance * 1000)
