"""PDP8_EXTENSIONS: what setup.py compiles, and what it says where it cannot."""

import runpy
import sys
from pathlib import Path
from types import ModuleType
from typing import Any

import pytest
import setuptools

HOUSE = Path(__file__).parents[2]


@pytest.fixture
def cython(monkeypatch: pytest.MonkeyPatch) -> None:
    """A Cython that translates nothing."""
    build = ModuleType("Cython.Build")
    build.cythonize = lambda extensions, **_: extensions  # type: ignore[attr-defined]
    monkeypatch.setitem(sys.modules, "Cython.Build", build)


def extensions(monkeypatch: pytest.MonkeyPatch, choice: str) -> list[setuptools.Extension]:
    """Return what setup.py hands to setuptools."""
    given: dict[str, Any] = {}
    monkeypatch.setattr(setuptools, "setup", given.update)
    monkeypatch.setenv("PDP8_EXTENSIONS", choice)
    runpy.run_path(str(HOUSE / "setup.py"))
    return list(given["ext_modules"])


@pytest.mark.usefixtures("cython")
@pytest.mark.parametrize(("choice", "optional"), [("auto", True), ("", True), ("require", False)])
def test_a_module_may_fail_to_compile_unless_all_are_required(
    monkeypatch: pytest.MonkeyPatch, choice: str, optional: bool
) -> None:
    built = extensions(monkeypatch, choice)
    typed = {
        path.with_suffix("").relative_to(HOUSE)
        for room in ("pal", "pdp8")
        for path in (HOUSE / room).rglob("*.pxd")
    }
    names = {Path(extension.name.replace(".", "/")) for extension in built}
    assert typed == {*names, Path("pdp8/computer/speed/piece")}  # that is compiled with the engine
    assert {extension.optional for extension in built} == {optional}


@pytest.mark.usefixtures("cython")
def test_nothing_is_compiled_for_the_wheel_for_every_platform(monkeypatch: pytest.MonkeyPatch) -> None:
    assert extensions(monkeypatch, "forbid") == []


def test_without_cython_only_a_required_build_fails(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "Cython.Build", None)
    assert extensions(monkeypatch, "auto") == []
    with pytest.raises(ImportError):
        extensions(monkeypatch, "require")


def test_another_choice_is_refused_by_name(monkeypatch: pytest.MonkeyPatch) -> None:
    with pytest.raises(SystemExit, match="PDP8_EXTENSIONS=yes: it may be auto, require, forbid"):
        extensions(monkeypatch, "yes")
