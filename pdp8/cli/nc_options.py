"""The options that the `pdp8 nc` commands share: the tape and the machine, the cutter and the curve."""

import os
from collections.abc import Callable
from contextlib import suppress
from dataclasses import dataclass
from math import isfinite
from typing import TYPE_CHECKING, Any, TypeVar, get_args

import click

from pdp8 import companion, shelf
from pdp8.cli.shared import command
from pdp8.cli.shared.arguments import Source
from pdp8.cli.shared.frames import unspelled
from pdp8.cli.shared.rules import field, flag, of, option
from tapes.errors import TapeError, WorkError, naming
from tapes.errors import named as named_error
from tapes.nominal import SIDES, Kind, Nominal
from tapes.text import lines_of, without_mark

if TYPE_CHECKING:
    from nc.curves import Curve
    from nc.machine import Settings
    from nc.path import Path
    from nc.unit import Unit

_Function = TypeVar("_Function", bound=Callable[..., Any])


class Within(click.types.FloatParamType):
    """A number from `low` (`above`: greater than it) to `high`."""

    def __init__(self, low: float, high: float, above: bool = False) -> None:
        self.low, self.high, self.above = low, high, above

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> float:
        """Return the number."""
        number = float(super().convert(value, param, ctx))
        if self.low <= number <= self.high and not (self.above and number == self.low):
            return number
        scale, unit = self.unit(ctx)
        given, low, high = (f"{each * scale:g}" for each in (number, self.low, self.high))
        start = "above" if self.above else "from"
        self.fail(f"{given}{unit} is not {start} {low} to {high}{unit}", param, ctx)

    def unit(self, ctx: click.Context | None) -> tuple[float, str]:
        """Return how many units of a message one is, and their name."""
        return 1, ""


class Inches(Within):
    """A length, with its unit or without: in inches, or millimetres with --mm."""

    name = "inches"

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> float:
        """Return the number of inches."""
        if isinstance(value, str):
            try:
                value = _inches(value, ctx)
            except ValueError:
                self.fail(f"{value!r} is not a length, such as .005, .005in or 0.127mm", param, ctx)
        return super().convert(value, param, ctx)

    def unit(self, ctx: click.Context | None) -> tuple[float, str]:
        """Return the command's unit."""
        return (_MM, " mm") if _is_metric(ctx) else (1, " in")


_MM = 25.4


def _is_metric(ctx: click.Context | None) -> bool:
    return bool(ctx and ctx.params.get("mm"))


def _inches(text: str, ctx: click.Context | None) -> float:
    """Return a length, with its unit or in the command's, in inches. Raises ValueError."""
    unit = text.strip()[-2:]
    metric = unit == "mm" or (unit != "in" and _is_metric(ctx))
    number = float(text.strip().removesuffix(unit if unit in ("in", "mm") else ""))
    return number / _MM if metric else number


@dataclass(frozen=True)
class Metric:
    """The unit of lengths that are given and written."""

    mm: bool = of(
        flag(
            "--mm",
            "Lengths are millimetres, given and written; those of an expression stay inches.",
            is_eager=True,
        )
    )

    @property
    def unit(self) -> "Unit":
        """The unit."""
        from nc.unit import INCH, MM

        return MM if self.mm else INCH


def numbers(
    names: str, one_for_all: bool = False, inches: bool = False
) -> Callable[[click.Context, click.Parameter, str | None], tuple[float, ...] | None]:
    """Return a callback that reads numbers separated by commas; with `one_for_all` one stands for all.

    With `inches` they are lengths, with a unit or without, and returned in inches.
    """
    count = len(names.split(","))

    def read(ctx: click.Context, _: click.Parameter, value: str | None) -> tuple[float, ...] | None:
        if value is None:
            return None
        try:
            given = tuple(_inches(part, ctx) if inches else float(part) for part in value.split(","))
        except ValueError:
            given = ()
        if len(given) == 1 and one_for_all:
            return given * count
        if len(given) != count or not all(isfinite(number) for number in given):
            raise click.BadParameter(f"{value!r} is not {names}: {count} numbers separated by commas")
        return given

    return read


def lengths(name: str, names: str, meaning: str, **rules: str) -> Callable[[_Function], _Function]:
    """Return an option of lengths, `names`, separated by commas; they are kept in inches."""
    return option(name, meaning, callback=numbers(names, inches=True), metavar=names, **rules)


@dataclass(frozen=True)
class Tape:
    """A tape and its reading options."""

    name: str = of(click.argument("name", type=Source(), metavar="[FILE.eia]", default="-"))
    strict: bool = of(
        flag(
            "--strict",
            "Read as later controls did: from the first end of block on, odd parity, no blank rows.",
        )
    )


