"""What a Count counted, for people and machines, by the listing of the program that ran."""

from collections.abc import Iterator

from pdp8.computer.count import Count
from pdp8.computer.hardware.signals import TICKS_PER_SECOND
from pdp8.computer.use.trace import Listing
from tapes.quantities import counted, duration, ranges

_COLUMN = 12


def table(count: Count, listing: Listing) -> Iterator[str]:
    """Yield the lines of a table for people."""
    done, cycles = counted(count.instructions, "instructions"), counted(count.cycles, "cycles")
    yield f"{done}, {cycles}, {_time(count.ticks)}" + ", with what was undone" * count.went_back
    share = 100 * count.waiting / count.ticks if count.ticks else 0
    yield f"waiting {share:.2f} %, {_time(count.waiting)}"
    if count.interrupts:
        yield f"interrupts {count.interrupts:,}"
    for name, times in count.operations.most_common():
        yield f"    {name:12} {times:15,} {100 * times / count.instructions:7.2f} %"
    yield f"never executed: {ranges(never_executed(count, listing))}"
    yield f"written: {ranges(count.written)}"


def never_executed(count: Count, listing: Listing) -> list[int]:
    """Return the listing's addresses that were never executed, including data."""
    return sorted(listing.words.keys() - count.executed.keys())


def annotated(count: Count, listing: Listing) -> list[str]:
    """Return the listing with, in its margin, how often each word was executed, or written (w)."""
    at = {place: address for address, place in listing.places.items()}
    return [
        f"{_margin(count, at.get(place)):>{_COLUMN}}  {line}".rstrip()
        for place, line in enumerate(listing.lines)
    ]


def _margin(count: Count, address: int | None) -> str:
    if address is None:
        return ""
    if count.executed[address]:
        return f"{count.executed[address]:,}"
    return f"{count.written[address]:,} w" if count.written[address] else "-"


def _time(ticks: int) -> str:
    return duration(ticks / TICKS_PER_SECOND)
