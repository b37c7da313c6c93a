"""What is measured of a flat tape, against what was drawn; and what makes a frame doubtful, at each limit."""

from copy import deepcopy
from typing import Any

import numpy as np
import pytest

from tapes.photograph import Frame, cells, reader
from tapes.photograph.cells import Cells
from tapes.photograph.flat import BEYOND, SAMPLES, Flat, flatten
from tapes.photograph.paper import Found
from tapes.photograph.pixels import Array
from tests.tapes.photograph import straight
from tests.tapes.photograph.straight import CODE, FEED

LENGTH = 20
CODES = [(u, v) for u in range(4, LENGTH) for v in straight.TRACKS if (7 * u + 3 * v * v) % 5 < 2]


def slope(u: Array, v: Array) -> Array:
    """Return the light of paper on which it falls along and across."""
    return np.asarray(150 + 4 * u + 6 * v)


def test_cells_are_measured_beside_the_paper_at_their_corners() -> None:
    """Holes lose .7 of the light; a Gaussian of .11 is in a disc by 1 - exp(-radius**2 / 2 / .11**2)."""
    u = np.arange((LENGTH + 6) * SAMPLES + 1) / SAMPLES - BEYOND
    v = np.arange(16 * SAMPLES + 1)[:, None] / SAMPLES - 8
    dark = np.zeros((len(v), len(u)))
    angle = np.radians(22.5 + 3 * 45)
    discs = [(2.0, -2 + 0.2, 0.1), (1 + 0.52 * np.cos(angle), 4 + 0.52 * np.sin(angle), 0.07)]
    discs += [*((at, 0, FEED) for at in range(LENGTH)), *((*code, CODE) for code in CODES)]
    for x, y, radius in discs:
        dark = np.maximum(dark, ((radius - np.hypot(u - x, v - y)) * SAMPLES + 0.5).clip(0, 1))
    measured = cells.measure(Flat(slope(u, v) * (1 - 0.7 * dark), dark, 8), LENGTH)
    rows, tracks = np.arange(LENGTH)[:, None], np.array(straight.TRACKS)
    hole = np.zeros((LENGTH, 8), dtype=bool)
    for at, track in CODES:
        hole[at, straight.TRACKS.index(track)] = True
    assert measured.paper == pytest.approx(slope(rows, tracks), abs=0.5)
    assert measured.full == pytest.approx(np.full(LENGTH, 0.7), abs=0.015)
    assert measured.sprocket == pytest.approx(np.full(LENGTH, 1 - np.exp(-(FEED**2) / 2 / 0.11**2)), abs=0.02)
    assert measured.core[3:] == pytest.approx(hole[3:].astype(float), abs=0.02)
    most = hole.astype(float)
    most[2, 1] = 1
    assert measured.most == pytest.approx(most, abs=0.03)
    assert [tuple(place) for place in np.argwhere(measured.ring > 0.6).tolist()] == [(0, 0, 6), (3, 1, 6)]


def test_how_dark_a_hole_is_follows_the_clear_ones_near() -> None:
    core, sprocket = np.zeros((40, 8)), np.full(40, 0.8)
    assert cells.full_darkness(core, sprocket) == pytest.approx(np.full(40, 1.1 * 0.8)), "no code hole at all"
    core[0] = 0.6
    assert cells.full_darkness(core, sprocket) == pytest.approx([0.6] * 9 + [1.1 * 0.8] * 31), "eight"
    core[39, :5], core[38, 0] = 0.7, 0.41
    core[37, 0] = 0.4  # half as dark: none
    expected = [0.6] * 9 + [0.6] * 21 + [0.6] + [0.7] * 9
    expected[30] = 0.6  # five holes, and what all of them are beside the sprocket holes
    assert cells.full_darkness(core, sprocket) == pytest.approx(expected)
    assert cells.full_darkness(0 * core, 0 * sprocket) == pytest.approx(np.full(40, 0.01))


def test_noise_is_what_alike_places_near_differ_by() -> None:
    core = np.tile([0.1, 0.12, 0.1, 0.12, 0.1, 0.12, 1, 0.9], (40, 1))
    core[0, :6] = core[30, :6] = 0.3
    noise = cells.noise(core, core > 0.5)
    expected = [0.02] * 9 + [0.01] * 13 + [0.02] * 17 + [0.01]
    assert noise[:, :6] == pytest.approx(1.48 * np.tile(expected, (6, 1)).T)
    assert noise[:, 6:] == pytest.approx(np.full((40, 2), 1.48 * 0.05))


def test_paper_is_from_the_first_row_with_edges_and_a_hole_to_the_last() -> None:
    light = straight.tape(LENGTH, CODES, feed=[*range(2, 7), *range(9, 17)])
    straight.hole(light, 1, 0, FEED, 200 - 140 * 0.45)
    straight.hole(light, 17, 0, FEED, 200 - 140 * 0.55)
    flat = flatten(straight.pictures(light), straight.sheet(LENGTH))
    edged = np.ones(LENGTH, dtype=bool)
    assert np.nonzero(cells.on_paper(flat, edged))[0].tolist() == [*range(2, 18)]
    edged[[2, 4, 5, 17]] = False
    assert np.nonzero(cells.on_paper(flat, edged))[0].tolist() == [*range(3, 17)]
    assert not cells.on_paper(flat, ~edged | edged[0])[:2].any()
    assert not cells.on_paper(flat, 0 * edged).any()


