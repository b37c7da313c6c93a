"""Curves from measured points, and the other hand of a part."""

from typing import Literal

import pytest

from programs import circle, drill, slope
from programs.least_squares import fit
from programs.mirror import mirrored
from programs.points import read
from programs.stretches import Point
from tapes.errors import WorkError
from tapes.expression import function
from tests.programs.printouts import blocks


def test_points_of_a_polynomial_give_it_back() -> None:
    points = [(x / 4, 0.2 * (x / 4) * (x / 4 - 2) * (x / 4 - 6)) for x in range(26)]
    found = fit(points, 3)
    assert found.worst < 1e-9
    assert fit([(0, 0), (1, 0)], 1).expression == "0"
    assert function(found.expression)(3.3) == pytest.approx(0.2 * 3.3 * 1.3 * -2.7)


def test_a_line_through_three_points() -> None:
    """Least squares by hand: slope 1/2, height 1/6 at 0; the middle point is 1/3 off."""
    found = fit([(0, 0), (1, 1), (2, 1)], 1)
    assert found.worst == pytest.approx(1 / 3)
    assert function(found.expression)(0) == pytest.approx(1 / 6)
    assert function(found.expression)(2) == pytest.approx(7 / 6)


def test_points_are_read_with_their_comments() -> None:
    assert read("# x y\n0 1\n\n2, 3.5  # last\n") == [(0, 1), (2, 3.5)]
    for text, said in (("", "no points"), ("1 2\n3\n", "line 2"), ("1 nan\n", "line 1")):
        with pytest.raises(WorkError, match=said):
            read(text)


@pytest.mark.parametrize(("across", "twice"), [("x", 4000 + 8330), ("y", 4000 + 6500)])
def test_a_mirrored_part_has_the_other_hand(across: Literal["x", "y"], twice: int) -> None:
    printout = slope.part()
    for before, after in zip(blocks(printout), blocks(mirrored(printout, across)), strict=True):
        of_the_part = before.preparatory == 6 or before.function == 80
        place = twice - getattr(before, across) if of_the_part else getattr(before, across)
        assert after == before._replace(**{across: place})


def test_a_mirror_at_a_place() -> None:
    assert [block.x for block in blocks(mirrored(drill.part(), "x", 5000))][2:] == [9000, 9000, 6000, 6000]
    assert [block.x for block in blocks(mirrored(drill.part(), "x", 5000.5))][2:] == [9001, 9001, 6001, 6001]
    with pytest.raises(WorkError, match=r"mirror about 5\.00025 in: must be a whole number of half"):
        mirrored(drill.part(), "x", 5000.25)
    assert mirrored(mirrored(circle.part(), "y"), "y").replace(" ", "0") == circle.part().replace(" ", "0")


def test_what_cannot_be_mirrored() -> None:
    for printout, said in (
        ("12\n", "line 1"),
        ("  1019   0    0   2\n", "no block mills"),
        (drill.part(), r"block 3: X -2\.000"),
    ):
        with pytest.raises(WorkError, match=said):
            mirrored(printout, "x", -500)


def test_a_slope_in_pieces() -> None:
    """Two blocks at rest for the feeds of Figure 3.1, then equal pieces, of thousandths, to the very end."""
    cut = blocks(slope.pieces(Point(5000, 4000), Point(6000, 3001), 3, 12, 7))
    assert [(block.x, block.y, block.tool) for block in cut[-5:]] == [
        (5000, 4000, 12),
        (5000, 4000, 7),
        (5333, 3667, 7),
        (5667, 3334, 7),
        (6000, 3001, 7),
    ]
    assert cut[:-5] == blocks(slope.part(from_x=5, from_y=4, to_x=6, to_y=3.001))[: len(cut) - 5] != []
