"""PDP8_EXTENSIONS: what setup.py compiles, and what it says where it cannot."""

import runpy
import sys
from collections.abc import Callable
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest
import setuptools
from setuptools.errors import CompileError

HOUSE = Path(__file__).parents[2]
Given = Callable[[str], dict[str, Any]]
Extensions = Callable[[str], list[setuptools.Extension]]


@pytest.fixture
def given(monkeypatch: pytest.MonkeyPatch) -> Given:
    """What setup.py hands to setuptools, by a Cython that translates nothing."""
    taken: dict[str, Any] = {}
    monkeypatch.setattr(setuptools, "setup", taken.update)
    cython = SimpleNamespace(cythonize=lambda extensions, **_: extensions)
    monkeypatch.setitem(sys.modules, "Cython.Build", cython)

    def given(choice: str) -> dict[str, Any]:
        monkeypatch.setenv("PDP8_EXTENSIONS", choice)
        runpy.run_path(str(HOUSE / "setup.py"))
        return taken

    return given


@pytest.fixture
def extensions(given: Given) -> Extensions:
    """The extensions among these."""
    return lambda choice: list(given(choice)["ext_modules"])


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


@pytest.mark.parametrize("choice", ["auto", "require"])
def test_without_a_compiler_it_says_so_once_and_goes_on_unless_required(
    choice: str,
    given: Given,
    monkeypatch: pytest.MonkeyPatch,
    tmp_path: Path,
    capfd: pytest.CaptureFixture[str],
) -> None:
    build = given(choice)["cmdclass"]["build_ext"]
    monkeypatch.delitem(sys.modules, "Cython.Build")  # the true one comes in its place
    monkeypatch.setenv("CC", "no-such-compiler")
    monkeypatch.chdir(tmp_path)
    found = [setuptools.Extension(name, [f"{name}.c"], optional=choice == "auto") for name in "abc"]
    command = build(setuptools.Distribution({"ext_modules": found}))
    command.ensure_finalized()
    if choice == "require":
        with pytest.raises(CompileError):
            command.run()
        return
    command.run()
    said = capfd.readouterr()
    assert said.out.count("no-such-compiler") == said.out.count("gcc, python3-dev") == 1
    assert not said.err
