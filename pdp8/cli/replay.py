"""`pdp8 replay`: the afternoon of 1971, act by act, and its figures beside the thesis's."""

import os
from typing import TYPE_CHECKING

import click

from pdp8 import shelf
from pdp8.cli.shared import command
from pdp8.cli.shared.arguments import Command, Folder, Source, Target, output
from pdp8.cli.shared.rules import option
from programs.parts import PARTS
from tapes.errors import naming

if TYPE_CHECKING:
    from pdp8.replay import Act, Afternoon

REPLAYED = tuple(name for name, part in PARTS.items() if part.has_defaults)


@click.command(cls=Command)
@click.argument("part", type=click.Choice(REPLAYED), metavar="PART")
@output(Folder(), "FOLDER", None, "Where tapes, listings and pictures go.  [default: replay-PART]")
@option("--html", "Write the afternoon as a page too: any instant of it, in one file.", Target("HTML"))
@option(
    "--fortran",
    "Run the listing in DEC's FORTRAN, on an 8/L of 8K with this DECtape of PS/8.",
    Source(),
    metavar="DECTAPE",
    excludes="--html",
)
def replay(part: str, output: str | None, html: str | None, fortran: str | None) -> None:
    """Do the afternoon of 1971 again for PART: circle, ellipse, polynomial, slope, die, drill or fluidic.

    Every constant is as the thesis has it. FORTRAN's output is punched, RIM toggled in, BIN loaded, eia.pal
    loaded, the tape translated, the part milled and inspected. Each step is one line: its time of day,
    how long it took in 1971 and takes today, and its outcome. The table at the end sets the thesis's
    figures beside the replay's; tapes, listings and pictures stay in a folder.

    With --fortran circle and ellipse are compiled and run on the 8/L itself, in place of Toronto's terminal.
    It is our experiment: nothing says that the 8/L of 1971 had 8K or a DECtape.

    \b
    Examples:
      pdp8 replay circle
      pdp8 replay ellipse --out ellipse --html ellipse.html
    """
    from pdp8.replay import replay as whole
    from pdp8.replay.day import ARRANGED

    folder = output or f"replay-{part}"
    _check(part, folder, html, in_fortran=fortran is not None)
    command.tell(ARRANGED)
    afternoon = _own(part, fortran) if fortran else whole(part, _say_act)
    _leave(afternoon, folder, html)
    _show(afternoon, aside=html == "-")


def _own(part: str, reel: str) -> "Afternoon":
    """Do the day with the part program in DEC's FORTRAN."""
    from pdp8.replay.fortran import LISTINGS, Own
    from tapes import dectape

    if part not in LISTINGS:
        raise click.UsageError(f"--fortran: the thesis lists {' and '.join(LISTINGS)}; {part} is ours.")
    content = shelf.read(reel)
    with naming(reel):
        image, notes = dectape.decode(content)
    command.say_of(reel, notes)
    afternoon = Own(part, image, _say_act)
    for _ in afternoon.through():
        pass
    return afternoon


def _say_act(act: "Act") -> None:
    from pdp8.replay import clock

    minutes, rest = divmod(round(act.seconds), 60)
    took = f"{minutes:3}:{rest:02} in 1971, {act.real:5.2f} s today"
    command.tell(f"{clock(act.starts):>11}  {act.name:<14} {took}  {act.outcome}")


def _check(part: str, folder: str, html: str | None, in_fortran: bool) -> None:
    """Raise UsageError if the page would replace another file of the replay, ShelfError for a kept file."""
    from pdp8.replay.desk import names

    paths = [os.path.join(folder, name) for name in names(part, in_fortran)]
    if html and os.path.realpath(html) in map(os.path.realpath, paths):
        raise click.UsageError(f"--html {html} is the name of another file of the replay; name another")
    for path in filter(os.path.exists, paths):
        command.check_output(path)


def _leave(afternoon: "Afternoon", folder: str, html: str | None) -> None:
    """Write all files."""
    from pdp8.replay.desk import desk

    command.put_all(folder, desk(afternoon).items())
    if html:
        from pdp8.web.workbench import page

        command.put(html, page(afternoon=afternoon))


def _show(afternoon: "Afternoon", aside: bool) -> None:
    """Print the figures, on standard error if the page goes to standard output."""
    from rich.console import Console
    from rich.table import Table

    from pdp8.replay.figures import COLUMNS, compare

    table = Table(title=f"{afternoon.part}: thesis beside replay")
    for column in COLUMNS:
        table.add_column(column)
    for line in compare(afternoon):
        table.add_row(*line)
    console = Console(stderr=aside)
    with console.capture() as shown:
        console.print(table)
    click.echo(shown.get(), nl=False, err=aside)
