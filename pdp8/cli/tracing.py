"""A trace into a file, which is there whole when the run has ended, and not at all if it could not be
written.
"""

import os
import sys
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager
from typing import TextIO

from pdp8.computer.machine import Machine
from pdp8.computer.use.trace import Listing, Trace
from tapes import command, shelf
from tapes.errors import visible


@contextmanager
def tracing(machine: Machine, name: str, listing: Listing, cycles: bool) -> Iterator[None]:
    """Write what `machine` executes meanwhile into file `name`, or to standard output for `-`.

    Raises ShelfError.
    """
    if name == "-":
        with _observed(machine, sys.stdout, listing, cycles):
            yield
        return
    special, replaced = os.path.exists(name) and not os.path.isfile(name), os.path.isfile(name)
    try:
        with ExitStack() as stack:
            path = name if special else stack.enter_context(shelf.replacing(name))
            file = stack.enter_context(open(path, "w", encoding="utf-8", newline="\n"))
            with _observed(machine, file, listing, cycles):
                yield
            file.close()
    except OSError as error:
        raise shelf.ShelfError(f"{name}: {error.strerror}; no trace was written") from error
    command.tell_written(name, replaced)


@contextmanager
def _observed(machine: Machine, file: TextIO, listing: Listing, cycles: bool) -> Iterator[None]:
    shown = visible if file.isatty() else str
    trace = Trace(lambda line: file.write(shown(line) + "\n"), listing, cycles)
    machine.watch.observer = trace
    try:
        yield
    finally:
        machine.watch.observer = None
