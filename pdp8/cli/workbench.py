"""`pdp8 workbench`: the live machine in one page."""

from os.path import basename

import click

from pdp8 import shelf
from pdp8.cli.shared import command
from pdp8.cli.shared.arguments import Command, Source, Target, output
from pdp8.cli.shared.rules import option
from tapes.errors import called


@click.command(cls=Command)
@option("--tape", "Open it with this EIA tape at the Hydra-Point.", Source())
@option(
    "--url", "The page's public address, with which the links that it gives begin.", metavar="URL", default=""
)
@output(Target("HTML"), "PAGE", "pdp8.html", "The page.", show_default=True)
def workbench(tape: str | None, url: str, output: str) -> None:
    """Write the workbench: a live PDP-8/L with Teletype, assembler, debugger and Hydra-Point, in one page.

    The page needs no network and nothing beside it: a browser opens it from disk. With --tape it shows the
    tape's path, band and blocks, and where the machine refuses it.

    \b
    Examples:
      pdp8 workbench
      pdp8 workbench -o lesson.html
      pdp8 workbench --tape circle.eia -o circle.html
      pdp8 workbench --url https://example.org/pdp8.html
    """
    from pdp8.web.workbench import page

    view = (basename(called(tape)), shelf.read(tape)) if tape else None
    command.put(output, page(view, url=url))
