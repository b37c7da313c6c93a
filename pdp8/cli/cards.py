"""`pdp8 cards`: cards to print and lay beside the machine."""

from collections.abc import Iterable
from importlib.util import find_spec
from io import BytesIO

import click

from pdp8.cli import command
from pdp8.cli.arguments import Command, Folder, output
from pdp8.lessons import cards as drawn
from tapes.errors import WorkError

_AFTERNOON = "afternoon"
_PART = "circle"
_A4 = 841.89, 595.28
"""Points, the long side across."""
_NAMES = (*drawn.CARDS, _AFTERNOON)


@click.command(cls=Command)
@click.argument("names", nargs=-1, type=click.Choice([*_NAMES, "all"]), metavar="NAME...")
@output(Folder(), "FOLDER", ".", "Where to.  [default: this folder]")
@click.option(
    "--pdf", is_flag=True, help="Write all into cards.pdf, a page each; needs CairoSVG, the extra `print`."
)
def cards(names: tuple[str, ...], output: str, pdf: bool) -> None:
    """Draw cards of A4, NAME.svg each: rim, instructions, ascii, eia, afternoon, or all.

    The afternoon's timetable is that of `pdp8 replay circle`.

    \b
    Examples:
      pdp8 cards all
      pdp8 cards rim instructions --out handout
      pdp8 cards all --pdf --out handout
    """
    if not names:
        raise click.UsageError(f"Give a card's name: {', '.join(_NAMES)}, or all.")
    if pdf and find_spec("cairosvg") is None:
        from pdp8.cli.extras import hint

        raise WorkError(f"PDF needs CairoSVG: {hint('print')}; a browser prints the SVG as well")
    wanted = _NAMES if "all" in names else dict.fromkeys(names)
    svgs = {name: _afternoon() if name == _AFTERNOON else drawn.CARDS[name]() for name in wanted}
    if pdf:
        command.put_all(output, [("cards.pdf", _pdf(svgs.values()))])
    else:
        command.put_all(output, ((f"{name}.svg", svg.encode()) for name, svg in svgs.items()))


def _pdf(svgs: Iterable[str]) -> bytes:
    import cairocffi  # type: ignore[import-untyped]
    from cairosvg.parser import Tree  # type: ignore[import-untyped]
    from cairosvg.surface import PDFSurface  # type: ignore[import-untyped]

    written = BytesIO()
    pages = cairocffi.PDFSurface(written, *_A4)

    class Page(PDFSurface):  # type: ignore[misc]
        """A page of the one file that all share."""

        def _create_surface(self, width: float, height: float) -> tuple[object, float, float]:
            return pages, width, height

    for svg in svgs:
        Page(Tree(bytestring=svg.encode()), None, 96)
        pages.show_page()
    pages.finish()
    return written.getvalue()


def _afternoon() -> str:
    from pdp8.replay import replay
    from pdp8.replay.day import clock

    slots = [(clock(act.starts), act.name, act.outcome) for act in replay(_PART).acts]
    return drawn.afternoon(slots, f"The afternoon: {_PART}")
