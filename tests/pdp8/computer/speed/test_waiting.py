"""What is passed over is passed over exactly, and a run that cannot go on says why."""

import pytest

from tests.pdp8.computer.bench import machine, octal, program

COPY = "6031 5200 6036 6046 6041 5204 5200"
# KSF, SKP, JMP read, TSF, JMP ., TCF, JMP ., read: KRB, TLS, JMP .
RING = "6031 7410 5207 6041 5200 6042 5200 6036 6046 5200"


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
        ("halt", "7402", None),
        ("tape out", COPY, b"\301\302"),
        ("tape out", RING, b"\301\302"),
    ],
)
def test_why_a_run_ends(reason: str, words: str, tape: bytes | None) -> None:
    core = dict(enumerate(octal(words), 0o200))
    m = machine(core)
    if tape is not None:
        m.teletype.reader.load(tape)
    assert m.run(seconds=5).reason == reason
    assert m.elapsed < 0.001 or words != "5200"
    if words in (COPY, RING):
        assert m.teletype.punch.tape == tape


@pytest.mark.parametrize("words", ["7200 5200", "7000 " * 100 + "5200", ""])
def test_a_ring_that_only_goes_round_is_endless(words: str) -> None:
    # CLA, JMP .-1; a long way round; and empty core, 4096 times AND 0.
    m = program(*octal(words))
    assert m.run(seconds=1).reason == "idle"
    assert m.elapsed < 0.05


def test_a_tape_out_waits_until_the_last_frame_is_punched() -> None:
    m = program(*octal("6031 5200 6036 6046 5200"))
    m.teletype.reader.load(b"\301")
    stop = m.run()
    assert m.teletype.punch.tape == b"\301"
    assert stop.elapsed == pytest.approx((1_545_455 + 1_636_364) / 20e6, abs=50e-6)


def test_a_tape_that_was_taken_out_does_not_run_out() -> None:
    m = program(*octal("6031 5200"))
    m.teletype.reader.load(b"")
    m.teletype.reader.remove()
    assert m.run().reason == "idle"


def test_a_count_is_not_endless() -> None:
    assert program(*octal("7001 5200")).run(seconds=0.05).reason == "limit"
    m = program(*octal("2210 5200 2211 5200 7402"))
    m.core[0o211] = -20
    assert m.run(seconds=10).reason == "halt"
