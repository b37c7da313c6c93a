"""Passing over what only waits is exact, and makes no difference to how and when a run ends."""

import signal
import sys
from types import FrameType, ModuleType
from typing import Any

import pytest

from tests.pdp8.computer.speed.forms import FORMS, machine_module

# TLS; KSF; JMP .-1; KRB; DCA HOLD; TSF; JMP .-1; TAD HOLD; TLS; CLA CLL; JMP 0201
COPY = (0o6046, 0o6031, 0o5201, 0o6036, 0o3220, 0o6041, 0o5205, 0o1220, 0o6046, 0o7300, 0o5201)
# ISZ 0220; JMP .-1; ISZ 0221; JMP .-3; HLT
DELAY = (0o2220, 0o5200, 0o2221, 0o5200, 0o7402)


@pytest.fixture(params=FORMS)
def form(request: pytest.FixtureRequest) -> ModuleType:
    return machine_module(request.param)


def started(form: ModuleType, words: tuple[int, ...], tape: bytes = b"") -> Any:
    machine = form.Machine()
    machine.load(dict(enumerate(words, 0o200)))
    machine.teletype.reader.load(tape)
    machine.start(0o200)
    return machine


def test_a_delay_loop_counts_all_its_turns(form: ModuleType) -> None:
    """4096 turns of ISZ, JMP .-1 (the last of them skips), then one of ISZ, JMP .-3, 4096 times; HLT."""
    machine = started(form, DELAY)
    assert machine.run().reason == "halt"
    turns = 4096 * (4096 * 96 - 32) + 4096 * 96 - 32
    assert (machine.ticks, machine.instructions) == (turns + 32, 4096 * 8191 + 8191 + 1)


def test_delays_can_be_left_to_run(form: ModuleType) -> None:
    machines = [started(form, DELAY), started(form, DELAY)]
    machines[1].engine.delays = False
    for machine in machines:
        machine.core[0o221] = 0o7770
        assert machine.run().reason == "halt"
    assert machines[0].ticks == machines[1].ticks
    assert machines[0].instructions == machines[1].instructions == 8 * 8191 + 8 + 7 + 1


def test_eight_hours_of_1971() -> None:
    """A working day of copying tape, 10 frames a second to the last one."""
    copied(machine_module("compiled"), 8 * 3600 * 10)


def test_five_minutes_of_1971() -> None:
    """The same without the help of a compiler."""
    copied(machine_module("plain"), 300 * 10)


def copied(form: ModuleType, frames: int) -> None:
    """Copy a tape of `frames` and account for every instruction and every tick.

    A character is 8 instructions in 532 ticks; what is left are turns of waiting, 2 instructions in 117.
    """
    machine = started(form, COPY, bytes(frames))
    stop = machine.run()
    assert (stop.reason, stop.pc) == ("tape out", 0o201)
    assert len(machine.teletype.punch.tape) == frames + 1
    turns, rest = divmod(machine.instructions - 1 - 8 * frames, 2)
    assert rest == 0
    assert machine.ticks == 85 + 532 * frames + 117 * turns
    assert machine.elapsed == pytest.approx(frames / 10, abs=0.2)


@pytest.mark.skipif(sys.platform == "win32", reason="no SIGALRM there")
@pytest.mark.parametrize("delays", [True, False])
def test_a_signal_gets_through_to_a_run_without_end(form: ModuleType, delays: bool) -> None:
    """ISZ, JMP .-1, JMP .-2 counts for ever; no limit is given."""

    def interrupt(number: int, frame: FrameType | None) -> None:
        raise KeyboardInterrupt

    machine = started(form, (0o2220, 0o5200, 0o5200))
    machine.engine.delays = delays
    before = signal.signal(signal.SIGALRM, interrupt)
    signal.setitimer(signal.ITIMER_REAL, 0.1)
    try:
        with pytest.raises(KeyboardInterrupt):
            machine.run()
    finally:
        signal.signal(signal.SIGALRM, before)
    assert machine.ticks > 0
