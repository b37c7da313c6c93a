"""The whole of an assembly: source tapes in, the object tape, its words, and all that was typed out.

Passes 1 and 2 are run at once, for the words; the tape, pass 3, and whatever is for people to read, only
when it is asked for: the program that is to run starts the sooner.
"""

from collections.abc import Sequence
from functools import cached_property
from typing import TYPE_CHECKING

from pal import punch
from pal.assembler import Message, Output
from pal.source import Place, Source
from pal.symbols import PSEUDO_OPERATORS, SIGNIFICANT, typed
from pal.watched import Watched

if TYPE_CHECKING:
    from pal.diagnostics import Diagnostic
    from pal.listing import ListingLine, Teletype
    from pal.notes import Mention

MOST = 100
"""Diagnostics that are printed, unless another number is asked for."""

PAL3, PAL8 = "pal3", "pal8"
_PSEUDO = {name[:SIGNIFICANT] for name in PSEUDO_OPERATORS}


class Assembly:
    """What became of a source.

    dialect      PAL3 or PAL8
    tape         the object tape as the high-speed punch made it, `bytes`; empty if there is none
    words        {address: word} for loading, the field above the twelve bits of the address
    diagnostics  what is wrong, in source order; `ok` if there is no error on the way to the tape
    stopped      why pass 1 or 2 went no further, and at which item of the source; None if both ended
    symbols      {name: value} of the source's symbols, in the order of the symbol table
    listing      what pass 3 typed, without the codes that do not print
    lines        the same by statements
    """

    dialect = PAL3

    def __init__(self, source: Source, names: Sequence[str], capacity: int, model: str | None = None) -> None:
        self.source = source
        self.model = model
        self.names = names
        self._assembler = assembler = Watched(source, capacity)
        self._first = assembler.run(1)
        self._table = assembler.table
        self._second: Output = [] if assembler.stopped else assembler.run(2)
        self.stopped = assembler.stopped
        self.words = {} if self.stopped else punch.words(self._second)

    @property
    def ok(self) -> bool:
        """Whether passes 1 and 2 ended, and without a message."""
        return not self.messages and not self.stopped

    @cached_property
    def tape(self) -> bytes:
        """The object tape as the high-speed punch made it; empty where pass 1 or 2 did not end."""
        return b"" if self.stopped else punch.START_UP + punch.tape(self._second)

    @cached_property
    def diagnostics(self) -> list["Diagnostic"]:
        """What is wrong, and what to know besides."""
        from pal import review
        from pal.diagnostics import diagnose

        noted = list(self._assembler.notes)
        stopped = self.stopped
        if not stopped:
            tapes = len(self.names)
            noted += review.notes(
                self.source, tapes, self._assembler, self.messages, self._second, self._table
            )
        if self._assembler.moved or self.model:
            stopped = stopped or self._third.stopped
            noted += review.of_pass_3(self._second, self._third.output)
        if self.model and not self.stopped:
            noted += review.on_models(self.source, self._second, self.model)
        return diagnose(self.source, self.names, self.messages, stopped, noted)

    def place(self, at: int) -> Place:
        """Return where an item of the source stands, as diagnostics and mentions have it."""
        return self.source.place(at)

    @cached_property
    def mentions(self) -> list["Mention"]:
        """The symbols where they stand; pseudo-operators are left out."""
        from pal.notes import Mention

        found = []
        for at, (item, mark) in enumerate(self.source.items):
            name = item[:SIGNIFICANT]
            if name[:1].isalpha() and name not in _PSEUDO:
                found.append(Mention(name, at, mark in (",", "=")))
            if mark == "$":
                break
        return found

    @cached_property
    def symbols(self) -> dict[str, int]:
        """The symbols of the source as pass 3 leaves them."""
        return {entry.name: entry.value for entry in self._third.table if entry.defined}

    @property
    def symbol_table(self) -> str:
        """The symbol table as pass 3 typed it: name, value, one a line."""
        return "".join(f"{name:6}  {value:04o}\n" for name, value in self.symbols.items())

    @cached_property
    def listing(self) -> str:
        """What pass 3 typed, `\\n` for CR LF."""
        return self.text(3)

    @cached_property
    def lines(self) -> list["ListingLine"]:
        """The listing by statements."""
        from pal import listing

        return list(listing.lines(self.source, self._third.output, self._third.lost))

    def text(self, number: int) -> str:
        """Return what pass 1, 2 or 3 typed, without the codes that do not print."""
        from pal import listing

        if number == 2:
            return listing.text_of(listing.complaints(self._second))
        return listing.text_of(self._typed(number))

    @cached_property
    def teletype(self) -> "Teletype":
        """The frames of the three passes when the ASR-33 does it all; a pass that was not run has none."""
        from pal.listing import Teletype

        return Teletype(*(self._typed(number) for number in (1, 2, 3)))

    def _typed(self, number: int) -> bytes:
        from pal import listing

        if number == 1:
            table = listing.symbol_table(self._table, 1) if self._second else b""
            return punch.START_UP + listing.complaints(self._first) + table
        if number == 2:
            return listing.object_tape(self._second, not self.stopped) if self._second else b""
        if self.stopped:
            return b""
        table = b"" if self._third.stopped else listing.symbol_table(self._third.table, 3)
        third = self._third
        return listing.listing(self.source, third.output, third.lost, third.again) + table

    @cached_property
    def values(self) -> dict[str, int]:
        """{name: value} of all symbols as pass 3 leaves them, the permanent ones included."""
        return self._third.values()

    def _repr_html_(self) -> str:
        """Return the listing as HTML, for a notebook."""
        from pal.reports import html

        return html(self)

    @cached_property
    def _third(self) -> Watched:
        """The assembler after pass 3; where it stopped before, as it was then."""
        if not self.stopped:
            self._assembler.run(3)
        return self._assembler

    @cached_property
    def messages(self) -> list[Message]:
        """The messages of passes 1 and 2, UA included."""
        said = [piece for piece in (*self._first, *self._second) if isinstance(piece, Message)]
        undefined = [
            Message("UA", typed(entry.name), entry.value, entry.at)
            for entry in self._table
            if self._second and not entry.defined
        ]
        return said + undefined
