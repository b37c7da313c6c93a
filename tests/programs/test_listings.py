"""The ports print what the listings print, character for character; gfortran is the judge."""

import shutil
from collections.abc import Callable
from pathlib import Path

import pytest

from programs import circle, ellipse
from programs.arithmetic import ARITHMETICS
from programs.milling import Milling
from tests.programs import fortran

PORTS = pytest.mark.parametrize(("name", "part"), [("circle", circle.part), ("ellipse", ellipse.part)])
gfortran = pytest.mark.skipif(not shutil.which("gfortran"), reason="gfortran is not installed")


def listing(name: str) -> str:
    return (fortran.LISTINGS / f"{name}.for").read_text()


def assert_same_printout(ours: str, expected: str) -> None:
    """Compare two printouts; the first block that differs is shown."""
    pairs = zip(ours.splitlines(), expected.splitlines(), strict=False)
    for number, (line, wanted) in enumerate(pairs, 1):
        assert line == wanted, f"block {number:03}: {line!r}, expected {wanted!r}"
    assert len(ours) == len(expected)


@gfortran
@PORTS
def test_gfortran_prints_the_same(name: str, part: Callable[[], str], tmp_path: Path) -> None:
    assert_same_printout(part(), fortran.printout(listing(name), tmp_path))


@gfortran
@PORTS
def test_double_precision_prints_the_same(name: str, part: Callable[[], str], tmp_path: Path) -> None:
    assert_same_printout(part(), fortran.printout(listing(name), tmp_path, "-fdefault-real-8"))


@gfortran
def test_changed_constants_change_both_alike(tmp_path: Path) -> None:
    changed = (
        listing("ellipse")
        .replace("AC=3000.", "AC=1000.")
        .replace("AX=3000.", "AX=1000.")
        .replace("BC=2250.", "BC=700.")
        .replace("AA=3005.", "AA=1003.")
        .replace("BB=2255.", "BB=703.")
        .replace(" A=2995.", " A=997.")
        .replace(" B=2245.", " B=697.")
        .replace("AT=5.", "AT=2.")
        .replace("CX=4000.", "CX=5000.")
        .replace("E1=5001.", "E1=5004.")
    )
    ours = ellipse.part(
        major=1000,
        minor=700,
        tolerance=3,
        milling=Milling(feed_code=2),
        centre_x=5000,
        arithmetic=ARITHMETICS["ieee32"],
    )
    assert_same_printout(ours, fortran.printout(changed, tmp_path))


@gfortran
def test_the_exit_against_rad_and_the_numbering_are_the_listings(tmp_path: Path) -> None:
    changed = listing("circle").replace(" RAD=1750.", " RAD=900. ")
    ours = circle.part(radius=900, start_x=1750, inner=1745, outer=1755)
    assert ours.count("\n") < 666
    assert_same_printout(ours, fortran.printout(changed, tmp_path))


def test_the_circle_by_its_landmarks() -> None:
    lines = circle.part().splitlines()
    assert lines[:7] == [
        "  1019   0    0   2",
        "  2000   0    0 186",
        "  3000   0    0   8",
        "  4000   0    03188",
        "  5002250040000  80",
        "  6903   035000 189",
        "  76 2250 4133  185",
    ]
    assert len(lines) == 666
    assert lines[-1] == "6666 2251 3844  184"
    assert [line[:3] for line in lines[6:]] == [f"{number:3}" for number in range(7, 667)]


def test_the_ellipse_by_its_landmarks() -> None:
    lines = ellipse.part().splitlines()
    assert lines[4] == "  5001   040000  80"
    assert lines[6] == "  76 1000 4131  585"
    assert len(lines) == 976
    assert lines[586] == "5876 6404 2647  585"


def test_the_die_ellipse_has_778_blocks() -> None:
    assert ellipse.part(minor=1500).count("\n") == 772 + 6


@pytest.mark.parametrize("name", ["circle", "ellipse"])
def test_listing_lines_are_numbered_by_five(name: str) -> None:
    numbers = [int(line[:3]) for line in listing(name).splitlines()]
    assert numbers == list(range(100, numbers[-1] + 1, 5))
