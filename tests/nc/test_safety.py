"""G-code for today's mill, judged by an interpreter of the tests' own and by LinuxCNC's."""

import math
import re
import shutil
import subprocess
from collections.abc import Iterable, Iterator
from itertools import groupby, pairwise, product
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from shapely import LineString, Point, Polygon, unary_union
from shapely.geometry.base import BaseGeometry

import nc
from nc.gcode import Output, gcode
from nc.gcode_1971 import gcode_1971
from nc.machine import Settings
from programs.parts import part
from tapes.errors import WorkError
from tapes.hydrapoint import COOLANT, MISCELLANEOUS, Miscellaneous
from tests.conftest import case
from tests.nc import safety
from tests.nc.safety import Stock
from tests.nc.tapes_1971 import CIRCLE, FOUR_HOLES, HEADER, tape
from tests.nc.test_export import EVERYTHING
from tests.programs import printouts
from tests.programs.printouts import Read

PARTS: dict[str, dict[str, object]] = {
    "circle": {},
    "ellipse": {},
    "polynomial": {"cutter": 0.5, "side": "above"},
    "slope": {"technique": "piece"},
    "die": {},
    "drill": {},
    "fluidic": {},
    "curve": {"to": 3, "cutter": 0.25, "side": "below"},
    "profile": {"cutter": 0.25, "side": "inside"},
}
OF_A_HOBBYIST: dict[str, tuple[str, str, dict[str, Any]]] = {
    "edge of a pocket": ("profile", "1/sqrt((cos(x)/1.5)**2+sin(x)**2)", {"cutter": 0.25, "side": "inside"}),
    "wave": ("curve", "sin(x)+1", {"from_": 0.5, "to": 2.5, "cutter": 0.25, "side": "above"}),
    "cam": ("profile", "1.2+0.2*cos(x)", {"cutter": 0.25, "tolerance": 0.003}),
}
LINUXCNC = {"M6", "M7", "M8", "M9", "G43"}


def frames(blocks: list[Read]) -> bytes:
    return tape(*("{:03}{}{:05}{:05}{}{:02}{:02}".format(*block) for block in blocks))


def places(blocks: list[Read]) -> list[tuple[float, float]]:
    """Return X and Y in inches where the blocks cut, in order; none twice in a row."""
    moving = [block for block in blocks if block.preparatory != 9]
    found = []
    for before, block in pairwise(moving):
        if block.preparatory:
            found += [before] * (block.preparatory == 6 and not before.preparatory) + [block]
    return [at for at, _ in groupby((block.x / 1000, block.y / 1000) for block in found)]


def stock(blocks: list[Read]) -> Stock:
    xs, ys = zip(*places(blocks), strict=True)
    ((point, depth),) = {(block.x, block.y) for block in blocks if block.preparatory == 9}
    return Stock((min(xs), min(ys)), (max(xs), max(ys)), (depth - point) / 1000)


def linuxcnc(lines: list[str], folder: Path) -> list[tuple[tuple[float, ...], bool]]:
    """Return the ends of the straight moves that LinuxCNC's interpreter makes, and whether it feeds."""
    (folder / "part.ngc").write_text("\n".join(lines) + "\n")
    (folder / "tools").write_text("".join(f"T{tool} P{tool} Z0 D0.5\n" for tool in range(1, 100)))
    (folder / "variables").touch()
    command = [str(shutil.which("rs274")), "-g", "-t", "tools", "-v", "variables", "part.ngc", "canon"]
    subprocess.run(command, cwd=folder, check=True, capture_output=True, timeout=60)
    canon = (folder / "canon").read_text()
    assert "PROGRAM_END()" in canon
    moves = re.findall(r"STRAIGHT_(FEED|TRAVERSE)\((.*), 0\.0000, 0\.0000, 0\.0000\)", canon)
    return [(tuple(map(float, place.split(", "))), kind == "FEED") for kind, place in moves]


@pytest.mark.parametrize("changes", [False, True])
def test_what_is_said_to_be_left_out_is_not_written_and_nothing_else(changes: bool) -> None:
    """Of each block that sets coolant, changes the tool or stops: it is in the program, or said, once."""
    path = nc.cut(EVERYTHING)
    lines = [*gcode(path, Output(pitch=50, tool_change=changes))]
    said = re.findall(r"^\(left out: (?!position)(.*)\)$", "\n".join(lines), re.MULTILINE)
    done = [line for line in lines if line[:1] == "T" or line[:2] == "M0"]
    sets = [step for step in path.steps if step.block.miscellaneous in COOLANT]
    coolant = [f"{step.modes.coolant} coolant of block {step.number}" for step in sets]
    assert [line for line in said if "coolant" in line] == (
        [] if changes else [line for line in coolant if line[:3] != "off"]
    )
    assert bool({"M7", "M8"} & {*lines}) == changes
    for step in path.steps:
        if step.tool_changed or step.stop or step.block.miscellaneous == Miscellaneous.INDEX:
            of = [line for line in (*done, *said) if re.search(rf"of block {step.number}\b", line)]
            assert len(of) == 1, step.number


