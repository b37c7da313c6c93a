"""The answers of a class marked, each in a process with bounds of processor time, memory and output.

Where there is no fork (Windows) the answers are marked here, and nothing but machine time bounds them.
"""

import os
import pickle
import signal
from collections.abc import Sequence
from contextlib import suppress
from pathlib import Path
from typing import TYPE_CHECKING

from pdp8.computer.use.program import FOUND
from pdp8.lessons import marking
from pdp8.lessons.answer import Answer
from pdp8.lessons.exercise import Exercise
from pdp8.lessons.marking import Result

if TYPE_CHECKING:
    from multiprocessing.connection import Connection

SECONDS = 10
"""Seconds of processor time for each answer."""
MEMORY = 512 << 20
"""Bytes that marking an answer may take beyond what the command has."""
LARGEST = 1 << 20
"""Bytes of an answer's marks."""


def marked(
    exercise: Exercise, answers: Sequence[Answer], seconds: float = SECONDS, dialect: str = FOUND
) -> list[Result]:
    """Return the marks of each answer; those of one that takes more than `seconds` are a fault."""
    if not hasattr(os, "fork"):
        return [marking.mark(exercise, answer, dialect) for answer in answers]
    return [_apart(exercise, answer, seconds, dialect) for answer in answers]


def _apart(exercise: Exercise, answer: Answer, seconds: float, dialect: str) -> Result:
    from multiprocessing import get_context

    fork = get_context("fork")
    source, sink = fork.Pipe()
    worker = fork.Process(target=_work, args=(exercise, answer, seconds, dialect, sink))
    worker.start()
    sink.close()
    content = b""
    with source, suppress(EOFError, OSError):
        content = source.recv_bytes()
    worker.join()
    if not content:
        return Result(answer.name, (), exercise.points, _fault(worker.exitcode, seconds))
    result: Result = pickle.loads(content)
    return result


def _fault(status: int | None, seconds: float) -> str:
    """Return why an answer's process ended. Raises RuntimeError if no limit was reached."""
    if status == -signal.SIGPROF:
        return f"it took more than {seconds:g} s of processor time, and was ended"
    if status == 1:
        raise RuntimeError("marking an answer failed; the traceback is above")
    return f"it took more than {MEMORY >> 20} MiB of memory, and was ended"


def _work(exercise: Exercise, answer: Answer, seconds: float, dialect: str, sink: "Connection") -> None:
    for number in (signal.SIGPROF, signal.SIGINT):
        signal.signal(number, signal.SIG_DFL)
    _bound_memory()
    signal.setitimer(signal.ITIMER_PROF, seconds)
    with suppress(MemoryError):
        result = marking.mark(exercise, answer, dialect)
        content = pickle.dumps(result)
        if len(content) > LARGEST:
            fault = f"its tapes and pages have more than {LARGEST:,} bytes"
            content = pickle.dumps(Result(answer.name, (), result.of, fault))
        sink.send_bytes(content)


def _bound_memory() -> None:
    import resource

    pages = Path("/proc/self/statm")
    if pages.exists():  # macOS bounds no address space
        now = int(pages.read_bytes().split()[0]) * resource.getpagesize()
        soft, hard = resource.getrlimit(resource.RLIMIT_AS)
        bounds = [now + MEMORY, *(bound for bound in (soft, hard) if bound != resource.RLIM_INFINITY)]
        resource.setrlimit(resource.RLIMIT_AS, (min(bounds), hard))
