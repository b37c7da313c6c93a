"""The ports print what the listings print, character for character: gfortran is the judge. FORMAT too."""

import re
import shutil
from collections.abc import Callable
from fractions import Fraction
from pathlib import Path
from typing import Any

import pytest

from programs import circle, drill, ellipse
from programs.arithmetic import ARITHMETICS
from programs.format import Format
from programs.header import Header
from programs.milling import Milling
from programs.printout import Printout
from tapes.hydrapoint import Block
from tests.nc.tapes_1971 import FOUR_HOLES
from tests.programs import fortran
from tests.programs.printouts import milled

PORTS = pytest.mark.parametrize(("name", "part"), [("circle", circle.part), ("ellipse", ellipse.part)])
gfortran = pytest.mark.skipif(not shutil.which("gfortran"), reason="gfortran is not installed")


def listing(name: str) -> str:
    return (fortran.LISTINGS / f"{name}.for").read_text()


@gfortran
@PORTS
def test_gfortran_prints_the_same(name: str, part: Callable[[], str], tmp_path: Path) -> None:
    """In single precision and in double."""
    for options in ((), ("-fdefault-real-8",)):
        theirs = fortran.printout(listing(name), tmp_path, *options)
        assert part().split("\n") == theirs.split("\n")


ALIKE: dict[str, Any] = {
    "header": Header(18765, 4321, tool=12, coolant=7, spindle=22, z_feed_point=2500, z_depth=4000, z_feed=3),
    **{"preparatory": 5, "x_feed": 85, "y_feed": 84, "milling": Milling(feed_code=2)},
    "arithmetic": ARITHMETICS["ieee32"],
}
"""Every constant of a listing, with another value, as ours has it, ..."""
OURS: dict[str, dict[str, Any]] = {
    "circle": {"radius": 222, "outer": 246, "inner": 238, "start_y": 17, "sequence": 40}
    | {"centre_x": 5000, "centre_y": 4400},
    "ellipse": {"major": 906, "minor": 641, "outer_major": 1003, "outer_minor": 704, "inner_major": 996}
    | {"inner_minor": 697, "start_y": 13, "sequence": 20, "centre_x": 5000, "centre_y": 4500},
}
THEIRS = {
    "circle": "E3=44170. AS=40. AY=17. RAD=222. ARL=246. ARS=238. AXX=5000. AYY=4400.",
    "ellipse": "E3=45130. AS=20. CX=5000. CY=4500. AC=906. BC=641. AA=1003. BB=704. A=996. B=697. AY=13.",
}
PARKED = "A1=1018. A2=7650. A3=43210. B4=1286. C4=7. D4=2288. G1=6902. G2=5000. G3=40000. G4=389."
"""... and as FORTRAN has it."""


@gfortran
@PORTS
def test_changed_constants_change_both_alike(name: str, part: Callable[..., str], tmp_path: Path) -> None:
    """The circle's quadrants end against RAD here; the start is within the band, beyond it, on the axis."""
    for start_x in {"circle": (240, 246), "ellipse": (990, 1003, 0)}[name]:
        source, x = listing(name), 5000 - start_x
        start = f"AX={start_x}. E1={5000 + x // 1000}. E2={x % 1000}0."
        for value in f"{PARKED} AP=5. AT=2. AMX=85. AMY=84. {start} {THEIRS[name]}".split():
            constant = value.partition("=")[0]
            source, found = re.subn(rf"(?<=[ \d]) {constant}=\d+\.", f" {value}", source)
            assert found, value
        ours = part(start_x=start_x, **ALIKE, **OURS[name])
        assert ours.split("\n") == fortran.printout(source, tmp_path).split("\n")


def test_a_circle_that_starts_above_its_centre_is_the_ellipse_s() -> None:
    """FORTRAN has no inner limit there: statement 41 sets it, and is passed over."""
    parts = circle.part(radius=200, start_x=0), ellipse.part(major=200, minor=200, start_x=0)
    ours, ellipses = ([cut[2:4] for cut in milled(part)] for part in parts)
    assert ours == ellipses


def test_a_closed_ellipse_has_one_block_more() -> None:
    lines = ellipse.part(close=True).splitlines()
    assert lines[-2:] == ["9766  997 3900  584", "9776  997 4000  585"]


@pytest.mark.parametrize("name", ["circle", "ellipse"])
def test_listing_lines_are_numbered_by_five(name: str) -> None:
    numbers = [int(line[:3]) for line in listing(name).splitlines()]
    assert numbers == list(range(100, numbers[-1] + 1, 5))


def test_a_line_as_format_has_it() -> None:
    """An I-field takes the whole part of a REAL."""
    assert Format("1X,I5,I4,I5,I4").line(1019, 0, 0, 2) == "  1019   0    0   2\n"
    assert Format("2X,I2,I5").line(5, -12) == "   5  -12\n"
    assert Format("I3,I5").line(1000, 23456) == "00023456\n"
    assert Format("I3,I5").line(1000, 23456, overflow="stars") == "***23456\n"
    for value, printed in ((2.9, "  2"), (-2.9, " -2"), (0.9999, "  0"), (99.5, " 99")):
        for real in (Fraction(str(value)), *(machine.real(value) for machine in ARITHMETICS.values())):
            assert Format("I3").line(real) == f"{printed}\n"


def test_a_block_by_the_digits_of_its_groups() -> None:
    printout = Printout()
    printout.print_10(Block(76, 0, 19234, 4321, 0, 31, 88))
    assert printout.text == " 760192340432103188\n"


def test_the_drilling_tape_is_chapter_3s() -> None:
    assert drill.part().splitlines() == [digits.replace(" ", "") for digits in FOUR_HOLES]
