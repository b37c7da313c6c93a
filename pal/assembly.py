"""What became of a source: its object tape, its words, and all that was typed out.

`pal.assembly3` and `pal.pal8.assembly` make it, in the two dialects: passes 1 and 2 at once, for the words;
the tape, pass 3 and what is for people to read, only when it is asked for, so that a program starts sooner.
"""

from collections.abc import Iterator, Sequence
from functools import cached_property
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from pal.diagnostics import Diagnostic
    from pal.listing import ListingLine, Teletype
    from pal.notes import Mention, Said
    from pal.source import Place

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
    noted        what is to be said of the source as a whole
    """

    words: dict[int, int]
    ok: bool
    stopped: tuple[str, int] | None

    def __init__(self, dialect: str, names: Sequence[str]) -> None:
        self.dialect = dialect
        self.names = names
        self.noted: list[Said] = []

    def __iter__(self) -> Iterator[tuple[int, int]]:
        """Yield (address, word), so that a machine loads an assembly as it is."""
        return iter(self.words.items())

    @property
    def tape(self) -> bytes:
        """The object tape as DEC's assembler punches it; empty if there is none."""
        raise NotImplementedError

    @property
    def symbols(self) -> dict[str, int]:
        """{name: value} of the source's symbols, in the order of the symbol table."""
        raise NotImplementedError

    @property
    def values(self) -> dict[str, int]:
        """{name: value} of all symbols, the permanent ones included."""
        raise NotImplementedError

    @property
    def mentions(self) -> "list[Mention]":
        """Where each symbol is used or defined, without the pseudo-operators."""
        raise NotImplementedError

    @property
    def messages(self) -> list[str]:
        """DEC's messages of passes 1 and 2, as they were typed."""
        raise NotImplementedError

    @property
    def lines(self) -> "list[ListingLine]":
        """The listing by statements."""
        raise NotImplementedError

    @property
    def teletype(self) -> "Teletype":
        """The frames that were typed and punched in each pass; a pass that was not run has none."""
        raise NotImplementedError

    @cached_property
    def listing(self) -> str:
        """What pass 3 types, with the symbol table."""
        return self.text(3)

    @cached_property
    def diagnostics(self) -> "list[Diagnostic]":
        """What is wrong, and what to know besides, in the order of the source."""
        from pal.diagnostics import empty, told

        if self.is_empty():
            return [empty(self.names)]
        return told([*self.said(), *self.noted], self.names, self.place)

    def add_note(self, key: str, **values: str) -> None:
        """Add a note on the source as a whole."""
        from pal.notes import NOTE, note

        self.noted.append((NOTE, note(key, self.first(), **values), ""))

    @property
    def symbol_table(self) -> str:
        """The symbol table: name, value, one a line."""
        return "".join(f"{name:6}  {value:04o}\n" for name, value in self.symbols.items())

    def text(self, number: int) -> str:
        """Return what pass 1, 2 or 3 typed, without the codes that do not print."""
        raise NotImplementedError

    def place(self, at: int) -> "Place":
        """Return the place in the source of a mention or a message."""
        raise NotImplementedError

    def first(self) -> int:
        """Return the place for notes about the whole source."""
        raise NotImplementedError

    def is_empty(self) -> bool:
        """Whether there is nothing in the source."""
        raise NotImplementedError

    def said(self) -> "list[Said]":
        """Return errors and notes, unsorted."""
        raise NotImplementedError

    def __repr__(self) -> str:
        """Return a line with source tapes, dialect, and the numbers of words and errors."""
        from tapes.quantities import counted

        errors = sum(diagnostic.error for diagnostic in self.diagnostics)
        said = f"{counted(len(self.words), 'words')}, {counted(errors, 'errors')}"
        return f"<Assembly of {', '.join(self.names)} in {self.dialect}: {said}>"

    def _repr_html_(self) -> str:
        """Return the listing as HTML, for a notebook."""
        from pal.reports import html

        return html(self)
