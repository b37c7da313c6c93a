"""Drills: who follows the card is done; who does not is told the first wrong switch; nobody gets stuck."""

from pathlib import Path

import pytest

from pdp8 import shelf
from pdp8.computer.machine import Machine
from pdp8.computer.use.operator import RIM
from pdp8.console.opening import opening
from pdp8.console.session import Session
from pdp8.console.switches import LOCKING
from pdp8.lessons.drill import LEFT_ALONE, NAMES, Coach, _holds, _loaded, find

KEYS = ("load_add", "exam", "dep", "start", "cont", "stop")


def room(name: str, left_alone: float | None = None, memory: int = 0o10000) -> tuple[Session, Coach]:
    session, programs = opening(clock=lambda: 0.0, memory=memory)
    bin_tape, program_tape = session.tapes[:2]
    tapes = (bin_tape.name, programs[1].words), (program_tape.name, programs[2].words)
    return session, Coach(find(name, tapes), session.machine, left_alone)


def press(session: Session, coach: Coach, key: str, sr: int | None = None) -> bool:
    if sr is not None:
        session.machine.sr = sr
    coach.touched()
    allowed = coach.allows(key)
    if allowed:
        session.press(key)
    return allowed


def advance(session: Session, coach: Coach, seconds: float) -> None:
    session.advance(seconds)
    if coach.advance(seconds):
        session.clear(session.tapes)


def follow(session: Session, coach: Coach, end: int = 99) -> None:
    """Do what the card says, as far as the step `end`, or its end."""
    session.speed = 1 if end < 99 else 1000
    tapes = {tape.name: tape for tape in session.tapes}
    while not coach.done and coach.at < end:
        step = coach.drill.steps[coach.at]
        session.machine.panel.mem_prot = session.machine.panel.sing_step = False
        if step.key:
            assert press(session, coach, step.key, step.sr), (step, coach.said)
        elif step.say.startswith("O:"):
            session.mount(tapes[step.say.split()[1]])
        advance(session, coach, 0.1)


@pytest.mark.parametrize("name", NAMES)
def test_who_follows_the_card_is_done(name: str) -> None:
    session, coach = room(name)
    assert coach.said == "Follow the card. The clock begins with your first key."
    advance(session, coach, 5)
    follow(session, coach, 1)
    assert coach.said == f"right: {coach.drill.steps[0].say}"
    follow(session, coach)
    assert coach.said.startswith("Done in 1.7 s, " if name == "rim" else "Done in ")
    assert coach.said.endswith("no mistake.")


def test_boot_leaves_the_program_in_core() -> None:
    session, coach = room("boot")
    follow(session, coach, 18)
    assert session.machine.core[0o7756:0o7777] == list(RIM)
    for wrong in ("start", "stop"):
        assert not press(session, coach, wrong)
        assert coach.said == f"not {wrong.upper()} yet: O: bin.rim into the reader"
    follow(session, coach, 21)
    session.machine.load(shelf.program("bin.pal").words)
    advance(session, coach, 0.1)
    assert coach.drill.steps[coach.at].say == "wait until the tape has run through"
    follow(session, coach)
    assert coach.said.endswith(", 2 mistakes.")
    assert press(session, coach, "stop", 0)
    assert (session.machine.core[0o200], session.machine.ac) == (0o6046, 0)


@pytest.mark.parametrize(
    ("key", "sr", "said"),
    [
        ("load_add", 0o7656, "switch 5 should be up: 7756, not 7656"),
        ("load_add", 0o7757, "switch 11 should be down: 7756, not 7757"),
        ("load_add", 0o0001, "switch 0 should be up: 7756, not 0001"),
        *((key, 0o7756, f"LOAD ADD is next, not {key.upper()}") for key in KEYS[1:]),
    ],
)
def test_the_first_wrong_switch_is_named_and_the_key_not_pressed(key: str, sr: int, said: str) -> None:
    session, coach = room("rim", memory=0o20000)
    assert not press(session, coach, key, sr)
    assert (coach.said, coach.wrong, coach.at) == (said, 1, 0)
    for name in LOCKING:
        session.lock(name)
        assert not press(session, coach, "load_add", 0o7756)
        is_so = f"{name.upper().replace('_', ' ')} is {'on' if name == 'sing_step' else 'up'}"
        assert coach.said == f"{is_so}: put it back first"
        session.lock(name)
    assert press(session, coach, "load_add", 0o7756)


