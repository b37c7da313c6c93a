"""`pdp8 dap`: a debugger for editors, on standard input and output."""

import os
import sys
from contextlib import redirect_stdout

import click

from pdp8.dap.session import Session
from pdp8.dap.wire import Wire


@click.command()
def dap() -> None:
    """Debug programs in an editor that speaks the Debug Adapter Protocol: VS Code, Neovim, Emacs.

    Breakpoints, steps into, over, out and back; registers, lamps, symbols, devices; core as memory and as
    instructions; the debug console takes the monitor's commands. docs/editors.md says how editors start it.

    \b
    Examples:
      pdp8 dap
    """
    reader, writer = os.fdopen(os.dup(0), "rb"), os.fdopen(os.dup(1), "wb")
    with open(os.devnull) as nothing, redirect_stdout(sys.stderr):  # nothing else reads or writes there
        sys.stdin = nothing
        Session(Wire(reader, writer)).serve()
