"""A trace that follows the listing: what was executed, with the lamps and the time.

        time       L AC    MA   MB    listing
       81.80   us  0 0000  0204 1102  0204  1102          TAD M60

An instruction a line, or a memory cycle a line with its major state. The time is when it began, in
microseconds since START; the lamps are as it left them. Loops that only wait take one line.
"""

from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING

from pal.disassembler import microinstruction
from pal.isa import DEFER, EXECUTE, FETCH, INDIRECT, IOT, JMP, OPERATIONS, STATES, refers_to
from pal.symbols import SIGNIFICANT
from pdp8.computer.hardware.extension import FIELD
from pdp8.computer.hardware.processor import Processor
from pdp8.computer.hardware.signals import CYCLE, IO_TICKS
from pdp8.computer.watch import memory_address

if TYPE_CHECKING:
    from pal import Assembly

_FIELD_IOTS = {
    **{0o6214: "RDF", 0o6224: "RIF", 0o6234: "RIB", 0o6244: "RMF"},
    **{0o6201 | field << 3: f"CDF {field}0" for field in range(8)},
    **{0o6202 | field << 3: f"CIF {field}0" for field in range(8)},
    **{0o6203 | field << 3: f"CIF CDF {field}0" for field in range(8)},
}
"""The memory extension's, for which PAL III has no names."""
_DTLA = 0o6766
"""In PAL III's table this is an IOT of the DECtape 552."""


class Listing:
    """What is known of the words in core: an assembly's lines and symbols, or nothing.

    `lines` are as pass 3 typed them, TABs counted from where the source begins; `words` is {address: word},
    `places` {address: number of its line}, `numbers` {address: number of its line in the source, from 1},
    `tapes` {address: its source tape, from 0}, `symbols` {name: value, or a tag's address with its field}.
    """

    def __init__(self, symbols: Mapping[str, int] | None = None) -> None:
        self.lines: list[str] = []
        self.words: dict[int, int] = {}
        self.places: dict[int, int] = {}
        self.numbers: dict[int, int] = {}
        self.tapes: dict[int, int] = {}
        self.symbols = dict(symbols or {})

    @staticmethod
    def of(assembly: "Assembly") -> "Listing":
        """Return the listing of an assembly."""
        listing = Listing(assembly.symbols)
        tags: list[str] = []
        here: list[int] = []
        for line in assembly.lines:
            source = line.source.expandtabs(8)
            tags += _tags(source)
            if line.address is not None:
                here.append(line.address)
            if source and here:
                listing._place(tags, here)
                tags, here = [], []
            if line.address is None or line.word is None:
                listing.lines.append(f"{'':12}{source}".rstrip())
            else:
                listing.words[line.address] = line.word
                listing.places[line.address] = len(listing.lines)
                listing.numbers[line.address] = line.number
                listing.tapes[line.address] = line.tape
                listing.lines.append(f"{line.address:04o}  {line.word:04o}  {source}".rstrip())
        return listing

    def _place(self, tags: Sequence[str], addresses: Sequence[int]) -> None:
        """Let `tags`, whose values have twelve bits, be those of `addresses` that they are the tags of."""
        for tag in tags:
            for address in addresses:
                if self.symbols.get(tag) == address & 0o7777:
                    self.symbols[tag] = address

    def fits(self, address: int, word: int) -> bool:
        """Tell whether the listing has `word` at `address`."""
        return self.words.get(address) == word

    def line(self, address: int, word: int, processor: Processor | None = None) -> str:
        """Return the line of `word` at `address`: as assembled, or disassembled if it is another word now."""
        if self.fits(address, word):
            return self.lines[self.places[address]]
        return f"{address:04o}  {word:04o}  {' ' * 8}{instruction(address, word, processor)}"


def without_comment(source: str) -> str:
    """Return a line of the source up to its comment; `"/` is a character."""
    return source[: (source.replace('"/', '""') + "/").find("/")]


def _tags(source: str) -> list[str]:
    """Return what a line of the source may define with commas."""
    before = without_comment(source).upper().replace(";", " ").split(",")[:-1]
    return [part.split()[-1][:SIGNIFICANT] for part in before if part.strip()]


def instruction(location: int, word: int, processor: Processor | None = None) -> str:
    """Return what `word` at `location` does, as PAL III writes it; an IOT as what is fitted to a processor
    has it.
    """
    code = word >> 9
    if processor is not None and code == IOT:
        if processor.extension.size > FIELD and word in _FIELD_IOTS:
            return _FIELD_IOTS[word]
        if word == _DTLA and any(device.NAME == "dectape" for device in processor.bus):
            return "DTLA"
    if code > JMP:
        return microinstruction(word) or f"{word:04o}"
    return f"{OPERATIONS[code]} {'I ' if word & INDIRECT else ''}{refers_to(word, location & 0o7777):04o}"


class Trace:
    """Writes a line for each instruction, or for each memory `cycles`, through `write`."""

    def __init__(self, write: Callable[[str], object], listing: Listing, cycles: bool) -> None:
        self._write = write
        self._listing = listing
        self._cycles = cycles
        self._began = 0
        self._what = ""

    def cycle(self, processor: Processor, interrupt: bool) -> None:
        """Take in the cycle that has ended; write its line, or the instruction's when that has ended."""
        p = processor
        if p.state == FETCH:
            self._what = self._listing.line(memory_address(p), p.mb, p)
        elif interrupt:
            self._what = "            JMS 0: an interrupt"
        if self._cycles or p.state == FETCH or interrupt:
            self._began = p.clock - p.started - CYCLE
            if p.state == FETCH and p.ir == IOT:
                self._began -= IO_TICKS
        if self._cycles:
            self._write(f"{_time(self._began)}  {STATES[p.state]:7}  {_lamps(p)}  {self._what}")
        elif p.next not in (DEFER, EXECUTE):
            self._write(f"{_time(self._began)}  {_lamps(p)}  {self._what}")

    def waited(self, processor: Processor, instructions: int, ticks: int) -> None:
        """Write what was passed over."""
        self._write(
            f"{' ' * 16}  ... the same again: {instructions:,} instructions, {ticks / 20_000:,.3f} ms"
        )


def _time(ticks: int) -> str:
    """Return `ticks` in microseconds, in a column."""
    return f"{ticks / 20:14,.2f} us"


def _lamps(processor: Processor) -> str:
    """Return L, AC, MA and MB as the lamps show them."""
    p = processor
    return f"{p.lac >> 12} {p.lac & 0o7777:04o}  {memory_address(p):04o} {p.mb:04o}"
