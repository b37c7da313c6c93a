"""The pages that `make docs` makes of the docstrings, and the page that says what is not emulated."""

from importlib import import_module
from pathlib import Path

import pytest

HOUSE = Path(__file__).parent.parent


def test_a_page_is_made_of_a_module(tmp_path: Path) -> None:
    pdoc = pytest.importorskip("pdoc", reason="pdoc, the extra `docs`, is not installed")
    pdoc.pdoc("tapes.frames", "pdp8.computer.processor", output_directory=tmp_path)
    page = (tmp_path / "pdp8" / "computer" / "processor.html").read_text()
    assert "Run one memory cycle." in page
    assert "Not emulated" in page


def modules() -> list[str]:
    packages = ("tapes", "pal", "pdp8", "programs", "nc")
    return [
        str(path.relative_to(HOUSE)) for name in packages for path in sorted((HOUSE / name).rglob("*.py"))
    ]


@pytest.mark.parametrize("path", [path for path in modules() if "console" not in path and "/cli" not in path])
def test_what_a_file_leaves_out_stands_in_the_table_too(path: str) -> None:
    said = import_module(path.removesuffix(".py").removesuffix("/__init__").replace("/", ".")).__doc__ or ""
    if "Not emulated" in said or "**not emulated**" in said:
        assert f"`{path}`" in (HOUSE / "docs" / "emulated.md").read_text()