@pytest.mark.parametrize(
    ("before", "after", "level", "lost", "found"),
    [
        (0.5, 0.5, 200, 0, []),
        (1.3, 0.5, 200, 0, [2]),
        (0.5, 1.3, 200, 0, [17]),
        (0.95, 0.95, 200, 0, []),
        (1.3, 1.3, 140, 0, [2, 17]),
        (1.3, 1.3, 120, 0, []),
        (0.5, 1.3, 160, 4, [17]),
        (0.5, 1.3, 140, 4, []),
        (0.5, 1.3, 140, 6, []),
    ],
)
def test_the_tape_goes_on_where_there_is_room_for_another_row(
    before: float, after: float, level: int, lost: int, found: list[int]
) -> None:
    """Rows 2 to 17 of 20. It is lighter than half way from paper to a quarter of the last six holes."""
    light = np.full_like(straight.tape(LENGTH), 60)
    straight.paper(light, (2 - before, 17 + after), (-3.92, 6.08), level)
    straight.paper(light, (1.5, 17.5), (-3.92, 6.08))
    for u in range(2, 18 - lost):
        straight.hole(light, u, 0, 0.3)
    rows = np.arange(LENGTH)
    tape = straight.sheet(LENGTH)
    flat = flatten(straight.pictures(light), tape)
    there = cells.ends(flat, tape, straight.pictures(light), (rows > 1) & (rows < 18))
    assert np.nonzero(there)[0].tolist() == found
    right, left = light[:, : (15 + 18) * 12], np.full((400, 400), 0)
    cut = cells.ends(flat, tape, straight.pictures(right), (rows > 1) & (rows < 18))
    assert np.nonzero(cut)[0].tolist() == [row for row in found if row != 17]
    assert not cells.ends(flat, tape, straight.pictures(left[:200]), (rows > 1) & (rows < 18)).any()


CORE = np.tile([0.0, 1.0], (12, 4))
CELLS = Cells(
    core=CORE,
    most=CORE.copy(),
    ring=np.zeros((8, 12, 8)),
    full=np.full(12, 0.5),
    sprocket=np.full(12, 0.9),
    paper=np.full((12, 8), 200.0),
)
"""Holes in channels 2, 4, 6 and 8."""
TAPE = Found(straight.sheet(12), np.ones(12, bool), np.zeros(12), np.ones(12, bool))


@pytest.mark.parametrize(
    ("field", "where", "value", "why"),
    [
        ("seen", 5, False, cells.UNSEEN),
        ("sprocket", 5, 0.4, ""),
        ("sprocket", 5, 0.39, cells.UNSEEN),
        ("sprocket", 5, 1.6, ""),
        ("sprocket", 5, 1.61, cells.UNSEEN),
        ("beyond", 5, True, "the tape goes on beyond it, where no sprocket hole is seen"),
        ("outside", (5, 3), True, "outside the picture"),
        ("astray", 5, 0.08, ""),
        ("astray", 5, 0.081, "holes are not at their places"),
        ("edged", 5, False, "an edge of the paper is not seen"),
        ("ring", ([2, 3], 5, 3), 0.61, "not a round hole: torn, or dirt"),
        ("ring", ([2, 3], 5, 3), 0.6, ""),
        ("ring", (2, 5, 3), 0.9, ""),
        ("ring", ([2, 3], 5, 2), 0.9, ""),
        ("most", (5, 3), 0.25, ""),
        ("most", (5, 3), 0.24, "a hole that is not dark throughout"),
        ("most", (5, 2), 0.5, ""),
        ("most", (5, 2), 0.51, "paper that is not clear"),
        ("paper", (5, 3), 12, ""),
        ("paper", (5, 3), 11.9, "too little light"),
        ("core", (5, 3), 0.75, ""),
        ("core", (5, 3), 0.74, "between paper and hole"),
        ("core", (5, 2), 0.25, ""),
        ("core", (5, 2), 0.26, "between paper and hole"),
    ],
)
def test_a_frame_is_doubtful_for_one_reason(field: str, where: Any, value: float, why: str) -> None:
    measured, tape, beyond, outside = deepcopy((CELLS, TAPE, np.zeros(12, bool), np.zeros((12, 8), bool)))
    (measured._asdict() | tape._asdict() | {"beyond": beyond, "outside": outside})[field][where] = value
    doubts = cells.doubts(measured, tape, beyond, outside)
    assert {reason: set(np.nonzero(at)[0]) for reason, at in doubts.items() if at.any()} == (
        {why: {5}} if why else {}
    )


@pytest.mark.parametrize(("noise", "doubtful"), [(0.035, False), (0.04, True)])
def test_a_place_is_sure_at_four_and_a_half_standard_deviations(noise: float, doubtful: bool) -> None:
    core = np.zeros((12, 8))
    core[:, ::2], core[:, 1::2] = 0.24, 0.24 - 2 * noise
    doubts = cells.doubts(
        CELLS._replace(core=core, most=0 * core), TAPE, np.zeros(12, bool), np.zeros((12, 8), bool)
    )
    assert (doubts["between paper and hole"] == doubtful * (core == 0.24)).all()


def test_a_strip_of_which_more_than_a_third_is_doubtful_says_why_and_what_to_do() -> None:
    sure, dirt, torn = (Frame(0, mask, why, ()) for mask, why in ((0, ""), (1, "dirt"), (1, cells.UNSEEN)))
    assert reader.too_doubtful([sure] * 13 + [dirt] * 7) == ""
    assert reader.too_doubtful([sure] * 12 + [dirt] * 3 + [torn] * 5) == (
        "8 of 20 frames are doubtful, most of them: its sprocket hole is not seen; "
        "lay it on something black and even, or light it from behind"
    )
