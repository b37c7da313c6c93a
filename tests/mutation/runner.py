"""A warm pytest that forks for each mutant.

    this process ──fork──► collected: the room's tests, each run once under coverage (in a fork of its own);
         │                  then, for each mutant in a function, fork ► put in its code ► its lines' tests
         └────────fork──► for each mutant outside a function: import it ► run all tests

A mutant is caught when a test fails, or takes LONGER times as long as it did, or all do.
"""

import ast
import gc
import importlib
import os
import pickle
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import traceback
import warnings
from collections.abc import Callable, Iterator, Sequence
from contextlib import suppress
from functools import cache, partial
from hashlib import sha256
from importlib.machinery import SourceFileLoader
from pathlib import Path
from types import CodeType, FunctionType, SimpleNamespace
from typing import NamedTuple

import coverage
import coverage.exceptions
import pytest
from _pytest.runner import runtestprotocol

from tests import commands, warm
from tests.mutation.mutants import Mutant, mutants

LONGER = 4
LEAST = 5.0
"""Seconds of processor time that every mutant may take, and as often the time of its tests."""
WAITING = 10
"""How many times as long a test may take in real time, on a busy machine."""
LONGEST = 120.0
"""Seconds of processor time that a test may take when its lines are noted."""

_MEMORY = 6 << 30
_OFF = ("cacheprovider", "xdist", "randomly")
_PYTEST = ["-q", *(f"-pno:{plugin}" for plugin in _OFF), "--capture=sys", "-m", "not slow"]
_PYTEST += ["-W", "ignore::pytest.PytestAssertRewriteWarning"]

Chosen = dict[str, set[int]]
"""The numbers of the mutants to try, by file."""


class Runs(NamedTuple):
    """What the tests run: for each file and line its tests; how long each takes; what is loaded."""

    tests: dict[str, dict[int, set[str]]]
    seconds: dict[str, float]
    failed: list[str]
    loaded: list[str]


def run(tests: list[str], chosen: Chosen, jobs: int, kept: Path) -> None:
    """Tell of each mutant its file, its number and the verdict: caught, survived or not run.

    `kept` has the lines of each test from one call to the next: what has not changed is not run again.
    """
    with tempfile.TemporaryDirectory(prefix="pdp8-mutants-") as folder:
        answer = Path(folder) / "answer"
        pid = _fork(lambda _own: _collected(tests, chosen, jobs, answer, kept), Path(folder), quiet=False)
        os.waitpid(pid, 0)
        runs, again = pickle.loads(answer.read_bytes())
        if runs.failed:
            print(f"left out: {' '.join(runs.failed)}"[:2000], file=sys.stderr)
        for name in runs.loaded:
            try:
                importlib.import_module(name)
            except Exception:
                continue
        for tried in _whole(again, runs, jobs, Path(folder)):
            _tell(*tried)


def _tell(file: str, number: int, verdict: str) -> None:
    """Write a line, its parts between tabs, past whatever captures standard output."""
    os.write(1, f"\n{file}\t{number}\t{verdict}\n".encode())


def _fork(work: Callable[[Path], int], folder: Path, limit: float | None = None, quiet: bool = True) -> int:
    """Do `work` in a process of its own, in a folder of its own, and all that it starts for at most `limit`
    seconds of processor time; the status tells.
    """
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
            os.setpgid(0, 0)
            resource.setrlimit(resource.RLIMIT_CPU, (int(limit), int(limit)))
            resource.setrlimit(resource.RLIMIT_AS, (_MEMORY, _MEMORY))
        own = folder / str(os.getpid())
        own.mkdir()
        os.environ["PYTEST_DEBUG_TEMPROOT"] = os.environ["HYPOTHESIS_STORAGE_DIRECTORY"] = str(own)
        status = work(own)
        shutil.rmtree(own, ignore_errors=True)
    except BaseException:
        traceback.print_exc()
    finally:
        os._exit(status)


def _wait() -> tuple[int, int]:
    """Wait for one process of `_fork`, and end all that it started; return its number and status."""
    pid, status = os.wait()
    with suppress(ProcessLookupError):
        os.killpg(pid, signal.SIGKILL)
    return pid, status


def _serve_commands(own: Path, clients: Path, status_of: Callable[[object], int] = warm.status_of) -> None:
    """Have the tests' commands run in forks of this process, with whatever is changed in it."""

    @cache
    def started() -> warm.Server:
        for name in warm.COMMANDS:
            (own / name).symlink_to(clients / warm.COMMANDS[0])
        (asked, life), (heard, ready) = os.pipe(), os.pipe()
        if os.fork() == 0:
            os.dup2(asked, 0)
            os.dup2(ready, 1)
            os.closerange(3, 1024)
            warnings.resetwarnings()
            setattr(warm, "status_of", status_of)  # noqa: B010
            warm.load()
            warm.serve(str(own / "server"))
            os._exit(0)
        os.close(asked)
        os.read(heard, 1)
        return warm.Server(own, life)

    setattr(warm, "started", started)  # noqa: B010
    setattr(commands, "subprocess", SimpleNamespace(**vars(subprocess) | {"Popen": _refused}))  # noqa: B010


