"""The scripts of docs/python.md: each prints what it says; mypy takes it; help(pdp8) names what it uses.

What a line prints stands behind it after two blanks and a number sign.
"""

import ast
import io
import pydoc
import re
import sys
from pathlib import Path

import numpy
import pytest

import pdp8
from tests import commands

HOUSE = Path(__file__).parents[2]
PAGE = (HOUSE / "docs" / "python.md").read_text()
SCRIPTS = dict(re.findall(r"^## (.*?)\n.*?^```python\n(.*?)^```", PAGE, re.MULTILINE | re.DOTALL))
PRINTED = re.compile(r"^ *print\(.*\)  # (.*)$", re.MULTILINE)


def test_there_are_eight() -> None:
    assert len(SCRIPTS) == PAGE.count("```python") == 8
    assert all(PRINTED.search(script) for script in SCRIPTS.values())


@pytest.mark.parametrize("title", SCRIPTS)
def test_a_script_prints_what_it_says(title: str, tmp_path: Path) -> None:
    (tmp_path / "script.py").write_text(SCRIPTS[title])
    done = commands.run(sys.executable, "script.py", folder=tmp_path)
    printed = [line.strip() for line in done.stdout.decode().splitlines()]
    assert printed == [line.strip() for line in PRINTED.findall(SCRIPTS[title])], done.stderr.decode()


@pytest.mark.slow("mypy reads numpy")
def test_mypy_takes_every_script(tmp_path: Path) -> None:
    names = [f"script{number}.py" for number in range(len(SCRIPTS))]
    for name, script in zip(names, SCRIPTS.values(), strict=True):
        (tmp_path / name).write_text(script)
    done = commands.run(
        *(sys.executable, "-m", "mypy", "--strict", *names),
        folder=tmp_path,
        MYPYPATH=str(HOUSE),
    )
    assert done.returncode == 0, done.stdout.decode()


@pytest.mark.parametrize("title", SCRIPTS)
def test_help_names_everything_a_script_uses(title: str) -> None:
    told = set(re.findall(r"\w+", pydoc.plain(pydoc.render_doc(pdp8))))
    known = {*dir(str), *dir(numpy.ndarray), *dir(io.TextIOWrapper), "period"}
    used = {node.attr for node in ast.walk(ast.parse(SCRIPTS[title])) if isinstance(node, ast.Attribute)}
    assert used - told - known == set()
