"""G-code as of 1971 run by interpreters that are not ours, DXF read back by ezdxf."""

import io
import random
import re
import shutil
import subprocess
import sys
from collections.abc import Iterable, Iterator
from dataclasses import replace
from pathlib import Path

import ezdxf
import numpy as np
import pygcode  # type: ignore[import-untyped]
import pytest
from ezdxf.entities.lwpolyline import LWPolyline

import nc
from nc.curves import Ellipse, StraightLine
from nc.dxf import dxf
from nc.gcode_1971 import gcode_1971
from nc.inspection import inspect
from nc.machine import Settings
from nc.path import MoveKind
from nc.report import inspection_report
from nc.unit import MM
from tapes.errors import WorkError
from tests.nc.tapes_1971 import CIRCLE, FOUR_HOLES, HEADER, tape
from tests.nc.test_second_machine import ALL_SET, program
from tests.reference.hydrapoint import SELECTS

SLOPE = tape(*HEADER, "007 6 02250 04000 0 02 84", "008 6 05250 05000 0 01 85")


def everything() -> Iterator[str]:
    """Yield a program with every code of Tables 2.3 and 2.4, and cuts, holes and stops between them."""
    yield from ALL_SET
    draw = random.Random(1)
    for code, tools in SELECTS.items():
        for tool in tools:
            yield f"001 6 {draw.randrange(20000):05} {draw.randrange(10000):05} 0 {tool:02} {code}"
            yield f"002 {draw.choice((1, 4, 5, 7, 8))} {draw.randrange(20000):05} 02000 0 00 80"
    for _ in range(8):
        yield from program(draw)


EVERYTHING = tape(HEADER[3], *everything())
PITCH = 0.05
FEEDS = (MoveKind.MILL, MoveKind.FEED_IN, MoveKind.FEED_OUT)
Event = tuple[object, ...]


def events(path: nc.Path) -> Iterator[Event]:
    """Yield each move, its end in inches, its feed, spindle (- as a tap comes out) and coolant; each stop and
    the spindle then, each tool. First the quill is up; from the work it goes to the top before all is off.
    """
    yield (0, 0, 0), None, 0, "off"
    for step in path.steps:
        turning = step.modes.spindle or 0
        for move in step.moves:
            x, y, z = move.end
            taps = step.block.preparatory in (1, 8)
            speed = turning * PITCH if taps else move.speed
            feed = round(speed, 4) if move.kind in FEEDS else None
            way = -1 if move.kind == MoveKind.FEED_OUT and taps else 1
            yield (x / 1000, y / 1000, -z / 1000), feed, way * turning, step.modes.coolant
        if step.tool_changed:
            yield "tool", step.modes.tool
        elif step.stop or step.block.miscellaneous == 83:
            yield "stop", 0 if step.block.miscellaneous == 6 else turning
    if step.at.z:
        yield (step.at.x / 1000, step.at.y / 1000, 0), None, step.modes.spindle or 0, step.modes.coolant


CANON = re.compile(r"^ *\d+ +N\S+ +(\w+)\((.*)\)$", re.MULTILINE)


def linuxcnc(lines: Iterable[str], folder: Path) -> Iterator[Event]:
    """Yield the same of a program as LinuxCNC's interpreter carries it out; the coolants that are on."""
    (folder / "part.ngc").write_text("\n".join(lines) + "\n")
    (folder / "tools").write_text("".join(f"T{tool} P{tool} Z0 D0.5\n" for tool in range(1, 25)))
    (folder / "variables").touch()
    command = [str(shutil.which("rs274")), "-g", "-t", "tools", "-v", "variables", "part.ngc", "canon"]
    subprocess.run(command, cwd=folder, check=True, capture_output=True, timeout=60)
    speed = turning = feed = 0.0
    coolants: set[str] = set()
    for call, given in CANON.findall((folder / "canon").read_text()):
        match call, given.split(", "):
            case "STRAIGHT_FEED" | "STRAIGHT_TRAVERSE", [*place, _, _, _]:
                at = tuple(map(float, place))
                yield at, feed if call == "STRAIGHT_FEED" else None, turning, "+".join(coolants) or "off"
            case "SET_FEED_RATE", [rate]:
                feed = float(rate)
            case "SET_SPINDLE_SPEED", [_, rpm]:
                speed = float(rpm)
                turning = speed if turning else 0
            case "START_SPINDLE_CLOCKWISE", _:
                turning = speed
            case "START_SPINDLE_COUNTERCLOCKWISE", _:
                turning = -speed
            case "STOP_SPINDLE_TURNING", _:
                turning = 0
            case (("MIST_ON" | "FLOOD_ON"), _):
                coolants.add(call[:-3].lower())
            case (("MIST_OFF" | "FLOOD_OFF"), _):
                coolants.discard(call[:-4].lower())
            case "SELECT_TOOL", [tool]:
                yield "tool", int(tool)
            case "PROGRAM_STOP", _:
                yield "stop", turning


