"""Each command of the tables answers as they have it: what it shows, says and writes, and its status."""

from difflib import unified_diff
from pathlib import Path

import pytest

from tests.transcripts.table import TABLES, block_answered, blocks

SLOW = {
    "parts": pytest.mark.slow("computes the thesis's parts, 3 s"),
    "class": pytest.mark.slow("marks a class's answers, 6 s"),
    "inspect": pytest.mark.slow("measures walls, 5 s"),
    "reels": pytest.mark.slow("copies DECtapes, 3 s"),
}


@pytest.mark.parametrize(
    "table", [pytest.param(path, id=path.stem, marks=SLOW.get(path.stem, ())) for path in TABLES]
)
def test_commands_answer_as_the_table_has_it(table: Path) -> None:
    wrong: list[str] = []
    for block in blocks(table.read_text("utf-8")):
        if (now := block_answered(block)) != block.strip("\n"):
            wrong += unified_diff(block.splitlines(), now.splitlines(), "table", "now", lineterm="")
    assert not wrong, "\n".join([f"{table.name}; python -m tests.transcripts writes it:", *wrong])
