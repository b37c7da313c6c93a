"""The PC8/L: 300 characters a second in, 50 out."""

import pytest

from pdp8.computer.machine import Machine
from tests.pdp8.computer.bench import octal


def machine(words: str, tape: bytes = b"") -> Machine:
    made = Machine(highspeed=True)
    made.load(dict(enumerate(octal(words), 0o200)))
    made.highspeed.reader.load(tape)
    made.start(0o200)
    return made


def test_a_copy_goes_at_the_pace_of_the_punch() -> None:
    # RFC; RSF; JMP .-1; RRB RFC; PLS; PSF; JMP .-1; CLA; JMP 0201
    m = machine("6014 6011 5201 6016 6026 6021 5205 7200 5201", bytes(range(256)))
    stop = m.run()
    assert stop.reason == "tape out"
    assert m.highspeed.punch.tape == bytes(range(256))
    assert m.elapsed == pytest.approx(256 / 50 + 1 / 300, abs=256 * 40e-6)


def test_reading_alone_is_300_a_second_less_the_programs_own_time() -> None:
    m = machine("6014 6011 5201 6016 7200 5201", bytes(300))
    assert m.run().reason == "tape out"
    assert (m.highspeed.reader.position, m.highspeed.fitted) == (300, True)
    assert 1 < m.elapsed < 1.02


def test_a_halt_lets_the_punch_finish_once() -> None:
    m = machine("7604 6026 7402 6021 5203 7402")
    m.sr = 0o101
    m.run()
    assert m.highspeed.punch.tape == b"\101"
    m.run()
    assert m.highspeed.punch.tape == b"\101"
