"""The facsimiles are listings: they assemble, compile and run, and have nothing of ours on them."""

import re
import shutil
from pathlib import Path

import pytest

import pal
from pdp8.thesis.evidence import TABLES
from pdp8.thesis.facsimile import facsimile
from pdp8.thesis.supplied import html, marked
from programs import circle, ellipse
from tests.pdp8.thesis import OCR, scanned
from tests.programs.fortran import printout

ZEROS = str.maketrans("ØQN@O•", "00000.")


def plain(appendix: str) -> list[str]:
    """Return the lines of a facsimile without brackets, slashes of zeros and form feeds."""
    return re.sub(r"[][\f]", "", facsimile(appendix)).replace("Ø", "0").splitlines()


def test_the_source_column_of_b_assembles_to_its_word_column() -> None:
    lines = [found for line in plain("B") if (found := re.match(r"(\d{4}) +(\d{4}) +(.*)", line))]
    printed = {int(address, 8): int(word, 8) for address, word, _ in (line.groups() for line in lines)}
    source = "".join(f"{line[3]}\n" for line in lines)
    before, definitions = source.split("HOLD,", 1)
    assert pal.assemble(f"*200\n{before}*100\nHOLD,{definitions}$\n").words == printed
    assert len(printed) == 0o352 - 0o200 + 0o131 - 0o100


@pytest.mark.skipif(shutil.which("gfortran") is None, reason="gfortran is not installed")
@pytest.mark.parametrize(("appendix", "part"), [("C", circle.part), ("D", ellipse.part)])
def test_gfortran_runs_the_facsimile(appendix: str, part: "type[object]", tmp_path: Path) -> None:
    listing = "".join(f"{line}\n" for line in plain(appendix) if re.match(r"\d{3}[C ] ?\S", line))
    assert printout(listing, tmp_path) == part()


@pytest.mark.parametrize("appendix", ["B", "C", "D"])
def test_nothing_of_ours_is_on_the_page(appendix: str) -> None:
    text = "\n".join(plain(appendix)[2:])
    assert not re.search(r"/[WDRC]\b|DAMAGED|RESTORED|CONJECTURE|RESTORATION", text)
    notes = set(re.findall(r"/ ?([A-Z][A-Z -]+[A-Z])", text))
    assert [note for note in notes if note not in scanned(f"appendix-{appendix.lower()}")] == []


def test_the_pages_end_with_their_numbers() -> None:
    for appendix, first in (("B", 105), ("C", 108), ("D", 111)):
        pages = facsimile(appendix).split("\f")
        last = [page.split()[-1].replace("Ø", "0") for page in pages]
        assert last == [f"{page}" if page == 105 else f"[{page}]" for page in range(first, first + 3)]
        assert "\n\n105\n" in (OCR / "appendix-b.txt").read_text()


def test_what_the_scan_does_not_show_is_in_brackets() -> None:
    """Tags and statements that are lost, characters that are misread, and the whole of page 106."""
    b, c, d = (facsimile(appendix).replace("Ø", "0") for appendix in "BCD")
    for line in (
        "0200  6046 [START,  TLS]",
        "0205  31[0]0         [DCA HOLD]",
        "0[10]0  0000  HOLD,   0",
        "[0232] 5236         [JMP N1]",
    ):
        assert f"\n{line}\n" in b
    for line in ("235 [PRINT 10,C1,C2,C3,C4]", "295 [RAD=1750.]                  /RADIUS OF CIRCLE"):
        assert f"\n{line}\n" in c
    assert "\n255 10 FORMAT(1X,[I]5,[I]4,[I]5,[I]4)\n" in d
    page_106 = b.split("\f")[1].split("\n\n")[0].splitlines()
    assert len(page_106) == 0o342 - 0o256
    assert all(re.fullmatch(r"\[[^][]*\]", line) for line in page_106)
    assert all(re.sub(r"\[.*?\]", "", text) != text for text in (b, c, d))


@pytest.mark.parametrize("artefact", ["eia.pal", "circle.for", "ellipse.for", *TABLES])
def test_what_stands_outside_of_brackets_is_the_scan_s(artefact: str) -> None:
    """In its order, zeros and points read by the first two rules; evidence's tests have the legible lines."""
    above = ""
    for row, lost in marked(artefact):
        above = row.scan if row.scan != "^" else above
        ours = "".join(row.ours.split()).translate(ZEROS)
        kept = [character for character, gone in zip(ours, lost, strict=True) if not gone]
        scan = iter(above.translate(ZEROS))
        assert row.kind == "legible" or all(character in scan for character in kept), row
        assert any(lost) or row.kind == "legible" or re.search("two lines|dirt", row.reason), row


@pytest.mark.parametrize("artefact", ["eia.pal", "circle.for", "ellipse.for"])
def test_brackets_are_about_the_very_places_where_the_scan_differs(artefact: str) -> None:
    """Where the scan has as many characters as ours, beside each other; the first two rules read both."""
    compared, zeros = 0, ZEROS if artefact.endswith(".pal") else str.maketrans("Ø•", "0.")
    for row, lost in marked(artefact):
        scan = "".join(row.scan.replace("¦", "").split()).translate(zeros)
        ours = "".join(row.ours.split()).translate(zeros)
        if row.kind == "damaged" and len(scan) == len(ours):
            compared += 1
            assert lost == [one != other for one, other in zip(scan, ours, strict=True)], row
        words = row.scan.translate(zeros).split()[:2]
        if row.kind == "damaged" and [len(word) for word in words] == [4, 4] and not row.scan[8:].strip(" •"):
            compared += 1
            assert lost[:8] == [one != other for one, other in zip("".join(words), ours, strict=False)], row
    assert compared


def test_the_columns_are_those_of_page_109() -> None:
    """The scan has this page with its layout: a statement from column 6, a note from column 34."""
    text = (OCR / "appendix-c.txt").read_text()
    kept = text[text.index("```") :]
    assert "\n     IF(AX-0.) 45,45,41" in kept
    assert "\n                                 /INNER LIMIT" in kept
    lines = plain("C")
    assert "345  IF(AX-0.) 45,45,41" in lines
    assert "335 30 FORMAT(I3,I1,I5,I5,I3,I2)" in lines
    assert f"{'355  ARS=1745.':<33}/INNER LIMIT" in lines


def test_a_listing_s_key_to_its_marks_is_not_marked() -> None:
    """In another colour stand the lines with a mark, not the comment that says what the marks mean."""
    marked = re.findall(
        r'<mark class="supplied">(.*)</mark>', html("\t/\t/D\tA DAMAGED LINE\n4214\tJMS READ\t/D")
    )
    assert marked == ["4214\tJMS READ\t/D"]
