"""What pyproject.toml says once and other files repeat: the version, the names of the extras."""

import re
import tomllib
from pathlib import Path

HOUSE = Path(__file__).parents[2]
PROJECT = tomllib.loads((HOUSE / "pyproject.toml").read_text())["project"]
EXTRA = re.compile(r"pdp8\[(\w+)\]|the extra\s+`(\w+)`")


def test_citation_and_changes_have_the_version() -> None:
    version = PROJECT["version"]
    assert f"\nversion: {version}\n" in (HOUSE / "CITATION.cff").read_text()
    first = re.search(r"^## (\S+?),? ", (HOUSE / "CHANGELOG.md").read_text(), re.MULTILINE)
    assert first
    assert first[1] == version


def test_every_extra_that_is_named_exists() -> None:
    packages = ("tapes", "pal", "pdp8", "programs", "nc")
    files = [path for name in packages for path in (HOUSE / name).rglob("*.py")]
    files += (HOUSE / "docs").glob("*.md")
    named = {one or other for path in files for one, other in EXTRA.findall(path.read_text())}
    assert named
    assert named <= set(PROJECT["optional-dependencies"])
