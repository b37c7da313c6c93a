"""`pdp8 nc`: list, cut, plot, inspect, export and view an EIA tape at the Hydra-Point."""

from os.path import basename
from typing import Any

import click
from click.core import ParameterSource

from pdp8 import shelf
from pdp8.cli.nc_options import (
    CURVE,
    PECK,
    TAPE,
    TIMES,
    Inches,
    Within,
    curve,
    curve_or_followed,
    cut_so_far,
    cut_tape,
    numbers,
)
from pdp8.cli.shared import command
from pdp8.cli.shared.arguments import Group, Source, Target, output
from pdp8.cli.shared.rules import option
from tapes.errors import naming


@click.group(cls=Group)
def nc() -> None:
    """The Moog Hydra-Point: list, cut, plot, inspect and export an EIA tape.

    FILE.eia is a tape of 20-row blocks, a bundled one such as circle.eia, or - for standard input. Lengths
    are inches. The machine stops before a bad block; the error names block, row and frame.

    \b
    Examples:
      pdp8 nc list circle.eia | head
      pdp8 nc cut circle.eia
      pdp8 nc plot circle.eia > circle.svg
      pdp8 nc inspect circle.eia --talyrond circle-talyrond.svg
      pdp8 nc export circle.eia --gcode > circle.ngc
    """


@nc.command("list")
@TAPE
@click.option("--modes", is_flag=True, help="Add what is in force after each block, and the time.")
def list_(modes: bool, **options: Any) -> None:
    """Print the program as a table: each block and what it does.

    \b
    Examples:
      pdp8 nc list circle.eia
      pdp8 nc list --modes --strict circle.eia
      echo 001 0 01000 01000 0 00 02 | pdp8 tape punch --code eia | pdp8 nc list
    """
    from nc.listing import lines

    path, error = cut_so_far(**options)
    command.echo("\n".join(lines(path, modes)))
    if error is not None:
        raise error


@nc.command()
@TAPE
@PECK
@TIMES
@click.option(
    "--passes",
    type=click.IntRange(1),
    metavar="NUMBER",
    default=1,
    show_default=True,
    help="How many times the tape is run.",
)
def cut(passes: int, **options: Any) -> None:
    """Cut the tape and report what was done and the time it took.

    \b
    Examples:
      pdp8 nc cut circle.eia
      pdp8 nc cut ellipse.eia --feed-code 1
      pdp8 nc cut ellipse.eia --feed-code 1 --feed-error 20
      pdp8 nc cut ellipse.eia --feed-code 1 --read-seconds 0.1 --passes 5
    """
    from nc.report import cut_report

    path, error = cut_so_far(**options)
    command.echo("\n".join(cut_report(path, passes)))
    if error is not None:
        raise error


@nc.command()
@TAPE
@CURVE
@click.option(
    "--block", type=click.IntRange(1), metavar="NUMBER", help="The current block; the last by default."
)
@click.option(
    "--at",
    callback=numbers("X,Y"),
    metavar="X,Y",
    help="Centre of the close view, inches; the current block by default.",
)
@click.option(
    "--zoom",
    type=Within(1, 1000),
    metavar="TIMES",
    default=10.0,
    show_default=True,
    help="Scale of the close view.",
)
@output(Target("SVG"), "FILE.svg")
def plot(output: str, block: int | None, at: tuple[float, float] | None, zoom: float, **options: Any) -> None:
    """Draw the path and the cut surface to scale as SVG.

    \b
    Examples:
      pdp8 nc plot circle.eia > circle.svg
      pdp8 nc plot circle.eia --block 120 -o circle-120.svg
      pdp8 nc plot circle.eia --at 4,6 --zoom 15 -o wall.svg
    """
    from nc.plot import plot as drawing

    path = cut_tape(**options)
    close_at = (at[0] * 1000, at[1] * 1000) if at else None
    text = drawing(
        path,
        curve_or_followed(path, **options),
        block=block,
        cutter=options["cutter"] * 1000,
        tolerance=options["tolerance"] * 1000,
        zoom=(zoom, zoom),
        close_at=close_at,
    )
    command.put(output, text)


