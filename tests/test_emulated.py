"""The page that says what is not emulated, beside the files that say it."""

import re
from importlib import import_module
from pathlib import Path

import pytest

HOUSE = Path(__file__).parent.parent


def modules() -> list[str]:
    packages = ("tapes", "pal", "pdp8", "programs", "nc")
    return [
        str(path.relative_to(HOUSE)) for name in packages for path in sorted((HOUSE / name).rglob("*.py"))
    ]


@pytest.mark.parametrize("path", [path for path in modules() if not re.search("console|/cli|__main__", path)])
def test_what_a_file_leaves_out_stands_in_the_table_too(path: str) -> None:
    said = import_module(path.removesuffix(".py").removesuffix("/__init__").replace("/", ".")).__doc__ or ""
    if "Not emulated" in said or "**not emulated**" in said:
        assert f"`{path}`" in (HOUSE / "docs" / "emulated.md").read_text()
