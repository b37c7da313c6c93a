"""What is omitted, trusted and compiled of the modules that are translated is there."""

import ast

import pytest

from pdp8.web.translator import COMPILED, MODULES, OMITTED, TRUSTED, _all
from tests.pdp8.computer.speed import forms


@pytest.mark.parametrize("names", [OMITTED, TRUSTED], ids=["omitted", "trusted"])
def test_each_name_is_defined_in_its_module(names: dict[str, str]) -> None:
    for module, listed in names.items():
        assert _is_translated(module)
        tree = ast.parse(forms.beside(module, ".py").read_text(encoding="utf-8"))
        assert {*listed.replace(".", " ").split()} <= _defined(tree), module


def test_what_is_unchecked_is_compiled_too() -> None:
    assert COMPILED - {*forms.COMPILED} == {"pdp8.computer.speed.piece"}  # with the engine
    assert all(map(_is_translated, COMPILED))


def test_all_modules_of_a_package_are_those_beside_its_init() -> None:
    found = {path.stem for path in forms.beside("pdp8.computer.dectape", "").glob("*.py")}
    assert {*_all("pdp8.computer.dectape")} == found - {"__init__"}


def _is_translated(module: str) -> bool:
    package, _, name = module.rpartition(".")
    return name in MODULES[package].split() or MODULES[package] == "*"


def _defined(tree: ast.Module) -> set[str]:
    nodes = [node for node in ast.walk(tree) if isinstance(node, ast.FunctionDef | ast.ClassDef)]
    stored = [
        node for node in ast.walk(tree) if isinstance(node, ast.Name) and isinstance(node.ctx, ast.Store)
    ]
    return {node.name for node in nodes} | {node.id for node in stored}
