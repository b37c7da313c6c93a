"""What a machine has done is undone exactly: over tapes, waits, interrupts, and whatever was set between."""

import json
from itertools import pairwise
from typing import Any

import pytest

import pal
from pdp8.computer.machine import Machine
from pdp8.computer.past import rewind, state
from pdp8.computer.past.history import History, HistoryError
from tapes import ascii, shelf
from tests.pdp8.computer.bench import octal, program

PROGRAMS = {
    name: dict(pal.assemble(shelf.read(name)).words) for name in ("eia.pal", "echo.pal", "counter.pal")
}
TAPE = ascii.encode("  76 2250 4133  185\n 123\n")


def saved(machine: Machine) -> dict[str, Any]:
    """Return the saved state; `writes` is a stamp, of which it matters only whether waiting has the same."""
    saved: dict[str, Any] = json.loads(state.save(machine))
    saved["unwritten"] = saved["processor"].pop("writes") == saved["waiting"].pop("writes")
    return saved


@pytest.fixture
def translated() -> tuple[Machine, History]:
    """A machine in the middle of a line of eia.pal, recorded from START on, run in slices."""
    machine = Machine()
    machine.load(PROGRAMS["eia.pal"])
    machine.teletype.reader.load(TAPE)
    machine.start(0o200)
    history = History(machine)
    for _ in range(24):
        machine.run(seconds=0.1)
    return machine, history


def test_a_character_back_and_a_block(translated: tuple[Machine, History]) -> None:
    machine, history = translated
    punched = machine.teletype.punch.tape
    rewind.characters(history, 3)
    assert machine.teletype.punch.tape == punched[:-3]
    machine.run(instructions=1)
    assert machine.teletype.punch.tape == punched[:-2]
    machine.run()
    assert machine.teletype.punch.tape.count(0o200) == 2
    rewind.blocks(history, 2)
    assert machine.teletype.punch.tape == punched[: punched.index(0o200)]


def test_one_is_undone_where_no_number_is_named(translated: tuple[Machine, History]) -> None:
    machine, history = translated
    machine.run()
    clock, instructions = machine.processor.clock, machine.instructions
    rewind.cycles(history)
    assert clock - machine.processor.clock in (32, 85)
    rewind.instructions(history)
    assert machine.instructions in (instructions - 1, instructions - 2)
    printed = len(machine.teletype.printer.frames)
    rewind.characters(history)
    assert len(machine.teletype.printer.frames) == printed - 1
    punched = machine.teletype.punch.tape.count(0o200)
    rewind.blocks(history)
    assert machine.teletype.punch.tape.count(0o200) == punched - 1


def test_cycles_back_stand_within_an_instruction(translated: tuple[Machine, History]) -> None:
    machine, history = translated
    was = saved(machine)
    stood = []
    for _ in range(12):
        stood.append((machine.processor.clock, machine.pc, machine.processor.next, machine.ac))
        machine.processor.cycle()
    rewind.cycles(history, 5)
    assert (machine.processor.clock, machine.pc, machine.processor.next, machine.ac) == stood[7]
    within, done = saved(machine), machine.instructions
    machine.run(instructions=3)
    rewind.instructions(history, machine.instructions - done)
    assert saved(machine) == within
    rewind.cycles(history, 7)
    assert saved(machine)["processor"] == was["processor"]


def test_seconds_back_end_with_an_instruction(translated: tuple[Machine, History]) -> None:
    machine, history = translated
    clock = machine.processor.clock
    rewind.seconds(history, 1.25)
    assert 0 <= machine.processor.clock - (clock - 25_000_000) < 200
    with pytest.raises(HistoryError, match=r"9 seconds cannot be undone: the history goes back 1\.1"):
        rewind.seconds(history, 9)


def test_what_was_set_as_an_instruction_ended_is_set_there_again() -> None:
    machine = program(*octal("7000 " * 30))
    history = History(machine)
    for sr in (0o17, 0o4000):
        machine.run(instructions=10)
        machine.sr = sr
    rewind.seconds(history, (10 * 32 + 5) / 20_000_000)
    assert (machine.ticks, machine.sr) == (10 * 32, 0o17)


def test_back_to_the_last_time_that_something_happened(translated: tuple[Machine, History]) -> None:
    machine, history = translated
    rewind.until_left(history, 0o205)  # DCA HOLD, of the last character
    assert (machine.pc, machine.processor.next) == (0o205, 0)
    held = machine.ac
    machine.run(instructions=1)
    assert machine.core[0o100] == held
    rewind.until_written(history, 0o100)
    assert (machine.pc, machine.ac) == (0o205, held)
    rewind.until_flag(history, 0o03)
    assert machine.teletype.receiver.flag
    rewind.instructions(history, 1)
    assert not machine.teletype.receiver.flag
    was = saved(machine)
    with pytest.raises(HistoryError, match="nothing was written at 7000 as far as the history goes back"):
        rewind.until_written(history, 0o7000)
    assert saved(machine) == was


