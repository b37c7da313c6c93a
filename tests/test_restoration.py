"""docs/restoration.md against what was restored: every word, every line, and a reason for every change."""

import re
from pathlib import Path

import pal
from tapes import shelf

HOUSE = Path(__file__).parent.parent
ROWS = [
    [cell.strip().strip("`") for cell in line.strip("|").split("|")]
    for line in (HOUSE / "docs" / "restoration.md").read_text().splitlines()
    if line.startswith("|") and "---" not in line and "scan" not in line and "| words |" not in line
]
WORDS = [row for row in ROWS if len(row) == 4]
LOST = [row for row in ROWS if re.fullmatch(r"0\d{3}-0\d{3}", row[0])]
LINES = [row for row in ROWS if len(row) == 3 and row not in LOST]
ASSEMBLY = pal.assemble(shelf.read("eia.pal"))
STATEMENTS = {
    line.address: " ".join(line.source.split("/")[0].split())
    for line in ASSEMBLY.lines
    if line.address is not None
}
CIRCLE = {
    line[:3]: line.removesuffix("RESTORED")[3:] for line in shelf.read("circle.for").decode().splitlines()
}


def run_together(text: str) -> str:
    return "".join(text.split())


def read(scan: str) -> str:
    """Read a line of the scan by the page's four rules."""
    formulas = scan.replace("$", "").replace("\\emptyset", "0").replace("\\bullet", ".")
    return run_together(formulas.replace("Ø", "0").replace("•", "."))


def test_every_word_of_the_listing_stands_on_the_page_once() -> None:
    shown = {int(row[1][:4], 8): int(row[1][5:], 8) for row in WORDS}
    assert len(shown) == len(WORDS)
    for run, words, sources in LOST:
        first, last = (int(end, 8) for end in run.split("-"))
        shown |= zip(range(first, last + 1), (int(word, 8) for word in words.split()), strict=True)
        assert sources.split("; ") == [STATEMENTS[address] for address in range(first, last + 1)]
    assert shown == ASSEMBLY.words


def test_the_sources_are_those_of_eia_pal() -> None:
    for _, numbers, source, _ in WORDS:
        assert source == STATEMENTS[int(numbers[:4], 8)]


def test_a_word_without_a_reason_is_what_the_scan_shows() -> None:
    for scan, numbers, source, reason in WORDS:
        if not reason:
            assert scan[:9] == numbers
            assert run_together(scan[9:]) in ("", run_together(source))


def test_the_restored_lines_are_those_of_circle_for() -> None:
    for _, restored, _ in LINES:
        assert restored[3:].split() == CIRCLE[restored[:3]].split()


def test_a_line_without_a_reason_is_what_the_scan_shows() -> None:
    for scan, restored, reason in LINES:
        if not reason:
            assert read(scan) == run_together(restored)


def test_every_line_of_the_first_page_stands_there_and_every_mark_in_the_listing_has_its_reason() -> None:
    reasons = {restored[:3]: reason for _, restored, reason in LINES}
    assert {f"{number}" for number in range(100, 330, 5)} <= set(reasons)
    marked = [
        line[:3] for line in shelf.read("circle.for").decode().splitlines() if line.endswith("RESTORED")
    ]
    assert len(marked) == 12
    assert all(reasons[number] for number in marked)
