"""The runners in Python, C and Go with the reference: each names every value that differs."""

import gzip
import json
import re
import shutil
import sys
from functools import reduce
from operator import getitem
from pathlib import Path
from typing import Any

import pytest

from pdp8.vectors import runner
from pdp8.vectors.folder import GROUPS
from tests import commands
from tests.pdp8.vectors.faults import FAULTS
from tests.reference.compiling import compile_c, compiler
from tests.reference.model import FOLDER as REFERENCE
from tests.reference.model import HEADERS, SOURCES

ROOT = Path(__file__).parents[3]
CHANGED = ("pc", "ac", "link", "sr", "ion", "run", "ticks", "core", "mem_prot", "protect", "MA")
"""What is changed in a vector each; MA is of a cycle, which only an emulator by cycles can see."""
pytestmark = pytest.mark.skipif(compiler() is None, reason="the reference needs a C compiler")


@pytest.fixture(scope="module")
def changed(folder: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A file of vectors of different words, each with one value changed, and of one that is as it was."""
    places: dict[str, Any] = {"ticks": ("ticks",), "core": ("final", "ram", 0, 1), "MA": ("cycles", 0, 1)}
    every: dict[int, Any] = {
        int(vector["name"][:4], 8): vector for vector in runner.read(folder / "mem_prot.json.gz")
    }
    some = [every[word] for word in GROUPS["isz"][0o20 : 0o20 + len(CHANGED) + 1]]
    for vector, what in zip(some, CHANGED, strict=False):
        *path, last = places.get(what, ("final", what))
        reduce(getitem, path, vector)[last] ^= 1
    lines = ",\n".join(json.dumps(vector, separators=(",", ":")) for vector in some)
    file = tmp_path_factory.mktemp("changed") / "changed.json.gz"
    file.write_bytes(gzip.compress(f"[\n{lines}\n]\n".encode()))
    return file


def assert_said(printed: str, cycles: bool) -> None:
    """Compare what a runner printed of the changed vectors."""
    expected = CHANGED if cycles else CHANGED[:-1]
    lines = re.findall(r" \d: .*", printed)
    assert len(lines) == len(expected), printed
    for line, what in zip(lines, expected, strict=True):
        assert f": {what} " in line
    assert f"{len(CHANGED) + 1} played, {len(expected)} differ in {len(expected)} words" in printed


def in_folder(folder: Path, *command: str | Path, **given: Any) -> tuple[int, str]:
    """Run a command in the folder; return exit status and what is printed."""
    done = commands.run(*command, folder=folder, **given)
    return done.returncode, (done.stdout + done.stderr).decode()


@pytest.mark.slow("plays every word without compiled code, 10 s")
def test_the_runner_in_python(changed: Path, folder: Path, tmp_path: Path) -> None:
    """Of the vectors of devices too; its module is in the current folder."""
    (tmp_path / "mine.py").write_text("from tests.pdp8.vectors.emulators import ReferenceEmulator as Mine\n")
    command = sys.executable, folder / "runner.py", "mine:Mine"
    right = folder / "opr3.json.gz"
    status, said = in_folder(tmp_path, *command, changed, right, PYTHONPATH=str(ROOT))
    assert status == 1, said
    assert_said(said, cycles=True)
    some = [folder / f"{name}.json.gz" for name in ("teletype", "pc8l", "interrupts", "opr1", "hands")]
    status, said = in_folder(tmp_path, *command, "--model", "8/L", *some, PYTHONPATH=str(ROOT))
    assert status == 0, said
    assert said.count(" 0 differ") == len(some)
    assert "interrupts.json.gz: 1424 played" in said


@pytest.fixture
def toy(folder: Path, tmp_path: Path) -> Path:
    """A folder with the toy, and what the README adds to it in each language."""
    made, readme = tmp_path / "toy", (folder / "README.md").read_text()
    shutil.copytree(Path(__file__).with_name("toy"), made)
    for name, language in (("mine.py", "python"), ("mine.c", "c"), ("mine_test.go", "go")):
        (text,) = re.findall(rf"```{language}\n(.*?)```", readme, re.DOTALL)
        (made / name).write_text(text)
    return made


def test_the_first_result_of_the_readme(folder: Path, toy: Path) -> None:
    tad = folder / "tad.json.gz"
    assert in_folder(toy, sys.executable, folder / "runner.py", "mine:Mine", tad) == (
        0,
        "tad.json.gz: 4096 played, 0 differ in 0 words\n",
    )
    status, said = in_folder(toy, sys.executable, folder / "runner.py", "mine")
    assert (status, said.splitlines()[-1]) == (
        2,
        "runner.py: error: mine: MODULE:EMULATOR is needed, as in mine:Mine",
    )
    compile_c(toy / "runner", f"-I{folder}", folder / "runner.c", toy / "mine.c", toy / "toy.c")
    status, said = in_folder(toy, "bash", "-c", f"gzip -dc {tad} | ./runner")
    assert (status, said) == (0, "4096 played, 0 differ in 0 words\n")


@pytest.mark.slow("Go compiles its own library first")
@pytest.mark.skipif(shutil.which("go") is None, reason="Go is not installed")
def test_the_first_result_of_the_readme_in_go(folder: Path, toy: Path) -> None:
    for source in toy.glob("*.c"):
        source.unlink()
    runner = (folder / "runner_test.go").read_text().replace("\npackage main\n", "\npackage toy\n")
    (toy / "runner_test.go").write_text(runner)
    (toy / "go.mod").write_text("module toy\ngo 1.22\n")
    command = "go", "test", "-v", "-run", "TestVectors", "-files", "tad", "-vectors"
    status, said = in_folder(toy, *command, folder)
    assert status == 0, said
    assert "4096 played, 0 differ in 0 words" in said


class CRunner:
    """The C runner with the reference, of which one source is compiled again, with a fault or an option."""

    def __init__(self, folder: Path, work: Path) -> None:
        self.work = work
        self.options = f"-I{folder}", f"-I{REFERENCE}"
        self.parts = folder / "runner.c", *SOURCES, REFERENCE / "emulator.c"
        self.objects = {source: self.compiled(source, source.stem) for source in self.parts}
        packed = [folder / f"{name}.json.gz" for name in (*GROUPS, "mem_prot", "interrupts")]
        self.vectors = b"".join(gzip.decompress(path.read_bytes()) for path in packed)

    def compiled(self, source: Path, name: str, *options: str) -> Path:
        compile_c(self.work / f"{name}.o", "-c", *self.options, *options, source)
        return self.work / f"{name}.o"

    def run(self, part: Path, again: Path, vectors: bytes = b"") -> tuple[int, str]:
        """Link with the object `again` for `part`, and run; return exit status and what is printed."""
        program = self.work / "runner"
        compile_c(program, *{**self.objects, part: again}.values())
        return in_folder(self.work, program, stdin=vectors or self.vectors)


@pytest.fixture(scope="module")
def c_runner(folder: Path, tmp_path_factory: pytest.TempPathFactory) -> CRunner:
    return CRunner(folder, tmp_path_factory.mktemp("runner"))


@pytest.mark.parametrize("options", [(), ("-DCYCLES",)], ids=["instructions", "cycles"])
def test_the_runner_in_c(c_runner: CRunner, folder: Path, changed: Path, options: tuple[str, ...]) -> None:
    source = folder / "runner.c"
    by = source, c_runner.compiled(source, "by", *options)
    status, said = c_runner.run(*by)
    assert status == 0, said
    assert int(said.split()[0]) == c_runner.vectors.count(b'"cycles"') > 35_000
    status, said = c_runner.run(*by, gzip.decompress(changed.read_bytes()))
    assert status == 1
    assert_said(said, cycles=bool(options))


@pytest.mark.parametrize("fault", FAULTS)
def test_the_runner_in_c_finds_a_fault(c_runner: CRunner, fault: str) -> None:
    old, new = FAULTS[fault]
    (source,) = (source for source in c_runner.parts if old in source.read_text())
    faulty = c_runner.work / "faulty.c"
    faulty.write_text(source.read_text().replace(old, new))
    status, said = c_runner.run(source, c_runner.compiled(faulty, "faulty"))
    assert status == 1, said


@pytest.mark.slow("Go compiles its own C library first")
@pytest.mark.skipif(shutil.which("go") is None, reason="Go is not installed")
def test_the_runner_in_go(folder: Path, changed: Path, tmp_path: Path) -> None:
    emulator = [REFERENCE / f"emulator.{kind}" for kind in ("c", "go")]
    for source in (*SOURCES, *HEADERS, *emulator, folder / "emulator.h", folder / "runner_test.go"):
        shutil.copy(source, tmp_path)
    (tmp_path / "go.mod").write_text("module reference\ngo 1.21\n")
    command = "go", "test", "-run", "TestVectors", "-v", "-vectors"
    for cycles in ("", "1"):
        variables = {"CGO_CFLAGS": "-O2 -Wno-parentheses", "CYCLES": cycles}
        status, said = in_folder(tmp_path, *command, folder, **variables)
        assert status == 0, said
        assert "6144 played, 0 differ" in said
        status, said = in_folder(tmp_path, *command, changed.parent, **variables)
        assert status == 1
        assert_said(said, bool(cycles))
    status, said = in_folder(tmp_path, *command, folder, "-model", "8/M", **variables)
    assert status == 1
    assert 'no vector holds for the model "8/M"' in said
