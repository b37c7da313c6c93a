"""The operator's time, without a terminal: hands, paces, lamps, tapes."""

from collections.abc import Callable, Iterator
from functools import partial
from itertools import count
from pathlib import Path

import pytest

from pdp8 import shelf
from pdp8.computer.hardware.panel import LAMPS
from pdp8.computer.machine import Machine
from pdp8.computer.use.operator import RIM
from pdp8.console.opening import opening
from pdp8.console.session import Session, Tape
from pdp8.monitor import debugging
from tests.pdp8.computer.bench import core

RIM_WORDS = dict(enumerate(RIM, 0o7756))


@pytest.fixture
def session() -> Session:
    """A session whose computer never tires: its clock stands still."""
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


def test_the_hands_press_a_key_every_tenth_of_a_second(session: Session) -> None:
    session.toggle_rim()
    session.advance(0)
    assert session.machine.ma == 0o7756
    session.advance(0.05)
    assert (session.machine.ma, session.machine.core[0o7756]) == (0o7756, 0)
    session.advance(0.1)
    assert session.machine.core[0o7756] == 0o6032
    session.advance(1.6)
    assert {address: session.machine.core[address] for address in RIM_WORDS} == RIM_WORDS
    assert session.said == "toggling RIM in: 0000 into 7776"
    session.advance(0.1)
    assert session.said == "the RIM loader is in core"
    assert session.machine.elapsed == 0
    session.machine.panel.mem_prot = True
    session.toggle_rim()
    session.advance(5)
    assert session.said == "MEM PROT is up: RIM did not go in"


def test_the_hands_find_the_keys_dead_while_run_is_on(session: Session) -> None:
    session.machine.core[0o200] = 0o5200
    session.machine.start(0o200)
    session.toggle_rim()
    assert session.said == "the machine runs: press STOP first"
    session.advance(0.2)
    assert session.machine.core[0o7756] == 0


@pytest.mark.parametrize("speed", [1, 10, 100, 1000])
def test_a_second_in_the_room_is_speed_seconds_at_the_machine(speed: int) -> None:
    session = counting()
    session.speed = speed
    for _ in range(4):
        session.advance(0.001)
    assert session.machine.elapsed == pytest.approx(0.004 * speed, rel=0.01)
    assert not session.behind


def test_a_computer_that_tires_falls_behind_and_leaves_nothing_out() -> None:
    times: Iterator[float] = map(float, range(1000))
    session = counting(lambda: next(times))
    session.advance(0.05)
    assert session.behind
    assert session.machine.elapsed < 0.05
    turns = session.machine.instructions // 2
    assert session.machine.ac in (turns & 0o7777, turns + 1 & 0o7777)
    session.press("stop")
    session.advance(0.05)
    assert not session.behind, "it stands still"
    session.press("cont")
    session.advance(0.05)
    assert session.behind
    times = iter([0.0] * 1000)
    session.advance(0.001)
    assert not session.behind


def test_lamps_at_a_standstill_are_the_panels(session: Session) -> None:
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


def test_the_teletype_goes_on_while_the_processor_stands_still(session: Session) -> None:
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


def test_a_halt_is_said_where_a_wait_was() -> None:
    """At 0201 it waits for a key, and PC has 0201 too behind the HLT that the key leads to.

    First it counts, while the slices grow: one slice takes the key in and ends at the HLT.
    """
    session = Session(Machine(), clock=lambda: 0.0)
    session.machine.load(core("7402 6031 5201 5200 2010 5204 2011 5204 5201 11/ 7700"))
    session.machine.start(0o204)
    session.speed = 1000
    session.advance(1)
    assert session.said == "the program waits for a key at 0201"
    session.machine.teletype.keyboard.press(b"A")
    session.advance(1)
    assert (session.said, session.machine.pc) == ("HLT at 0200", 0o201)


