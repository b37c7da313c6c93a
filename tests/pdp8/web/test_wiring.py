"""Each control of the page names a method that its pane has."""

import re
from pathlib import Path

import pytest

WEB = Path(__file__).parents[3] / "pdp8" / "web"
CONTROL = re.compile(r'data-(?:click|change|input|submit)="([\w.]+)"')
SOURCES = [*WEB.glob("*.html"), *WEB.glob("*/*.html"), *WEB.glob("bench/*.mjs"), *WEB.glob("room/*.mjs")]
PARTS = {"switches.card": "class Card", "switches.panel": "class Panel"}
"""What a pane has in it that controls call."""


def _methods(name: str) -> set[str]:
    """Return the public methods of a pane of the page, of the page itself for ""."""
    files = [WEB / "workbench.mjs"] if not name else [*WEB.glob("*.mjs"), *WEB.glob("*/*.mjs")]
    wanted = PARTS.get(name, f"class {(name or 'bench').capitalize()}")
    text = next(text for file in files if re.search(rf"\b{wanted}\b", text := file.read_text()))
    body = text[text.index(wanted) :]
    return set(re.findall(r"^  (?:async )?(\w+)\(.*\{", body[: body.index("\n}\n")], re.MULTILINE))


@pytest.mark.parametrize("file", SOURCES, ids=lambda file: str(file.relative_to(WEB)))
def test_a_control_calls_what_there_is(file: Path) -> None:
    for called in set(CONTROL.findall(file.read_text())):
        owner, _, method = called.rpartition(".")
        assert method in _methods(owner), called
