"""`pdp8 nc`: list, cut, plot, inspect and export an EIA tape at the Hydra-Point."""

from dataclasses import replace

import click
from click.core import ParameterSource

from pdp8.cli.nc_options import (
    CUTTER,
    PECK,
    TOLERANCE,
    Feeds,
    Inches,
    Nominal,
    Tape,
    Times,
    Within,
    cut_so_far,
    numbers,
)
from pdp8.cli.nc_options import cut as cut_tape
from pdp8.cli.shared import command
from pdp8.cli.shared.arguments import Group, Target, output
from pdp8.cli.shared.rules import declared, option
from tapes.errors import naming
from tapes.paper import PAPERS, sized, tiled


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
@declared
@click.option("--modes", is_flag=True, help="Add what is in force after each block, and the time.")
def list_(tape: Tape, modes: bool) -> None:
    """Print the program as a table: each block and what it does.

    \b
    Examples:
      pdp8 nc list circle.eia
      pdp8 nc list --modes --strict circle.eia
      echo 001 0 01000 01000 0 00 02 | pdp8 tape punch --code eia | pdp8 nc list
    """
    from nc.listing import lines

    path, error = cut_so_far(tape)
    command.echo("\n".join(lines(path, modes)))
    if error is not None:
        raise error


@nc.command()
@declared
@PECK
@click.option(
    "--passes",
    type=click.IntRange(1),
    metavar="NUMBER",
    default=1,
    show_default=True,
    help="How many times the tape is run.",
)
def cut(tape: Tape, feeds: Feeds, times: Times, peck: int, passes: int) -> None:
    """Cut the tape and report what was done and the time it took.

    \b
    Examples:
      pdp8 nc cut circle.eia
      pdp8 nc cut ellipse.eia --feed-code 1
      pdp8 nc cut ellipse.eia --feed-code 1 --feed-error 20
      pdp8 nc cut ellipse.eia --feed-code 1 --read-seconds 0.1 --passes 5
    """
    from nc.report import cut_report

    settings = replace(
        feeds.settings(),
        peck=peck,
        tool_change_seconds=times.tool_change,
        read_seconds=times.read_seconds,
    )
    path, error = cut_so_far(tape, settings)
    command.echo("\n".join(cut_report(path, passes)))
    if error is not None:
        raise error


@nc.command()
@declared
@CUTTER
@TOLERANCE
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
@click.option(
    "--paper",
    type=click.Choice(list(PAPERS)),
    help="Draw pages of this paper, with a ruler: print at 100 %.",
)
@output(Target("SVG"), "FILE.svg")
def plot(
    tape: Tape,
    feeds: Feeds,
    nominal: Nominal,
    cutter: float,
    tolerance: float,
    block: int | None,
    at: tuple[float, float] | None,
    zoom: float,
    paper: str | None,
    output: str,
) -> None:
    """Draw the path and the cut surface to scale as SVG.

    \b
    Examples:
      pdp8 nc plot circle.eia > circle.svg
      pdp8 nc plot circle.eia --block 120 -o circle-120.svg
      pdp8 nc plot circle.eia --at 4,6 --zoom 15 -o wall.svg
      pdp8 nc plot circle.eia --paper a4 -o pages.svg
    """
    from nc.plot import plot as drawing

    path = cut_tape(tape, feeds.settings())
    close_at = (at[0] * 1000, at[1] * 1000) if at else None
    text = drawing(
        path,
        nominal.curve_or_followed(path, cutter, tolerance),
        block=block,
        cutter=cutter,
        tolerance=tolerance * 1000,
        zoom=(zoom, zoom),
        close_at=close_at,
    )
    command.put(output, tiled(text, paper) if paper else sized(text))


@nc.command()
@declared
@CUTTER
@TOLERANCE
@click.option(
    "--talyrond", type=Target("SVG"), metavar="FILE.svg", help="Draw the polar graph of both walls."
)
@click.option("--talysurf", type=Target("SVG"), metavar="FILE.svg", help="Draw both walls laid out straight.")
@option(
    "--stretch",
    callback=numbers("FROM,TO"),
    metavar="FROM,TO",
    needs="--talysurf",
    help="Stretch of the curve for the Talysurf, in inches along it.",
)
@click.pass_context
def inspect(
    ctx: click.Context,
    /,
    tape: Tape,
    feeds: Feeds,
    nominal: Nominal,
    cutter: float,
    tolerance: float,
    talyrond: str | None,
    talysurf: str | None,
    stretch: tuple[float, float] | None,
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

    path = cut_tape(tape, feeds.settings())
    found = measure(path, nominal.curve(cutter), cutter, tolerance * 1000)
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
@declared
@PECK
@CUTTER
@option(
    "--gcode",
    is_flag=True,
    excludes="--circle --ellipse --line --function",
    help="G-code (RS-274) for today's mill: Z 0 is the top of the stock.",
)
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
@option(
    "--dxf",
    is_flag=True,
    excludes="--gcode --peck",
    help="A drawing of the path (needs ezdxf, the extra `nc`).",
)
@output(Target("text"))
def export(
    tape: Tape,
    feeds: Feeds,
    nominal: Nominal,
    peck: int,
    cutter: float,
    gcode: bool,
    safe: float,
    shift: tuple[float, float] | None,
    tool_change: bool,
    as_1971: bool,
    dxf: bool,
    output: str,
) -> None:
    """Write the path as G-code or DXF, in inches.

    \b
    Examples:
      pdp8 nc export circle.eia --gcode > circle.ngc
      pdp8 nc export circle.eia --gcode --shift=-2,-2 --safe 0.5 -o circle.ngc
      pdp8 nc export circle.eia --dxf -o circle.dxf
    """
    if not (gcode or dxf):
        raise click.UsageError("give one of --gcode and --dxf")
    path = cut_tape(tape, replace(feeds.settings(), peck=peck))
    if dxf:
        from nc.dxf import dxf as drawing

        command.put(output, drawing(path, nominal.curve_or_followed(path, cutter), cutter))
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
    with naming(tape.name):
        command.put(output, "".join(f"{line}\n" for line in lines))
