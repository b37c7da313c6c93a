"""Steps and calls, against what is seen when every instruction is watched."""

import copy
import random
from collections.abc import Callable
from itertools import product
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest

from pal.isa import JMP
from pdp8 import shelf
from pdp8.computer.hardware.signals import INTERRUPT
from pdp8.computer.machine import Machine
from pdp8.dap import calls, motion, scopes
from pdp8.dap.breakpoints import ADDRESSES, DATA, Breakpoints
from pdp8.dap.debuggee import Debuggee, Halt
from pdp8.dap.launch import Launch
from pdp8.dap.scopes import stack_trace
from pdp8.monitor.prompt import Monitor

FOLDER = Path(__file__).parent
in_both_fields = pytest.mark.parametrize("field", [0, 0o10000], ids=["field 0", "field 1"])


def began(source: str, folder: Path, field: int = 0, **more: object) -> Debuggee:
    """Return what is debugged, stopped at 0200 as a debugger begins; `more` of its configuration."""
    if field:
        source, more = f"FIELD 1\n{source}", {"memory": "8k", "start": "10200", **more}
    (folder / "x.pal").write_text(source)
    return Debuggee(Launch.of({"program": str(folder / "x.pal"), **more}), Breakpoints())


def machine_with(name: str, field: int = 0) -> Machine:
    machine = Machine(memory=2 * field or 0o10000)
    words = shelf.program(str(FOLDER / name) if (FOLDER / name).exists() else name).words
    machine.load({field | address: word for address, word in words.items()})
    machine.panel.data_field = field >> 12
    machine.start(field | 0o200)
    return machine


@in_both_fields
@pytest.mark.parametrize("name", ["nested.pal", "before_main.pal", "eia.pal"])
def test_the_callers_are_those_that_called(name: str, field: int) -> None:
    """What each JMS pushes as it is done, a jump to the return pops."""
    machine = machine_with(name, field)
    machine.teletype.reader.load(bytes(0o200 | code for code in b"N10 X3\r\n"))
    entries: list[int] = []
    depths = set()
    for _ in range(1200):
        if machine.run(instructions=1).reason not in ("limit", "halt"):
            break
        p, core = machine.processor, list(machine.core)
        if p.state == 2 and p.ir == 4:
            entries.append(machine.ma)
        elif p.ir == 5 and entries and p.pc == core[entries[-1]]:
            entries.pop()
        found = [frame.entry for frame in calls.frames(core, machine.pc, 0)]
        assert found == [*reversed(entries), None], f"at {machine.pc:04o}"
        depths.add(len(found))
    assert len(depths) > 1


def test_the_callers_are_shown_in_parts() -> None:
    machine = machine_with("nested.pal")
    while len(calls.frames(list(machine.core), machine.pc, 0)) < 3:
        machine.run(instructions=1)
    debuggee: Any = SimpleNamespace(monitor=Monitor(lambda line: None, machine), knows_source=False)
    whole = stack_trace(debuggee, {})["stackFrames"]
    for levels in (1, 2):
        parts = [
            stack_trace(debuggee, {"startFrame": at, "levels": levels})["stackFrames"] for at in range(3)
        ]
        assert parts == [whole[at : at + levels] for at in range(3)]


def test_an_interrupt_is_stepped_into_and_over() -> None:
    machine = machine_with("interrupted.pal")
    machine.run(seconds=0.05)
    while machine.processor.next != 3:
        motion.into(machine)
    interrupted = machine.pc
    again = copy.copy(machine)
    motion.into(machine)
    assert (machine.pc, machine.core[0]) == (1, interrupted)
    motion.into(machine)
    assert [frame.entry for frame in calls.frames(list(machine.core), machine.pc, machine.ion)] == [0, None]
    _, caller, *_ = calls.frames(2 * list(machine.core), machine.pc, machine.ion, 0o10000)
    assert caller.address == 0o10000 | interrupted
    machine = again
    _, goal = motion.over(machine)
    assert goal is not None
    assert (goal.entry, goal.interrupt) == (0, True)
    machine.watch.breakpoints = goal.places(machine)
    machine.run()
    assert goal.reached(machine)
    assert machine.pc == interrupted


