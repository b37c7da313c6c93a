"""`pdp8 cards`: cards to print and lay beside the machine."""

import os
from importlib.util import find_spec

import click

from pdp8.lessons import cards as drawn
from tapes import command, shelf
from tapes.errors import WorkError

_AFTERNOON = "afternoon"
_NAMES = (*drawn.CARDS, _AFTERNOON)


@click.command()
@click.argument("names", nargs=-1, type=click.Choice([*_NAMES, "all"]), metavar="NAME...")
@command.output("FOLDER", ".", "Where to.  [default: this folder]")
@click.option("--part", metavar="PART", default="circle", show_default=True, help="Whose afternoon it is.")
@click.option("--pdf", is_flag=True, help="Write PDF; needs CairoSVG, the extra `print`.")
def cards(names: tuple[str, ...], output: str, part: str, pdf: bool) -> None:
    """Draw cards of 7 by 5 inches, NAME.svg each: rim, instructions, ascii, eia, afternoon, or all.

    The afternoon's timetable is that of a replay: `pdp8 replay` shows it too.

    \b
    Examples:
      pdp8 cards all
      pdp8 cards rim instructions --out handout
      pdp8 cards all --pdf --out handout
      pdp8 cards afternoon --part ellipse
    """
    if not names:
        raise click.UsageError(f"Give a card's name: {', '.join(_NAMES)}, or all.")
    if pdf and find_spec("cairosvg") is None:
        raise WorkError("PDF needs CairoSVG: pip install 'pdp8[print]'; a browser prints the SVG as well")
    os.makedirs(output, exist_ok=True)
    for name in _NAMES if "all" in names else dict.fromkeys(names):
        svg = _afternoon(part) if name == _AFTERNOON else drawn.CARDS[name]()
        path = os.path.join(output, f"{name}.{'pdf' if pdf else 'svg'}")
        shelf.write(path, _pdf(svg) if pdf else svg.encode())
        click.echo(path)


def _pdf(svg: str) -> bytes:
    import cairosvg  # type: ignore[import-untyped]

    return bytes(cairosvg.svg2pdf(bytestring=svg.encode()))


def _afternoon(part: str) -> str:
    from pdp8.replay import replay
    from pdp8.replay.afternoon import clock

    slots = [drawn.Slot(clock(act.starts), act.name, act.outcome) for act in replay(part).acts]
    return drawn.afternoon(slots, f"The afternoon: {part}")
