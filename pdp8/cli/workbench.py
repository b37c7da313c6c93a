"""`pdp8 workbench`: the live machine in one page."""

import click

from pdp8.cli.shared import command
from pdp8.cli.shared.arguments import Command, Target, output


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
