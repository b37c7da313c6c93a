"""The `pdp8 nc` commands: list, cut, plot, inspect and export an EIA tape at the Hydra-Point."""

from collections.abc import Callable
from math import isfinite
from os.path import basename, splitext
from sys import stdout
from typing import TYPE_CHECKING, Any

import click

from tapes import shelf
from tapes.errors import WorkError

if TYPE_CHECKING:
    from nc.curves import Curve
    from nc.path import Path

_Decorator = Callable[[Callable[..., Any]], Callable[..., Any]]


def _numbers(
    names: str, one_for_all: bool = False
) -> Callable[[click.Context, click.Parameter, str | None], tuple[float, ...] | None]:
    """Return what reads an option's numbers with commas between; one may do for all of them."""
    count = len(names.split(","))

    def read(_: click.Context, __: click.Parameter, value: str | None) -> tuple[float, ...] | None:
        if value is None:
            return None
        try:
            numbers = tuple(float(part) for part in value.split(","))
        except ValueError:
            numbers = ()
        if len(numbers) == 1 and one_for_all:
            return numbers * count
        if len(numbers) != count or not all(isfinite(number) for number in numbers):
            raise click.BadParameter(
                f"{value!r} is not {names}: numbers with commas between, {count} of them"
            )
        return numbers

    return read


def _within(
    low: float, high: float, above: bool = False
) -> Callable[[click.Context, click.Parameter, float], float]:
    """Return what refuses a number that does not lie from low (or above it) to high; nan never does."""

    def check(_: click.Context, __: click.Parameter, value: float) -> float:
        if low <= value <= high and not (above and value == low):
            return value
        start = f"above {low:g}" if above else f"from {low:g}"
        raise click.BadParameter(f"{value:g} is not {start} to {high:g}")

    return check


def _tape_options(command: Callable[..., Any]) -> Callable[..., Any]:
    """Give a command the tape and how the machine reads and runs it."""
    options: tuple[_Decorator, ...] = (
        click.argument("tape", metavar="FILE.eia", default="-"),
        click.option("--strict", is_flag=True, help="Read as later controls did: odd parity, no blank rows."),
        click.option(
            "--feed-error",
            callback=_numbers("X,Y,Z", one_for_all=True),
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
            callback=_within(0.001, 5),
            metavar="INCHES",
            default=0.1,
            show_default=True,
            help="How deep the drill goes between two withdrawals; no source tells.",
        ),
        click.option(
            "--tool-change",
            type=float,
            callback=_within(0, 3600),
            default=0.0,
            metavar="SECONDS",
            help="What an automatic tool change takes; no source tells.",
        ),
    )
    for option in reversed(options):
        command = option(command)
    return command


def _curve_options(command: Callable[..., Any]) -> Callable[..., Any]:
    """Give a command the cutter and the curve that was meant."""
    options: tuple[_Decorator, ...] = (
        click.option(
            "--circle",
            callback=_numbers("X,Y,RADIUS"),
            metavar="X,Y,RADIUS",
            help="The curve meant for the cutter's centre.",
        ),
        click.option(
            "--ellipse",
            callback=_numbers("X,Y,A,B"),
            metavar="X,Y,A,B",
            help="The same, with semi-axes along X and Y.",
        ),
        click.option(
            "--line",
            callback=_numbers("X1,Y1,X2,Y2"),
            metavar="X1,Y1,X2,Y2",
            help="The same, from one place to another.",
        ),
        click.option(
            "--polynomial",
            callback=_numbers("X,Y,A,B,C"),
            metavar="X,Y,A,B,C",
            help="The same: y = Ax(x-B)(x-C), its origin at X,Y, from x = 0 to C.",
        ),
        click.option(
            "--cutter",
            type=float,
            callback=_within(0, 10, above=True),
            metavar="INCHES",
            default=0.5,
            show_default=True,
            help="Its diameter.",
        ),
        click.option(
            "--tolerance",
            type=float,
            callback=_within(0, 1, above=True),
            metavar="INCHES",
            default=0.005,
            show_default=True,
            help="Half the width of the band.",
        ),
    )
    for option in reversed(options):
        command = option(command)
    return command


