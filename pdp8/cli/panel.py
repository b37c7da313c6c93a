"""`pdp8 panel`: the front panel in the terminal."""

import sys
from importlib.util import find_spec

import click

from pdp8.cli.parameters import octal
from tapes.errors import WorkError


@click.command()
@click.argument("program", required=False)
@click.option("--reader", metavar="FILE", help="Tape in the Teletype's reader to begin with.")
@click.option("--start", type=octal, default="0200", show_default=True, help="Where PROGRAM starts, octal.")
@click.option("--sr", type=octal, help="Switch register to begin with, octal.  [default: --start]")
@click.option("--cold", is_flag=True, help="Leave core empty: PROGRAM is a tape at hand, to be loaded.")
def panel(program: str | None, reader: str | None, start: int, sr: int | None, cold: bool) -> None:
    """Sit down at the PDP-8/L: lamps, switches and keys, its Teletype and tapes, in the terminal.

    PROGRAM is PAL III source, a BIN or a RIM tape, or a bundled name; it is in core, the PC at its start.
    Without it the machine is cold, as on a morning of 1971: RIM is to be toggled in (R does it for you), RIM
    reads BIN, BIN reads eia.bin, and eia.bin reads circle.asc. All these tapes are at hand.

    The letters underlined are the keys; 0 to 7 set the switches, so do arrows and mouse; TAB turns to the
    Teletype, O puts a tape into the reader, W tears off what was punched, P changes the pace, Q goes home.
    Ctrl-C is the STOP key.

    \b
    Examples:
      pdp8 panel
      pdp8 panel eia.pal --reader circle.asc
      pdp8 panel --cold mine.pal
    """
    if not (sys.stdin.isatty() and sys.stdout.isatty()):
        raise WorkError("the panel is drawn on a terminal, and this is none; `pdp8 run` needs none")
    if find_spec("textual") is None:
        raise WorkError("the panel needs Textual: pip install textual")
    from pdp8.console.opening import opening

    session, programs = opening(program, reader, start, cold)
    if sr is not None:
        session.machine.sr = sr
    from pdp8.console.app import Room

    Room(session, programs).run()