@dataclass(frozen=True)
class Feeds:
    """The machine's feeds."""

    feed_error: tuple[float, float, float] = field(
        "--feed-error",
        "Error of the feeds, within +-20; one number, or X,Y,Z.",
        callback=numbers("X,Y,Z", one_for_all=True),
        default="0",
        metavar="PERCENT",
        show_default=False,
    )
    feed_code: int | None = field(
        "--feed-code",
        "Mill at this code of Table 2.4 in place of the tape's.",
        click.IntRange(1, 18),
        metavar="CODE",
    )

    def settings(self) -> "Settings":
        """Return the machine's settings for these feeds. Raises BadParameter."""
        from nc.machine import Settings

        for error in self.feed_error:
            if not abs(error) <= 20:
                said = f"{error:g} % is not allowed: give -20 to 20"
                raise click.BadParameter(said, param_hint="--feed-error")
        x, y, z = self.feed_error
        return Settings((x / 100, y / 100, z / 100), self.feed_code)


@dataclass(frozen=True)
class Times:
    """Seconds that change only the time of a cut."""

    tool_change: float = field(
        "--tool-change",
        "Time of an automatic tool change; not in the thesis.",
        Within(0, 3600),
        default=0.0,
        metavar="SECONDS",
    )
    read_seconds: float = field(
        "--read-seconds",
        "Time to read a block; an electronic reader takes less (Chapter 10).",
        Within(0, 3600),
        default=2.0,
        metavar="SECONDS",
    )


@dataclass(frozen=True)
class Named:
    """The nominal curve, if options name one; lengths are inches."""

    circle: tuple[float, ...] | None = of(
        lengths(
            "--circle",
            "X,Y,RADIUS",
            "Nominal curve: the path of the cutter's centre, or with --side the part's surface.",
            excludes="--ellipse --line --function --profile",
        )
    )
    ellipse: tuple[float, ...] | None = of(
        lengths(
            "--ellipse",
            "X,Y,A,B",
            "The same, with semi-axes along X and Y.",
            excludes="--line --function --profile",
        )
    )
    line: tuple[float, ...] | None = of(
        lengths(
            "--line",
            "X1,Y1,X2,Y2",
            "Path of the cutter's centre, from one place to another.",
            excludes="--function --profile",
        )
    )
    function: str | None = field(
        "--function",
        "Nominal curve: y as a function of x, as `pdp8 part curve` has it.",
        metavar="EXPRESSION",
        needs="--range",
        excludes="--profile",
    )
    profile: str | None = field(
        "--profile",
        "Nominal curve, as `pdp8 part profile` has it: the radius as a function of the angle, a "
        "file of points, or the .json that was written beside a tape.",
        Source(),
        metavar="EXPRESSION|FILE",
    )
    origin: tuple[float, float] | None = of(
        lengths(
            "--origin",
            "X,Y",
            "Where x and y are 0 on the table.  [default: 4,5 in; the centre of a profile: 4,4 in]",
            needs="--function --profile",
        )
    )
    range_: tuple[float, float] | None = field(
        "--range range_",
        "Range of x of --function, inches.",
        callback=numbers("FROM,TO"),
        metavar="FROM,TO",
        needs="--function",
    )
    side = ""

    def nominal(self, mm: bool, tolerance: float | None) -> Nominal | None:
        """Return the curve that the options name, or None. Raises UsageError and WorkError."""
        places = {"line": self.line, "circle": self.circle, "ellipse": self.ellipse}
        kind: Kind
        for kind in get_args(Kind):
            numbers, expression = places.get(kind), ""
            if kind == "function" and self.function is not None:
                numbers, expression = (*(self.origin or (4, 5)), *(self.range_ or ())), self.function
            if kind == "profile" and self.profile is not None:
                numbers, expression = self.origin or (4, 4), self.profile
            if numbers is None:
                continue
            if self.side not in ("", *SIDES[kind]):
                raise click.UsageError(f"--side of a --{kind} is {' or '.join(SIDES[kind])}.")
            named = Nominal(kind, numbers, expression, side=self.side)
            named = named._replace(tolerance=tolerance or named.tolerance)
            return self._of_file(named, mm) if kind == "profile" and shelf.is_name(expression) else named
        return None

    def _of_file(self, named: Nominal, mm: bool) -> Nominal:
        """Return the curve of a file of points, or of one that `pdp8 part` wrote beside a tape."""
        from programs import points, table

        name = named.expression
        content = shelf.read(name, wide=True)
        with naming(name):
            text = without_mark(content).decode("utf-8", "replace")
            if not companion.is_one(text):
                found = table.read(content, mm)
                command.say_of(name, found.notes)
                corners = points.outline(found.places, named.tolerance)
                return named._replace(expression="", points=tuple(corners), source=name)
            if self.side or self.origin:
                raise click.UsageError(f"{name} says the side and the place: leave out --side and --origin.")
            return companion.read(text)[0]._replace(source=name)