@pytest.mark.parametrize("seed", range(6))
def test_back_goes_through_the_stops_of_the_way_out(seed: int, tmp_path: Path) -> None:
    """Breakpoints of all kinds, drawn, some on a condition; of a word it stops before what used it."""
    draw = random.Random(seed)
    debuggee = began((FOLDER / "pointed.pal").read_text(), tmp_path)
    machine, points = debuggee.monitor.machine, debuggee.breakpoints
    code, data = range(0o200, 0o207), (0o10, 0o203, 0o207)
    for kind, key, places in ((ADDRESSES, "name", code), (DATA, "dataId", data)):
        asked: list[tuple[object, dict[str, str]]] = []
        for place in draw.sample(places, 3):
            point = {key: f"{place:o}", "accessType": draw.choice(["read", "write", "readWrite"])}
            point["condition"] = draw.choice(["", "", "core[207] & 1", "!(core[207] & 1)", "AC > 0"])
            point |= draw.choice([{}, {}, {}, {"hitCondition": "% 3"}, {"logMessage": "{AC}"}])
            asked.append((place, point))
        points.put(debuggee.monitor, debuggee.places, kind, "", asked)
    points.put_into(machine.watch)
    forwards = set()
    for number, used in product(range(60), (False, True)):
        if used:
            machine.run(instructions=1)
        those = [point for point in points.hit(machine) if (point.kind == DATA) == used]
        forwards |= {number for point in those if point.stops(machine.instructions, [])}
    backwards = []
    while debuggee.back_to(lambda part: None).reason != "entry":
        backwards.append(machine.instructions)
    assert backwards == sorted(forwards, reverse=True)


def test_a_jump_through_a_word_that_is_no_entry_is_no_return() -> None:
    machine = Machine()
    machine.load(
        {0o200: 0o4210, 0o201: 0o7402, 0o210: 0, 0o211: 0o5615, 0o212: 0o7000, 0o213: 0o5610, 0o215: 0o212}
    )
    machine.start(0o200)
    seen = []
    for _ in range(3):
        machine.run(instructions=1)
        seen.append([frame.entry for frame in calls.frames(list(machine.core), machine.pc, 0)])
    assert seen == [[0o210, None]] * 3


@in_both_fields
def test_a_call_into_another_field_returns_from_there(field: int, tmp_path: Path) -> None:
    """As CIF, JMS call it and CIF, JMP I leave it."""
    other = 1 - (field >> 12)
    words = f"*200\n62{other}2\nJMS 300\nHLT\nFIELD {other}\n*300\n0\nCLA\n62{1 - other}2\nJMP I 300\n$\n"
    debuggee = began(words, tmp_path, field, memory="8k")
    machine = debuggee.monitor.machine
    debuggee.into()
    again = copy.copy(machine)
    halt = debuggee.over()
    while halt is None:
        halt = debuggee.advance()
    assert (halt, machine.pc) == (Halt("step"), field | 0o202)
    motion.into(again)
    called = other << 12 | 0o300
    for _ in range(3):
        assert calls.of(again) == [(again.pc, called), (field | 0o201, None)]
        assert motion.out(again).places(again) == {field | 0o202}
        motion.into(again)


@pytest.mark.parametrize("step", [Debuggee.into, Debuggee.over])
@pytest.mark.parametrize(
    ("words", "protected", "halt"),
    [
        ("CLA", 0, Halt("step")),
        ("HLT", 0, Halt("halt", "HLT at 0200")),
        ("A,JMS A", 0, Halt("step")),
        ("DCA I P;P,7600", 0, Halt("step")),
        ("DCA I P;P,7600", 1, Halt("exception", "MEM PROT stopped a write at 0200 into 7600")),
        ("ISZ I P;P,7777", 1, Halt("exception", "MEM PROT stopped a write at 0200 into 7777")),
        ("ISZ .;P,7777", 1, Halt("step")),
        ("DCA I P;P,7577", 1, Halt("step")),
        ("JMS I P;P,7600", 1, Halt("exception", "MEM PROT stopped a write into 7600")),
        ("JMP I P;P,7600", 1, Halt("step")),
    ],
)
def test_a_step_says_how_its_instruction_ended(
    words: str, protected: int, halt: Halt, step: Callable[[Debuggee], Halt], tmp_path: Path
) -> None:
    debuggee = began("\n".join(["*200", *words.split(";"), "$\n"]), tmp_path)
    debuggee.monitor.machine.panel.mem_prot = bool(protected)
    assert step(debuggee) == halt


