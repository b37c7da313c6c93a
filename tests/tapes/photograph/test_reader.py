"""Photographs of tape are read without a frame that is wrong in silence, or refused with the reason.

The whole table of pictures is in docs/photographs.md, and made by survey.py.
"""

import os
from pathlib import Path

import numpy as np
import pytest

from tapes import photograph
from tapes.errors import TapeError
from tapes.photograph import paper, pixels, sprockets
from tests.tapes.photograph import camera, scenes, survey
from tests.tapes.photograph.camera import Shot

PART = 60
"""Frames of a test's tape: less than a whole strip, so that the tests are quick."""


def holes(frames: list[photograph.Frame]) -> bytes:
    return bytes(frame.holes for frame in frames)


def doubtful(frames: list[photograph.Frame]) -> list[int]:
    return [number for number, frame in enumerate(frames) if frame.doubtful]


OWN = os.environ.get("PDP8_PHOTOGRAPHS", "")
"""A folder of photographs, and beside each a file of its name, .tape, with the frames that it shows."""

WITHIN = {
    "perspective .3, from a corner": 0,
    "curl 11 %": 0,
    "barrel .15": 0,
    "shadow of half the light": 2,
    "light falls by 85 %": 0,
    "6 pixels a row": 0,
    "noise 12": 0,
    "dark tape, lit from behind": 0,
    "on a desk": 16,
}
"""The most frames that may be doubtful."""
HARDEST = ["all at once", "perspective .5", "curl 25 %", "noise 60"]


@pytest.mark.parametrize("kind", WITHIN)
def test_within_the_limits_every_frame_is_right_and_its_holes_are_where_they_were_drawn(kind: str) -> None:
    tape, shot = survey.some_tape(7, PART), survey.varied(survey.WITHIN[kind], 7)
    found = photograph.read(camera.photograph(tape, shot))
    assert holes(found) == tape
    assert len(doubtful(found)) <= WITHIN[kind]
    places = np.array([frame.places for frame in found])
    off = np.hypot(*np.moveaxis(places - camera.places(PART, shot), 2, 0))
    assert off.max() < 0.5 + 0.2 * shot.row
    assert off.mean() < 0.4 + 0.025 * shot.row


@pytest.mark.parametrize(
    ("kind", "seed", "mean", "most"),
    [
        ("barrel .15", 7, 0.04, 0.26),
        ("6 pixels a row", 8, 0.01, 0.055),
        ("noise 12", 7, 0.011, 0.065),
    ],
)
def test_where_the_holes_are_is_known_to_a_small_part_of_a_row(
    kind: str, seed: int, mean: float, most: float
) -> None:
    tape, shot = survey.some_tape(seed, PART), survey.varied(survey.WITHIN[kind], seed)
    pictures = sprockets.sizes(pixels.lights(camera.photograph(tape, shot))[0])
    found = paper.find(pictures, sprockets.rows(pictures)[0])
    first = (len(found.seen) - PART) // 2
    places = found.sheet.place(
        np.arange(first, first + PART)[:, None], np.array([0, -3, -2, -1, 1, 2, 3, 4, 5])
    )
    off = np.hypot(*np.moveaxis(places - camera.places(PART, shot), 2, 0)) / shot.row
    assert (off.mean() < mean, off.max() < most) == (True, True), (off.mean(), off.max())
    assert found.astray.max() < 0.05
    assert found.edged.sum() >= PART
    assert found.seen.sum() >= PART


def test_what_is_not_as_on_a_tape_is_doubtful_with_the_reason() -> None:
    light, places = camera.picture(bytes([0o205]) * 44, Shot()), camera.places(44, Shot())
    y, x = np.mgrid[: light.shape[0], : light.shape[1]]
    for at, channel, aside, radius, level in (
        (6, 3, 0.4, 0.4, 60),  # torn along the tape, into the frame after it
        (12, 5, 0.2, 0.12, 60),
        (18, 1, 0.22, 0.15, 205),
        (24, 6, 0, 0.36, 130),
        *((at, 0, 0, 0.35, 205) for at in (30, 41, 42, 43)),
    ):
        across, down = places[at, channel]
        light[np.hypot(x - across - 12 * aside, y - down) < 12 * radius] = level
    across, down = places[36, 8].astype(int)
    light[down + 6 : down + 30, across - 9 : across + 9] = 205  # beyond the edge
    found = photograph.read(camera.develop(light, Shot()))
    assert {at: (found[at].open, found[at].channel, found[at].why) for at in doubtful(found)} == {
        6: (0o004, 3, "not a round hole: torn, or dirt"),
        7: (0o004, 3, "not a round hole: torn, or dirt"),
        12: (0o020, 5, "paper that is not clear"),
        18: (0o001, 1, "a hole that is not dark throughout"),
        24: (0o040, 6, "between paper and hole"),
        30: (0o377, 1, photograph.UNSEEN),
        36: (0o377, 1, "an edge of the paper is not seen"),
        40: (0o377, 1, "the tape goes on beyond it, where no sprocket hole is seen"),
    }
    with pytest.raises(TapeError, match="frames are doubtful, most of them: too little light"):
        photograph.read(camera.photograph(bytes([0o205]) * 44, Shot(paper=16, behind=12, noise=0)))


