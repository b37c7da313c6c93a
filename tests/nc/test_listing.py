"""The program as a table, and what the reports say."""

import nc
from nc.curves import Ellipse, StraightLine
from nc.inspection import inspect
from nc.listing import does, in_force, lines
from nc.machine import Settings
from nc.report import cut_report, inspection_report
from tests.nc.tapes_1971 import CIRCLE, FOUR_HOLES, HEADER, milled, tape


def test_the_circle_begins() -> None:
    assert list(lines(nc.cut(CIRCLE)))[:9] == [
        "block seq P       X       Y  TF MF  does",
        "    1 001 0  19.000   0.000  00 02  position to X 19.000 Y 0.000; end of program, waits for START",
        "    2 002 0   0.000   0.000  01 86  position to X 0.000 Y 0.000; tool change, automatic, tool 01",
        "    3 003 0   0.000   0.000  00 08  position to X 0.000 Y 0.000; mist coolant on",
        "    4 004 0   0.000   0.000  31 88  position to X 0.000 Y 0.000; spindle 2000 rpm",
        "    5 005 0   2.250   4.000  00 80  position to X 2.250 Y 4.000",
        "    6 006 9   3.000   3.500  01 89  read Z: feed point 3.000, final depth 3.500; Z feed 1.0 in/min",
        "    7 007 6   2.250   4.133  01 85  quill to 3.500 at 1.0 in/min, mill Y to 4.133 at 1.0 in/min",
        "    8 008 6   2.261   4.133  01 84  mill X to 2.261 at 1.0 in/min",
    ]


def test_modes_and_the_clock_after_each_block() -> None:
    table = list(lines(nc.cut(CIRCLE), modes=True))
    assert "3.500     1.0     1.0     1.0  2000   01    mist    full    36:42.7  mill X" in table[666]
    assert "    29:00.0  mill Y" in table[517]
    blocks = (*HEADER, "007 6 02250 04133 0 01 85", "008 0 02250 04133 0 00 81")
    heading, *_, last = lines(nc.cut(tape(*blocks)), modes=True)
    assert [heading[36:], last[36:]] == [
        "         Z  X feed  Y feed  Z feed   rpm tool coolant retract       time  does",
        "     3.000       -     1.0     1.0  2000   01    mist partial     1:03.1  "
        "position to X 2.250 Y 4.133; partial retract on",
    ]


def test_the_words_for_every_code() -> None:
    path = nc.cut(
        tape(
            "001 9 00000 02000 0 02 89",
            "002 1 00100 00100 0 00 81",
            "003 5 00100 00200 0 02 89",
            "004 7 00100 00300 0 00 83",
            "005 5 00100 00400 0 00 00",
            "006 0 00100 00400 0 05 84",
            "007 0 00100 00400 0 06 85",
            "008 6 00100 00400 0 06 85",
            "009 6 00200 00500 0 06 85",
            "010 0 00000 00000 0 03 06",
            "011 0 00000 00000 0 00 06",
            "012 0 00000 00000 0 00 07",
        )
    )
    assert [does(step) for step in path.steps] == [
        "read Z: feed point 0.000, final depth 2.000; Z feed 2.1 in/min",
        "tap, feed control at X 0.100 Y 0.100, from 0.000 to 2.000 at 2.1 in/min; partial retract on",
        "drill at X 0.100 Y 0.200, from 0.000 to 2.000 at 2.1 in/min",
        "bore at X 0.100 Y 0.300, from 0.000 to 2.000 at 2.1 in/min; index work piece",
        "drill at X 0.100 Y 0.400, from 0.000 to 2.000 at 2.1 in/min; program stop, waits for START",
        "position to X 0.100 Y 0.400; X feed 5.5 in/min",
        "position to X 0.100 Y 0.400; Y feed 7.2 in/min",
        "quill to 2.000 at 2.1 in/min, mill, already there",
        "mill X to 0.176 Y to 0.500 at 9.1 in/min, mill X to 0.200 at 5.5 in/min",
        "position to X 0.000 Y 0.000; tool change, manual, tool 03, waits for START",
        "position to X 0.000 Y 0.000; tool change, manual, waits for START",
        "position to X 0.000 Y 0.000; flood coolant on",
    ]
    said = "at X 0.200 Y 0.500, quill down 2.000 · X feed 5.5, Y feed 7.2, Z feed 2.1 in/min · coolant off · "
    assert in_force(path.steps[8]) == f"{said}partial retract"


