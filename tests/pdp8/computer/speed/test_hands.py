"""What a run may not overlook: interrupts that are due, hands between two runs, hands in the middle of one.

The oracle is the processor alone, one instruction after the other: nothing passes over anything there.
"""

import random
from types import ModuleType
from typing import Any

import pytest

from tests.pdp8.computer.speed.forms import FORMS, machine_module
from tests.pdp8.computer.speed.test_lockstep import NEVER, random_program

KSF, KCC, TSF, TLS, ION, HLT = 0o6031, 0o6032, 0o6041, 0o6046, 0o6001, 0o7402
DAY = 24 * 3600.0


@pytest.fixture(params=FORMS)
def form(request: pytest.FixtureRequest) -> ModuleType:
    return machine_module(request.param)


def started(form: ModuleType, *words: int, tape: bytes = b"", ac: int = 0, **others: int) -> Any:
    machine = form.Machine()
    machine.load(dict(enumerate(words, 0o200)))
    machine.load({int(address.removeprefix("at_"), 8): word for address, word in others.items()})
    machine.teletype.reader.load(tape)
    machine.start(0o200)
    machine.ac = ac
    return machine


def step(machine: Any, ticks: int) -> None:
    """Run the processor alone to tick `ticks` since START, or to a halt."""
    processor = machine.processor
    while processor.run and machine.ticks < ticks:
        processor.instruction()


@pytest.mark.parametrize("wait", [(KSF, 0o5205), (0o5205,), (0o7000, 0o5205)])
def test_an_interrupt_is_not_waited_past(form: ModuleType, wait: tuple[int, ...]) -> None:
    """TLS, TSF, JMP .-1, KCC, ION, then any loop: the printer's flag is up, and interrupts at once."""
    program = (TLS, TSF, 0o5201, KCC, ION, *wait)
    machine, oracle = (started(form, *program, tape=b"abc", at_1=HLT) for _ in range(2))
    assert machine.run(seconds=1).reason == "halt"
    step(oracle, 20_000_000)
    assert machine.ticks == oracle.ticks < 1_700_000


def test_a_halt_in_a_ring_halts_every_time(form: ModuleType) -> None:
    machine = started(form, KSF, HLT, 0o5200)
    assert [machine.run().reason for _ in range(30)] == ["halt"] * 30


def test_time_that_passes_between_runs_is_no_turn(form: ModuleType) -> None:
    machine = started(form, KSF, 0o7000, 0o7000, 0o7000, 0o5200)
    machine.teletype.keyboard.press(b"AA")
    machine.run(instructions=43)
    machine.wait(0.001)
    before = machine.ticks
    machine.run(instructions=2000)
    assert machine.ticks - before == 400 * (85 + 4 * 32)


def test_the_clock_does_not_run_backwards(form: ModuleType) -> None:
    machine = started(form, 0o7000, 0o5200)
    machine.run()
    machine.wait(1)
    before = machine.ticks
    assert machine.run().reason == "idle"
    assert machine.ticks >= before


@pytest.mark.parametrize("keys", range(40, 45))
def test_a_jump_by_hand_is_no_turn(form: ModuleType, keys: int) -> None:
    machine = started(form, KSF, 0o7000, 0o7000, 0o7000, 0o5200)
    machine.teletype.keyboard.press(b"AA")
    machine.run(instructions=keys)
    machine.pc = 0o200
    before = machine.ticks
    machine.run(instructions=2000)
    assert machine.ticks - before == 400 * (85 + 4 * 32)


def test_limits_hold_in_any_year(form: ModuleType) -> None:
    for clock in (1 << 31, 1 << 32, (1 << 51) + 52, (1 << 53) - 5, 2 * 10**16):
        machine = started(form, 0o2210, 0o7000, 0o5200, 0o5200)
        machine.processor.clock = clock
        assert machine.run(instructions=10).reason == "limit"
        assert machine.instructions == 10
        assert machine.run(instructions=NEVER * 4, seconds=1e-4).reason == "limit"


def test_stop_from_whoever_sees_a_frame(form: ModuleType) -> None:
    """ISZ 210, JMP .-1, JMP .-2: it computes, and looks at the Teletype every 10 ms only."""
    machine = started(form, TLS, 0o2210, 0o5201, 0o5201, ac=0o301)
    machine.teletype.printer.on_frame = lambda frame: machine.stop()
    assert machine.run(seconds=DAY).reason == "stop key"
    assert 0.08 < machine.elapsed < 0.11
    assert machine.mb == machine.core[machine.ma]  # the lamps are those of the last instruction


def test_stop_between_two_slices(form: ModuleType) -> None:
    """The frame is printed in the very tick in which the first slice ends."""
    machine = started(form, TLS, 0o2210, 0o5201, 0o5201, ac=0o301)
    machine.teletype.printer.on_frame = lambda frame: machine.stop()
    assert machine.run(seconds=1_545_523 / 20e6).reason == "stop key"


@pytest.mark.parametrize("act", ["stop", "deposit", "jump"])
def test_a_flag_test_that_the_operator_interrupts(form: ModuleType, act: str) -> None:
    """TLS, KSF, JMP .-1: the printer's frame comes while it waits, and is seen in front of the KSF."""
    machine = started(
        form, TLS, KSF, 0o5201, 0o6036, 0o5201, tape=b"ab", ac=0o301, at_300=0o2310, at_301=0o5300
    )
    acts = {
        "stop": machine.stop,
        "deposit": lambda: machine.core.__setitem__(0o201, HLT),
        "jump": lambda: setattr(machine, "pc", 0o300),
    }
    machine.teletype.printer.on_frame = lambda frame: acts[act]()
    stop = machine.run(seconds=0.1)
    assert stop.reason == {"stop": "stop key", "deposit": "halt", "jump": "limit"}[act]
    assert (machine.elapsed < 0.09) == (act != "jump")
    if act == "jump":  # from some 0.082 s on it counts, 96 ticks a turn
        assert 3000 < machine.core[0o310] < 4000


