"""The catalogue against the text of the scan: what it numbers, its words and its tables.

ocr/mentions.txt has every paragraph that names a figure, a table, an appendix or a program by number, or from
which the catalogue quotes; ocr/tables.txt the tables.
"""

import re

import pytest

from pdp8.thesis import tables
from pdp8.thesis.catalogue import STATES, Item, catalogue, find
from pdp8.thesis.evidence import rows
from tests.pdp8.thesis import OCR, scanned

MENTIONS = scanned("mentions")
CONTENTS = (OCR / "mentions.txt").read_text().partition("\n\n")[0]
STARTS = [int(page) for page in re.findall(r" (\d+)(?=\s|$)", CONTENTS)]
"""The first page of each chapter, and of what follows, from the scan's table of contents."""


CHAPTER_2 = scanned("numbers")


def scanned_lines(first: str, last: str) -> list[list[str]]:
    """Return the cells of the scan's tables from the line that begins with `first` to that with `last`."""
    lines = (OCR / "tables.txt").read_text().splitlines()
    start = next(number for number, line in enumerate(lines) if line.startswith(first))
    end = next(number for number, line in enumerate(lines) if number >= start and line.startswith(last))
    return [line.split("\t") for line in lines[start : end + 1]]


@pytest.mark.parametrize(
    ("listed", "pattern"),
    [
        (r"figure-(\d.*)", r"F(?:igure|IGURE) (\d+\.\d)"),
        (r"table-(\d.*)", r"T(?:able|ABLE) (\d+\.\d)"),
        (r"listing-(.*)", r"A(?:ppendix|PPENDIX) ([B-D])\b"),  # Appendix A, an essay, lists nothing
        (r"program-ch5-(.*)", r"Program \(([12])\)"),  # the third is Appendix B
    ],
)
def test_everything_the_thesis_names_is_listed(listed: str, pattern: str) -> None:
    found = [re.fullmatch(listed, item.stem) for item in catalogue()]
    assert {each[1] for each in found if each} == set(re.findall(pattern, MENTIONS))


@pytest.mark.parametrize("item", catalogue(), ids=lambda item: item.number)
def test_an_item_is_whole_its_words_are_the_thesis_s_and_its_page_lies_in_its_chapter(item: Item) -> None:
    assert item.says in MENTIONS
    assert item.kind in ("figure", "table", "listing", "program")
    assert item.state in STATES
    assert item.title
    assert item.note.endswith(".")
    assert bool(item.maker) == (item.state != "lost")
    assert item.caption.startswith(f"Page {item.page}. ")
    if item.chapter.isdigit():
        assert item.page in range(*STARTS[int(item.chapter) - 1 : int(item.chapter) + 1])
    else:
        assert item.page == {"B": 105, "C": 108, "D": 111}[item.number]


def test_an_item_is_found_by_its_number() -> None:
    assert find("8.4").page == find("8.5").page == 85  # the scan numbers this page
    assert len({item.number.casefold() for item in catalogue()}) == len(catalogue())


def test_table_2_4_is_the_scan_s() -> None:
    shown = [[float(cell.strip(" ._")) for cell in line] for line in scanned_lines("01\t", "18\t")]
    assert [[float(cell) for cell in row] for row in tables.rates().rows] == shown


def test_table_2_3_and_the_block_are_in_the_scan_s_words() -> None:
    """Whatever is not in brackets, but for the table's dashes and where the 20th digit's words stand."""
    text = scanned("tables").replace(" ---", "").replace("- ", "")
    for code, what in tables.functions().rows:
        assert f"{code} {what}".strip() in text
    assert len(tables.functions().rows) == 2 + len(
        re.findall(r"(\d+) [A-Z\"]", text.partition("TABLE 2.3")[0])
    )
    for digits, what in tables.block_format().rows:
        for words in (f"{digits}:", *re.split(r"\[.*?\]", what)):
            assert words in CHAPTER_2


@pytest.mark.parametrize(
    ("kind", "first", "last"),
    [
        ("memory-reference", "Logical AND", "Jump\t"),
        ("microinstructions", "Clear the Accumulator", "Halt"),
        ("input-output", "Skip if Keyboard", "Load Printer"),
    ],
)
def test_the_instructions_are_those_of_chapter_4(kind: str, first: str, last: str) -> None:
    """In the scan's words; and each value is what the assembler makes of the mnemonic."""
    lines = [" ".join(cells) for cells in scanned_lines(first, last)]
    assert [row.scan for row in rows(f"ch4-{kind}")] == lines
    for _, mnemonic, value in tables.instructions(f"ch4-{kind}").rows:
        word = tables.word(f"{mnemonic} 0") >> 9 if len(value) == 1 else tables.word(mnemonic)
        assert int(value, 8) == word


@pytest.mark.slow("cuts all parts of the table, by both techniques")
def test_the_thesis_s_figures_of_table_10_1_are_the_scan_s() -> None:
    shown = [
        [found[0] for cell in cells[1:] if (found := re.match(r"\d+", cell))]
        for cells in scanned_lines('4" DIA', "FLUIDIC")
    ]
    made: list[list[str]] = []
    for part, _, *figures in tables.comparison().rows:
        made += [[]] if part else []
        made[-1] += [figures[place] for place in (0, 3, 5)]
    assert made == shown
