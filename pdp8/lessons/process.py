"""A process that marks answers and sends the marks, until one takes more time or memory than it may.

POSIX alone: Windows has no fork.
"""

import os
import pickle
import signal
import sys
import traceback
from collections.abc import Callable, Iterator, Sequence

from pdp8.lessons import marking
from pdp8.lessons.answer import Answer
from pdp8.lessons.exercise import Exercise
from pdp8.lessons.marking import Result

assert sys.platform != "win32"

MEMORY = 512 << 20
"""Bytes more than the command has."""
LARGEST = 1 << 20
"""Bytes of an answer's marks."""
_NO_MEMORY = 3


def fault(status: int, seconds: float) -> str:
    """Return why the process of an answer ended. Raises RuntimeError where no bound was the reason."""
    if os.WIFSIGNALED(status) and os.WTERMSIG(status) == signal.SIGPROF:
        return f"it took more than {seconds:g} s of processor time, and was ended"
    if os.WIFSIGNALED(status) or os.WEXITSTATUS(status) == _NO_MEMORY:
        return f"it took more than {MEMORY >> 20} MiB of memory, and was ended"
    raise RuntimeError("marking an answer failed; the traceback is above")


def process(
    exercise: Exercise, answers: Sequence[Answer], seconds: float, dialect: str
) -> tuple[list[Result], int]:
    """Return the results of the answers up to the first that is ended, and the process's exit status."""
    source, sink = os.pipe()
    child = os.fork()
    if child == 0:
        os.close(source)
        _work(exercise, answers, seconds, dialect, sink)
    os.close(sink)
    with os.fdopen(source, "rb") as pipe:
        results = list(_received(pipe.read))
    return results, os.waitpid(child, 0)[1]


def _received(read: Callable[[int], bytes]) -> Iterator[Result]:
    while len(head := read(4)) == 4:
        size = int.from_bytes(head, "big")
        content = read(size)
        if len(content) < size:
            return
        result: Result = pickle.loads(content)
        yield result


def _work(exercise: Exercise, answers: Sequence[Answer], seconds: float, dialect: str, sink: int) -> None:
    """Mark the answers in this process, which ends with it and never returns."""
    try:
        signal.signal(signal.SIGPROF, signal.SIG_DFL)
        _bound_memory()
        with os.fdopen(sink, "wb") as pipe:
            for answer in answers:
                signal.setitimer(signal.ITIMER_PROF, seconds)
                content = _content(exercise, answer, dialect)
                pipe.write(len(content).to_bytes(4, "big") + content)
                pipe.flush()
    except MemoryError:
        os._exit(_NO_MEMORY)
    except Exception:
        traceback.print_exc()
    finally:
        os._exit(os.EX_OK)


def _content(exercise: Exercise, answer: Answer, dialect: str) -> bytes:
    result = marking.mark(exercise, answer, dialect)
    content = pickle.dumps(result)
    if len(content) > LARGEST:
        fault = f"its tapes and pages have more than {LARGEST:,} bytes"
        return pickle.dumps(Result(answer.name, (), result.of, fault))
    return content


def _bound_memory() -> None:
    import resource

    if not os.path.exists("/proc/self/statm"):  # macOS bounds no address space
        return
    with open("/proc/self/statm", encoding="ascii") as file:
        now = int(file.read().split()[0]) * resource.getpagesize()
    soft, hard = resource.getrlimit(resource.RLIMIT_AS)
    bounds = [now + MEMORY, *(bound for bound in (soft, hard) if bound != resource.RLIM_INFINITY)]
    resource.setrlimit(resource.RLIMIT_AS, (min(bounds), hard))
