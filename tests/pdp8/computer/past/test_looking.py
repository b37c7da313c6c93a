"""Looking at a machine changes nothing: a run with looks between its pieces is the run without."""

import copy
import io
import random
from collections.abc import Callable
from itertools import islice
from typing import Any

import pytest

from pdp8.computer.count import Count
from pdp8.computer.machine import Machine
from pdp8.computer.past import state
from pdp8.computer.past.history import History
from pdp8.computer.use.trace import Trace
from pdp8.computer.watch import Observer
from tests.pdp8.computer.past.test_history import act, set_up

LOOKS: dict[str, Callable[[Machine], Any]] = {
    "history": History,
    "save": state.save,
    "copy": copy.deepcopy,
    "values": Machine.values,
    "lamps": lambda machine: machine.panel.lamps,
    "repr": repr,
    "no time": lambda machine: machine.wait(0),
    "no seconds": lambda machine: machine.run(seconds=0),
    "no instructions": lambda machine: machine.run(instructions=0),
    "no slice": lambda machine: list(islice(machine.slices(seconds=0), 1)),
    "out of tape": lambda machine: [device.out_of_tape() for device in machine.bus],
}


def seen(machine: Machine) -> dict[str, Any]:
    """Return the state, and what went out."""
    return {**machine.values(), "elapsed": machine.elapsed}


def played(seed: int, look: Callable[[Machine, random.Random], object]) -> list[dict[str, Any]]:
    """Return what is seen after each piece of a random run."""
    draw, looks = random.Random(seed), random.Random(seed)
    machine = set_up(draw)
    result = []
    for _ in range(6):
        look(machine, looks)
        for _ in range(draw.randrange(3)):
            act(machine, draw)
            look(machine, looks)
        instructions = draw.choice([1, 2, 7, 300, 5_000])
        seconds = draw.choice([None, 0.000_002, 0.01, 0.1])
        machine.run(seconds=seconds, instructions=instructions)
        result.append(seen(machine))
    return result


@pytest.mark.parametrize("name", LOOKS)
def test_a_run_with_looks_is_the_run_without(name: str) -> None:
    for seed in range(60):
        assert played(seed, lambda machine, _: LOOKS[name](machine)) == played(seed, lambda *_: None), seed


def test_all_looks_in_turn() -> None:
    for seed in range(100, 300):
        some = played(seed, lambda machine, draw: draw.choice(list(LOOKS.values()))(machine))
        assert some == played(seed, lambda *_: None), seed


@pytest.mark.parametrize("record", [None, History, lambda machine: machine.wait(0)])
def test_a_recorder_takes_no_frame_from_the_program(record: Callable[[Machine], object] | None) -> None:
    """KCC, KSF, JMP .-1, KRB, TLS, TSF, JMP .-1, JMP 0200: what is read is punched."""
    machine = Machine()
    machine.load(dict(enumerate((0o6031, 0o5200, 0o6036, 0o6046, 0o6041, 0o5204, 0o5200), 0o200)))
    machine.teletype.reader.load(b"\301\302\303")
    if record is not None:
        record(machine)
    machine.start(0o200)
    machine.run()
    assert machine.teletype.punch.tape == b"\301\302\303"


def observed(machine: Machine, observer: Observer) -> None:
    machine.watch.observer = observer


@pytest.mark.parametrize("observer", [Count, lambda: Trace(io.StringIO().write)])
def test_who_watches_each_cycle_changes_nothing(observer: Callable[[], Observer]) -> None:
    """But for what is remembered of loops, and for the stamp of what was written meanwhile."""
    for seed in range(30):
        with_it = played(seed, lambda machine, _: observed(machine, observer()))
        for watched, alone in zip(with_it, played(seed, lambda *_: None), strict=True):
            of_loops = {
                name
                for name in alone
                if name.startswith(("waiting", "processor writes")) or name.endswith(" tested")
            }
            assert {name: alone[name] for name in alone if watched[name] != alone[name]}.keys() <= of_loops, (
                seed
            )
