"""A tape says of a doubtful frame what it must be: for each code a hole taken away or put in is found."""

import pytest

from tapes import convert, eia, redundancy, shelf
from tapes.frames import with_parity
from tests.tapes.strips import FORMAT_BIN, LEADER

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
    "bin": (100, 0o004, "the checksum"),
    "rim": (101, 0o100, "RIM's order"),
    "eia": (100, 0o004, "EIA's odd holes"),
    "mark": (100, 0o200, "the tape's parity, mark"),
    "even": (100, 0o004, "the tape's parity, even"),
    "none": (100, 0o200, "the tape's parity, none"),
}
"""A frame, a channel in which the code shows a fault there, and by what."""


@pytest.mark.parametrize("code", TAPES)
def test_a_fault_in_a_doubtful_channel_is_mended(code: str) -> None:
    tape, (at, bit, by) = TAPES[code], FAULTS[code]
    seen = bytearray(tape)
    seen[at] ^= bit
    assert redundancy.propose(bytes(seen), {at: bit, 121: 0o003}) == ({at: tape[at]}, by)
    assert redundancy.propose(tape, {at: 0o377, 120: 0o377})[0] == {}


BLANKS = TAPES["eia"][:90].replace(b"\x20", b"\0")
"""Four blocks, whose zeros are blank frames, as a Hydra-Point may have them."""
TORN = FORMAT_BIN[:121] + b"\x42" + LEADER
"""BIN from either end; from this one it goes on for longer."""


@pytest.mark.parametrize("tape", [*TAPES.values(), BLANKS, TORN], ids=[*TAPES, "blanks", "torn"])
def test_a_tape_read_from_its_end_is_found_out(tape: bytes) -> None:
    assert not redundancy.looks_reversed(tape)
    assert redundancy.looks_reversed(tape[::-1])


@pytest.mark.parametrize("tape", [b"\x83\6\5", eia.encode("0" * 19 + "\n"), TAPES["eia"][:90] + b"\3\x80"])
def test_a_tape_without_order_says_nothing(tape: bytes) -> None:
    assert not redundancy.looks_reversed(tape)


def test_a_good_tape_stays_and_one_of_no_known_code() -> None:
    assert redundancy.propose(b"\x83\6\5", {0: 0o200}) == ({}, "")
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
