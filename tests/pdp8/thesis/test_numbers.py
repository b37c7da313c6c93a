"""The list of the thesis's numbers against the text of the scan: its words, and that none is left out.

ocr/numbers.txt has every paragraph of Chapters 1 to 10 with a digit that is in neither ocr/mentions.txt nor
ocr/tables.txt.
"""

import re
from importlib.resources import files
from pathlib import Path

import pytest

from pdp8.thesis import edition
from pdp8.thesis.catalogue import catalogue
from pdp8.thesis.numbers import STATES, numbers, plain
from tests.pdp8.thesis import scanned

DOCS = Path(__file__).parents[3] / "docs"
PAGE = (DOCS / "thesis.md").read_text()
ALL = list(numbers())

NAMES = (
    r"PDP-8/L", r"83-1000", r"IBM 7040", r"CDC 6400",
    r"(?:Figure|FIGURE|Table|TABLE) \d+\.\d", r"[Rr]eference \d+", r"item \d", r"(?:CHAPTER|Chapter) \d+",
    r"Chapters \d+(?:, \d+,)? and \d+", r"Programs? \(\d\)", r"\([123]\)", r"Subroutines? \d\.(?: and \d\.)?",
    r"\$\$.*?\$\$", r"[xy]_\d", r"= 2C", r"\\sqrt\{.*?\}(?:/1)?", r"1(?= or 1\.732)", r"switches\. 9",
    r"(?<= )94(?= )", r"2(?:°|\^\{.*?\})", r"\\frac\{1\}\{2\}", r"2nd Method", r"A11 the",
)  # fmt: skip
"""What has digits and is no number: names, references, equations, place values, two page numbers; a ± and the
word All, misread."""


CHAPTERS = " {} {}{} {} ".format(
    scanned("numbers"),
    *scanned("mentions").partition("The Moog Hydra-Point model")[1:],
    scanned("tables").partition("TABLE 2.4")[2],
)


def test_the_words_are_the_scan_s() -> None:
    assert [one.words for one in ALL if one.words not in CHAPTERS] == []


def test_no_number_of_the_chapters_is_left_out() -> None:
    left = list(CHAPTERS)
    text = (files("pdp8.thesis") / "numbers.txt").read_text(encoding="utf-8")
    for line in text.splitlines():
        if not line.startswith("#"):
            before, number, after = re.split("[«»]", re.sub("‹.*?›", "", line.split("|")[1].strip()))
            for found in re.finditer(re.escape(before + number + after), CHAPTERS):
                start = found.start() + len(before)
                left[start : start + len(number)] = "_" * len(number)
    remains = re.sub("|".join(NAMES), " ", "".join(left))
    assert re.findall(r".{30}\d.{10}", remains) == []


@pytest.mark.slow("runs every part of the thesis, and the piece-wise technique")
def test_the_state_of_each_number_is_what_it_says() -> None:
    agreeing = {STATES["text"], STATES["made"], STATES["fits"]}
    wrong = [(one.page, one.said, one.ours) for one in ALL if one.agrees != (one.state in agreeing)]
    assert wrong == []
    for one in ALL:
        if one.state == STATES["text"] and isinstance(one.ours, float | int):
            said = float(re.sub("[^.0-9]", "", plain(one.said)))
            assert said == pytest.approx(one.ours, abs=1e-9), one.words


def test_a_number_that_is_off_does_not_agree() -> None:
    """666 blocks are "about 670"; 13 % more are not, nor is a wrong digit in a word."""
    block = next(one for one in ALL if one.said == "670")
    word = next(one for one in ALL if one.said == "7402")
    assert block._replace(measure="circle blocks").agrees
    assert not block._replace(said="757").agrees
    assert not word._replace(said="7403").agrees


def test_what_makes_a_number_is_there() -> None:
    items = {item.number for item in catalogue()}
    pages = {page.stem for page in DOCS.glob("*.md")}
    for one in ALL:
        assert one.by in items | pages | {""} or one.by.startswith("pdp8 "), one.by
        assert bool(one.measure) == (one.state != STATES["none"])


@pytest.mark.slow("runs every part of the thesis, and the piece-wise technique")
def test_the_edition_is_made_from_the_catalogue_and_the_numbers() -> None:
    assert edition.page(PAGE) == PAGE, "run `make evidence`"


def test_the_edition_has_every_item_and_every_number_with_its_link() -> None:
    anchors = re.findall(r'<a id="([^"]+)">', PAGE)
    assert anchors == [f"{item.kind}-{item.number}" for item in catalogue()]
    rows = re.findall(r"^\| \d+ \| `.*` \|.*\| (.*) \|$", PAGE, re.MULTILINE)
    assert len(rows) == len(ALL)
    assert {link for row in rows for link in re.findall(r"\(#(.*?)\)", row)} <= set(anchors)
    assert all(row for row, one in zip(rows, ALL, strict=True) if one.state != STATES["none"])


def test_pages_follow_each_other_through_the_ten_chapters() -> None:
    pages = [one.page for one in ALL]
    assert pages == sorted(pages)
    assert {one.chapter for one in ALL} == set(range(1, 11))


def test_what_differs_stands_in_errata_or_is_explained() -> None:
    assert {one.by for one in ALL if one.state == STATES["errs"]} == {"errata", "implied"}
