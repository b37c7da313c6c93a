"""An answer run on one case, on a machine of its own, for a bounded time.

Core that the answer does not load is full of 5200, a jump to the first word of its page: no program may
count on what it finds there, and one that runs into it does not end.
"""

from collections.abc import Sequence
from typing import NamedTuple

from pdp8.computer.hardware.teletype import printed
from pdp8.computer.machine import Machine
from pdp8.computer.stop import Stop
from pdp8.lessons.answer import Answer
from pdp8.lessons.exercise import Case

_JUNK = 0o5200


class Outcome(NamedTuple):
    """What the machine was like when it stopped; of tape, page and count what the last START brought."""

    stop: Stop
    ac: int
    link: int
    before: Sequence[int]
    core: Sequence[int]
    tape: bytes
    page: str
    instructions: int


def needs(case: Case) -> list[str]:
    """Return the symbols by which the case calls places of an answer, each once."""
    pointers = (word for word in case.deposit.values() if isinstance(word, str))
    places = (case.start, *case.deposit, *pointers, *case.core, *case.changed)
    return list(dict.fromkeys(place for place in places if not place[0].isdigit()))


def run(answer: Answer, case: Case) -> Outcome:
    """Run `answer`, which has the symbols the case needs, as the case says."""
    machine = Machine()
    machine.load(dict.fromkeys(range(0o10000), _JUNK))
    machine.load(answer.words)
    for place, word in case.deposit.items():
        machine.core[_at(answer, place)] = word if isinstance(word, int) else _at(answer, word)
    before = list(machine.core)
    machine.sr = case.sr
    punched, printer = machine.teletype.punch.frames, machine.teletype.printer.frames
    for _ in range(case.starts):
        machine.teletype.reader.load(case.reader)
        punched.clear()
        printer.clear()
        instructions = machine.instructions
        machine.start(_at(answer, case.start))
        machine.teletype.keyboard.press(case.keys)
        stop = machine.run(seconds=case.seconds)
    page = printed(bytes(printer)).decode().replace("\r\n", "\n")
    instructions = machine.instructions - instructions
    core = list(machine.core)
    return Outcome(stop, machine.ac, machine.link, before, core, bytes(punched), page, instructions)


def _at(answer: Answer, place: str) -> int:
    address = answer.address(place)
    assert address is not None, f"the answer has no {place}"
    return address
