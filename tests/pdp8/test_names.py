"""What `import pdp8` gives a script, and what a script's own files may be called."""

import re
import sys
from pathlib import Path

import pytest

import pdp8
from tests import commands

HOUSE = Path(__file__).parents[2]
ROOMS = ("nc", "pal", "programs", "tapes")


def python(folder: Path, *arguments: str) -> commands.Done:
    return commands.run(sys.executable, *arguments, folder=folder)


@pytest.fixture
def shadowed(tmp_path: Path) -> Path:
    """A folder whose files bear the names of all our packages but pdp8."""
    for room in ROOMS:
        (tmp_path / f"{room}.py").write_text("raise SystemExit('the file of the script was imported')\n")
    return tmp_path


def test_every_name_can_be_imported_and_is_listed() -> None:
    assert set(pdp8.__all__) <= set(dir(pdp8))
    assert all(getattr(pdp8, name) is not None for name in pdp8.__all__)
    assert re.fullmatch(r"\d+\.\d+\.\d+", pdp8.__version__)
    with pytest.raises(AttributeError, match="no attribute 'nothing'"):
        pdp8.nothing  # noqa: B018


def test_a_script_runs_beside_files_with_our_packages_names(shadowed: Path) -> None:
    script = re.search(r"```python\n(.*?)```", (HOUSE / "docs" / "python.md").read_text(), re.DOTALL)
    assert script
    (shadowed / "script.py").write_text(script[1])
    done = python(shadowed, "script.py")
    assert b" 13321 " in done.stdout, done.stderr.decode()


def test_the_command_runs_beside_files_with_our_packages_names(shadowed: Path) -> None:
    done = python(shadowed, "-m", "pdp8", "run", "hello.pal", "--quiet")
    assert (done.returncode, b"HELLO" in bytes(frame & 0o177 for frame in done.stdout)) == (0, True), (
        done.stderr
    )


def test_a_file_that_was_imported_under_our_name_is_named(tmp_path: Path) -> None:
    (tmp_path / "programs.py").write_text("")
    done = python(tmp_path, "-c", "import programs, pdp8; pdp8.part")
    assert f"{tmp_path / 'programs.py'} was imported as 'programs'".encode() in done.stderr


def test_a_file_that_ours_hides_is_named_once(shadowed: Path) -> None:
    """The script runs on; a folder of tapes beside it hides nothing."""
    (shadowed / "tapes.py").unlink()
    (shadowed / "tapes").mkdir()
    done = python(
        shadowed, "-c", "import pdp8; pdp8.part; import programs; import tapes; print(programs.__file__)"
    )
    said = done.stderr.decode()
    assert (done.returncode, said.count("UserWarning")) == (0, 1), said
    assert f"{shadowed / 'programs.py'} is hidden: 'programs' is {HOUSE / 'programs' / '__init__.py'}" in said


def test_importing_the_package_imports_nothing_heavy(tmp_path: Path) -> None:
    done = python(tmp_path, "-c", "import sys, pdp8; print(*sys.modules)")
    loaded = set(done.stdout.decode().split())
    assert not loaded & {"click", "numpy", "rich", "tapes", "pal", "programs", "nc", "pdp8.computer"}


def test_each_package_is_typed() -> None:
    assert all((HOUSE / room / "py.typed").exists() for room in (*ROOMS, "pdp8"))
