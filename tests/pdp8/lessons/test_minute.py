"""The guided minute, followed on the machine in Python, from anywhere."""

import re
from random import Random

import pytest

from pdp8.computer.machine import Machine
from pdp8.lessons.minute import PROGRAM, Minute, Step

_KEYS = ["start", "load add", "dep", "exam", "cont", "stop", "sing step", "mem prot"]


def _press(machine: Machine, key: str) -> None:
    name = key.replace(" ", "_")
    if key in ("sing step", "mem prot"):
        setattr(machine.panel, name, not getattr(machine.panel, name))
    else:
        getattr(machine.panel, name)()


def _let(machine: Machine, seconds: float) -> None:
    if machine.processor.run:
        machine.run(seconds=seconds)


def _do(machine: Machine, minute: Minute, step: Step) -> None:
    """Do what the sentence says: the step's own fields have to say the same."""
    if wanted := re.search(r"Flip the ringed switch(?:es)?, or type (\d{4})", step.say):
        assert step.switches == int(wanted[1], 8)
        machine.panel.sr = step.switches
        return
    key = re.search(r"Press ([A-Z ]+)[.:,]", step.say)
    assert key is not None, step
    assert key[1].lower() == step.key
    _press(machine, step.key)
    minute.answer(step.key, machine)


def _led(machine: Machine, minute: Minute) -> list[str]:
    """Follow the steps until a name is asked for; return all that was said."""
    said = []
    for _ in range(30):
        step = minute.next(machine)
        said += [minute.did, step.say]
        if not step.key and step.switches < 0:
            return said
        _do(machine, minute, step)
        _let(machine, 0.01)
    raise AssertionError(said)


@pytest.mark.parametrize("seed", range(40))
def test_from_anywhere(seed: int) -> None:
    """Whatever is in core and whatever was pressed, a name can be typed at last; no sentence is too long."""
    random = Random(seed)
    machine, minute = Machine(), Minute(typed=True)
    machine.load({0o200 + word: random.randrange(0o10000) for word in range(40)})
    machine.pc = 0o200
    machine.teletype.punch.frames.extend(bytes(9))
    minute.begin(machine)
    said, key = [], ""
    for _ in range(random.randrange(60)):
        machine.panel.sr ^= 0o4000 >> random.randrange(12)
        minute.next(machine)
        assert not (key == "stop" and "by itself" in minute.did)
        key = random.choice(_KEYS)
        ran = machine.processor.run
        _press(machine, key)
        minute.answer(key, machine)
        assert ("did not hear" in minute.did) == bool(ran and key not in ("stop", "sing step", "mem prot"))
        said.append(minute.did)
        _let(machine, 0.001)
    said += _led(machine, minute)
    assert max(map(len, said)) <= 90, max(said, key=len)
    before = len(machine.teletype.punch.tape)
    machine.teletype.keyboard.press(b"\xc1\xc4\xc1")
    machine.run(seconds=1)
    assert machine.teletype.punch.tape[before:] == b"\xc1\xc4\xc1"
    assert minute.next(machine).say.startswith("ADA: 3 rows of holes")
    machine.teletype.punch.frames.clear()  # it is torn off
    assert minute.next(machine).say.startswith("Your program runs")
    machine.teletype.keyboard.press(b"\xc5")
    machine.run(seconds=1)
    assert minute.next(machine).say.startswith("E: one row of holes")


def test_what_a_key_did() -> None:
    """Words and addresses of each answer, by hand."""
    machine, minute = Machine(), Minute(typed=False)
    machine.load({0o200: 0o7300})
    minute.begin(machine)
    answers = []
    for switches, key in (
        (0o200, "stop"), (0o200, "load add"), (0o6031, "dep"), (0, "exam"), (0o200, "load add"),
        (0o200, "start"), (0o200, "dep"), (0o200, "stop"),
    ):  # fmt: skip
        machine.panel.sr = switches
        _press(machine, key)
        minute.answer(key, machine)
        answers.append(minute.did)
        _let(machine, 0.001)
    address = f"{machine.processor.ma:04o}"
    assert answers == [
        "It had stopped already: STOP did nothing.",
        "MEMORY ADDRESS says 0200, MEMORY BUFFER the word there: 7300 CLA CLL.",
        "0200 held 7300; now it holds 6031 KSF.",
        "In 0201 is 0000. The next EXAM shows 0202.",
        "MEMORY ADDRESS says 0200, MEMORY BUFFER the word there: 6031 KSF.",
        "It began at 0200, and runs.",
        "It runs, and did not hear DEP.",
        f"It has stopped: RUN is dark, and MEMORY ADDRESS says {address}.",
    ]


def test_a_switch_that_locks_is_said_as_it_stands_now() -> None:
    machine, minute = Machine(), Minute(typed=False)
    minute.begin(machine)
    answers = []
    for key in ("mem prot", "sing step", "mem prot", "sing step"):
        _press(machine, key)
        minute.answer(key, machine)
        answers.append(minute.did)
    assert answers == [
        "MEM PROT is on: 7600 to 7777 cannot be written.",
        "SING STEP is on: it stops after each cycle.",
        "MEM PROT is off: all of memory can be written.",
        "SING STEP is off: it runs freely again.",
    ]


@pytest.mark.parametrize(
    ("at", "running", "stopped"),
    [
        (0o177, "RUN is lit", "All five words are in."),
        (0o200, "Your program runs", "Five words"),
        (0o201, "Your program runs", "It has stopped within your program. Press CONT"),
        (0o204, "Your program runs", "It has stopped within your program. Press CONT"),
        (0o205, "RUN is lit", "All five words are in."),
    ],
)
def test_where_it_runs_and_where_it_stopped(at: int, running: str, stopped: str) -> None:
    machine, minute = Machine(), Minute(typed=False)
    machine.load({0o200 + place: word for place, (word, _) in enumerate(PROGRAM)})
    machine.load({0o177: 0o5177, 0o205: 0o5205})
    machine.start(at)
    machine.run(instructions=1)
    minute.begin(machine)
    assert minute.did == "The switches are yours. The computer runs; its tape reader is off."
    assert minute.next(machine).say.startswith(running)
    machine.stop()
    machine.pc = machine.sr = at
    machine.panel.load_add()
    machine.panel.sr = 0
    said = minute.next(machine).say
    assert said.startswith(stopped)
    assert "or type" not in said


def test_a_name_is_made_of_the_characters_that_can_be_seen() -> None:
    machine, minute = Machine(), Minute(typed=False)
    machine.load({0o200 + place: word for place, (word, _) in enumerate(PROGRAM)})
    machine.start(0o200)
    machine.run(instructions=1)
    minute.begin(machine)
    for frames, made in ((b"\x1f\x41\x20\x5f\x60\xc2\xa0", "A _B"), (b"\x8d\x8a\xe1\xff", "")):
        machine.teletype.punch.frames.clear()
        minute.next(machine)
        machine.teletype.punch.frames.extend(frames)
        assert minute.next(machine).say.startswith(f"{made}: " if made else "Your program runs")
