"""The vectors, with few states: the same bytes always, and every machine passes them."""

import gzip
import json
import shutil
import subprocess
from collections import Counter
from pathlib import Path
from typing import Any

import pytest

from pdp8.vectors import runner
from pdp8.vectors.folder import GROUPS, files
from tests.conftest import Shell
from tests.pdp8.vectors.emulators import EngineEmulator, ProcessorEmulator, ReferenceEmulator
from tests.pdp8.vectors.faults import FAULTS
from tests.reference.compiling import compile_c, compiler
from tests.reference.model import FOLDER as REFERENCE
from tests.reference.model import SOURCES

STATES = 8
needs_c = pytest.mark.skipif(compiler() is None, reason="the reference needs a C compiler")


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A set of vectors with 8 states of each word."""
    folder = tmp_path_factory.mktemp("vectors")
    for name, content in files(STATES):
        (folder / name).write_bytes(content)
    return folder


def read(path: Path) -> list[dict[str, Any]]:
    vectors: list[dict[str, Any]] = json.loads(gzip.decompress(path.read_bytes()))
    return vectors


def test_made_twice_they_are_the_same_bytes(folder: Path, shell: Shell) -> None:
    """The second time by the command, in another process."""
    done = shell(f"PYTHONHASHSEED=7 pdp8 vectors --out again --states {STATES} && cd again && cksum *")
    assert done.returncode == 0, done.stderr
    first = subprocess.run("cksum *", shell=True, cwd=folder, capture_output=True, check=True)
    assert done.stdout == first.stdout


def test_every_word_is_there_in_so_many_states(folder: Path) -> None:
    for name, words in GROUPS.items():
        count = Counter(int(vector["name"].split()[0], 8) for vector in read(folder / f"{name}.json.gz"))
        assert count == dict.fromkeys(words, STATES), name


def test_a_hundred_states_stay_under_5_megabytes(folder: Path) -> None:
    """More states pack better, not worse."""
    size = sum(path.stat().st_size for path in folder.glob("*.json.gz"))
    assert size / STATES * 100 < 8_000_000


def test_a_vector_has_the_form_that_the_readme_says(folder: Path) -> None:
    """TAD I 0017, autoindexed: three cycles, and every word they touch."""
    vector = next(one for one in read(folder / "tad.json.gz") if one["name"] == "1417 4")
    assert list(vector) == ["name", "initial", "final", "ticks", "cycles"]
    registers = ["pc", "ac", "link", "sr", "ion", "mem_prot", "ram"]
    assert list(vector["initial"]) == registers
    assert list(vector["final"]) == [*registers, "run", "protect"]
    assert vector["ticks"] == 96
    assert [state for state, _, _ in vector["cycles"]] == ["FETCH", "DEFER", "EXECUTE"]
    assert [address for address, _ in vector["initial"]["ram"]] == sorted(
        {ma for _, ma, _ in vector["cycles"]}
    )


@pytest.mark.slow("every vector of a folder")
@pytest.mark.parametrize("emulator", [ProcessorEmulator, EngineEmulator])
def test_our_machines_pass(folder: Path, emulator: type, capsys: pytest.CaptureFixture[str]) -> None:
    assert runner.main(folder, emulator()) == 0, capsys.readouterr().out


@needs_c
def test_the_reference_passes_the_devices(folder: Path, tmp_path: Path) -> None:
    for name in ("differences.json", "teletype.json.gz", "pc8l.json.gz", "interrupts.json.gz"):
        shutil.copy(folder / name, tmp_path)
    assert runner.main(tmp_path, ReferenceEmulator()) == 0


@pytest.mark.skipif(shutil.which("node") is None, reason="Node.js is not installed")
def test_the_machine_of_the_page_passes(folder: Path) -> None:
    driver = Path(__file__).parent / "page_machine.mjs"
    done = subprocess.run(["node", driver, folder], capture_output=True, text=True, check=True)
    results = json.loads(done.stdout)
    assert {file: wrong for file, (_, wrong) in results.items() if wrong} == {}
    assert sum(count for count, _ in results.values()) > 4096 * STATES


def test_the_runner_names_a_difference(folder: Path) -> None:
    vector = read(folder / "opr1.json.gz")[0]
    wrong = vector | {"final": vector["final"] | {"ac": vector["final"]["ac"] ^ 1}}
    found = runner.play(wrong, ProcessorEmulator())
    assert found is not None
    assert found.startswith("final ac is ")


def test_another_models_words_are_passed_over(folder: Path) -> None:
    rules = json.loads((folder / "differences.json").read_text())["rules"]
    words = {
        model: {word for word in GROUPS["opr1"] if runner.passed_over(_fetched(word), rules, model)}
        for model in ("8/I", "8/E", "8")
    }
    assert words["8/I"] == set()
    assert words["8/E"] == {w for w in GROUPS["opr1"] if w & 0o14 == 0o14 or w & 0o16 == 0o2}
    assert {0o7005, 0o7011, 0o7014} <= words["8"]


def _fetched(word: int) -> dict[str, Any]:
    return {"cycles": [["FETCH", 0o200, word]]}


class Runner:
    """The C runner with the reference, of which one source is compiled again with a fault."""

    def __init__(self, folder: Path, work: Path) -> None:
        self.work = work
        self.options = f"-I{folder}", f"-I{REFERENCE}"
        self.parts = {
            source.name: source for source in (folder / "runner.c", *SOURCES, REFERENCE / "emulator.c")
        }
        self.objects = {name: self.object(source) for name, source in self.parts.items()}
        packed = [folder / f"{name}.json.gz" for name in (*GROUPS, "interrupts")]
        self.vectors = b"".join(gzip.decompress(path.read_bytes()) for path in packed)

    def object(self, source: Path) -> Path:
        compiled = self.work / f"{source.stem}.o"
        compile_c(compiled, "-c", *self.options, source)
        return compiled

    def run(self, *objects: Path) -> tuple[int, str]:
        """Link and run; return exit status and what is printed."""
        program = self.work / "runner"
        compile_c(program, *objects)
        done = subprocess.run([program], input=self.vectors, capture_output=True, check=False)
        return done.returncode, done.stdout.decode()

    def run_with(self, old: str, new: str) -> tuple[int, str]:
        """Run with `old` replaced by `new` in the one source that has it once."""
        (name,) = (name for name, source in self.parts.items() if old in source.read_text())
        text = self.parts[name].read_text()
        assert text.count(old) == 1
        faulty = self.work / f"faulty-{name}"
        faulty.write_text(text.replace(old, new))
        others = [compiled for other, compiled in self.objects.items() if other != name]
        return self.run(*others, self.object(faulty))


@pytest.fixture(scope="module")
def c_runner(folder: Path, tmp_path_factory: pytest.TempPathFactory) -> Runner:
    if compiler() is None:
        pytest.skip("the reference needs a C compiler")
    return Runner(folder, tmp_path_factory.mktemp("runner"))


def test_the_runner_in_c_passes_the_reference(c_runner: Runner) -> None:
    status, said = c_runner.run(*c_runner.objects.values())
    assert status == 0, said
    assert int(said.split()[0]) > 4096 * STATES


@pytest.mark.parametrize("fault", FAULTS)
def test_the_runner_in_c_finds_a_fault(c_runner: Runner, fault: str) -> None:
    status, said = c_runner.run_with(*FAULTS[fault])
    assert status == 1, said
