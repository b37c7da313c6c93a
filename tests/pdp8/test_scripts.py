"""A script with `import pdp8`: those of docs/python.md, its names, what its own files may be called.

What a line of docs/python.md prints stands behind it after two blanks and a number sign.
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
ROOMS = ("nc", "pal", "programs", "tapes")
PAGE = (HOUSE / "docs" / "python.md").read_text()
SCRIPTS = dict(re.findall(r"^## (.*?)\n.*?^```python\n(.*?)^```", PAGE, re.MULTILINE | re.DOTALL))
PRINTED = re.compile(r"^ *print\(.*\)  # (.*)$", re.MULTILINE)


def python(folder: Path, *arguments: str) -> tuple[str, str]:
    """Return what Python prints, and what it says on standard error."""
    done = commands.run(sys.executable, *arguments, folder=folder)
    return done.stdout.decode(errors="replace"), done.stderr.decode()


def test_there_are_eight() -> None:
    assert len(SCRIPTS) == PAGE.count("```python") == 8
    assert all(PRINTED.search(script) for script in SCRIPTS.values())


@pytest.fixture
def shadowed(tmp_path: Path) -> Path:
    """A folder whose files bear the names of all our packages but pdp8."""
    for room in ROOMS:
        (tmp_path / f"{room}.py").write_text("raise SystemExit('the file of the script was imported')\n")
    return tmp_path


@pytest.mark.parametrize("title", SCRIPTS)
def test_a_script_prints_what_it_says_beside_any_files(title: str, shadowed: Path) -> None:
    (shadowed / "script.py").write_text(SCRIPTS[title])
    printed, said = python(shadowed, "script.py")
    expected = [line.strip() for line in PRINTED.findall(SCRIPTS[title])]
    assert [line.strip() for line in printed.splitlines()] == expected, said


@pytest.mark.slow("mypy reads numpy")
def test_mypy_takes_every_script(tmp_path: Path) -> None:
    names = [f"script{number}.py" for number in range(len(SCRIPTS))]
    for name, script in zip(names, SCRIPTS.values(), strict=True):
        (tmp_path / name).write_text(script)
    line = sys.executable, "-m", "mypy", "--strict", *names
    done = commands.run(*line, folder=tmp_path, MYPYPATH=str(HOUSE))
    assert done.returncode == 0, done.stdout.decode()


@pytest.mark.parametrize("title", SCRIPTS)
def test_help_names_everything_a_script_uses(title: str) -> None:
    told = set(re.findall(r"\w+", pydoc.plain(pydoc.render_doc(pdp8))))
    known = {*dir(str), *dir(numpy.ndarray), *dir(io.TextIOWrapper), "period"}
    used = {node.attr for node in ast.walk(ast.parse(SCRIPTS[title])) if isinstance(node, ast.Attribute)}
    assert used - told - known == set()


def test_every_name_can_be_imported_and_is_listed() -> None:
    shown = [name for name in dir(pdp8) if name[:2] != "__"]
    assert shown == sorted(pdp8.__all__)
    assert all(getattr(pdp8, name) is not None for name in pdp8.__all__)
    assert re.fullmatch(r"\d+\.\d+\.\d+", pdp8.__version__)
    with pytest.raises(AttributeError, match="no attribute 'nothing'"):
        pdp8.nothing  # noqa: B018


def test_the_command_runs_beside_any_files(shadowed: Path) -> None:
    assert "HLT at 0205" in python(shadowed, "-m", "pdp8", "run", "hello.pal")[1]


def test_a_file_that_was_imported_under_our_name_is_named(tmp_path: Path) -> None:
    (tmp_path / "programs.py").write_text("")
    said = python(tmp_path, "-c", "import programs, pdp8; pdp8.part")[1]
    assert f"{tmp_path / 'programs.py'} was imported as 'programs'" in said


def test_a_file_that_ours_hides_is_named_once(shadowed: Path) -> None:
    """The script runs on; a folder of tapes beside it hides nothing."""
    (shadowed / "tapes.py").unlink()
    (shadowed / "tapes").mkdir()
    script = "import pdp8; pdp8.part; import programs; import tapes; print(programs.__file__)"
    printed, said = python(shadowed, "-c", script)
    ours = HOUSE / "programs" / "__init__.py"
    assert (printed.strip(), said.count("UserWarning")) == (str(ours), 1), said
    assert f"{shadowed / 'programs.py'} is hidden: 'programs' is {ours}" in said


def test_importing_the_package_imports_nothing_heavy(tmp_path: Path) -> None:
    loaded = python(tmp_path, "-c", "import sys, pdp8; print(*sys.modules)")[0].split()
    assert not {"click", "numpy", "rich", "tapes", "pal", "programs", "nc", "pdp8.computer"}.intersection(
        loaded
    )


def test_each_package_is_typed() -> None:
    assert all((HOUSE / room / "py.typed").exists() for room in (*ROOMS, "pdp8"))


def test_an_assembly_says_what_it_is() -> None:
    assert repr(pdp8.assemble("*200\n\tCLA\n\tQQ\n$\n", names=["own.pal"])) == (
        "<Assembly of own.pal in pal3: 2 words, 1 error>"
    )
    assert repr(pdp8.assemble("*200\n\tTAD (5)\n$\n", "", names=["a", "b"], dialect="pal8")) == (
        "<Assembly of a, b in pal8: 2 words, no errors>"
    )


def test_words_come_back_as_a_source_of_them() -> None:
    words = pdp8.assemble(pdp8.tape("eia.pal")).words
    assert pdp8.assemble(pdp8.disassemble(words)).words == words
    machine = pdp8.Machine()
    history = pdp8.History(machine)
    machine.load({0o200: 0o7001, 0o201: 0o5200})
    machine.start(0o200)
    machine.run(instructions=3)
    assert history.instructions == 3
