"""The tables of docs/restoration.md, and the sources in programs/, made from the evidence.

    <!-- evidence eia.pal 105 106 107 -->     the rows of these pages; and of these classes, if any are named
    <!-- end -->                              what stands between the two is replaced

`make evidence` runs this as a program, in the project's folder.
"""

import re
from pathlib import Path

from pdp8.thesis.evidence import ARTEFACTS, CLASSES, Row, source, table

PAGE = Path("docs/restoration.md")
_SECTION = re.compile(r"(<!-- evidence (\S+) ([\w ]+) -->\n).*?(<!-- end -->)", re.DOTALL)
_HEADING = "| page | the scan | ours | evidence | reason |\n|--:|---|---|---|---|\n"


def page(text: str) -> str:
    """Return `text` with every table in it made again."""
    return _SECTION.sub(lambda found: found[1] + _table(found[2], found[3].split()) + found[4], text)


def _table(artefact: str, wanted: list[str]) -> str:
    classes = [word for word in wanted if word in CLASSES] or CLASSES
    lines = [_line(row) for row in table(artefact) if row.page in wanted and row.kind in classes]
    return _HEADING + "".join(lines)


def _line(row: Row) -> str:
    cells = (row.page, _code(row.scan), _code(row.ours), row.kind, row.reason)
    return "| " + " | ".join(cells) + " |\n"


def _code(text: str) -> str:
    return f"`{text}`" if text else ""


def main() -> None:
    """Write the page and the sources again."""
    PAGE.write_text(page(PAGE.read_text()))
    for artefact in ARTEFACTS:
        Path("programs", artefact).write_text(source(artefact))


if __name__ == "__main__":
    main()