@pytest.mark.parametrize("name", PARTS)
def test_a_part_is_safe_on_a_mill(name: str, tmp_path: Path) -> None:
    """It is judged by the blocks of the printout, without the exporter; and goes where they say, at any
    safe height and anywhere.
    """
    expression = {"curve": ["sin(x)+1"], "profile": ["1.2+0.2*cos(x)"]}.get(name, [])
    blocks = printouts.blocks(part(name, *expression, **PARTS[name]))
    path, reached = nc.cut(frames(blocks)), stock(blocks)
    lines = [*gcode(path)]
    assert safety.faults(lines, reached) == []
    for output in (Output(safe=30, shift=(-500, 250)), Output(safe=400, tool_change=True)):
        low, high = (
            (x + output.shift[0] / 1000 + near, y + output.shift[1] / 1000 + near)
            for (x, y), near in ((reached.low, -1e-9), (reached.high, 1e-9))
        )
        assert (
            safety.faults(gcode(path, output), Stock(low, high, reached.depth), output.safe / 1000, LINUXCNC)
            == []
        )
    mill = safety.run(lines, 0.25)
    down = [at for at, _ in groupby(move.end[:2] for move in mill.went if move.end[2] < 0)]
    if "technique" in PARTS[name]:  # with two feeds a block has a corner, which no block of it names
        corners = iter(down)
        assert all(place in corners for place in places(blocks))
    else:
        assert down == places(blocks)
    if shutil.which("rs274"):
        there = linuxcnc(lines, tmp_path)
        assert [end for end, _ in there[1:]] == [move.end for move in mill.went[1:]]
        assert [fed for _, fed in there] == [move.feed is not None for move in mill.went]


@pytest.mark.parametrize("name", OF_A_HOBBYIST)
def test_what_the_g_code_cuts_is_the_part(name: str) -> None:
    """The wall that the cutter leaves along the program's own moves, by shapely, beside the part's edge."""
    program, expression, constants = OF_A_HOBBYIST[name]
    blocks = printouts.blocks(part(program, expression, stop="inside", **constants))
    lines = [*gcode(nc.cut(frames(blocks)), Output(250, shift=(-2000, -1000)))]
    reached = stock(blocks)
    (left, near), (right, far) = reached.low, reached.high
    moved = Stock((left - 2 - 1e-9, near - 1 - 1e-9), (right - 2 + 1e-9, far - 1 + 1e-9), reached.depth)
    assert safety.faults(lines, moved) == []
    went = [move.end for move in safety.run(lines, 0.25).went]
    cuts = [LineString([one[:2], other[:2]]) for one, other in pairwise(went) if one[2] < 0 and other[2] < 0]
    metal = unary_union([cut.buffer(0.125, quad_segs=128) for cut in cuts])
    assert isinstance(metal, Polygon)
    of_x = eval(f"lambda x: {expression}", {"cos": math.cos, "sin": math.sin, "sqrt": math.sqrt})
    if program == "profile":
        edge = [
            (2 + of_x(x) * math.cos(x), 3 + of_x(x) * math.sin(x)) for x in np.arange(0, 2 * math.pi, 0.002)
        ]
        found: BaseGeometry = metal.exterior if constants.get("side") == "inside" else metal.interiors[0]
    else:
        edge = [(2 + x, 4 + of_x(x)) for x in np.arange(0.7, 2.3, 0.002)]
        found = metal.boundary
    off = max(found.distance(Point(place)) for place in edge)
    assert off <= float(constants.get("tolerance", 0.005)) + 0.0001


SPOILT = {
    "a rapid at depth": (r"^G1 (X2.261)", r"G0 \1"),
    "no spindle": (r"^M3 S2000\n", ""),
    "too deep": (r"Z-0.5000", "Z-0.5001"),
    "no units": (r"G20 ", ""),
    "no end": (r"^M30\n", ""),
    "outside the stock": (r"X2.2610", "X2.2440"),
    "no lift first": (r"^G0 Z0.2500\nM3", "M3"),
    "no work offset": (r"G54 ", ""),
    "no feed": (r" F1.0", ""),
    "away before the retract": (r"^G0 Z0.2500\nM5", "G0 X3\nG0 Z0.2500\nM5"),
    "a rapid onto the stock": (r"^G0 Z0.0500", "G0 Z0.0000"),
    "left in the work": (r"^G0 Z0.2500\nM5", "M5"),
    "a word that grbl does not know": (r"^M3", "T1 M6\nM3"),
    "the spindle left on": (r"^M5\n", ""),
    "incremental": (r"G90 ", "G91 "),
}