def _refused(*_words: object, **_options: object) -> None:
    raise OSError("what starts as it is has no mutant in it")


def _each(
    trials: Sequence[tuple[str, int]], begin: Callable[[Mutant, str], int | str], jobs: int
) -> Iterator[tuple[str, int, str]]:
    """Begin each trial, `jobs` at once; yield its verdict, from `begin` or from the status of its process."""
    wanted: Chosen = {}
    for file, number in trials:
        wanted.setdefault(file, set()).add(number)
    alive: dict[int, tuple[str, int]] = {}

    def ended() -> tuple[str, int, str]:
        pid, status = _wait()
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


def _collected(tests: list[str], chosen: Chosen, jobs: int, answer: Path, kept: Path) -> int:
    """Collect the tests, find what each runs, try the mutants in functions; leave all of it in `answer`."""
    _calm_hypothesis()
    measured = _measuring([str(Path(file).resolve()) for file in chosen])
    warm.load()
    plugin = _Collected(measured, chosen, jobs, answer, kept)
    return int(pytest.main([*_PYTEST, *tests], plugins=[plugin]))


def _measuring(files: list[str]) -> coverage.Coverage:
    """Begin to note which lines of these files run."""
    measured = coverage.Coverage(data_file=None, config_file=False, include=files, messages=False)
    measured.start()
    return measured


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


_Ran = tuple[dict[str, set[int]], float]
"""The lines that a test runs, by file, and its seconds."""


class _Collected:
    def __init__(
        self, measured: coverage.Coverage, chosen: Chosen, jobs: int, answer: Path, kept: Path
    ) -> None:
        self.kept = kept
        self.measured = measured
        self.chosen = chosen
        self.files = {file: str(Path(file).resolve()) for file in chosen}
        self.jobs = jobs
        self.answer = answer
        self.clients = answer.parent / "clients"

    def pytest_runtestloop(self, session: pytest.Session) -> bool:
        items = {item.nodeid: item for item in session.items}
        runs = self._measure(list(items.values()))
        functions = _functions({str(Path(file).resolve()) for file in self.chosen})
        folder = self.answer.parent
        imported: set[tuple[str, int]] = set()

        def begin(mutant: Mutant, file: str) -> int | str:
            lines = runs.tests.get(file, {})
            names = set().union(*(lines.get(line, set()) for line in mutant.lines))
            code = compile(mutant.tree, str(Path(file).resolve()), "exec")
            if mutant.whole or (names and not _fits(functions, code)):
                return "import"
            if "" in names:
                imported.add((file, mutant.number))
            names &= runs.seconds.keys()
            if not names and (file, mutant.number) in imported:
                return "import"
            # what no test is seen to run, one may in a process that it starts
            names = names or set().union(*lines.values()) & runs.seconds.keys()
            if not names:
                return "not run"
            order = sorted(names, key=lambda name: runs.seconds[name])

            def work(own: Path) -> int:
                _swap(functions, code)
                _load(code)
                _serve_commands(own, self.clients)
                return _fails([items[name] for name in order], runs.seconds)

            return _fork(work, folder, LEAST + LONGER * sum(runs.seconds[name] for name in order))

        trials = [(file, number) for file, numbers in self.chosen.items() for number in numbers]
        again = []
        for file, number, verdict in _each(trials, begin, self.jobs):
            if verdict == "import" or (verdict == "survived" and (file, number) in imported):
                again.append((file, number))
            else:
                _tell(file, number, verdict)
        self.answer.write_bytes(pickle.dumps((runs, again)))
        return True

    def _measure(self, items: list[pytest.Item]) -> Runs:
        """Run every test once under coverage, each in a fork: none finds what another has cached."""
        folder = self.answer.parent
        self.clients.mkdir()
        warm.compile_commands(self.clients)
        runs = Runs({file: {} for file in self.files}, {}, [], _loaded())
        self._note(runs, "", self._lines(self.measured))
        alive: dict[int, str] = {}
        before = pickle.loads(self.kept.read_bytes()) if self.kept.exists() else {}
        kept: dict[str, tuple[str, _Ran]] = {}
        items_by_name = {item.nodeid: item for item in items}

        def note() -> None:
            pid, _ = _wait()
            name, found = alive.pop(pid), folder / f"{pid}.ran"
            if found.exists():
                ran: _Ran = pickle.loads(found.read_bytes())
                kept[name] = self._key(items_by_name[name], ran[0]), ran
            else:
                runs.failed.append(name)

        for item in items:
            key, ran = before.get(item.nodeid, ("", ({}, 0.0)))
            if key == self._key(item, ran[0]):
                kept[item.nodeid] = key, ran
                continue
            alive[_fork(partial(self._run, item), folder, LONGEST)] = item.nodeid
            if len(alive) == self.jobs:
                note()
        while alive:
            note()
        self.kept.write_bytes(pickle.dumps(kept))
        for name, (_, (lines, seconds)) in kept.items():
            runs.seconds[name] = seconds
            self._note(runs, name, lines)
        return runs

    def _key(self, item: pytest.Item, lines: dict[str, set[int]]) -> str:
        """Return what stays the same while a test's file and the sources that it runs do."""
        ran = (Path(file).read_bytes() for file in sorted(lines) if lines[file] and Path(file).exists())
        return sha256(b"".join([item.path.read_bytes(), *ran])).hexdigest()

    def _run(self, item: pytest.Item, own: Path) -> int:
        """Run a test; leave what it ran, unless it fails."""
        gc.disable()  # what it ends may run a traced line while coverage holds its lock, and wait for ever
        measured = _measuring(list(self.files.values()))
        plain = warm.status_of

        def status_of(run: object) -> int:
            status = plain(run)
            (own / f"{os.getpid()}.lines").write_bytes(pickle.dumps(self._lines(measured)))
            return status

        _serve_commands(own, self.clients, status_of)
        began = time.monotonic()
        if _fails([item], {}):
            return 1
        seconds = time.monotonic() - began
        lines = self._lines(measured)
        for one in own.glob("*.lines"):
            for file, there in pickle.loads(one.read_bytes()).items():
                lines[file] |= there
        ran: _Ran = lines, seconds
        own.with_suffix(".ran").write_bytes(pickle.dumps(ran))
        return 0

    def _lines(self, measured: coverage.Coverage) -> dict[str, set[int]]:
        measured.stop()
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", coverage.exceptions.CoverageWarning)  # no line is an answer
            data = measured.get_data()
        return {file: set(data.lines(path) or ()) for file, path in self.files.items()}

    def _note(self, runs: Runs, name: str, lines: dict[str, set[int]]) -> None:
        for file, there in lines.items():
            for line in there:
                runs.tests[file].setdefault(line, set()).add(name)


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