@click.group(context_settings={"help_option_names": ["-h", "--help"]})
def nc() -> None:
    """The Moog Hydra-Point: list, cut, plot, inspect and export an EIA tape.

    FILE.eia is a tape of 20-row blocks, a bundled one such as circle.eia, or - for standard input. Lengths
    are inches. A bad block stops the machine before any of it is done; the error names block, row and frame.

    \b
    Examples:
      pdp8 nc list circle.eia | head
      pdp8 nc cut circle.eia
      pdp8 nc plot circle.eia > circle.svg
      pdp8 nc inspect circle.eia --talyrond circle-talyrond.svg
      pdp8 nc export circle.eia --gcode > circle.ngc
    """


@nc.command("list")
@_tape_options
@click.option("--modes", is_flag=True, help="Add what is in force after each block, and the clock.")
def list_(modes: bool, **options: Any) -> None:
    """Print the program as a table: each block with what it does.

    \b
    Examples:
      pdp8 nc list circle.eia
      pdp8 nc list --modes --strict circle.eia
      echo 001 0 01000 01000 0 00 02 | pdp8 tape punch --code eia --drop-spaces | pdp8 nc list
    """
    from nc.listing import lines

    path, error = _cut_so_far(**options)
    click.echo("\n".join(lines(path, modes)))
    if error is not None:
        raise error


@nc.command()
@_tape_options
def cut(**options: Any) -> None:
    """Cut the tape and say what was done and how long it took.

    \b
    Examples:
      pdp8 nc cut circle.eia
      pdp8 nc cut ellipse.eia --feed-code 1
      pdp8 nc cut ellipse.eia --feed-code 1 --feed-error 20
    """
    from nc.report import cut_report

    path, error = _cut_so_far(**options)
    click.echo("\n".join(cut_report(path)))
    if error is not None:
        raise error


@nc.command()
@_tape_options
@_curve_options
@click.option("--block", type=click.IntRange(1), help="The current block; the last unless told.")
@click.option(
    "--at",
    callback=_numbers("X,Y"),
    metavar="X,Y",
    help="Where the close view is taken; at the current block unless told.",
)
@click.option(
    "--zoom",
    type=float,
    callback=_within(1, 1000),
    metavar="TIMES",
    default=10.0,
    show_default=True,
    help="Scale of the close view.",
)
@click.option("-o", "--output", metavar="FILE.svg", help="Where the drawing goes.")
def plot(
    output: str | None, block: int | None, at: tuple[float, float] | None, zoom: float, **options: Any
) -> None:
    """Draw the path and the cut surface to scale as SVG.

    The drawing goes to standard output, or where that is a terminal to the tape's name with .svg.

    \b
    Examples:
      pdp8 nc plot circle.eia > circle.svg
      pdp8 nc plot circle.eia --block 120 -o circle-120.svg
      pdp8 nc plot circle.eia --at 4,6 --zoom 15 -o wall.svg
    """
    from nc.plot import plot as drawing

    path = _cut(**options)
    close_at = (at[0] * 1000, at[1] * 1000) if at else None
    text = drawing(
        path,
        _curve_or_followed(path, **options),
        block=block,
        cutter=options["cutter"] * 1000,
        tolerance=options["tolerance"] * 1000,
        zoom=zoom,
        close_at=close_at,
    )
    _put(text, output or _beside(options["tape"], ".svg"))


@nc.command()
@_tape_options
@_curve_options
@click.option("--talyrond", metavar="FILE.svg", help="Draw the polar graph of both walls.")
@click.option(
    "--magnification", type=click.IntRange(1), help="Of the polar graph; 100 unless told, or what fits."
)
@click.option("--talysurf", metavar="FILE.svg", help="Draw both walls laid out straight.")
@click.option(
    "--stretch",
    callback=_numbers("FROM,TO"),
    metavar="FROM,TO",
    help="The Talysurf's part of the curve, in inches along it.",
)
def inspect(
    talyrond: str | None,
    magnification: int | None,
    talysurf: str | None,
    stretch: tuple[float, float] | None,
    **options: Any,
) -> None:
    """Measure the walls the cutter left against the curve that was meant.

    Unless told, the curve is the circle, ellipse or line that the milled path follows. Errors are inches,
    outward is +; a place is within 10 degrees of an apex, 5 of 45 degrees.

    \b
    Examples:
      pdp8 nc inspect circle.eia
      pdp8 nc inspect circle.eia --circle 4,4,1.75 --cutter 0.5 --talyrond talyrond.svg
      pdp8 nc inspect ellipse.eia --talysurf talysurf.svg --stretch 3,5
    """
    from nc.inspection import inspect as measure
    from nc.report import inspection_report

    path = _cut(**options)
    found = measure(path, _curve(**options), options["cutter"] * 1000, options["tolerance"] * 1000)
    drawings = []
    if talyrond:
        from nc.talyrond import talyrond as polar

        drawings.append((talyrond, polar(found, magnification)))
    if talysurf:
        from nc.talysurf import talysurf as trace

        part = (stretch[0] * 1000, stretch[1] * 1000) if stretch else None
        drawings.append((talysurf, trace(found, part)))
    for name, text in drawings:
        _put(text, name)
    to_standard_output = any(name == "-" for name, _ in drawings)
    click.echo("\n".join(inspection_report(found)), err=to_standard_output)


