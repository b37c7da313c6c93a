"""What a run did, counted: as a table, as the listing with counts in its margin, as JSON."""

import json
from collections.abc import Iterator
from contextlib import contextmanager

from pdp8.computer.machine import Machine
from pdp8.computer.use.count import Count
from pdp8.computer.use.trace import Listing
from tapes import command


@contextmanager
def counting(
    machine: Machine, listing: Listing, table: bool, annotate: str | None, record: str | None
) -> Iterator[None]:
    """Count what `machine` does meanwhile; at the end show the `table` on standard error, write the annotated
    listing and the JSON into files of those names. Raises ShelfError.
    """
    count = Count()
    machine.watch.observer = count
    try:
        yield
    finally:
        machine.watch.observer = None
        if table:
            for line in count.table(listing):
                command.tell(line)
        if annotate is not None:
            command.put(annotate, "".join(f"{line}\n" for line in count.annotated(listing)))
        if record is not None:
            command.put(record, f"{json.dumps(count.record(listing), indent=1)}\n")
