"""The lines of a source and the addresses of its words; and what an editor calls an address.

A PAL source is the file itself. A BIN or RIM tape has none: its listing, disassembled, is shown in its place,
and the editor asks for it.
"""

import os
from operator import itemgetter

from pdp8 import shelf
from pdp8.computer.use.program import Program
from pdp8.dap.wire import Body
from tapes import kinds
from tapes.errors import WorkError

BYTES = 2
"""Of a word."""
_LISTING = 1
"""The editor's reference for the listing of a tape."""


def reference(address: int) -> str:
    """Return what an editor calls the word at `address`: the number of its first byte."""
    return f"0x{BYTES * address:04x}"


def byte(text: str, offset: int = 0) -> int:
    """Return the number of a byte by a reference, `offset` bytes on. Raises WorkError."""
    try:
        return int(text, 0) + offset
    except ValueError:
        raise WorkError(f"{text}: a reference to memory is a number such as 0x0100") from None


def place(text: str, offset: int = 0) -> int:
    """Return the address of a word by its reference, `offset` bytes on. Raises WorkError."""
    at = byte(text, offset)
    if at % BYTES:
        raise WorkError(f"{text}: no word begins at byte {at:x}")
    return at // BYTES


class Places:
    """Where the words of a program stand; its first line has number `first`, to the editor."""

    def __init__(self, program: Program, first: int = 1) -> None:
        self.listing = listing = program.listing
        self.path = os.path.realpath(shelf.find(program.name))
        self.source: Body = {"name": os.path.basename(self.path), "path": self.path}
        self.lines = {address: number - 1 + first for address, number in listing.numbers.items()}
        """The line of the word at each address."""
        if program.kind != kinds.ASCII:
            self.source = {"name": f"{self.source['name']}, disassembled", "sourceReference": _LISTING}
            self.lines = {address: number + first for address, number in listing.places.items()}

    def is_of(self, source: Body) -> bool:
        """Tell whether the editor speaks of this source."""
        if source.get("sourceReference"):
            return bool(source["sourceReference"] == self.source.get("sourceReference"))
        return os.path.realpath(str(source.get("path", ""))) == self.source.get("path")

    def first_from(self, line: int) -> tuple[int, int] | None:
        """Return the address of the first word from `line` on, and its line."""
        found = (item for item in self.lines.items() if item[1] >= line)
        return min(found, key=itemgetter(1), default=None)
