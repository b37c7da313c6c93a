"""Frames under the head: what it feels, where a block ends, and every fault by its row."""

from contextlib import suppress

import pytest
from hypothesis import given
from hypothesis import strategies as st

import nc
from nc.blocks import BlockError, read
from tapes.errors import TapeError, WorkError
from tapes.hydrapoint import Block
from tests.conftest import case
from tests.nc.tapes_1971 import CIRCLE_BLOCKS, FOUR_HOLES, HEADER, tape


def blocks(frames: bytes, strict: bool = False) -> list[Block]:
    return [found for _, found in read(frames, strict)]


def refusal(frames: bytes, strict: bool = False) -> BlockError:
    with pytest.raises(BlockError) as caught:
        blocks(frames, strict)
    return caught.value


def test_the_head_feels_channels_1_to_4_and_8() -> None:
    """Every frame as row 9 of a block, the last of X: a digit by channels 1-4 alone, or refused."""
    for frame in range(0o400):
        with case(frame):
            weights = ((0o001, 1), (0o002, 2), (0o004, 4), (0o010, 8))
            digit = sum(weight for hole, weight in weights if frame & hole)
            rows = bytearray(tape("001 0 00000 00000 0 00 80"))
            rows[1 + 8] = frame
            if digit <= 9 and not frame & 0o200:
                assert blocks(bytes(rows)) == [Block(1, 0, digit, 0, 0, 0, 80)]
            else:
                error = refusal(bytes(rows))
                assert (error.block, error.row, error.frame) == (1, 9, 9)


def test_leader_and_trailer_are_not_read() -> None:
    program = tape(*FOUR_HOLES)
    assert blocks(bytes(200) + program + bytes(300)) == blocks(program)
    assert [place.frame for place, _ in read(bytes(200) + program)] == [201 + 20 * n for n in range(6)]


def test_a_blank_row_is_a_zero_within_a_block() -> None:
    frames = tape(*HEADER)
    assert blocks(frames[:1] + frames[1:2] + frames[2:].replace(b"\x20", b"\0")) == blocks(frames)


@pytest.mark.parametrize("length", [0, 1, 19, 500])
def test_nothing_punched_is_no_tape(length: int) -> None:
    with pytest.raises(TapeError, match="no row is punched"):
        nc.cut(bytes(length))


@pytest.mark.parametrize(
    ("digits", "row", "says"),
    [
        ("001 2 00000 00000 0 00 80", 4, "unknown preparatory function 2"),
        ("001 3 00000 00000 0 00 80", 4, "unknown preparatory function 3"),
        ("001 0 20001 00000 0 00 80", 5, "X 20.001 is beyond the travel of 20 in"),
        ("001 0 20000 10001 0 00 80", 10, "Y 10.001 is beyond the travel of 10 in"),
        ("001 9 05001 05001 0 01 89", 5, "Z feed point 5.001 is beyond the travel of 5 in"),
        ("001 9 05000 05001 0 01 89", 10, "final depth 5.001 is beyond the travel of 5 in"),
        ("001 9 03000 02999 0 01 89", 10, "final depth 2.999 is above the Z feed point 3.000"),
        ("001 0 00000 00000 1 00 80", 15, "the reserved digit is 1; it must be 0"),
        ("001 0 00000 00000 0 00 01", 18, "unknown miscellaneous function 01"),
        ("001 0 00000 00000 0 00 87", 18, "unknown miscellaneous function 87"),
        ("001 0 00000 00000 0 00 84", 16, "unknown X feed code 00"),
        ("001 0 00000 00000 0 19 85", 16, "unknown Y feed code 19"),
        ("001 0 00000 00000 0 21 89", 16, "unknown Z feed code 21"),
        ("001 0 00000 00000 0 20 88", 16, "unknown spindle speed code 20"),
        ("001 0 00000 00000 0 39 88", 16, "unknown spindle speed code 39"),
        ("001 0 00000 00000 0 25 86", 16, "unknown tool code 25"),
        ("001 0 00000 00000 0 39 80", 16, "unknown tool function code 39"),
    ],
)
def test_an_unknown_code_or_place_is_refused_by_row(digits: str, row: int, says: str) -> None:
    error = refusal(tape(*HEADER[:3], digits))
    assert (error.block, error.row, error.frame) == (4, row, 60 + row)
    assert str(error) == f"frame {60 + row}: block 4, row {row}: {says}"


def test_wrong_lengths_are_named() -> None:
    program = tape(*HEADER)
    assert "the block ends in row 19; a block has 20 rows" in str(refusal(program[:45] + program[46:]))
    assert "no end of block in row 20, but the digit 8" in str(refusal(program[:45] + program[44:]))
    assert "the tape ends after 7 rows of the block's 20" in str(refusal(program[:48]))
    assert "the block ends in row 1;" in str(refusal(program + b"\x80"))
    assert "the block ends in row 1;" in str(refusal(b"\x80" + program))


FORTY = tape(*CIRCLE_BLOCKS[:42])
"""The first 40 blocks of the circle and two more, so that a shift has somewhere to go."""


@pytest.mark.parametrize("change", ["dropped", "doubled"])
def test_a_frame_dropped_or_doubled_anywhere_is_found_in_its_block(change: str) -> None:
    for frame in range(1, 801):
        twice = FORTY[frame : frame + 1] * (2 if change == "doubled" else 0)
        error = refusal(FORTY[:frame] + twice + FORTY[frame + 1 :])
        row = (frame - 1) % 20 + 1
        extra_end = change == "doubled" and row == 20
        assert error.block == (frame - 1) // 20 + 1 + extra_end, f"frame {frame}"
        assert error.row in (1, 19, 20)


@given(st.binary(max_size=200))
def test_no_tape_brings_down_the_machine(frames: bytes) -> None:
    for strict in (False, True):
        with suppress(WorkError):
            nc.cut(frames, strict=strict)


class TestStrict:
    """Later controls: parity, no blank rows, digits only."""

    def test_a_good_tape_is_the_same(self) -> None:
        program = tape(*HEADER)
        assert blocks(program, strict=True) == blocks(program)
        assert blocks(program + bytes(100), strict=True) == blocks(program)

    def test_any_one_hole_changed_is_refused_in_its_row(self) -> None:
        for frame in range(2, 121):
            for hole in (1 << channel for channel in range(8)):
                changed = bytearray(FORTY)
                changed[frame] ^= hole
                error = refusal(bytes(changed), strict=True)
                assert (error.frame, error.row) == (frame, (frame - 1) % 20 + 1), f"{frame} {hole:03o}"

    @pytest.mark.parametrize(
        ("frame", "says"),
        [
            (0o000, "a blank row within the block"),
            (0o003, "wrong parity: 003 has 2 holes, EIA frames have an odd number"),
            (0o111, "111 is not an EIA digit"),
            (0o260, "260 is not an EIA digit"),
            (0o020, "020 is not an EIA digit"),
            (0o052, "052 is 10, not a decimal digit"),
            (0o203, "an end of block with digit holes beside it: 203"),
        ],
    )
    def test_what_is_wrong_is_said(self, frame: int, says: str) -> None:
        rows = bytearray(tape(*HEADER))
        rows[30] = frame
        assert refusal(bytes(rows), strict=True).reason == says
