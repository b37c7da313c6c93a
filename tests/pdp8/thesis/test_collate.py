"""What a rescan would settle: rivals by running them, answers, and lines found on pages that we draw."""

import re
import shutil
from pathlib import Path

import pytest

import pal
import pdp8
from pdp8 import shelf
from pdp8.thesis import collate, evidence
from pdp8.thesis.collate import answers, conjectures, letter, settled, state
from pdp8.thesis.facsimile import facsimile
from programs import circle, die, polynomial
from tapes import ascii
from tapes.errors import WorkError
from tests.conftest import Call
from tests.pictures import pixels

KNOWN = conjectures()


def test_every_conjecture_of_the_evidence_is_on_the_list() -> None:
    for artefact in ("eia.pal", "circle.for", "ellipse.for", *evidence.TABLES):
        for row in evidence.table(artefact):
            named = [one for one in KNOWN.values() if artefact in one.targets and one.ours in row.ours]
            assert row.kind != "conjecture" or [one.page for one in named] == [row.page], row


def test_what_a_rival_would_change_is_what_it_changes() -> None:
    blocks = {name: re.findall(r"(\d+) blocks", str(KNOWN[name].rivals)) for name in ("RAD", "die", "range")}
    assert blocks["die"] == [str(die.part(major=2750, minor=1250).count("\n"))]
    ranges = polynomial.part(from_=-0.5, to=6.5, origin_y=5.0)
    assert blocks["range"] == [str(ranges.count("\n"))]
    other = circle.part(radius=1800, start_x=1750, inner=1745, outer=1755)
    assert (blocks["RAD"], other) == ([str(other.count("\n"))], circle.part())


def test_a_second_program_without_the_space_punches_360_for_it() -> None:
    machine = pdp8.Machine()
    source = shelf.read_bundled("eia2.pal").decode().replace("JMP NSP", "JMP NCR")
    machine.load(pal.assemble(source).words)
    machine.start(0o200)
    machine.teletype.reader.load(ascii.encode(" ", fill=0))
    machine.run()
    assert machine.teletype.punch.tape[1] == 0o360
    assert "punches 360 for a space" in str(KNOWN["space"].rivals)


def test_an_answer_is_as_ours_or_says_what_it_changes() -> None:
    space = KNOWN["0340"]
    assert [state(space, each) for each in (None, "tad p0", "tadMSP", "TAD NCR")] == [
        "conjectured",
        "read",
        "read: tadMSP; " + space.rivals["TAD MSP"],
        "read: TAD NCR; not foreseen, so not computed",
    ]


@pytest.mark.parametrize(
    ("line", "said"),
    [
        ("0340 | TAD P0", "line 2: 0340 | TAD P0: an answer is NAME | WHAT THE PAGE HAS | WHO LOOKED"),
        ("340 | TAD P0 | me", "line 2: 340: no such conjecture; there are 0340, RAD"),
        (
            "RAD | RAD=1800. | you\nRAD | RAD=1750. | me",
            "line 3: RAD: RAD=1750.; an earlier line has RAD=1800.",
        ),
    ],
)
def test_a_line_that_is_no_answer_is_refused(line: str, said: str) -> None:
    with pytest.raises(WorkError, match=re.escape(said)):
        answers(f"# a comment\n{line}\n")


def test_answers_turn_conjectures_into_readings(monkeypatch: pytest.MonkeyPatch) -> None:
    """The source has the page's words, also another word; an input that was read is no longer fitted."""
    given = ("0340 | TAD MSP", "RAD | rad=1750.", "range | X from -.5 to 6.5", "die | 6 x 3 is the path")
    read = answers("".join(f"{line} | me\n" for line in given))
    monkeypatch.setattr(collate, "answers", lambda text=None: read)
    evidence.rows.cache_clear()
    try:
        words = [row.ours for row in evidence.table("eia.pal") if row.ours[:4] == "0340"]
        assert words == ["0340 1127 TAD MSP"]
        assert not re.search("CONJECTURE", evidence.source("circle.for"))
        assert [row.kind for row in evidence.table("eia.pal") if row.ours[:4] == "0340"] == ["read"]
        (line,) = (line for line in facsimile("B").splitlines() if line.lstrip("[").startswith("Ø34Ø"))
        assert "[" not in line
        other = evidence.Row("106", "conjecture", "", "0341 7402 HLT", "")
        assert collate.as_read(other, "eia.pal") == other
    finally:
        evidence.rows.cache_clear()
    assert settled("die's path")
    assert not settled("range"), "the page has another range than ours"


def test_the_letter_names_page_and_place_of_each() -> None:
    text = letter()
    assert all(re.search(rf"page +{one.page}  {re.escape(one.place)}\. Name", text) for one in KNOWN.values())
    assert "Husemeyer" in text


def drawn(lines: list[str], path: Path) -> None:
    """Draw a page of monospace lines as a typewriter's, six to the inch, 100 dots to the inch."""
    rows = "".join(
        f'<text x="80" y="{60 + 17 * row}" xml:space="preserve">{line}</text>'
        for row, line in enumerate(lines)
    )
    size = 'width="850" height="1100"'
    svg = f'<svg xmlns="http://www.w3.org/2000/svg" {size}><rect {size} fill="#fff"/>'
    style = '<g font-family="monospace" font-size="12">'
    pixels(f"{svg}{style}{rows}</g></svg>").save(path)


@pytest.mark.slow("reads pictures by OpenCV")
@pytest.mark.skipif(shutil.which("fc-list") is None, reason="no fonts")
@pytest.mark.parametrize("lost", [0, 3])
def test_a_line_is_found_on_a_page_and_only_about_where_lines_are_missing(
    lost: int, call: Call, tmp_path: Path
) -> None:
    pages = pytest.importorskip("pdp8.thesis.pages", reason="OpenCV is not installed", exc_type=ImportError)
    page = facsimile("B").split("\f")[1].replace("[", "").replace("]", "").splitlines()
    lines = [line for line in page if line.strip()][lost:]
    drawn(lines, tmp_path / "page-0106.png")
    place = pages.find(KNOWN["0340"], (tmp_path / "page-0106.png").read_bytes())
    (row,) = [at for at, line in enumerate(lines) if line.startswith("Ø34Ø")]
    assert place
    top, last, sure = place
    assert sure == (lost == 0)
    assert top <= 60 + 17 * row - 4 <= last
    assert last - top < (17 if sure else 60)
    status, out, _ = call(f"pdp8 thesis collate --pages {tmp_path}")
    assert status == 0
    about = "" if sure else "by its number among the lines, about "
    assert f"line 0340; page-0106.png: {about}rows {top} to {last}" in str(out)


def test_a_folder_without_a_page_is_refused(call: Call, tmp_path: Path) -> None:
    pytest.importorskip("cv2")
    status, _, said = call(f"pdp8 thesis collate --pages {tmp_path}")
    assert status == 1
    assert "no picture of a page on the list; one is called 106.png" in said
