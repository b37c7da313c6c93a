"""Which mutants a test catches: a warm process forks for each, and the fork imports ours and runs tests.

    this process ── fork ► each file of tests once, under coverage: the lines and the seconds of each test
                 ── fork ► a mutant: the tests that run its line, the quickest first; then all others

A mutant stands as the bytecode of its module in a copy of the sources in which nothing of the package is
compiled: whatever a test starts has it too. It is caught when a test fails, or takes LONGER times as long as
it did. Which lines a test runs only says which is first: a mutant survives all tests of its package.
"""

import importlib
import marshal
import os
import pickle
import resource
import signal
import sys
import time
from collections import defaultdict
from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import suppress
from functools import partial
from hashlib import sha256
from importlib.util import MAGIC_NUMBER, cache_from_source
from pathlib import Path
from typing import NamedTuple, TypeVar

import coverage
import pytest
from hypothesis import HealthCheck, Phase, settings

from tests.faults import workshop
from tests.mutation.mutants import Mutant
from tests.mutation.packages import PACKAGES, ROOT, tests

LEAST, LONGER = 5.0, 4
"""Seconds of processor time that every test may take, and how often the time that it takes."""
WAITING = 10
"""How many times as long a test may take in real time, on a busy machine."""
LONGEST = 30.0
"""The seconds of a test of which none are known."""

KEPT = ROOT / "build/mutation"
_MEMORY = 6 << 30
_OURS = {"tapes", "pal", "pdp8", "programs", "nc", "tests", "release"}
_PYTEST = ["-m", "not slow", "--hypothesis-profile=mutants", "-pno:cacheprovider", "-pno:xdist", "--tb=no"]
_PYTEST += ["-W", "ignore::pytest.PytestAssertRewriteWarning"]  # what is warm

Trial = tuple[str, Mutant]
Task = TypeVar("Task")


class Runs(NamedTuple):
    """The seconds of each test, which fail by themselves, and which run each line of each file."""

    seconds: dict[str, float]
    failed: set[str]
    tests: dict[tuple[str, int], list[str]]


def tried(
    package: str, trials: list[Trial], jobs: int, folder: Path, near: bool = False
) -> Iterator[tuple[str, Mutant, str]]:
    """Yield mutants, each with its file and the verdict: caught, survived or not run (by any test seen).

    `folder` is for copies of the sources; `near` leaves it at the tests of a mutant's lines.
    """
    copies = [_copy(package, folder / str(number)) for number in range(jobs if trials else 0)]
    if not copies:
        return
    _warm(package, copies)
    runs = _measured(package, copies)
    if runs.failed:
        print(f"left out: {' '.join(sorted(runs.failed))}"[:2000], file=sys.stderr)
    if not runs.seconds:
        raise SystemExit(f"no test of {package} runs")
    for copy, (file, mutant), status in _each(trials, partial(_try, runs, near), copies):
        _bytecode(copy, file).unlink(missing_ok=True)
        seen = any((file, line) in runs.tests for line in mutant.lines)
        yield file, mutant, "caught" if status else "survived" if seen else "not run"


def _copy(package: str, copy: Path) -> Path:
    """Copy the sources to a folder; what is compiled of other packages is compiled there."""
    workshop.copy(copy)
    for built in () if package == "pal" else ROOT.glob("p*/**/*.so"):
        path = built.relative_to(ROOT)
        if not path.is_relative_to(PACKAGES[package][0]):
            (copy / path).symlink_to(built)
    return copy


def _bytecode(copy: Path, file: str) -> Path:
    """Return where Python keeps the bytecode of a file."""
    path = Path(cache_from_source(str(copy / file)))
    path.parent.mkdir(exist_ok=True)
    return path


def _each(
    tasks: Sequence[Task], work: Callable[[Path, Task], int], copies: list[Path]
) -> Iterator[tuple[Path, Task, int]]:
    """Do the work of each task in a fork, in a copy that is free; yield both and the status."""
    waiting, free = list(reversed(tasks)), list(copies)
    alive: dict[int, tuple[Path, Task]] = {}
    while waiting or alive:
        while waiting and free:
            copy, task = free.pop(), waiting.pop()
            pid = os.fork()
            if pid == 0:
                _within(copy, partial(work, copy, task))
            alive[pid] = copy, task
        pid, status = os.wait()
        with suppress(ProcessLookupError):
            os.killpg(pid, signal.SIGKILL)  # whatever its tests have started
        copy, task = alive.pop(pid)
        free.append(copy)
        yield copy, task, status


def _within(copy: Path, work: Callable[[], int]) -> None:
    """Do the work with the modules and commands of a copy, in silence; end the process."""
    status = 3
    try:
        nowhere = os.open(os.devnull, os.O_RDWR)
        for stream in range(3):
            os.dup2(nowhere, stream)
        os.setpgid(0, 0)
        resource.setrlimit(resource.RLIMIT_AS, (_MEMORY, _MEMORY))
        os.chdir(copy)
        sys.path.insert(0, str(copy))
        os.environ["PYTHONPATH"] = str(copy)
        for name in [name for name in sys.modules if name.split(".")[0] in _OURS]:
            del sys.modules[name]
        status = work()
    finally:
        os._exit(status)


