"""The vectors, with few states: the same bytes always, and the page's machine passes them."""

import gzip
import json
import shutil
import subprocess
from collections import Counter
from pathlib import Path
from typing import Any

import pytest

from pal.models import MODELS
from pdp8.vectors import runner
from pdp8.vectors.folder import GROUPS
from tests.conftest import Shell
from tests.pdp8.vectors.conftest import STATES
from tests.pdp8.web.node import modules


def read(path: Path) -> list[dict[str, Any]]:
    return list(runner.read(path))


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


def test_a_vector_has_the_form_that_the_readme_says(folder: Path) -> None:
    """TAD I 0017, autoindexed: three cycles, and every word they touch; a file is JSON as a whole."""
    whole = json.loads(gzip.decompress((folder / "tad.json.gz").read_bytes()))
    assert whole == read(folder / "tad.json.gz")
    vector = next(one for one in read(folder / "tad.json.gz") if one["name"] == "1417 4")
    assert list(vector) == ["name", "models", "instructions", "initial", "final", "ticks", "cycles"]
    assert vector["instructions"] == 1
    registers = ["pc", "ac", "link", "sr", "ion"]
    assert list(vector["initial"]) == [*registers, "ram"]
    assert list(vector["final"]) == [*registers, "run", "ram"]
    assert vector["ticks"] == 96
    assert [state for state, _, _ in vector["cycles"]] == ["FETCH", "DEFER", "EXECUTE"]
    assert [address for address, _ in vector["initial"]["ram"]] == sorted(
        {ma for _, ma, _ in vector["cycles"]}
    )


def test_mem_prot_is_up_in_one_file_only(folder: Path) -> None:
    """There it stops hundreds of ISZ, DCA and JMS each."""
    for file in folder.glob("*.json.gz"):
        up = {vector["initial"].get("mem_prot") for vector in read(file)}
        assert up == ({1} if file.name == "mem_prot.json.gz" else {None}), file.name
    vectors = read(folder / "mem_prot.json.gz")
    stopped = Counter(vector["name"][0] for vector in vectors if vector["final"]["protect"])
    assert set(stopped) == set("234")
    assert min(stopped.values()) > 200


def test_a_vector_says_how_many_instructions_it_holds(folder: Path) -> None:
    """Of a program that stops at its HLT, so many as were run; the cycle of an interrupt is none."""
    for file in folder.glob("*.json.gz"):
        for vector in read(file):
            if "cycles" in vector:
                fetched = sum(state == "FETCH" for state, _, _ in vector["cycles"])
                assert vector["instructions"] == fetched, vector["name"]
    counts = {vector["name"]: vector["instructions"] for vector in read(folder / "interrupts.json.gz")}
    assert counts["6001 7402 0 flags 1"] == 2
    assert counts["6001 6002 7000 0 flags 1"] == 3


@pytest.mark.skipif(shutil.which("node") is None, reason="Node.js is not installed")
def test_the_machine_of_the_page_passes(folder: Path) -> None:
    driver = Path(__file__).parent / "page_machine.mjs"
    done = subprocess.run(["node", driver, modules(), folder], capture_output=True, text=True, check=True)
    results = json.loads(done.stdout)
    assert {file: wrong for file, (_, wrong) in results.items() if wrong} == {}
    assert sum(count for count, _ in results.values()) > 4096 * STATES


def test_models_are_those_that_do_the_same(folder: Path) -> None:
    words: dict[str, set[int]] = {model: set() for model in MODELS}
    for vector in read(folder / "opr1.json.gz"):
        for model in vector["models"]:
            words[model].add(int(vector["name"][:4], 8))
    assert words["8/L"] == words["8/I"] == set(GROUPS["opr1"])
    assert words["8/L"] - words["8/E"] == {w for w in GROUPS["opr1"] if w & 0o14 == 0o14 or w & 0o16 == 0o2}
    assert {0o7005, 0o7011, 0o7014} <= words["8/L"] - words["8"]
