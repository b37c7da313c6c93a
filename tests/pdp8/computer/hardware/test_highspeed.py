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


def test_it_reads_nothing_before_rfc() -> None:
    m = machine("6011 5200", b"\1")
    assert m.run().reason == "idle"
    assert m.highspeed.reader.position == 0


def test_rrb_ors_and_rfc_empties_the_buffer() -> None:
    m = machine("6014 6011 5201 6012 6014 6012 7402", b"\125\252")
    m.ac = 0o7000
    assert m.run().reason == "halt"
    assert m.ac == 0o7125


def test_a_second_rfc_starts_no_second_frame() -> None:
    m = machine("6014 6014 6011 5202 7402", b"\125\252")
    m.run()
    assert m.highspeed.reader.position == 1
    assert m.ticks == pytest.approx(65 + 66_667, abs=300)


def test_ppc_ors_into_what_is_not_cleared() -> None:
    # LAS; PPC; PSF; JMP .-1; CLA; TAD 0020; PPC; PSF ... the flag is still up, so wait with the delay of
    # another PLS
    m = machine("7604 6026 6021 5202 7240 0220 6022 6024 6024 6021 5211 7402")
    m.sr = 0o101
    m.core[0o220] = 0o002
    assert m.run().reason == "halt"
    assert m.highspeed.punch.tape == bytes([0o101, 0o002])


def test_a_halt_lets_the_punch_finish_once() -> None:
    m = machine("7604 6026 7402 6021 5203 7402")
    m.sr = 0o101
    m.run()
    assert m.highspeed.punch.tape == b"\101"
    m.run()
    assert m.highspeed.punch.tape == b"\101"
