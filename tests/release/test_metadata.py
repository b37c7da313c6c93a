"""What pyproject.toml says once and others repeat: version, extras, tag; and where README's links lead."""

import re
import tomllib
from pathlib import Path

import pytest

from release.dist import check_tag
from release.links import absolute, moved

HOUSE = Path(__file__).parents[2]
README = (HOUSE / "README.md").read_text()
LINK = re.compile(r"\]\(([^)\s]+)\)")
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


def test_without_an_address_links_stay(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv("PDP8_SITE", raising=False)
    assert absolute(README) == README
    for target in LINK.findall(README):
        assert (HOUSE / target.partition("#")[0]).exists(), target


def test_one_address_leads_every_link_to_the_site(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("PDP8_SITE", "https://example.org/pdp8/")
    links = {link.removeprefix("https://example.org/pdp8/") for link in LINK.findall(absolute(README))}
    assert {"install.html", "room.png", "benchmarks.html", "CONTRIBUTING.html"} <= links
    assert not [link for link in links if "/" in link]


def test_a_page_of_the_site_has_its_neighbours_beside_it() -> None:
    page = "](docs/tapes.md#labels) ](../CONTRIBUTING.md) ](https://x.org/docs/a.md) ](benchmarks/README.md)"
    assert moved(page) == "](tapes.md#labels) ](CONTRIBUTING.md) ](https://x.org/docs/a.md) ](benchmarks.md)"


def test_a_tag_is_the_version() -> None:
    check_tag("v0.1.0")
    with pytest.raises(SystemExit, match=r"tag v9.9.9: pyproject.toml has version"):
        check_tag("v9.9.9")
