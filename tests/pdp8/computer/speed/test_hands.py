"""What a run may not overlook: hands in the middle of it, of whoever sees a frame; and limits in any year."""

from collections.abc import Callable
from functools import partial

import pytest

from tests.pdp8.computer.bench import machine
from tests.pdp8.computer.speed.forms import FORMS
from tests.reference.model import NEVER

pytestmark = pytest.mark.parametrize("form", FORMS)
HLT = 0o7402
COUNTS = "6046 2210 5201 5201"
"""TLS, ISZ 210, JMP .-1, JMP .-2: it computes, and looks at the Teletype every 10 ms only."""
A = 0o301


def test_limits_hold_in_any_year(form: str) -> None:
    for clock in (1 << 31, 1 << 32, (1 << 51) + 52, (1 << 53) - 5, 2 * 10**16):
        m = machine("2210 7000 5200 5200", form=form)
        m.processor.clock = clock
        assert m.run(instructions=10).reason == "limit"
        assert m.instructions == 10
        assert m.run(instructions=NEVER * 4, seconds=1e-4).reason == "limit"


@pytest.mark.parametrize("seconds", [24 * 3600.0, 1_545_523 / 20e6])
def test_stop_from_whoever_sees_a_frame(form: str, seconds: float) -> None:
    """Also where the frame is printed in the very tick in which the run ends, or a slice of it."""
    m = machine(COUNTS, form=form, ac=A)
    m.teletype.printer.on_frame = lambda frame: m.stop()
    assert m.run(seconds).reason == "stop key"
    assert 0.07 < m.elapsed < 0.11
    assert m.mb == m.core[m.ma]  # the lamps are those of the last instruction


@pytest.mark.parametrize(
    ("act", "reason"), [("stop", "stop key"), ("deposit", "halt"), ("jump", "limit"), ("mem prot", "limit")]
)
def test_a_flag_test_that_the_operator_interrupts(form: str, act: str, reason: str) -> None:
    """TLS, KSF, JMP .-1: the printer's frame comes while it waits, and is seen in front of the KSF."""
    m = machine("6046 6031 5201 6036 5201 300/ 2310 5300", b"ab", form=form, ac=A)
    acts: dict[str, Callable[[], object]] = {
        "stop": m.stop,
        "deposit": partial(m.core.__setitem__, 0o201, HLT),
        "jump": partial(setattr, m, "pc", 0o300),
        "mem prot": partial(setattr, m.panel, "mem_prot", True),
    }
    m.teletype.printer.on_frame = lambda frame: acts[act]()
    assert m.run(seconds=0.1).reason == reason
    assert (m.elapsed < 0.09) == (reason != "limit")
    if act == "jump":  # from some 0.082 s on it counts, 96 ticks a turn
        assert 3000 < m.core[0o310] < 4000


def test_a_jump_when_a_frame_is_seen_is_no_turn(form: str) -> None:
    for before in range(34_895, 34_910):
        m = machine("6046 6031 7000 7000 7000 5201", form=form, ac=A)
        m.teletype.printer.on_frame = lambda frame, m=m: setattr(m, "pc", 0o201)
        m.run(instructions=before)
        ticks, pc = m.ticks, m.pc
        m.run(instructions=2000)
        assert pc != 0o201 or m.ticks - ticks == 400 * (85 + 4 * 32), before


@pytest.mark.parametrize("what", ["a word", "MEM PROT"])
def test_what_whoever_sees_a_frame_does_to_a_program_that_computes(form: str, what: str) -> None:
    m = machine("6046 2210 3420 7000 5201 5201 20/ 7700", form=form, ac=A)
    if what == "a word":
        m.teletype.printer.on_frame = lambda frame: m.core.__setitem__(0o203, HLT)
    else:
        m.teletype.printer.on_frame = lambda frame: setattr(m.panel, "mem_prot", True)
    assert m.run(seconds=2).reason == ("halt" if what == "a word" else "protect")
    assert 0.08 < m.elapsed < 0.11


def test_an_exception_of_whoever_sees_a_frame_loses_no_frame(form: str) -> None:
    """TLS, TSF, JMP .-1, CLA, TAD 220, TLS, TSF, JMP .-1, HLT."""
    m = machine("6046 6041 5201 7200 1220 6046 6041 5206 7402 220/ 102", form=form, ac=0o101)
    raised: list[int] = []

    def refuse(frame: int) -> None:
        if not raised:
            raised.append(frame)
            raise RuntimeError("once")

    m.teletype.printer.on_frame = refuse
    with pytest.raises(RuntimeError, match="once"):
        m.run()
    assert m.run().reason == "halt"
    assert bytes(m.teletype.printer.frames) == m.teletype.punch.tape == b"AB"
