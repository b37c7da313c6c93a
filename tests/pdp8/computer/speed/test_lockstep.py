"""The engine and the processor one can read, side by side: nobody can tell which of them ran.

The readable one is driven by the machine's own watched run, which never uses the engine.
"""

import random
from collections.abc import Iterator, Mapping
from types import ModuleType
from typing import Any

import pytest

from tests.pdp8.computer.speed.forms import FORMS, machine_module

REGISTERS = (
    *("lac", "pc", "ma", "mb", "ir", "state", "next", "run", "ion", "ion_delayed"),
    *("sr", "protect", "clock", "instructions"),
)
RECEIVER = ("flag", "due", "buffer", "active", "shifts", "reader_run")
TRANSMITTER = ("flag", "due", "register", "sent", "selected")
NEVER = 1 << 62


@pytest.fixture(params=FORMS)
def form(request: pytest.FixtureRequest) -> ModuleType:
    return machine_module(request.param)


class Observer:
    """Watches every cycle, so that the engine is not used."""

    def cycle(self, processor: object) -> None:
        """See a cycle."""

    def waited(self, processor: object, instructions: int, ticks: int) -> None:
        """Hear of a wait."""


def state(machine: Any) -> dict[str, object]:
    """Return all that can be seen of a machine but core."""
    p, teletype = machine.processor, machine.teletype
    machine.bus.advance(p.clock)
    seen: dict[str, object] = {name: getattr(p, name) for name in REGISTERS}
    seen |= {f"receiver {name}": getattr(teletype.receiver, name) for name in RECEIVER}
    seen |= {f"transmitter {name}": getattr(teletype.transmitter, name) for name in TRANSMITTER}
    return seen | {"read": teletype.reader.position, "punched": teletype.punch.tape.hex()}


def same(fast: Any, readable: Any, where: str) -> None:
    ours, expected = state(fast), state(readable)
    different = {name: (ours[name], expected[name]) for name in expected if ours[name] != expected[name]}
    assert not different, f"{where}: (engine, processor) {different}"
    for address, (engine, processor) in enumerate(zip(fast.core, readable.core, strict=True)):
        assert engine == processor, f"{where}: {address:04o} holds {engine:04o}, not {processor:04o}"


def pair(form: ModuleType, words: Mapping[int, int], tape: bytes = b"", mem_prot: bool = False) -> list[Any]:
    """Return the same machine twice, the second to be run by the readable processor; both started at 0200."""
    machines = []
    for observer in (None, Observer()):
        machine = form.Machine()
        machine.load(words)
        machine.teletype.reader.load(tape)
        machine.panel.mem_prot = mem_prot
        machine.watch.observer = observer
        machine.start(0o200)
        machines.append(machine)
    return machines


def random_word(draw: random.Random) -> int:
    """Return a word for a program of nonsense: more IOT, OPR and JMP to its page than chance would have."""
    kind = draw.random()
    if kind < 0.08:
        return 0o6000 | draw.choice([1, 2, 0o31, 0o32, 0o34, 0o36, 0o35, 0o41, 0o42, 0o44, 0o46, 0o47, 0o11])
    if kind < 0.3:
        return draw.randrange(0o7000, 0o10000) if draw.random() < 0.97 else 0o7402
    if kind < 0.5:
        return 0o5200 | draw.randrange(0o200)
    return draw.randrange(0o10000)


def random_program(draw: random.Random) -> dict[int, int]:
    return {address: random_word(draw) for address in range(0o10000)}


@pytest.mark.parametrize("seed", range(8))
def test_random_programs_in_random_pieces(form: ModuleType, seed: int) -> None:
    draw = random.Random(seed)
    tape = draw.randbytes(30)
    fast, readable = pair(form, random_program(draw), tape, draw.random() < 0.3)
    for piece in range(60):
        if draw.random() < 0.2:
            breakpoints = set(draw.sample(range(0o10000), draw.choice([0, 20, 200])))
            fast.watch.breakpoints, readable.watch.breakpoints = breakpoints, breakpoints
        limits = {
            "instructions": draw.choice([1, 2, 3, 10, 100, 2000]),
            "seconds": draw.choice([None, None, 1e-5, 1e-3, 0.05]),
        }
        stops = fast.run(**limits), readable.run(**limits)
        assert stops[0] == stops[1], f"piece {piece}"
        same(fast, readable, f"piece {piece}, {limits}, {stops[0].reason}")
        if stops[0].reason not in ("limit", "breakpoint"):
            fast.core[fast.pc] = readable.core[readable.pc] = random_word(draw)


@pytest.mark.parametrize("seed", range(100, 104))
def test_after_every_instruction(form: ModuleType, seed: int) -> None:
    """Run n instructions at once for every n, and be where the processor is after n single ones."""
    draw = random.Random(seed)
    words, tape = random_program(draw), draw.randbytes(30)
    readable = pair(form, words, tape)[1]
    for n in range(1, 250):
        reason = readable.run(instructions=1).reason
        fast = pair(form, words, tape)[0]
        assert fast.run(instructions=n).reason == reason
        same(fast, readable, f"after {n} instructions")
        if reason != "limit":
            break


