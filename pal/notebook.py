"""An assembly as a notebook shows it: the listing, wrong lines marked, and below it what is wrong."""

from collections.abc import Sequence
from html import escape

from pal.diagnostics import Diagnostic
from pal.listing import ListingLine

_STYLE = (
    "<style>.pal td { font-family: monospace; text-align: left; white-space: pre; padding: 0 1em 0 0 }"
    " .pal .wrong { background: #fbd9d3; color: #222 }</style>"
)


def html(lines: Sequence[ListingLine], names: Sequence[str], diagnostics: Sequence[Diagnostic]) -> str:
    """Return address, word and source of every line as an HTML table, then the diagnostics."""
    wrong = {(diagnostic.file, diagnostic.line) for diagnostic in diagnostics if diagnostic.error}
    rows = [_row(line, (names[line.tape], line.number) in wrong) for line in lines]
    said = "\n\n".join(map(str, diagnostics))
    below = f"<pre>{escape(said)}</pre>" if said else ""
    return f'{_STYLE}<table class="pal">{"".join(rows)}</table>{below}'


def _row(line: ListingLine, wrong: bool) -> str:
    numbers = ("" if number is None else f"{number:04o}" for number in (line.address, line.word))
    cells = "".join(f"<td>{escape(cell)}</td>" for cell in (*numbers, line.source.expandtabs()))
    state = "wrong" if wrong else "right"
    return f'<tr class="{state}">{cells}</tr>'
