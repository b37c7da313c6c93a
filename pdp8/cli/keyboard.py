"""A terminal as the Teletype: what is typed is its keyboard (see computer/keys), what it prints is the page.

A Model 33 prints nothing by itself. Ctrl-] leaves to the monitor, with the machine as it stands. The terminal
is put back as it was, however the run ends.
"""

import os
import select
import signal
import sys
import termios
import time
import tty
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from types import FrameType

import click

from pdp8.computer.bus import NEVER
from pdp8.computer.keys import sent
from pdp8.computer.machine import TICKS_PER_SECOND, Machine
from pdp8.computer.stop import Stop
from pdp8.computer.teletype import printed
from pdp8.computer.trace import Listing

ESCAPE = b"\x1d"
_SLICE = 0.05


def sit_down(
    machine: Machine,
    listing: Listing | None,
    max_time: float | None,
    realtime: bool,
    pass_on: Callable[[], object],
) -> Stop | None:
    """Run with the terminal as the Teletype until the machine stops or Ctrl-] is typed.

    `pass_on` is called after each slice of the run. Returns how the run ended, or None after the monitor.
    """
    machine.teletype.printer.on_frame = _print
    try:
        with raw_terminal():
            click.echo("Teletype on line; Ctrl-] leaves to the monitor.\r", err=True)
            stop = _run(machine, max_time, realtime, pass_on)
    finally:
        machine.teletype.printer.on_frame = None
    click.echo(err=True)
    if stop is None:
        _to_the_monitor(machine, listing)
    return stop


@contextmanager
def raw_terminal() -> Iterator[None]:
    """Take every key as it is typed, Ctrl-C too; put the terminal back as it was, whoever ends the run."""
    before = termios.tcgetattr(sys.stdin)
    handlers = {number: signal.signal(number, _end) for number in (signal.SIGTERM, signal.SIGHUP)}
    try:
        tty.setraw(sys.stdin, termios.TCSADRAIN)
        yield
    finally:
        termios.tcsetattr(sys.stdin, termios.TCSADRAIN, before)
        for number, handler in handlers.items():
            signal.signal(number, handler)


def _end(number: int, frame: FrameType | None) -> None:
    sys.exit(128 + number)


def _run(
    machine: Machine, max_time: float | None, realtime: bool, pass_on: Callable[[], object]
) -> Stop | None:
    began = time.monotonic() - machine.elapsed
    last = NEVER if max_time is None else machine.ticks + round(max_time * TICKS_PER_SECOND)
    while True:
        stop = machine.run(seconds=min(_SLICE, (last - machine.ticks) / TICKS_PER_SECOND))
        pass_on()
        waiting = stop.reason in ("tape out", "idle")
        if (stop.reason != "limit" and not waiting) or machine.ticks >= last:
            return stop
        ahead = machine.elapsed - (time.monotonic() - began) if realtime else 0.0
        typed = _keys(_SLICE if waiting else max(0.0, ahead))
        if ESCAPE in typed:
            return None
        if waiting:
            machine.wait(max(_SLICE, time.monotonic() - began - machine.elapsed if realtime else 0.0))
        machine.teletype.keyboard.press(sent(typed.decode("utf-8", "ignore")))


def _keys(seconds: float) -> bytes:
    """Return what is typed within `seconds`; the end of the terminal is as good as Ctrl-]."""
    ready, _, _ = select.select([sys.stdin], [], [], seconds)
    typed = os.read(sys.stdin.fileno(), 64) if ready else b""
    if typed[:2] in (b"\x1b[", b"\x1bO"):
        return b""  # an arrow or another key that a Model 33 has not; ESC alone is ALT MODE
    return ESCAPE if ready and not typed else typed


def _print(frame: int) -> None:
    """Print a frame as a Model 33 does."""
    sys.stdout.write(printed(bytes([frame])).decode())
    sys.stdout.flush()


def _to_the_monitor(machine: Machine, listing: Listing | None) -> None:
    from pdp8.cli.monitor import converse
    from pdp8.monitor.prompt import Monitor

    converse(Monitor(click.echo, machine, listing))
