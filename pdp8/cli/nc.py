"""`pdp8 nc` with `pdp8 nc view`, whose page nc/ knows nothing of."""

from os.path import basename

import click

from nc.cli import nc
from tapes import command, shelf
from tapes.arguments import Command, Source, Target, output

__all__ = ["nc"]


@nc.command(cls=Command)
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
