"""What the tests of several packages share: commands in this process, a shell, how two tapes are compared."""

import asyncio
import io
import os
import shlex
import signal
import sys
from collections.abc import Callable, Coroutine, Iterator
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager
from itertools import zip_longest
from pathlib import Path
from typing import TYPE_CHECKING, TypeVar

import pytest
from hypothesis import settings

from pdp8.cli.assemble import pal
from pdp8.cli.root import pdp8
from pdp8.cli.shared import command
from tapes.frames import draw
from tests import commands
from tests.pdp8.web.browsing import CHROMIUM, launched
from tests.reference.compiling import compiler

if TYPE_CHECKING:
    from playwright.sync_api import Browser

if sys.platform == "win32":  # signals, terminals, devices, links and modes are of POSIX
    collect_ignore = [
        "fuzz",
        "pdp8/cli/test_files.py",
        "pdp8/cli/test_line.py",
        "pdp8/cli/test_refusals.py",
        "pdp8/cli/test_run.py",
        "pdp8/replay/test_command.py",
    ]

settings.register_profile("untimed", deadline=None)
settings.load_profile("untimed")

# One process a core is enough: threads of numpy and OpenCV would wait for each other, and take twice as long.
os.environ |= {"OPENBLAS_NUM_THREADS": "1", "OPENCV_FOR_THREADS_NUM": "1"}

# Outputs are those of anybody's terminal, and are buffered as they are for anybody.
_TERMINAL = "COLUMNS", "LINES", "FORCE_COLOR", "NO_COLOR", "CLICOLOR", "CLICOLOR_FORCE"
_RICH, _PYTHON = ("TTY_COMPATIBLE", "TTY_INTERACTIVE"), ("UNBUFFERED", "IOENCODING", "SAFEPATH", "WARNINGS")
for _variable in (*_TERMINAL, *_RICH, *(f"PYTHON{name}" for name in _PYTHON)):
    os.environ.pop(_variable, None)

if signal.getsignal(signal.SIGINT) is signal.SIG_IGN:  # by `&` of a script
    signal.signal(signal.SIGINT, signal.default_int_handler)
if sys.platform != "win32" and signal.getsignal(signal.SIGHUP) is signal.SIG_IGN:  # by `nohup`
    signal.signal(signal.SIGHUP, signal.SIG_DFL)

Call = Callable[..., tuple[int, str, str]]
Shell = Callable[..., commands.Done]
Result = TypeVar("Result")


@pytest.hookimpl(optionalhook=True)
def pytest_xdist_auto_num_workers() -> int:
    """Return one process more than there are cores: browsers, terminals and pipes are waited for."""
    return (os.cpu_count() or 1) + 1


@pytest.hookimpl(tryfirst=True)
def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Leave to `make check` what needs its packages, a browser's driver, OpenCV; begin with the longest."""
    items.sort(key=lambda item: not {"options", "transcripts"}.intersection(item.path.parts))
    for item in items:
        if "browser" in getattr(item, "fixturenames", ()):
            item.add_marker(pytest.mark.slow("in a browser"))
        if "photograph" in item.path.parts:
            item.add_marker(pytest.mark.slow("reads pictures by OpenCV"))


@pytest.hookimpl(trylast=True)
def pytest_unconfigure(config: pytest.Config) -> None:
    """Say in the last line what the machine was not compared with, where no C compiler is."""
    if not hasattr(config, "workerinput") and compiler() is None:
        print("No C compiler: the machine was NOT compared with the reference; no lockstep test ran.")


@pytest.fixture(autouse=True)
def nothing_outlives_its_test() -> Iterator[None]:
    """End commands that a failed test left, whose open pipes would fail another; refuse other leavings."""
    before = _process()
    yield
    while commands.STARTED:
        with commands.STARTED.pop() as run:
            run.kill()
    assert _process() == before, "the test leaves the process otherwise than it found it"


def _process() -> tuple[object, ...]:
    """Return what the tests of a process share: signals' handlers and the folder."""
    names = "SIGINT", "SIGTERM", "SIGHUP", "SIGALRM", "SIGPIPE"
    handlers = [signal.getsignal(getattr(signal, name)) for name in names if hasattr(signal, name)]
    return handlers, os.getcwd()


@pytest.fixture
def here(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Have a test work in an empty folder."""
    monkeypatch.chdir(tmp_path)


class Stream(io.TextIOWrapper):
    """A standard stream in memory, a terminal or not."""

    def __init__(self, content: bytes, terminal: bool) -> None:
        super().__init__(io.BytesIO(content), encoding="utf-8", write_through=True)
        self.isatty = lambda: terminal  # type: ignore[method-assign]


@pytest.fixture
def call(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Call:
    """Call a command in this process, in an empty folder; return its status, standard output and error.

    The three streams are a terminal, none is, or those named, "stdin stdout".
    """
    monkeypatch.chdir(tmp_path)

    def called(line: str, stdin: bytes = b"", terminal: bool | str = False) -> tuple[int, str, str]:
        contents = {"stdin": stdin, "stdout": b"", "stderr": b""}
        at = terminal.split() if isinstance(terminal, str) else [*contents] * terminal
        streams = [Stream(content, name in at) for name, content in contents.items()]
        for name, stream in zip(contents, streams, strict=True):
            monkeypatch.setattr(sys, name, stream)
        name, *words = shlex.split(line)
        status = command.status({"pdp8": pdp8, "pal": pal}[name], name, words)
        out, said = (stream.buffer.getvalue() for stream in streams[1:])  # type: ignore[attr-defined]
        return status, out.decode("utf-8", "surrogateescape"), said.decode()

    return called


@pytest.fixture
def shell(tmp_path: Path) -> Shell:
    """Run a command line in an empty folder, our commands first on the PATH; return the finished process."""
    if sys.platform == "win32":
        pytest.skip("a line for a POSIX shell")
    return lambda line, stdin=b"": commands.run("bash", "-c", line, stdin=stdin, folder=tmp_path)


def awaited(work: Coroutine[None, None, Result]) -> Result:
    """Return what a coroutine does, in a thread of its own: a page's tests keep a loop in this one."""
    with ThreadPoolExecutor(1) as thread:
        return thread.submit(asyncio.run, work).result()


@contextmanager
def case(*values: object) -> Iterator[None]:
    """Name the case in what fails within; hundreds of them are quicker in one test than in a test each."""
    try:
        yield
    except Exception as error:
        error.add_note("case " + ", ".join(map(str, values)))
        raise


def assert_same_tape(ours: bytes, expected: bytes) -> None:
    """Compare two tapes; the first difference is shown as holes."""
    if ours == expected:
        return
    for at, pair in enumerate(zip_longest(ours, expected)):
        if pair[0] != pair[1]:
            here, there = ("no frame" if frame is None else f"{frame:03o} |{draw(frame)}|" for frame in pair)
            pytest.fail(f"frame {at}: {here} should be {there} ({len(ours)} and {len(expected)} frames)")


@pytest.fixture(scope="session")
def browser() -> "Iterator[Browser]":
    """A headless Chromium; Playwright runs once in a process."""
    pytest.importorskip("playwright.sync_api", reason="playwright is not installed")
    if CHROMIUM is None:
        pytest.skip("Chromium is not installed")
    with launched() as chromium:
        yield chromium
