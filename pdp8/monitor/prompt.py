"""A machine at a prompt: a line is a command and its arguments.

Numbers are octal. An address may be a symbol of the program that was loaded, with + or - a number: CHK,
CHK+3-1. A range is A:B; 200-203 is one too, as in SIMH: only from a symbol does - subtract. A command's name
may be shortened as long as it stays one of them, as DEC's were: e for examine, se for set.
"""

import re
from collections.abc import Callable

from pdp8 import fitting
from pdp8.computer.count import Count
from pdp8.computer.hardware.processor import Processor
from pdp8.computer.machine import Machine
from pdp8.computer.past import state
from pdp8.computer.past.history import History
from pdp8.computer.stop import Reason, Stop
from pdp8.computer.use import ending
from pdp8.computer.use.operator import Operator, Pace
from pdp8.computer.use.program import FOUND
from pdp8.computer.use.trace import Listing
from pdp8.computer.watch import Observer
from pdp8.monitor.arguments import MonitorError, octal
from pdp8.reels import Reels
from tapes.quantities import ranges

_ENDED = {Reason.TAPE_OUT: "waits for a tape"}
_RANGE = re.compile(r"\d+-\d+")
HANDS = 0.1
"""Seconds the operator takes to press a key."""


class Observers:
    """Observers of the same runs: traces and counts."""

    def __init__(self, each: list[Observer]) -> None:
        self.each = each

    def cycle(self, processor: Processor, interrupt: bool) -> None:
        for observer in self.each:
            observer.cycle(processor, interrupt)

    def waited(self, processor: Processor, instructions: int, ticks: int) -> None:
        for observer in self.each:
            observer.waited(processor, instructions, ticks)


