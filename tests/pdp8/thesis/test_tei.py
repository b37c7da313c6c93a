"""The TEI against the evidence, and against TEI's own schema (TEI P5 4.3.0, tei_all.rng)."""

import os
from pathlib import Path
from xml.etree import ElementTree as ET

import pytest

from pdp8.thesis.evidence import ARTEFACTS, TABLES, table
from pdp8.thesis.tei import RECONSTRUCTIONS, tei

SPACE = "{http://www.tei-c.org/ns/1.0}"
RELAX = "{http://relaxng.org/ns/structure/1.0}"
SCHEMA = Path(os.environ.get("TEI_SCHEMA", Path(__file__).parents[3] / "build" / "tei_all.rng"))


def elements(root: ET.Element, name: str) -> list[ET.Element]:
    return list(root.iter(SPACE + name))


def text(line: ET.Element, without: set[str]) -> str:
    """Return the text of an element without that of some elements in it."""
    inner = ("" if each.tag[len(SPACE) :] in without else text(each, without) for each in line)
    tails = (each.tail or "" for each in line)
    return (line.text or "") + "".join(one + tail for one, tail in zip(inner, tails, strict=True))


def statement(line: str) -> str:
    """Return the statement of a line of a PAL listing, without address, word and tag."""
    return line[10 if line[0] == "0" else 0 :].rpartition(",")[2].strip()


@pytest.mark.parametrize("artefact", ARTEFACTS + TABLES)
def test_its_corrected_lines_are_ours_and_its_misread_ones_the_scan_s(artefact: str) -> None:
    root = ET.fromstring(tei(artefact))
    rows = list(table(artefact))
    assert [text(line, {"sic", "note"}) for line in elements(root, "ab")] == [row.ours for row in rows]
    sic = [each.text for each in elements(root, "sic")]
    assert (
        sic == [row.scan for row in rows if row.kind == "damaged" and row.scan != "^"]
        or artefact == "ch2-block"
    )
    assert [each.text for each in elements(root, "note")] == [row.reason for row in rows if row.reason]
    assert len(elements(root, "gap")) == (artefact == "eia.pal")  # page 106


def test_readings_that_an_editor_asks_for_are_there() -> None:
    sic = [each.text or "" for each in elements(ET.fromstring(tei("eia.pal")), "sic")]
    for reading in ("0205 3190", "0251 3188", "0103 0040 PQ.40", "0010 0000 HOLD, Q", "0104 1000 P1,1"):
        assert reading in sic


def test_what_may_have_been_otherwise_is_not_sure() -> None:
    """Tags that are ours, their uses, `.-1` for which a tag may have stood, and the one word of page 106."""
    supplied = elements(ET.fromstring(tei("eia.pal")), "supplied")
    low = {
        word.rstrip(",")
        for each in supplied
        if each.get("cert") == "low"
        for word in (each.text or "").split()
    }
    high = {
        word.rstrip(",")
        for each in supplied
        if each.get("cert") == "high"
        for word in (each.text or "").split()
    }
    tags = {"START", "NEXT", "READ", "PUNCH", "NSP", "NCR", *(f"N{digit}" for digit in range(1, 10))}
    assert low == tags | {".-1", "0340", "1103", "TAD", "P0"}
    assert not high & (tags | {".-1"})
    block = ET.fromstring(tei("ch2-block"))
    assert {each.get("cert") for name in ("supplied", "corr") for each in elements(block, name)} == {"low"}


@pytest.mark.parametrize("artefact", RECONSTRUCTIONS)
def test_a_program_that_we_wrote_is_not_given_to_the_author(artefact: str) -> None:
    root = ET.fromstring(tei(artefact))
    title = elements(root, "titleStmt")[0]
    assert not elements(title, "author")
    assert "reconstruct" in text(title, set())
    assert not any(elements(root, name) for name in ("pb", "gap", "supplied", "sic"))
    third = {statement(row.ours) for row in table("eia.pal")}
    like = [row for row in table(artefact) if "the third program's statement" in row.reason]
    assert like
    assert all(statement(row.ours) in third for row in like)


@pytest.mark.slow("asks for TEI's schema")
def test_it_is_valid_tei() -> None:
    """By the schema without the elements that no document has, which takes libxml2 no minute to read."""
    etree = pytest.importorskip("lxml.etree")
    if not SCHEMA.exists():
        pytest.skip("TEI's schema is not here: make build/tei_all.rng")
    names = ("eia.pal", "eia1.pal", "circle.for", "ch2-block")
    documents = {name: etree.fromstring(tei(name).encode()) for name in names}
    used = {each.tag for document in documents.values() for each in document.iter(etree.Element)}
    grammar = etree.parse(str(SCHEMA))
    for element in grammar.iter(f"{RELAX}element"):
        if element.get("name") and SPACE + element.get("name") not in used:
            element.clear()
            element.tag = f"{RELAX}notAllowed"
    schema = etree.RelaxNG(grammar)
    for name, document in documents.items():
        assert schema.validate(document), (name, schema.error_log)
    document.append(etree.Element(f"{SPACE}ab"))
    assert not schema.validate(document), "the schema is one that can fail"
