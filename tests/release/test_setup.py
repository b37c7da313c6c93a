"""PDP8_EXTENSIONS: what setup.py compiles, and what it says where it cannot."""

import runpy
import sys
from collections.abc import Callable
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest
import setuptools

HOUSE = Path(__file__).parents[2]
Extensions = Callable[[str], list[setuptools.Extension]]


@pytest.fixture
def extensions(monkeypatch: pytest.MonkeyPatch) -> Extensions:
    """What setup.py hands to setuptools, by a Cython that translates nothing."""
    given: dict[str, Any] = {}
    monkeypatch.setattr(setuptools, "setup", given.update)
    cython = SimpleNamespace(cythonize=lambda extensions, **_: extensions)
    monkeypatch.setitem(sys.modules, "Cython.Build", cython)

    def extensions(choice: str) -> list[setuptools.Extension]:
        monkeypatch.setenv("PDP8_EXTENSIONS", choice)
        runpy.run_path(str(HOUSE / "setup.py"))
        return list(given["ext_modules"])

    return extensions


def test_a_module_may_fail_to_compile_unless_all_are_required(extensions: Extensions) -> None:
    found = (path for room in ("pal", "pdp8") for path in (HOUSE / room).rglob("*.pxd"))
    typed = {".".join(path.with_suffix("").relative_to(HOUSE).parts) for path in found}
    for choice, optional in (("auto", True), ("", True), ("require", False)):
        built = extensions(choice)
        assert typed == {*(each.name for each in built), "pdp8.computer.speed.piece"}  # part of the engine
        assert {extension.optional for extension in built} == {optional}
    assert extensions("forbid") == [], "the wheel for every platform"


def test_without_cython_only_a_required_build_fails(
    extensions: Extensions, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setitem(sys.modules, "Cython.Build", None)
    assert extensions("auto") == []
    with pytest.raises(ImportError):
        extensions("require")


def test_another_choice_is_refused_by_name(extensions: Extensions) -> None:
    with pytest.raises(SystemExit, match="PDP8_EXTENSIONS=yes: it may be auto, require, forbid"):
        extensions("yes")
