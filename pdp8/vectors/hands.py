"""What keys and switches do: words in core, one hand after another, and the lamps after each.

A hand does what a hand can do at a real panel, so that a real machine can play the vectors: README.md has the
format, pipan8l.tcl plays them by the panel of the pdp8l project.
"""

import random
from collections.abc import Iterable, Iterator
from importlib import resources
from typing import Any

from pal.isa import NO_STATE, STATES
from pdp8.computer.machine import Machine
from pdp8.vectors.record import Vector

Hand = tuple[str, int]
KEYS = ("load_add", "start", "cont", "stop", "exam", "dep")
SWITCHES = ("sr", "sing_step", "mem_prot")
RUN = "run"
"""Wait until RUN goes off."""
LAMPS = ("ma", "mb", "link", "ac", "ir", "ion", "protect", "run")
PIPAN8L = {"load_add": "ldad", "sing_step": "step", "mem_prot": "mprt", "protect": "prot"}
"""The names that pipan8l has for some of them."""
_BEGIN: list[Hand] = [("stop", 0), ("sing_step", 0), ("mem_prot", 0)]
_STEP, _CONT, _START = ("sing_step", 1), ("cont", 0), ("start", 0)
_GO_ON: list[Hand] = [("sing_step", 0), _CONT, (RUN, 0)]
_FLAG_UP = {0o170: 0o6046, 0o171: 0o6041, 0o172: 0o5171, 0o173: 0o7402}
"""TLS, TSF, JMP .-1, HLT: the printer's flag is up then."""
_IOTS = (0o6001, 0o6001, 0o6002, 0o6041, 0o6042, 0o6000)
"""ION, IOF, TSF, TCF: what others do depends on how long a hand takes."""
_SHOWS, _SHOWN = ("load_add", "exam", "dep"), ("ma", "mb", "state", "protect")
"""Keys that do a memory cycle, and the lamps that they set."""
_RANDOM, _HANDS, _SEED = 400, 16, 1968


def vectors() -> Iterator[Vector]:
    """Yield vectors for each key in each cycle, for disputed cases, and random ones."""
    for name, words, hands in _directed():
        yield _vector(name, words, hands)
    draw = random.Random(_SEED)
    for number in range(_RANDOM):
        yield _vector(f"hands by chance {number}", *_by_chance(draw))


def _at(address: int) -> list[Hand]:
    return [("sr", address), ("load_add", 0)]


def _directed() -> Iterator[tuple[str, dict[int, int], list[Hand]]]:
    for key in KEYS:
        for cycles in range(3):
            hands = [*_at(0o200), _STEP, _START, *[_CONT] * cycles, (key, 0), *[_CONT] * 3]
            yield f"{key} after cycle {cycles + 1} of ISZ I", {0o200: 0o2420, 0o20: 0o30}, hands
    up = [*_at(0o170), _START, (RUN, 0), *_at(0o200)]
    ion = {0: 0, 1: 0o7402, **_FLAG_UP, 0o200: 0o6001, 0o201: 0o7402, 0o202: 0o7001, 0o203: 0o7402}
    yield "CONT after ION, HLT with a flag up", ion, [*up, *_GO_ON, _CONT, (RUN, 0)]
    yield "EXAM, CONT after ION, HLT with a flag up", ion, [*up, *_GO_ON, ("exam", 0), _CONT, (RUN, 0)]
    yield "ION in single cycles with a flag up", ion, [*up, _STEP, *[_CONT] * 5]
    for address in (0o7577, 0o7600, 0o7777):
        refused: list[Hand] = [*_at(address), ("mem_prot", 1), ("sr", 0o4321), ("dep", 0), ("exam", 0)]
        hands = [*refused, ("mem_prot", 0), *_at(address), ("sr", 0o4321), ("dep", 0)]
        yield f"DEP at {address:04o} with MEM PROT up", {address: 0o1234}, hands
        for word in (0o2420, 0o3420, 0o4420):
            hands = [*_at(0o200), ("mem_prot", 1), _STEP, _START, _CONT, _CONT, ("mem_prot", 0), _CONT]
            yield f"{word:04o} at {address:04o} with MEM PROT up", {0o200: word, 0o20: address}, hands


def _by_chance(draw: random.Random) -> tuple[dict[int, int], list[Hand]]:
    """Return random words on page zero and from 0200 on, and random keys; half have the printer's flag up."""
    words = {address: draw.getrandbits(12) for address in (*range(0o20), *range(0o200, 0o220))}
    words |= {address: draw.choice(_IOTS) for address, word in words.items() if word >> 9 == 0o6} | _FLAG_UP
    up = [*_at(0o170), _START, (RUN, 0), *_at(0o200), _STEP]
    hands = up if draw.random() < 0.5 else [*_at(0o200), _STEP, _START]
    for _ in range(_HANDS):
        key = draw.choice((*KEYS, *["cont"] * 12))
        if key == "load_add":
            hands.append(("sr", draw.choice((0o200, 0o7577, draw.getrandbits(12)))))
        elif draw.random() < 0.1:
            hands.append(("mem_prot", draw.getrandbits(1)))
        hands.append((key, 0))
    return words, hands


def _vector(name: str, words: dict[int, int], hands: list[Hand]) -> Vector:
    machine, done = Machine(), []
    machine.load(words)
    known = False
    for what, value in _BEGIN + hands:
        lamps = hand(machine, what, value)
        known |= what == "start"
        if lamps["run"]:  # what it shows depends on when it is looked at
            lamps = {}
        elif not known:  # no key has set the rest
            lamps = {lamp: lamps[lamp] for lamp in _SHOWN if what in _SHOWS}
        done.append({"hand": what, "value": value, "lamps": lamps})
        words.setdefault(machine.ma, 0)
    return {
        "name": name,
        "models": ["8/L"],
        "initial": {"ram": sorted(words.items())},
        "final": {"ram": [(address, machine.core[address]) for address in sorted(words)]},
        "hands": done,
    }


def hand(machine: Machine, what: str, value: int) -> dict[str, Any]:
    """Do one action of the operator, a tenth of a second long; return the lamps."""
    panel = machine.panel
    if what in SWITCHES:
        setattr(panel, what, value)
    elif what in KEYS:
        getattr(panel, what)()
    elif panel.lamps.run:
        machine.run(seconds=1)
    if not panel.lamps.run:
        machine.wait(0.1)
    state = machine.processor.state
    lamps: dict[str, Any] = {name: getattr(panel.lamps, name) for name in LAMPS}
    return lamps | {"state": "" if state == NO_STATE else STATES[state]}


def pipan8l(given: Iterable[Vector]) -> str:
    """Return the vectors as a script for the Tcl of the pdp8l project's panel."""
    lines = [resources.files("pdp8.vectors").joinpath("pipan8l.tcl").read_text()]
    for vector in given:
        lines.append(f"vector {{{vector['name']}}}")
        lines += [f"word 0{address:o} 0{word:o}" for address, word in vector["initial"]["ram"]]
        for done in vector["hands"]:
            lamps = [
                f"{PIPAN8L.get(lamp, lamp)} {value[:1] or '{}' if lamp == 'state' else f'0{value:o}'}"
                for lamp, value in done["lamps"].items()
            ]
            name = PIPAN8L.get(done["hand"], done["hand"])
            lines.append(f"hand {name} 0{done['value']:o} {{{' '.join(lamps)}}}")
        lines += [f"core 0{address:o} 0{word:o}" for address, word in vector["final"]["ram"]]
    return "\n".join([*lines, "summary", ""])