class Monitor:
    """A machine at a prompt; `say` takes each line of the answers."""

    def __init__(
        self, say: Callable[[str], object], machine: Machine | None = None, listing: Listing | None = None
    ) -> None:
        self.say = say
        self.listing = listing or Listing()
        self.dialect = FOUND
        """The dialect of PAL source that is loaded."""
        self.finished = False
        self.stopping = False
        """Set to end a run as the STOP key does."""
        self.live: Callable[[float], Stop] | None = None
        """Runs for so many seconds with a terminal as the Teletype, if there is one."""
        self.realtime = False
        """Whether `live` runs at the pace of 1971."""
        self.echo: Callable[[str], object] = lambda line: None
        """Takes each line of a script that is read within another."""
        self.depth = 0
        """How many scripts are being read, each within another."""
        self.goto = ""
        """The label to which the script jumps after this line, if any."""
        self.punching: dict[str, str] = {}
        """The names of files that were attached for what is punched."""
        self.once_running: list[Callable[[], object]] = []
        """What is done once the machine runs."""
        self._waiting: list[tuple[int, list[str]]] = [(0, [])]
        """The tapes that wait, and since which tick."""
        self.reels = Reels()
        """The DECtapes on the drives, with the files they came from."""
        self.attend(machine or Machine())

    def attend(self, machine: Machine) -> None:
        """Use `machine` from now on."""
        self.machine = machine
        self.reels.look_at(machine.devices)
        recorded = machine.recorder
        self.history = recorded if isinstance(recorded, History) else History(machine)
        """What can be undone: all since then, or since the run that is left to the monitor began."""
        self.operator = Operator(machine, Pace(pressing=HANDS))
        self.expected = self.matched = 0
        """How many frames of the page `expect` passes over: those printed before the last command that ran a
        machine; and those up to the end of its last match.
        """
        self.shown = 0
        """How many frames of it `page` has shown."""

    @property
    def waiting_tapes(self) -> list[str]:
        """The names of the tapes that go into the reader as it runs out."""
        return self._waiting[-1][1]

    @waiting_tapes.setter
    def waiting_tapes(self, names: list[str]) -> None:
        self._waiting.append((self.machine.processor.clock, names))

    def went_back(self) -> None:
        """Follow the machine, of which something was undone: tapes that went in since then wait again."""
        frames = len(self.machine.teletype.printer.frames)
        self.expected, self.matched = min(self.expected, frames), min(self.matched, frames)
        self.shown = min(self.shown, frames)
        self.reels.discs.went_back(self.machine.processor.clock)
        while self._waiting[-1][0] > self.machine.processor.clock:
            self._waiting.pop()
        for each in self.observers():
            if isinstance(each, Count):
                each.went_back = True

    def observers(self) -> list[Observer]:
        """Return what observes the machine's runs."""
        observer = self.machine.watch.observer
        return observer.each if isinstance(observer, Observers) else [observer] if observer else []

    def turn_to(self, text: str) -> None:
        """Use the machine of state `text`. Devices, reels and discs that it does not know of stay, as do
        breakpoints within its core, pace and page.
        """
        watch, pace, page = self.machine.watch, self.operator.pace, self.machine.teletype.printer.on_frame
        fitted = [type(device)() for device in self.machine.devices]
        with self.reels.staying(fitted):
            self.attend(state.restore(text, fitted, self.reels.images(), fitting.known(), fitting.MOUNT))
        self.machine.watch, self.operator.pace = watch, pace
        self.machine.teletype.printer.on_frame = page
        memory = self.machine.memory
        beyond = {at for at in watch.breakpoints | watch.writes | watch.reads if at >= memory}
        if beyond:
            self.say(f"not watched any more, beyond {memory - 1:o}: {ranges(beyond)}")
        for points in (watch.breakpoints, watch.writes, watch.reads):
            points.difference_update(beyond)

    def say_where(self, why: str) -> None:
        """Say where the machine is now, `why`, and at what time."""
        m = self.machine
        self.say(f"{why}; {m.elapsed:,.6f} s; next {self.listing.line(m.pc, m.core[m.pc], m.processor)}")

    def say_stop(self, stop: Stop) -> None:
        """Say how a run ended, and why where something is wrong."""
        stop = self.explained(stop)
        waits = any(why.what == ending.KEY for why in stop.why)
        self.say_where("waits for a key" if waits else _ENDED.get(stop.reason, stop.reason))
        for sentence in self.sentences(stop):
            self.say(sentence)

    def explained(self, stop: Stop) -> Stop:
        """Return a stop with its reasons, where something may be wrong."""
        return ending.explained(stop, self.history, self.listing.words)

    def sentences(self, stop: Stop) -> list[str]:
        """Return what is wrong, in sentences."""
        return ending.sentences(stop, self.listing, self.machine.core)

    def address(self, text: str) -> int:
        """Return the address of `text`: octal numbers and symbols, added and subtracted."""
        name, *offsets = re.split("(?=[+-])", text)
        if name.isdecimal() and "-" in text:
            raise MonitorError(f"{text}: a range, where one address was expected")
        address = self._named(name or text)
        for offset in offsets:
            if offset[1:].upper()[:6] in self.listing.symbols:
                raise MonitorError(f"{text}: a range? write A:B; octal numbers follow + and -")
            address += octal(offset[1:] or text) * (1 if offset[0] == "+" else -1)
        if not 0 <= address < self.machine.memory:
            raise MonitorError(f"{text}: not between 0000 and {self.machine.memory - 1:o}")
        return address

    def word(self, text: str, most: int = 0o7777) -> int:
        """Return the number of `text`, up to `most`; as a word, a symbol's address is without its field."""
        number = self.address(text)
        named = most == 0o7777 and not text[0].isdecimal()
        return octal(f"{number & most if named else number:o}", most)

    def _named(self, name: str) -> int:
        symbol = self.listing.symbols.get(name.upper()[:6])
        if symbol is not None:
            return symbol
        if not name.isdecimal():
            advice = "" if self.listing.symbols else "; a tape brings none, `listing SOURCE` does"
            raise MonitorError(f"{name}: neither an octal number nor a symbol{advice}")
        return octal(name, self.machine.memory - 1)

    def range(self, text: str) -> range:
        """Return the addresses of A, A:B, A-B for numbers, or A/N for N words."""
        begin_at, counts, words = text.partition("/")
        if counts:
            begin = self.address(begin_at)
            end = begin + octal(words or text, self.machine.memory)
            if end == begin:
                raise MonitorError(f"{text}: no words")
            if end > self.machine.memory:
                raise MonitorError(f"{text}: goes beyond {self.machine.memory - 1:o}")
            return range(begin, end)
        first, found, last = text.partition("-" if _RANGE.fullmatch(text) else ":")
        begin = self.address(first)
        end = self.address(last) if found else begin
        if end < begin:
            raise MonitorError(f"{text}: {end:04o} lies before {begin:04o}")
        return range(begin, end + 1)
