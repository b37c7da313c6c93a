"""What the scan shows of each program and table, line by line, and the sources made from it.

One file an artefact, scan/NAME.txt, feeds sources, facsimiles and tables. A row is a line of it or the scan:

    page | class | scan | ours | reason
    107  | damaged | 0103 0040 PQ.40 | P0,40 | 0 and a comma misread; P0, beside P1

    scan    the scan's line, white space apart; ^ is one more line of ours from the row above; after ¦ is
            what the scan has elsewhere on the page
    ours    the line of the source without its layout and mark, `/` before a note; = is what `reading` reads

A blank line is one in the artefact, # opens a comment.

    class        the scan                                       mark in .pal     mark in .for, from column 73
    legible      shows it, by the six rules of `reading`
    damaged      shows it, with characters misread              /D               DAMAGED
    implied      (or the chapter) leaves no choice              /W or /R         RESTORED
    conjecture   does not settle it                             /C               CONJECTURE
    read         the same, settled by a look at the page (`collate`)
    ours         has no such line: a comment of ours
    none         has a line that does not belong to the listing: a heading, a page number, dirt

/W is implied by the word beside it, /R by a twin, a header or a pattern.
Source: the thesis, pages 13 and 14 (Chapter 2), 37 to 39 (4), 44 and 45 (5), 105 to 113 (Appendices B to D).
"""

from collections.abc import Iterator
from functools import cache
from typing import NamedTuple

import pal
from pdp8.thesis.collate import as_read
from pdp8.thesis.reading import fortran_line, pal_line
from pdp8.thesis.table import text_of
from tapes.errors import WorkError
from tapes.text import lines_of

ARTEFACTS = ("eia.pal", "eia1.pal", "eia2.pal", "circle.for", "ellipse.for")
TABLES = ("ch2-block", "2.3", "ch4-memory-reference", "ch4-microinstructions", "ch4-input-output")
CLASSES = ("legible", "damaged", "implied", "conjecture", "read", "ours", "none")

_AS_READ = "="
_PAL_MARKS = {"damaged": "/D", "conjecture": "/C"}
_FORTRAN_MARKS = {"damaged": "DAMAGED", "implied": "RESTORED", "conjecture": "CONJECTURE"}
_NOTE_COLUMN, _MARK_COLUMN, _PAL_NOTE_COLUMN, _TAB = 40, 72, 24, 8


class Row(NamedTuple):
    """A line of the artefact and what is known of it; a blank line is `BLANK`."""

    page: str
    kind: str
    scan: str
    ours: str
    reason: str

    @property
    def is_of_the_thesis(self) -> bool:
        """Whether the thesis has, or had, this line."""
        return self.kind not in ("ours", "none")


BLANK = Row("", "ours", "", "", "")


@cache
def rows(artefact: str) -> tuple[Row, ...]:
    """Return the rows of an artefact in order. Raises WorkError if there is none of that name."""
    if artefact not in ARTEFACTS + TABLES:
        raise WorkError(f"{artefact}: no evidence; there is some of {', '.join(ARTEFACTS + TABLES)}")
    text = text_of(f"scan/{artefact}.txt")
    return tuple(_row(line, artefact) for line in lines_of(text) if not line.startswith("#"))


def _row(line: str, artefact: str) -> Row:
    if not line:
        return BLANK
    row = Row(*(cell.strip() for cell in line.split("|")))
    return row._replace(ours=read(row.scan, artefact)) if row.ours == _AS_READ else as_read(row, artefact)


def read(scan: str, artefact: str) -> str:
    """Return what a legible line of the scan says, in the form of the column `ours`."""
    if artefact in TABLES:
        return scan.replace(" ¦", "").replace(" --- ", " ")
    return pal_line(scan)[1] if artefact.endswith(".pal") else fortran_line(scan.replace(" ¦", ""))


def source(artefact: str) -> str:
    """Return the artefact, the file of that name in programs/: every line laid out, with its mark."""
    lay_out = _pal_source if artefact.endswith(".pal") else _fortran_source
    lines = [lay_out(row).rstrip() for row in rows(artefact) if row.kind != "none"]
    return "".join(line + "\n" for line in lines)


def _pal_source(row: Row) -> str:
    if row.kind == "ours" or row.ours[0] in "/*":
        return row.ours
    statement, _, note = row.ours.partition(" /")
    tag, comma, rest = statement.rpartition(",")
    line = f"{tag}{comma}\t{rest.strip()}"
    mark = ("/W" if row.scan else "/R") if row.kind == "implied" else _PAL_MARKS.get(row.kind, "")
    said = f"{mark} {note}".strip()
    return line + "\t" * -((len(line.expandtabs(_TAB)) - _PAL_NOTE_COLUMN) // _TAB) + said if said else line


def _fortran_source(row: Row) -> str:
    statement, slash, note = row.ours.partition(" /")
    first, _, rest = statement.partition(" ")
    line = statement if rest[:1].isdigit() or first.endswith("C") else f"{first:<{_TAB}}{rest}"
    if slash:
        line = f"{line:<{_NOTE_COLUMN}}/{note}"
    return f"{line:<{_MARK_COLUMN - 1}} {_FORTRAN_MARKS.get(row.kind, '')}"


def table(artefact: str) -> Iterator[Row]:
    """Yield the rows that the thesis has; in a PAL program `ours` is address, word and source."""
    if not artefact.endswith(".pal"):
        yield from (row for row in rows(artefact) if row.is_of_the_thesis)
        return
    assembly = pal.assemble(source(artefact))
    addresses = (line.address for line in assembly.lines if line.address is not None)
    words = (f"{address:04o} {assembly.words[address]:04o}" for address in addresses)
    for row in rows(artefact):
        if row.is_of_the_thesis:
            statement = row.ours.partition(" /")[0]
            yield row._replace(ours=row.ours if row.ours[0] in "/*" else f"{next(words)} {statement}")
