"""The lines of a source and the addresses of its words; and what an editor calls an address.

A PAL source is the file itself. A BIN or RIM tape has none: its listing, disassembled, is shown in its place,
and the editor asks for it.
"""

import os
from collections.abc import Sequence
from difflib import SequenceMatcher
from operator import itemgetter

from pal.text import Text, path_of
from pdp8 import shelf
from pdp8.computer.use.program import Program
from pdp8.dap.wire import Body
from tapes import codes
from tapes.errors import WorkError

BYTES = 2
"""Bytes of a word."""
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
    """Where a program's words are in its sources; `first` and `column` are the editor's numbers of line and
    column 1.
    """

    def __init__(self, program: Program, first: int = 1, column: int = 1) -> None:
        self.listing = listing = program.listing
        self.name = program.name
        self._first = first
        self.column = column
        self._paths = [os.path.realpath(shelf.find(name)) for name in program.names]
        self._times = self._stamps()
        self._sources: list[Body] = [{"name": os.path.basename(path), "path": path} for path in self._paths]
        self.lines = {
            address: (listing.tapes[address], number - 1 + first)
            for address, number in listing.numbers.items()
        }
        """{address: the tape and the line of the word there}."""
        if program.code is not codes.ASCII:
            name = f"{self._sources[0]['name']}, disassembled"
            self._sources = [{"name": name, "sourceReference": _LISTING}]
            self.lines = {address: (0, number + first) for address, number in listing.places.items()}

    def at(self, address: int) -> Body | None:
        """Return the source and the line of the word at an address, as the protocol has them."""
        if address not in self.lines:
            return None
        tape, line = self.lines[address]
        return {"source": self._sources[tape], "line": line, "column": self.column}

    def _tape(self, source: Body) -> int | None:
        """Return the tape that the editor names by path or URI, None for another file."""
        path = str(source.get("path", ""))
        if path.startswith("file://"):
            path = path_of(path)
        for tape, own in enumerate(self._sources):
            if source.get("sourceReference"):
                if source["sourceReference"] == own.get("sourceReference"):
                    return tape
            elif os.path.realpath(path) == own.get("path"):
                return tape
        return None

    def is_of(self, source: Body) -> bool:
        """Tell whether the editor speaks of a source of this program."""
        return self._tape(source) is not None

    def source_of(self, source: Body) -> Body:
        """Return the source that the editor speaks of, as this program calls it."""
        tape = self._tape(source)
        return source if tape is None else self._sources[tape]

    def first_from(self, source: Body, line: int) -> tuple[int, int] | None:
        """Return the address of the first word from a line of a source on, and its line."""
        tape = self._tape(source)
        found = ((at, number) for at, (of, number) in self.lines.items() if of == tape and number >= line)
        return min(found, key=itemgetter(1), default=None)

    def text(self, source: Body) -> list[str]:
        """Return the lines of a source as its file has them now; of another file, or a listing, none."""
        path = self.source_of(source).get("path")
        if not self.is_of(source) or path is None or not os.path.exists(path):
            return []
        with open(path, "rb") as file:
            return Text(file.read().decode("utf-8", "replace")).lines

    def went(self, source: Body, line: int, before: Sequence[str]) -> int:
        """Return where a line is after edits of its source; if it was replaced, where its replacement is."""
        at = line - self._first
        edits = SequenceMatcher(None, before, self.text(source)).get_opcodes()
        for _, first, last, start, end in edits:
            if at < last:
                return start + min(at - first, max(end - start - 1, 0)) + self._first
        return line

    def changed(self) -> list[str]:
        """Return the sources that another program has written since the last look."""
        before, self._times = self._times, self._stamps()
        return [
            path for path, one, other in zip(self._paths, before, self._times, strict=True) if one != other
        ]

    def _stamps(self) -> list[int]:
        """Return when each source was last written, 0 for one that is gone."""
        return [os.stat(path).st_mtime_ns if os.path.exists(path) else 0 for path in self._paths]
