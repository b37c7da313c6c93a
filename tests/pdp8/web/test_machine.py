"""The page's machine and the package's under random keys, tapes and switches: every number the same."""

import random
from typing import Any

import pytest

from pdp8.computer.hardware.teletype import half_units
from pdp8.computer.machine import Machine
from tests.pdp8.conftest import Ask
from tests.pdp8.web.node import MODULES

_NUMBERS = (
    (
        "processor",
        "lac pc ma mb ir state next run stopping ion ion_delayed sr mem_prot sing_step protect clock started",
    ),
    ("processor", "instructions writes"),
    ("teletype.receiver", "flag reader_run frame start stage free"),
    ("teletype.reader", "position"),
    ("teletype.transmitter", "flag register start shifts free unit selected printed"),
    ("highspeed.reader_control", "flag buffer fetching"),
    ("highspeed.reader", "position"),
    ("highspeed.punch_control", "flag buffer punched"),
)
"""Every number of the machine that decides how it goes on."""


def _camel(path: str) -> str:
    first, *rest = path.split("_")
    return first + "".join(part.capitalize() for part in rest)


_PATHS = [f"{part}.{name}" for part, names in _NUMBERS for name in names.split()]

_PLAY = """(afternoon, sessions) => sessions.map(({ core, highspeed, moves }) => {
  const machine = new afternoon.machine.constructor(highspeed);
  const { panel, processor, teletype } = machine;
  machine.load(core.map((word, address) => [address, word]));
  processor.pc = 0o200;
  const seen = [];
  const does = {
    key: (name) => panel[name](),
    switches: (word) => { processor.sr = word; },
    memProt: (up) => { processor.memProt = up; },
    singStep: (down) => { processor.singStep = down; },
    tape: (frames) => teletype.reader.load(frames),
    lever: (on) => teletype.reader.lever(on),
    type: (frames) => teletype.keyboard.press(frames),
    punch: (on) => { teletype.punch.on = on; },
    fast: (frames) => machine.highspeed.reader.load(frames),
    fastLever: (on) => machine.highspeed.reader.lever(on),
    wait: (ticks) => machine.wait(ticks),
  };
  for (const [cycles, what, value] of moves) {
    for (let cycle = 0; cycle < cycles && processor.run; cycle++) processor.cycle();
    does[what](value);
    machine.bus.advance(processor.clock);
    seen.push([SEEN]);
  }
  const { punch, printer } = teletype;
  return [seen, Array.from(machine.core), punch.frames, printer.frames, machine.highspeed.punch.frames];
})""".replace("SEEN", ", ".join("machine." + ".".join(map(_camel, path.split("."))) for path in _PATHS))

_KEYS = {
    "start": "start",
    "cont": "cont",
    "stop": "stop",
    "loadAdd": "load_add",
    "exam": "exam",
    "dep": "dep",
}
_IOTS = (*range(0o6000, 0o6030), *range(0o6030, 0o6050), 0o6101, 0o6214)


def _word(draw: random.Random) -> int:
    """Return a word of a random program: any, or often an IOT; seldom HLT."""
    word = draw.choice(_IOTS) if draw.random() < 0.15 else draw.randrange(0o10000)
    halts = word & 0o7403 == 0o7402 and draw.random() < 0.99
    return word & 0o7775 if halts else word


def _frames(draw: random.Random) -> list[int]:
    return [draw.randrange(0o400) for _ in range(draw.randrange(1, 40))]


def _move(draw: random.Random, most: int) -> tuple[int, str, Any]:
    """Return how many cycles to run at most, and what the operator does then."""
    what = draw.choice(
        ["key"] * 8 + ["switches", "memProt", "singStep", "tape", "tape", "lever", "type", "type", "punch"]
        + ["fast", "fast", "fastLever", "wait"]
    )  # fmt: skip
    values = {
        "key": draw.choice(["cont", "cont", "cont", "start", "stop", "exam", "dep", "loadAdd"]),
        "switches": draw.randrange(0o10000),
        "memProt": int(draw.random() < 0.2),
        "singStep": int(draw.random() < 0.1),
        "lever": draw.random() < 0.8,
        "punch": draw.random() < 0.8,
        "fastLever": draw.random() < 0.8,
        "wait": draw.randrange(1, 3_000_000),
    }
    value = values[what] if what in values else _frames(draw)
    return draw.randrange(most), what, value


def _session(seed: int, moves: int, most: int) -> dict[str, Any]:
    draw = random.Random(seed)
    played = [(0, "key", "start"), *(_move(draw, most) for _ in range(moves))]
    return {"core": [_word(draw) for _ in range(0o10000)], "highspeed": seed % 2 == 1, "moves": played}


def _do(machine: Machine, what: str, value: Any) -> None:
    """Do one of the operator's moves on the package's machine."""
    panel, teletype, processor = machine.panel, machine.teletype, machine.processor
    match what:
        case "key":
            getattr(panel, _KEYS[value])()
        case "switches":
            panel.sr = value
        case "memProt":
            panel.mem_prot = bool(value)
        case "singStep":
            panel.sing_step = bool(value)
        case "tape":
            teletype.reader.load(bytes(value))
        case "lever":
            teletype.reader.lever(value)
        case "type":
            teletype.keyboard.press(bytes(value))
        case "punch":
            teletype.punch.on = value
        case "fast":
            machine.highspeed.reader.load(bytes(value))
        case "fastLever":
            machine.highspeed.reader.lever(value)
        case _:
            processor.clock += value
            machine.bus.advance(processor.clock)


def _number(machine: Machine, path: str) -> int:
    part: Any = machine
    for name in path.split("."):
        part = getattr(part, name)
    return int(part)


