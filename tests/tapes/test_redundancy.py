"""A tape says of a doubtful frame what it must be: for each code a hole taken away or put in is found."""

import pytest

from tapes import convert, redundancy, shelf
from tapes.frames import with_parity

BIN = shelf.read("eia.bin")
TAPES = {
    "bin": BIN,
    "rim": convert.convert(BIN, "bin", "rim", "mark", None),
    "eia": shelf.read("circle.eia"),
    "mark": shelf.read("circle.asc"),
    "even": with_parity(shelf.read("circle.asc"), "even"),
    "none": with_parity(shelf.read("circle.asc"), "none"),
}
CHANNEL = {"bin": 0o004, "rim": 0o100, "eia": 0o004, "mark": 0o200, "even": 0o004, "none": 0o200}
"""One in which the code shows a fault."""


@pytest.mark.parametrize("code", TAPES)
def test_a_fault_in_a_doubtful_channel_is_mended(code: str) -> None:
    tape, bit = TAPES[code], CHANNEL[code]
    seen = bytearray(tape)
    seen[100] ^= bit
    found, by = redundancy.propose(bytes(seen), {100: bit, 121: 0o003})
    assert found == {100: tape[100]}
    assert by


@pytest.mark.parametrize("code", TAPES)
def test_nothing_is_proposed_for_a_good_tape(code: str) -> None:
    assert redundancy.propose(TAPES[code], {100: 0o377, 120: 0o377})[0] == {}


def test_nothing_is_proposed_where_several_values_fit() -> None:
    seen = bytearray(TAPES["even"])
    seen[100] ^= 0o004
    assert redundancy.propose(bytes(seen), {100: 0o017})[0] == {}


@pytest.mark.parametrize("code", TAPES)
def test_a_tape_read_from_its_end_is_found_out(code: str) -> None:
    assert not redundancy.looks_reversed(TAPES[code])
    assert redundancy.looks_reversed(TAPES[code][::-1])
