"""The registry: a new part program is its own file and an entry, and every command has it."""

from collections.abc import Iterable
from inspect import signature
from itertools import pairwise
from math import cos, dist, radians, sin
from pathlib import Path
from typing import Any

import pytest
from click.testing import CliRunner

import programs
from pdp8.cli.part import part
from pdp8.replay import replay
from programs import die, fluidic, parts, slope, thesis
from programs.nominals import NOMINALS
from programs.parts import PARTS, Part
from tapes import ascii
from tests.programs.printouts import blocks, milled


def test_a_new_part_program_is_its_file_and_its_entry(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The file is a copy of the slope's."""
    (tmp_path / "chamfer.py").write_text(Path(slope.__file__).read_text())
    monkeypatch.setattr(programs, "__path__", [*programs.__path__, str(tmp_path)])
    monkeypatch.setitem(PARTS, "chamfer", Part("chamfer", "A slope of 30 degrees.", ("> chamfer.asc",)))
    run = CliRunner()
    assert "A slope of 30 degrees" in run.invoke(part, ["--help"]).output
    assert "--feed-error" in run.invoke(part, ["chamfer", "--help"]).output
    made = run.invoke(part, ["chamfer"]).stdout_bytes
    assert ascii.decode(made).splitlines() == slope.part().splitlines()
    assert replay("chamfer").path.blocks == replay("slope").path.blocks


def test_every_part_but_that_of_holes_has_a_nominal_curve() -> None:
    """Without one in programs/nominals.py its walls are measured against a guess."""
    assert set(PARTS) - {"drill"} == set(NOMINALS)


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
    nominal = entry.nominal() if entry.has_defaults else None
    assert not (nominal and tolerance) or tolerance.default in (nominal.tolerance, nominal.tolerance * 1000)


@pytest.mark.parametrize(
    ("words", "constants", "start", "end"),
    [
        ("polynomial", {}, (3250, 3216), (10250, 7328)),
        ("polynomial", {"cutter": 0.5}, (3005, 3265), (10003, 7367)),
        ("slope", {}, (4000, 4000), (8330, 6500)),
        ("curve sin(x)", {"to": 6.283}, (4000, 5000), (10283, 5000)),
        ("curve 1", {}, (4000, 6000), (8000, 6000)),
        ("die", {"cut": "groove"}, (2250, 4000), (2251, 3863)),
        ("fluidic", {"program": "main"}, (6938, 250), (6938, 250)),
        ("fluidic", {"program": "control", "control": 0.8}, (6266, 3400), (5734, 3400)),
        ("fluidic", {}, (6938, 250), (5882, 2600)),
    ],
)
def test_a_part_is_fit_for_the_machine(
    words: str, constants: dict[str, Any], start: tuple[int, int], end: tuple[int, int]
) -> None:
    """Travel, sequence, and that a cut moves along the axis that its function names and no other."""
    printout = parts.part(*words.split(), **constants)
    path = milled(printout)
    assert [path[0][2:4], path[-1][2:4]] == [start, end]
    for number, block in enumerate(blocks(printout), 1):
        assert (block.sequence, block.reserved) == (number % 1000, 0)
        assert block.x <= 20000, block
        assert block.y <= 10000, block
    for before, block in pairwise(path):
        if block.preparatory == 6:
            moves = {84: block.x != before.x, 85: block.y != before.y}
            assert [axis for axis, moved in moves.items() if moved] == [block.function], block
        else:
            assert (block.preparatory, block.tool, block.function) == (0, 0, 80), block


def test_a_thousand_holes_are_whole_blocks() -> None:
    made = blocks(parts.part("drill", holes=[(1, 1)] * 1000))
    assert [block.sequence for block in made] == [number % 1000 for number in range(1, 1003)]


def sloping(segments: Iterable[fluidic.Segment]) -> int:
    """Return how many of them are straight and along no axis."""
    lines = (segment for segment in segments if isinstance(segment, fluidic.Slope))
    return sum(one.start[0] != one.end[0] and one.start[1] != one.end[1] for one in lines)


def ends(segment: fluidic.Segment) -> list[tuple[float, float]]:
    if isinstance(segment, fluidic.Slope):
        return [segment.start, segment.end]
    (x, y), radius, start, sweep = segment
    angles = (radians(start), radians(start + sweep))
    return [(x + radius * cos(angle), y + radius * sin(angle)) for angle in angles]


def test_the_fluidic_element_is_of_chapter_8_s_make_up() -> None:
    """A nozzle of .02 in; "4 linear slope segments and 9 circular segments"; 4 slopes of the channels."""
    outline = fluidic.outline()
    for before, after in pairwise([*outline, outline[0]]):
        assert dist(ends(before)[1], ends(after)[0]) < 0.0015
    assert (sloping(outline), 2 * sloping(fluidic.channel(0))) == (4, 4)
    assert sum(isinstance(segment, fluidic.Bend) for segment in outline) == 9
    (_, _, wall, *_) = fluidic.RIGHT
    assert 2 * (ends(wall)[0][0] + 0.125 / 2) == pytest.approx(fluidic.SCALE * 0.02, abs=0.0011)
    assert fluidic.TAPER == 7 / 38  # 10.4 degrees


def test_the_line_that_is_inspected_is_a_wall_of_the_fluidic_element() -> None:
    nominal = parts.find("fluidic").nominal()
    assert nominal
    x, y, u, v = (1000 * inches for inches in nominal.numbers)
    stops = [(block.x, block.y) for block in milled(fluidic.part(program="main"))]
    for at in (0, 0.25, 0.5, 0.75, 1):
        assert min(dist(stop, (x + (u - x) * at, y + (v - y) * at)) for stop in stops) < 25


def test_the_control_channels_move_downstream_and_nothing_else_does() -> None:
    near, far = fluidic.part(control=0.0), fluidic.part(control=0.8)
    main = fluidic.part(program="main").count("\n")
    assert near.splitlines()[:main] == far.splitlines()[:main]
    ys = [max(block.y for block in blocks(part)[main:]) for part in (near, far)]
    assert ys[1] - ys[0] == 800


def test_what_the_thesis_gives() -> None:
    """Chapter 7: a block of 12 by 8 by 2 in, 6 by 3 open."""
    assert die.BLOCK == (12_000, 8_000, 2_000)
    wide = {"opening": (6_000, 3_000), "rounding": (6_250, 3_250), "groove": (7_500, 4_500)}
    assert {cut: (x / 2, y / 2) for cut, (x, y) in wide.items()} == die.AXES
    assert {PARTS[name].cutter for name in ("circle", "ellipse", "polynomial")} == {0.5}
    assert (PARTS["fluidic"].cutter, PARTS["fluidic"].instrument) == (0.125, "Talysurf")
    assert PARTS["circle"].instrument == "Talyrond"
    assert [name for name, entry in PARTS.items() if not entry.has_defaults] == ["curve", "profile"]


TABLE_10_1 = """\
circle 670 30 30 200 9 9
ellipse 1000 50 50 400 18 18
die 800 40 200 350 16 120
polynomial 1200 55 55
fluidic 2650 180 180"""


def test_table_10_1() -> None:
    ours = [(name, *row.step, *(row.piece or ())) for name, row in thesis.TABLE_10_1.items()]
    assert [" ".join(map(str, row)) for row in ours] == TABLE_10_1.splitlines()
    assert thesis.THESIS.keys() == thesis.TABLE_10_1.keys()
