"""`pdp8 monitor`: the operator's prompt, at a terminal with editing and history, or fed by a script."""

import os
import signal
import sys
from collections.abc import Iterator

import click

from pdp8 import fitting, shelf
from pdp8.cli.shared import command
from pdp8.cli.shared.arguments import Command, Source
from pdp8.computer.machine import Machine
from pdp8.computer.use.program import DIALECTS, FOUND
from pdp8.monitor.arguments import MonitorError
from pdp8.monitor.commands import COMMANDS, do
from pdp8.monitor.prompt import Monitor
from tapes.errors import WorkError, called
from tapes.text import lines_of


@click.command(cls=Command)
@click.argument("script", type=Source(), required=False)
@click.option("--highspeed", is_flag=True, help="Fit the PC8/L high-speed reader and punch.")
@click.option(
    "--device",
    multiple=True,
    metavar="NAME|FILE:CLASS",
    help="Fit a device, highspeed or a class in a Python file of your own.",
)
@click.option("--dialect", type=click.Choice(DIALECTS), default=FOUND, help="That of PAL source.")
@click.option("--echo", is_flag=True, help="Show each line of a script before its answer.")
def monitor(script: str | None, highspeed: bool, device: tuple[str, ...], dialect: str, echo: bool) -> None:
    """Operate the machine by commands: examine, deposit, step, break, trace; from SCRIPT or at a prompt.

    Answers go to standard output. A script ends at its first error, with exit status 1 and its line number.
    Type help for the commands; numbers are octal, and symbols of a loaded program are addresses.

    \b
    Examples:
      pdp8 monitor
      printf 'load eia.pal\\nreader circle.asc\\nbreak CHK\\ngo 200\\n' | pdp8 monitor -
      pdp8 monitor lesson.txt --echo
    """
    machine = Machine()
    fitting.fit(machine, fitting.devices(["highspeed", *device] if highspeed else device))
    made = Monitor(command.echo, machine)
    made.dialect = dialect
    if script is None and sys.stdin.isatty():
        if echo:
            raise click.UsageError("--echo means nothing without SCRIPT.")
        converse(made)
    else:
        _follow(made, script or "-", echo)


def _follow(made: Monitor, script: str, echo: bool) -> None:
    """Carry out a script; its first error ends it."""
    text = shelf.read(script).decode("utf-8-sig", "replace")
    for number, line in enumerate(lines_of(text), 1):
        if echo:
            command.echo(f"* {line}")
        try:
            do(made, line)
        except WorkError as error:
            raise MonitorError(f"{called(script)}, line {number}: {error}") from error
        if made.finished:
            return


def converse(made: Monitor) -> None:
    """Answer at a terminal until quit or end of file; errors are said, Ctrl-C is the STOP key."""
    click.echo("PDP-8/L, 4K. help tells what there is; quit leaves.")
    for line in _typed():
        before = signal.signal(signal.SIGINT, lambda number, frame: setattr(made, "stopping", True))
        try:
            do(made, line)
        except WorkError as error:
            command.tell(str(error))
        finally:
            signal.signal(signal.SIGINT, before)
        if made.finished:
            return


def _typed() -> Iterator[str]:
    from prompt_toolkit import PromptSession
    from prompt_toolkit.completion import WordCompleter
    from prompt_toolkit.history import FileHistory, InMemoryHistory

    folder = os.environ.get("XDG_STATE_HOME", os.path.expanduser("~/.local/state"))
    kept = os.path.isdir(folder) and os.access(folder, os.W_OK)
    history = FileHistory(os.path.join(folder, "pdp8-monitor")) if kept else InMemoryHistory()
    session: PromptSession[str] = PromptSession(history=history, completer=WordCompleter(list(COMMANDS)))
    while True:
        try:
            yield session.prompt("* ")
        except KeyboardInterrupt:
            continue
        except EOFError:
            return
