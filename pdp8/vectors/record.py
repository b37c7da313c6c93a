"""Instructions of the processor, written down: registers and core before and after, and each memory cycle.

    {"name", "models", "instructions", "initial", "final", "ticks", "cycles": [["FETCH", MA, MB], ...]}

Of core "ram" has every word that a cycle touches. "models" are those on which the words do the same.
"""

from functools import cache
from typing import Any

from pal.isa import DEFER, EXECUTE, FETCH, INDIRECT, IOT, STATES, autoindexed, refers_to
from pal.models import MODELS, rules
from pdp8.computer.hardware.signals import INTERRUPT
from pdp8.computer.machine import Machine
from pdp8.vectors.states import State

Vector = dict[str, Any]
Cycle = tuple[str, int, int]


class Recorder:
    """A machine whose instructions are written down."""

    def __init__(self) -> None:
        self.machine = Machine(highspeed=True)
        self.touched: set[int] = set()
        """The words of core that are not 0."""

    def vector(
        self, name: str, state: State, word: int, flags: tuple[int, ...] = (), mem_prot: int = 0
    ) -> Vector:
        """Return what `word` at the PC of `state` does."""
        return self.run(name, state, _core(state, word), 1, flags, mem_prot)

    def run(
        self,
        name: str,
        state: State,
        core: dict[int, int],
        instructions: int,
        flags: tuple[int, ...],
        mem_prot: int = 0,
    ) -> Vector:
        """Return what so many instructions do, fewer if the machine stops, and the interrupt that follows."""
        self._prepare(state, core, flags)
        p = self.machine.processor
        p.mem_prot = mem_prot
        clock, first = p.clock, p.instructions
        cycles = self._instruction()
        while p.run and (p.instructions < first + instructions or p.next == INTERRUPT):
            cycles += self._instruction()
        touched = sorted({ma for _, ma, _ in cycles})
        self.touched.update(core, touched)
        switch = {"mem_prot": 1} if mem_prot else {}
        initial = {
            **{"pc": state.pc, "ac": state.ac, "link": state.link, "sr": state.sr, "ion": state.ion},
            **switch,
            "ram": [[address, core.get(address, 0)] for address in touched],
        }
        if flags:
            initial["flags"] = list(flags)
        lamp = {"mem_prot": 1, "protect": p.protect} if mem_prot else {}
        words = tuple(mb for state, _, mb in cycles if state == STATES[FETCH])
        return {
            "name": name,
            "models": ["8/L"] if mem_prot else models(words),
            "instructions": p.instructions - first,
            "initial": initial,
            "final": self._final(touched) | lamp,
            "ticks": p.clock - clock,
            "cycles": cycles,
        }

    def _prepare(self, state: State, core: dict[int, int], flags: tuple[int, ...]) -> None:
        machine = self.machine
        p = machine.processor
        machine.power_up()
        for device in machine.bus:
            device.flag = int(device.code in flags)
        machine.pc, machine.ac, machine.link, machine.sr = state.pc, state.ac, state.link, state.sr
        machine.ion = state.ion
        p.protect, p.run = 0, 1
        for address in self.touched:
            p.core[address] = 0
        self.touched.clear()
        for address, word in core.items():
            p.core[address] = word

    def _instruction(self) -> list[Cycle]:
        """Run one instruction, or the cycle of an interrupt."""
        p = self.machine.processor
        cycles: list[Cycle] = []
        while not cycles or p.next in (DEFER, EXECUTE):
            p.cycle()
            cycles.append((STATES[p.state], p.ma, p.mb))
        return cycles

    def _final(self, touched: list[int]) -> dict[str, Any]:
        machine = self.machine
        p = machine.processor
        return {
            **{"pc": machine.pc, "ac": machine.ac, "link": machine.link, "sr": machine.sr},
            **{"ion": machine.ion, "run": p.run},
            "ram": [[address, p.core[address]] for address in touched],
        }


@cache
def models(words: tuple[int, ...]) -> list[str]:
    """Return the models on which all words do as on an 8/L."""
    does = [rule.does for word in words for rule in rules(word)]
    return [model for model in MODELS if all(rule.get(model) == rule["8/L"] for rule in does)]


def _core(state: State, word: int) -> dict[int, int]:
    """Return the words that the instruction `word` at the PC of `state` will touch."""
    core = {}
    if word >> 9 < IOT:
        address = refers_to(word, state.pc)
        core[address] = state.operand
        if word & INDIRECT:
            core[state.target] = state.operand
            core[address] = state.target - autoindexed(address) & 0o7777
    core[state.pc] = word
    return core
