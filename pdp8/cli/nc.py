"""`pdp8 nc`: list, cut, plot, inspect and export an EIA tape at the Hydra-Point."""

import os
from dataclasses import replace
from math import inf

import click

from pdp8.cli.nc_options import (
    PECK,
    Cutter,
    Cutting,
    Feeds,
    Inches,
    Metric,
    Named,
    Surface,
    Tape,
    Times,
    Within,
    cut_so_far,
    lengths,
    work,
)
from pdp8.cli.shared import command
from pdp8.cli.shared.arguments import Group, Target, output
from pdp8.cli.shared.rules import declared, flag, is_given, option, words
from tapes.errors import naming
from tapes.paper import PAPERS, area, sized, tiled


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
      pdp8 nc export circle.eia -o circle.ngc
    """


@nc.command("list")
@declared
@flag("--modes", "Add what is in force after each block, and the time.")
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
@option("--passes", "How many times the tape is run.", click.IntRange(1), metavar="NUMBER", default=1)
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
@option("--block", "The current block; the last by default.", click.IntRange(1), metavar="NUMBER")
@lengths("--at", "X,Y", "Centre of the close view; the current block by default.")
@option("--zoom", "Scale of the close view.", Within(1, 1000), metavar="TIMES", default=10.0)
@option("--paper", "Draw pages of this paper, with a ruler: print at 100 %.", click.Choice(list(PAPERS)))
@output(Target("SVG"), "FILE.svg")
def plot(
    tape: Tape,
    feeds: Feeds,
    metric: Metric,
    named: Surface,
    cutting: Cutting,
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
    from nc.inspection import followed
    from nc.plot import plot as drawing

    known = work(tape, feeds.settings(), named, metric, cutting.cutter, cutting.tolerance)
    close_at = (at[0] * 1000, at[1] * 1000) if at else None
    text = drawing(
        known.path,
        known.curve or followed(known.path, known.tolerance),
        block=block,
        cutter=known.cutter,
        tolerance=known.tolerance,
        zoom=(zoom, zoom),
        close_at=close_at,
        unit=metric.unit,
        high=area(paper)[1] * 100 if paper else inf,
    )
    command.put(output, tiled(text, paper) if paper else sized(text))


@nc.command()
@declared
@option("--talyrond", "Draw the polar graph of both walls.", Target("SVG"), metavar="FILE.svg")
@option("--talysurf", "Draw both walls laid out straight.", Target("SVG"), metavar="FILE.svg")
@lengths("--stretch", "FROM,TO", "Stretch of the curve for the Talysurf, along it.", needs="--talysurf")
@click.pass_context
def inspect(
    ctx: click.Context,
    /,
    tape: Tape,
    feeds: Feeds,
    metric: Metric,
    named: Surface,
    cutting: Cutting,
    talyrond: str | None,
    talysurf: str | None,
    stretch: tuple[float, float] | None,
) -> None:
    """Measure the walls that the cutter left against the nominal curve.

    The nominal curve is the one that an option names; or that of the .json which `pdp8 part -o` wrote beside
    the tape; or that of the part program of the tape's name, if its blocks are the same. Where none is known,
    the circle, ellipse or line is taken that the milled path follows: that is a guess, and gives no verdict.

    Errors are inches, + is outward, or to the left; a place is within 10 degrees of an apex, 5 of 45 degrees.
    With --side only the wall of the part is measured, without it both walls of the slot.

    Exit status with --tolerance: 0 the walls are within it, 1 one is not, or not all of the curve is cut.

    \b
    Examples:
      pdp8 nc inspect circle.eia
      pdp8 nc inspect cam.eia --profile '1.5+0.25*cos(x)' --side outside --cutter 0.25 --tolerance 0.002
      pdp8 nc inspect circle.eia --circle 4,4,1.75 --cutter 0.5 --talyrond talyrond.svg
      pdp8 nc inspect ellipse.eia --talysurf talysurf.svg --stretch 3,5
      pdp8 nc inspect sine.eia --function 'sin(x)' --range 0,6.283
    """
    from nc.inspection import inspect as measure
    from nc.report import inspection_report

    known = work(tape, feeds.settings(), named, metric, cutting.cutter, cutting.tolerance)
    found = measure(known.path, known.curve, known.cutter, known.tolerance, metric.unit)
    if cutting.tolerance is not None and found.curve.guessed:
        raise click.UsageError(
            f"--tolerance needs the nominal curve, and none is known of {tape.name}: name it by --circle, "
            "--ellipse, --line, --function or --profile. "
            f"Its path follows this: {found.curve.said(metric.unit)}."
        )
    drawings = []
    if talyrond:
        from nc.talyrond import talyrond as polar

        drawings.append((talyrond, polar(found, unit=metric.unit)))
    if talysurf:
        from nc.talysurf import talysurf as trace

        part = (stretch[0] * 1000, stretch[1] * 1000) if stretch else None
        drawings.append((talysurf, trace(found, part, unit=metric.unit)))
    for name, text in drawings:
        command.put(name, text)
    report = "\n".join(inspection_report(found, known.source, metric.unit))
    if any(name == "-" for name, _ in drawings):
        command.tell(report)
    else:
        command.echo(report)
    ctx.exit(1 if cutting.tolerance is not None and not found.within_tolerance else 0)


_FORMATS = {".dxf": "DXF"} | dict.fromkeys((".ngc", ".nc", ".gcode", ".tap", ".cnc", ".gc"), "G-code")
"""What the ending of a file's name says."""