@pytest.mark.slow("a photograph of each kind, 10 s")
@pytest.mark.parametrize("kind", HARDEST)
def test_no_frame_is_wrong_or_lost_in_silence_even_there(kind: str) -> None:
    shot = {**survey.WITHIN, **survey.BEYOND}[kind]
    tape = survey.some_tape(7, PART)
    found = survey.count(tape, camera.photograph(tape, survey.varied(shot, 7)))
    assert found[survey.SILENT] == 0
    assert found["doubtful"] or not found["lost"]


@pytest.mark.skipif(not OWN, reason="PDP8_PHOTOGRAPHS names no folder")
def test_your_own_photographs_have_no_frame_that_is_wrong_in_silence() -> None:
    tapes = sorted(Path(OWN).glob("*.tape"))
    assert tapes, f"{OWN}: no NAME.tape beside a picture NAME"
    for tape in tapes:
        (picture,) = (path for path in tape.parent.glob(f"{tape.stem}.*") if path != tape)
        assert survey.count(tape.read_bytes(), picture.read_bytes())[survey.SILENT] == 0, picture


def test_rows_too_close_together_are_refused_with_their_distance() -> None:
    with pytest.raises(TapeError, match=r"only [34]\.\d pixels apart: 6 are needed"):
        photograph.read(camera.photograph(survey.some_tape(1, PART), Shot(row=4)))


@pytest.mark.parametrize("scene", scenes.SCENES)
def test_a_picture_without_a_tape_is_refused(scene: str) -> None:
    with pytest.raises(TapeError, match=scenes.SCENES[scene][-1]):
        photograph.read(camera.develop(scenes.picture(scene)[170:400, :600], Shot()))


def test_frames_in_a_gap_are_counted_and_doubtful() -> None:
    tape = survey.some_tape(3, PART)
    found = photograph.read(camera.photograph(tape, Shot(covered=(30,))))
    assert len(found) == len(tape)
    assert {30, 31} <= set(doubtful(found)) <= set(range(26, 36))
    assert all(found[number].why == photograph.UNSEEN for number in (30, 31))
    assert [
        number for number, frame in enumerate(found) if not frame.doubtful and frame.holes != tape[number]
    ] == []


@pytest.mark.parametrize("angle", [90, 270])
def test_a_tape_is_read_from_its_own_start_however_it_lies(angle: float) -> None:
    tape = survey.some_tape(4, PART)
    assert holes(photograph.read(camera.photograph(tape, Shot(angle=angle)))) == tape


def test_a_tape_seen_from_below_is_read_from_its_end_unless_that_is_said() -> None:
    tape = survey.some_tape(4, PART)
    picture = camera.photograph(tape, Shot(below=True))
    assert holes(photograph.read(picture, underside=True)) == tape
    assert holes(photograph.read(picture)) == tape[::-1]


def test_strips_are_read_from_top_to_bottom() -> None:
    tapes = [survey.some_tape(seed, PART) for seed in (1, 2)]
    both = np.concatenate([camera.picture(tape, Shot()) for tape in tapes])
    assert holes(photograph.read(camera.develop(both, Shot()))) == b"".join(tapes)


@pytest.mark.parametrize("seed", [5, 9])
def test_a_tape_that_runs_off_the_picture_has_no_frame_beyond_it(seed: int) -> None:
    tape = survey.some_tape(seed, PART)
    light = camera.picture(tape, Shot(angle=4 * (seed - 7)))
    light = light[:, light.shape[1] // 4 : light.shape[1] * 3 // 4]
    (strip,) = photograph.strips(camera.develop(light, Shot()))
    assert strip.off == (True, True)
    places = np.array([frame.places[0] for frame in strip.frames])
    assert ((places >= 0) & (places < light.shape[::-1])).all()
    sure = [frame.holes if not frame.doubtful else None for frame in strip.frames]
    assert any(
        all(one in (None, other) for one, other in zip(sure, tape[at:], strict=False))
        for at in range(PART - len(sure) + 1)
    )
    assert sure.count(None) <= 4


def test_pieces_on_one_line_are_read_as_they_lie_and_upright_strips_from_left_to_right() -> None:
    """The second piece lies a little higher, so that it would come first by its place alone."""
    tapes = [survey.some_tape(seed, 30) for seed in (1, 2)]
    one, two = (camera.picture(tape, Shot()) for tape in tapes)
    line = np.concatenate([np.roll(one, 4, axis=0), two], axis=1)
    for light, underside in ((line, False), (np.rot90(line, 2), False), (line[:, ::-1], True)):
        assert holes(photograph.read(camera.develop(light, Shot()), underside)) == b"".join(tapes)
    upright = np.concatenate([np.rot90(one), np.rot90(two, 3)], axis=1)
    assert holes(photograph.read(camera.develop(upright, Shot()))) == b"".join(tapes)


def test_fingers_over_an_edge_make_the_frames_under_them_doubtful_alone() -> None:
    tape, shot = survey.some_tape(7, PART), Shot()
    light, places = camera.picture(tape, shot), camera.places(PART, shot)
    for at in (10, 40):
        across, down = places[at, 7].astype(int)
        light[down:, across - 24 : across + 24] = 123
    found = photograph.read(camera.develop(light, shot))
    assert len(found) == PART
    assert {9, 10, 11, 39, 40, 41} <= set(doubtful(found)) <= {*range(7, 14), *range(37, 44)}
    assert all(frame.doubtful or frame.holes == tape[at] for at, frame in enumerate(found))