@nc.command()
@_tape_options
@_curve_options
@click.option("--gcode", is_flag=True, help="RS-274, one linear move a block, for today's controllers.")
@click.option("--dxf", is_flag=True, help="A drawing of the path (needs ezdxf: pip install 'pdp8[nc]').")
@click.option(
    "-o", "--output", metavar="FILE", default="-", help="Where it goes; standard output unless told."
)
def export(gcode: bool, dxf: bool, output: str, **options: Any) -> None:
    """Write the path as G-code or DXF, in inches.

    \b
    Examples:
      pdp8 nc export circle.eia --gcode > circle.ngc
      pdp8 nc export circle.eia --dxf -o circle.dxf
    """
    if gcode == dxf:
        raise click.UsageError("say --gcode or --dxf")
    path = _cut(**options)
    if gcode:
        from nc.gcode import gcode as program

        _put("\n".join(program(path)) + "\n", output)
        return
    from nc.dxf import dxf as drawing

    _put(drawing(path, _curve_or_followed(path, **options), options["cutter"] * 1000), output)


def _cut(**options: Any) -> "Path":
    path, error = _cut_so_far(**options)
    if error is not None:
        raise error
    return path


def _cut_so_far(
    tape: str,
    strict: bool,
    feed_error: tuple[float, float, float],
    feed_code: int | None,
    peck: float,
    tool_change: float,
    **_: Any,
) -> tuple["Path", WorkError | None]:
    """Return the path, and the error that stopped the machine if one did."""
    from nc.machine import CutError, Settings, cut

    x, y, z = feed_error
    if not all(abs(error) <= 20 for error in feed_error):
        raise click.BadParameter("the machine keeps its feeds within 20 %", param_hint="--feed-error")
    settings = Settings((x / 100, y / 100, z / 100), feed_code, tool_change, round(peck * 1000))
    try:
        return cut(shelf.read(tape), strict=strict, settings=settings), None
    except CutError as error:
        return error.path, error


def _curve(
    circle: tuple[float, ...] | None,
    ellipse: tuple[float, ...] | None,
    line: tuple[float, ...] | None,
    polynomial: tuple[float, ...] | None,
    **_: Any,
) -> "Curve | None":
    """Return the curve that was named, if one was."""
    from nc.curves import Cubic, Ellipse, Line

    if sum(curve is not None for curve in (circle, ellipse, line, polynomial)) > 1:
        raise click.UsageError("--circle, --ellipse, --line, --polynomial: one of them, please")
    if circle:
        x, y, radius = _thousandths(circle)
        return Ellipse(x, y, radius, radius)
    if ellipse:
        return Ellipse(*_thousandths(ellipse))
    if polynomial:
        return Cubic(*_thousandths(polynomial[:2]), *polynomial[2:])
    return Line(*_thousandths(line)) if line else None


def _curve_or_followed(path: "Path", tolerance: float, **options: Any) -> "Curve | None":
    """Return the curve that was named, or else the one the path follows, or none."""
    from nc.inspection import followed

    return _curve(**options) or followed(path, tolerance * 1000)


def _thousandths(inches: tuple[float, ...]) -> tuple[float, ...]:
    return tuple(round(length * 1000, 6) for length in inches)


def _beside(tape: str, suffix: str) -> str:
    """Return where a drawing goes unless told: standard output, but beside the tape if that is a terminal."""
    if tape == "-" or not stdout.isatty():
        return "-"
    return splitext(basename(tape))[0] + suffix


def _put(text: str, output: str) -> None:
    if output == "-":
        click.echo(text, nl=False)
        return
    shelf.write(output, text.encode())
    click.echo(f"wrote {output}", err=True)