@pytest.mark.parametrize(
    ("words", "said"),
    [
        ("7402", "HLT at 0200"),
        ("6031 5200 6032 5200", "the program waits for a key at 0200"),
        ("6031 5200 6036 5200", "the reader ran out of tape, and the program waits for it at 0200"),
        ("5200", "an endless loop at 0200"),
    ],
)
def test_what_became_of_a_program_is_said_each_time_that_it_is_started(words: str, said: str) -> None:
    session = Session(Machine(), clock=lambda: 0.0)
    session.machine.load(core(words))
    if "6036" in words:
        session.mount(Tape("t", b"A"))
    for _ in range(3):
        load_address(session, 0o200)
        session.press("start")
        for _ in range(2):
            session.advance(1)
            assert session.said.startswith(said)
            session.machine.teletype.keyboard.press(b"A")
        session.press("stop")


def test_mem_prot_is_said(session: Session) -> None:
    session.machine.panel.mem_prot = True
    load_address(session, 0o7600)
    session.press("dep")
    assert session.said == "MEM PROT stopped a write into 7600"
    assert session.brightness["protect"] == (1,)


@pytest.mark.parametrize(
    "act",
    [
        *(partial(Session.press, key=key) for key in debugging.KEYS),
        lambda one: one.back(),
        lambda one: one.back(1),
        lambda one: one.clear([]),
    ],
)
def test_hands_that_toggle_rim_in_stop(act: Callable[[Session], None]) -> None:
    session = Session(Machine(), clock=lambda: 0.0)
    session.toggle_rim()
    session.advance(0.5)
    act(session)
    before = list(session.machine.core)
    session.advance(3)
    assert list(session.machine.core) == before


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
    session.mount(session.tapes[0])
    session.back()  # that, too, with the lever that waits
    session.press("cont")
    for _ in range(100):
        session.advance(0.05)
    assert session.machine.teletype.punch.tape.startswith(punched)
    session.back(1000)
    assert session.machine.teletype.punch.tape == b""


def test_a_program_starts_in_its_field() -> None:
    session, _ = opening("eia.pal", start=0o10200, memory=0o20000)
    assert (session.machine.pc, session.machine.panel.inst_field) == (0o10200, 1)


def test_a_tape_that_is_none_for_ascii_is_said(session: Session) -> None:
    for name in ("circle.asc", "eia.bin", "circle.eia"):
        assert session.said == "standing still"
        session.mount(Tape(name, shelf.read_bundled(name)))
    assert session.said == "circle.eia is an EIA tape: a program for ASCII finds no character on it"


def test_files_of_the_same_names_change_nothing_in_the_room(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    there = opening(clock=lambda: 0.0)
    for name in ("rim.pal", "bin.pal", "eia.pal", "circle.asc"):
        (tmp_path / name).write_text("*200\n\tHLT\n$\n")
    monkeypatch.chdir(tmp_path)
    here = opening(clock=lambda: 0.0)
    assert here[0].tapes == there[0].tapes
    assert [program.words for program in here[1]] == [program.words for program in there[1]]


@pytest.mark.parametrize(("took", "turned"), [(0.002, 2), (0.004, 1), (0.007, 1), (0.008, 0.5)])
def test_a_slice_takes_some_milliseconds(took: float, turned: float) -> None:
    session = counting(count(0, took).__next__)
    for began, after in ((0.001, 0.001 * turned), (1e-4, 1e-4 * max(turned, 1))):
        session._slice = began
        session.advance(1e-6)
        assert session._slice == after


def test_the_keys_are_dead_and_sing_step_is_not_while_the_machine_runs(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr("pdp8.console.session.randrange", lambda greatest: greatest - 1)
    session = counting()
    session.press("exam")
    assert session.said == "the machine runs: all keys but STOP are dead"
    session.press("cont")
    assert session.said == "running"
    took = []
    for switch in ("mem_prot", "sing_step"):
        before = session.machine.processor.clock
        session.lock(switch)
        took.append(session.machine.processor.clock - before)
    assert (took[0], took[1] > 0) == (0, True)
