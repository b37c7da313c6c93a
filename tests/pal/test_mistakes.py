"""What students write by mistake, in mistakes/: each source with the codes that name it, on its own line.
And in said.txt what is said of each, as it was read by eye: line, columns, code, message, advice, hint.

    SZA CMA     /! PN01         these codes, of errors or notes, and no other note

A `$` is added where there is none, but at the sources of "no end". No advice changes what a source means: it
names what to write, and never says to take a character away.
"""

from pathlib import Path

import pal
from pal.diagnostics import Diagnostic
from tests.conftest import case

FOLDER = Path(__file__).parent / "mistakes"
NO_END = ("no end", "a word before the end", "a condition without its end")


def mistakes(dialect: str) -> list[tuple[str, str]]:
    pieces = (FOLDER / f"{dialect}.txt").read_text().split("== ")[1:]
    return [(title, text) for title, _, text in (piece.partition("\n") for piece in pieces)]


def diagnosed(dialect: str, title: str, text: str) -> list[Diagnostic]:
    source = "\n".join(line.partition("/!")[0].rstrip() for line in text.splitlines()) + "\n"
    if title not in NO_END and "\n$" not in source:
        source += "$\n"
    return pal.assemble(source, dialect=dialect).diagnostics


CASES = [(dialect, *case) for dialect in ("pal3", "pal8") for case in mistakes(dialect)]


def test_there_are_enough() -> None:
    assert len(mistakes("pal3")) >= 45


def test_each_mistake_is_named_on_its_line() -> None:
    for dialect, title, text in CASES:
        with case(dialect, title, text):
            lines = text.splitlines()
            said = {
                number: sorted(line.partition("/!")[2].split())
                for number, line in enumerate(lines, 1)
                if "/!" in line
            }
            found: dict[int, list[str]] = {}
            for diagnostic in diagnosed(dialect, title, text):
                if dialect == "pal8" or diagnostic.code.startswith("PN"):
                    found.setdefault(diagnostic.line, []).append(diagnostic.code)
                assert "remove" not in diagnostic.advice
            assert {number: sorted(set(codes)) for number, codes in found.items()} == said


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
