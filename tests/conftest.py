"""What the tests of several packages share: a shell, and how two tapes are compared."""

import asyncio
import os
import sys
from collections.abc import Callable, Coroutine, Iterator
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, TypeVar

import pytest

import programs  # noqa: F401 - its files go on the shelf
from tests import commands
from tests.pdp8.web.browsing import CHROMIUM, launched

if TYPE_CHECKING:
    from playwright.sync_api import Browser

if sys.platform == "win32":  # signals, terminals, devices, links and modes are of POSIX
    collect_ignore = [
        "fuzz",
        "pdp8/cli/test_files.py",
        "pdp8/cli/test_line.py",
        "pdp8/cli/test_manners.py",
        "pdp8/cli/test_run.py",
        "pdp8/replay/test_command.py",
    ]

Shell = Callable[..., commands.Done]
Result = TypeVar("Result")


@pytest.hookimpl(optionalhook=True)
def pytest_xdist_auto_num_workers() -> int:
    """Return one process more than there are cores: browsers, terminals and pipes are waited for."""
    return (os.cpu_count() or 1) + 1


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


def holes(frame: int | None) -> str:
    """Return a frame as its row of holes, channel 8 first, the sprocket between 4 and 3."""
    if frame is None:
        return "(no frame)"
    row = "".join("o" if frame & 1 << channel else "-" for channel in range(7, -1, -1))
    return f"{row[:5]}.{row[5:]} {frame:03o}"


def assert_same_tape(ours: bytes, expected: bytes) -> None:
    """Compare two tapes; the first difference is shown as holes."""
    if ours == expected:
        return
    at = next(
        (i for i, pair in enumerate(zip(ours, expected, strict=False)) if pair[0] != pair[1]),
        min(len(ours), len(expected)),
    )
    there, here = (tape[at] if at < len(tape) else None for tape in (ours, expected))
    pytest.fail(
        f"tapes of {len(ours)} and {len(expected)} frames differ first at frame {at}: "
        f"{holes(there)} where {holes(here)} was expected"
    )


@pytest.fixture(scope="session")
def browser() -> "Iterator[Browser]":
    """A headless Chromium; Playwright runs once in a process."""
    pytest.importorskip("playwright.sync_api", reason="playwright is not installed")
    if CHROMIUM is None:
        pytest.skip("Chromium is not installed")
    with launched() as chromium:
        yield chromium
