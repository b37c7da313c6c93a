"""What became of a source in PAL III."""

from collections.abc import Sequence
from functools import cached_property
from typing import TYPE_CHECKING

from pal import punch
from pal.assembler import Message, Output
from pal.assembly import PAL3, Assembly
from pal.source import Place, Source
from pal.symbols import PSEUDO_OPERATORS, SIGNIFICANT, typed
from pal.watched import Watched

if TYPE_CHECKING:
    from pal.listing import ListingLine, Teletype
    from pal.notes import Mention, Said

_PSEUDO = {name[:SIGNIFICANT] for name in PSEUDO_OPERATORS}


class Assembly3(Assembly):
    """What became of a source in PAL III."""

    def __init__(self, source: Source, names: Sequence[str], capacity: int, model: str | None) -> None:
        super().__init__(PAL3, names)
        self._source = source
        self._model = model
        self._assembler = assembler = Watched(source, capacity)
        self._first = assembler.run(1)
        self._table = assembler.table
        self._second: Output = [] if assembler.stopped else assembler.run(2)
        self.stopped = assembler.stopped
        self.words = {} if self.stopped else punch.words(self._second)
        self.ok = not self._complaints and not self.stopped

    @cached_property
    def tape(self) -> bytes:
        return b"" if self.stopped else punch.START_UP + punch.tape(self._second)

    @cached_property
    def symbols(self) -> dict[str, int]:
        return {entry.name: entry.value for entry in self._third.table if entry.defined}

    @cached_property
    def values(self) -> dict[str, int]:
        return self._third.values()

    @cached_property
    def mentions(self) -> list["Mention"]:
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
        return self._source.place(at)

    def first(self) -> int:
        return 0

    @cached_property
    def messages(self) -> list[str]:
        return [str(message) for message in self._complaints]

    @cached_property
    def lines(self) -> list["ListingLine"]:
        from pal import listing

        return list(listing.lines(self._source, self._third.output, self._third.lost))

    def text(self, number: int) -> str:
        from pal import listing

        if number == 2:
            return listing.text_of(listing.complaints(self._second))
        return listing.text_of(self._typed(number))

    @cached_property
    def teletype(self) -> "Teletype":
        from pal.listing import Teletype

        return Teletype(*(self._typed(number) for number in (1, 2, 3)))

    def is_empty(self) -> bool:
        return len(self._source.text) == 1

    def said(self) -> list["Said"]:
        from pal import review
        from pal.diagnostics import of_pal3

        noted = list(self._assembler.notes)
        stopped = self.stopped
        if not stopped:
            noted += review.notes(
                self._source, len(self.names), self._assembler, self._complaints, self._second, self._table
            )
        if self._assembler.moved or self._model:
            stopped = stopped or self._third.stopped
            noted += review.of_pass_3(self._second, self._third.output)
        if self._model:
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
        """The assembler after pass 3, or after the pass in which it stopped."""
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
