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


@pytest.mark.parametrize(("choice", "optional"), [("auto", True), ("", True), ("require", False)])
def test_a_module_may_fail_to_compile_unless_all_are_required(
    extensions: Extensions, choice: str, optional: bool
) -> None:
    built = extensions(choice)
    found = (path for room in ("pal", "pdp8") for path in (HOUSE / room).rglob("*.pxd"))
    typed = {".".join(path.with_suffix("").relative_to(HOUSE).parts) for path in found}
    assert typed == {*(each.name for each in built), "pdp8.computer.speed.piece"}  # compiled with the engine
    assert {extension.optional for extension in built} == {optional}


def test_nothing_is_compiled_for_the_wheel_for_every_platform(extensions: Extensions) -> None:
    assert extensions("forbid") == []


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