@pytest.mark.skipif(not shutil.which("rs274"), reason="LinuxCNC's interpreter (rs274) is not installed")
@pytest.mark.parametrize("frames", [CIRCLE, EVERYTHING], ids=["circle", "everything"])
def test_linuxcnc_does_the_same(frames: bytes, tmp_path: Path) -> None:
    path = nc.cut(frames, settings=Settings(feed_error=(0.12345, -0.2, 0.2)))
    lines = gcode_1971(path, 1000 * PITCH if frames is EVERYTHING else 0)
    for here, there in zip(linuxcnc(lines, tmp_path), events(path), strict=True):
        assert here[1:] == there[1:], f"{here}, not {there}"
        assert here[0] == (pytest.approx(there[0], abs=0.00011) if len(there) > 2 else there[0])


def test_pygcode_goes_the_same_way() -> None:
    """The judge where LinuxCNC is not installed."""
    path = nc.cut(EVERYTHING[: 1 + 20 * 60], settings=Settings(feed_error=(0.1, -0.2, 0.2)))
    machine = pygcode.Machine()
    went = []
    for line in gcode_1971(path, 1000 * PITCH):
        block = pygcode.Line(line).block
        machine.process_block(block)
        for code in block.gcodes:
            if code.word_key in ("G00", "G01"):
                feed = machine.mode.feed_rate.word.value if code.word_key == "G01" else None
                went.append((tuple(machine.pos.values[axis] for axis in "XYZ"), feed))
    moves = [event for event in events(path) if len(event) > 2]
    for (place, feed), (at, expected, *_) in zip(went, moves, strict=True):
        assert (pytest.approx(place, abs=0.00006), feed) == (at, expected)


def test_the_header_of_the_circle() -> None:
    lines = list(gcode_1971(nc.cut(CIRCLE)))
    assert [*lines[:7], *lines[9:14], *lines[-4:]] == [
        "(Moog Hydra-Point 83-1000 MC, 20-row block tape)",
        "G20 G90 G17 G94 G40 G80 G61",
        "G0 Z0.0000 (the quill is up)",
        "N1 G0 X19.0000 Y0.0000",
        "N1 M0 (001 0 19000 00000 0 00 02)",
        "N2 G0 X0.0000 Y0.0000",
        "N2 T1 M6 (002 0 00000 00000 0 01 86)",
        "N5 G0 X2.2500 Y2.2500",
        "N5 G0 X2.2500 Y4.0000 (005 0 02250 04000 0 00 80)",
        "N6 (006 9 03000 03500 0 01 89)",
        "N7 G0 Z-3.0000",
        "N7 G1 Z-3.5000 F1.0",
        "G0 Z0.0000 (the tape ends here)",
        "M5",
        "M9",
        "M2",
    ]


def test_a_tape_that_starts_no_spindle_says_so() -> None:
    assert list(gcode_1971(nc.cut(tape(FOUR_HOLES[0]))))[1].startswith("G20")
    assert list(gcode_1971(nc.cut(tape("001 0 01000 00000 0 00 80"))))[1] == "(the tape starts no spindle)"


def test_a_line_s_number_has_five_digits_at_the_most() -> None:
    path = nc.cut(tape(FOUR_HOLES[0]))
    steps = tuple(replace(path.steps[0], number=number) for number in (99_999, 100_000))
    assert [line.split()[0] for line in gcode_1971(replace(path, steps=steps))][3:5] == ["N99999", "(001"]


def read_back(text: str) -> "ezdxf.document.Drawing":
    drawing = ezdxf.read(io.StringIO(text))  # type: ignore[attr-defined]
    audit = drawing.audit()
    assert not audit.errors
    assert not audit.fixes
    return drawing


def test_the_circle_as_dxf() -> None:
    path = nc.cut(CIRCLE + tape("667 0 02251 00000 0 00 80")[1:])
    drawing = read_back(dxf(path, Ellipse(4000, 4000, 1750, 1750)))
    assert (drawing.units, drawing.header["$MEASUREMENT"]) == (ezdxf.units.IN, 0)
    assert {layer.dxf.name: (layer.color, layer.dxf.linetype) for layer in drawing.layers} == {
        "0": (7, "Continuous"),
        "Defpoints": (7, "Continuous"),
        "MILL": (5, "CONTINUOUS"),
        "POSITION": (8, "DASHED"),
        "HOLES": (1, "CONTINUOUS"),
        "CURVE": (3, "DASHED"),
    }
    milled, curve = drawing.query("LWPOLYLINE")
    assert isinstance(milled, LWPolyline)
    assert isinstance(curve, LWPolyline)
    assert (milled.dxf.layer, milled.dxf.elevation, milled.closed) == ("MILL", 0, False)
    places = [path.cuts[0].start, *(move.end for move in path.cuts)]
    expected = np.array([(at.x / 1000, at.y / 1000) for at in places])
    assert np.array(milled.get_points("xy")) == pytest.approx(expected)
    assert (curve.dxf.layer, curve.closed) == ("CURVE", True)
    assert np.hypot(*(np.array(curve.get_points("xy")) - 4).T) == pytest.approx(1.75)
    assert len(drawing.query("LINE")) == 0  # 1971's parking
    low, high = drawing.header["$EXTMIN"], drawing.header["$EXTMAX"]
    assert [*low[:2], *high[:2]] == pytest.approx([2.25, 2.245, 5.75, 5.755])


