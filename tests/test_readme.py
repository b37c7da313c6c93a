"""Every command that README.md and docs/ show is run, and what they show is what it prints.

In a fenced block marked `console` a line that begins with `$ ` is a command, and the lines after it are what
it prints; `...` stands for anything, within a line or for any number of lines. All blocks of one file are one
sitting in one folder; a block marked with a file's name, as in `toml shift.toml`, is that file there, and
so are the photographs that the page shows. The tapes that a file `tapes.sha256` lists are there too: DEC's,
from the folder that the environment variable PDP8_TAPES names. What takes a terminal or makes the environment
(`make`, `git`, `panel`) stands in blocks of `sh`.
"""

import os
import re
from pathlib import Path

import pytest

from tests.conftest import Shell

HOUSE = Path(__file__).parent.parent
README = HOUSE / "README.md"
PAGES = [README, *sorted((HOUSE / "docs").glob("**/*.md"))]
PHOTOGRAPH = re.compile(r"^!\[.*\]\((\S+\.jpg)\)$", re.MULTILINE)
FILE = re.compile(r"^```\w+ (\S+)\n(.*?)^```$", re.MULTILINE | re.DOTALL)
BLOCK = re.compile(r"^```console\n(.*?)^```$", re.MULTILINE | re.DOTALL)
SHOWN = re.compile(r"^\$ (.*(?:\\\n.*)*)\n((?:(?!\$ ).*\n)*)", re.MULTILINE)


def sittings(page: Path) -> list[tuple[str, str]]:
    return [shown for block in BLOCK.findall(page.read_text()) for shown in SHOWN.findall(block)]


def pattern(expected: str) -> str:
    """Return the regular expression of what is shown: `...` stands for anything."""
    return "".join(r"(?:.*\n)*?" if line == "..." else f"{_line(line)}\n" for line in expected.splitlines())


def _line(shown: str) -> str:
    return ".*".join(re.escape(piece) for piece in shown.split("..."))


@pytest.mark.slow("each command of a page is a process")
@pytest.mark.parametrize("page", PAGES, ids=lambda page: str(page.relative_to(HOUSE)))
def test_what_the_page_shows_is_what_happens(page: Path, shell: Shell, tmp_path: Path) -> None:
    for photograph in PHOTOGRAPH.findall(page.read_text()):
        (tmp_path / photograph).symlink_to(page.parent / photograph)
    for name, content in FILE.findall(page.read_text()):
        (tmp_path / name).write_text(content)
    _bring_tapes(tmp_path)
    for command, shown in sittings(page):
        done = shell(f"{{ {command}\n}} 2>&1")
        printed = done.stdout.decode()
        assert "Traceback" not in printed
        if not re.fullmatch(pattern(shown.rstrip("\n")), _whole_lines(printed)):
            pytest.fail(f"$ {command}\n{printed}--- is shown as ---\n{shown}", pytrace=False)


def _bring_tapes(folder: Path) -> None:
    """Put the tapes that tapes.sha256 lists into `folder`, or skip the test."""
    listed = folder / "tapes.sha256"
    where = Path(os.environ.get("PDP8_TAPES", "nowhere")).absolute()
    for line in listed.read_text().splitlines() if listed.exists() else ():
        name = line.split()[1]
        if not (where / name).exists():
            pytest.skip(f"PDP8_TAPES names no folder with {name}, of DEC's tapes")
        (folder / name).symlink_to(where / name)


def _whole_lines(printed: str) -> str:
    text = printed.strip("\n")
    return f"{text}\n" if text else ""
