"""The whole of an assembly: source tapes in, the object tape, its words, and all that was typed out.

A dialect does the work (`pal.work3`, `pal.work8`): passes 1 and 2 at once, for the words; the tape, pass 3,
and whatever is for people to read, only when it is asked for: the program that is to run starts the sooner.
"""

from collections.abc import Sequence
from functools import cached_property
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from pal.diagnostics import Diagnostic
    from pal.listing import ListingLine, Teletype
    from pal.notes import Mention, Said
    from pal.source import Place
    from pal.work3 import Work3
    from pal.work8 import Work8

MOST = 100
"""Diagnostics that are printed, unless another number is asked for."""

PAL3, PAL8 = "pal3", "pal8"
SPELLED = {PAL3: "PAL III", PAL8: "PAL8"}


class Assembly:
    """What became of a source.

    dialect      PAL3 or PAL8
    names        what the source tapes are called
    words        {address: word} for loading, the field above the twelve bits of the address
    ok           whether passes 1 and 2 ended, and without an error
    stopped      why pass 1 or 2 went no further, and at which place of the source; None if both ended
    tape         the object tape as DEC's assembler makes it, `bytes`; empty if there is none
    symbols      {name: value} of the source's symbols; `values`, of all, the permanent ones included
    mentions     the symbols where they stand; pseudo-operators are left out
    lines        the listing by statements
    teletype     the frames that were typed and punched, pass by pass; a pass that was not run has none
    messages     DEC's messages of passes 1 and 2
    diagnostics  what is wrong, and what to know besides, in source order
    noted        what is to be said besides of the source as a whole
    """

    def __init__(self, dialect: str, names: Sequence[str], work: "Work3 | Work8") -> None:
        self.dialect = dialect
        self.names = names
        self.words = work.words
        self.ok = work.ok
        self.stopped = work.stopped
        self.noted: list[Said] = []
        self._work = work

    @cached_property
    def tape(self) -> bytes:
        """The object tape: leader, origins and words as they come, checksum, trailer."""
        return self._work.tape()

    @cached_property
    def symbols(self) -> dict[str, int]:
        """The symbols of the source in the order of the symbol table."""
        return self._work.symbols()

    @cached_property
    def values(self) -> dict[str, int]:
        """{name: value} of all symbols after the last pass."""
        return self._work.values()

    @cached_property
    def mentions(self) -> "list[Mention]":
        """The symbols where they stand."""
        return self._work.mentions()

    @cached_property
    def messages(self) -> list[str]:
        """DEC's messages as they were typed, those of pass 1 first."""
        return self._work.messages()

    @cached_property
    def lines(self) -> "list[ListingLine]":
        """The listing by statements."""
        return self._work.lines()

    @cached_property
    def listing(self) -> str:
        """What pass 3 types, with the symbol table, as text."""
        return self._work.text(3)

    @cached_property
    def teletype(self) -> "Teletype":
        """The frames of the three passes."""
        return self._work.teletype()

    @cached_property
    def diagnostics(self) -> "list[Diagnostic]":
        """What is wrong, and what to know besides."""
        from pal.diagnostics import empty, told

        if self._work.is_empty():
            return [empty(self.names)]
        return told([*self._work.said(), *self.noted], self.names, self.place)

    @property
    def symbol_table(self) -> str:
        """The symbol table: name, value, one a line."""
        return "".join(f"{name:6}  {value:04o}\n" for name, value in self.symbols.items())

    def place(self, at: int) -> "Place":
        """Return where a mention or a message stands in the source."""
        return self._work.place(at)

    def __repr__(self) -> str:
        """Return what it is in one line: the source tapes, the dialect, how many words and errors."""
        from tapes.quantities import counted

        errors = sum(diagnostic.error for diagnostic in self.diagnostics)
        said = f"{counted(len(self.words), 'words')}, {counted(errors, 'errors')}"
        return f"<Assembly of {', '.join(self.names)} in {self.dialect}: {said}>"

    def _repr_html_(self) -> str:
        """Return the listing as HTML, for a notebook."""
        from pal.reports import html

        return html(self)

    def text(self, number: int) -> str:
        """Return what pass 1, 2 or 3 typed, without the codes that do not print."""
        return self._work.text(number)
