"""Where README's links lead: as they are in the repository, to the site on PyPI; and what a tag has to be."""

import re
from pathlib import Path

import pytest

from release.dist import check_tag
from release.links import absolute, moved

HOUSE = Path(__file__).parents[2]
README = (HOUSE / "README.md").read_text()
LINK = re.compile(r"\]\(([^)\s]+)\)")


def test_without_an_address_links_stay(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv("PDP8_SITE", raising=False)
    assert absolute(README) == README
    for target in LINK.findall(README):
        assert (HOUSE / target.partition("#")[0]).exists(), target


def test_one_address_leads_every_link_to_the_site(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("PDP8_SITE", "https://example.org/pdp8/")
    links = LINK.findall(absolute(README))
    assert all(link.startswith("https://example.org/pdp8/") for link in links)
    assert "https://example.org/pdp8/install.html" in links
    assert "https://example.org/pdp8/workbench.png" in links
    assert "https://example.org/pdp8/benchmarks.html" in links
    assert "https://example.org/pdp8/CONTRIBUTING.html" in links


def test_a_page_of_the_site_has_its_neighbours_beside_it() -> None:
    page = "](docs/tapes.md#labels) ](../CONTRIBUTING.md) ](https://x.org/docs/a.md) ](benchmarks/README.md)"
    assert moved(page) == "](tapes.md#labels) ](CONTRIBUTING.md) ](https://x.org/docs/a.md) ](benchmarks.md)"


def test_a_tag_is_the_version() -> None:
    check_tag("v0.1.0")
    with pytest.raises(SystemExit, match=r"tag v9.9.9: pyproject.toml has version"):
        check_tag("v9.9.9")
