"""`pdp8 replay` as a user runs it."""

from pathlib import Path

import pytest

from pdp8.cli.replay import REPLAYED
from tests.conftest import Shell


@pytest.mark.slow("the afternoon, whole")
def test_the_acts_are_said_and_the_table_printed(shell: Shell, tmp_path: Path) -> None:
    done = shell("pdp8 replay drill --out desk --html page.html")
    assert done.returncode == 0
    said = done.stderr.decode().splitlines()
    assert said[0].startswith(
        "The thesis gives minutes for punching, translating and cutting; the others, and"
    )
    assert said[1].startswith(" 1:00:00 pm  FORTRAN          0:16 in 1971,")
    assert "checksum right" in said[4]
    assert said[-2:] == ["wrote 13 files in desk", "wrote page.html"]
    assert "thesis beside replay" in done.stdout.decode()
    assert len(list((tmp_path / "desk").iterdir())) == 13
    assert (tmp_path / "page.html").read_text(encoding="utf-8").startswith("<!DOCTYPE html>")


@pytest.mark.slow("an afternoon of each part, 15 s")
@pytest.mark.parametrize("part", sorted(set(REPLAYED) - {"circle", "ellipse", "die", "drill"}))
def test_any_other_part(shell: Shell, part: str) -> None:
    """What no other test takes goes the whole way, the page too (the die is the ellipse's program)."""
    done = shell(f"pdp8 replay {part} --html - > page.html && wc -c < page.html")
    assert done.returncode == 0, done.stderr.decode()
    assert 100_000 < int(done.stdout) < 3_000_000
