"""Where a run is to stop: before the instructions of lines, of addresses, after words are read or written.

A breakpoint at a line without a word goes to the next that has one. One at an address is a function
breakpoint to the editor: its name is an octal address or a symbol. One with a condition, a count of hits or a
log message is looked at when the run comes to it; a log message is said, and the run continues. A step back
ends where the run stopped or would have stopped: a hit that was counted keeps its number.

What the editor asked for is kept. When a program is loaded again, its breakpoints are placed again and keep
their numbers.
"""

import operator
import re
from bisect import bisect_left
from collections.abc import Callable, Iterator, Sequence
from itertools import count

from pal.isa import EXECUTE, JMS
from pdp8.computer.machine import Machine
from pdp8.computer.watch import Watch
from pdp8.dap import expressions
from pdp8.dap.places import Places, place, reference
from pdp8.dap.wire import Body
from pdp8.monitor.prompt import Monitor
from tapes.errors import WorkError

LINES, ADDRESSES = "breakpoint", "function breakpoint"
INSTRUCTIONS, DATA = "instruction breakpoint", "data breakpoint"
"""Kinds of breakpoints, by the reason that the protocol has for a stop at one."""
_COMPARED = {"==": operator.eq, ">": operator.gt, ">=": operator.ge, "<": operator.lt, "<=": operator.le}
_HITS = re.compile(r"\s*(==|>=|<=|>|<|%)?\s*([0-9]+)\s*")


class Point:
    """A breakpoint as the editor asked for it by `key`, a line, name or reference; `address` is None, with
    `why`, if it has no place.
    """

    def __init__(self, number: int, kind: str, key: object, asked: Body) -> None:
        self.number, self.kind, self.key, self.asked = number, kind, key, asked
        self.address: int | None = None
        self.line: int | None = None
        self.why = ""
        self.text: list[str] = []
        """The lines of its source when it was asked for."""
        self._hits: list[int] = []
        """The instructions at which it was hit, if they are counted."""
        self._condition: expressions.Value | None = None
        self._log: Callable[[], str] = str

    def place(self, monitor: Monitor, places: Places) -> None:
        """Find the place of the breakpoint in the program that is loaded."""
        self.address, self.why, self._condition = None, "", None
        self.line = self.asked["line"] if self.kind == LINES else None
        self._hits.clear()
        try:
            if self.asked.get("condition"):
                self._condition = expressions.read(self.asked["condition"], monitor)
            if (hits := self.asked.get("hitCondition")) and not _HITS.fullmatch(hits):
                raise WorkError(f"{hits}: a decimal number of hits expected, alone or behind == > >= < <= %")
            self._log = expressions.message(self.asked.get("logMessage") or "", monitor)
            self._find(monitor, places)
        except WorkError as error:
            self.why = str(error)

    def follow(self, places: Places) -> None:
        """Move with its line after an edit, as the editor does without saying so."""
        if self.kind == LINES and self.text:
            self.key = places.went(self.asked["source"], self.asked["line"], self.text)
            self.asked = {**self.asked, "line": self.key}
            self.text = places.text(self.asked["source"])

    def _find(self, monitor: Monitor, places: Places) -> None:
        if self.kind == LINES:
            if not places.is_of(self.asked["source"]):
                raise WorkError(f"the program that runs is {places.name}")
            found = places.first_from(self.asked["source"], self.asked["line"])
            if found is None:
                raise WorkError("no word from this line on")
            self.address, self.line = found
        elif self.kind == INSTRUCTIONS:
            at = place(self.asked["instructionReference"], self.asked.get("offset") or 0)
            if not 0 <= at < monitor.machine.memory:
                raise WorkError(f"{at:o}: no address of core")
            self.address = at
        else:
            if self.kind == DATA and not (self.reads or self.writes):
                raise WorkError(f"{self._access}: a word is watched for read, write or readWrite")
            self.address = monitor.address(self.asked["name" if self.kind == ADDRESSES else "dataId"])

    @property
    def _access(self) -> str:
        return str(self.asked.get("accessType") or "write")

    @property
    def writes(self) -> bool:
        """Whether it stops after a word was written."""
        return self.kind == DATA and self._access in ("write", "readWrite")

    @property
    def reads(self) -> bool:
        """Whether it stops after a word was read."""
        return self.kind == DATA and self._access in ("read", "readWrite")

    def described(self, places: Places) -> Body:
        """Return the protocol's Breakpoint."""
        body: Body = {"id": self.number, "verified": self.address is not None}
        if self.line is not None:
            body |= {"line": self.line, "source": places.source_of(self.asked["source"])}
        if self.address is None:
            return body | {"message": self.why}
        return body | {"instructionReference": reference(self.address)}

    def stops(self, now: int, say: list[str]) -> bool:
        """Whether a run stops that reaches it after `now` instructions; a log message never stops it."""
        if self.asked.get("hitCondition") and (self._condition is None or self._condition()):
            self._hits[bisect_left(self._hits, now) :] = [now]
        if not self._met(now):
            return False
        if self.asked.get("logMessage"):
            say.append(self._log())
            return False
        return True

    def stopped(self, now: int) -> bool:
        """Whether a run that reached it at `now` stopped there, or would have."""
        return not self.asked.get("logMessage") and self._met(now)

    def _met(self, now: int) -> bool:
        if hits := self.asked.get("hitCondition"):
            number = bisect_left(self._hits, now)
            return self._hits[number : number + 1] == [now] and _reached(hits, number + 1)
        return self._condition is None or bool(self._condition())


