"""A warm pytest that forks for each mutant.

    this process ──fork──► collected: the room's tests, each run once under coverage (in a fork of its own);
         │                  then, for each mutant in a function, fork ► put in its code ► its lines' tests
         └────────fork──► for each mutant outside a function: import it ► run all tests

A mutant is caught when a test fails, or takes LONGER times as long as all of them did.
"""

import ast
import gc
import importlib
import importlib.abc
import importlib.machinery
import importlib.util
import os
import pickle
import resource
import shutil
import signal
import sys
import tempfile
import time
import traceback
from collections.abc import Callable, Iterator, Sequence
from importlib.machinery import ModuleSpec
from pathlib import Path
from types import CodeType, FunctionType, ModuleType
from typing import NamedTuple

import coverage
import pytest
from _pytest.runner import runtestprotocol

from tests import commands
from tests.mutation.mutants import Mutant, mutants

LONGER = 20
LEAST = 20.0
"""Seconds of processor time that every mutant may take."""

_MEMORY = 6 << 30
_PYTEST = [
    "-q",
    "-p",
    "no:cacheprovider",
    "-p",
    "no:xdist",
    "-p",
    "no:randomly",
    "--capture=sys",
    "-m",
    "not slow",
]
_PYTEST += ["-W", "ignore::pytest.PytestAssertRewriteWarning"]

Chosen = dict[str, set[int]]
"""The numbers of the mutants to try, by file."""


class Runs(NamedTuple):
    """What the tests run: for each file and line its tests; how long each takes; what is run at import."""

    tests: dict[str, dict[int, set[str]]]
    seconds: dict[str, float]
    failed: list[str]
    loaded: list[str]


def run(tests: list[str], chosen: Chosen, jobs: int) -> Iterator[tuple[str, int, str]]:
    """Yield for each mutant its file, its number and the verdict: caught, survived or not run."""
    with tempfile.TemporaryDirectory(prefix="pdp8-mutants-") as folder:
        answer = Path(folder) / "answer"
        pid = _fork(lambda: _collected(tests, chosen, jobs, answer), Path(folder), quiet=False)
        os.waitpid(pid, 0)
        runs, verdicts = pickle.loads(answer.read_bytes())
        if runs.failed:
            print(f"left out {len(runs.failed)} tests that run commands of their own", file=sys.stderr)
        for name in runs.loaded:
            try:
                importlib.import_module(name)
            except Exception:
                continue
        again = []
        for (file, number), verdict in verdicts.items():
            if verdict == "import":
                again.append((file, number))
            else:
                yield file, number, verdict
        yield from _whole(again, runs, jobs, Path(folder))


def _fork(work: Callable[[], int], folder: Path, limit: float | None = None, quiet: bool = True) -> int:
    """Do `work` in a process of its own, for at most `limit` seconds of its time; the status tells."""
    pid = os.fork()
    if pid:
        return pid
    status = 3
    try:
        if quiet:
            nowhere = os.open(os.devnull, os.O_WRONLY)
            os.dup2(nowhere, 1)
            os.dup2(nowhere, 2)
        if limit is not None:
            signal.signal(signal.SIGPROF, signal.SIG_DFL)
            signal.setitimer(signal.ITIMER_PROF, limit)
            signal.alarm(int(limit * 10))
            resource.setrlimit(resource.RLIMIT_AS, (_MEMORY, _MEMORY))
        own = folder / str(os.getpid())
        own.mkdir()
        os.environ["PYTEST_DEBUG_TEMPROOT"] = os.environ["HYPOTHESIS_STORAGE_DIRECTORY"] = str(own)
        status = work()
        shutil.rmtree(own, ignore_errors=True)
    except BaseException:
        traceback.print_exc()
    finally:
        os._exit(status)


