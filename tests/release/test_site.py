"""The documentation as a site: mkdocs.yml lets no warning pass, a broken link or anchor among them."""

import json
import os
import subprocess
import sys
from pathlib import Path

import click
import pytest

from pdp8.cli.root import pdp8
from release.reference import commands

HOUSE = Path(__file__).parents[2]

pytestmark = pytest.mark.slow("a page is made of each module")


@pytest.fixture(scope="module")
def site(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The site, built."""
    pytest.importorskip("mkdocs", reason="mkdocs, of the extra `docs`, is not installed")
    folder = tmp_path_factory.mktemp("site")
    done = subprocess.run(
        [sys.executable, "-m", "mkdocs", "build", "-q", "--strict", "-d", folder],
        cwd=HOUSE,
        env={**os.environ, "NO_MKDOCS_2_WARNING": "1"},
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    assert done.stderr == ""
    return folder


def test_the_first_page_is_the_readme(site: Path) -> None:
    page = (site / "index.html").read_text()
    assert "Moses Wong" in page
    assert 'href="pdp8.html"' in page
    assert 'href="start.html#words"' in page


def test_all_commands_stand_on_a_page(site: Path) -> None:
    page = (site / "reference.html").read_text()
    for context in commands(click.Context(pdp8, info_name="pdp8")):
        assert f"<code>{context.command_path}</code>" in page
        for option in context.command.params:
            if isinstance(option, click.Option) and not option.hidden:
                assert option.opts[-1] in page


def test_the_site_is_small(site: Path) -> None:
    """Pages of modules show no sources, which stand in the repository."""
    assert sum(path.stat().st_size for path in site.rglob("*") if path.is_file()) < 16 << 20


def test_a_page_is_made_of_each_module(site: Path) -> None:
    page = (site / "api" / "pdp8.computer.hardware.processor.html").read_text()
    assert "Run one memory cycle." in page
    assert "Not emulated" in page
    assert "__pyx" not in page  # the sources are read, not what is compiled of them


def test_every_page_of_docs_can_be_searched(site: Path) -> None:
    index = json.loads((site / "search" / "search_index.json").read_text())
    found = {entry["location"].split("#")[0] for entry in index["docs"]}
    assert {page.with_suffix(".html").name for page in (HOUSE / "docs").glob("*.md")} <= found
