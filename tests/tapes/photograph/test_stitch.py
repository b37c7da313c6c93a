"""Parts of a tape, with what a photograph does to them, become that tape, or are refused."""

import random

import pytest

from pdp8 import shelf
from tapes import photograph
from tapes.errors import TapeError
from tapes.photograph import Frame, correction, stitch
from tests.tapes.photograph import camera, survey
from tests.tapes.photograph.camera import Shot


def seen(tape: bytes) -> list[Frame]:
    return [Frame(holes, 0, "", ((at, 0),) * 9) for at, holes in enumerate(tape)]


def parts(tape: bytes, *spans: tuple[int, int]) -> list[list[Frame]]:
    return [seen(tape[begin:end]) for begin, end in spans]


def holes(piece: stitch.Piece) -> bytes:
    return bytes(frame.holes for frame, _ in piece.frames)


TAPES = {name: shelf.read(name) for name in ("circle.asc", "circle.eia", "eia.bin")}


@pytest.mark.parametrize("name", TAPES)
def test_parts_in_any_order_become_the_tape(name: str) -> None:
    """Some frames are doubtful, some sure and wrong: where a second picture shows them, they are known."""
    for seed in range(20):
        draw = random.Random(seed)
        start = draw.randrange(20, len(TAPES[name]) - 330) if name != "eia.bin" else 60
        tape = TAPES[name][start : start + 260]
        spans = [(at, at + 100) for at in range(0, 161, 40)]
        strips = parts(tape, *spans)
        wrong = set()
        for strip, (begin, _) in zip(strips, spans, strict=True):
            for at in draw.sample(range(len(strip)), 8):
                mask = draw.choice([0o377, 1 << draw.randrange(8)])
                strip[at] = strip[at]._replace(holes=strip[at].holes ^ mask, open=mask, why="dirt")
                wrong.add(begin + at)
        order = draw.sample(range(len(strips)), len(strips))
        found = stitch.join([strips[at] for at in order])
        assert {order[at]: begin for at, begin in found.begins.items()} == {
            at: begin for at, (begin, _) in enumerate(spans)
        }
        assert len(found.frames) == len(tape)
        for at, (frame, _) in enumerate(found.frames):
            assert (frame.holes ^ tape[at]) & ~frame.open == 0, "wrong and sure"
            assert not frame.doubtful or at in wrong


def test_what_is_sure_in_one_picture_is_sure_and_what_differs_is_doubtful() -> None:
    one, two = parts(TAPES["circle.eia"][1:101], (0, 100), (0, 100))
    doubtful = one[7]._replace(holes=one[7].holes ^ 0o003, open=0o003, why="dirt")
    one[7], two[8] = doubtful, two[8]._replace(holes=two[8].holes ^ 0o010)
    two[9], one[9] = (frame._replace(open=mask, why="dirt") for frame, mask in ((two[9], 5), (one[9], 6)))
    found = [frame for frame, _ in stitch.join([one, two]).frames]
    assert bytes(frame.holes for frame in found[:8]) == TAPES["circle.eia"][1:9]
    assert (found[7].open, found[8].open, found[9].open) == (0, 0o010, 4)
    assert (found[8].why, found[9].why, found[7].why) == ("two pictures of it differ", "dirt", "")


@pytest.mark.parametrize(
    ("strips", "why"),
    [
        (parts(TAPES["circle.asc"], (0, 100), (100, 200)), "not all photographs overlap"),
        (parts(TAPES["circle.asc"], (0, 100), (95, 200)), "not all photographs overlap"),
        (
            parts(bytes(60) + TAPES["eia.bin"][65:] + bytes(60), (0, 50), (30, 80)),
            "not all photographs overlap",
        ),
        (parts(bytes(range(1, 17)) * 20, (0, 100), (70, 170)), "overlap in more than one way"),
        (parts(TAPES["circle.asc"], (0, 100), (70, 170), (300, 400)), "not all photographs overlap"),
    ],
)
def test_what_is_not_clear_is_refused(strips: list[list[Frame]], why: str) -> None:
    with pytest.raises(TapeError, match=why):
        stitch.join(strips)


def test_no_part_of_a_regular_tape_is_put_where_it_is_not() -> None:
    """Whatever two parts of the circle: they are joined as they lie on the tape, or refused."""
    joined = 0
    for seed in range(300):
        draw = random.Random(seed)
        tape = TAPES[draw.choice(["circle.asc", "circle.eia"])]
        first = draw.randrange(len(tape) - 300)
        second = first + draw.randrange(-120, 200)
        spans = [(max(0, at), max(0, at) + draw.randrange(40, 120)) for at in (first, second)]
        try:
            found = stitch.join(parts(tape, *spans))
        except TapeError:
            continue
        joined += 1
        assert holes(found) == tape[min(spans)[0] : max(end for _, end in spans)]
    assert joined > 50


@pytest.mark.slow("three photographs, ten seconds")
def test_photographs_of_a_long_tape_are_stitched() -> None:
    tape = survey.some_tape(5, 150)
    picture = camera.picture(tape, Shot(angle=2))
    wide = picture.shape[1]
    crops = [picture[:, int(wide * a) : int(wide * b)] for a, b in ((0, 0.5), (0.25, 0.75), (0.5, 1))]
    pictures = [camera.develop(crop, Shot(seed=at)) for at, crop in enumerate(crops)]
    read = correction.Reading(
        [correction.Picture(f"{at}.jpg", each, photograph.strips(each)) for at, each in enumerate(pictures)],
        stitched=True,
    )
    assert read.tape == tape
    said = "\n".join(read.report(underside=False))
    assert "strip 3 of 3" in said
    assert "may go on" not in said
    assert [strip for strip, _ in read.runs] == [1, 2, 3]