def _warm(package: str, copies: list[Path]) -> None:
    """Import what the tests of a package import that is not ours; have Hypothesis always draw the same."""
    found = copies[0].with_suffix(".modules")
    settings.register_profile(
        "mutants",
        deadline=None,
        derandomize=True,
        database=None,
        phases=(Phase.explicit, Phase.generate),
        suppress_health_check=list(HealthCheck),
    )

    def collect(copy: Path, files: list[str]) -> int:
        _pytest(copy, files, None, "--collect-only")
        found.write_text("\n".join(name for name in sys.modules if name.split(".")[0] not in _OURS))
        return 0

    for _ in _each([tests(package)], collect, copies):
        for name in found.read_text().splitlines():
            with suppress(Exception):
                importlib.import_module(name)


def _pytest(copy: Path, files: Iterable[str], plugin: object, *options: str) -> int:
    return int(pytest.main([*_PYTEST, f"--basetemp={copy}.tmp", *options, *files], plugins=[plugin]))


def _limit(seconds: float) -> None:
    """Give a test that begins, and what it starts, LONGER times these seconds."""
    limit = LEAST + LONGER * seconds
    resource.setrlimit(resource.RLIMIT_CPU, (int(time.process_time() + limit), resource.RLIM_INFINITY))
    signal.alarm(int(WAITING * limit))


# The lines and seconds of the tests


def _measured(package: str, copies: list[Path]) -> Runs:
    """Return what the tests of a package run, kept for each file until any module changes."""
    others = sorted(path for path in copies[0].rglob("*.py") if not path.name.startswith("test_"))
    texts = sha256(b"".join(path.read_bytes() for path in others)).digest()
    kept = {file: KEPT / sha256(texts + (ROOT / file).read_bytes()).hexdigest() for file in tests(package)}
    KEPT.mkdir(parents=True, exist_ok=True)
    new = [(file, path) for file, path in kept.items() if not path.exists()]
    for _ in _each(new, partial(_measure, package), copies):
        pass
    runs = Runs({}, set(), defaultdict(list))
    for file, path in kept.items():
        if not path.exists():
            runs.failed.add(file)
            continue
        seconds, failed, lines = pickle.loads(path.read_bytes())
        runs.seconds.update(seconds)
        runs.failed.update(failed)
        for line, names in lines.items():
            runs.tests[line] += names
    return runs


def _measure(package: str, copy: Path, task: tuple[str, Path]) -> int:
    """Run the tests of a file under coverage; keep what they run."""
    file, kept = task
    lines = copy.with_suffix(".lines")
    lines.mkdir(exist_ok=True)
    within = f"{copy / PACKAGES[package][0]}/*"
    measured = coverage.Coverage(
        str(lines / "one"), data_suffix=True, config_file=False, include=[within], messages=False
    )
    meter = _Meter(measured)
    measured.start()
    _pytest(copy, [file], meter)
    measured.stop()
    measured.save()
    measured.combine()
    data = measured.get_data()
    found = {
        (Path(path).relative_to(copy).as_posix(), line): [name for name in names if name]
        for path in data.measured_files()
        for line, names in data.contexts_by_lineno(path).items()
    }
    if meter.seconds:
        kept.write_bytes(pickle.dumps((meter.seconds, meter.failed, found)))
    return 0


class _Meter:
    """Notes the seconds of tests and which fail; names each to coverage, in the commands it starts too."""

    def __init__(self, measured: coverage.Coverage) -> None:
        self.measured = measured
        self.seconds: dict[str, float] = {}
        self.failed: set[str] = set()

    def pytest_runtest_logstart(self, nodeid: str) -> None:
        self.seconds[nodeid] = 0.0
        self.measured.switch_context(nodeid)
        self.measured.config.context = nodeid
        os.environ["COVERAGE_PROCESS_CONFIG"] = self.measured.config.serialize()
        _limit(LONGEST)

    def pytest_runtest_logreport(self, report: pytest.TestReport) -> None:
        self.seconds[report.nodeid] += report.duration
        if report.failed:
            self.failed.add(report.nodeid)


# A mutant and its tests


def _try(runs: Runs, near: bool, copy: Path, trial: Trial) -> int:
    """Run the tests of a mutant's lines, or else of its file, and then all others unless `near`; return 1 if
    one fails.
    """
    file, mutant = trial
    unchecked = (1).to_bytes(4, "little") + bytes(8)  # by a hash of the source, which is not looked at
    code = marshal.dumps(mutant.code(str(copy / file)))
    _bytecode(copy, file).write_bytes(MAGIC_NUMBER + unchecked + code)
    lines = mutant.lines if mutant.scope or not near else ()  # an import runs in the first test only
    first = {name for line in lines for name in runs.tests.get((file, line), ())}
    if not first:
        first = {name for (other, _), names in runs.tests.items() if other == file for name in names}
    others = runs.seconds.keys() - first
    for wanted, left in ((first, others), (others, first))[: 1 if near else 2]:
        files = {name.split("::")[0] for name in wanted}
        chosen = _Chosen(runs.seconds, left | runs.failed)
        _limit(LONGEST)  # to import them
        if wanted and _pytest(copy, files, chosen, "-x") not in (0, pytest.ExitCode.NO_TESTS_COLLECTED):
            return 1
    return 0


class _Chosen:
    """Leaves tests out, and runs the quickest of the others first, each within its time."""

    def __init__(self, seconds: dict[str, float], left: set[str]) -> None:
        self.seconds = seconds
        self.left = left

    @pytest.hookimpl(trylast=True)
    def pytest_collection_modifyitems(self, items: list[pytest.Item]) -> None:
        chosen = (item for item in items if item.nodeid not in self.left)
        items[:] = sorted(chosen, key=lambda item: self.seconds.get(item.nodeid, LONGEST))

    def pytest_runtest_logstart(self, nodeid: str) -> None:
        _limit(self.seconds.get(nodeid, LONGEST))