def _fits(functions: dict[tuple[str, int, str], list[FunctionType]], code: CodeType) -> bool:
    """Tell whether the code of a changed module can be put into the functions that are there."""
    return all(
        all(
            function.__code__.co_freevars == inner.co_freevars
            for function in functions.get((inner.co_filename, inner.co_firstlineno, inner.co_qualname), ())
        )
        and _fits(functions, inner)
        for inner in code.co_consts
        if isinstance(inner, CodeType)
    )


def _swap(functions: dict[tuple[str, int, str], list[FunctionType]], code: CodeType) -> None:
    """Put the code of a changed module into the functions that are there."""
    for inner in code.co_consts:
        if isinstance(inner, CodeType):
            for function in functions.get((inner.co_filename, inner.co_firstlineno, inner.co_qualname), ()):
                function.__code__ = inner
            _swap(functions, inner)


def _load(code: CodeType) -> None:
    """Have the changed module be what is loaded from its file from now on."""
    plain = SourceFileLoader.get_code

    def get_code(self: SourceFileLoader, fullname: str) -> CodeType | None:
        return code if self.path == code.co_filename else plain(self, fullname)

    setattr(SourceFileLoader, "get_code", get_code)  # noqa: B010


def _fails(items: list[pytest.Item], seconds: dict[str, float]) -> int:
    """Run tests up to the first that fails; return 1 if one does."""
    for item, after in zip(items, [*items[1:], None], strict=True):
        _Bounds(seconds).pytest_runtest_logstart(item.nodeid)
        if any(report.failed for report in runtestprotocol(item, log=False, nextitem=after)):
            return 1
    return 0


class _Bounds(NamedTuple):
    """Ends the process where a test takes LONGER times the `seconds` known of it, or waits for ever."""

    seconds: dict[str, float]

    def pytest_runtest_logstart(self, nodeid: str) -> None:
        limit = LEAST + LONGER * self.seconds.get(nodeid, LONGEST / LONGER)
        signal.setitimer(signal.ITIMER_PROF, limit)
        signal.setitimer(signal.ITIMER_REAL, WAITING * limit)


# What works when a module is imported


def _whole(
    trials: list[tuple[str, int]], runs: Runs, jobs: int, folder: Path
) -> Iterator[tuple[str, int, str]]:
    """Try mutants by importing them: with the tests that run anything of their module, then with the others,
    which may read a table of it.
    """

    def begin(mutant: Mutant, file: str) -> int | str:
        names = set().union(*runs.tests.get(file, {}).values())
        order = sorted(runs.seconds, key=lambda name: (name not in names, runs.seconds[name]))
        code = compile(mutant.tree, str(Path(file).resolve()), "exec")
        limit = LEAST + LONGER * sum(runs.seconds[name] for name in order)

        def work(own: Path) -> int:
            _load(code)
            _serve_commands(own, folder / "clients")
            _calm_hypothesis()
            return int(pytest.main([*_PYTEST, "-x", "--tb=no", *order], plugins=[_Bounds(runs.seconds)]))

        return _fork(work, folder, limit)

    return _each(trials, begin, jobs)


def main(tests: str, chosen: str, jobs: str, kept: str) -> None:
    """Call `run`; the arguments are Python literals."""
    run(ast.literal_eval(tests), ast.literal_eval(chosen), int(jobs), Path(kept))