@nc.command()
@TAPE
@CURVE
@click.option(
    "--talyrond", type=Target("SVG"), metavar="FILE.svg", help="Draw the polar graph of both walls."
)
@click.option("--talysurf", type=Target("SVG"), metavar="FILE.svg", help="Draw both walls laid out straight.")
@click.option(
    "--stretch",
    callback=numbers("FROM,TO"),
    metavar="FROM,TO",
    help="Stretch of the curve for the Talysurf, in inches along it.",
)
@click.pass_context
def inspect(
    ctx: click.Context,
    /,
    talyrond: str | None,
    talysurf: str | None,
    stretch: tuple[float, float] | None,
    **options: Any,
) -> None:
    """Measure the walls that the cutter left against the nominal curve.

    The default curve is the circle, ellipse or line that the milled path follows within .020 inch, or four
    times --tolerance if that is more. Errors are inches, + is outward, or to the left; a place is within 10
    degrees of an apex, 5 of 45 degrees.

    Exit status with --tolerance: 0 both walls are within it, 1 one is not, or not all of the curve is cut.

    \b
    Examples:
      pdp8 nc inspect circle.eia
      pdp8 nc inspect circle.eia --circle 4,4,1.75 --cutter 0.5 --talyrond talyrond.svg
      pdp8 nc inspect ellipse.eia --talysurf talysurf.svg --stretch 3,5
      pdp8 nc inspect sine.eia --function 'sin(x)' --range 0,6.283
    """
    from nc.inspection import inspect as measure
    from nc.report import inspection_report

    if stretch and not talysurf:
        raise click.UsageError("--stretch needs --talysurf")
    path = cut_tape(**options)
    found = measure(path, curve(**options), options["cutter"] * 1000, options["tolerance"] * 1000)
    drawings = []
    if talyrond:
        from nc.talyrond import talyrond as polar

        drawings.append((talyrond, polar(found)))
    if talysurf:
        from nc.talysurf import talysurf as trace

        part = (stretch[0] * 1000, stretch[1] * 1000) if stretch else None
        drawings.append((talysurf, trace(found, part)))
    for name, text in drawings:
        command.put(name, text)
    report = "\n".join(inspection_report(found))
    if any(name == "-" for name, _ in drawings):
        command.tell(report)
    else:
        command.echo(report)
    asked = ctx.get_parameter_source("tolerance") is ParameterSource.COMMANDLINE
    ctx.exit(1 if asked and not found.within_tolerance else 0)


@nc.command()
@TAPE
@PECK
@CURVE
@option("--gcode", is_flag=True, help="G-code (RS-274) for today's mill: Z 0 is the top of the stock.")
@option(
    "--safe",
    type=Inches(0.001, 5),
    metavar="INCHES",
    default=0.25,
    show_default=True,
    needs="--gcode",
    excludes="--as-1971",
    help="Height above the stock at which rapids go.",
)
@option(
    "--shift",
    callback=numbers("X,Y"),
    metavar="X,Y",
    needs="--gcode",
    excludes="--as-1971",
    help="Added to the tape's X and Y, inches.",
)
@option(
    "--tool-change",
    is_flag=True,
    needs="--gcode",
    excludes="--as-1971",
    help="Write tool changes and coolant, for LinuxCNC and others that have them.",
)
@option(
    "--as-1971",
    is_flag=True,
    needs="--gcode",
    excludes="--cutter",
    help="All that the machine did, parking and stops; Z 0 is the quill's top.",
)
@option("--dxf", is_flag=True, help="A drawing of the path (needs ezdxf, the extra `nc`).")
@output(Target("text"))
def export(
    gcode: bool,
    safe: float,
    shift: tuple[float, float] | None,
    tool_change: bool,
    as_1971: bool,
    dxf: bool,
    output: str,
    **options: Any,
) -> None:
    """Write the path as G-code or DXF, in inches.

    \b
    Examples:
      pdp8 nc export circle.eia --gcode > circle.ngc
      pdp8 nc export circle.eia --gcode --shift=-2,-2 --safe 0.5 -o circle.ngc
      pdp8 nc export circle.eia --dxf -o circle.dxf
    """
    if gcode == dxf:
        raise click.UsageError("give one of --gcode and --dxf")
    path = cut_tape(**options)
    cutter = options["cutter"] * 1000
    if dxf:
        from nc.dxf import dxf as drawing

        command.put(output, drawing(path, curve_or_followed(path, **options), cutter))
        return
    from nc.gcode import gcode as program
    from nc.gcode_1971 import gcode_1971

    x, y = shift or (0, 0)
    lines = (
        gcode_1971(path)
        if as_1971
        else program(
            path, cutter=cutter, safe=safe * 1000, shift=(x * 1000, y * 1000), tool_change=tool_change
        )
    )
    with naming(options["tape"]):
        command.put(output, "".join(f"{line}\n" for line in lines))


@nc.command()
@click.argument("tape", type=Source(), metavar="FILE.eia")
@output(Target("HTML"), "PAGE", None, "The page.", required=True)
def view(tape: str, output: str) -> None:
    """Write a page that cuts a tape: path, band, blocks, and where the machine refuses it.

    \b
    Examples:
      pdp8 nc view circle.eia -o circle.html
    """
    from pdp8.web.workbench import page

    command.put(output, page((basename(tape), shelf.read(tape))))
