"""A tape says of a doubtful frame what it must be: for each code a hole taken away or put in is found."""

import pytest

from pdp8 import shelf
from tapes import convert, eia, redundancy
from tapes.frames import with_parity
from tests.tapes.strips import FORMAT_BIN, LEADER

BIN, CIRCLE, EIA = map(shelf.read, ("eia.bin", "circle.asc", "circle.eia"))
EVEN = with_parity(CIRCLE, "even")
RIM = b"\0" + convert.convert(BIN, "bin", "rim", "mark", None)

FAULTS = {
    "bin": (BIN, 100, 0o004, "the checksum"),
    "rim": (RIM, 101, 0o100, "RIM's order"),
    "eia": (EIA, 100, 0o004, "EIA's code, of odd holes"),
    "mark": (CIRCLE, 100, 0o200, "the tape's parity, mark"),
    "even": (EVEN, 100, 0o004, "the tape's parity, even"),
    "none": (with_parity(CIRCLE, "none"), 100, 0o200, "the tape's parity, none"),
}
"""A tape, a frame of it, a channel in which its code shows a fault there, and by what."""


@pytest.mark.parametrize(("tape", "at", "bit", "by"), FAULTS.values(), ids=FAULTS)
def test_a_fault_in_a_doubtful_channel_is_mended(tape: bytes, at: int, bit: int, by: str) -> None:
    seen = bytearray(tape)
    seen[at] ^= bit
    assert redundancy.propose(bytes(seen), {at: bit, 121: 0o003}) == ({at: tape[at]}, by)
    assert redundancy.propose(tape, {at: 0o377, 120: 0o377})[0] == {}


TAPES = {code: tape for code, (tape, *_) in FAULTS.items()} | {
    # four blocks, whose zeros are blank frames, as a Hydra-Point may have them
    "blanks": EIA[:90].replace(b"\x20", b"\0"),
    # BIN from either end; from this one it goes on for longer
    "torn": FORMAT_BIN[:121] + b"\x42" + LEADER,
}


@pytest.mark.parametrize("tape", TAPES.values(), ids=TAPES)
def test_a_tape_read_from_its_end_is_found_out(tape: bytes) -> None:
    assert not redundancy.looks_reversed(tape)
    assert redundancy.looks_reversed(tape[::-1])


@pytest.mark.parametrize("tape", [b"\x83\6\5", eia.encode("0" * 19 + "\n"), EIA[:90] + b"\3\x80"])
def test_a_tape_without_order_says_nothing(tape: bytes) -> None:
    assert not redundancy.looks_reversed(tape)


def test_a_good_tape_stays_and_one_of_no_known_code() -> None:
    assert redundancy.propose(b"\x83\6\5", {0: 0o200}) == ({}, "")
    ones, noughts = ([at for at in range(70, 120) if BIN[at] & 1 == bit] for bit in (1, 0))
    assert redundancy.propose(BIN, {ones[0]: 1, noughts[0]: 1}) == ({}, "")


def test_nothing_is_proposed_where_several_values_fit() -> None:
    seen = bytearray(EVEN)
    seen[100] ^= 0o004
    assert redundancy.propose(bytes(seen), {100: 0o017})[0] == {}


def test_nothing_is_proposed_where_two_mends_give_the_checksum() -> None:
    ones = [at for at in range(70, 120) if BIN[at] & 1]
    seen = bytearray(BIN)
    seen[ones[0]] ^= 1
    assert redundancy.propose(bytes(seen), {ones[0]: 1})[0] == {ones[0]: BIN[ones[0]]}
    noughts = [at for at in range(70, 120) if not BIN[at] & 1]
    assert redundancy.propose(bytes(seen), {ones[0]: 1, noughts[0]: 1}) == ({}, "")


@pytest.mark.parametrize("channels", [24, 25])
def test_of_a_bin_tape_no_more_than_24_channels_are_tried(channels: int) -> None:
    seen = bytearray(BIN)
    seen[100] ^= 0o004
    others = [(at, bit) for at in range(101, 107) for bit in (0o001, 0o002, 0o010, 0o020, 0o040)]
    doubtful = {100: 0o004}
    for at, bit in others[: channels - 1]:
        doubtful[at] = doubtful.get(at, 0) | bit
    assert redundancy.propose(bytes(seen), doubtful)[0] == ({100: BIN[100]} if channels == 24 else {})


