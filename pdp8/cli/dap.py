"""`pdp8 dap`: a debugger for editors, on standard input and output."""

import click

from pdp8.cli.shared import command
from pdp8.dap.session import Session


@click.command()
def dap() -> None:
    """Debug programs in an editor that speaks the Debug Adapter Protocol: VS Code, Neovim, Emacs.

    Breakpoints, steps into, over, out and back; registers, lamps, symbols, devices; core as memory and as
    instructions; the debug console takes the monitor's commands. docs/editors.md says how editors start it.

    \b
    Examples:
      pdp8 dap
    """
    with command.conversation() as (reader, writer):
        Session(reader, writer).serve()
