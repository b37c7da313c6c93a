"""The catalogue against the text of the scan: what it numbers, its words and its tables.

ocr/mentions.txt has every paragraph that names a figure, a table, an appendix or a program by number, or from
which the catalogue quotes; ocr/tables.txt the tables. Both are the scan's text, unchanged.
"""

import re
from pathlib import Path

import pytest

from pdp8.thesis import tables
from pdp8.thesis.catalogue import STATES, Item, catalogue, find
from tapes.errors import WorkError

OCR = Path(__file__).parent / "ocr"
MENTIONS = " ".join((OCR / "mentions.txt").read_text().split())
items = pytest.mark.parametrize("item", catalogue(), ids=lambda item: item.number)


def numbers(pattern: str) -> set[str]:
    return set(re.findall(pattern, MENTIONS))


def scanned_lines(first: str, last: str) -> list[list[str]]:
    """Return the cells of the scan's tables from the line that begins with `first` to that with `last`."""
    lines = (OCR / "tables.txt").read_text().splitlines()
    start = next(number for number, line in enumerate(lines) if line.startswith(first))
    end = next(number for number, line in enumerate(lines) if number >= start and line.startswith(last))
    return [line.split("\t") for line in lines[start : end + 1]]


@pytest.mark.parametrize(
    ("kind", "pattern"),
    [
        ("figure", r"F(?:igure|IGURE) (\d+\.\d)"),
        ("table", r"T(?:able|ABLE) (\d+\.\d)"),
        ("listing", r"A(?:ppendix|PPENDIX) ([B-D])\b"),  # Appendix A, an essay, lists nothing
    ],
)
def test_everything_the_thesis_names_is_listed(kind: str, pattern: str) -> None:
    listed = {item.number for item in catalogue() if item.kind == kind and not item.number.startswith("ch")}
    assert listed == numbers(pattern)


def test_every_program_of_chapter_5_is_listed() -> None:
    own = {item.number[-1] for item in catalogue() if item.number.startswith("ch5-")}
    assert own | {"3"} == numbers(r"Program \((\d)\)")  # the third is Appendix B


@items
def test_an_item_is_whole_and_its_words_are_the_thesis_s(item: Item) -> None:
    assert item.says in MENTIONS
    assert item.kind in ("figure", "table", "listing", "program")
    assert item.state in STATES
    assert item.title
    assert item.note.endswith(".")
    assert bool(item.maker) == (item.state != "lost")


def chapter_starts() -> dict[str, int]:
    """Return the first page of each chapter, and 11 for what follows, from the scan's table of contents."""
    contents = (OCR / "mentions.txt").read_text().partition("\n\n")[0]
    starts = map(int, re.findall(r" (\d+)(?=\s|$)", contents))
    return {str(number): page for number, page in enumerate(starts, 1)} | {"B": 105, "C": 108, "D": 111}


@items
def test_a_page_lies_in_its_chapter(item: Item) -> None:
    starts = chapter_starts()
    if item.chapter.isdigit():
        assert starts[item.chapter] <= item.page < starts[str(int(item.chapter) + 1)]
    else:
        assert item.page == starts[item.number]
    assert item.caption.startswith(f"Page {item.page}. ")


def test_an_item_is_found_by_its_number() -> None:
    assert find("8.4").page == find("8.5").page == 85  # the scan numbers this page
    assert len({item.number.casefold() for item in catalogue()}) == len(catalogue())
    with pytest.raises(WorkError, match=r"7\.9: no such figure"):
        find("7.9")


def test_table_2_4_is_the_scan_s() -> None:
    shown = [[float(cell.strip(" ._")) for cell in line] for line in scanned_lines("01\t", "18\t")]
    assert [[float(cell) for cell in row] for row in tables.rates().rows] == shown


def test_the_codes_of_table_2_3_are_the_scan_s() -> None:
    text = (OCR / "tables.txt").read_text().partition("TABLE 2.3")[0]
    shown = re.findall(r"(\d+) (?:--- )?[A-Z\"]", text)
    assert [row[1] for row in tables.functions().rows] == shown


@pytest.mark.parametrize(
    ("kind", "first", "last"),
    [
        ("memory reference", "Logical AND", "Jump\t"),
        ("microinstructions", "Clear the Accumulator", "Halt"),
        ("input-output", "Skip if Keyboard", "Load Printer"),
    ],
)
def test_the_instructions_are_those_of_chapter_4(kind: str, first: str, last: str) -> None:
    shown = [(cells[1].split()[-1], cells[2]) for cells in scanned_lines(first, last)]
    assert [row[1:] for row in tables.instructions(kind).rows] == shown


@pytest.mark.slow("cuts all parts of the table, by both techniques")
def test_the_thesis_s_figures_of_table_10_1_are_the_scan_s() -> None:
    shown = [
        [found[0] for cell in cells[1:] if (found := re.match(r"\d+", cell))]
        for cells in scanned_lines('4" DIA', "FLUIDIC")
    ]
    made: list[list[str]] = []
    for part, _, *figures in tables.comparison().rows:
        made += [[]] if part else []
        made[-1] += figures[:-1:2]
    assert made == shown
