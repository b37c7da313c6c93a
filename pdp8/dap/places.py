"""The lines of a source, and the addresses of its words.

A PAL source is the file itself. A BIN or RIM tape has none: its listing, disassembled, is shown in its place,
and the editor asks for it.
"""

import os

from pdp8.computer.use.program import Program
from pdp8.dap.wire import Body
from tapes import kinds, shelf

_LISTING = 1
"""The editor's reference for the listing of a tape."""


class Places:
    """Where the words of a program stand; its first line has number `first`, to the editor."""

    def __init__(self, program: Program, first: int = 1) -> None:
        listing = program.listing
        self.listing = listing
        self.path = os.path.realpath(shelf.find(program.name))
        self.source: Body = {"name": os.path.basename(self.path), "path": self.path}
        self._lines = {address: number - 1 + first for address, number in listing.numbers.items()}
        if program.kind != kinds.ASCII:
            self.source = {"name": f"{self.source['name']}, disassembled", "sourceReference": _LISTING}
            self._lines = {address: number + first for address, number in listing.places.items()}
        self._addresses: dict[int, int] = {}
        for address, line in self._lines.items():
            self._addresses.setdefault(line, address)

    @property
    def text(self) -> str:
        """The listing."""
        return "\n".join(self.listing.lines) + "\n"

    def is_of(self, source: Body) -> bool:
        """Tell whether the editor speaks of this source."""
        if source.get("sourceReference"):
            return bool(source["sourceReference"] == self.source.get("sourceReference"))
        return os.path.realpath(str(source.get("path", ""))) == self.source.get("path")

    def line(self, address: int) -> int | None:
        """Return the line of the word at `address`, or None."""
        return self._lines.get(address)

    def first_from(self, line: int) -> tuple[int, int] | None:
        """Return the first line from `line` on that has a word, and its first word's address."""
        found = min((each for each in self._addresses if each >= line), default=None)
        return None if found is None else (found, self._addresses[found])
