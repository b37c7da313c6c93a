"""One situation on the machine and on the reference; and the first difference in the terms of the machine."""

from array import array
from collections.abc import Iterator
from typing import Any, NamedTuple

from tests.pdp8.computer.lockstep.sides import MachineSide, ReferenceSide
from tests.pdp8.computer.lockstep.situations import Situation

ENDLESS = ("idle", "tape out")
AS_REFERENCE_SAYS = {"halt": "stopped", "stop key": "stopped", "protect": "stopped"}
DECIMAL = ("clock", "instructions", "read", "fast read", "keys")


class Played(NamedTuple):
    """How many instructions both have run, and the first difference, if there was one."""

    instructions: int
    difference: str


def play(situation: Situation, form: str) -> Played:
    """Do all of `situation` on both; stop at the first difference."""
    machine = MachineSide(form, situation.fast, situation.words)
    reference = ReferenceSide(situation.fast, situation.words)
    for number, act in enumerate(situation.acts):
        if act.name == "run":
            difference = _run(machine, reference, *act.values)
        else:
            for side in (machine, reference):
                getattr(side, act.name)(*act.values)
            difference = ""
        difference = difference or _difference(machine.seen(), reference.seen())
        if difference:
            return Played(reference.reference.instructions, f"act {number}, {act.name}: {difference}")
    return Played(reference.reference.instructions, "")


def _run(machine: MachineSide, reference: ReferenceSide, ticks: int | None, instructions: int) -> str:
    """Run one piece on both; return how they differ in why it ended."""
    reason = machine.run(ticks, instructions)
    if reason in ENDLESS:
        endless = reference.run_endless(machine.machine.instructions)
        return "" if endless else f"the machine says {reason!r}, but the program goes on"
    expected = reference.run(ticks, instructions)
    if AS_REFERENCE_SAYS.get(reason, reason) != expected:
        return f"the machine ended with {reason!r}, the reference with {expected!r}"
    return ""


def _difference(ours: dict[str, Any], expected: dict[str, Any]) -> str:
    return ", ".join(_differences(ours, expected)) if ours != expected else ""


def _differences(ours: dict[str, Any], expected: dict[str, Any]) -> Iterator[str]:
    for name, value in expected.items():
        if ours[name] == value:
            continue
        if name == "core":
            yield from _words(ours[name], value)
        elif isinstance(value, bytes):
            yield f"{name} {ours[name].hex(' ') or 'nothing'}, not {value.hex(' ') or 'nothing'}"
        elif name in DECIMAL:
            yield f"{name} {ours[name]}, not {value}"
        else:
            yield f"{name} {ours[name]:o}, not {value:o}"


def _words(ours: bytes, expected: bytes) -> Iterator[str]:
    for address, (our, other) in enumerate(zip(array("H", ours), array("H", expected), strict=True)):
        if our != other:
            yield f"{address:04o} holds {our:04o}, not {other:04o}"


def listing(situation: Situation) -> str:
    """Return the situation for a reader: the words, runs of the same one shortened, then what is done."""
    lines = ["with the PC8/L"] if situation.fast else []
    words = situation.words
    before: tuple[int, int] | None = None
    for address, word in sorted(words.items()):
        if before != (address - 1, word):
            lines.append(f"    {address:04o}  {word:04o}")
        elif not lines[-1].endswith("..."):
            lines[-1] += "  ..."
        before = address, word
    for act in situation.acts:
        lines.append(f"  {act.name} {', '.join(_value(value) for value in act.values)}".rstrip())
    return "\n".join(lines)


def _value(value: Any) -> str:
    if isinstance(value, frozenset):
        return "{" + " ".join(f"{address:04o}" for address in sorted(value)) + "}"
    if isinstance(value, bytes):
        return " ".join(f"{frame:03o}" for frame in value) or "nothing"
    return repr(value)
