"""The tables of evidence against the text of the scan; sources and docs/restoration.md against the tables.

ocr/ holds the scan's text of Appendices B, C and D unchanged, with headings and dirt.
"""

import re
from pathlib import Path

import pytest

import pal
from pdp8.thesis import edition, evidence
from pdp8.thesis.evidence import ARTEFACTS, CLASSES, Row, rows
from pdp8.thesis.reading import fortran_line, pal_line
from programs import circle
from tapes import shelf
from tapes.errors import WorkError
from tests.conftest import Shell

HERE = Path(__file__).parent
HOUSE = HERE.parents[2]
APPENDICES = {"eia.pal": "appendix-b", "circle.for": "appendix-c", "ellipse.for": "appendix-d"}
ASSEMBLY = pal.assemble(shelf.read("eia.pal"))


def scanned(artefact: str) -> str:
    """Return the scan's text of an appendix, every run of white space as one space."""
    return " ".join((HERE / "ocr" / f"{APPENDICES[artefact]}.txt").read_text().split())


def on_the_line(row: Row) -> str:
    return row.scan.partition(" ¦ ")[0]


def of(artefact: str, *classes: str) -> list[Row]:
    return [row for row in evidence.table(artefact) if row.kind in classes]


@pytest.mark.parametrize("artefact", ["eia.pal", "ellipse.for"])
def test_the_scan_column_is_the_scan_character_for_character(artefact: str) -> None:
    assert " ".join(row.scan for row in rows(artefact) if row.scan not in ("", "^")) == scanned(artefact)


def test_the_scan_column_is_the_scan_of_the_circle_but_for_the_notes_that_stand_apart() -> None:
    notes = [row.scan.partition(" ¦ ")[2] for row in rows("circle.for")]
    apart = " ".join(note for note in notes if note) + " "
    assert scanned("circle.for").count(apart) == 1
    lines = " ".join(on_the_line(row) for row in rows("circle.for") if row.scan)
    assert lines == scanned("circle.for").replace(apart, "")


@pytest.mark.parametrize("artefact", ARTEFACTS)
def test_the_sources_are_made_from_the_tables(artefact: str) -> None:
    made = evidence.source(artefact)
    assert (HOUSE / "programs" / artefact).read_text() == made, "run `make evidence`"


def test_the_page_is_made_from_the_tables() -> None:
    page = (HOUSE / "docs" / "restoration.md").read_text()
    assert edition.page(page) == page, "run `make evidence`"


@pytest.mark.parametrize("artefact", ARTEFACTS)
def test_every_row_has_a_class_and_every_change_its_reason(artefact: str) -> None:
    for row in rows(artefact):
        assert row.kind in CLASSES
        assert bool(row.reason) or row.kind in ("legible", "ours")


@pytest.mark.parametrize("artefact", ARTEFACTS)
def test_legible_lines_are_left_to_the_reading(artefact: str) -> None:
    text = (HOUSE / "pdp8" / "thesis" / "scan" / f"{artefact}.txt").read_text()
    for line in text.splitlines():
        cells = [cell.strip() for cell in line.split("|")]
        if not line.startswith("#") and len(cells) > 1:
            assert (cells[1] == "legible") == (cells[3] == "="), line


def test_a_word_that_is_legible_or_implies_its_source_is_the_word_assembled() -> None:
    for row in of("eia.pal", "legible", "implied"):
        digits, source = pal_line(row.scan)
        if digits:
            assert digits == row.ours[:4] + row.ours[5:9]
            assert row.kind == "implied" or source == row.ours[10:]


def test_a_damaged_word_is_not_called_legible() -> None:
    for row in of("eia.pal", "damaged"):
        digits, source = pal_line(row.scan)
        assert (digits, source.replace(" ", "")) != (
            row.ours[:4] + row.ours[5:9],
            row.ours[10:].replace(" ", ""),
        )


@pytest.mark.parametrize("artefact", ["circle.for", "ellipse.for"])
def test_a_damaged_line_is_not_called_legible(artefact: str) -> None:
    for row in of(artefact, "damaged"):
        assert fortran_line(row.scan.replace(" ¦", "")) != row.ours


def test_a_line_of_the_lost_page_repeats_the_line_its_reason_names() -> None:
    shape = {
        row.ours[:4]: re.sub(r"\b([PMN])(\d|SP|CR)\b", r"\1", row.ours[10:].rpartition(", ")[2])
        for row in evidence.table("eia.pal")
        if row.ours[:1] == "0"
    }
    lost = [row for row in evidence.table("eia.pal") if row.page == "106"]
    assert [int(row.ours[:4], 8) for row in lost] == list(range(0o256, 0o342))
    for row in lost:
        twin = row.reason[3:7]
        assert (int(row.ours[:4], 8) - int(twin, 8)) % 7 == 0
        assert shape[row.ours[:4]] == shape[twin]


def test_the_sixth_rule_moves_what_the_page_says() -> None:
    """Lines of Appendices C and D whose number stands behind; counted in the scan's own words."""
    legible = [
        row.scan.replace("*", "") for name in ("circle.for", "ellipse.for") for row in of(name, "legible")
    ]
    behind = [line for line in legible if re.match(r"(\. )?[A-Z].* [\dØ]{3}$", line)]
    before = [line for line in legible if re.match(r"/[A-Z ]+\d{3} ", line)]
    page = (HOUSE / "docs" / "restoration.md").read_text()
    said = re.search(r"to the end: (\d+) numbers and\s+one note", page)
    assert said
    assert (len(behind), len(before)) == (int(said[1]), 1)


@pytest.mark.parametrize("name", ["eia1.pal", "eia2.pal"])
def test_no_line_of_the_first_two_programs_is_said_to_survive(name: str) -> None:
    kinds = {row.kind for row in evidence.table(name)}
    assert kinds == {"implied", "conjecture"}
    assert not any(row.scan for row in rows(name))
    implied = [row.ours.split()[-2].rstrip(",") for row in of(name, "implied")]
    assert all(tag == "MASK" or tag[0] == "P" for tag in implied), "instructions are conjecture"


def test_the_radius_cannot_be_known_from_the_tape() -> None:
    printed = circle.part()
    for radius in (1745, 1746, 1755, 2000):
        assert circle.part(radius=radius, start_x=1750, inner=1745, outer=1755) == printed
    assert circle.part(radius=1744, start_x=1750, inner=1745, outer=1755) != printed


def test_what_has_no_evidence_is_refused() -> None:
    with pytest.raises(WorkError, match=r"bin\.pal: no evidence; there is some of eia\.pal"):
        rows("bin.pal")


def test_the_command_prints_a_line_of_the_table(shell: Shell) -> None:
    done = shell("pdp8 thesis evidence eia.pal | grep PQ.40")
    columns = done.stdout.decode().split("  ")
    assert [column.strip() for column in columns if column.strip()] == [
        "107",
        "damaged",
        "0103 0040 PQ.40",
        "0103 0040 P0,40",
        "0 and a comma misread; P0, beside P1",
    ]
