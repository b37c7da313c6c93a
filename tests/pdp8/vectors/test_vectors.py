"""The vectors, with few states: the same bytes always, every word, the form that the README says."""

import gzip
import json
import subprocess
from collections import Counter
from collections.abc import Iterator
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest

from pal.models import MODELS
from pdp8.cli.shared.progress import Bar
from pdp8.vectors import folder as contents
from pdp8.vectors import runner
from pdp8.vectors.folder import GROUPS
from tests.conftest import Call, Shell, case
from tests.pdp8.vectors.conftest import STATES

Vectors = dict[str, list[dict[str, Any]]]


@pytest.fixture(scope="module")
def vectors(folder: Path) -> Vectors:
    """What is in each file."""
    return {file.name.partition(".")[0]: list(runner.read(file)) for file in folder.glob("*.json.gz")}


@pytest.mark.slow("all vectors, twice")
def test_made_twice_they_are_the_same_bytes(folder: Path, shell: Shell) -> None:
    """The second time by the command, in another process."""
    done = shell(
        f"PYTHONHASHSEED=7 pdp8 vectors --out again --states {STATES} --pipan8l && cd again && cksum *"
    )
    assert done.returncode == 0, done.stderr
    first = subprocess.run("cksum *", shell=True, cwd=folder, capture_output=True, check=True)
    assert done.stdout == first.stdout


