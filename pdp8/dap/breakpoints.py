"""Where a run is to stop: before the instructions of lines, of addresses, after words are written."""

from collections.abc import Iterable
from itertools import count

from pal.isa import EXECUTE, JMS, autoindexed
from pdp8.computer.machine import Machine
from pdp8.computer.watch import wrote

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
