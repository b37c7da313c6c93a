"""A tape says of a doubtful frame what it must be: for each code a hole taken away or put in is found."""

import pytest

from tapes import convert, redundancy, shelf
from tapes.frames import with_parity

BIN = shelf.read("eia.bin")
TAPES = {
    "bin": BIN,
    "rim": b"\0" + convert.convert(BIN, "bin", "rim", "mark", None),
    "eia": shelf.read("circle.eia"),
    "mark": shelf.read("circle.asc"),
    "even": with_parity(shelf.read("circle.asc"), "even"),
    "none": with_parity(shelf.read("circle.asc"), "none"),
}
FAULTS = {
    "bin": (0o004, "the checksum"),
    "rim": (0o100, "RIM's order"),
    "eia": (0o004, "EIA's odd holes"),
    "mark": (0o200, "the tape's parity, mark"),
    "even": (0o004, "the tape's parity, even"),
    "none": (0o200, "the tape's parity, none"),
}
"""A channel in which the code shows a fault, and by what."""


@pytest.mark.parametrize("code", TAPES)
def test_a_fault_in_a_doubtful_channel_is_mended_and_a_reversed_tape_found_out(code: str) -> None:
    tape, (bit, by) = TAPES[code], FAULTS[code]
    seen = bytearray(tape)
    seen[100] ^= bit
    assert redundancy.propose(bytes(seen), {100: bit, 121: 0o003}) == ({100: tape[100]}, by)
    assert redundancy.propose(tape, {100: 0o377, 120: 0o377})[0] == {}
    assert [redundancy.looks_reversed(each) for each in (tape, tape[::-1], b"\3\6\5")] == [False, True, False]


def test_a_good_tape_stays_though_two_holes_could_change_places() -> None:
    ones, noughts = ([at for at in range(70, 120) if BIN[at] & 1 == bit] for bit in (1, 0))
    assert redundancy.propose(BIN, {ones[0]: 1, noughts[0]: 1}) == ({}, "")


def test_nothing_is_proposed_where_several_values_fit() -> None:
    seen = bytearray(TAPES["even"])
    seen[100] ^= 0o004
    assert redundancy.propose(bytes(seen), {100: 0o017})[0] == {}


@pytest.mark.parametrize("faults", [3, 4])
def test_of_a_bin_tape_no_more_than_three_faults_are_mended(faults: int) -> None:
    doubtful = {100 + at: 1 << at for at in range(faults)}
    seen = bytearray(BIN)
    for at, bit in doubtful.items():
        seen[at] ^= bit
    found = {at: BIN[at] for at in doubtful}
    assert redundancy.propose(bytes(seen), doubtful)[0] == (found if faults == 3 else {})
