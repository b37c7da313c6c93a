"""Steps and calls, against what is seen when every instruction is watched."""

import copy

import pytest

import pal
import programs  # noqa: F401 - its files go on the shelf
from pdp8.computer.hardware.processor import Processor
from pdp8.computer.machine import Machine
from pdp8.computer.past.history import History
from pdp8.dap import calls, motion
from tapes import shelf

INTERRUPTED = """
*0
	0
	JMP SERVE
SAVE,	0
*20
SERVE,	DCA SAVE
	TCF
	TAD SAVE
	ION
	JMP I 0
*200
	ION
	TLS
	CLA CLL IAC
	NOP
	JMP .-1
$
"""
NESTED = """
*200
	JMS OUTER
	7
	HLT
	JMP 200
OUTER,	0
	CLA
	TAD I OUTER
	ISZ OUTER
	JMS I PINNER
	JMP .-1
	JMP I OUTER
PINNER,	INNER
*400
INNER,	0
	ISZ TIMES
	JMP I INNER
	ISZ INNER
	CLA CMA CLL RAL
	DCA TIMES
	JMP I INNER
TIMES,	-2
$
"""


BEFORE_MAIN = """
*200
	JMP MAIN
SUB,	0
	CLA
	JMP I SUB
MAIN,	JMS SUB
	NOP
	JMP MAIN
$
"""
POINTED = """
*10
POINT,	277
*200
	TAD I POINT
	JMS STORE
	JMP 200
STORE,	0
	DCA HELD
	ISZ HELD
	JMP I STORE
HELD,	0
$
"""


def machine_with(source: str) -> Machine:
    machine = Machine()
    machine.load(pal.assemble(source).words)
    machine.start(0o200)
    return machine


class Stack:
    """The calls under way as they are made: what each JMS pushes, a jump to the return pops."""

    def __init__(self) -> None:
        self.entries: list[int] = []

    def follow(self, processor: Processor, core: list[int]) -> None:
        """Take in the instruction that has ended."""
        p = processor
        if p.state == 2 and p.ir == 4:
            self.entries.append(p.ma)
        elif p.ir == 5 and self.entries and p.pc == core[self.entries[-1]]:
            self.entries.pop()


@pytest.mark.parametrize("source", [NESTED, BEFORE_MAIN, shelf.read("eia.pal").decode()])
def test_the_callers_are_those_that_called(source: str) -> None:
    machine = machine_with(source)
    machine.teletype.reader.load(bytes(0o200 | code for code in b"N10 X3\r\n"))
    stack = Stack()
    depths = set()
    for _ in range(1200):
        if machine.run(instructions=1).reason not in ("limit", "halt"):
            break
        core = list(machine.core)
        stack.follow(machine.processor, core)
        found = [frame.entry for frame in calls.frames(core, machine.pc, 0)]
        assert found == [*reversed(stack.entries), None], f"at {machine.pc:04o}"
        depths.add(len(found))
    assert len(depths) > 1


def test_an_interrupt_is_stepped_into_and_over() -> None:
    machine = machine_with(INTERRUPTED)
    machine.run(seconds=0.05)
    while machine.processor.next != 3:
        motion.into(machine)
    interrupted = machine.pc
    again = copy.copy(machine)
    motion.into(machine)
    assert (machine.pc, machine.core[0]) == (1, interrupted)
    motion.into(machine)
    assert [frame.entry for frame in calls.frames(list(machine.core), machine.pc, machine.ion)] == [0, None]
    machine = again
    _, goal = motion.over(machine)
    assert goal is not None
    assert (goal.entry, goal.interrupt) == (0, True)
    machine.watch.breakpoints = goal.places(machine)
    machine.run()
    assert goal.reached(machine)
    assert machine.pc == interrupted


def test_back_goes_through_the_stops_of_the_way_out() -> None:
    machine = machine_with(POINTED)
    history = History(machine)
    breakpoints, writes = {0o201, 0o202, 0o203}, {0o10, 0o207}
    forwards = set()
    for number in range(100):
        here, before = machine.pc, [machine.core[address] for address in sorted(writes)]
        if here in (0o201, 0o202):
            forwards.add(number)
        machine.run(instructions=1)
        if here == 0o201:  # JMS 203
            forwards.add(number + 1)
        if [machine.core[address] for address in sorted(writes)] != before:
            forwards.add(number)
    backwards = []
    while motion.back_to(history, breakpoints, writes):
        backwards.append(machine.instructions)
    assert backwards == sorted(forwards, reverse=True)
