"""Where a run is to stop: before the instructions of lines, of addresses, after words are written.

A breakpoint at a line without a word goes to the next that has one. One at an address is a function
breakpoint to the editor: its name is an octal address or a symbol.
"""

from collections.abc import Callable, Iterable
from itertools import count
from typing import TYPE_CHECKING

from pal.isa import EXECUTE, JMS, autoindexed
from pdp8.computer.machine import Machine
from pdp8.computer.watch import wrote
from pdp8.dap.places import place, reference
from pdp8.dap.wire import Body
from tapes.errors import WorkError

if TYPE_CHECKING:
    from pdp8.dap.debuggee import Debuggee

LINES, ADDRESSES = "breakpoint", "function breakpoint"
INSTRUCTIONS, DATA = "instruction breakpoint", "data breakpoint"
"""Kinds of breakpoints, by the reason that the protocol has for a stop at one."""


class Breakpoints:
    """Those of one debugger, kind by kind, each with a number."""

    def __init__(self) -> None:
        self._numbers = count(1)
        self._set: dict[str, dict[int, int]] = {}
        self.lines: list[int] = []
        """The lines for which the editor asked, which may have moved when the program is loaded again."""

    def put(self, kind: str, addresses: Iterable[int]) -> dict[int, int]:
        """Put breakpoints at `addresses` in place of all others of the kind; return the number of each."""
        self._set[kind] = {address: next(self._numbers) for address in addresses}
        return self._set[kind]

    @property
    def code(self) -> set[int]:
        """The addresses of the instructions before which a run stops."""
        return {address for kind, points in self._set.items() if kind != DATA for address in points}

    @property
    def data(self) -> set[int]:
        """The addresses of the words after whose writing a run stops."""
        return set(self._set.get(DATA, ()))

    def hit(self, machine: Machine) -> tuple[str, list[int]]:
        """Return at what kind of breakpoint a machine stands, and their numbers; "" if at none."""
        p = machine.processor
        places = {p.pc, p.ma} if p.state == EXECUTE and p.ir == JMS else {p.pc}
        written = set[int]()
        if machine.watch.reached:
            written = {p.ma} & self.data if wrote(p) else set(filter(autoindexed, self.data))
        found = [
            (kind, number)
            for kind, points in self._set.items()
            for address, number in points.items()
            if address in (written if kind == DATA else places)
        ]
        return (found[0][0], [number for _, number in found]) if found else ("", [])


def set_lines(room: "Debuggee", arguments: Body) -> Body:
    """Set the breakpoints of a source, in place of those before."""
    asked = [point["line"] for point in arguments.get("breakpoints") or ()]
    if not room.places.is_of(arguments["source"]):
        why = f"the program that runs is {room.places.source['name']}"
        return {"breakpoints": [{"verified": False, "line": line, "message": why} for line in asked]}
    room.breakpoints.lines = asked
    return place_lines(room)


def place_lines(room: "Debuggee") -> Body:
    """Set the breakpoints of the source's lines, and say where each is."""
    found = [(line, room.places.first_from(line)) for line in room.breakpoints.lines]
    numbers = room.breakpoints.put(LINES, [place[0] for _, place in found if place])
    return {
        "breakpoints": [
            {**_verified(numbers, place[0]), "line": place[1], "source": room.places.source}
            if place
            else {"verified": False, "line": line, "message": "no word from this line on"}
            for line, place in found
        ]
    }


def set_functions(room: "Debuggee", arguments: Body) -> Body:
    return _set(room, ADDRESSES, arguments, lambda point: room.monitor.address(point["name"]))


def set_instructions(room: "Debuggee", arguments: Body) -> Body:
    def find(point: Body) -> int:
        return place(point["instructionReference"], point.get("offset") or 0)

    return _set(room, INSTRUCTIONS, arguments, find)


def set_data(room: "Debuggee", arguments: Body) -> Body:
    return _set(room, DATA, arguments, lambda point: room.monitor.address(point["dataId"]))


def _set(room: "Debuggee", kind: str, arguments: Body, find: Callable[[Body], int]) -> Body:
    found: list[int | WorkError] = []
    for point in arguments["breakpoints"]:
        try:
            found.append(find(point))
        except WorkError as error:
            found.append(error)
    numbers = room.breakpoints.put(kind, [place for place in found if isinstance(place, int)])
    return {
        "breakpoints": [
            _verified(numbers, place)
            if isinstance(place, int)
            else {"verified": False, "message": str(place)}
            for place in found
        ]
    }


def _verified(numbers: dict[int, int], address: int) -> Body:
    return {"id": numbers[address], "verified": True, "instructionReference": reference(address)}