def test_the_circle_that_the_listing_closes_is_a_closed_polyline() -> None:
    """Its last block ends .001 in, the machine's least move, from where it began."""
    path = nc.cut(CIRCLE + tape("667 6 02251 04000 0 01 85")[1:])
    milled, _ = read_back(dxf(path, Ellipse(4000, 4000, 1750, 1750))).query("LWPOLYLINE")
    assert isinstance(milled, LWPolyline)
    assert (path.gap, milled.closed) == (1, True)
    assert tuple(milled.get_points("xy")[-1]) == (2.251, 4)
    assert not any("not closed" in line for line in inspection_report(inspect(path)))


def test_a_cut_of_no_length_is_not_drawn() -> None:
    path = nc.cut(SLOPE)
    cut = path.cuts[0]
    stays = replace(cut, start=cut.end, end=cut.end)
    for moves, points in (((cut, stays), 2), ((stays, cut), 2), ((stays,), 0)):
        step = replace(path.steps[-1], moves=moves)
        found = read_back(dxf(replace(path, steps=(step,)), Ellipse(4000, 4000, 1750, 1750)))
        milled = [line for line in found.query("LWPOLYLINE") if line.dxf.layer == "MILL"]
        assert sum(len(line) for line in milled if isinstance(line, LWPolyline)) == points, moves


def test_the_four_holes_as_dxf() -> None:
    path = nc.cut(tape(*FOUR_HOLES))
    for text, radius in ((dxf(path), 0.25), (dxf(path, cutter=250), 0.125)):
        holes = read_back(text).query('CIRCLE[layer=="HOLES"]')
        places = [(x, y, 0, radius) for x, y in ((1, 1), (1, 2), (4, 2), (4, 1))]
        assert [(*hole.dxf.center, hole.dxf.radius) for hole in holes] == places


def drawn(text: str) -> np.ndarray:
    """Return X, Y and Z of everything in a drawing, its extents last."""
    drawing, places = read_back(text), list[tuple[float, ...]]()
    for line in drawing.query("LINE"):
        places += [tuple(line.dxf.start), tuple(line.dxf.end)]
    for milled in drawing.query("LWPOLYLINE"):
        assert isinstance(milled, LWPolyline)
        places += [(x, y, milled.dxf.elevation) for x, y in milled.get_points("xy")]
    places += [tuple(hole.dxf.center) for hole in drawing.query("CIRCLE")]
    return np.array([*places, drawing.header["$EXTMIN"], drawing.header["$EXTMAX"]])


def test_everything_in_a_drawing_is_shifted_in_its_unit_and_at_its_depth() -> None:
    """Two cuts, a hole from another feed point, and a curve that is open."""
    cuts = ("007 6 02250 04100 0 01 85", "008 0 04000 04100 0 01 80", "009 6 04000 04500 0 01 85")
    path = nc.cut(tape(*HEADER, *cuts, "010 9 03200 03400 0 01 89", "011 5 01500 01000 0 00 80"))
    line = StraightLine(500, 4000, 5000, 6000)
    plain = drawn(dxf(path, line))
    assert [*plain[0], *plain[1]] == [2.25, 4.1, 0, 4, 4.1, 0]
    curve = read_back(dxf(path, line)).query('LWPOLYLINE[layer=="CURVE"]').first
    assert isinstance(curve, LWPolyline)
    assert not curve.closed
    assert [*curve.get_points("xy")[0], *curve.get_points("xy")[-1]] == [0.5, 4, 5, 6]
    assert [*plain[-2], *plain[-1]] == [0.5, 0.75, 0, 5, 6, 0]
    assert drawn(dxf(path, line, shift=(1000, -500))) == pytest.approx(plain + np.array([1, -0.5, 0]))
    assert drawn(dxf(path, line, unit=MM)) == pytest.approx(plain * 25.4)
    header = read_back(dxf(path, line, unit=MM)).header
    assert (header["$INSUNITS"], header["$MEASUREMENT"]) == (ezdxf.units.MM, 1)
    deep = drawn(dxf(path, line, depth=True))
    assert deep[:, :2] == pytest.approx(plain[:, :2])
    assert sorted({*deep[:, 2]}) == [-0.5, -0.4, 0]


def test_the_same_path_is_the_same_drawing() -> None:
    """Also in another process: what a set names is sorted."""
    text = dxf(nc.cut(SLOPE))
    assert text == dxf(nc.cut(SLOPE))
    assert not ezdxf.options.write_fixed_meta_data_for_testing  # type: ignore[attr-defined]
    used = [name for name in re.findall("\nCLASS\n  1\n(.*)\n", text) if f"\n  0\n{name}\n" in text]
    assert used == sorted(used)


def test_without_ezdxf_one_sentence_says_what_to_do(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "ezdxf", None)
    with pytest.raises(WorkError, match="needs ezdxf"):
        dxf(nc.cut(SLOPE))
