"""An item of the catalogue made: a sheet with its pictures and caption, or a text with its caption.

figure-7.2.svg   table-10.1.txt   listing-B.txt   program-ch5-1.txt   figure-7.4.eia
"""

from collections.abc import Callable, Iterator
from importlib import import_module
from typing import Any, NamedTuple

from pdp8.thesis.catalogue import Item
from pdp8.thesis.evidence import TABLES
from pdp8.thesis.paper import framed
from pdp8.thesis.supplied import NOTE
from pdp8.thesis.table import Table
from tapes.errors import WorkError


class Made(NamedTuple):
    """The product of an item: its file, its table if it is one, its tape if any."""

    item: Item
    name: str
    text: str
    table: Table | None = None
    tape: bytes = b""

    @property
    def files(self) -> Iterator[tuple[str, bytes]]:
        """Yield the names and contents of all its files."""
        yield self.name, self.text.encode()
        if self.tape:
            yield f"{self.item.stem}.eia", self.tape

    @property
    def is_drawn(self) -> bool:
        """Whether it is a picture."""
        return self.name.endswith(".svg")


def make(item: Item) -> Made:
    """Make an item. Raises WorkError if it is lost."""
    if not item.maker:
        raise WorkError(f"{item.name}: {item.state}. {item.note}")
    product = _function(item.maker)(**item.given)
    tape: bytes = _function(item.tape)() if item.tape else b""
    table = product if isinstance(product, Table) else None
    pictures = product if isinstance(product, list) else [table.text() if table else product]
    heading = item.name.upper()
    if pictures[0].startswith("<svg"):
        sheet = framed(pictures, heading, item.title, item.caption, across=item.across)
        return Made(item, f"{item.stem}.svg", sheet, table, tape)
    note = f"\n{NOTE}" if item.number in (*TABLES, "10.1") else ""
    text = f"{heading}  {item.title}\n{item.caption}{note}\n\n{pictures[0]}"
    return Made(item, f"{item.stem}.txt", text, table, tape)


def _function(name: str) -> Callable[..., Any]:
    module, function = name.split(".")
    found: Callable[..., Any] = getattr(import_module(f"pdp8.thesis.{module}"), function)
    return found