def test_the_day_with_the_circle() -> None:
    """Chapter 7: 2 s for each of 660 blocks and 13.86 in at 1 in/min are 35.9 min; the header adds .8."""
    path = nc.cut(CIRCLE)
    assert repr(path) == "<Path: 666 blocks, 36.7 min>"
    assert list(cut_report(path, passes=2)) == [
        "blocks        666",
        "stop          block 1: end of program, waits for START",
        "milled        13.861 in, 660 blocks",
        "extent        X 2.250 Y 2.245 to X 5.749 Y 5.755",
        "milling ends  X 2.251 Y 3.844, 0.156 in from its start",
        "cutter        X 2.251 Y 3.844, quill down 3.500",
        "",
        "reading          22.2 min   666 blocks at 2 s",
        "positioning       0.1 min   at 300 in/min",
        "Z feed            0.5 min",
        "milling          13.9 min   at 1 in/min",
        "tool changes      0.0 min   1, time not counted",
        "machining        36.7 min",
        "contour alone    35.9 min   660 milling blocks: reading 22.0, cutting 13.9, efficiency 39%",
        "2 passes         73.4 min   36.7 each",
    ]


def test_the_day_with_the_four_holes() -> None:
    assert list(cut_report(nc.cut(tape(*FOUR_HOLES), settings=Settings(tool_change_seconds=8)))) == [
        "blocks        6",
        "holes         4",
        "cutter        X 4.000 Y 1.000, quill up",
        "",
        "reading           0.2 min   6 blocks at 2 s",
        "positioning       0.1 min   at 300 in/min",
        "Z feed            2.0 min",
        "milling           0.0 min",
        "tool changes      0.0 min   0 at 8 s",
        "machining         2.3 min",
    ]


def test_milling_at_several_feeds() -> None:
    ends = ("007 6 02250 05000 0 05 85", "008 6 02350 05000 0 02 84", "009 6 02350 05001 0 04 85")
    said = list(cut_report(nc.cut(tape(*HEADER, *ends), settings=Settings((0.12345, -0.2, 0)))))
    assert "milling           0.3 min   at 2.135 to 4.4 in/min" in said
    assert "milling ends  X 2.350 Y 5.001, 1.006 in from its start" in said


def test_the_inspection_stands_beside_the_thesis() -> None:
    around = Ellipse(4000, 4000, 1750, 1750)
    said = list(inspection_report(inspect(nc.cut(CIRCLE), around)))
    assert [*said[:8], said[10], said[16], *said[24:]] == [
        "nominal   circle, centre X 4.000 Y 4.000, radius 1.750 in",
        "cutter    0.500 in; its centre went from .0060 inside to .0060 outside of nominal",
        "stations  36000",
        "open      the milling ends .1560 in from its start: the contour is not closed",
        "",
        "place         wall      lowest  highest  trough to peak   thesis",
        "whole length  outer     -.0114   +.0060           .0174",
        "whole length  inner     -.0060   +.0084           .0144",
        "+Y apex       outer     -.0046   +.0060           .0106",
        "45° +X+Y      outer     +.0048   +.0055           .0007   about .001",
        "",
        "worst trough to peak .0173 in: outer wall, -X apex, from -.0114 to +.0059; thesis .009",
        "at 45 degrees .0007 to .0009 in",
        "out of tolerance: -.0114 off nominal at most, outer wall, -X apex; .0050 is allowed",
    ]
    assert "thesis" not in "\n".join(inspection_report(inspect(nc.cut(CIRCLE), cutter=250)))


def test_an_error_has_its_sign_and_four_places() -> None:
    for y, said, side, verdict in (
        (3999.5, "+.0005", "left", "within"),
        (4000, "+.0000", "right", "within"),
        (4000.5, "-.0005", "right", "within"),
        (3994.96, "+.0050", "left", "within"),
        (4005.06, "-.0051", "right", "out of"),
    ):
        found = inspect(milled((3250, 4000)), StraightLine(2250, y, 3250, y), cutter=10_000)
        report = list(inspection_report(found))
        assert f"whole length  outer     {said}   {said}           .0000" in report
        went = f"its centre went from {said[1:]} {side} to {said[1:]} {side} of nominal"
        assert report[1] == f"cutter    10.000 in; {went}"
        assert report[-1].startswith(f"{verdict} tolerance: {said} off nominal at most")
