"""`pdp8 cards`: cards to print and lay beside the machine."""

import click

from pdp8.cli.shared import command
from pdp8.cli.shared.arguments import Command, Folder, output
from pdp8.lessons import cards as drawn

_AFTERNOON = "afternoon"
_PART = "circle"
_NAMES = (*drawn.CARDS, _AFTERNOON)


@click.command(cls=Command)
@click.argument("names", nargs=-1, type=click.Choice([*_NAMES, "all"]), metavar="NAME...")
@output(Folder(), "FOLDER", ".", "Where to.  [default: this folder]")
def cards(names: tuple[str, ...], output: str) -> None:
    """Draw cards of A4, NAME.svg each: rim, instructions, ascii, eia, afternoon, or all.

    The afternoon's timetable is that of `pdp8 replay circle`.

    \b
    Examples:
      pdp8 cards all
      pdp8 cards rim instructions --out handout
    """
    if not names:
        raise click.UsageError(f"Give a card's name: {', '.join(_NAMES)}, or all.")
    wanted = _NAMES if "all" in names else dict.fromkeys(names)
    svgs = {name: _afternoon() if name == _AFTERNOON else drawn.CARDS[name]() for name in wanted}
    command.put_all(output, ((f"{name}.svg", svg.encode()) for name, svg in svgs.items()))


def _afternoon() -> str:
    from pdp8.replay import replay
    from pdp8.replay.day import clock

    slots = [(clock(act.starts), act.name, act.outcome) for act in replay(_PART).acts]
    return drawn.afternoon(slots, f"The afternoon: {_PART}")
