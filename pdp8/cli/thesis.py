"""`pdp8 thesis`: the thesis's programs line by line, and its figures, tables and listings reproduced."""

import os
import re
import sys
from pathlib import Path
from typing import TYPE_CHECKING, Final

import click

from pdp8 import shelf
from pdp8.cli.shared import command, extras
from pdp8.cli.shared.arguments import Command, Folder, Group, Source, Target, output
from pdp8.cli.shared.rules import flag, option
from tapes.errors import TapeError, naming
from tapes.text import without_mark

if TYPE_CHECKING:
    from pdp8.thesis.table import Table

_EVIDENCE: Final = ("page", "evidence", "scan", "ours", "reason")
_CATALOGUE: Final = ("number", "page", "kind", "state", "title")
_STYLES: Final = {
    "damaged": "yellow",
    "implied": "cyan",
    "conjecture": "red",
    "conjectured": "red",
    "our drawing": "cyan",
    "fitted or conjectured": "yellow",
    "lost": "red",
    "differs": "red",
}


_COLUMN = 16
"""Characters of a terminal for each column of a table; in a narrower one each row is a paragraph."""


@click.group(cls=Group)
def thesis() -> None:
    """The thesis, page by page: its figures, tables and listings reproduced, its programs line by line.

    \b
    Examples:
      pdp8 thesis list
      pdp8 thesis make 7.2 --out figures
      pdp8 thesis make all --out figures
      pdp8 thesis evidence eia.pal
      pdp8 thesis numbers --chapter 7
      pdp8 thesis collate --letter
      pdp8 thesis page -o curve.html
    """


@thesis.command(cls=Command)
@output(Target("HTML"), "PAGE", "curve.html", "The page.", show_default=True)
def page(output: str) -> None:
    """Write "A curve in ten minutes": a page that teaches the thesis's method with live figures.

    Slope, band, steps, circle, tape, translation, roundness: each figure runs the programs and machines
    themselves. The page needs no network: a browser opens it from disk. The tape of a curve that you draw
    opens in pdp8.html beside it, the page that pdp8 workbench writes.

    \b
    Examples:
      pdp8 thesis page
      pdp8 thesis page -o lesson.html
    """
    from pdp8.web import curve

    command.put(output, curve.page())


@thesis.command("numbers")
@option("--chapter", "Only the numbers of one chapter.", click.IntRange(1, 10), metavar="NUMBER")
@output(Target("text"))
def numbers_(chapter: int | None, output: str) -> None:
    """List every number of the thesis: page, words, ours, its state, and what makes it.

    A number is from the text (the software takes it as a constant), computed, fitted or conjectured; or ours
    differs from it; or nothing here makes it. "Made by" is a figure or table, a command, or a page of docs/.

    \b
    Examples:
      pdp8 thesis numbers
      pdp8 thesis numbers --chapter 7
      pdp8 thesis numbers | grep differs
    """
    from pdp8.thesis.numbers import table

    _show(table(chapter), "The thesis's numbers", coloured_by=4, output=output)


@thesis.command()
@click.argument("number", metavar="NUMBER|all", required=False)
@output(Folder(), "FOLDER", "thesis", "Where the files are written.", show_default=True)
@flag("--facsimile", "Listing B, C or D as it stood on its pages; in brackets what we supply.")
def make(number: str | None, output: str, facsimile: bool) -> None:
    """Make figure, table, listing or program NUMBER; or all, with a page that sets them beside the thesis.

    A figure is an SVG, anything else a text; each has its number and caption. A facsimile has the thesis's
    lines alone, as they stood on its pages; what the scan does not show of them is supplied, in brackets.

    \b
    Examples:
      pdp8 thesis make 7.2
      pdp8 thesis make B --facsimile
      pdp8 thesis make all --out figures
    """
    from pdp8.cli.shared.progress import Bar
    from pdp8.thesis.catalogue import catalogue, find
    from pdp8.thesis.making import Made, make

    if number is None:
        raise click.UsageError("give a NUMBER, or all; pdp8 thesis list has the numbers.")
    if facsimile:
        from pdp8.thesis import facsimile as page

        text = page.facsimile(number)
        command.put_all(output, [(f"facsimile-{number.upper()}.txt", text.encode())])
        return
    whole = number == "all"
    items = [item for item in catalogue() if item.maker] if whole else [find(number)]
    made: dict[str, Made] = {}
    with Bar("figures", len(items)) as bar:
        for item in items:
            made[item.number] = make(item)
            bar.show(len(made))
    files = dict(file for one in made.values() for file in one.files)
    if whole:
        from pdp8.thesis import gallery

        files["index.html"] = gallery.page(made).encode()
    command.put_all(output, files.items())
    if whole:
        command.tell(f"begin with {os.path.join(output, 'index.html')}")


