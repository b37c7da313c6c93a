"""What a run did, counted: as a table, as the listing with counts in its margin, as JSON."""

import json
from collections.abc import Iterator
from contextlib import contextmanager

from pdp8.computer.machine import Machine
from pdp8.computer.use import counted
from pdp8.computer.use.trace import Listing
from tapes import command


@contextmanager
def counting(
    machine: Machine, listing: Listing, table: bool, annotate: str | None, record: str | None
) -> Iterator[None]:
    """Count what `machine` does meanwhile; at the end show the `table` on standard error, write the annotated
    listing and the JSON into files of those names. Raises ShelfError.
    """
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
            if record is not None:
                command.put(record, f"{json.dumps(counted.record(count, listing), indent=1)}\n")