def test_an_interrupted_instruction_is_stepped_over_with_its_interrupt(tmp_path: Path) -> None:
    """Its handler runs to the return, past the breakpoint that a log message is at, and then it is done."""
    debuggee = began((FOLDER / "interrupted.pal").read_text(), tmp_path)
    machine = debuggee.monitor.machine
    machine.run(seconds=0.05)
    while machine.processor.next != INTERRUPT:
        motion.into(machine)
    interrupted, word = machine.pc, machine.core[machine.pc]
    halt = debuggee.over()
    while halt is None:
        halt = debuggee.advance()
    assert halt == Halt("step")
    assert (machine.processor.next, machine.ma) == (0, interrupted)
    assert word >> 9 == JMP
    assert machine.pc == word & 0o177 | interrupted & 0o7600


@in_both_fields
def test_a_step_over_a_call_passes_a_log_message(field: int, tmp_path: Path) -> None:
    debuggee = began("*200\nJMS SUB\nHLT\nSUB,0\nCLA\nJMP I SUB\n$\n", tmp_path, field)
    asked = {"name": "SUB+2", "condition": "core[SUB+1] == 7200", "logMessage": "from {core[SUB]}"}
    debuggee.breakpoints.put(debuggee.monitor, debuggee.places, ADDRESSES, "", [("SUB+2", asked)])
    halt = debuggee.over()
    while halt is None:
        halt = debuggee.advance()
    ended = halt, debuggee.monitor.machine.pc, debuggee.notes()
    assert ended == (Halt("step"), field | 0o201, "from 0201\n")


@pytest.mark.parametrize(
    ("words", "places"),
    [
        ({0o202: 0o201, 0o203: 0o7200}, {0o201}),
        ({0o202: 0o201, 0o203: 0o2202}, {0o201}),  # it counts, and is right behind its argument
        ({0o212: 0o201, 0o213: 0o2212}, {*range(0o201, 0o211)}),
    ],
)
@in_both_fields
def test_the_places_that_a_subroutine_returns_to(words: dict[int, int], places: set[int], field: int) -> None:
    machine = Machine(memory=0o20000)
    machine.load({field | address: word for address, word in words.items()})
    goal = motion.Goal(field | min(words), field)
    assert goal.places(machine) == {field | place for place in places}


@in_both_fields
@pytest.mark.parametrize(
    ("undebugged", "kind", "at"),
    [(True, "step", 0o201), (False, ADDRESSES, 0o201), (True, "step", 0o202), (False, DATA, 0o202)],
)
def test_a_step_over_ends_at_a_breakpoint_unless_there_is_no_debugging(
    undebugged: bool, kind: str, at: int, field: int, tmp_path: Path
) -> None:
    """At 0201, to which the call returns, or as 0202 is written, which holds that."""
    debuggee = began("*200\nJMS A\nHLT\nA,0\nJMP I A\n$\n", tmp_path, field, noDebug=undebugged)
    name = f"{field | at:o}"
    points, asked = (ADDRESSES, "name") if at == 0o201 else (DATA, "dataId")
    debuggee.breakpoints.put(debuggee.monitor, debuggee.places, points, "", [(name, {asked: name})])
    halt = debuggee.over()
    while halt is None:
        halt = debuggee.advance()
    assert (halt.reason, debuggee.monitor.machine.pc) == (kind, field | (0o203 if kind == DATA else 0o201))