@thesis.command("list", cls=Command)
def list_() -> None:
    """List every figure, table, listing and program of the thesis with what there is of it here.

    It is from the text; or our drawing of what the text says, where the original is lost; or some of it is
    fitted or conjectured; or it is lost.

    \b
    Examples:
      pdp8 thesis list
      pdp8 thesis list | grep lost
    """
    from pdp8.thesis.catalogue import catalogue
    from pdp8.thesis.table import Table

    rows = tuple((item.number, str(item.page), item.kind, item.state, item.title) for item in catalogue())
    _show(Table(_CATALOGUE, rows), "The thesis", coloured_by=3)


@thesis.command()
@click.argument("file", metavar="FILE")
@flag("--tei", "Write it as TEI, for editors: what is supplied, with the reason.")
@output(Target("text"))
def evidence(file: str, tei: bool, output: str) -> None:
    """Show for every line of FILE the page, the scan's reading, ours, its evidence and the reason.

    FILE is eia.pal, eia1.pal, eia2.pal, circle.for or ellipse.for, or a table: ch2-block, 2.3,
    ch4-memory-reference, ch4-microinstructions or ch4-input-output. A line is legible, damaged, implied (by a
    word, a twin, a header) or a conjecture; ^ is one more line of ours from the scan's line above.

    \b
    Examples:
      pdp8 thesis evidence eia.pal
      pdp8 thesis evidence circle.for | grep conjecture
      pdp8 thesis evidence eia.pal --tei > eia.xml
    """
    from pdp8.thesis import evidence as known
    from pdp8.thesis.table import Table

    if tei:
        from pdp8.thesis.tei import tei as document

        command.put(output, document(file))
        return
    rows = tuple((row.page, row.kind, row.scan, row.ours, row.reason) for row in known.table(file))
    _show(Table(_EVIDENCE, rows), file, coloured_by=1, output=output)


@thesis.command()
@click.argument("answers", type=Source(), metavar="[ANSWERS]", required=False)
@flag("--letter", "Write a letter to a library that has the thesis.", excludes="--pages ANSWERS")
@option(
    "--pages",
    "Pictures of pages, 106.png or page-106.png: say where on them the lines are.",
    click.Path(exists=True, file_okay=False),
    metavar="FOLDER",
)
@output(Target("text"))
def collate(answers: str | None, letter: bool, pages: str | None, output: str) -> None:
    """List what a rescan of the thesis would settle: place, our reading, rivals, what each would change.

    ANSWERS is a file with a line for each place that somebody has looked up, NAME | WHAT THE PAGE HAS | WHO
    LOOKED, WHERE, WHEN; the list then says which readings are settled and what the others change. The same
    lines in pdp8/thesis/scan/answers.txt, and `make evidence`, take them into the sources and tables.

    \b
    Examples:
      pdp8 thesis collate
      pdp8 thesis collate --letter > letter.txt
      pdp8 thesis collate --pages scans
      pdp8 thesis collate answers.txt
    """
    from pdp8.thesis import collate as known

    if letter:
        command.put(output, known.letter())
        return
    text = without_mark(shelf.read(answers)).decode("utf-8", "replace") if answers else ""
    with naming(answers or ""):
        given = known.answers(text)
    places = _places(pages) if pages else {}
    _show(known.table(given, places), "What a rescan would settle", coloured_by=4, output=output)


def _places(folder: str) -> dict[str, str]:
    """Return, by name, where the lines of conjectures are on the pictures in a folder."""
    from pdp8.thesis import collate as known

    pictures = []
    for file in sorted(Path(folder).glob("*.png")):
        number = re.search(r"(\d+)\.png$", file.name)
        page = str(int(number[1])) if number else ""
        pictures += [(file, each) for each in known.conjectures().values() if each.page == page]
    if not pictures:
        raise TapeError(f"{folder}: no picture of a page on the list; one is called 106.png or page-106.png")
    extras.need("cv2", "vision", "reading a picture needs OpenCV")
    from pdp8.thesis import pages

    places = {}
    for file, each in pictures:
        top, last, sure = pages.find(each, file.read_bytes()) or (0, 0, True)
        rows = f"rows {top} to {last} of pixels" if last else "the whole page"
        places[each.name] = f"; {file.name}: {'' if sure else 'by its number among the lines, about '}{rows}"
    return places


def _show(table: "Table", title: str, coloured_by: int, output: str = "-") -> None:
    """Print a table, coloured by one column at a terminal, else as plain text."""
    if output != "-" or not sys.stdout.isatty():
        command.put(output, table.text())
        return
    from rich.console import Console
    from rich.markup import escape
    from rich.padding import Padding
    from rich.table import Table as Shown

    console, shown = Console(), Shown(*table.headings, title=title)
    narrow = console.width < _COLUMN * len(table.headings)
    for row in table.rows:
        style = _STYLES.get(row[coloured_by])
        if narrow:  # a row is a paragraph
            first, second, *more = map(escape, row)
            console.print(f"{first}  {second}", style=style, highlight=False)
            cells = [f"{name}: {cell}" for name, cell in zip(table.headings[2:], more, strict=True) if cell]
            console.print(Padding("; ".join(cells), (0, 0, 0, 4)), style=style, highlight=False)
        else:
            shown.add_row(*map(escape, row), style=style)
    if not narrow:
        console.print(shown)
