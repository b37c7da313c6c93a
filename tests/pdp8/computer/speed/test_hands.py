"""What a run may not overlook: hands in the middle of it, of whoever sees a frame; and limits in any year."""

from types import ModuleType
from typing import Any

import pytest

from tests.pdp8.computer.speed.forms import FORMS, machine_module
from tests.reference.model import NEVER

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


def test_a_jump_when_a_frame_is_seen_is_no_turn(form: ModuleType) -> None:
    for before in range(34_895, 34_910):
        machine = started(form, TLS, KSF, 0o7000, 0o7000, 0o7000, 0o5201, ac=0o301)
        machine.teletype.printer.on_frame = lambda frame, machine=machine: setattr(machine, "pc", 0o201)
        machine.run(instructions=before)
        ticks, pc = machine.ticks, machine.pc
        machine.run(instructions=2000)
        assert pc != 0o201 or machine.ticks - ticks == 400 * (85 + 4 * 32), before


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
