"""What the machine refuses, in its words, and how long it takes; tests/reference judges what it does."""

import re
from math import nan
from typing import Any

import pytest

import nc
from nc.machine import Settings
from nc.path import Position
from tapes.errors import TapeError, WorkError
from tests.conftest import case
from tests.nc.tapes_1971 import CIRCLE_BLOCKS, FOUR_HOLES, HEADER, tape


def refusal(frames: bytes, strict: bool = False) -> nc.BlockError:
    with pytest.raises(nc.BlockError) as caught:
        nc.cut(frames, strict=strict)
    return caught.value


def test_nothing_punched_is_no_tape() -> None:
    for length in (0, 1, 19, 500):
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
        (program[:48], "the tape ends after 7 of the block's 20 rows"),
        (program + b"\x80", "the block ends in row 1; a block has 20 rows"),
        (b"\x80" + program, "the block ends in row 1; a block has 20 rows"),
    ):
        assert refusal(frames).reason == says


def test_a_refused_block_leaves_the_machine_as_it_was() -> None:
    machine = nc.HydraPoint()
    ((place, block),) = nc.blocks.read(tape("001 6 01000 00000 0 01 84"), strict=False)
    before = (machine.modes, machine.at)
    with pytest.raises(nc.BlockError):
        machine.carry_out(place, block)
    assert (machine.modes, machine.at) == before


def test_what_the_machine_cannot_be_set_to() -> None:
    Settings((0.2, -0.2, 0), 18, tool_change_seconds=0, peck=1, read_seconds=0)
    settings: list[tuple[dict[str, Any], str]] = [
        ({"feed_error": (0, 0.21, 0)}, "Y feed error +21%: must be within 20%"),
        ({"feed_error": (-0.201, 0, 0)}, "X feed error -20%: must be within 20%"),
        ({"feed_error": (0, 0, 1.0)}, "Z feed error +100%: must be within 20%"),
        ({"feed_error": (0, nan, 0)}, "Y feed error +nan%: must be within 20%"),
        ({"feed_code": 0}, "unknown feed code 00: Table 2.4 has 01 to 18"),
        ({"feed_code": 19}, "unknown feed code 19: Table 2.4 has 01 to 18"),
        ({"tool_change_seconds": -0.1}, "tool change of -0.1 s: must be 0 or more"),
        ({"peck": 0}, "peck of 0 thousandths: must be 1 or more"),
        ({"read_seconds": -0.1}, "reading time of -0.1 s a block: must be 0 or more"),
        ({"read_seconds": nan}, "reading time of nan s a block: must be 0 or more"),
    ]
    for setting, says in settings:
        with pytest.raises(WorkError, match=f"^{re.escape(says)}$"):
            Settings(**setting)


def test_a_strict_machine_refuses_any_one_hole_changed_in_its_row() -> None:
    """Parity, no blank rows, digits only; in the first six of eight blocks, so that a shift has room."""
    program = tape(*CIRCLE_BLOCKS[:8]) + bytes(100)
    blocks = [step.block for step in nc.cut(program).steps]
    assert [step.block for step in nc.cut(program, strict=True).steps] == blocks[1:]
    program = b"\x80" + program.lstrip(b"\0")
    assert [step.block for step in nc.cut(program, strict=True).steps] == blocks
    rubbed = program[:50] + b"\x7f\x7f" + program[50:]
    assert [step.block for step in nc.cut(rubbed, strict=True).steps] == blocks
    assert refusal(rubbed[:70] + b"\3" + rubbed[71:], strict=True).frame == 70
    for frame in range(2, 121):
        for hole in (1 << channel for channel in range(8)):
            changed = bytearray(program)
            changed[frame] ^= hole
            error = refusal(bytes(changed), strict=True)
            assert (error.frame, error.row) == (frame, (frame - 1) % 20 + 1), f"{frame} {hole:03o}"


def test_what_a_strict_machine_says() -> None:
    for frame, says in (
        (0o000, "a blank row within the block"),
        (0o003, "wrong parity: 003 has 2 holes, EIA frames have an odd number"),
        (0o111, "111 is not an EIA digit"),
        (0o260, "260 is not an EIA digit"),
        (0o020, "020 is not an EIA digit"),
        (0o052, "052 is 10, not a decimal digit"),
        (0o203, "an end of block with digit holes beside it: 203"),
    ):
        rows = bytearray(tape(*HEADER))
        rows[30] = frame
        assert refusal(bytes(rows), strict=True).reason == says


def test_the_four_holes_of_chapter_3() -> None:
    path = nc.cut(tape(*FOUR_HOLES))
    places = [(1000, 1000), (1000, 2000), (4000, 2000), (4000, 1000)]
    assert path.holes == tuple(Position(x, y, 3500) for x, y in places)
    assert path.gap == path.contour.efficiency == 0
    assert path.array().tolist() == [[0, 0, 0], *([*move.end] for move in path.moves)]
    assert nc.cut(tape(FOUR_HOLES[0])).array().shape == (0, 3)
    bored = nc.cut(tape(*FOUR_HOLES[:2], "003 7 01000 01000 0 01 89", "004 6 01000 01500 0 01 85"))
    kinds = ["position", "approach", "feed in", "feed out", "retract", "approach", "feed in", "mill"]
    assert [move.kind for move in bored.moves] == kinds


def test_where_the_cutter_is_at_a_second() -> None:
    """2 s a block, 8 s a tool; .2 s an inch across, .6 s down; half an inch in and half along, 30 s each."""
    blocks = ("900 9 03000 03500 0 01 89", "002 0 01000 00500 0 01 86", "003 6 01500 00500 0 01 84")
    path = nc.cut(tape(*blocks), settings=Settings(tool_change_seconds=8))
    assert path.starts == pytest.approx([0, 2, 12.2])
    knots = [(0, 0, 0), (12, 0, 0), (12.1, 500, 500), (12.2, 1000, 500), (14.2, 1000, 500), (14.8, 1000, 500)]
    knots += [(44.8, 1000, 500), (74.8, 1500, 500)]
    assert [knot[:3] for knot in path.knots] == [pytest.approx(knot) for knot in knots]
    assert [knot.down for knot in path.knots] == [False] * 6 + [True] * 2
    for second, knot, x, y, down, block in (
        (0, 0, 0, 0, False, -1),
        (6, 0, 0, 0, False, 1),
        (12.05, 1, 250, 250, False, 1),
        (59.8, 6, 1250, 500, True, 2),
        (80, 7, 1500, 500, False, 2),
    ):
        assert [*path.at(second)] == pytest.approx([knot, x, y, down, block])
    assert [*path.first] == pytest.approx([5, 1000, 500, False, -1])
    assert [path.row(second) for second in (0, 1, 2, 3, 12.2, 80)] == [0, 10, 19, 30, 39, 59]
    assert [*nc.cut(tape(FOUR_HOLES[0])).first] == [0, 0, 0, False, -1]