def reached(machine: Machine) -> set[int]:
    """Return the addresses at which a breakpoint stops a run here: the PC, and after a JMS its target."""
    p = machine.processor
    return {machine.pc, machine.ma} if p.state == EXECUTE and p.ir == JMS else {machine.pc}


def _reached(wanted: str, hits: int) -> bool:
    found = _HITS.fullmatch(wanted)
    assert found is not None, "it was placed"
    sign, number = found[1] or "==", int(found[2])
    if sign == "%":
        return number > 0 and hits % number == 0
    return bool(_COMPARED[sign](hits, number))


class Breakpoints:
    """The numbered breakpoints of one debugger."""

    def __init__(self) -> None:
        self._numbers = count(1)
        self._set: dict[tuple[str, str], list[Point]] = {}
        """By kind, and by source for those of lines."""

    def __iter__(self) -> Iterator[Point]:
        return (point for points in self._set.values() for point in points)

    def put(
        self,
        monitor: Monitor,
        places: Places,
        kind: str,
        source: str,
        asked: Sequence[tuple[object, Body]],
    ) -> list[Body]:
        """Replace the breakpoints of one type and source by those `asked`; return them with their numbers."""
        before = {point.key: point.number for point in self._set.get((kind, source), ())}
        points: dict[object, Point] = {}
        for key, words in asked:
            if key not in points:
                points[key] = Point(before.get(key) or next(self._numbers), kind, key, words)
                points[key].place(monitor, places)
                points[key].text = places.text(words["source"]) if kind == LINES else []
        self._set[kind, source] = list(points.values())
        return [points[key].described(places) for key, _ in asked]

    def place_anew(self, monitor: Monitor, places: Places, reloaded: bool = True) -> list[Body]:
        """Place all in another machine, where the program may be reloaded; return those that moved."""
        moved = []
        for point in self:
            was = point.described(places)
            if reloaded:
                point.follow(places)
            point.place(monitor, places)
            if point.described(places) != was:
                moved.append(point.described(places))
        return moved

    def put_into(self, watch: Watch) -> None:
        """Let a watch stop only at these breakpoints."""
        placed = [(point, point.address) for point in self if point.address is not None]
        watch.breakpoints = {address for point, address in placed if point.kind != DATA}
        watch.writes = {address for point, address in placed if point.writes}
        watch.reads = {address for point, address in placed if point.reads}

    def stopped(self, machine: Machine) -> list[Point]:
        """Return those at which a run that ended in the machine's state has stopped, or would have."""
        return [point for point in self.hit(machine) if point.stopped(machine.instructions)]

    def hit(self, machine: Machine) -> list[Point]:
        """Return the breakpoints at a machine's next address, whatever their conditions."""
        places, watch = reached(machine), machine.watch
        return [
            point
            for point in self
            if (point.kind != DATA and point.address in places)
            or (point.writes and point.address in watch.written)
            or (point.reads and point.address in watch.read)
        ]