def test_the_judge_finds_what_is_spoilt() -> None:
    good = "".join(f"{line}\n" for line in gcode(nc.cut(CIRCLE)))
    around = Stock((2.245, 2.245), (5.755, 5.755), 0.5)
    assert safety.faults(good.splitlines(), around) == []
    for name, (old, new) in SPOILT.items():
        with case(name):
            bad = re.sub(old, new, good, count=1, flags=re.MULTILINE)
            assert bad != good
            assert safety.faults(bad.splitlines(), around)
    assert safety.faults(good.splitlines(), around._replace(depth=0.4999))
    assert safety.faults([line for line in good.splitlines() if not line.startswith("G1")], around)


def test_every_code_of_the_machine(tmp_path: Path) -> None:
    """Holes, pecks, taps, stops and tools in every order stay safe, also with the feeds astray."""
    path = nc.cut(tape(HEADER[3]) + EVERYTHING[1:], settings=Settings(feed_error=(0.12345, -0.2, 0.2)))
    everywhere = Stock((0, 0), (20, 10), 5)
    for tool_change, allowed in ((False, set()), (True, LINUXCNC)):
        lines = [*gcode(path, Output(safe=400, tool_change=tool_change, pitch=50))]
        assert safety.faults(lines, everywhere, 0.4, allowed) == []
        words = {word for line in lines for word in re.sub(r"\(.*?\)", "", line).split()}
        assert {"M0", "M4", *(LINUXCNC if tool_change else ())} <= words
        if shutil.which("rs274"):
            went = safety.run(lines, 0.4, allowed).went
            ends = [end for end, _ in linuxcnc(lines, tmp_path)]
            assert len(ends) == len(went)
            assert ends[-1] == pytest.approx(went[-1].end, abs=0.00011)


def test_the_header_says_what_an_operator_has_to_know() -> None:
    assert [*gcode(nc.cut(CIRCLE), Output(250))][:20] == [
        "(Moog Hydra-Point tape of 1971, 666 blocks, about 14 min of cutting)",
        "(X 2.2500 to 5.7490, Y 2.2450 to 5.7550: the path of the cutter's centre)",
        "(cutter 0.2500 across, which no tape says: its edge goes 0.1250 further)",
        "(Z 0 is the stock's top, set it with the cutter on it: feed point 3.0000)",
        "(depth 0.5000, safe Z 0.2500, work offset G54)",
        "(spindle 2000 rpm, feeds 1 in/min)",
        "(left out: position X 19.0000 Y 0.0000 of block 1)",
        "(left out: position X 0.0000 Y 0.0000 of block 2)",
        "(left out: mist coolant of block 3)",
        "(left out: end of program of block 1)",
        "(left out: tool 01 of block 2, set Z 0 with it)",
        "G17 G20 G40 G49 G54 G61 G80 G90 G94",
        "G0 Z0.2500",
        "M3 S2000",
        "G4 P3",
        "G0 X2.2500 Y4.0000 (N7)",
        "G0 Z0.0500 (N7)",
        "G1 Z-0.5000 F1.0 (N7)",
        "G1 Y4.1330 (N7)",
        "G1 X2.2610 (N8)",
    ]


def after_the_header(*blocks: str, **settings: object) -> list[str]:
    lines = [*gcode(nc.cut(tape(*HEADER, *blocks)), Output(**settings))]  # type: ignore[arg-type]
    return [re.sub(r" \(N\d+\)", "", line) for line in lines[lines.index("G4 P3") + 1 :]]


MILL = "007 6 02250 04100 0 01 85"


def test_a_stop_between_two_cuts_has_the_cutter_up_and_still() -> None:
    again = ["G0 Z0.2500", "M3 S2000", "G4 P3", "G0 X2.2500 Y4.1000", "G0 Z0.0500", "G1 Z-0.5000"]
    first = ["G0 X2.2500 Y4.0000", "G0 Z0.0500", "G1 Z-0.5000 F1.0", "G1 Y4.1000", "G0 Z0.2500", "M5"]
    last = ["G1 Y4.2000", "G0 Z0.2500", "M5", "M30"]
    for block, stop, with_tools in (
        ("008 6 02250 04100 0 00 00", ["M0 (program stop of block 8)"], None),
        ("008 0 02250 04100 0 00 83", ["M0 (index work piece of block 8)"], None),
        (
            "008 0 02250 04100 0 05 86",
            ["M0 (tool 05 of block 8, set Z 0 with it)"],
            ["T5 M6 (tool 05 of block 8)", "G43"],
        ),
        (
            "008 0 02250 04100 0 06 06",
            ["M0 (tool 06 of block 8, set Z 0 with it)"],
            ["T6 M6 (tool 06 of block 8)", "G43"],
        ),
    ):
        with case(block):
            blocks = (MILL, block, "009 6 02250 04200 0 01 85")
            assert after_the_header(*blocks) == [*first, *stop, *again, *last]
            lines = after_the_header(*blocks, tool_change=True)
            assert lines == ["M7", *first, *(with_tools or stop), *again, *last[:-1], "M9", "M30"]


