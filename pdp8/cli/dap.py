"""`pdp8 dap`: a debugger for editors, on standard input and output or at a port of this computer."""

import os
import socket
import sys
from contextlib import redirect_stdout
from typing import BinaryIO

import click

from pdp8.dap.session import Session
from pdp8.dap.wire import Wire, WireError
from tapes import command


@click.command()
@click.option(
    "--port",
    type=click.IntRange(0, 65535),
    metavar="PORT",
    help="Listen at this port of 127.0.0.1; 0 is any.",
)
def dap(port: int | None) -> None:
    """Debug programs in an editor that speaks the Debug Adapter Protocol: VS Code, Neovim, Emacs.

    Breakpoints, steps into, over, out and back; registers, lamps, symbols, devices; core as memory and as
    instructions; the debug console takes the monitor's commands. docs/editors.md says how editors start it.

    \b
    Examples:
      pdp8 dap
      pdp8 dap --port 4711
    """
    if port is None:
        _at_standard_streams()
    else:
        _listen(port)


def _at_standard_streams() -> None:
    """Serve one session; what else reads standard input has nothing, what else is printed goes to standard
    error.
    """
    reader, writer = os.fdopen(os.dup(0), "rb"), os.fdopen(os.dup(1), "wb")
    with open(os.devnull) as nothing, redirect_stdout(sys.stderr):
        sys.stdin = nothing
        Session(Wire(reader, writer)).serve()


def _listen(port: int) -> None:
    """Serve one editor after another, until Ctrl-C."""
    with socket.create_server(("127.0.0.1", port)) as server:
        command.say(f"listening at port {server.getsockname()[1]} of 127.0.0.1; Ctrl-C ends")
        while True:
            connection, _ = server.accept()
            with connection, connection.makefile("rb") as reader, connection.makefile("wb") as writer:
                _serve(reader, writer)


def _serve(reader: BinaryIO, writer: BinaryIO) -> None:
    try:
        Session(Wire(reader, writer)).serve()
    except WireError as error:
        command.say(str(error))
    except ConnectionError:
        pass
