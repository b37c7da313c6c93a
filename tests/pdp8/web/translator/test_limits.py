"""Both sides of each limit: what is refused, and beside it what is accepted and runs as in Python.

`limits.txt` is three modules. A line that ends in `# no: WHY` is refused with these words, and no other line
is. What a line shows after `# js: ` is in what becomes of its function: it is for what no value shows. Each
function that takes nothing is called in both languages, but for those whose names begin with `_`.
"""

import ast
import re
import sys
from collections.abc import Callable, Iterator
from pathlib import Path
from types import CodeType, FrameType, ModuleType
from typing import Any, NamedTuple
from unittest.mock import patch

import pytest

from pdp8.web.translator import modules, program
from tests.pdp8.web.node import called, needs_node, plain, write

_TEXT = Path(__file__).with_name("limits.txt").read_text(encoding="utf-8")
MODULES = dict(re.findall(r"^## (\w+)\n(.*?)(?=^## |\Z)", _TEXT, re.MULTILINE | re.DOTALL))
_FOLDER = Path(modules.__file__).parent
_OMITTED = "__repr__ _omitted"
_OTHERS = ("__init__", "__main__", "declarations")
_NOT_CALLED = {"Expressions.call"}
"""Calls has it."""


def _marked(text: str, mark: str) -> dict[int, str]:
    """Return what stands after a mark, by the number of its line."""
    lines = enumerate(text.split("\n"), 1)
    return {number: line.partition(mark)[2] for number, line in lines if mark in line}


class _Module(NamedTuple):
    """A module of limits.txt: its faults, its JavaScript, and its definitions that are accepted."""

    said: dict[int, str]
    text: str
    accepted: ast.Module


def _read(name: str) -> _Module:
    text, trusted, faults = MODULES[name], "", list[str]()
    if name == "trusted":
        trusted = " ".join(re.findall(r"^(?:def|class) (\w+)", text, re.MULTILINE))
    unchecked = (name,) if name == "unchecked" else ()
    made = modules.translate(
        {name: (name, text)}, {name: _OMITTED}, faults.append, unchecked, {name: trusted}
    )[name]
    said = {int(line): why.strip() for _, line, why in (fault.split(":", 2) for fault in faults)}
    tree = ast.parse(text)
    tree.body = [each for each in tree.body if said.keys().isdisjoint(_lines(each))]
    return _Module(said, made, tree)


def _functions(tree: ast.Module) -> list[ast.FunctionDef]:
    return [each for each in tree.body if isinstance(each, ast.FunctionDef)]


def _lines(node: ast.stmt) -> range:
    first = min((each.lineno for each in getattr(node, "decorator_list", ())), default=node.lineno)
    return range(first, (node.end_lineno or 0) + 1)


@pytest.mark.parametrize("name", MODULES)
def test_each_refusal_and_nothing_beside_it(name: str) -> None:
    said, wanted = _read(name).said, _marked(MODULES[name], "# no: ")
    assert said.keys() == wanted.keys(), said
    assert {line: why for line, why in said.items() if not why.startswith(wanted[line])} == {}


STATEMENTS = (
    *("if b: {}", "if b: pass\n    else: {}", "while b: {}", "for b in [1]: {}", "with held(): {}"),
    *("try: {}\n    finally: pass", "try: {}\n    except ValueError: pass"),
    *("try: f(a, b)\n    except ValueError: {}", "try: pass\n    finally: {}"),
    "\n    el".join(f"if b == {number}: {{}}" for number in range(6)),
)
_SET = """from collections.abc import Iterator
from contextlib import contextmanager
@contextmanager
def held() -> Iterator[None]: yield
def f(a: int | None, b: int) -> int:
    if a is None: return 0
    {}
    return a + 1
"""


@pytest.mark.parametrize("statement", STATEMENTS)
def test_what_a_test_said_of_a_name_holds_until_a_statement_sets_it(statement: str) -> None:
    for what, said in (
        ("c = 5", []),
        *((each, ["it may be None"]) for each in ("a = None", "b, a = 5, None")),
    ):
        faults = list[str]()
        modules.translate({"m": ("m", _SET.format(statement.replace("{}", what)))}, {}, faults.append)
        assert [fault.split(": ")[1] for fault in faults] == said, what


@pytest.mark.parametrize("name", MODULES)
def test_what_no_value_shows(name: str) -> None:
    _, text, tree = _read(name)
    pieces = dict(re.findall(r"^export function\*? (\w+)(.*?)(?=^export |\Z)", text, re.M | re.S))
    for line, shown in _marked(MODULES[name], "# js: ").items():
        [name] = [each.name for each in _functions(tree) if line in _lines(each)]
        assert shown in pieces[name]


@needs_node
@pytest.mark.parametrize("name", MODULES)
def test_what_is_accepted_does_as_in_python(name: str, tmp_path: Path) -> None:
    _, text, tree = _read(name)
    module = ModuleType(name)
    with patch.dict(sys.modules, {name: module}):  # where dataclasses look
        exec(compile(tree, name, "exec"), vars(module))
        own = [each for each in _functions(tree) if each.name[0] != "_" and not ast.unparse(each.args)]
        names = [each.name for each in own]
        wanted = {each: _value(getattr(module, each)) for each in names}
    write(tmp_path, {name: text})
    there = called(*((name, each) for each in names), folder=tmp_path)
    assert dict(zip(names, there, strict=True)) == wanted


def _value(function: Callable[[], Any]) -> Any:
    """Return what a function returns, or the error it raises, as `called` does."""
    try:
        return plain(function())
    except Exception as error:
        return f"{type(error).__name__}: {error}"


def test_each_function_of_the_translator_is_called() -> None:
    seen = set[str]()

    def note(frame: FrameType, event: str, _: object) -> None:
        if event == "call" and frame.f_code.co_filename.startswith(str(_FOLDER)):
            seen.add(frame.f_code.co_qualname)

    program.libraries.cache_clear()
    sys.setprofile(note)
    try:
        for name in MODULES:
            _read(name)
    finally:
        sys.setprofile(None)
    paths = [path for path in _FOLDER.glob("*.py") if path.stem not in _OTHERS]
    functions = {each for path in paths for each in _names(compile(path.read_text(), path, "exec"))}
    assert functions - seen == _NOT_CALLED


def _names(code: CodeType) -> Iterator[str]:
    """Yield the functions and methods in a piece of code by their qualified names."""
    for each in code.co_consts:
        if isinstance(each, CodeType):
            if each.co_flags & 1 and each.co_name[0] != "<" and each.co_name != "__annotate__":  # no class
                yield each.co_qualname
            yield from _names(each)
