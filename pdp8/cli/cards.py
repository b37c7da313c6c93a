"""`pdp8 cards`: cards to print and lay beside the machine."""

from importlib.util import find_spec

import click

from pdp8.lessons import cards as drawn
from tapes import command
from tapes.arguments import Command, Folder, output
from tapes.errors import WorkError

_AFTERNOON = "afternoon"
_NAMES = (*drawn.CARDS, _AFTERNOON)


@click.command(cls=Command)
@click.argument("names", nargs=-1, type=click.Choice([*_NAMES, "all"]), metavar="NAME...")
@output(Folder(), "FOLDER", ".", "Where to.  [default: this folder]")
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
    wanted = _NAMES if "all" in names else dict.fromkeys(names)
    command.put_all(output, (_card(name, part, pdf) for name in wanted))


def _card(name: str, part: str, pdf: bool) -> tuple[str, bytes]:
    svg = _afternoon(part) if name == _AFTERNOON else drawn.CARDS[name]()
    return (f"{name}.pdf", _pdf(svg)) if pdf else (f"{name}.svg", svg.encode())


def _pdf(svg: str) -> bytes:
    import cairosvg  # type: ignore[import-untyped]

    return bytes(cairosvg.svg2pdf(bytestring=svg.encode()))


def _afternoon(part: str) -> str:
    from pdp8.replay import replay
    from pdp8.replay.afternoon import clock

    slots = [drawn.Slot(clock(act.starts), act.name, act.outcome) for act in replay(part).acts]
    return drawn.afternoon(slots, f"The afternoon: {part}")