@pytest.mark.parametrize("instructions", [2, 3, 4])
def test_start_is_no_turn(form: ModuleType, instructions: int) -> None:
    """NOP, TSF, HLT, NOP, JMP 200: the printer's flag is up until START clears it."""
    machine = started(form, 0o7000, TSF, HLT, 0o7000, 0o5200)
    machine.teletype.transmitter.flag = 1
    machine.run(instructions=instructions)
    machine.start(0o200)
    assert machine.run().reason == "halt"


@pytest.mark.parametrize("before", range(20, 60))
def test_switches_up_and_down_are_no_turn(form: ModuleType, before: int) -> None:
    """KSF, LAS, SZA CLA, SKP, JMP 200, NOP, JMP 200: by the switch register a turn is longer."""
    machines = []
    for _ in range(2):
        machine = started(form, KSF, 0o7604, 0o7640, 0o7410, 0o5200, 0o7000, 0o5200)
        machine.teletype.keyboard.press(b"AB")
        machines.append(machine)
    fast, alone = machines
    for sr, instructions in ((0, before), (1, 2), (0, 2000)):
        fast.sr = alone.sr = sr
        fast.run(instructions=instructions)
        for _ in range(instructions):
            alone.processor.instruction()
        assert (fast.ticks, fast.pc) == (alone.ticks, alone.pc)


@pytest.mark.parametrize("before", range(34_895, 34_910))
def test_a_jump_when_a_frame_is_seen_is_no_turn(form: ModuleType, before: int) -> None:
    machine = started(form, TLS, KSF, 0o7000, 0o7000, 0o7000, 0o5201, ac=0o301)
    machine.teletype.printer.on_frame = lambda frame: setattr(machine, "pc", 0o201)
    machine.run(instructions=before)
    ticks, pc = machine.ticks, machine.pc
    machine.run(instructions=2000)
    assert pc != 0o201 or machine.ticks - ticks == 400 * (85 + 4 * 32)


def test_a_word_put_in_by_whoever_sees_a_frame(form: ModuleType) -> None:
    program = (TLS, 0o7000, 0o7000, 0o7000, 0o2210, 0o5201, 0o5201)
    machine = started(form, *program, ac=0o301)
    machine.teletype.printer.on_frame = lambda frame: machine.core.__setitem__(0o203, HLT)
    assert machine.run(seconds=2).reason == "halt"
    assert 0.08 < machine.elapsed < 0.11


def test_mem_prot_thrown_by_whoever_sees_a_frame(form: ModuleType) -> None:
    machine = started(form, TLS, 0o2210, 0o3420, 0o5201, ac=0o301, at_20=0o7700)
    machine.teletype.printer.on_frame = lambda frame: setattr(machine.panel, "mem_prot", True)
    assert machine.run(seconds=2).reason == "protect"
    assert 0.08 < machine.elapsed < 0.11


def test_an_exception_of_whoever_sees_a_frame_loses_no_frame(form: ModuleType) -> None:
    """TLS, TSF, JMP .-1, CLA, TAD 220, TLS, TSF, JMP .-1, HLT."""
    program = (TLS, TSF, 0o5201, 0o7200, 0o1220, TLS, TSF, 0o5206, HLT)
    machine = started(form, *program, ac=0o101, at_220=0o102)
    raised: list[int] = []

    def refuse(frame: int) -> None:
        if not raised:
            raised.append(frame)
            raise RuntimeError("once")

    machine.teletype.printer.on_frame = refuse
    with pytest.raises(RuntimeError, match="once"):
        machine.run()
    assert machine.run().reason == "halt"
    assert bytes(machine.teletype.printer.frames) == machine.teletype.punch.tape == b"AB"


@pytest.mark.parametrize("seed", range(60))
def test_nothing_is_passed_over_that_happens(form: ModuleType, seed: int) -> None:
    """Nonsense with flags, tapes and interrupts, run in slices, and by the processor alone."""
    draw = random.Random(seed)
    words, tape = random_program(draw), draw.randbytes(20)
    words |= {
        0: 0,
        1: draw.choice((0o5001, 0o6036, 0o6042, 0o7000)),
        2: draw.choice((ION, 0o7000)),
        3: 0o5400,
    }
    words |= {0o200: draw.choice((TLS, KCC)), 0o201: draw.choice((ION, 0o7000, TLS))}
    machines = []
    for _ in range(2):
        machine = form.Machine()
        machine.load(words)
        machine.teletype.reader.load(tape)
        machine.start(0o200)
        machines.append(machine)
    fast, alone = machines
    for _ in range(20):
        stop = fast.run(seconds=draw.choice((1e-4, 1e-3, 0.03)))
        step(alone, fast.ticks)
        assert (fast.ticks, fast.instructions) == (alone.ticks, alone.instructions)
        assert (fast.pc, fast.processor.lac) == (alone.pc, alone.processor.lac)
        assert list(fast.core) == list(alone.core)
        if stop.reason != "limit":
            break
