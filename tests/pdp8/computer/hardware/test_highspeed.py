"""The PC8/L: 300 characters a second in, 50 out."""

import pytest

from tests.pdp8.computer.bench import machine


def test_a_copy_goes_at_the_pace_of_the_punch() -> None:
    # RFC; RSF; JMP .-1; RRB RFC; PLS; PSF; JMP .-1; CLA; JMP 0201
    tape = bytes(range(256))
    m = machine("6014 6011 5201 6016 6026 6021 5205 7200 5201", tape, highspeed=True)
    assert m.run().reason == "tape out"
    assert m.highspeed.punch.tape == tape
    assert m.elapsed == pytest.approx(256 / 50 + 1 / 300, abs=256 * 40e-6)


def test_reading_alone_is_300_a_second_less_the_programs_own_time() -> None:
    m = machine("6014 6011 5201 6016 7200 5201", bytes(300), highspeed=True)
    assert m.run().reason == "tape out"
    assert (m.highspeed.reader.position, m.highspeed.fitted) == (300, True)
    assert 1 < m.elapsed < 1.02


def test_a_halt_lets_the_punch_finish_once() -> None:
    """LAS, PLS, HLT, then PSF, JMP .-1, HLT."""
    m = machine("7604 6026 7402 6021 5203 7402", highspeed=True, sr=0o101)
    for _ in range(2):
        m.run()
        assert m.highspeed.punch.tape == b"\101"


def test_a_tape_put_in_after_rfc_takes_its_time_from_then() -> None:
    """RFC at once, RSF, JMP .-1, HLT; the tape 3 ms later: a frame takes 3.3 ms."""
    m = machine("6014 6011 5201 7402", highspeed=True)
    m.run(seconds=0.003)
    at = m.ticks
    m.highspeed.reader.load(b"a")
    assert m.run().reason == "halt"
    assert 66_667 <= m.ticks - at < 66_667 + 300
