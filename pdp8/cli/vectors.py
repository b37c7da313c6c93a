"""`pdp8 vectors`: single-step vectors for any emulator."""

import click

from pdp8.cli.shared import command
from pdp8.cli.shared.arguments import Command, Folder, output
from pdp8.cli.shared.progress import Bar
from pdp8.cli.shared.rules import flag, option


@click.command(cls=Command)
@output(Folder(), "FOLDER", None, "Where the files go.", required=True)
@option(
    "--states",
    "States of each word, in steps of four.",
    click.IntRange(4, 1000),
    metavar="NUMBER",
    default=100,
)
@flag("--pipan8l", "Add hands.tcl, which plays the keys on a real PDP-8/L.")
def vectors(output: str, states: int, pipan8l: bool) -> None:
    """Write what each of the 4,096 words does, in a hundred states each, for tests of any emulator.

    Beside them go interrupts, keys and switches, the Teletype and the PC8/L against the clock, what other
    models of the PDP-8 do otherwise, runners in Python, C and Go, and a README that describes the format.

    \b
    Examples:
      pdp8 vectors --out vectors
      gzip -dc vectors/tad.json.gz | head -3
    """
    from pdp8.vectors import folder

    with Bar("vectors", folder.COUNT + pipan8l) as bar:
        command.put_all(output, bar.along(folder.files(states, pipan8l)))
