"""What is made of an assembly besides: JSON for other programs, HTML for a notebook.

    {"words": {"0200": "7200", ...}, "symbols": {"A": "0200", ...},
     "lines": [{"file": "a.pal", "line": 2, "address": "0200", "word": "7200", "source": "A,\\tCLA"}, ...],
     "diagnostics": [{"code": "IR", "message": ..., "file": ..., "line": ..., "column": ..., ...}]}

Words and addresses are octal, as text; addresses beyond 7777 have the field as fifth digit.
"""

import json
from collections.abc import Mapping, Sequence
from html import escape
from typing import TYPE_CHECKING, Protocol

if TYPE_CHECKING:
    from pal.diagnostics import Diagnostic
    from pal.listing import ListingLine


class Reported(Protocol):
    """What a report needs to know about an assembly."""

    @property
    def names(self) -> Sequence[str]: ...
    @property
    def words(self) -> Mapping[int, int]: ...
    @property
    def symbols(self) -> Mapping[str, int]: ...
    @property
    def lines(self) -> "Sequence[ListingLine]": ...
    @property
    def diagnostics(self) -> "Sequence[Diagnostic]": ...


_STYLE = (
    "<style>.pal td { font-family: monospace; text-align: left; white-space: pre; padding: 0 1em 0 0 }"
    " .pal .wrong { background: #fbd9d3; color: #222 }</style>"
)


def as_json(assembly: Reported) -> str:
    """Return the assembly as a JSON text."""
    content = {
        "words": {f"{address:04o}": f"{word:04o}" for address, word in assembly.words.items()},
        "symbols": {name: f"{value:04o}" for name, value in assembly.symbols.items()},
        "lines": [
            {
                "file": assembly.names[line.tape],
                "line": line.number,
                "address": None if line.address is None else f"{line.address:04o}",
                "word": None if line.word is None else f"{line.word:04o}",
                "source": line.source,
            }
            for line in assembly.lines
        ],
        "diagnostics": [diagnostic._asdict() for diagnostic in assembly.diagnostics],
    }
    return json.dumps(content, indent=1) + "\n"


def html(assembly: Reported) -> str:
    """Return the listing as an HTML table, wrong lines marked, and below it what is wrong."""
    wrong = {(found.file, found.line) for found in assembly.diagnostics if found.error}
    rows = []
    for line in assembly.lines:
        numbers = ("" if number is None else f"{number:04o}" for number in (line.address, line.word))
        cells = "".join(f"<td>{escape(cell)}</td>" for cell in (*numbers, line.source.expandtabs()))
        state = "wrong" if (assembly.names[line.tape], line.number) in wrong else "right"
        rows.append(f'<tr class="{state}">{cells}</tr>')
    said = "\n\n".join(map(str, assembly.diagnostics))
    below = f"<pre>{escape(said)}</pre>" if said else ""
    return f'{_STYLE}<table class="pal">{"".join(rows)}</table>{below}'
