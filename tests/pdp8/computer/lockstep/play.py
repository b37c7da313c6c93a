"""One situation on the machine in its forms and on the reference; the first difference in its terms."""

from array import array
from collections.abc import Iterator, Sequence
from typing import Any, NamedTuple

from tests.pdp8.computer.lockstep.sides import ReferenceSide, Seen, Side, sides
from tests.pdp8.computer.lockstep.situations import Act, Situation

LONGEST_WATCHED = 2_000
"""Instructions of a piece that is watched: the machine is slow then."""
ENDLESS = ("idle", "tape out")
AS_REFERENCE_SAYS = {"halt": "stopped", "stop key": "stopped", "protect": "stopped"}
DECIMAL = ("clock", "instructions", "position", "counted", "cycles", "ticks", "interrupts")


class Played(NamedTuple):
    """How many instructions all have run, and the first difference, if there was one."""

    instructions: int
    difference: str


def play(situation: Situation, forms: Sequence[str]) -> Played:
    """Do all of `situation` in each of `forms` and on the reference; stop at the first difference."""
    played, reference = sides(forms, situation), ReferenceSide(situation)
    for number, act in enumerate(_done(situation.acts, reference)):
        for form, difference in _after(act, played, reference):
            if difference:
                where = f"act {number}, {act.name}: {form}"
                return Played(reference.reference.instructions, f"{where}: {difference}")
    return Played(reference.reference.instructions, "")


def _done(acts: Sequence[Act], reference: ReferenceSide) -> Iterator[Act]:
    """Yield what is done as `acts` say: a piece that is watched is short; `back` leads to where one of the
    last runs began, if that is recorded; what is restored is recorded again.
    """
    watched = recorded = False
    stood: list[int] = []
    for name, values in acts:
        now = reference.reference.instructions
        given = values
        if name == "watch":
            watched = any(values)
        elif name == "run" and watched:
            given = values[0], min(values[1], LONGEST_WATCHED)
        elif name == "back":
            before = [number for number in stood if number < now]
            stood = before[: -values[0]]
            if not (recorded and before):
                continue
            given = (now - before[-values[0] :][0],)
        yield Act(name, given)
        if name in ("run", "single_cycle", "run_cycles"):
            stood.append(now)
        elif name == "record" or (name == "save_and_restore" and recorded):
            stood, recorded = [], True
            if name != "record":
                yield Act("record")


def _after(act: Act, sides: dict[str, Side], reference: ReferenceSide) -> Iterator[tuple[str, str]]:
    """Do `act` on all; yield for each form how it differs, in why a run ended and in what is seen."""
    reasons = {form: each.do(act) for form, each in sides.items()}
    seen = {form: each.seen() for form, each in sides.items()}
    if act.name == "run":
        first, *_ = sides
        reason = str(reasons[first])
        for form, other in reasons.items():
            yield form, "" if other == reason else f"ended with {other!r}, {first} with {reason!r}"
        yield first, _run(reason, seen[first]["instructions"], act, reference)
    else:
        reference.do(act)
    expected = reference.seen()
    for form, ours in seen.items():
        yield form, ", ".join(_differences(ours, expected)) if ours != expected else ""


def _run(reason: str, instructions: int, act: Act, reference: ReferenceSide) -> str:
    """Run a piece on the reference; return how it differs in why it ended."""
    if reason in ENDLESS:
        return "" if reference.run_endless(instructions) else f"says {reason!r}, but the program goes on"
    expected = reference.do(act)
    if AS_REFERENCE_SAYS.get(reason, reason) != expected:
        return f"ended with {reason!r}, the reference with {expected!r}"
    return ""


def _differences(ours: Seen, expected: Seen) -> Iterator[str]:
    """Yield what differs of all that can be seen of a form: the pages have no counts by address."""
    for name, own in ours.items():
        value = expected[name]
        if own == value:
            continue
        if isinstance(value, dict):
            addresses = [address for address in {**own, **value} if own.get(address) != value.get(address)]
            yield f"{name} at {addresses[0]:04o} {own.get(addresses[0])}, not {value.get(addresses[0])}"
        elif name == "processor.core":
            yield from _words(own, value)
        elif isinstance(value, bytes):
            yield f"{name} {own.hex(' ') or 'nothing'}, not {value.hex(' ') or 'nothing'}"
        elif name.rpartition(".")[2] in DECIMAL:
            yield f"{name} {own}, not {value}"
        else:
            yield f"{name} {own:o}, not {value:o}"


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
    return str(value)
