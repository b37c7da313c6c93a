"""The operator's time, without a terminal: hands, paces, lamps, tapes."""

from collections.abc import Callable
from pathlib import Path

import pytest

from pdp8.computer.hardware.panel import LAMPS
from pdp8.computer.machine import Machine
from pdp8.console.opening import opening
from pdp8.console.session import Session, Tape
from tapes import shelf
from tests.conftest import assert_same_tape

# The loader's words as DEC's instruction card has them.
RIM_WORDS = {
    0o7756: 0o6032, 0o7757: 0o6031, 0o7760: 0o5357, 0o7761: 0o6036, 0o7762: 0o7106, 0o7763: 0o7006,
    0o7764: 0o7510, 0o7765: 0o5357, 0o7766: 0o7006, 0o7767: 0o6031, 0o7770: 0o5367, 0o7771: 0o6034,
    0o7772: 0o7420, 0o7773: 0o3776, 0o7774: 0o3376, 0o7775: 0o5356, 0o7776: 0o0000,
}  # fmt: skip


def at_rest() -> Session:
    """Return a session whose computer never tires: its clock stands still."""
    return Session(Machine(), clock=lambda: 0.0)


def counting(clock: Callable[[], float] = lambda: 0.0) -> Session:
    """Return a session whose machine runs IAC, JMP .-1: it never waits."""
    session = Session(Machine(), clock=clock)
    session.machine.load({0o200: 0o7001, 0o201: 0o5200})
    session.machine.start(0o200)
    return session


def load_address(session: Session, address: int) -> None:
    session.machine.sr = address
    session.press("load_add")


def test_the_hands_press_a_key_every_tenth_of_a_second() -> None:
    session = at_rest()
    session.toggle_rim()
    session.advance(0.05)
    assert session.machine.ma == 0o7756
    assert session.machine.core[0o7756] == 0
    session.advance(0.1)
    assert session.machine.core[0o7756] == 0o6032
    session.advance(1.6)
    assert {address: session.machine.core[address] for address in RIM_WORDS} == RIM_WORDS
    assert session.said == "toggling RIM in: 0000 into 7776"
    session.advance(0.1)
    assert session.said == "the RIM loader is in core"
    assert session.machine.elapsed == 0


def test_the_hands_find_the_keys_dead_while_run_is_on() -> None:
    session = at_rest()
    session.machine.core[0o200] = 0o5200
    session.machine.start(0o200)
    session.toggle_rim()
    assert session.said == "the machine runs: press STOP first"
    session.advance(0.2)
    assert session.machine.core[0o7756] == 0


def test_stop_stops_the_hands() -> None:
    session = at_rest()
    session.toggle_rim()
    session.press("stop")
    session.advance(5)
    assert session.machine.core[0o7776] == 0
    assert not any(session.machine.core)


@pytest.mark.parametrize("speed", [1, 10, 100, 1000])
def test_a_second_in_the_room_is_speed_seconds_at_the_machine(speed: int) -> None:
    session = counting()
    session.speed = speed
    for _ in range(4):
        session.advance(0.001)
    assert session.machine.elapsed == pytest.approx(0.004 * speed, rel=0.01)
    assert not session.behind


def test_a_computer_that_tires_falls_behind_and_leaves_nothing_out() -> None:
    times = iter(range(1000))
    session = counting(lambda: float(next(times)))
    session.advance(0.05)
    assert session.behind
    assert session.machine.elapsed < 0.05
    turns = session.machine.instructions // 2
    assert session.machine.ac in (turns & 0o7777, turns + 1 & 0o7777)


def test_lamps_at_a_standstill_are_the_panels() -> None:
    session = at_rest()
    session.machine.core[0o1234] = 0o4321
    load_address(session, 0o1234)
    assert session.brightness["ma"] == (0, 0, 1, 0, 1, 0, 0, 1, 1, 1, 0, 0)
    assert session.brightness["mb"] == (1, 0, 0, 0, 1, 1, 0, 1, 0, 0, 0, 1)
    assert session.brightness["run"] == (0,)
    assert {name: len(bits) for name, bits in session.brightness.items()} == LAMPS