def test_what_the_console_lets_a_run_stop_at_stays_until_it_is_forgotten(tmp_path: Path) -> None:
    """Beside the editor's breakpoints, which it names too; a step over ends there."""
    debuggee = began("*200\nL,JMS S\nISZ N\nJMP L\nS,0\nJMP I S\nN,0\n$\n", tmp_path)
    monitor = debuggee.monitor

    def stops(*steps: str) -> list[str]:
        found = []
        for step in steps:
            debuggee.run()
            halt = debuggee.over() if step == "over" else None
            while halt is None:
                halt = debuggee.advance()
            debuggee.pause()
            found.append(f"{halt.reason} {monitor.machine.pc:o}")
        return found

    def console(line: str) -> str:
        return str(scopes.evaluate(debuggee, {"expression": line, "context": "repl"})["result"])

    debuggee.breakpoints.put(monitor, debuggee.places, ADDRESSES, "", [("L", {"name": "L"})])
    console("watch N")
    console("break S")
    ran = stops("over", "run", "run", "run", "over")
    assert ran == [
        *("breakpoint 204", "breakpoint 202", "function breakpoint 200", "breakpoint 204", "step 201")
    ]
    assert (console("break"), console("watch")) == ("0200 0203", "0205")
    back = [(debuggee.back_to(lambda _: None).reason, f"{monitor.machine.pc:o}") for _ in range(4)]
    assert back == [("breakpoint", "204"), (ADDRESSES, "200"), (DATA, "201"), ("breakpoint", "204")]
    stops("run", "run", "run", "over")
    console("forget")
    assert stops("over", "run") == ["step 202", "function breakpoint 200"]
    assert console("break") == "0200"
    debuggee.breakpoints.put(monitor, debuggee.places, ADDRESSES, "", [("S", {"name": "S"})])
    assert stops("over") == ["function breakpoint 204"]
    debuggee.breakpoints.put(monitor, debuggee.places, ADDRESSES, "", [])
    monitor.machine.start(0o200)
    assert debuggee.over() is None
    debuggee.pause()  # the step's goal, 0201, is given up
    console("break 202")
    console("cont")
    assert monitor.machine.pc == 0o202


def test_a_machine_that_is_stopped_says_at_what(tmp_path: Path) -> None:
    debuggee = began("*200\nCLA\nHLT\n$\n", tmp_path)
    machine = debuggee.monitor.machine
    assert debuggee.stands() == Halt("pause")
    (point,) = debuggee.breakpoints.put(
        debuggee.monitor, debuggee.places, ADDRESSES, "", [("0201", {"name": "0201"})]
    )
    assert debuggee.into() == Halt("step")
    assert debuggee.stands() == Halt(ADDRESSES, "", (point["id"],))
    assert debuggee.into() == Halt("halt", "HLT at 0201")
    assert debuggee.stands() == Halt("halt", "the machine is stopped; next is 0202")
    machine.panel.sing_step = True
    assert debuggee.stands() == Halt("pause")


def test_commands_of_a_launch_find_the_switches_set_and_may_set_them(tmp_path: Path) -> None:
    source = tmp_path / "own.pal"
    source.write_text("*200\n\tHLT\n$\n")
    for commands, sr in (([], 0o1234), (["deposit SR 4321"], 0o4321)):
        given = {"program": str(source), "sr": "1234", "commands": commands}
        monitor, _ = Launch.of(given).ready(lambda line: None)
        assert monitor.machine.sr == sr


def test_a_tape_that_went_in_waits_again_after_a_step_back(tmp_path: Path) -> None:
    names = [str(tmp_path / name) for name in ("a", "b")]
    for name in names:
        Path(name).write_bytes(b"\x80")
    debuggee = began("*200\n\tKSF\n\tJMP .-1\n\tKRB\n\tJMP 200\n$\n", tmp_path, reader=names)
    monitor = debuggee.monitor
    debuggee.run()
    while debuggee.advance() is None:
        pass
    assert (monitor.waiting_tapes, debuggee.notes().count("goes into")) == ([], 1)
    debuggee.back_to(lambda _: None)
    assert monitor.waiting_tapes == names[1:]
    debuggee.into()
    monitor.waiting_tapes = ["c"]
    debuggee.into()
    for left in (["c"], names[1:]):
        debuggee.back()
        assert monitor.waiting_tapes == left
