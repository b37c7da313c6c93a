"""The registry: a new part program is its own file and an entry, and every command has it."""

from inspect import signature
from pathlib import Path

import pytest
from click import Choice
from click.testing import CliRunner

import programs
from pdp8.replay import replay
from programs import die, fluidic, thesis
from programs.cli import part
from programs.options import parameters
from programs.parts import PARTS, Part, find
from tapes.errors import WorkError

SQUARE = '''
"""A square of 1 in."""

from typing import Annotated

from programs.header import THESIS, Header
from programs.milling import SLOWEST, Milling
from programs.printout import Printout
from programs.stretches import Point, line
from programs.units import THOUSANDTHS

CORNERS = (Point(1000, 1000), Point(2000, 1000), Point(2000, 2000), Point(1000, 2000), Point(1000, 1000))


def part(
    *,
    tolerance: Annotated[float, "half the band", THOUSANDTHS] = 5,
    milling: Milling = SLOWEST,
    header: Header = THESIS,
) -> str:
    printout = Printout()
    printout.header(header, *CORNERS[0])
    for start, stop in zip(CORNERS, CORNERS[1:]):
        milling.print(printout, line(start, stop, tolerance))
    return printout.text
'''


@pytest.fixture
def square(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Add a part program as a user would: its file, and its entry in the registry."""
    (tmp_path / "square.py").write_text(SQUARE)
    monkeypatch.setattr(programs, "__path__", [*programs.__path__, str(tmp_path)])
    monkeypatch.setitem(PARTS, "square", Part("square", "A square of 1 in.", ("> square.asc",)))


@pytest.mark.usefixtures("square")
def test_a_new_part_program_is_its_file_and_its_entry() -> None:
    run = CliRunner()
    assert "A square of 1 in" in run.invoke(part, ["--help"]).output
    assert "--feed-error" in run.invoke(part, ["square", "--help"]).output
    tape = run.invoke(part, ["square", "--parity", "none"]).stdout_bytes
    assert tape.count(b"\r") == 6 + 4
    afternoon = replay("square")
    assert (len(afternoon.path), afternoon.path.gap) == (10, 0)


def test_no_such_part() -> None:
    with pytest.raises(WorkError, match="square: no such part program; there are circle, ellipse"):
        find("square")


@pytest.mark.parametrize("name", PARTS)
def test_every_entry_is_a_part_program(name: str) -> None:
    entry = PARTS[name]
    program = entry.program()
    assert program.__module__ == f"programs.{name}"
    if entry.has_defaults:
        assert program().endswith("\n")
    said = CliRunner().invoke(part, [name, "--help"]).output
    assert f"\n  Examples:\n    pdp8 part {name} {entry.examples[0]}\n" in said
    tolerance = signature(program).parameters.get("tolerance")
    assert tolerance is None or tolerance.default in (entry.tolerance, entry.tolerance * 1000)


def test_what_an_option_may_be() -> None:
    taken = (option for entry in PARTS.values() for option in parameters(entry.program()))
    assert {option.name: [*option.type.choices] for option in taken if isinstance(option.type, Choice)} == {
        "technique": ["step", "piece"],
        "stop": ["boundary", "inside"],
        "arithmetic": ["exact", "ge635", "ieee32", "cdc6400"],
        "overflow": ["low-digits", "stars"],
        "side": ["above", "below"],
        "cut": ["opening", "rounding", "groove"],
        "program": ["both", "main", "control"],
    }


TABLE_10_1 = """\
circle 670 30 30 200 9 9
ellipse 1000 50 50 400 18 18
die 800 40 200 350 16 120
polynomial 1200 55 55 N.A.
fluidic 2650 180 180 N.A."""


def test_the_dimensions_that_the_thesis_gives() -> None:
    """Chapter 7: a block of 12 by 8 by 2 in, 6 by 3 open; Chapter 8: a nozzle of .02 in, enlarged."""
    assert die.BLOCK == (12_000, 8_000, 2_000)
    wide = {"opening": (6_000, 3_000), "rounding": (6_250, 3_250), "groove": (7_500, 4_500)}
    assert {cut: (x / 2, y / 2) for cut, (x, y) in wide.items()} == die.AXES
    (_, _, wall, *_) = fluidic.RIGHT
    assert isinstance(wall, fluidic.Slope)
    nozzle = wall.start[0] + 0.125 / 2
    assert 2 * nozzle == pytest.approx(fluidic.SCALE * 0.02, abs=0.0011)
    assert len([piece for piece in fluidic.outline() if isinstance(piece, fluidic.Bend)]) == 9
    assert fluidic.TAPER == 7 / 38  # 10.4 degrees
    assert {PARTS[name].cutter for name in ("circle", "ellipse", "polynomial")} == {0.5}
    assert (PARTS["fluidic"].cutter, PARTS["fluidic"].instrument) == (0.125, "Talysurf")
    assert PARTS["circle"].instrument == "Talyrond"
    assert [name for name, entry in PARTS.items() if not entry.has_defaults] == ["curve"]


def test_table_10_1() -> None:
    rows = TABLE_10_1.replace(" N.A.", "").splitlines()
    ours = [(name, *row.step, *(row.piece or ())) for name, row in thesis.TABLE_10_1.items()]
    assert [" ".join(map(str, row)) for row in ours] == rows
    assert thesis.THESIS.keys() == thesis.TABLE_10_1.keys()
