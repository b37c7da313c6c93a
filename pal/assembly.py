"""The whole of an assembly: source tapes in, the object tape, its words, and all that was typed out.

    assemble("*200\\n\\tCLA\\n\\tHLT\\n$\\n").words  ->  {0o200: 0o7200, 0o201: 0o7402}

Passes 1 and 2 are run at once, for the words; the tape, pass 3, and whatever is for people to read, only
when it is asked for: the program that is to run starts the sooner.
"""

from collections.abc import Sequence
from functools import cached_property
from typing import TYPE_CHECKING

from pal import punch, scanner
from pal.assembler import TELETYPE_SYMBOLS, Assembler, Entry, Message, Result
from pal.scanner import Line
from pal.symbols import internal_order

if TYPE_CHECKING:
    from pal.diagnostics import Diagnostic
    from pal.listing import ListingLine, Teletype


class Assembly:
    """What became of a source.

    tape         the object tape as the high-speed punch made it, `bytes`; empty if the symbol table was full
    words        {address: word} for loading, the field above the twelve bits of the address
    diagnostics  what is wrong, in source order; `ok` if none of it is an error
    symbols      {name: value} of the user's symbols, in the order of the symbol table
    listing      what pass 3 typed, without the codes that do not print
    lines        the same by statements
    """

    def __init__(self, lines: list[Line], names: Sequence[str], assembler: Assembler) -> None:
        self.source = lines
        self.names = names
        self._assembler = assembler
        self._entries: list[Entry] = assembler.define()
        self._results: list[Result] = [] if assembler.full else assembler.assemble()
        self.words = punch.words(self._results)

    @property
    def ok(self) -> bool:
        """Whether DEC's assembler would have had nothing to say."""
        return not self._messages

    @cached_property
    def tape(self) -> bytes:
        """The object tape as the high-speed punch made it; empty if the symbol table was full."""
        return b"" if self._assembler.full else punch.tape(self._results)

    @cached_property
    def diagnostics(self) -> list["Diagnostic"]:
        """What is wrong, and what to know besides."""
        from pal.diagnostics import diagnose

        return diagnose(self.source, self.names, self._messages)

    @cached_property
    def symbols(self) -> dict[str, int]:
        """The user's symbols as pass 3 leaves them."""
        table = sorted(self._third[1], key=lambda entry: internal_order(entry.name))
        return {entry.name: entry.value for entry in table}

    @property
    def symbol_table(self) -> str:
        """The symbol table as pass 3 typed it: name, value, one a line."""
        return "".join(f"{name:6}  {value:04o}\n" for name, value in self.symbols.items())

    @cached_property
    def listing(self) -> str:
        """What pass 3 typed, `\\n` for CR LF."""
        return self.printed(3)

    @cached_property
    def lines(self) -> list["ListingLine"]:
        """The listing by statements."""
        from pal.listing import listing_line

        return [listing_line(self.source[result.line], result) for result in self._third[0]]

    def printed(self, number: int) -> str:
        """Return what pass 1, 2 or 3 typed, without the codes that do not print."""
        from pal.listing import printed

        return printed(self._typed(number))

    @cached_property
    def teletype(self) -> "Teletype":
        """The tapes of the three passes when the ASR-33 does it all."""
        from pal import listing

        return listing.Teletype(
            listing.tape(self._typed(1), finished=not self._assembler.full),
            listing.object_tape(self._results) if self.tape else b"",
            listing.tape(self._typed(3)) if self.tape else b"",
        )

    def _typed(self, number: int) -> str:
        from pal import listing

        if number == 1 and self._assembler.full:
            return listing.complaints(self._assembler.messages)
        if number == 1:
            return listing.definitions(self._assembler.messages, self._entries)
        if not self.tape:
            return ""
        if number == 2:
            return listing.complaints(self._referred)
        return listing.listing(self.source, *self._third[:2])

    @cached_property
    def values(self) -> dict[str, int]:
        """{name: value} of all symbols as pass 3 leaves them, the permanent ones included."""
        return self._third[2]

    @cached_property
    def _third(self) -> tuple[list[Result], list[Entry], dict[str, int]]:
        results = self._assembler.assemble() if self.tape else []
        return results, self._assembler.table(), self._assembler.values()

    def _repr_html_(self) -> str:
        """Return the listing as HTML, for a notebook."""
        from pal.notebook import html

        return html(self)

    @property
    def _referred(self) -> list[Message]:
        return [result.message for result in self._results if result.message]

    @cached_property
    def _messages(self) -> list[Message]:
        undefined = [
            Message("UA", f"{entry.name:6}", entry.value, entry.place)
            for entry in self._entries
            if not entry.defined
        ]
        return self._assembler.messages + undefined + self._referred


def assemble(
    *sources: str | bytes,
    names: Sequence[str] | None = None,
    modern: bool = False,
    capacity: int = TELETYPE_SYMBOLS,
) -> Assembly:
    """Assemble the source tapes, read one after the other.

    sources   frames, with channel 8 or without, or texts; in a text a character beyond ASCII is illegal
    names     what the diagnostics call each tape
    modern    fold lower case
    capacity  room for symbols of the user's: TELETYPE_SYMBOLS, or HIGH_SPEED_SYMBOLS

    Whatever is wrong with the source is a diagnostic; nothing is raised.
    """
    tapes = [source.encode("ascii", "replace") if isinstance(source, str) else source for source in sources]
    lines = list(scanner.lines(tapes, modern))
    called = names or [f"tape {number}" for number in range(1, len(tapes) + 1)]
    return Assembly(lines, called, Assembler(lines, capacity))