def test_each_card_says_what_to_do() -> None:
    """A line for each step: the key, the switches, what is said."""
    lines = []
    for name in NAMES:
        drill = room(name)[1].drill
        lines += [f"{drill.name}: {drill.title}"]
        lines += [f"{key:8} {'' if sr is None else f'{sr:04o}':4}  {say}" for say, key, sr, _ in drill.steps]
        lines += [""]
    assert lines[:-1] == (Path(__file__).parent / "drills.txt").read_text().splitlines()


def test_a_chain_of_addresses_is_in_core_again_and_again() -> None:
    session, coach = room("examine")
    chain = (0o300, 0o345, 0o1234, 0o4571, 0o7402)
    follow(session, coach)
    assert session.machine.pc == 0o4572
    session.machine.core[chain[1]] = 0
    coach.again()
    assert [session.machine.core[address] for address in chain] == [*chain[1:], 0]


@pytest.mark.parametrize("name", NAMES)
def test_again_is_as_a_coach_that_nobody_had(name: str) -> None:
    """After wrong keys, some right ones, and time."""
    session, coach = room(name)
    fresh = {key: value for key, value in vars(coach).items() if key != "machine"}
    core = session.machine.values()
    for key in ("cont", "exam", "load_add", "dep"):
        press(session, coach, key, 0o1234)
        advance(session, coach, 1)
    assert (coach.wrong > 0, coach.seconds > 0) == (True, True)
    coach.again()
    assert {key: value for key, value in vars(coach).items() if key != "machine"} == fresh
    assert session.machine.values() == core


@pytest.mark.parametrize("name", NAMES)
def test_a_kiosk_that_is_left_alone_is_as_it_was_for_the_next(name: str) -> None:
    session, coach = room(name, LEFT_ALONE)
    session.mount(session.tapes[0])
    session.machine.panel.mem_prot = session.machine.panel.sing_step = True
    for _ in range(2):
        advance(session, coach, 59.5)
        assert (coach.begun, session.machine.panel.mem_prot) == (False, True)
        coach.touched()
    advance(session, coach, 60)
    assert (coach.at, coach.begun, session.machine.panel.mem_prot) == (0, False, False)
    follow(session, coach, 2)
    advance(session, coach, 59)
    assert coach.at == 2
    advance(session, coach, 1)
    assert (coach.at, session.machine.pc, session.machine.sr) == (0, 0, 0)
    follow(session, coach)
    taken = coach.seconds
    coach.advance(5)
    assert (coach.done, coach.seconds) == (True, taken)


def test_a_kiosk_that_nobody_touched_stays() -> None:
    _, coach = room("rim", LEFT_ALONE)
    assert not coach.advance(LEFT_ALONE)
    coach.touched()
    assert not coach.advance(LEFT_ALONE - 0.1)
    assert coach.advance(0.1)
    assert not coach.advance(LEFT_ALONE)


def test_boot_is_done_if_bin_halts_where_it_does_with_all_in_core() -> None:
    cases = (
        (True, 0o7700, 0o7402, 0, 5), (False, 0o7700, 0o5300, 0, 5), (False, 0o300, 0o7402, 0, 5),
        (False, 0o7700, 0o7402, 1, 5), (False, 0o7700, 0o7402, 0, 4),
    )  # fmt: skip
    for done, at, word, ac, found in cases:
        machine = Machine()
        machine.load({at: word, 0o200: found})
        machine.start(at)
        machine.ac = ac
        machine.run(instructions=1)
        assert _loaded(machine, {0o200: 5}) == done
    machine.teletype.reader.load(b"A")
    assert [_holds(machine, {0o200: 4}), _holds(machine, {})] == [False, False]
    machine.teletype.reader.position = 1
    assert [_holds(machine, {0o200: 4}), _holds(machine, {0o200: 5})] == [True, False]