def test_breakpoints_and_listeners_notice_nothing(translated: tuple[Machine, History]) -> None:
    machine, history = translated
    machine.watch.breakpoints.add(0o205)
    heard: list[int] = []
    machine.teletype.punch.on_frame = heard.append
    rewind.instructions(history, 5000)
    assert heard == []
    assert (machine.watch.breakpoints, machine.run().pc) == ({0o205}, 0o205)


def test_the_memory_is_bounded_and_the_oldest_past_forgotten() -> None:
    machine = Machine()
    machine.load(PROGRAMS["counter.pal"])
    machine.start(0o200)
    history = History(machine, memory=200_000)
    for _ in range(400):
        machine.run(seconds=1)
    assert 100_000 < history.size <= 200_000
    assert 10 < history.seconds < 110
    was = saved(machine)
    rewind.seconds(history, history.seconds)
    with pytest.raises(HistoryError, match="1 instructions cannot be undone: the history goes back 0"):
        rewind.instructions(history)
    assert saved(machine) != was


def test_many_snapshots_are_thinned_out() -> None:
    machine = Machine()
    machine.load(PROGRAMS["counter.pal"])
    machine.start(0o200)
    history = History(machine)
    machine.run(instructions=1000)
    was = saved(machine)

    def apart() -> list[float]:
        return [(late.clock - soon.clock) / 20_000_000 for late, soon in pairwise(history.snapshots())]

    while len(history.snapshots()) < 128:
        machine.run(seconds=0.5)
    assert 5 <= min(apart()) <= max(apart()) < 5.6
    while len(history.snapshots()) == 128:
        machine.run(seconds=0.5)
    assert len(history.snapshots()) == 65
    assert 10 <= min(apart()) <= max(apart()) < 11.2
    for undo in (rewind.instructions, rewind.characters, rewind.cycles, rewind.seconds, rewind.blocks):
        now = saved(machine)
        undo(history, 0)
        with pytest.raises(
            HistoryError, match=f"9,999,999,999 {undo.__name__} cannot be undone: the history goes back [0-9]"
        ):
            undo(history, 9_999_999_999)
        assert saved(machine) == now
    rewind.instructions(history, machine.instructions - 1000)
    assert saved(machine) == was


def test_what_a_breakpoint_has_finished_is_there_again() -> None:
    """TLS, IAC: the frame on its way is out when the run has ended, though no time has passed for it."""
    machine = program(*octal("6046 7001 5201"))
    machine.watch.breakpoints.add(0o202)
    history = History(machine)
    machine.run()
    machine.watch.breakpoints.clear()
    was = saved(machine)
    assert machine.teletype.punch.tape == b"\0"
    machine.run(instructions=4)
    rewind.instructions(history, 4)
    assert saved(machine) == was


def test_nothing_that_is_searched_for_stops_the_way_there() -> None:
    """TLS, IAC, JMP .-1: a stop at 0202 would print the frame that is on its way."""
    machine = program(*octal("6046 7001 5201"))
    history = History(machine)
    machine.run(instructions=4)
    was = saved(machine)
    machine.run(instructions=1)
    rewind.until_left(history, 0o202)
    assert saved(machine) == was


def test_a_history_that_is_closed_records_nothing() -> None:
    machine = Machine()
    history = History(machine)
    history.close()
    assert machine.recorder is None
    machine.run(instructions=10)
    assert history.size == 0


def test_a_device_that_is_not_fitted() -> None:
    machine = Machine()
    history = History(machine)
    machine.run(instructions=10)
    with pytest.raises(HistoryError, match="device 01 is not fitted"):
        rewind.until_flag(history, 0o01)


def test_going_back_passes_what_is_idle() -> None:
    """Core of AND 0 and one JMP I 27 waits in vain, which the run that goes back may see sooner."""
    machine = Machine()
    machine.load({0o3521: 0o5427})
    history = History(machine)
    machine.watch.writes = {0o20}
    for instructions in (1000, 2000, 2000):
        assert machine.run(instructions=instructions).reason == "limit"
    machine.panel.stop()
    machine.run(instructions=2)
    rewind.instructions(history, 2)
    assert (machine.instructions, machine.pc, machine.processor.run) == (5000, 0o2344, 0)
