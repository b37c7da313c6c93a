"""What is passed over is passed over exactly, and makes no difference to how and when a run ends."""

import signal
import sys
from types import FrameType

import pytest

from tests.pdp8.computer.bench import machine
from tests.pdp8.computer.speed.forms import FORMS

COPY = "6031 5200 6036 6046 6041 5204 5200"
# KSF, SKP, JMP read, TSF, JMP ., TCF, JMP ., read: KRB, TLS, JMP .
RING = "6031 7410 5207 6041 5200 6042 5200 6036 6046 5200"
FAST = "6014 6011 5201 5200"  # RFC, RSF, JMP .-1, JMP 0200
COUNT = "2220 5200 2221 5200 7402"  # ISZ 0220; JMP .-1; ISZ 0221; JMP .-3; HLT


@pytest.mark.parametrize(
    ("reason", "words", "tape"),
    [
        ("tape out", "6031 5200 6036 5200", b"\301\302"),  # KSF, JMP .-1, KRB
        ("tape out", "6031 5200 6036 5200", b""),  # an empty tape
        ("idle", "6031 5200 6036 5200", None),  # no tape at all: nothing was asked of the reader's owner
        ("idle", "5200", None),  # JMP .
        ("idle", "5200", b""),  # JMP . does not wait for the reader
        ("idle", "6031 5200 6036 5203", b"\301"),  # nor after what did
        ("idle", "6041 5200", b"\301"),  # TSF before anything was printed
        ("tape out", "6001 5201", b""),  # under interrupt it does
        ("idle", "6001 5201", None),
        ("idle", "4210 5200 0 0 0 0 0 0 0 5610", None),  # a subroutine that writes the same word again
        ("idle", "7200 5200", None),  # CLA, JMP .-1
        ("idle", "7000 " * 100 + "5344", None),  # a long way round
        ("idle", "", None),  # empty core, 4096 times AND 0
        ("limit", "7001 5200", None),  # a count in AC
        ("halt", "2210 5200 2211 5200 7402 211/ 7754", None),
        ("halt", "7402", None),
        ("tape out", COPY, b"\301\302"),
        ("tape out", RING, b"\301\302"),
        ("tape out", FAST, b"\301\302"),
        ("idle", FAST, None),
    ],
)
def test_why_a_run_ends(reason: str, words: str, tape: bytes | None) -> None:
    m = machine(words, tape, highspeed=words == FAST)
    assert m.run(seconds=5).reason == reason
    if words in (COPY, RING):
        assert m.teletype.punch.tape == tape
    if reason == "idle" and tape is None:
        assert m.elapsed < 0.05
    if words == "5200":
        assert m.elapsed < 0.001
    if words == "7200 5200":
        assert m.ticks == 200_000 + 64  # it is looked at after 10 ms, and does one turn more


def test_a_loop_after_a_wait_is_looked_at_at_the_same_ticks() -> None:
    """TLS, TSF, JMP .-1, then CLA, JMP .-1: every 10 ms of machine time."""
    m = machine("6046 6041 5201 7200 5203")
    assert m.run().reason == "idle"
    assert 0 < m.ticks % 200_000 < 200


def test_a_tape_that_was_taken_out_does_not_run_out() -> None:
    m = machine("6031 5200", b"")
    m.teletype.reader.remove()
    assert m.run().reason == "idle"


@pytest.mark.parametrize("form", FORMS)
@pytest.mark.parametrize("delays", [True, False])
def test_a_delay_loop_counts_all_its_turns(form: str, delays: bool) -> None:
    """4096 turns of ISZ, JMP .-1, the last of which skips, then one of ISZ, JMP .-3: so often; HLT."""
    times = 4096 if delays else 8
    m = machine(f"{COUNT} 221/ {-times & 0o7777:o}", form=form)
    m.engine.delays = delays
    assert m.run().reason == "halt"
    turns = times * (4096 * 96 - 32) + times * 96 - 32
    assert (m.ticks, m.instructions) == (turns + 32, times * 8191 + 2 * times - 1 + 1)


@pytest.mark.skipif(sys.platform == "win32", reason="no SIGALRM there")
@pytest.mark.parametrize("form", FORMS)
@pytest.mark.parametrize("delays", [True, False])
def test_a_signal_gets_through_to_a_run_without_end(form: str, delays: bool) -> None:
    """ISZ, JMP .-1, JMP .-2 counts for ever; no limit is given."""

    def interrupt(number: int, frame: FrameType | None) -> None:
        raise KeyboardInterrupt

    m = machine("2220 5200 5200", form=form)
    m.engine.delays = delays
    before = signal.signal(signal.SIGALRM, interrupt)
    signal.setitimer(signal.ITIMER_REAL, 0.1)
    try:
        with pytest.raises(KeyboardInterrupt):
            m.run()
    finally:
        signal.signal(signal.SIGALRM, before)
    assert m.ticks > 0