def _each(
    trials: Sequence[tuple[str, int]], begin: Callable[[Mutant, str], int | str], jobs: int
) -> Iterator[tuple[str, int, str]]:
    """Begin each trial, `jobs` at once; yield its verdict, from `begin` or from the status of its process."""
    wanted: Chosen = {}
    for file, number in trials:
        wanted.setdefault(file, set()).add(number)
    alive: dict[int, tuple[str, int]] = {}

    def ended() -> tuple[str, int, str]:
        pid, status = os.wait()
        return *alive.pop(pid), "survived" if status == 0 else "caught"

    for file, numbers in wanted.items():
        for mutant in mutants(Path(file).read_text()):
            if mutant.number not in numbers:
                continue
            begun = begin(mutant, file)
            if isinstance(begun, str):
                yield file, mutant.number, begun
                continue
            alive[begun] = file, mutant.number
            if len(alive) == jobs:
                yield ended()
    while alive:
        yield ended()


# The collected process


def _collected(tests: list[str], chosen: Chosen, jobs: int, answer: Path) -> int:
    """Collect the tests, find what each runs, try the mutants in functions; leave all of it in `answer`."""
    _calm_hypothesis()
    files = [str(Path(file).resolve()) for file in chosen]
    measured = coverage.Coverage(data_file=None, config_file=False, include=files, messages=False)
    measured.start()
    plugin = _Collected(measured, chosen, jobs, answer)
    return int(pytest.main([*_PYTEST, *tests], plugins=[plugin]))


def _calm_hypothesis() -> None:
    """Have Hypothesis draw the same examples always, without a clock and without shrinking."""
    from hypothesis import HealthCheck, Phase, settings

    settings.register_profile(
        "mutants",
        deadline=None,
        derandomize=True,
        database=None,
        phases=(Phase.explicit, Phase.generate),
        suppress_health_check=list(HealthCheck),
    )
    settings.load_profile("mutants")


class _Collected:
    def __init__(self, measured: coverage.Coverage, chosen: Chosen, jobs: int, answer: Path) -> None:
        self.measured = measured
        self.chosen = chosen
        self.jobs = jobs
        self.answer = answer

    def pytest_runtestloop(self, session: pytest.Session) -> bool:
        items = {item.nodeid: item for item in session.items}
        runs = self._measure(list(items.values()))
        functions = _functions({str(Path(file).resolve()) for file in self.chosen})
        folder = self.answer.parent
        imported: set[tuple[str, int]] = set()

        def begin(mutant: Mutant, file: str) -> int | str:
            lines = runs.tests.get(file, {})
            names = set().union(*(lines.get(line, set()) for line in mutant.lines))
            if mutant.whole or "" in names:
                imported.add((file, mutant.number))
            names &= runs.seconds.keys()
            if mutant.whole:
                return "import"
            if not names:
                return "import" if (file, mutant.number) in imported else "not run"
            code = compile(mutant.tree, str(Path(file).resolve()), "exec")
            order = sorted(names, key=lambda name: runs.seconds[name])
            limit = LEAST + LONGER * sum(runs.seconds[name] for name in order)
            return _fork(
                lambda: _swap(functions, code) or _fails([items[name] for name in order]), folder, limit
            )

        trials = [(file, number) for file, numbers in self.chosen.items() for number in numbers]
        verdicts = {}
        for file, number, verdict in _each(trials, begin, self.jobs):
            again = verdict == "survived" and (file, number) in imported
            verdicts[file, number] = "import" if again else verdict
        self.answer.write_bytes(pickle.dumps((runs, verdicts)))
        return True

    def _measure(self, items: list[pytest.Item]) -> Runs:
        """Run every test once in a fork, under coverage."""
        found = self.answer.with_suffix(".runs")
        pid = _fork(lambda: self._run_all(items, found), found.parent)
        os.waitpid(pid, 0)
        self.measured.stop()
        runs: Runs = pickle.loads(found.read_bytes())
        return runs

    def _run_all(self, items: list[pytest.Item], found: Path) -> int:
        setattr(commands, "subprocess", None)  # noqa: B010 -- a command of its own has no mutant in it
        seconds, failed = {}, []
        for item, after in zip(items, [*items[1:], None], strict=True):
            self.measured.switch_context(item.nodeid)
            began = time.process_time()
            if any(report.failed for report in runtestprotocol(item, log=False, nextitem=after)):
                failed.append(item.nodeid)
                continue
            seconds[item.nodeid] = time.process_time() - began
        self.measured.stop()
        data = self.measured.get_data()
        tests = {
            file: {
                line: set(names) for line, names in data.contexts_by_lineno(str(Path(file).resolve())).items()
            }
            for file in self.chosen
        }
        found.write_bytes(pickle.dumps(Runs(tests, seconds, failed, _loaded())))
        return 0


