"""G-code run by interpreters that are not ours, DXF read back by ezdxf."""

import io
import re
import shutil
import subprocess
import sys
from pathlib import Path

import ezdxf
import numpy as np
import pygcode  # type: ignore[import-untyped]
import pytest
from ezdxf.entities.lwpolyline import LWPolyline

import nc
from nc.curves import Ellipse
from nc.dxf import dxf
from nc.gcode import gcode
from nc.machine import Settings
from nc.path import MoveKind, Position
from tapes import shelf
from tapes.errors import WorkError
from tests.nc.tapes_1971 import CIRCLE, FOUR_HOLES, HEADER, tape

SLOPES = tape(*HEADER, "007 6 02250 04000 0 02 84", "008 6 05250 05000 0 01 85", "009 6 01333 02777 0 04 84")
TAPES = {
    "circle": CIRCLE,
    "ellipse": shelf.read("ellipse.eia"),
    "four holes": tape(*FOUR_HOLES),
    "slopes": SLOPES,
    "every preparatory function": tape(
        *HEADER,
        *(f"01{code} {code} 01{code}00 02000 0 03 89" for code in (1, 4, 5, 7, 8)),
        "020 6 03000 02000 0 05 84",
        "021 0 04000 02000 0 12 86",
        "022 0 04000 02000 0 00 83",
        "023 0 04000 02000 0 00 09",
    ),
}


def signed(point: Position) -> tuple[float, float, float]:
    return point.x / 1000, point.y / 1000, -point.z / 1000


def travelled(path: nc.Path) -> list[tuple[bool, tuple[float, float, float]]]:
    """Return for each move whether it is at a feed, and where it ends in inches."""
    feeds = (MoveKind.MILL, MoveKind.FEED_IN, MoveKind.FEED_OUT)
    return [(move.kind in feeds, signed(move.end)) for move in path.moves]


@pytest.mark.parametrize("name", TAPES)
def test_pygcode_goes_the_same_way_in_the_same_time(name: str) -> None:
    path = nc.cut(TAPES[name], settings=Settings(feed_error=(0.1, -0.2, 0.2)))
    machine = pygcode.Machine()
    went, minutes = [], 0.0
    for line in gcode(path):
        before = machine.pos
        block = pygcode.Line(line).block
        machine.process_block(block)
        if machine.pos != before or any(code.word_key in ("G00", "G01") for code in block.gcodes):
            way = machine.pos - before
            length = sum(value**2 for value in way.values.values()) ** 0.5
            at_feed = str(machine.mode.modal_groups[1]).startswith("G01")
            minutes += length / machine.mode.feed_rate.word.value if at_feed else 0
            went.append((at_feed, tuple(machine.pos.values[axis] for axis in "XYZ")))
    assert [at_feed for at_feed, _ in went] == [at_feed for at_feed, _ in travelled(path)]
    for (_, here), (_, there) in zip(went, travelled(path), strict=True):
        assert here == pytest.approx(there, abs=0.00006)
    assert minutes * 60 == pytest.approx(path.times.milling + path.times.z_feed, abs=0.05)


RS274 = shutil.which("rs274")
CANON = re.compile(r"STRAIGHT_(TRAVERSE|FEED)\((-?[\d.]+), (-?[\d.]+), (-?[\d.]+),")


@pytest.mark.skipif(RS274 is None, reason="LinuxCNC's interpreter (rs274) is not installed")
@pytest.mark.parametrize("name", TAPES)
def test_linuxcnc_goes_the_same_way(name: str, tmp_path: Path) -> None:
    path = nc.cut(TAPES[name])
    (tmp_path / "part.ngc").write_text("\n".join(gcode(path)) + "\n")
    (tmp_path / "tools").write_text("".join(f"T{tool} P{tool} Z0 D0.5\n" for tool in range(1, 25)))
    (tmp_path / "variables").touch()
    subprocess.run(
        [str(RS274), "-g", "-t", "tools", "-v", "variables", "part.ngc", "canon"],
        cwd=tmp_path,
        check=True,
        capture_output=True,
        timeout=60,
    )
    found = CANON.findall((tmp_path / "canon").read_text())
    went = [(how == "FEED", tuple(map(float, place))) for how, *place in found]
    assert len(went) == len(path.moves)
    for (at_feed, here), (feeds, there) in zip(went, travelled(path), strict=True):
        assert at_feed == feeds
        assert here == pytest.approx(there, abs=0.00011)


