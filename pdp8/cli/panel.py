"""`pdp8 panel`: the front panel in the terminal."""

import sys

import click

from pdp8.cli.shared import extras
from pdp8.cli.shared.arguments import Command, Source
from pdp8.cli.shared.parameters import address, check_start, octal
from pdp8.cli.shared.rules import flag, option
from pdp8.computer.hardware.extension import MEMORY
from pdp8.lessons.drill import LEFT_ALONE, NAMES, Coach, find
from tapes.errors import WorkError


@click.command(cls=Command)
@click.argument("program", type=Source(), required=False)
@option("--reader", "Tape in the Teletype's reader to begin with.", Source())
@option(
    "--start", "Where PROGRAM starts, octal.", address, default="0200", needs="PROGRAM", excludes="--cold"
)
@option("--sr", "Switch register to begin with, octal.  [default: --start]", octal)
@option("--drill", "Follow a card key by key; what is wrong is named.", click.Choice(NAMES), only="--kiosk")
@flag("--kiosk", "Begin the drill again when it is left alone for a minute.", needs="--drill")
@flag("--cold", "Leave core empty: PROGRAM is a tape at hand, to be loaded.", needs="PROGRAM")
@option(
    "--memory",
    "Words of core; 8k comes with the memory extension MC8/L and its switches.",
    click.Choice(["4k", "8k"], case_sensitive=False),
    default="4k",
)
def panel(
    program: str | None,
    reader: str | None,
    start: int,
    sr: int | None,
    drill: str | None,
    kiosk: bool,
    cold: bool,
    memory: str,
) -> None:
    """Operate the PDP-8/L in the terminal: lamps, switches and keys, its Teletype and tapes.

    PROGRAM is PAL III source, a BIN or a RIM tape, or a bundled name; it is in core, the PC at its start.
    Without it the machine is cold, as on a morning of 1971: RIM is to be toggled in (R does it for you), RIM
    reads BIN, BIN reads eia.bin, and eia.bin reads circle.asc. All these tapes are at hand.

    The letters underlined are the keys; 0 to 7 set the switches, so do arrows and mouse; TAB turns to the
    Teletype, O puts a tape into the reader, W tears off what was punched, P changes the pace, Q leaves.
    Ctrl-C is the STOP key.

    A drill is a card to follow: a key that is not the next one, or with a wrong switch, is not pressed, and
    the first wrong switch is named. X begins again. A kiosk is left with Ctrl-Q.

    \b
    Examples:
      pdp8 panel
      pdp8 panel --drill rim
      pdp8 panel --drill boot --kiosk
      pdp8 panel eia.pal --reader circle.asc
      pdp8 panel --cold mine.pal
    """
    if not (sys.stdin.isatty() and sys.stdout.isatty()):
        raise WorkError("the panel needs a terminal; `pdp8 run` works without one")
    check_start(start, MEMORY[memory])
    extras.need("textual", "panel", "the panel needs Textual")
    from pdp8.console.opening import opening

    session, programs = opening(program, reader, start, cold, memory=MEMORY[memory])
    if sr is not None:
        session.machine.sr = sr
    from pdp8.console.app import Room

    coach = None
    if drill is not None:
        bin_tape, tape = session.tapes[:2]
        tapes = (bin_tape.name, programs[1].words), (tape.name, programs[2].words)
        coach = Coach(find(drill, tapes), session.machine, LEFT_ALONE if kiosk else None)
    sys.exit(Room(session, programs, coach=coach).operate())
