"""Instructions of the processor, written down: registers and core before and after, and each memory cycle.

README.md says what a vector has.
"""

from array import array
from functools import cache
from typing import Any

from pal.isa import FETCH, INDIRECT, IOT, STATES, autoindexed, refers_to
from pal.models import MODELS, rules
from pdp8.computer.hardware.highspeed import HighSpeed
from pdp8.computer.hardware.teletype import Teletype
from pdp8.computer.machine import Machine
from pdp8.vectors.states import State

Vector = dict[str, Any]
_REGISTERS = ("pc", "ac", "link", "sr", "ion")
_EMPTY = array("H", bytes(2 * 0o10000))


class Recorder:
    """A machine that records its instructions as vectors."""

    def __init__(self) -> None:
        self.machine = Machine([Teletype(), HighSpeed()])

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
        """Return the vectors of so many instructions, up to a stop, and of the interrupt that follows."""
        machine, p = self.machine, self.machine.processor
        machine.power_up()
        for device in machine.bus:
            device.flag = int(device.code in flags)
        for register in _REGISTERS:
            setattr(machine, register, getattr(state, register))
        p.mem_prot, p.run = mem_prot, 1
        p.core[:] = _EMPTY
        for address, word in core.items():
            p.core[address] = word
        clock, first = p.clock, p.instructions
        cycles: list[tuple[str, int, int]] = []
        while p.run and (p.next != FETCH or p.instructions < first + instructions):
            p.cycle()
            cycles.append((STATES[p.state], p.ma, p.mb))
        touched = sorted({ma for _, ma, _ in cycles})
        initial: dict[str, Any] = {register: getattr(state, register) for register in _REGISTERS}
        final: dict[str, Any] = {register: getattr(machine, register) for register in _REGISTERS}
        initial |= {"mem_prot": 1} if mem_prot else {}
        initial["ram"] = [[address, core.get(address, 0)] for address in touched]
        initial |= {"flags": list(flags)} if flags else {}
        final |= {"run": p.run, "ram": [[address, p.core[address]] for address in touched]}
        final |= {"mem_prot": 1, "protect": p.protect} if mem_prot else {}
        return {
            "name": name,
            "models": ["8/L"]
            if mem_prot
            else models(tuple(mb for at, _, mb in cycles if at == STATES[FETCH])),
            "instructions": p.instructions - first,
            "initial": initial,
            "final": final,
            "ticks": p.clock - clock,
            "cycles": cycles,
        }


@cache
def models(words: tuple[int, ...]) -> list[str]:
    """Return the models on which all words do the same as on an 8/L."""
    does = [rule.does for word in words for rule in rules(word)]
    return [model for model in MODELS if all(rule.get(model) == rule["8/L"] for rule in does)]


def _core(state: State, word: int) -> dict[int, int]:
    """Return the words of core that instruction `word` will use."""
    core = {}
    if word >> 9 < IOT:
        address = refers_to(word, state.pc)
        core[address] = state.operand
        if word & INDIRECT:
            core[state.target] = state.operand
            core[address] = state.target - autoindexed(address) & 0o7777
    core[state.pc] = word
    return core