def _play(session: dict[str, Any]) -> tuple[Machine, list[list[int]], int]:
    """Return the package's machine after the session, what was seen after each move, and its cycles."""
    machine = Machine(highspeed=session["highspeed"])
    machine.load(enumerate(session["core"]))
    processor = machine.processor
    processor.pc = 0o200
    seen = []
    done = 0
    for cycles, what, value in session["moves"]:
        for _ in range(cycles):
            if not processor.run:
                break
            processor.cycle()
            done += 1
        _do(machine, what, value)
        machine.bus.advance(processor.clock)
        seen.append([_number(machine, path) for path in _PATHS])
    return machine, seen, done


@pytest.mark.parametrize(
    ("moves", "most", "sessions", "least"), [(300, 60, 24, 10**5), (400, 6000, 20, 10**7)]
)
def test_random_keys_tapes_and_switches(ask: Ask, moves: int, most: int, sessions: int, least: int) -> None:
    """10 000 000 cycles: a few seconds, because every number is compared after every move of the operator."""
    played = [_session(seed, moves, most) for seed in range(sessions)]
    cycles = 0
    for seed, (session, shown) in enumerate(zip(played, ask(_PLAY, played), strict=True)):
        machine, seen, done = _play(session)
        cycles += done
        for number, (one, other) in enumerate(zip(shown[0], seen, strict=True)):
            differing = {
                path: (there, here)
                for path, there, here in zip(_PATHS, one, other, strict=True)
                if there != here
            }
            assert differing == {}, f"seed {seed}, move {number}: {session['moves'][number]}"
        assert shown[1] == list(machine.core), f"seed {seed}"
        punches = (
            machine.teletype.punch.tape,
            bytes(machine.teletype.printer.frames),
            machine.highspeed.punch.tape,
        )
        assert tuple(map(bytes, shown[2:])) == punches, f"seed {seed}"
    assert cycles >= least


_RUN = """(afternoon, programs) => programs.map(({ core, ends, typed, tape }) => {
  const machine = new afternoon.machine.constructor();
  machine.load(core.map((word, address) => [address, word]));
  machine.teletype.reader.load(tape);
  machine.processor.pc = 0o200;
  machine.panel.start();
  return ends.map((end, index) => {
    if (typed[index]) machine.teletype.keyboard.press([typed[index]]);
    machine.run(end);
    const { clock, instructions, lac, pc, ma, mb, ir } = machine.processor;
    const sum = machine.core.reduce((sum, word) => (sum * 31 + word) % 1000003, 0);
    return [clock, instructions, lac, pc, ma, mb, ir, sum];
  });
})"""

_WAITING = {
    "echo": [0o6032, 0o6046, 0o6031, 0o5202, 0o6036, 0o6041, 0o5205, 0o6046, 0o5202],
    "echo under interrupt": [0o6001, 0o5201],
    "a delay loop between two characters": [0o6046, 0o2300, 0o5201, 0o6041, 0o5203, 0o7001, 0o5200],
    "a ring of two tests": [0o6046, 0o6031, 0o7410, 0o5210, 0o6041, 0o5201, 0o6042, 0o5200, 0o6036, 0o5200],
    "a loop that counts in core": [0o2300, 0o7000, 0o5200],
    "a loop without a test": [0o7000, 0o7000, 0o5200],
    "a jump to itself": [0o5200],
    "a delay within a delay, under interrupt": [0o6001, 0o2300, 0o5201, 0o2301, 0o5201, 0o5200],
}
_HANDLER = [0o0000, 0o6041, 0o5004, 0o6042, 0o6031, 0o5007, 0o6036, 0o6001, 0o5400]


@pytest.mark.parametrize("name", _WAITING)
def test_what_is_passed_over_is_exact(ask: Ask, name: str) -> None:
    """Slices of any length end with the clock, count, lamps and core of single instructions."""
    draw = random.Random(name)
    core = [0] * 0o10000
    core[0o200 : 0o200 + len(_WAITING[name])] = _WAITING[name]
    core[0 : len(_HANDLER)] = _HANDLER
    ends = sorted(draw.randrange(40_000_000) for _ in range(60))
    typed = [draw.randrange(0o200, 0o400) if draw.random() < 0.2 else 0 for _ in ends]
    tape = [draw.randrange(0o400) for _ in range(8)]
    program = {"core": core, "ends": ends, "typed": typed, "tape": tape}
    (shown,) = ask(_RUN, [program])
    machine = Machine()
    machine.load(enumerate(core))
    machine.teletype.reader.load(bytes(tape))
    machine.start(0o200)
    p = machine.processor
    for number, (end, frame, one) in enumerate(zip(ends, typed, shown, strict=True)):
        if frame:
            machine.teletype.keyboard.press(bytes([frame]))
        machine.bus.advance(p.clock)
        while p.clock < end:
            p.instruction()
        total = 0
        for word in machine.core:
            total = (total * 31 + word) % 1000003
        assert one == [p.clock, p.instructions, p.lac, p.pc, p.ma, p.mb, p.ir, total], f"slice {number}"


_TELETYPE = (MODULES / "computer" / "teletype.mjs").as_uri()


def test_half_units_are_those_of_the_line(ask: Ask) -> None:
    """To the nearest tick, as far as a garbled character is ever long."""
    found = ask(
        f"""async (afternoon, most) => {{
      const {{ halfUnits }} = await import("{_TELETYPE}");
      return [...Array(most).keys()].map(halfUnits);
    }}""",
        400,
    )
    assert found == [half_units(count) for count in range(400)]