def test_lamps_of_a_running_machine_are_as_bright_as_they_were_often_on() -> None:
    session = counting()
    session.advance(0.05)
    assert session.brightness["run"] == (1,)
    assert any(0 < brightness < 1 for brightness in session.brightness["ac"])
    assert all(0 <= brightness <= 1 for bits in session.brightness.values() for brightness in bits)


def test_the_teletype_goes_on_while_the_processor_stands_still() -> None:
    session = at_rest()
    session.mount(Tape("two frames", b"\xb1\xb2"))
    session.machine.load({0o200: 0o6031, 0o201: 0o5200, 0o202: 0o6036})  # KSF, JMP .-1, KRB
    session.machine.panel.sing_step = True
    load_address(session, 0o200)
    session.press("start")
    assert session.address == 0o201
    session.advance(0.1)
    assert session.machine.teletype.reader.position == 1
    session.press("cont")
    session.press("cont")
    assert session.address == 0o202
    session.press("cont")
    assert session.machine.ac == 0o261


@pytest.mark.parametrize("key", ["start", "cont"])
def test_a_tape_put_in_at_a_standstill_waits_for_the_key_that_starts_the_machine(key: str) -> None:
    session = at_rest()
    reader = session.machine.teletype.reader
    session.mount(Tape("two frames", b"\xb1\xb2"))
    session.machine.core[0o200] = 0o5200
    load_address(session, 0o200)
    session.advance(3)
    assert (reader.position, reader.on) == (0, False)
    session.press(key)
    assert reader.on
    session.advance(0.05)
    assert reader.position == 1


def test_a_tape_put_into_a_running_machine_is_read_at_once() -> None:
    session = at_rest()
    session.machine.core[0o200] = 0o5200
    session.machine.start(0o200)
    session.mount(Tape("two frames", b"\xb1\xb2"))
    session.advance(0.05)
    assert session.machine.teletype.reader.position == 1


def test_a_lever_thrown_by_hand_is_left_to_the_hand() -> None:
    session = at_rest()
    reader = session.machine.teletype.reader
    session.operator.throw_lever()
    session.mount(Tape("two frames", b"\xb1\xb2"))
    session.press("start")
    assert not reader.on
    session.press("stop")
    session.operator.throw_lever()
    session.mount(Tape("two frames", b"\xb1\xb2"))
    session.operator.throw_lever()
    session.operator.throw_lever()
    session.press("start")
    assert not reader.on


def test_single_steps_name_their_state() -> None:
    session = at_rest()
    session.machine.load({0o200: 0o1410, 0o10: 0o0377, 0o400: 0o7777})  # TAD I 10
    session.machine.panel.sing_step = True
    load_address(session, 0o200)
    said = []
    for key in ("start", "cont", "cont"):
        session.press(key)
        said.append((session.said, session.address))
    assert said == [("one cycle: FETCH", 0o200), ("one cycle: DEFER", 0o200), ("one cycle: EXECUTE", 0o201)]
    assert session.machine.ac == 0o7777


def test_a_loaders_tape_is_set_on_its_leader_and_no_other_tape_loses_a_frame() -> None:
    session = at_rest()
    session.mount(Tape("loader", b"\0\0\x80\x80\x01\x02"))
    assert session.machine.teletype.reader.tape == b"\x80\x80\x01\x02"
    session.mount(Tape("eia", b"\0\x20\x01\x80"))
    assert session.machine.teletype.reader.tape == b"\0\x20\x01\x80"


def test_dialling_octal_digits_sets_three_switches_at_a_time() -> None:
    session = at_rest()
    for digit in (7, 7, 5, 6):
        session.dial(digit)
    assert session.machine.sr == 0o7756
    session.throw(0)
    assert session.machine.sr == 0o3756


