"""A run watched: traced into a file, which is there whole when the run has ended, and not at all if it could
not be written; or counted: as a table, as the listing with counts in its margin.
"""

import os
import sys
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager
from typing import TextIO

from pdp8 import shelf
from pdp8.cli.shared import command
from pdp8.computer.machine import Machine
from pdp8.computer.use import counted
from pdp8.computer.use.trace import Listing, Trace
from tapes.errors import visible


@contextmanager
def tracing(machine: Machine, name: str, listing: Listing) -> Iterator[None]:
    """Write what `machine` executes inside into file `name` or `-`. Raises ShelfError."""
    if name == "-":
        with _observed(machine, sys.stdout, listing):
            yield
        return
    special, replaced = os.path.exists(name) and not os.path.isfile(name), os.path.isfile(name)
    with shelf.failing(name, "; no trace was written"), ExitStack() as stack:
        path = name if special else stack.enter_context(shelf.replacing(name))
        file = stack.enter_context(open(path, "w", encoding="utf-8", newline="\n"))
        with _observed(machine, file, listing):
            yield
        file.close()
    command.tell_written(name, replaced)


@contextmanager
def _observed(machine: Machine, file: TextIO, listing: Listing) -> Iterator[None]:
    shown = visible if file.isatty() else str
    trace = Trace(lambda line: file.write(shown(line) + "\n"), listing, cycles=False)
    machine.watch.observer = trace
    try:
        yield
    finally:
        machine.watch.observer = None


@contextmanager
def counting(machine: Machine, listing: Listing, table: bool, annotate: str | None) -> Iterator[None]:
    """Count what runs inside; show the `table`, write the listing to `annotate`. Raises ShelfError."""
    with machine.count() as count:
        try:
            yield
        finally:
            if table:
                for line in counted.table(count, listing):
                    command.tell(line)
            if annotate is not None:
                lines = counted.annotated(count, listing)
                command.put(annotate, "".join(f"{line}\n" for line in lines))
