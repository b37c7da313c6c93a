"""The tables of docs/parts.md say what comes out."""

import re
import shlex
from collections.abc import Iterator
from pathlib import Path

import pytest
from click.testing import CliRunner

from programs.cli import part

PAGE = Path(__file__).parents[2] / "docs" / "parts.md"


def rows(heading: str) -> Iterator[list[str]]:
    """Yield the cells of each row, under `heading`, that has a command."""
    section = PAGE.read_text().split(f"## {heading}")[1].split("\n## ")[0]
    for line in section.split("\n"):
        if "`pdp8 part" in line and line.startswith("|"):
            yield [cell.strip() for cell in line.strip("|").split("|")]


def count(command: str, *more: str) -> int:
    """Return the blocks that a command of the page makes, with more options."""
    words = shlex.split(command.strip("`"))[2:]
    tape: bytes = CliRunner().invoke(part, [*words, *more]).stdout_bytes
    return tape.count(b"\r" if b"\r" in tape else b"\x8d")


@pytest.mark.parametrize("row", list(rows("Blocks, the thesis's and ours")), ids=lambda row: row[0])
def test_the_blocks_of_a_part(row: list[str]) -> None:
    assert count(row[1]) == int(row[3])


@pytest.mark.parametrize("row", list(rows("The piece-wise technique")), ids=lambda row: row[0])
def test_the_blocks_of_the_piece_wise_technique(row: list[str]) -> None:
    counts = [count(row[1], "--feed-error", error) for error in ("0.2", "0.1", "0")]
    assert counts == [int(cell) for cell in row[3:6]]


def test_the_slowest_feed_alone() -> None:
    said = re.search(r"--fastest 1` makes (\d+) blocks", PAGE.read_text())
    assert said
    assert count("`pdp8 part circle --technique piece`", "--fastest", "1") == int(said[1])