@nc.command()
@declared
@PECK
@flag("--gcode", "G-code (RS-274) for today's mill: Z 0 is the top of the stock.")
@option(
    "--safe",
    "Height of rapid moves above the stock.  [default: 0.25]",
    Inches(0.001, 5),
    excludes="--as-1971 --dxf",
)
@lengths("--shift", "X,Y", "Added to the tape's X and Y.", excludes="--as-1971")
@option(
    "--tap",
    "Pitch of the tap, for a tape that taps and a floating tap holder; without it taps are refused.",
    Inches(0.001, 1),
    excludes="--dxf",
)
@flag(
    "--tool-change",
    "Write tool changes and coolant, for LinuxCNC and others that have them.",
    excludes="--as-1971 --dxf",
)
@flag(
    "--as-1971",
    "All that the machine did, with parking and stops; Z 0 is the quill's top.",
    excludes="--cutter --dxf",
)
@flag("--dxf", "A drawing of the path (needs ezdxf, the extra `nc`).", excludes="--gcode --peck")
@flag(
    "--depth",
    "In the drawing, Z is the depth of the cut; without it the drawing is flat.",
    excludes="--gcode",
)
@output(Target("text"))
@click.pass_context
def export(
    ctx: click.Context,
    /,
    tape: Tape,
    feeds: Feeds,
    metric: Metric,
    named: Named,
    cutter: Cutter,
    peck: int,
    gcode: bool,
    safe: float | None,
    shift: tuple[float, float] | None,
    tap: float | None,
    tool_change: bool,
    as_1971: bool,
    dxf: bool,
    depth: bool,
    output: str,
) -> None:
    """Write the path as G-code or DXF. The ending of the file says which: .ngc, .nc, .gcode or .tap, or .dxf.

    \b
    Examples:
      pdp8 nc export circle.eia -o circle.ngc
      pdp8 nc export circle.eia --gcode --shift=-2,-2 --safe 0.5 --mm > circle.ngc
      pdp8 nc export circle.eia -o circle.dxf
    """
    made = _format(ctx, gcode, dxf, output)
    known = work(tape, replace(feeds.settings(), peck=peck), named, metric, cutter.cutter)
    x, y = shift or (0, 0)
    if made == "DXF":
        from nc.dxf import dxf as drawing

        with naming(tape.name):
            text = drawing(
                known.path,
                known.curve,
                known.cutter,
                shift=(1000 * x, 1000 * y),
                depth=depth,
                unit=metric.unit,
            )
        command.put(output, text)
        return
    from nc.gcode import Output
    from nc.gcode import gcode as program
    from nc.gcode_1971 import gcode_1971

    settings = Output(
        known.cutter, 1000 * (safe or 0.25), (1000 * x, 1000 * y), tool_change, 1000 * (tap or 0), metric.unit
    )
    lines = gcode_1971(known.path, settings.pitch, metric.unit) if as_1971 else program(known.path, settings)
    with naming(tape.name):
        command.put(output, "".join(f"{line}\n" for line in lines))


def _format(ctx: click.Context, gcode: bool, dxf: bool, output: str) -> str:
    """Return the output's format, "G-code" or "DXF". Raises UsageError if it is unknown or contradictory."""
    ending = os.path.splitext(output)[1].lower()
    asked = "G-code" if gcode else "DXF" if dxf else ""
    made = asked or _FORMATS.get(ending, "")
    if not made:
        raise click.UsageError(
            "give --gcode or --dxf, or a file whose name says so: -o FILE.ngc, -o FILE.dxf"
        )
    if _FORMATS.get(ending, made) != made:
        raise click.UsageError(f"{output} is the name of {_FORMATS[ending]}, not of {made}")
    barred = {
        "DXF": ("peck", "safe", "tap", "tool_change", "as_1971"),
        "G-code": ("depth", "circle", "ellipse", "line", "function", "profile"),
    }
    params = {param.name: param for param in ctx.command.params}
    for name in barred[made]:
        if is_given(ctx, params[name]):
            raise click.UsageError(f"{words(params[name])[0]} is not for {made}.")
    return made
