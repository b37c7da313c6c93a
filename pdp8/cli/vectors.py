"""`pdp8 vectors`: single-step vectors for any emulator."""

import os

import click

from tapes import command, shelf
from tapes.progress import Bar


@click.command()
@command.output("FOLDER", None, "Where the files go.", required=True)
@click.option(
    "--states",
    metavar="NUMBER",
    type=click.IntRange(4, 1000),
    default=100,
    show_default=True,
    help="States of each word, in steps of four.",
)
def vectors(output: str, states: int) -> None:
    """Write what each of the 4,096 words does, in a hundred states each, for tests of any emulator.

    Beside them go interrupts, the Teletype and the PC8/L against the clock, what other models of the PDP-8 do
    otherwise, runners in Python, C and Go, and a README that describes the format.

    \b
    Examples:
      pdp8 vectors --out vectors
      gzip -dc vectors/tad.json.gz | head -3
    """
    from pdp8.vectors import folder

    os.makedirs(output, exist_ok=True)
    size = 0
    with Bar("vectors", folder.COUNT) as bar:
        for number, (name, content) in enumerate(folder.files(states), 1):
            shelf.write(os.path.join(output, name), content)
            size += len(content)
            bar.show(number)
    click.echo(f"{folder.COUNT} files in {output}, {size / 1e6:.1f} MB", err=True)