CELLS, POINTERS, INDEXES, BACK = (0o20, 0o21), (0o24, 0o25), (0o10, 0o11), 0o27
WAYS = (
    *(0o2000 | cell for cell in CELLS * 4),  # ISZ
    *(code | cell for cell in CELLS for code in (0o1000, 0o3000)),  # TAD, DCA
    *(
        code | pointer for pointer in POINTERS for code in (0o2400, 0o3400, 0o3400, 0o4400)
    ),  # ISZ I, DCA I, JMS I
    *(code | index for index in INDEXES for code in (0o1400, 0o3400)),  # TAD I, DCA I, autoindexed
    *(0o1010, 0o2010, 0o3010),  # TAD, ISZ, DCA of an autoindex itself
    *(0o4020, 0o4021, 0o5020),  # JMS, JMP: cells are executed too
    *(0o7001, 0o7041, 0o7420, 0o7500),  # IAC, CIA, SNL, SMA
)


def crowded_program(draw: random.Random) -> dict[int, int]:
    """Return a loop that writes the same few words in every way: straight, by pointers, by autoindexes."""
    words = dict.fromkeys(range(0o10000), 0o5400 | BACK)  # from wherever it strays: JMP I BACK
    words |= {pointer: draw.choice(CELLS + INDEXES) for pointer in POINTERS}
    words |= {index: draw.randrange(0o5, 0o20) for index in INDEXES} | {BACK: 0o200}
    words |= {cell: draw.choice((0, 0o7001, 0o7041)) for cell in CELLS}
    words[CELLS[-1] + 1] = draw.choice((0o5420, 0o5421, 0o5400 | BACK))  # mostly the way back of a JMS
    words |= {address: draw.choice(WAYS) for address in range(0o200, 0o212)}
    if draw.random() < 0.3:  # a delay loop, ISZ and JMP .-1, between others that count the same word
        words |= {0o204: 0o2020, 0o205: 0o2020, 0o206: 0o5205, 0o207: 0o2020, 0o20: 0o7770}
    return words


@pytest.mark.parametrize("seed", range(400))
def test_words_that_everything_writes(form: ModuleType, seed: int) -> None:
    """Limits of time leave longer pieces than limits of instructions: 3 to 30 instructions here."""
    draw = random.Random(seed)
    fast, readable = pair(form, crowded_program(draw))
    for piece in range(60):
        seconds = draw.uniform(10e-6, 100e-6)
        stops = [machine.run(seconds=seconds) for machine in (fast, readable)]
        assert stops[0] == stops[1], f"piece {piece}"
        same(fast, readable, f"piece {piece}, {seconds} s, {stops[0].reason}")


# A loop through 0210, where a NOP stands at first; what 0202 makes of it, an AND with a word that is 0, does
# clear the AC.
EXECUTED = {
    **{0o200: 0o7240, 0o201: 0o5210, 0o205: 0o5210},  # CLA CMA, JMP 210, JMP 210
    **{0o210: 0o7000, 0o211: 0o2025, 0o212: 0o5202, 0o213: 0o5210},  # NOP, ISZ 25, JMP 202, JMP 210
    **{0o24: 0o210, 0o25: 0o7776},
}
WRITERS = {
    "JMS 210": {0o202: 0o4210},
    "JMS I 24": {0o202: 0o4424},
    "ISZ 210, JMP .-1": {0o202: 0o2210, 0o203: 0o5202, 0o204: 0o7000},
}


@pytest.mark.parametrize("writer", WRITERS)
def test_what_is_executed_was_written_last(form: ModuleType, writer: str) -> None:
    machine = pair(form, EXECUTED | WRITERS[writer])[0]
    machine.run(seconds=0.01)
    assert f"{machine.ac:04o}" == "0000"


def after(form: ModuleType, words: Mapping[int, int], lac: int, instructions: int) -> Iterator[Any]:
    for machine in pair(form, words, mem_prot=True):
        machine.processor.lac = lac
        machine.sr = 0o5252
        machine.run(instructions=instructions)
        yield machine


@pytest.mark.parametrize("first", range(0o7000, 0o10000, 0o100))
def test_every_opr_word(form: ModuleType, first: int) -> None:
    draw = random.Random(first)
    words = {0o200: first, **dict.fromkeys(range(0o201, 0o210), 0o7000)}
    for word in range(first, first + 0o100):
        words[0o200] = word
        for lac in (0, 0o10000, 0o7777, 0o4000, draw.randrange(0o20000), draw.randrange(0o20000)):
            fast, readable = after(form, words, lac, 4)
            where = f"{word:04o} with L AC {lac:05o}"
            assert {name: getattr(fast.processor, name) for name in REGISTERS} == {
                name: getattr(readable.processor, name) for name in REGISTERS
            }, where


@pytest.mark.parametrize("ion", [0, 1])
def test_every_iot(form: ModuleType, ion: int) -> None:
    """Both flags up and both down, in a program that goes on after it."""
    for word in range(0o6000, 0o7000):
        for tape, time in ((b"", 1), (b"\x81", 5_000_000)):
            nothing = dict.fromkeys((*range(0o10), *range(0o201, 0o210)), 0o7000)
            words = nothing | {0o200: word}
            machines = pair(form, words, tape)
            for machine in machines:
                machine.teletype.transmitter.pulse(4, 0o301, 0)
                machine.processor.clock = time
                machine.processor.ion = machine.processor.ion_delayed = ion
                machine.processor.lac = 0o11234
                machine.run(instructions=6)
            fast, readable = machines
            ours, expected = state(fast), state(readable)
            assert ours == expected, f"{word:04o}, flags {'up' if tape else 'down'}, ION {ion}"
