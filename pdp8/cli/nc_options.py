"""The options that the `pdp8 nc` commands share: the tape and the machine, the cutter and the curve."""

from collections.abc import Callable
from dataclasses import dataclass
from math import isfinite
from typing import TYPE_CHECKING, Annotated, Any, Literal

import click

from pdp8 import shelf
from pdp8.cli.shared import command
from pdp8.cli.shared.arguments import Source
from pdp8.cli.shared.rules import option
from tapes.errors import WorkError, named, naming

if TYPE_CHECKING:
    from nc.curves import Curve
    from nc.machine import Settings
    from nc.path import Path


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


@dataclass(frozen=True)
class Tape:
    """A tape, and how it is read."""

    name: Annotated[str, click.argument("name", type=Source(), metavar="[FILE.eia]", default="-")]
    strict: Annotated[
        bool,
        option(
            "--strict",
            is_flag=True,
            help="Read as later controls did: from the first end of block on, odd parity, no blank rows.",
        ),
    ]


@dataclass(frozen=True)
class Feeds:
    """How the machine feeds."""

    feed_error: Annotated[
        tuple[float, float, float],
        option(
            "--feed-error",
            callback=numbers("X,Y,Z", one_for_all=True),
            default="0",
            metavar="PERCENT",
            help="Error of the feeds, within +-20; one number, or X,Y,Z.",
        ),
    ]
    feed_code: Annotated[
        int | None,
        option(
            "--feed-code",
            type=click.IntRange(1, 18),
            metavar="CODE",
            help="Mill at this code of Table 2.4 in place of the tape's.",
        ),
    ]

    def settings(self) -> "Settings":
        """Return the settings of a machine that feeds so. Raises BadParameter."""
        from nc.machine import Settings

        for error in self.feed_error:
            if not abs(error) <= 20:
                raise click.BadParameter(f"{error:g} %: -20 to 20 is allowed", param_hint="--feed-error")
        x, y, z = self.feed_error
        return Settings((x / 100, y / 100, z / 100), self.feed_code)


@dataclass(frozen=True)
class Times:
    """What only the time of a cut depends on, seconds."""

    tool_change: Annotated[
        float,
        option(
            "--tool-change",
            type=Within(0, 3600),
            default=0.0,
            show_default=True,
            metavar="SECONDS",
            help="Time of an automatic tool change; not in the thesis.",
        ),
    ]
    read_seconds: Annotated[
        float,
        option(
            "--read-seconds",
            type=Within(0, 3600),
            default=2.0,
            show_default=True,
            metavar="SECONDS",
            help="Time to read a block; an electronic reader takes less (Chapter 10).",
        ),
    ]


@dataclass(frozen=True)
class Nominal:
    """The curve that the cutter's centre should follow, if one is named; lengths are inches."""

    circle: Annotated[
        tuple[float, ...] | None,
        option(
            "--circle",
            callback=numbers("X,Y,RADIUS"),
            metavar="X,Y,RADIUS",
            excludes="--ellipse --line --function",
            help="Nominal curve of the cutter's centre, inches.",
        ),
    ]
    ellipse: Annotated[
        tuple[float, ...] | None,
        option(
            "--ellipse",
            callback=numbers("X,Y,A,B"),
            metavar="X,Y,A,B",
            excludes="--line --function",
            help="The same, with semi-axes along X and Y.",
        ),
    ]
    line: Annotated[
        tuple[float, ...] | None,
        option(
            "--line",
            callback=numbers("X1,Y1,X2,Y2"),
            metavar="X1,Y1,X2,Y2",
            excludes="--function",
            help="The same, from one place to another.",
        ),
    ]
    function: Annotated[
        str | None,
        option(
            "--function",
            metavar="EXPRESSION",
            needs="--range",
            help="The same: y as a function of x, as `pdp8 part curve` has it.",
        ),
    ]
    origin: Annotated[
        tuple[float, float],
        option(
            "--origin",
            callback=numbers("X,Y"),
            metavar="X,Y",
            default="4,5",
            show_default=True,
            needs="--function",
            help="Origin of --function on the table, inches.",
        ),
    ]
    range_: Annotated[
        tuple[float, float] | None,
        option(
            "--range",
            "range_",
            callback=numbers("FROM,TO"),
            metavar="FROM,TO",
            needs="--function",
            help="Range of x of --function, inches.",
        ),
    ]
    side: Annotated[
        Literal["above", "below"] | None,
        option(
            "--side",
            type=click.Choice(["above", "below"]),
            needs="--function",
            help="The function is the surface, and the cutter is on this side, as `pdp8 part curve` has it.",
        ),
    ]

    def curve(self, cutter: float) -> "Curve | None":
        """Return the curve of the cutter's centre, for a cutter of so many thousandths, if one is named."""
        from nc.curves import nominal

        radius = cutter / 2000

        return nominal(
            circle=self.circle,
            ellipse=self.ellipse,
            line=self.line,
            function=self.function,
            origin=self.origin,
            range_=self.range_,
            beside={None: 0.0, "above": radius, "below": -radius}[self.side],
        )

    def curve_or_followed(self, path: "Path", cutter: float, tolerance: float = 0.005) -> "Curve | None":
        """Return the curve that is named, or else the one that the path follows, or None."""
        from nc.inspection import followed

        return self.curve(cutter) or followed(path, tolerance * 1000)


PECK = option(
    "--peck",
    type=Inches(0.001, 5),
    callback=lambda _, __, inches: round(inches * 1000),
    metavar="INCHES",
    default=0.1,
    show_default=True,
    help="Depth the drill goes between two withdrawals; not in the thesis.",
)

CUTTER = option(
    "--cutter",
    type=Inches(0, 10, above=True),
    callback=lambda _, __, inches: inches * 1000,
    metavar="INCHES",
    default=0.5,
    show_default=True,
    help="Diameter of the cutter.",
)

TOLERANCE = option(
    "--tolerance",
    type=Inches(0, 1, above=True),
    metavar="INCHES",
    default=0.005,
    show_default=True,
    help="The most that a wall may be off nominal, either way; half the width of the band.",
)


def cut(tape: Tape, settings: "Settings | None" = None) -> "Path":
    """Return the path of the whole tape. Raises WorkError at its first bad block."""
    path, error = cut_so_far(tape, settings)
    if error is not None:
        raise error
    return path


def cut_so_far(tape: Tape, settings: "Settings | None" = None) -> tuple["Path", WorkError | None]:
    """Return the path and the error that stopped the machine, if any; raise it if the path is empty."""
    from nc import diagnosis, machine

    frames = shelf.read(tape.name)
    command.say_of(tape.name, () if tape.strict else diagnosis.notes(frames))
    with naming(tape.name):
        try:
            return machine.cut(frames, strict=tape.strict, settings=settings or machine.Settings()), None
        except machine.CutError as error:
            complaint = WorkError(diagnosis.explain(frames, error))
            if not error.path:
                raise complaint from error
            return error.path, named(tape.name, complaint)