def _loaded() -> list[str]:
    """Return the packages that are loaded and not ours."""
    ours = {"tapes", "pal", "pdp8", "programs", "nc", "tests", "__main__", "__mp_main__"}
    return sorted({name.split(".")[0] for name in sys.modules} - ours)


def _functions(files: set[str]) -> dict[tuple[str, int, str], list[FunctionType]]:
    """Return the functions that are defined in these files, by file, first line and name."""
    found: dict[tuple[str, int, str], list[FunctionType]] = {}
    for thing in gc.get_objects():
        if isinstance(thing, FunctionType) and thing.__code__.co_filename in files:
            code = thing.__code__
            found.setdefault((code.co_filename, code.co_firstlineno, code.co_qualname), []).append(thing)
    return found


def _swap(functions: dict[tuple[str, int, str], list[FunctionType]], code: CodeType) -> int:
    """Put the code of a changed module into the functions that are there."""
    for inner in code.co_consts:
        if isinstance(inner, CodeType):
            for function in functions.get((inner.co_filename, inner.co_firstlineno, inner.co_qualname), ()):
                if function.__code__.co_freevars == inner.co_freevars:
                    function.__code__ = inner
            _swap(functions, inner)
    return 0


def _fails(items: list[pytest.Item]) -> int:
    """Run tests up to the first that fails; return 1 if one does."""
    for item, after in zip(items, [*items[1:], None], strict=True):
        if any(report.failed for report in runtestprotocol(item, log=False, nextitem=after)):
            return 1
    return 0


# What works when a module is imported


def _whole(
    trials: list[tuple[str, int]], runs: Runs, jobs: int, folder: Path
) -> Iterator[tuple[str, int, str]]:
    """Try mutants by importing them: with all tests, first those that run anything of their module."""

    def begin(mutant: Mutant, file: str) -> int | str:
        names = set().union(*runs.tests.get(file, {}).values())
        order = sorted(runs.seconds, key=lambda name: (name not in names, runs.seconds[name]))
        code = compile(mutant.tree, str(Path(file).resolve()), "exec")
        limit = 2 * LEAST + LONGER * sum(runs.seconds[name] for name in order)
        return _fork(lambda: _import_and_run(file, code, order), folder, limit)

    return _each(trials, begin, jobs)


def _import_and_run(file: str, code: CodeType, tests: list[str]) -> int:
    _calm_hypothesis()
    sys.meta_path.insert(0, _Changed(file, code))
    return int(pytest.main([*_PYTEST, "-x", "--tb=no", *tests]))


class _Changed(importlib.abc.MetaPathFinder):
    """Finds one module, with a mutant in it."""

    def __init__(self, file: str, code: CodeType) -> None:
        self.name = file.removesuffix(".py").removesuffix("/__init__").replace("/", ".")
        self.file = file
        self.code = code

    def find_spec(
        self, fullname: str, path: Sequence[str] | None, target: ModuleType | None = None
    ) -> ModuleSpec | None:
        """Return the changed module's specification."""
        if fullname != self.name:
            return None
        file = str(Path(self.file).resolve())
        loader = _Loader(fullname, file)
        loader.code = self.code
        return importlib.util.spec_from_file_location(fullname, file, loader=loader)


class _Loader(importlib.machinery.SourceFileLoader):
    code: CodeType

    def get_code(self, fullname: str) -> CodeType:
        return self.code


def main(tests: str, chosen: str, jobs: str) -> None:
    """Print the verdicts line by line, their parts between tabs; the arguments are Python literals."""
    lines = run(ast.literal_eval(tests), ast.literal_eval(chosen), int(jobs))
    for file, number, verdict in lines:
        print(f"{file}\t{number}\t{verdict}", flush=True)
