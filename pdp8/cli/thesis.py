"""`pdp8 thesis`: the thesis's programs line by line, and its figures, tables and listings made again."""

import sys
from typing import TYPE_CHECKING

import click

from tapes import shelf

if TYPE_CHECKING:
    from pdp8.thesis.evidence import Row

_HEADINGS = ("page", "evidence", "scan", "ours", "reason")


@click.group(context_settings={"help_option_names": ["-h", "--help"]})
def thesis() -> None:
    """The thesis, page by page: what the scan shows, and what was made again.

    \b
    Examples:
      pdp8 thesis evidence eia.pal
      pdp8 thesis evidence circle.for --source -o circle.for
    """


@thesis.command()
@click.argument("file", metavar="FILE")
@click.option("--source", "as_source", is_flag=True, help="Make FILE itself, as it is in programs/.")
@click.option("-o", "--output", metavar="FILE", default="-", help="Where to; standard output if not given.")
def evidence(file: str, as_source: bool, output: str) -> None:
    """Show for every line of FILE the page, the scan's reading, ours, its evidence and the reason.

    FILE is eia.pal, eia1.pal, eia2.pal, circle.for or ellipse.for. A line is legible, damaged, implied (by a
    word, a twin, a header) or a conjecture; ^ is one more line of ours from the scan's line above.

    \b
    Examples:
      pdp8 thesis evidence eia.pal
      pdp8 thesis evidence circle.for | grep conjecture
      pdp8 thesis evidence eia.pal --source -o eia.pal
    """
    from pdp8.thesis import evidence as known

    if as_source:
        shelf.write(output, known.source(file).encode())
    elif output == "-" and sys.stdout.isatty():
        _show(file, list(known.table(file)))
    else:
        shelf.write(output, _plain(list(known.table(file))).encode())


def _cells(row: "Row") -> tuple[str, str, str, str, str]:
    return row.page, row.kind, row.scan, row.ours, row.reason


def _plain(rows: "list[Row]") -> str:
    """Return the rows as columns of text, two spaces between them."""
    lines = [_HEADINGS, *map(_cells, rows)]
    widths = [max(len(line[column]) for line in lines) for column in range(len(_HEADINGS))]
    return "".join(
        "  ".join(f"{cell:{width}}" for cell, width in zip(line, widths, strict=True)).rstrip() + "\n"
        for line in lines
    )


def _show(file: str, rows: "list[Row]") -> None:
    """Print the rows as a table, each class in its colour."""
    from rich.console import Console
    from rich.markup import escape
    from rich.table import Table

    styles = {"damaged": "yellow", "implied": "cyan", "conjecture": "red"}
    shown = Table(title=file)
    for heading in _HEADINGS:
        shown.add_column(heading)
    for row in rows:
        shown.add_row(*map(escape, _cells(row)), style=styles.get(row.kind))
    Console().print(shown)
