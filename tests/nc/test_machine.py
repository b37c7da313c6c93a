"""What no second machine judges: settings, the thesis's times, where the cutter is at a second."""

from typing import Any

import pytest

import nc
from nc.machine import Settings
from nc.path import Position
from tapes import shelf
from tapes.errors import WorkError
from tests.nc.tapes_1971 import CIRCLE, FOUR_HOLES, tape


def test_the_four_holes_of_chapter_3() -> None:
    path = nc.cut(tape(*FOUR_HOLES))
    places = [(1000, 1000), (1000, 2000), (4000, 2000), (4000, 1000)]
    assert path.holes == tuple(Position(x, y, 3500) for x, y in places)
    assert path.gap == path.contour.efficiency == 0
    assert path.array().tolist() == [[0, 0, 0], *([*move.end] for move in path.moves)]
    assert nc.cut(tape(FOUR_HOLES[0])).array().shape == (0, 3)


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


def test_the_circle_takes_36_minutes() -> None:
    """Chapter 7: 2 s for each of 660 blocks and 13.86 in at 1 in/min are 35.9 min; the header adds .8."""
    assert shelf.read("circle.eia") == CIRCLE, "the bundled tape is the one made here"
    path = nc.cut(CIRCLE)
    assert sum(move.length for move in path.cuts) == 13_861
    assert sum(2 + step.moves[-1].seconds for step in path.steps[6:]) / 60 == pytest.approx(35.86, abs=0.01)
    assert path.times.total / 60 == pytest.approx(36.7, abs=0.05)
    assert repr(path) == "<Path: 666 blocks, 36.7 min>"


def test_chapter_10s_efficiency() -> None:
    """About 33 of 50 minutes of the ellipse are reading: 17 minutes of work, an efficiency of about 33 %."""
    fast = Settings(feed_error=(0.2, 0.2, 0), feed_code=1)
    contour = nc.cut(shelf.read("ellipse.eia"), settings=fast).contour
    assert contour.reading / 60 == pytest.approx(33, abs=1)
    assert contour.total / 60 == pytest.approx(50, abs=0.5)
    assert round(contour.efficiency, 2) == 0.35


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