def test_a_value_is_proposed_of_those_that_have_a_code() -> None:
    """Blank tape has one; 203 has none."""
    seen = bytearray(EIA)
    seen[100] = 0
    assert redundancy.propose(bytes(seen), {100: 0o004})[0] == {}
    seen[100] = 0o003
    assert redundancy.propose(bytes(seen), {100: 0o201})[0] == {100: 0o002}


@pytest.mark.parametrize("faults", [3, 4])
def test_of_a_bin_tape_no_more_than_three_faults_are_mended(faults: int) -> None:
    doubtful = {100 + at: 1 << at for at in range(faults)}
    seen = bytearray(BIN)
    for at, bit in doubtful.items():
        seen[at] ^= bit
    found = {at: BIN[at] for at in doubtful}
    assert redundancy.propose(bytes(seen), doubtful)[0] == (found if faults == 3 else {})


@pytest.mark.parametrize(("tape", "at", "bit", "by"), FAULTS.values(), ids=FAULTS)
def test_a_fault_in_a_sure_frame_is_doubtful_and_hides_no_other(
    tape: bytes, at: int, bit: int, by: str
) -> None:
    """The channel that is nearest to being the other is named; a doubtful frame is mended all the same."""
    seen = bytearray(tape)
    seen[at] ^= bit
    weakest = [(0.4, 0o001)] * len(seen)
    weakest[at] = 0.26, bit
    assert redundancy.contradict(bytes(seen), {}, weakest) == ({at: bit}, by)
    assert redundancy.contradict(tape, {}, weakest)[0] == {}
    assert redundancy.propose(bytes(seen), {at: bit}) == ({at: tape[at]}, by)
    if by != "the checksum":
        seen[at + 28] ^= bit
        assert redundancy.contradict(bytes(seen), {at + 28: bit}, weakest) == ({at: bit}, by)
        assert redundancy.propose(bytes(seen), {at: bit, at + 28: bit})[0] == {
            at: tape[at],
            at + 28: tape[at + 28],
        }
    else:
        assert redundancy.contradict(bytes(seen), {at + 28: bit}, weakest) == ({}, "")


def test_a_rule_that_more_than_a_tenth_breaks_is_none() -> None:
    tape = bytearray(with_parity(CIRCLE[:270], "even"))
    weakest = [(0.4, 0o001)] * len(tape)
    for at in range(0, 200, 14):
        tape[at] ^= 0o200
    wrong, _ = redundancy.contradict(bytes(tape), {}, weakest)
    assert len(wrong) >= 10
    for at in range(7, 200, 14):
        tape[at] ^= 0o200
    assert redundancy.contradict(bytes(tape), {}, weakest)[0] == {}
    shifted = RIM[:201] + b"\0" + RIM[201:]
    assert redundancy.contradict(shifted, {}, [(0.4, 0o001)] * len(shifted)) == ({}, "")


@pytest.mark.parametrize("tape", [BIN, EIA])
def test_a_tape_is_turned_as_it_lies(tape: bytes) -> None:
    ways = {
        "": tape,
        redundancy.REVERSE: tape[::-1],
        redundancy.MIRROR: redundancy.mirrored(tape),
        f"{redundancy.REVERSE} {redundancy.MIRROR}": redundancy.mirrored(tape[::-1]),
    }
    assert {way: redundancy.turned(each) for way, each in ways.items()} == {way: way for way in ways}


def test_a_scrap_is_not_turned() -> None:
    for scrap in (b"", b"\x83\6\5", *(EIA[at : at + 2] for at in range(60, 100)), EIA[70:73][::-1]):
        assert redundancy.turned(scrap) == "", scrap
    for blocks, way in ((3, ""), (4, redundancy.REVERSE)):  # of which two, three follow one another
        tape = eia.encode("".join(f"{number:03}0000000000003588\n" for number in range(blocks)))
        assert redundancy.turned(tape[::-1]) == way
