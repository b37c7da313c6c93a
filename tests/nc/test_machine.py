"""What each block makes the machine do, the modes it leaves, and the thesis's times."""

from typing import Any

import pytest

import nc
from nc.machine import CutError, Settings
from nc.path import Move, MoveKind, Path, Position
from tapes import shelf
from tapes.errors import WorkError
from tests.nc.tapes_1971 import CIRCLE, CIRCLE_BLOCKS, FOUR_HOLES, HEADER, tape

READ_Z = "900 9 03000 03500 0 01 89"


def moves(path: Path) -> list[tuple[str, Position, float]]:
    return [(str(move.kind), move.end, move.speed) for move in path.moves]


def last(*blocks: str, settings: Settings | None = None) -> tuple[Move, ...]:
    """Return the moves of the last of these blocks."""
    return nc.cut(tape(*blocks), settings=settings).steps[-1].moves


def refusal(*blocks: str) -> CutError:
    with pytest.raises(CutError) as caught:
        nc.cut(tape(*blocks))
    return caught.value


def test_the_four_holes_of_chapter_3() -> None:
    path = nc.cut(tape(*FOUR_HOLES))
    places = [(1000, 1000), (1000, 2000), (4000, 2000), (4000, 1000)]
    assert path.holes == tuple(Position(x, y, 3500) for x, y in places)
    assert path.steps[0].modes.spindle == 3100
    for (x, y), step in zip(places, path.steps[2:], strict=True):
        drilled = [(move.kind, move.end, move.speed) for move in step.moves[-3:]]
        assert drilled == [
            (MoveKind.APPROACH, Position(x, y, 3000), 300),
            (MoveKind.FEED_IN, Position(x, y, 3500), 1.0),
            (MoveKind.RETRACT, Position(x, y, 0), 300),
        ]
    assert path.times.z_feed == pytest.approx(4 * 30)
    assert path.gap == 0


def test_two_feeds_leave_the_slope_where_one_axis_arrives() -> None:
    """Figure 3.1: a slope of 30 degrees with X at 1.9 and Y at 1.0; Y is not there yet when X is."""
    both = last(READ_Z, "001 6 00000 00000 0 02 84", "002 6 17321 10000 0 01 85")
    assert both[0].end == pytest.approx((17321, 17321 / 1.9, 3500))
    assert both[1].end == (17321, 10000, 3500)
    assert [move.speed for move in both] == [pytest.approx((1.9**2 + 1) ** 0.5), 1.0]
    assert sum(move.seconds for move in both) == pytest.approx(10 / 1.0 * 60)


def test_a_tool_change_needs_the_quill_up_and_takes_its_time() -> None:
    blocks = (READ_Z, "001 6 01000 00000 0 01 84", "002 6 02000 00000 0 07 86")
    path = nc.cut(tape(*blocks), settings=Settings(tool_change_seconds=8))
    assert [str(move.kind) for move in path.steps[-1].moves] == ["mill", "retract"]
    assert path.steps[-1].modes.tool == 7
    assert path.times.tool_changes == 8


def test_stops_wait_for_the_operator_and_the_tape_goes_on() -> None:
    path = nc.cut(tape(*HEADER, "007 0 00000 00000 0 00 00"))
    assert [(step.number, step.stop) for step in path.steps if step.stop] == [
        (1, "end of program"),
        (7, "program stop"),
    ]


@pytest.mark.parametrize(
    ("blocks", "says"),
    [
        (["001 6 01000 00000 0 01 84"], "the quill needs depths"),
        (["001 5 01000 00000 0 01 89"], "the quill needs depths"),
        (
            ["001 9 03000 03500 0 00 80", "002 5 01000 00000 0 00 80"],
            "the quill needs a Z feed",
        ),
        ([READ_Z, "002 6 01000 00000 0 01 85"], "milling along X needs an X feed"),
        ([READ_Z, "002 6 00000 01000 0 01 84"], "milling along Y needs a Y feed"),
    ],
)
def test_what_no_block_has_set_is_refused(blocks: list[str], says: str) -> None:
    error = refusal(*blocks)
    assert error.reason.startswith(says)
    assert (error.block, error.row) == (len(blocks), 4)


def test_a_bad_block_is_never_half_executed() -> None:
    good = tape(*CIRCLE_BLOCKS[:50])
    error = refusal(*CIRCLE_BLOCKS[:50], "051 6 20001 04000 0 01 84", *CIRCLE_BLOCKS[51:])
    assert error.path.steps == nc.cut(good).steps
    assert (error.block, error.row) == (51, 5)


def test_a_refused_block_leaves_the_machine_as_it_was() -> None:
    machine = nc.HydraPoint()
    (_, block), *_ = nc.blocks.read(tape("001 6 01000 00000 0 01 84"))
    place = nc.blocks.Row(1, 0)
    before = (machine.modes, machine.at)
    with pytest.raises(nc.BlockError):
        machine.carry_out(place, block)
    assert (machine.modes, machine.at) == before