def test_what_is_fed_begins_above_the_stock() -> None:
    """A peck goes down again at its feed; a deeper feed point is not approached in a rapid."""
    peck = after_the_header("007 4 01000 01000 0 00 80", safe=30, shift=(500, -500))
    steps = [line for depth in (2, 3, 4, 5) for line in (f"G1 Z-0.{depth}000", "G0 Z0.0300")]
    assert peck == ["G0 X1.5000 Y0.5000", "G1 Z-0.1000 F1.0", "G0 Z0.0300", *steps, "M5", "M30"]
    lower = "008 9 03200 03400 0 01 89"
    there = after_the_header("007 5 01000 01000 0 00 80", lower, "009 5 01500 01000 0 00 80")
    assert there[4:] == ["G0 X1.5000", "G0 Z0.0500", "G1 Z-0.4000", "G0 Z0.2500", "M5", "M30"]
    header = [*gcode(nc.cut(tape(*HEADER, MILL, lower, MILL)))]
    assert (
        "(Z 0 is the stock's top, set it with the cutter on it: feed point 3.0000, others -0.2000)" in header
    )


def test_each_move_has_the_feed_of_its_axis_whichever_was_used_before() -> None:
    """Of Table 2.4, codes 05, 02 and 04: 5.5, 1.9 and 4.0 in/min."""
    corners, codes = [(2250, 5000), (2350, 5000), (2350, 5100), (2450, 5100), (2450, 5200)], (5, 2, 5, 2, 4)
    blocks = [
        f"{number:03} 6 {x:05} {y:05} 0 {code:02} {85 - number % 2}"
        for number, ((x, y), code) in enumerate(zip(corners, codes, strict=True), 8)
    ]
    for output in (Output(), Output(safe=30, shift=(-500, 250))):
        mill = safety.run([*gcode(nc.cut(tape(*HEADER, *blocks)), output)], output.safe / 1000)
        assert [move.feed for move in mill.went if move.feed][1:] == [5.5, 1.9, 5.5, 1.9, 4.0]


def test_a_tape_that_a_mill_cannot_cut_is_refused() -> None:
    with pytest.raises(WorkError, match="no block of this tape cuts"):
        [*gcode(nc.cut(tape(*HEADER)))]
    with pytest.raises(WorkError, match="block 2 cuts with the spindle at rest"):
        [*gcode(nc.cut(tape(*FOUR_HOLES[1:])))]


def fed(lines: Iterable[str]) -> Iterator[tuple[float, str]]:
    """Yield X and the coolant of each move that is fed; the spindle has to turn."""
    turning, coolant, x = False, {"M7": False, "M8": False}, 0.0
    for line in lines:
        words = re.sub(r"\(.*?\)", "", line).split()
        for word in words:
            turning = word in ("M3", "M4") or (turning and word not in ("M5", "M6"))
            coolant |= (
                dict.fromkeys(coolant, False) if word == "M9" else {word: True} if word in coolant else {}
            )
            x = float(word[1:]) if word[0] == "X" else x
        if "G1" in words:
            assert turning, line
            yield x, " ".join(name for name, on in coolant.items() if on)


def test_after_any_two_functions_the_cutter_turns_under_the_last_coolant() -> None:
    """A hole, a function, a hole, another function, a hole: in every program that can be written of it."""
    begin = ("001 0 00000 00000 0 31 88", "002 9 03000 03500 0 01 89", "003 5 01000 01000 0 01 80")
    words = {"mist": "M7", "flood": "M8", "off": ""}
    for functions in product(MISCELLANEOUS, (0, 6, 7, 8, 9, 86)):
        moves = [
            (f"004 0 02000 02000 0 01 {function:02}", f"005 5 0{at}000 01000 0 01 80")
            for at, function in zip((4, 6), functions, strict=True)
        ]
        path = nc.cut(tape(*begin, *moves[0], *moves[1]))
        wanted = [(x, words[path.steps[at].modes.coolant]) for x, at in ((1, 2), (4, 4), (6, 6))]
        dry = [(x, "") for x, _ in wanted]
        changing, plain = ([*gcode(path, Output(tool_change=given))] for given in (True, False))
        with case(functions):
            assert safety.run(changing, 0.25, LINUXCNC).faults == safety.run(plain, 0.25).faults == []
            for lines, expected in ((changing, wanted), (plain, dry), (gcode_1971(path), wanted)):
                assert [*dict.fromkeys(fed(lines))] == expected
