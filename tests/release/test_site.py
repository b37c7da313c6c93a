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
    """The site, built; it is small, since pages of modules show no sources, which stand in the repository."""
    pytest.importorskip("mkdocs", reason="mkdocs, of the extra `docs`, is not installed")
    folder = tmp_path_factory.mktemp("site")
    command: list[str | Path] = [sys.executable, "-m", "mkdocs", "build", "-q", "--strict", "-d", folder]
    environment = {**os.environ, "NO_MKDOCS_2_WARNING": "1"}
    done = subprocess.run(command, cwd=HOUSE, env=environment, stderr=subprocess.PIPE, text=True, check=False)
    assert (done.returncode, done.stderr) == (0, "")
    assert sum(path.stat().st_size for path in folder.rglob("*") if path.is_file()) < 20 << 20
    return folder


@pytest.mark.parametrize(
    ("name", "texts"),
    [
        ("index.html", ["Moses Wong", 'href="pdp8.html"', 'href="start.html#words"']),
        ("api/pdp8.computer.hardware.processor.html", ["Run one memory cycle", "Not emulated"]),
    ],
)
def test_a_page_has_its_words(site: Path, name: str, texts: list[str]) -> None:
    """The first is the README; each module has one, from its source, not from what is compiled of it."""
    page = (site / name).read_text()
    assert [text for text in texts if text not in page] == []
    assert "__pyx" not in page


def test_all_commands_stand_on_a_page(site: Path) -> None:
    page = (site / "reference.html").read_text()
    for context in commands(click.Context(pdp8, info_name="pdp8")):
        assert f"<code>{context.command_path}</code>" in page
        for option in context.command.params:
            if isinstance(option, click.Option) and not option.hidden:
                assert option.opts[-1] in page


def test_every_page_of_docs_can_be_searched(site: Path) -> None:
    index = json.loads((site / "search" / "search_index.json").read_text())
    found = {entry["location"].split("#")[0] for entry in index["docs"]}
    assert {page.with_suffix(".html").name for page in (HOUSE / "docs").glob("*.md")} <= found
