"""The list of the thesis's numbers against the text of the scan: its words, and that none is left out.

ocr/numbers.txt has every paragraph of Chapters 1 to 10 with a digit that is in neither ocr/mentions.txt nor
ocr/tables.txt.
"""

import ast
import re
from collections.abc import Callable
from importlib.resources import files
from pathlib import Path

import pytest

from pdp8.thesis import chain, measures, tables
from pdp8.thesis.catalogue import catalogue
from pdp8.thesis.inputs import COMPUTED, DIFFERS, FITTED, FROM_TEXT, INPUTS, NOT_MADE, state
from pdp8.thesis.numbers import numbers, plain
from programs import die, fluidic, polynomial, thesis
from release import edition
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


@pytest.mark.parametrize(
    ("made", "agrees", "names", "said"),
    [
        (False, False, (), NOT_MADE),
        (True, True, ("itself",), FROM_TEXT),
        (True, False, ("itself",), DIFFERS),
        (True, True, ("Appendix C", "2 s"), COMPUTED),
        (True, True, ("EIA",), COMPUTED),
        (True, False, ("Appendix C", "2 s"), DIFFERS),
        (True, True, ("Appendix C", "6 rubouts"), FITTED),
        (True, False, ("range", "6 rubouts"), FITTED),
    ],
)
def test_a_state_follows_from_the_inputs(made: bool, agrees: bool, names: tuple[str, ...], said: str) -> None:
    assert state(made, agrees, names) == said


def _other_rows(monkeypatch: pytest.MonkeyPatch) -> None:
    """Let the thesis have other results than it has, where the package keeps any of them."""
    for part, row in thesis.TABLE_10_1.items():
        other = thesis.Timed(row.step.blocks // 2, row.step.minutes / 2, row.step.total / 2)
        monkeypatch.setitem(thesis.TABLE_10_1, part, thesis.Row(row.part, other, row.piece and other))


def _wider(segment: fluidic.Segment) -> fluidic.Segment:
    return segment._replace(radius=1.9) if isinstance(segment, fluidic.Bend) else segment


OTHERS: dict[str, Callable[[pytest.MonkeyPatch], None]] = {
    "": _other_rows,
    "6 rubouts": lambda patch: patch.setattr(measures, "LINE_SECONDS", 3.0),
    "die's path": lambda patch: patch.setitem(die.part.__kwdefaults__ or {}, "minor", 1250),
    "5 passes": lambda patch: patch.setitem(tables.PASSES, "die", 4),
    "range": lambda patch: patch.setitem(polynomial.part.__kwdefaults__ or {}, "from_", 0.0),
    "outline": lambda patch: patch.setattr(fluidic, "RIGHT", tuple(map(_wider, fluidic.RIGHT))),
}
"""Other values for what was fitted to the thesis; "" for the thesis's own results."""


KEPT = measures._table, measures._readings, chain.path, chain._printed


@pytest.mark.slow("computes all numbers, and again for each value that was fitted")
def test_no_number_that_is_computed_hangs_on_a_result_of_the_thesis(monkeypatch: pytest.MonkeyPatch) -> None:
    """What was fitted is given another value: the measures that name it change, and no others."""
    names = sorted({one.measure for one in ALL if one.measure and "our stops" not in one.inputs})
    before = {name: measures.measure(name) for name in names}
    for value, set_other in OTHERS.items():
        with monkeypatch.context() as patch:
            set_other(patch)
            kept = KEPT if value == "outline" else KEPT[:-1]  # the others are arguments of what is printed
            for each in kept:
                each.cache_clear()
            try:
                changed = {name for name in names if measures.measure(name) != before[name]}
            finally:
                for each in kept:
                    each.cache_clear()
        assert changed <= {name for name in names if value in measures.inputs(name)}, value
        assert bool(changed) == bool(value), value


@pytest.mark.slow("computes what takes long")
def test_what_is_kept_is_what_is_computed() -> None:
    computed = measures.computed(one.measure for one in ALL)
    assert {name: measures.value(name) for name in computed} == computed


def test_no_result_of_the_thesis_is_written_into_a_measure() -> None:
    """Chapter 10's 17 minutes were once 50 - 1000 * 2 / 60, and were called computed."""
    tree = ast.parse(Path(measures.__file__).read_text())
    found: set[object] = set()
    for function in tree.body:
        if isinstance(function, ast.FunctionDef) and function.name in ("_of_part", "_parts", "_elements"):
            found |= {each.value for each in ast.walk(function) if isinstance(each, ast.Constant)}
    assert {number for number in found if type(number) in (int, float)} <= {0, 1, 2, 60, 100, 1000, 8.3}


def test_each_input_is_used_and_of_a_kind() -> None:
    used = {name for one in ALL for name in one.inputs}
    assert used == set(INPUTS)
    assert {each.kind for each in INPUTS.values()} == {"thesis", "ours", "fitted"}
    assert set(OTHERS) - {""} == {
        name for name, each in INPUTS.items() if each.kind == "fitted" and "chosen" not in each.why
    }


@pytest.mark.slow("runs every part of the thesis, and the piece-wise technique")
def test_what_is_from_the_text_is_the_very_number() -> None:
    for one in ALL:
        if one.state == FROM_TEXT and isinstance(one.ours, float | int):
            said = float(re.sub("[^.0-9]", "", plain(one.said)))
            assert said == pytest.approx(one.ours, rel=1e-4, abs=1.1e-4), one.words


@pytest.mark.slow("runs every part of the thesis, and the piece-wise technique")
def test_what_differs_stands_in_errata_or_is_explained() -> None:
    other = {one.by for one in ALL if one.measure and not one.agrees}
    assert other == {"errata", "implied"}


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


@pytest.mark.slow("runs every part of the thesis, and the piece-wise technique")
def test_the_edition_is_made_from_the_catalogue_and_the_numbers() -> None:
    assert edition.page(PAGE) == PAGE, "run `make evidence`"


def test_the_edition_has_every_item_and_every_number_with_its_link() -> None:
    anchors = re.findall(r'<a id="([^"]+)">', PAGE)
    assert anchors == [f"{item.kind}-{item.number}" for item in catalogue()]
    rows = re.findall(r"^\| \d+ \| `.*` \|.*\| (.*) \|$", PAGE, re.MULTILINE)
    assert len(rows) == len(ALL)
    assert {link for row in rows for link in re.findall(r"\(#(.*?)\)", row)} <= set(anchors)
    assert all(row for row, one in zip(rows, ALL, strict=True) if one.measure)


def test_pages_follow_each_other_through_the_ten_chapters() -> None:
    pages = [one.page for one in ALL]
    assert pages == sorted(pages)
    assert {one.chapter for one in ALL} == set(range(1, 11))


@pytest.mark.parametrize(
    ("said", "ours", "agrees"),
    [
        ("12 or more", 12, True), ("12 or more", 11.9, False), ("12", "12 or more", True),
        ("11", "12 or more", False), ("many", "12 or more", False), ("12", "12 or less", False),
        ("many", 3, False), ("3", None, False), ("100", 105, True), ("100", 105.1, False),
        ("0.1", 0.149, True), ("0.1", 0.151, False), ("1", 1.4, False), ("7402_8", "7402", True),
    ],
)  # fmt: skip
def test_when_ours_is_what_the_thesis_says(
    said: str, ours: float | str | None, agrees: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("pdp8.thesis.numbers.value", lambda name: ours)
    assert ALL[0]._replace(said=said, measure="own").agrees == agrees
