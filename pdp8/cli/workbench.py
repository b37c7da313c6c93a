"""`pdp8 workbench` and `pdp8 nc view`: the live machine in one page, and a tape at the machine tool in it."""

from os.path import basename

import click

from tapes import command, shelf
from tapes.arguments import Command, Source, Target, output


@click.command(cls=Command)
@output(Target("HTML"), "PAGE", "pdp8.html", "The page.", show_default=True)
def workbench(output: str) -> None:
    """Write the workbench: a live PDP-8/L with Teletype, assembler, debugger and Hydra-Point, in one page.

    The page needs no network and nothing beside it: a browser opens it from disk.

    \b
    Examples:
      pdp8 workbench
      pdp8 workbench -o lesson.html
    """
    from pdp8.web.workbench import page

    command.put(output, page())


@click.command(cls=Command)
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
