"""The page's machine and the package's, side by side: they may differ in nothing at any instant."""

import random
from typing import Any

import pytest

from pal.isa import FETCH
from pdp8.computer.hardware.signals import TICKS_PER_SECOND
from pdp8.computer.machine import Machine
from pdp8.replay import Afternoon
from tests.pdp8.conftest import Ask
from tests.pdp8.web.follower import STATE, Follower, state

_AT = f"""(afternoon, instants) => instants.map((tick) => {{
  afternoon.to(tick);
  const {{ machine }} = afternoon;
  const {{ teletype }} = machine;
  const sum = (numbers) => numbers.reduce((total, number) => (total * 31 + number) % 1000003, 0);
  const punched = sum(teletype.punch.frames);
  const core = sum(machine.core);
  return {{ ...{STATE}, core, punched }};
}})"""


def _sum(numbers: Any) -> int:
    total = 0
    for number in numbers:
        total = (total * 31 + number) % 1000003
    return total


def _computing(afternoon: Afternoon) -> tuple[int, int]:
    """Return the ticks between which the computer is used."""
    return afternoon.acts[0].ends, afternoon.acts[4].ends


def test_random_instants_of_the_afternoon(circle: Afternoon, ask: Ask) -> None:
    """Any instant, visited in any order, is the one the processor comes to going forward from cold."""
    draw = random.Random(1971)
    instants = [draw.randrange(circle.acts[-1].ends) for _ in range(40)]
    instants += [draw.randrange(*_computing(circle)) for _ in range(360)]
    instants += [circle.acts[2].starts + draw.randrange(120 * TICKS_PER_SECOND) for _ in range(60)]
    instants += [action.at for action in circle.actions]
    shown = dict(zip(instants, ask(_AT, instants), strict=True))
    follower = Follower(circle)
    for tick in sorted(shown):
        follower.to(tick)
        expected = follower.state()
        expected["core"] = _sum(follower.machine.core)
        expected["punched"] = _sum(follower.machine.teletype.punch.tape)
        assert shown[tick] == expected, f"at tick {tick}, {tick / TICKS_PER_SECOND:.8f} s"


_STEPS = f"""(afternoon, {{ from, to, unit }}) => {{
  const states = [];
  const {{ machine }} = afternoon;
  afternoon.to(from);
  while (afternoon.now < to) {{
    afternoon.next(unit);
    states.push(Object.values({STATE}));
  }}
  return states;
}}"""


def _follow(follower: Follower, start: int, end: int, by: str) -> list[list[int]]:
    """Return the states after every cycle or instruction after `start` up to the first at or past `end`."""
    follower.to(start)
    processor = follower.machine.processor
    states = []
    while processor.clock < end:
        processor.cycle()
        while by == "instruction" and processor.next != FETCH:
            processor.cycle()
        follower.machine.bus.advance(processor.clock)
        states.append(list(follower.state().values()))
    return states


@pytest.mark.parametrize(("unit", "characters"), [("cycle", 1), ("instruction", 2)])
def test_every_step_of_the_first_characters(circle: Afternoon, ask: Ask, unit: str, characters: int) -> None:
    """From START on, step by step: none is left out, none differs."""
    start = next(action.at for action in reversed(circle.actions) if action.key == "lever")
    end = start + characters * TICKS_PER_SECOND // 10
    shown = ask(_STEPS, {"from": start, "to": end, "unit": unit})
    expected = _follow(Follower(circle), start, end, unit)
    names = list(Follower(circle).state())
    for index, (one, other) in enumerate(zip(shown, expected, strict=True)):
        assert dict(zip(names, one, strict=True)) == dict(zip(names, other, strict=True)), f"{unit} {index}"


def test_every_cycle_that_translates_a_character(circle: Afternoon, ask: Ask) -> None:
    """The three milliseconds after each of the first forty characters has come, two blocks' worth."""
    lever = next(action.at for action in reversed(circle.actions) if action.key == "lever")
    follower = Follower(circle)
    starts = [lever + character * 2_000_000 + 1_545_000 for character in range(40)]
    windows = [{"from": start, "to": start + 60_000, "unit": "cycle"} for start in starts]
    shown = ask(f"(afternoon, windows) => windows.map((window) => ({_STEPS})(afternoon, window))", windows)
    for character, start in enumerate(starts):
        assert shown[character] == _follow(follower, start, start + 60_000, "cycle"), f"character {character}"


_RUN = f"""(afternoon, programs) => programs.map(({{ core, tape, every, samples }}) => {{
  const machine = new afternoon.machine.constructor();
  const {{ teletype }} = machine;
  machine.core.set(core);
  teletype.reader.load(tape);
  machine.processor.pc = 0o200;
  machine.panel.start();
  const states = [];
  for (let sample = 0; sample < samples; sample++) {{
    for (let cycle = 0; cycle < every; cycle++) machine.processor.cycle();
    machine.bus.advance(machine.processor.clock);
    states.push(Object.values({STATE}));
  }}
  return {{ states, core: Array.from(machine.core), punched: teletype.punch.frames }};
}})"""
_IOTS = [*range(0o6030, 0o6040), *range(0o6040, 0o6050), *range(0o6000, 0o6010), 0o6101, 0o6214]


def _word(draw: random.Random) -> int:
    """Return a word of a random program: any, or often an IOT; never HLT."""
    word = draw.choice(_IOTS) if draw.random() < 0.15 else draw.randrange(0o10000)
    return word & 0o7775 if word & 0o7403 == 0o7402 else word


def _program(core: list[int], tape: bytes, every: int, samples: int) -> dict[str, Any]:
    """Return a program that starts at 0200, with its tape; how often and after how many cycles to look."""
    return {"core": core, "tape": list(tape), "every": every, "samples": samples}


def _nonsense(seed: int) -> dict[str, Any]:
    draw = random.Random(seed)
    core = [_word(draw) for _ in range(0o10000)]
    return _program(core, bytes(draw.randrange(256) for _ in range(100)), 80 + seed, 800)


def _check(program: dict[str, Any], shown: dict[str, Any]) -> None:
    """Run the program on the package's machine and compare what the page's had at every look."""
    machine = Machine()
    machine.load(enumerate(program["core"]))
    machine.teletype.reader.load(bytes(program["tape"]))
    machine.start(0o200)
    for sample, one in enumerate(shown["states"]):
        for _ in range(program["every"]):
            machine.processor.cycle()
        machine.bus.advance(machine.processor.clock)
        expected = state(machine)
        assert dict(zip(expected, one, strict=True)) == expected, f"sample {sample}"
    assert shown["core"] == list(machine.core)
    assert bytes(shown["punched"]) == machine.teletype.punch.tape


def test_random_programs(ask: Ask) -> None:
    """600 000 cycles of nonsense: every instruction, interrupts, a Teletype used in every wrong way."""
    programs = [_nonsense(seed) for seed in range(10)]
    for program, shown in zip(programs, ask(_RUN, programs), strict=True):
        _check(program, shown)


def test_a_reader_and_a_punch_that_wait_for_the_program(ask: Ask) -> None:
    """KRB, TLS and 177 ms of ISZ X, JMP .-1: the line is idle when the pulse comes, and starts with it."""
    core = [0] * 0o10000
    loops = [word for address in range(0o202, 0o224, 2) for word in (0o2300, 0o5000 | address & 0o377)]
    core[0o200:0o225] = [0o6036, 0o6046, *loops, 0o5200]
    program = _program(core, bytes(range(1, 200)), 1009, 500)
    _check(program, ask(_RUN, [program])[0])
