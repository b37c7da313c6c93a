"""What a run did, counted: as a table, as the listing with counts in its margin, as JSON."""

import json
import sys
from collections.abc import Iterator
from contextlib import contextmanager

import click

from pdp8.computer.machine import Machine
from pdp8.computer.use.count import Count
from pdp8.computer.use.trace import Listing
from tapes import shelf


@contextmanager
def counting(
    machine: Machine, listing: Listing, table: bool, annotate: str | None, record: str | None
) -> Iterator[None]:
    """Count what `machine` does meanwhile; at the end show the `table` on standard error, write the annotated
    listing and the JSON into files of those names. Raises ShelfError.
    """
    for name in (annotate, record):
        if name is not None:
            shelf.check_writable(name)
    count = Count()
    machine.watch.observer = count
    try:
        yield
    finally:
        machine.watch.observer = None
        if annotate is not None:
            shelf.write(annotate, "".join(f"{line}\n" for line in count.annotated(listing)).encode())
        if record is not None:
            shelf.write(record, f"{json.dumps(count.record(listing), indent=1)}\n".encode())
        if table:
            for line in count.table(listing):
                click.echo(line, file=sys.stderr)
