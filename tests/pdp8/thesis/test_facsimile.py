"""The facsimiles are listings: they assemble, compile and run, and have nothing of ours on them."""

import re
import shutil
from pathlib import Path

import pytest

import pal
from pdp8.thesis.facsimile import facsimile
from programs import circle, ellipse
from tests.pdp8.thesis import OCR, scanned
from tests.programs.fortran import printout

B = [line.replace("Ø", "0") for line in facsimile("B").replace("\f", "").splitlines()]


def test_the_source_column_of_b_assembles_to_its_word_column() -> None:
    printed = {int(line[:4], 8): int(line[6:10], 8) for line in B if re.match(r"\d{4}  \d{4}  ", line)}
    source = [line[12:] for line in B if line[:4].isdigit() or line.startswith(" " * 12 + "*")]
    assert pal.assemble("".join(f"{line}\n" for line in source) + "$\n").words == printed
    assert len(printed) == 0o352 - 0o200 + 0o131 - 0o100


@pytest.mark.skipif(shutil.which("gfortran") is None, reason="gfortran is not installed")
@pytest.mark.parametrize(("appendix", "part"), [("C", circle.part), ("D", ellipse.part)])
def test_gfortran_runs_the_facsimile(appendix: str, part: "type[object]", tmp_path: Path) -> None:
    lines = facsimile(appendix).replace("Ø", "0").replace("\f", "").splitlines()
    listing = "".join(f"{line}\n" for line in lines if re.match(r"\d{3}[C ] ?\S", line))
    assert printout(listing, tmp_path) == part()


@pytest.mark.parametrize("appendix", ["B", "C", "D"])
def test_nothing_of_ours_is_on_the_page(appendix: str) -> None:
    text = facsimile(appendix)
    assert not re.search(r"/[WDRC]\b|DAMAGED|RESTORED|CONJECTURE|RESTORATION", text)
    notes = set(re.findall(r"/ ?([A-Z][A-Z -]+[A-Z])", text.replace("Ø", "0")))
    assert [note for note in notes if note not in scanned(f"appendix-{appendix.lower()}")] == []


def test_the_pages_end_with_their_numbers() -> None:
    for appendix, first in (("B", 105), ("C", 108), ("D", 111)):
        pages = facsimile(appendix).split("\f")
        assert [int(page.split()[-1].replace("Ø", "0")) for page in pages] == [first, first + 1, first + 2]


def test_the_columns_are_those_of_page_109() -> None:
    """The scan has this page with its layout: a statement from column 6, a note from column 34."""
    text = (OCR / "appendix-c.txt").read_text()
    kept = text[text.index("```") :]
    assert "\n     IF(AX-0.) 45,45,41" in kept
    assert "\n                                 /INNER LIMIT" in kept
    lines = facsimile("C").replace("Ø", "0").splitlines()
    assert "345  IF(AX-0.) 45,45,41" in lines
    assert "335 30 FORMAT(I3,I1,I5,I5,I3,I2)" in lines
    assert f"{'355  ARS=1745.':<33}/INNER LIMIT" in lines