def test_every_milling_block_is_one_line() -> None:
    lines = [line for line in gcode(nc.cut(CIRCLE)) if line.endswith("84)") or line.endswith("85)")]
    assert len(lines) == 660
    assert lines[:2] == [
        "N7 G1 Y4.1330 F1.0 (007 6 02250 04133 0 01 85)",
        "N8 G1 X2.2610 F1.0 (008 6 02261 04133 0 01 84)",
    ]


def test_the_header_of_the_circle() -> None:
    assert list(gcode(nc.cut(CIRCLE)))[:13] == [
        "(Moog Hydra-Point 83-1000 MC, 20-row block tape)",
        "G20 G90 G17 G94 G40 G80 G61",
        "N1 G0 X19.0000",
        "N1 M0 (001 0 19000 00000 0 00 02)",
        "N2 G0 X0.0000",
        "N2 T1 M6 (002 0 00000 00000 0 01 86)",
        "N3 M7 (003 0 00000 00000 0 00 08)",
        "N4 S2000 M3 (004 0 00000 00000 0 31 88)",
        "N5 G0 X2.2500 Y2.2500",
        "N5 G0 Y4.0000 (005 0 02250 04000 0 00 80)",
        "N6 (006 9 03000 03500 0 01 89)",
        "N7 G0 Z-3.0000",
        "N7 G1 Z-3.5000 F1.0",
    ]


def read_back(text: str) -> "ezdxf.document.Drawing":
    drawing = ezdxf.read(io.StringIO(text))  # type: ignore[attr-defined]
    audit = drawing.audit()
    assert not audit.errors
    assert not audit.fixes
    return drawing


def test_the_circle_as_dxf() -> None:
    path = nc.cut(CIRCLE)
    drawing = read_back(dxf(path, Ellipse(4000, 4000, 1750, 1750)))
    assert drawing.units == ezdxf.units.IN
    space = drawing.modelspace()
    (milled,) = space.query('LWPOLYLINE[layer=="MILL"]')
    assert isinstance(milled, LWPolyline)
    places = [path.cuts[0].start, *(move.end for move in path.cuts)]
    expected = np.array([(at.x / 1000, at.y / 1000) for at in places])
    assert np.array(milled.get_points("xy")) == pytest.approx(expected)
    assert milled.dxf.elevation == pytest.approx(-3.5)
    (curve,) = space.query('LWPOLYLINE[layer=="CURVE"]')
    assert isinstance(curve, LWPolyline)
    assert curve.closed
    assert len(space.query('LINE[layer=="POSITION"]')) == 4


def test_the_four_holes_as_dxf() -> None:
    space = read_back(dxf(nc.cut(tape(*FOUR_HOLES)), cutter=250)).modelspace()
    holes = [(*hole.dxf.center, hole.dxf.radius) for hole in space.query('CIRCLE[layer=="HOLES"]')]
    assert holes == [(1, 1, -3.5, 0.125), (1, 2, -3.5, 0.125), (4, 2, -3.5, 0.125), (4, 1, -3.5, 0.125)]


def test_the_same_path_is_the_same_drawing() -> None:
    assert dxf(nc.cut(SLOPES)) == dxf(nc.cut(SLOPES))


def test_without_ezdxf_one_sentence_says_what_to_do(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "ezdxf", None)
    with pytest.raises(WorkError, match=r"pip install 'pdp8\[nc\]'"):
        dxf(nc.cut(SLOPES))
