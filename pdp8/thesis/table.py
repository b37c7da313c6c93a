"""A table, as text in columns or as cells; and the rows of this package's own tables.

name | page | where        a row of a file of this package; # opens a comment
"""

from collections.abc import Iterator
from importlib.resources import files
from typing import NamedTuple

from tapes.text import lines_of


class Table(NamedTuple):
    """Headings and rows of cells."""

    headings: tuple[str, ...]
    rows: tuple[tuple[str, ...], ...]

    def text(self) -> str:
        """Return the table in columns, two spaces between them."""
        lines = [self.headings, *self.rows]
        widths = [max(len(line[column]) for line in lines) for column in range(len(self.headings))]
        return "".join(
            "  ".join(f"{cell:{width}}" for cell, width in zip(line, widths, strict=True)).rstrip() + "\n"
            for line in lines
        )


def text_of(name: str) -> str:
    """Return the text of a file of this package."""
    return files("pdp8.thesis").joinpath(name).read_text(encoding="utf-8")


def cells(text: str) -> Iterator[list[str]]:
    """Yield the cells of each row of a file's text."""
    for line in lines_of(text):
        if not line.startswith("#"):
            yield [cell.strip() for cell in line.split("|")]
