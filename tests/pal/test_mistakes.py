"""What students write by mistake, in mistakes/; and in said.txt all that is said of each, as it was read by
eye: line, columns, code, message, advice, hint.

A `$` is added where there is none, but at "no end". No advice changes what a source means: it names what to
write, and never says to take a character away.
"""

from pathlib import Path

import pal
from pal.diagnostics import Diagnostic

FOLDER = Path(__file__).parent / "mistakes"


def mistakes(dialect: str) -> list[tuple[str, str]]:
    pieces = (FOLDER / f"{dialect}.txt").read_text().split("== ")[1:]
    return [(title, text) for title, _, text in (piece.partition("\n") for piece in pieces)]


def diagnosed(dialect: str, title: str, text: str) -> list[Diagnostic]:
    end = "" if title.startswith("no end") or "$" in text else "$\n"
    return pal.assemble(text + end, dialect=dialect).diagnostics


CASES = [(dialect, *case) for dialect in ("pal3", "pal8") for case in mistakes(dialect)]


def test_what_is_said_of_each_is_what_was_read() -> None:
    said = []
    for dialect, title, text in CASES:
        said.append(f"== {dialect} {title}")
        for found in diagnosed(dialect, title, text):
            place = f"{found.line}:{found.column}-{found.end_column}"
            said.append(
                " | ".join(filter(None, (place, found.code, found.message, found.advice, found.hint)))
            )
    assert said == (FOLDER / "said.txt").read_text().splitlines()