@pytest.mark.parametrize("more", ["", " --pipan8l"])
def test_the_bar_is_full_with_the_last_file(
    more: str, folder: Path, call: Call, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    names = [path.name for path in folder.iterdir() if more or path.name != "hands.tcl"]
    monkeypatch.setattr(contents, "files", lambda states, pipan8l: ((name, b"") for name in names))
    totals: list[int] = []

    def bar(label: str, total: int) -> Bar:
        totals.append(total)
        return Bar(label, total)

    monkeypatch.setattr("pdp8.cli.vectors.Bar", bar)
    assert call(f"pdp8 vectors --out {tmp_path}{more}")[0] == 0
    assert totals == [len(names)]


def test_every_word_is_there_in_so_many_states(vectors: Vectors) -> None:
    for name, words in GROUPS.items():
        count = Counter(int(vector["name"].split()[0], 8) for vector in vectors[name])
        assert count == dict.fromkeys(words, STATES), name


def test_a_vector_has_the_form_that_the_readme_says(folder: Path, vectors: Vectors) -> None:
    """TAD I 0017, autoindexed: three cycles, and every word they touch; a file is JSON as a whole."""
    assert json.loads(gzip.decompress((folder / "tad.json.gz").read_bytes())) == vectors["tad"]
    vector = next(one for one in vectors["tad"] if one["name"] == "1417 4")
    assert " ".join(vector) == "name models instructions initial final ticks cycles"
    assert " ".join(vector["initial"]) == "pc ac link sr ion ram"
    assert " ".join(vector["final"]) == "pc ac link sr ion run ram"
    assert (vector["instructions"], vector["ticks"]) == (1, 96)
    states, addresses, _ = zip(*vector["cycles"], strict=True)
    assert states == ("FETCH", "DEFER", "EXECUTE")
    assert [address for address, _ in vector["initial"]["ram"]] == sorted(set(addresses))


class Recorded:
    """An emulator that does what a vector says."""

    def __init__(self, vector: dict[str, Any]) -> None:
        self.vector = vector
        self.cycle = iter(vector.get("cycles", ())).__next__
        self.play = lambda initial, inputs, ticks: vector["events"]
        self.flag = lambda device: True
        self.examine = dict(vector["final"].get("ram", ())).get
        self.get = lambda: vector["final"] | {"ticks": vector.get("ticks")}
        lamps = iter([hand["lamps"] for hand in vector.get("hands", ())])
        self.hand = lambda what, value: next(lamps)

    def set(self, registers: object) -> None:
        pass

    def deposit(self, address: int, word: int) -> None:
        pass


def others(value: Any) -> Iterator[Any]:
    """Yield a value with one number or text in it another, and a list of events with one too few or many."""
    if isinstance(value, dict):
        for key in value.keys() - {"hand", "value"}:
            yield from (value | {key: other} for other in others(value[key]))
    elif isinstance(value, list):
        for at, each in enumerate(value):
            yield from ([*value[:at], other, *value[at + 1 :]] for other in others(each))
        if value and isinstance(value[0], dict) and "tick" in value[0]:
            yield from (value[:-1], [*value, value[-1]])
    else:
        yield value ^ 1 if isinstance(value, int) else f"{value}?"


def test_the_runner_sees_whatever_an_emulator_does_otherwise(vectors: Vectors) -> None:
    for name, those in vectors.items():
        for vector in those[:: len(those) // 3]:
            assert runner.play(vector, Recorded(vector)) == "", name
            looked_at = {"teletype": "events", "pc8l": "events", "hands": "hands final"}
            for part in looked_at.get(name, "final ticks cycles").split():
                for other in others(vector[part]):
                    with case(name, vector["name"], part, other):
                        assert runner.play(vector, Recorded(vector | {part: other}))


def test_mem_prot_is_up_in_one_file_only(vectors: Vectors) -> None:
    """There it stops hundreds of ISZ, DCA and JMS each."""
    for name, those in vectors.items():
        up = {vector["initial"].get("mem_prot") for vector in those}
        assert up == ({1} if name == "mem_prot" else {None}), name
    stopped = Counter(vector["name"][0] for vector in vectors["mem_prot"] if vector["final"]["protect"])
    assert set(stopped) == set("234")
    assert min(stopped.values()) > 200


def test_models_are_those_that_do_the_same(vectors: Vectors) -> None:
    words: dict[str, set[int]] = {model: set() for model in MODELS}
    for vector in vectors["opr1"]:
        for model in vector["models"]:
            words[model].add(int(vector["name"][:4], 8))
    assert words["8/L"] == words["8/I"] == set(GROUPS["opr1"])
    assert words["8/L"] - words["8/E"] == {w for w in GROUPS["opr1"] if w & 0o14 == 0o14 or w & 0o16 == 0o2}
    assert {0o7005, 0o7011, 0o7014} <= words["8/L"] - words["8"]


VECTOR: dict[str, Any] = {
    "name": "7000 1", "models": ["8/L"], "instructions": 1, "ticks": 32,
    "initial": {"pc": 0o200, "ram": [[0o200, 0o7000]]},
    "final": {"pc": 0o201, "ac": 5, "ram": [[0o200, 0o7000]]},
    "cycles": [["FETCH", 0o200, 0o7000]],
}  # fmt: skip
FLAGS = {"initial": VECTOR["initial"] | {"flags": [1, 2]}}
HANDS = {"hands": [{"hand": "load_add", "value": 0, "lamps": {"ma": 0o200, "run": 0}}]}
EVENTS = {"events": [{"at": 0, "key": 1}, {"at": 5, "flag": 1}], "initial": {}}


def emulator(**more: Any) -> Any:
    """Return an emulator whose one instruction is a NOP; it has no AC."""
    core: dict[int, int] = {}
    made = {
        "set": lambda registers: None, "deposit": core.__setitem__, "examine": core.__getitem__,
        "run": lambda instructions: None, "get": lambda: {"pc": 0o201, "ticks": 32},
    }  # fmt: skip
    return SimpleNamespace(**made | more)


@pytest.mark.parametrize(
    ("vector", "offers", "found"),
    [
        ({}, {}, ""),
        ({"final": {"pc": 0o202, "ram": []}}, {}, "pc is 201, not 202"),
        ({"ticks": 33}, {}, "ticks is 32, not 33"),
        ({"final": {"ram": [[0o200, 0o7001]]}}, {}, "core 200 is 7000, not 7001"),
        (FLAGS, {}, None),
        (FLAGS, {"flag": lambda device: device == 1}, None),
        (FLAGS, {"flag": lambda device: True}, ""),
        ({}, {"cycle": lambda: ["FETCH", 0o200, 0o7000]}, ""),
        ({}, {"cycle": lambda: ["DEFER", 0o200, 0o7000]}, "state of cycle 1 is DEFER, not FETCH"),
        ({}, {"cycle": lambda: ["FETCH", 0o201, 0o7000]}, "MA of cycle 1 is 201, not 200"),
        (HANDS, {}, None),
        (HANDS, {"hand": lambda what, value: {"ma": 0o200}}, ""),
        (HANDS, {"hand": lambda what, value: {"ma": 0o201}}, "ma after hand 1, load_add, is 201, not 200"),
        (EVENTS, {}, None),
        (EVENTS, {"play": lambda initial, inputs, ticks: EVENTS["events"]}, ""),
        (EVENTS, {"play": lambda initial, inputs, ticks: inputs}, "1 events, not 2"),
        (EVENTS, {"play": lambda initial, inputs, ticks: [{"at": 1}]}, "{'at': 1}, not {'at': 0, 'key': 1}"),
    ],
)
def test_what_differs_is_said(vector: dict[str, Any], offers: dict[str, Any], found: str | None) -> None:
    assert runner.play(VECTOR | vector, emulator(**offers)) == found


def test_a_file_is_counted_by_model_and_said_by_words(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file = tmp_path / "own.json.gz"
    words = [f"{0o7000 + number // 2:o} {number}" for number in range(42)]
    some = [VECTOR, VECTOR | FLAGS, *(VECTOR | {"ticks": 33, "name": name} for name in words)]
    file.write_bytes(gzip.compress(("[\n" + ",\n".join(map(json.dumps, some)) + "\n]\n").encode()))
    assert runner.main(emulator(), [file], "8/E") == 0
    assert runner.main(emulator(), [file]) == 1
    none = tmp_path / "none.json.gz"
    none.write_bytes(gzip.compress(b"[\n]\n"))
    assert runner.main(emulator(), [file, none]) == 1
    first, second, *said = capsys.readouterr().out.splitlines()
    assert first == "own.json.gz: 0 played, 0 differ in 0 words"
    assert second == "own.json.gz: 43 played, 42 differ in 21 words"
    shown = [f"  {name}: ticks is 32, not 33" for name in words[::2][: runner.SHOWN]]
    assert said == [*shown, second, *shown, "none.json.gz: 0 played, 0 differ in 0 words"]