@pytest.mark.parametrize(
    ("setting", "says"),
    [
        ({"feed_error": (0, 0.21, 0)}, r"Y feed error \+21%: must be within 20%"),
        ({"feed_error": (-0.201, 0, 0)}, "X feed error -20%: must be within 20%"),
        ({"feed_error": (0, 0, 1.0)}, r"Z feed error \+100%: must be within 20%"),
        ({"feed_error": (0, float("nan"), 0)}, "must be within 20%"),
        ({"feed_code": 0}, "unknown feed code 00: Table 2.4 has 01 to 18"),
        ({"feed_code": 19}, "unknown feed code 19"),
        ({"tool_change_seconds": -0.1}, "tool change of -0.1 s: must be 0 or more"),
        ({"peck": 0}, "peck of 0 thousandths: must be 1 or more"),
        ({"read_seconds": -0.1}, "reading time of -0.1 s a block: must be 0 or more"),
        ({"read_seconds": float("nan")}, "must be 0 or more"),
    ],
)
def test_what_the_machine_cannot_be_set_to(setting: dict[str, Any], says: str) -> None:
    Settings((0.2, -0.2, 0), 18, tool_change_seconds=0, peck=1, read_seconds=0)
    with pytest.raises(WorkError, match=says):
        Settings(**setting)


def test_a_feed_error_changes_the_times_and_not_the_staircase() -> None:
    true, slow = nc.cut(CIRCLE), nc.cut(CIRCLE, settings=Settings(feed_error=(-0.2, -0.2, 0)))
    assert [move.end for move in slow.moves] == [move.end for move in true.moves]
    assert slow.times.milling == pytest.approx(true.times.milling / 0.8)


class TestTheCircle:
    """4 in, +-.005, 1 in/min: 36 minutes in Chapter 7."""

    def test_the_bundled_tape_is_the_one_made_here(self) -> None:
        assert shelf.read("circle.eia") == CIRCLE

    def test_blocks_and_ends(self) -> None:
        path = nc.cut(CIRCLE)
        assert len(path) == 666
        assert path.steps[-1].block.sequence == 666
        assert path.cuts[0].start == Position(2250, 4000, 3500)
        assert path.cuts[-1].end == Position(2251, 3844, 3500)
        assert path.gap == pytest.approx(156, abs=0.01)

    def test_machining_takes_36_minutes(self) -> None:
        """2 s for each of 660 milling blocks and 13.86 in at 1 in/min are 35.9 min; the header adds .8."""
        path = nc.cut(CIRCLE)
        assert sum(move.length for move in path.cuts) == 13_861
        contour = sum(2 + step.moves[-1].seconds for step in path.steps[6:])
        assert contour / 60 == pytest.approx(35.86, abs=0.01)
        assert path.times.total / 60 == pytest.approx(36.7, abs=0.05)
        assert list(path.clock())[-1] == pytest.approx(path.times.total)


class TestTheEllipse:
    """6 x 4 1/2 in, +-.005: 50 minutes in Chapter 7, 33 of them reading (Chapter 10)."""

    ELLIPSE = shelf.read("ellipse.eia")

    @pytest.mark.parametrize(
        ("settings", "minutes"),
        [
            (Settings(), 36.1),
            (Settings(feed_code=1), 53.2),
            (Settings(feed_code=1, feed_error=(0.2, 0.2, 0.2)), 49.7),
        ],
        ids=["code 05, 5.5 in/min", "1.0 in/min", "1.2 in/min"],
    )
    def test_machining(self, settings: Settings, minutes: float) -> None:
        path = nc.cut(self.ELLIPSE, settings=settings)
        assert len(path) == 976
        assert path.times.reading / 60 == pytest.approx(32.5, abs=0.05)
        contour = 970 * 2 + path.times.milling
        assert contour / 60 == pytest.approx(minutes, abs=0.05)


def test_a_path_is_one_line_to_look_at() -> None:
    assert repr(nc.cut(CIRCLE)) == "<DrawnPath: 666 blocks, 36.7 min>"


def test_chapter_10s_efficiency() -> None:
    """About 33 of 50 minutes of the ellipse are reading: 17 minutes of work, an efficiency of about 33 %."""
    fast = Settings(feed_error=(0.2, 0.2, 0), feed_code=1)
    contour = nc.cut(shelf.read("ellipse.eia"), settings=fast).contour
    assert contour.reading / 60 == pytest.approx(33, abs=1)
    assert contour.total / 60 == pytest.approx(50, abs=0.5)
    assert round(contour.efficiency, 2) == 0.35


def test_an_electronic_reader() -> None:
    quick = nc.cut(CIRCLE, settings=Settings(read_seconds=0.01))
    assert quick.contour.total == pytest.approx(660 * 0.01 + quick.times.milling)
    assert quick.contour.efficiency > 0.99