def test_the_whole_morning_at_a_thousand_times_the_pace() -> None:
    session, programs = opening(clock=lambda: 0.0)
    session.speed = 1000
    tapes = {tape.name: tape for tape in session.tapes}
    assert set(tapes) == {"bin.rim", "eia.bin", "circle.asc", "ellipse.asc"}
    session.toggle_rim()
    session.advance(2)
    read_by(session, tapes["bin.rim"], 0o7756)
    assert session.said.startswith("out of tape")
    session.press("stop")
    read_by(session, tapes["eia.bin"], 0o7777)
    assert session.said == "HLT at 7700"
    assert session.machine.ac == 0
    assert programs[-1].listing.fits(0o200, session.machine.core[0o200])
    short = tapes["circle.asc"].frames[:54]
    read_by(session, Tape("two lines", short), 0o200)
    expected = bytes([0, *(0o40, 0o40, 0o1, 0o40, 0o1, 0o31), *[0o40] * 12, 0o2, 0o200])
    assert_same_tape(session.machine.teletype.punch.tape[:21], expected)


def read_by(session: Session, tape: Tape, start: int) -> None:
    """Put the tape in, LOAD ADD, START, and wait until the machine has had enough."""
    session.mount(tape)
    load_address(session, start)
    session.press("start")
    for _ in range(100):
        session.advance(0.05)
        if session.said != "running":
            return


def test_sing_step_stops_a_running_machine_and_cont_goes_on() -> None:
    session = counting()
    session.advance(0.05)
    session.machine.panel.sing_step = True
    session.advance(0.05)
    count = session.machine.instructions
    assert not session.machine.panel.lamps.run
    session.advance(0.05)
    assert session.machine.instructions == count
    session.machine.panel.sing_step = False
    session.press("cont")
    session.advance(0.05)
    assert session.said == "running"
    assert session.machine.instructions > count


def test_mem_prot_is_said() -> None:
    session = at_rest()
    session.machine.panel.mem_prot = True
    load_address(session, 0o7600)
    session.press("dep")
    assert session.said == "MEM PROT stopped a write at 7600"
    assert session.brightness["protect"] == (1,)


def test_time_runs_back_by_an_instruction_and_by_a_second() -> None:
    session, _ = opening("eia.pal", "circle.asc", clock=lambda: 0.0)
    session.press("start")
    for _ in range(100):
        session.advance(0.05)
    punched = session.machine.teletype.punch.tape
    before = session.machine.instructions
    session.back()
    assert session.machine.instructions == before - 1
    assert not session.machine.panel.lamps.run
    session.back(4)
    assert len(session.machine.teletype.punch.tape) < len(punched)
    session.press("cont")
    for _ in range(100):
        session.advance(0.05)
    assert session.machine.teletype.punch.tape.startswith(punched)
    session.back(1000)
    assert session.machine.teletype.punch.tape == b""


def test_a_tape_that_is_none_for_ascii_is_said(tmp_path: Path) -> None:
    session = at_rest()
    session.mount(Tape("circle.eia", shelf.read_bundled("circle.eia")))
    assert session.said == "circle.eia is an EIA tape: a program for ASCII finds no character on it"
    session = at_rest()
    for name in ("circle.asc", "eia.bin"):
        session.mount(Tape(name, shelf.read_bundled(name)))
    assert session.said == "standing still"


def test_files_of_the_same_names_change_nothing_in_the_room(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    there = opening(clock=lambda: 0.0)
    for name in ("rim.pal", "bin.pal", "eia.pal", "circle.asc"):
        (tmp_path / name).write_text("*200\n\tHLT\n$\n")
    monkeypatch.chdir(tmp_path)
    here = opening(clock=lambda: 0.0)
    assert here.session.tapes == there.session.tapes
    assert [program.words for program in here.programs] == [program.words for program in there.programs]
