"""docs/implied.md shows what pdp8.replay.implied computes."""

from pathlib import Path

import pytest

from pdp8.replay import implied
from programs.thesis import TABLE_10_1

PAGE = (Path(__file__).parents[3] / "docs" / "implied.md").read_text()


def shown(name: str) -> list[list[str]]:
    """Return the cells of the table of that name, its two heading lines left out."""
    table = PAGE.split(f"<!-- {name} -->\n")[1].split("\n\n")[0].rstrip("\n")
    return [[cell.strip() for cell in line.strip("|").split("|")] for line in table.split("\n")[2:]]


@pytest.mark.parametrize("part", TABLE_10_1)
def test_feeds(part: str) -> None:
    assert shown(f"feed, {part}") == list(implied.rows(implied.feeds(part)))


@pytest.mark.slow("cuts the polynomial twelve times")
def test_the_range_is_the_only_one_within_2_percent() -> None:
    found = list(implied.ranges())
    assert shown("range") == list(implied.rows(found))
    assert [candidate.assumption for candidate in found if candidate.off <= 0.02] == ["-0.75 to 6.25"]


@pytest.mark.slow("the piece-wise technique tries every pair of feeds, for each allowance")
@pytest.mark.parametrize("part", implied.FITTING_PIECES)
def test_allowances(part: str) -> None:
    assert shown(f"allowance, {part}") == list(implied.rows(implied.allowances(part)))


def test_the_element() -> None:
    assert shown("element") == list(implied.rows(implied.element()))


@pytest.mark.slow("cuts all parts of the table, by both techniques")
def test_table_10_1() -> None:
    assert shown("Table 10.1") == list(implied.table_10_1())