@dataclass(frozen=True)
class Surface(Named):
    """The nominal curve, which may be the surface of the part."""

    side: str = field(
        "--side",
        "The curve is the part's surface, and the cutter is on this side of it.",
        click.Choice(["above", "below", "outside", "inside"]),
        callback=lambda _, __, side: side or "",
        needs="--function --profile --circle --ellipse",
    )


@dataclass(frozen=True)
class Cutter:
    """The cutter; None: as the nominal curve has it."""

    cutter: float | None = field(
        "--cutter",
        "Diameter of the cutter.  [default: that of the nominal curve, or 0.5]",
        Inches(0, 10, above=True),
    )


@dataclass(frozen=True)
class Cutting(Cutter):
    """The cutter and the tolerance, None to use the nominal curve's."""

    tolerance: float | None = field(
        "--tolerance",
        "The most that a wall may be off nominal, either way; half the width of the band.  "
        "[default: that of the nominal curve, or 0.005]",
        Inches(0, 1, above=True),
    )


@dataclass(frozen=True)
class Work:
    """A path with its nominal curve, if known; cutter and tolerance in thousandths."""

    path: "Path"
    curve: "Curve | None"
    cutter: float
    tolerance: float
    source: str


def work(
    tape: Tape,
    settings: "Settings",
    named: Named,
    metric: Metric,
    cutter: float | None,
    tolerance: float | None = None,
) -> Work:
    """Return the path of the whole tape with the curve from the options or from the tape's program.

    Raises WorkError, at the tape's first bad block too.
    """
    from nc.curves import curve

    path, error = cut_so_far(tape, settings)
    if error is not None:
        raise error
    nominal = named.nominal(metric.mm, tolerance) or _made_for(tape, path)
    known = nominal or Nominal("line", ())
    across = 1000 * (cutter or known.cutter)
    return Work(
        path,
        curve(nominal, across) if nominal else None,
        across,
        1000 * (tolerance or known.tolerance),
        known.source,
    )


def _made_for(tape: Tape, path: "Path") -> Nominal | None:
    """Return the curve from the file beside the tape or from its part program, if their blocks match."""
    from nc import machine
    from programs.parts import PARTS

    if tape.name == "-":
        return None
    read = [path]
    if tape.strict:  # the first block may be left out
        with suppress(TapeError):
            read.append(machine.cut(unspelled(tape.name, shelf.read(tape.name))[0]))
    digests = [companion.digest(block.digits for block in each.blocks) for each in read]
    name = companion.beside(tape.name)
    if os.path.isfile(name) and companion.is_one(text := shelf.read_text(name)):
        with naming(name):
            nominal, of = companion.read(text)
        if of in digests:
            return nominal._replace(source=f"{name}, {nominal.source}")
        command.say(f"{name} is of another tape, as its blocks differ: not used; --profile {name} uses it")
    stem = os.path.splitext(os.path.basename(tape.name))[0]
    part = PARTS.get(stem)
    if part and part.has_defaults and companion.digest(lines_of(part.program()())) in digests:
        followed = part.nominal()
        return followed and followed._replace(source=f"pdp8 part {stem}")
    return None


PECK = option(
    "--peck",
    "Depth the drill goes between two withdrawals; not in the thesis.",
    Inches(0.001, 5),
    callback=lambda _, __, inches: round(inches * 1000),
    default=0.1,
)


def cut_so_far(tape: Tape, settings: "Settings | None" = None) -> tuple["Path", WorkError | None]:
    """Return the path and the error that stopped the machine, if any; raise it if the path is empty."""
    from nc import diagnosis, machine

    frames, note = unspelled(tape.name, shelf.read(tape.name))
    command.say_of(tape.name, [*[note] * bool(note), *diagnosis.notes(frames, tape.strict)])
    with naming(tape.name):
        try:
            return machine.cut(frames, strict=tape.strict, settings=settings or machine.Settings()), None
        except machine.CutError as error:
            complaint = WorkError(diagnosis.explain(frames, error))
            if not error.path:
                raise complaint from error
            return error.path, named_error(tape.name, complaint)
