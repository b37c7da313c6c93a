"""A terminal as the Teletype: what is typed is its keyboard (see computer/keys), what it prints is the page.

A Model 33 prints nothing by itself. Ctrl-] leaves to the monitor, with the machine as it stands.
"""

import sys
import time
from collections.abc import Callable

import click

from pdp8.cli.terminal import Terminal
from pdp8.computer.hardware.signals import NEVER, TICKS_PER_SECOND
from pdp8.computer.hardware.teletype import printed
from pdp8.computer.machine import Machine
from pdp8.computer.stop import Stop
from pdp8.computer.use.keys import sent
from pdp8.computer.use.trace import Listing
from tapes import command

ESCAPE = "\x1d"
_SLICE = 0.05


def sit_down(
    machine: Machine, listing: Listing, max_time: float | None, realtime: bool, pass_on: Callable[[], object]
) -> Stop | None:
    """Run with the terminal as the Teletype until the machine stops or Ctrl-] is typed.

    `pass_on` is called after each slice of the run. Returns how the run ended, or None after the monitor.
    """
    machine.teletype.printer.on_frame = _Page().print
    terminal = Terminal()
    try:
        with terminal.raw():
            click.echo("Teletype on line; Ctrl-] leaves to the monitor.\r", err=True)
            stop = _run(machine, terminal, max_time, realtime, pass_on)
    finally:
        machine.teletype.printer.on_frame = None
    click.echo(err=True)
    if stop is None:
        _to_the_monitor(machine, listing)
    return stop


def _run(
    machine: Machine,
    terminal: Terminal,
    max_time: float | None,
    realtime: bool,
    pass_on: Callable[[], object],
) -> Stop | None:
    began = time.monotonic() - machine.elapsed
    last = NEVER if max_time is None else machine.ticks + round(max_time * TICKS_PER_SECOND)
    while True:
        stop = machine.run(seconds=min(_SLICE, max(last - machine.ticks, 0) / TICKS_PER_SECOND))
        pass_on()
        waiting = stop.reason in ("tape out", "idle")
        if (stop.reason != "limit" and not waiting) or machine.ticks >= last:
            return stop
        ahead = machine.elapsed - (time.monotonic() - began) if realtime else 0.0
        typed = terminal.typed(_SLICE if waiting else max(0.0, ahead))
        if ESCAPE in typed or terminal.closed:
            return None
        if waiting:
            machine.wait(max(_SLICE, time.monotonic() - began - machine.elapsed if realtime else 0.0))
        machine.teletype.keyboard.press(sent(typed))


class _Page:
    """The terminal as the page: a line feed goes straight down, as on a Model 33."""

    def __init__(self) -> None:
        self._column = 0

    def print(self, frame: int) -> None:
        """Print a frame as a Model 33 does."""
        character = printed(bytes([frame])).decode()
        if character == "\r":
            self._column = 0
        elif character >= " ":
            self._column += 1
        elif character == "\n" and self._column:  # a terminal may return the carriage too
            character = f"\n\x1b[{self._column + 1}G"
        sys.stdout.write(character)
        sys.stdout.flush()


def _to_the_monitor(machine: Machine, listing: Listing) -> None:
    from pdp8.cli.monitor import converse
    from pdp8.monitor.prompt import Monitor

    converse(Monitor(command.echo, machine, listing))
