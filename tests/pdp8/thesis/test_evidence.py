"""The tables of evidence against the text of the scan; sources and docs/restoration.md against the tables."""

import re
from importlib.resources import files
from pathlib import Path

import pytest

import pal
import pdp8
from pdp8.thesis import evidence
from pdp8.thesis.evidence import ARTEFACTS, CLASSES, Row, rows
from pdp8.thesis.reading import fortran_line, pal_line
from programs import circle
from release import edition
from tapes import ascii
from tests.pdp8.thesis import scanned
from tests.reference import variants
from tests.reference.compiling import compiler

HOUSE = Path(__file__).parents[3]
RESTORATION = (HOUSE / "docs" / "restoration.md").read_text()
APPENDICES = {"eia.pal": "appendix-b", "circle.for": "appendix-c", "ellipse.for": "appendix-d"}


def of(artefact: str, *classes: str) -> list[Row]:
    return [row for row in evidence.table(artefact) if row.kind in classes]


@pytest.mark.parametrize("artefact", APPENDICES)
def test_the_scan_column_is_the_scan_but_for_the_circle_s_notes_that_stand_apart(artefact: str) -> None:
    scans = [row.scan.partition(" ¦ ") for row in rows(artefact) if row.scan not in ("", "^")]
    apart = "".join(f"{note} " for _, _, note in scans if note)
    before, found, after = scanned(APPENDICES[artefact]).partition(apart or "\0")
    assert bool(found) == bool(apart) == (artefact == "circle.for")
    assert " ".join(line for line, _, _ in scans) == before + after


@pytest.mark.parametrize("artefact", ARTEFACTS)
def test_the_sources_are_made_from_the_tables(artefact: str) -> None:
    made = evidence.source(artefact)
    assert (HOUSE / "programs" / artefact).read_text() == made, "run `make evidence`"


def test_the_page_is_made_from_the_tables() -> None:
    assert edition.page(RESTORATION) == RESTORATION, "run `make evidence`"


@pytest.mark.parametrize("artefact", ARTEFACTS)
def test_every_row_has_a_class_and_every_change_its_reason(artefact: str) -> None:
    for row in rows(artefact):
        assert row.kind in CLASSES
        assert bool(row.reason) or row.kind in ("legible", "ours")
    for line in files("pdp8.thesis").joinpath("scan", f"{artefact}.txt").read_text().splitlines():
        cells = [cell.strip() for cell in line.split("|")]
        if not line.startswith("#") and len(cells) > 1:
            assert (cells[1] == "legible") == (cells[3] == "="), "legible lines are left to the reading"


def test_a_line_of_b_is_called_what_reading_it_beside_its_word_makes_of_it() -> None:
    for row in of("eia.pal", "legible", "implied", "damaged"):
        digits, source = pal_line(row.scan)
        as_assembled = digits == row.ours[:4] + row.ours[5:9]
        as_ours = source.replace(" ", "") == row.ours[10:].replace(" ", "")
        match row.kind:
            case "legible":
                assert not digits or (as_assembled and as_ours), row
            case "implied":
                assert not digits or as_assembled, row
            case _:
                assert not (as_assembled and as_ours), row


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
    (said,) = re.findall(r"to the end: (\d+) numbers and\s+one note", RESTORATION)
    assert (len(behind), len(before)) == (int(said), 1)


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


@pytest.mark.skipif(compiler() is None, reason="no C compiler is installed")
@pytest.mark.slow("tries 536,445 changes of the conversion program, in C: 2 s")
def test_no_other_words_would_do_the_same_work() -> None:
    assert variants.FILE.read_text() == variants.lines(), "run `make evidence`"


def test_the_space_s_word_is_the_one_conjecture_of_b_and_changes_no_position() -> None:
    """TAD MSP for TAD P0 changes 2,789 frames of the circle's tape, none of which the head sees otherwise."""
    (row,) = of("eia.pal", "conjecture")
    assert row.ours == "0340 1103 TAD P0"
    words = dict(pal.assemble(evidence.source("eia.pal")).words)
    tapes = []
    for word in (words[0o340], 0o1127):
        machine = pdp8.Machine()
        machine.load(words | {0o340: word})
        machine.start(0o200)
        machine.teletype.reader.load(ascii.encode(circle.part()))
        machine.run()
        tapes.append(machine.teletype.punch.tape)
    assert sum(one != other for one, other in zip(*tapes, strict=True)) == 2789
    assert [frame & 0o217 for frame in tapes[0]] == [frame & 0o217 for frame in tapes[1]]
    assert "2,789 frames" in RESTORATION
