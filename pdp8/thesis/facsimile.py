"""Listings B, C and D as they were on their pages; what the scan lost is supplied by us, in brackets.

    0244  1100  [N1,]    [TAD HOLD]       address, word and source, as PAL's third pass prints them
    335 30 FORMAT([I]3,[I]1,...)          line number, label, statement; the author's note in column 34

Zeros have the printer's slash. Pages end with their number and a form feed. Not kept: the places of blank
lines in Appendix B, which the scan does not show. Tags that are lost are ours (docs/restoration.md). Of the
numbers of these pages the scan has only 105.

Sources: the evidence; for the columns of the FORTRAN listings page 109, which the scan has with its layout.
"""

from collections.abc import Iterator
from itertools import groupby
from typing import Final

from pdp8.thesis.evidence import Row
from pdp8.thesis.supplied import NOTE, bracketed, marked
from tapes.errors import WorkError

HEADINGS: Final = {
    "B": ("eia.pal", "PAL PRINTOUT OF THE EIA CONVERSION PROGRAM"),
    "C": ("circle.for", "FORTRAN CIRCLE PROGRAM"),
    "D": ("ellipse.for", "FORTRAN ELLIPSE PROGRAM"),
}

_NUMBERED: Final = ("105",)
"""Pages whose number the scan shows."""

_WIDTH, _NOTE_COLUMN, _SOURCE_COLUMN, _TAB = 72, 33, 12, 8
_SLASHED = str.maketrans("0", "Ø")


def facsimile(appendix: str) -> str:
    """Return the text of an appendix. Raises WorkError for another than B, C or D."""
    if appendix.upper() not in HEADINGS:
        raise WorkError(f"{appendix}: no facsimile; there is one of {', '.join(HEADINGS)}")
    artefact, heading = HEADINGS[appendix.upper()]
    said = f"Facsimile of Appendix {appendix.upper()}, with nothing of ours but what it supplies. {NOTE}"
    why = f"`pdp8 thesis evidence {artefact}` has the scan, and the reason, of each line."
    title = f"{said}\n{why}\n\n{f'APPENDIX {appendix.upper()}':^{_WIDTH}}\n\n{heading:^{_WIDTH}}\n\n"
    set_line = _pal_line if artefact.endswith(".pal") else _fortran_line
    pages = []
    for page, rows in groupby(marked(artefact), key=lambda each: each[0].page):
        lines = "".join(f"{bracketed(line, lost)}\n" for row, lost in rows for line in set_line(row))
        number = page if page in _NUMBERED else f"[{page}]"
        pages.append(f"{lines.translate(_SLASHED)}\n{number:^{_WIDTH}}\n".replace(" \n", "\n"))
    return "\n".join(line.rstrip() for line in (title + "\f".join(pages)).split("\n"))


def _pal_line(row: Row) -> Iterator[str]:
    if row.ours[0] in "/*":
        yield from ("", " " * _SOURCE_COLUMN + row.ours, "")
        return
    address, word, source = row.ours.split(" ", 2)
    tag, comma, statement = source.rpartition(",")
    yield f"{address}  {word}  {f'{tag}{comma}':<{_TAB}}{statement.strip()}"


def _fortran_line(row: Row) -> Iterator[str]:
    statement, slash, note = row.ours.partition(" /")
    number, _, rest = statement.partition(" ")
    if number.endswith("C"):
        yield row.ours
        return
    line = f"{number} {rest}" if rest[0].isdigit() else f"{number}  {rest}"
    yield f"{line:<{_NOTE_COLUMN}}/{note}" if slash else line
