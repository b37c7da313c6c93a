"""What the machine refuses, in its words, and by row; the second Hydra-Point judges which block and frame."""

from contextlib import suppress

import pytest
from hypothesis import given
from hypothesis import strategies as st

import nc
from tapes.errors import TapeError, WorkError
from tests.conftest import case
from tests.nc.tapes_1971 import CIRCLE_BLOCKS, HEADER, tape


def refusal(frames: bytes, strict: bool = False) -> nc.BlockError:
    with pytest.raises(nc.BlockError) as caught:
        nc.cut(frames, strict=strict)
    return caught.value


@pytest.mark.parametrize("length", [0, 1, 19, 500])
def test_nothing_punched_is_no_tape(length: int) -> None:
    with pytest.raises(TapeError, match="no row is punched"):
        nc.cut(bytes(length))


REFUSED = """\
2 00000 00000 0 00 80 | 4 | unknown preparatory function 2
3 00000 00000 0 00 80 | 4 | unknown preparatory function 3
0 20001 00000 0 00 80 | 5 | X 20.001 is beyond the travel of 20 in
0 20000 10001 0 00 80 | 10 | Y 10.001 is beyond the travel of 10 in
9 05001 05001 0 01 89 | 5 | Z feed point 5.001 is beyond the travel of 5 in
9 05000 05001 0 01 89 | 10 | final depth 5.001 is beyond the travel of 5 in
9 03000 02999 0 01 89 | 10 | final depth 2.999 is above the Z feed point 3.000
0 00000 00000 1 00 80 | 15 | the reserved digit is 1; it must be 0
0 00000 00000 0 00 01 | 18 | unknown miscellaneous function 01
0 00000 00000 0 00 87 | 18 | unknown miscellaneous function 87
0 00000 00000 0 00 84 | 16 | unknown X feed code 00
0 00000 00000 0 19 85 | 16 | unknown Y feed code 19
0 00000 00000 0 21 89 | 16 | unknown Z feed code 21
0 00000 00000 0 20 88 | 16 | unknown spindle speed code 20
0 00000 00000 0 39 88 | 16 | unknown spindle speed code 39
0 00000 00000 0 25 86 | 16 | unknown tool code 25
0 00000 00000 0 39 80 | 16 | unknown tool function code 39
6 01000 00000 0 01 84 | 4 | the quill needs depths (preparatory function 9); no block has set them
5 01000 00000 0 01 89 | 4 | the quill needs depths (preparatory function 9); no block has set them
6 01000 00000 0 01 85 | 4 | milling along X needs an X feed (miscellaneous function 84); no block has set one
6 00000 01000 0 01 84 | 4 | milling along Y needs a Y feed (miscellaneous function 85); no block has set one
"""


def test_an_unknown_code_or_place_is_refused_by_row() -> None:
    for line in REFUSED.splitlines():
        with case(line):
            digits, row, says = line.split(" | ")
            error = refusal(tape(*HEADER[:3], f"004 {digits}"))
            assert str(error) == f"frame {60 + int(row)}: block 4, row {row}: {says}"
            assert (error.block, error.row, error.frame) == (4, int(row), 60 + int(row))
    error = refusal(tape("001 9 03000 03500 0 00 80", "002 5 01000 00000 0 00 80"))
    assert error.reason == "the quill needs a Z feed (miscellaneous function 89); no block has set one"


def test_wrong_lengths_are_named() -> None:
    program = tape(*HEADER)
    for frames, says in (
        (program[:45] + program[46:], "the block ends in row 19; a block has 20 rows"),
        (program[:45] + program[44:], "no end of block in row 20, but the digit 8"),
        (program[:48], "the tape ends after 7 rows of the block's 20"),
        (program + b"\x80", "the block ends in row 1; a block has 20 rows"),
        (b"\x80" + program, "the block ends in row 1; a block has 20 rows"),
    ):
        assert refusal(frames).reason == says


def test_a_refused_block_leaves_the_machine_as_it_was() -> None:
    machine = nc.HydraPoint()
    ((place, block),) = nc.blocks.read(tape("001 6 01000 00000 0 01 84"))
    before = (machine.modes, machine.at)
    with pytest.raises(nc.BlockError):
        machine.carry_out(place, block)
    assert (machine.modes, machine.at) == before


@given(st.binary(max_size=200))
def test_no_tape_brings_down_the_machine(frames: bytes) -> None:
    for strict in (False, True):
        with suppress(WorkError):
            nc.cut(frames, strict=strict)


class TestStrict:
    """Later controls: parity, no blank rows, digits only."""

    def test_a_good_tape_is_the_same(self) -> None:
        program = tape(*HEADER) + bytes(100)
        assert nc.cut(program, strict=True).steps == nc.cut(program).steps

    def test_any_one_hole_changed_is_refused_in_its_row(self) -> None:
        """In the first six of eight blocks, so that a shift has somewhere to go."""
        for frame in range(2, 121):
            for hole in (1 << channel for channel in range(8)):
                changed = bytearray(tape(*CIRCLE_BLOCKS[:8]))
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
