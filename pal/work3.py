"""PAL III at work for an `Assembly`: its passes, what they typed, and what is said of them."""

from functools import cached_property
from typing import TYPE_CHECKING

from pal import punch
from pal.assembler import Message, Output
from pal.source import Place, Source
from pal.symbols import PSEUDO_OPERATORS, SIGNIFICANT, typed
from pal.watched import Watched

if TYPE_CHECKING:
    from pal.listing import ListingLine, Teletype
    from pal.notes import Mention, Said

_PSEUDO = {name[:SIGNIFICANT] for name in PSEUDO_OPERATORS}


class Work3:
    """What PAL III does with a source; the members are those that `Assembly` asks for."""

    def __init__(self, source: Source, tapes: int, capacity: int, model: str | None) -> None:
        self._source = source
        self._tapes = tapes
        self._model = model
        self._assembler = assembler = Watched(source, capacity)
        self._first = assembler.run(1)
        self._table = assembler.table
        self._second: Output = [] if assembler.stopped else assembler.run(2)
        self.stopped = assembler.stopped
        self.words = {} if self.stopped else punch.words(self._second)
        self.ok = not self._complaints and not self.stopped

    def tape(self) -> bytes:
        """Return the object tape as the high-speed punch made it; empty where pass 1 or 2 did not end."""
        return b"" if self.stopped else punch.START_UP + punch.tape(self._second)

    def symbols(self) -> dict[str, int]:
        """Return the symbols of the source as pass 3 leaves them, in the order of its table."""
        return {entry.name: entry.value for entry in self._third.table if entry.defined}

    def values(self) -> dict[str, int]:
        """Return the values of all symbols as pass 3 leaves them."""
        return self._third.values()

    def mentions(self) -> list["Mention"]:
        """Return the symbols where they stand."""
        from pal.notes import Mention

        found = []
        for at, (item, mark) in enumerate(self._source.items):
            name = item[:SIGNIFICANT]
            if name[:1].isalpha() and name not in _PSEUDO:
                found.append(Mention(name, at, mark in (",", "=")))
            if mark == "$":
                break
        return found

    def place(self, at: int) -> Place:
        """Return where an item of the source stands."""
        return self._source.place(at)

    def first(self) -> int:
        """Return the place of notes on the whole source."""
        return 0

    def messages(self) -> list[str]:
        """Return the messages of passes 1 and 2, UA included."""
        return [str(message) for message in self._complaints]

    def lines(self) -> list["ListingLine"]:
        """Return the listing by statements."""
        from pal import listing

        return list(listing.lines(self._source, self._third.output, self._third.lost))

    def text(self, number: int) -> str:
        """Return what pass 1, 2 or 3 typed, without the codes that do not print."""
        from pal import listing

        if number == 2:
            return listing.text_of(listing.complaints(self._second))
        return listing.text_of(self._typed(number))

    def teletype(self) -> "Teletype":
        """Return the frames of the three passes when the ASR-33 does it all."""
        from pal.listing import Teletype

        return Teletype(*(self._typed(number) for number in (1, 2, 3)))

    def is_empty(self) -> bool:
        """Tell whether there is nothing in the source."""
        return len(self._source.text) == 1

    def said(self) -> list["Said"]:
        """Return the messages, why PAL III went no further, and our notes."""
        from pal import review
        from pal.diagnostics import of_pal3

        noted = list(self._assembler.notes)
        stopped = self.stopped
        if not stopped:
            noted += review.notes(
                self._source, self._tapes, self._assembler, self._complaints, self._second, self._table
            )
        if self._assembler.moved or self._model:
            stopped = stopped or self._third.stopped
            noted += review.of_pass_3(self._second, self._third.output)
        if self._model and not self.stopped:
            noted += review.on_models(self._source, self._second, self._model)
        return of_pal3(self._source, self._complaints, stopped, noted)

    def _typed(self, number: int) -> bytes:
        from pal import listing

        if number == 1:
            table = listing.symbol_table(self._table, 1) if self._second else b""
            return punch.START_UP + listing.complaints(self._first) + table
        if number == 2:
            return listing.object_tape(self._second, not self.stopped) if self._second else b""
        if self.stopped:
            return b""
        third = self._third
        table = b"" if third.stopped else listing.symbol_table(third.table, 3)
        return listing.listing(self._source, third.output, third.lost, third.again) + table

    @cached_property
    def _third(self) -> Watched:
        """The assembler after pass 3; where it stopped before, as it was then."""
        if not self.stopped:
            self._assembler.run(3)
        return self._assembler

    @cached_property
    def _complaints(self) -> list[Message]:
        said = [piece for piece in (*self._first, *self._second) if isinstance(piece, Message)]
        undefined = [
            Message("UA", typed(entry.name), entry.value, entry.at)
            for entry in self._table
            if self._second and not entry.defined
        ]
        return said + undefined
