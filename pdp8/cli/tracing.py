"""A trace into a file, which is there whole when the run has ended, and not at all if it could not be
written.
"""

import os
import sys
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from typing import TextIO

from pdp8.computer.machine import Machine
from pdp8.computer.trace import Listing, Trace
from tapes.shelf import ShelfError


@contextmanager
def tracing(machine: Machine, name: str, listing: Listing, cycles: bool) -> Iterator[None]:
    """Write what `machine` executes meanwhile into file `name`, or to standard output for `-`.

    Raises ShelfError.
    """
    if name == "-":
        with _told(machine, sys.stdout, listing, cycles):
            yield
        return
    if os.path.isdir(name):
        raise ShelfError(f"{name}: Is a directory")
    special = os.path.exists(name) and not os.path.isfile(name)
    beside = name if special else f"{name}.{os.getpid()}.part"
    try:
        with open(beside, "w") as file, _told(machine, file, listing, cycles):
            yield
        if not special:
            os.replace(beside, name)
    except OSError as error:
        raise ShelfError(f"{name}: {error.strerror}; no trace was written") from error
    finally:
        if not special:
            with suppress(FileNotFoundError):
                os.unlink(beside)


@contextmanager
def _told(machine: Machine, file: TextIO, listing: Listing, cycles: bool) -> Iterator[None]:
    trace = Trace(lambda line: file.write(line + "\n"), listing, cycles)
    trace.begin(machine.processor)
    machine.watch.observer = trace
    try:
        yield
    finally:
        machine.watch.observer = None
