"""`pdp8 monitor`: the operator's prompt, at a terminal with editing and history, or fed by a script."""

import os
import signal
import sys
from collections.abc import Callable, Iterable, Iterator
from contextlib import ExitStack, suppress
from typing import TYPE_CHECKING

import click

from pdp8 import fitting, leaving, shelf
from pdp8.cli.shared import command
from pdp8.cli.shared.arguments import Command, Source
from pdp8.cli.shared.parameters import device_option, dialect_option
from pdp8.cli.shared.rules import flag
from pdp8.computer.machine import Machine
from pdp8.computer.stop import Stop
from pdp8.computer.use.trace import Listing
from pdp8.monitor import simh
from pdp8.monitor.commands import COMMANDS, do, do_file
from pdp8.monitor.prompt import Monitor
from pdp8.monitor.running import next_tape
from pdp8.reels import Reels
from tapes.errors import WorkError

if TYPE_CHECKING:
    from pdp8.cli.running.feed import Feed
    from pdp8.cli.running.keyboard import Terminal


_BACK = "cont goes back into the program"


@click.command(cls=Command)
@click.argument("script", type=Source(), required=False)
@flag("--highspeed", "Fit the PC8/L high-speed reader and punch.")
@device_option
@dialect_option()
@flag("--echo", "Show each line of a script before its answer.")
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
    at_terminal = script is None and sys.stdin.isatty()
    if echo and at_terminal:
        raise click.UsageError("--echo means nothing without SCRIPT.")
    with ExitStack() as stack:
        stack.callback(simh.leave, made)
        if at_terminal:
            click.echo(f"PDP-8/L, {machine.memory // 1024}K. help tells what there is; quit leaves.")
            converse(made)
            return
        if echo:
            made.echo = lambda line: command.echo(f"* {line}")
        do_file(made, "-" if script is None else script)


def converse(made: Monitor, terminal: "Terminal | None" = None) -> None:
    """Answer at a terminal until quit; while the machine runs it is the Teletype; Ctrl-] or Ctrl-C stops."""
    from pdp8.cli.running.keyboard import Terminal

    at = terminal or Terminal()
    hint = False

    def live(seconds: float) -> Stop:
        nonlocal hint
        stop, left = at.run(made.machine, seconds, made.realtime, lambda: next_tape(made))
        hint = hint or left
        return stop

    if sys.stdout.isatty():
        made.live, made.say = live, at.say
    told = terminal is not None
    with ExitStack() as stack:
        stack.callback(simh.take_off, made)
        for line in _typed():
            before = signal.signal(signal.SIGINT, lambda number, frame: setattr(made, "stopping", True))
            try:
                with at.printing(made.machine):
                    do(made, line)
                if hint and not told:
                    told = True
                    made.say(_BACK)
            except WorkError as error:
                at.end_line()
                command.tell(str(error))
            finally:
                signal.signal(signal.SIGINT, before)
            at.end_line()
            if made.finished:
                break


def sit_down(
    machine: Machine,
    listing: Listing,
    dialect: str,
    mounted: Reels | None,
    feed: "Feed",
    max_time: float | None,
    realtime: bool,
    follow: Callable[[Machine], object],
    pass_on: Callable[[], object],
) -> Stop | None:
    """Run with the terminal as the Teletype; return how the run stopped, None if Ctrl-] ended it.

    Then `follow` is called with the machine that the monitor leaves: it may have restored another one.
    """
    from pdp8.cli.running.keyboard import Terminal

    def next_tape() -> None:
        if feed.names:
            terminal.end_line()
            feed.announce_next()

    terminal = Terminal(pass_on)
    terminal.resume, feed.idle = feed.resume, terminal.asked
    click.echo("Teletype on line; Ctrl-] stops, and leaves to the monitor.", err=True)
    stop, left = terminal.run(machine, max_time, realtime, next_tape)
    terminal.end_line()
    if not left:
        return stop
    made = Monitor(terminal.say, machine, listing)
    made.dialect, made.realtime, made.waiting_tapes = dialect, realtime, feed.names
    feed.idle = lambda: terminal.asked() or made.stopping
    if mounted is not None:
        made.reels = mounted
    made.say_stop(stop)
    made.say(f"{_BACK}; help tells what there is; quit leaves")
    try:
        converse(made, terminal)
    finally:
        follow(made.machine)
    return None


def _typed() -> Iterator[str]:
    from prompt_toolkit import PromptSession
    from prompt_toolkit.application import get_app
    from prompt_toolkit.completion import WordCompleter
    from prompt_toolkit.history import FileHistory

    class Kept(FileHistory):
        """What was typed, in a file as far as it can be read and written."""

        def load_history_strings(self) -> Iterable[str]:
            try:
                return super().load_history_strings()
            except OSError:
                return []

        def store_string(self, string: str) -> None:
            with suppress(OSError, UnicodeError):
                super().store_string(string)

    history = Kept(os.path.join(shelf.of_user("XDG_STATE_HOME", "~/.local/state"), "pdp8-monitor"))
    session: PromptSession[str] = PromptSession(history=history, completer=WordCompleter(list(COMMANDS)))
    asked: list[int] = []

    def end(number: int, _: object) -> None:
        asked.append(number)
        loop = get_app().loop  # on a dumb terminal it is not the session's own, and calls no `pre_run`
        if loop is None:
            sys.exit(128 + number)
        loop.call_soon_threadsafe(leave)

    def leave() -> None:
        app = get_app()
        if asked and app.is_running and not app.is_done:
            app.exit(exception=EOFError)

    while True:
        line: str | None = None
        try:
            with leaving.taken(end, *leaving.ENDS):  # an exception may be lost within prompt_toolkit
                line = session.prompt("pdp8> ", pre_run=leave)
        except KeyboardInterrupt:
            pass
        except EOFError:
            if not asked:
                return
        except OSError:  # the terminal is closed
            if not asked:
                raise
        if asked:
            sys.exit(128 + asked[0])
        if line is not None:
            yield line
