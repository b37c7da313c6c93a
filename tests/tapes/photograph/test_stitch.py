"""Parts of a tape, with what a photograph does to them, become that tape, or are refused."""

import random
import re
from itertools import pairwise

import pytest

from pdp8 import shelf
from tapes import photograph
from tapes.errors import TapeError
from tapes.photograph import Frame, correction, stitch
from tests.tapes.photograph import camera, survey
from tests.tapes.photograph.camera import Shot


def seen(tape: bytes) -> list[Frame]:
    return [Frame(holes, 0, "", ((at, 0),) * 9) for at, holes in enumerate(tape)]


def parts(tape: bytes, *spans: tuple[int, int]) -> dict[int, list[Frame]]:
    return {number: seen(tape[begin:end]) for number, (begin, end) in enumerate(spans, 1)}


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
        for strip, (begin, _) in zip(strips.values(), spans, strict=True):
            for at in draw.sample(range(len(strip)), 8):
                mask = draw.choice([0o377, 1 << draw.randrange(8)])
                strip[at] = strip[at]._replace(holes=strip[at].holes ^ mask, open=mask, why="dirt")
                wrong.add(begin + at)
        found = stitch.join({number: strips[number] for number in draw.sample([*strips], len(strips))})
        assert found.begins == {number: begin for number, (begin, _) in enumerate(spans, 1)}
        assert len(found.frames) == len(tape)
        for at, (frame, _) in enumerate(found.frames):
            assert (frame.holes ^ tape[at]) & ~frame.open == 0, "wrong and sure"
            assert not frame.doubtful or at in wrong


def test_what_is_sure_in_one_picture_is_sure_and_what_differs_is_doubtful() -> None:
    one, two = parts(TAPES["circle.eia"][1:101], (0, 100), (0, 100)).values()
    doubtful = one[7]._replace(holes=one[7].holes ^ 0o003, open=0o003, why="dirt")
    one[7], two[8] = doubtful, two[8]._replace(holes=two[8].holes ^ 0o010)
    two[9], one[9] = (frame._replace(open=mask, why="dirt") for frame, mask in ((two[9], 5), (one[9], 6)))
    one[10], two[10] = (
        frame._replace(holes=frame.holes ^ mask, open=mask, why="dirt")
        for frame, mask in ((one[10], 1), (two[10], 2))
    )
    found = [frame for frame, _ in stitch.join({1: one, 2: two}).frames]
    assert bytes(frame.holes for frame in found[:8]) == TAPES["circle.eia"][1:9]
    assert (found[7].open, found[8].open, found[9].open) == (0, 0o010, 4)
    assert (found[8].why, found[9].why, found[7].why) == ("two pictures of it differ", "dirt", "")
    assert (found[10].open, found[10].why) == (0, ""), "each picture is sure of what the other doubts"
    assert found[10].holes == TAPES["circle.eia"][11]


ANY = random.Random(1).randbytes(200)
BIN = TAPES["eia.bin"][65:320]


def test_strips_that_differ_where_a_third_puts_them_are_refused() -> None:
    strips = parts(ANY, (0, 100), (60, 160), (90, 190))
    assert holes(stitch.join(strips)) == ANY[:190]
    strips[2][30:40] = [frame._replace(open=0o377, why="dirt") for frame in strips[2][30:40]]
    strips[3][:10] = [frame._replace(holes=frame.holes ^ 1) for frame in strips[3][:10]]
    with pytest.raises(TapeError, match="strips 1 and 3 cannot be joined"):
        stitch.join(strips)


@pytest.mark.parametrize(
    ("strips", "why"),
    [
        (
            parts(TAPES["circle.asc"], (0, 100), (100, 200)),
            "strips 1; 2 cannot be joined: two have to have 30",
        ),
        (parts(TAPES["circle.asc"], (0, 100), (92, 200)), "two have to have 30 frames in common"),
        (
            parts(b"".join(bytes(60) + TAPES["eia.bin"][65:125] for _ in "12"), (0, 60), (59, 160)),
            "30 frames",
        ),
        (parts(b"\200" * 99 + TAPES["eia.bin"][65:300], (0, 60), (30, 140)), "30 frames"),
        (parts(bytes(range(1, 17)) * 20, (0, 100), (70, 170)), "the tape repeats itself"),
        (parts(TAPES["circle.asc"], (0, 100), (300, 400), (70, 170)), "strips 1, 3; 2 cannot be joined"),
        (parts(BIN[:165] + b"\200" * 40 + BIN[165:], (0, 195), (172, 290)), "30 frames"),
        (parts(bytes(ANY[at // 2] * (at % 2) for at in range(200)), (0, 100), (90, 200)), "30 frames"),
        (parts(ANY[:60] + ANY[:20] + ANY[60:], (0, 83), (60, 170)), "the tape repeats itself"),
        (parts(TAPES["circle.asc"][:90] * 2, (0, 60), (20, 130), (110, 180)), "the tape repeats itself"),
    ],
)
def test_what_is_not_clear_is_refused(strips: dict[int, list[Frame]], why: str) -> None:
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


def says(tape: bytes) -> int:
    """Return how many frames are neither blank nor like the one before."""
    return sum(frame not in (0, before) for before, frame in pairwise(b"\0" + tape))


def long_tape(seed: int) -> tuple[bytes, list[tuple[int, int]]]:
    """Return a tape, and five parts of it; each has 30 frames that say something in common with the next."""
    draw = random.Random(seed)
    name = [*TAPES, *TAPES, "any", "any", "any", "some"][seed % 10]
    tape = survey.some_tape(seed, 1000) if name == "some" else draw.randbytes(1000)
    if name in TAPES:
        start = draw.randrange(1, len(TAPES[name]) - 360)
        tape = TAPES[name][start:]
    spans = [(0, next(at for at in range(len(tape)) if says(tape[:at]) == 50))]
    while len(spans) < 5:
        end = spans[-1][1]
        begin = max(at for at in range(end) if says(tape[at:end]) == 30)
        spans.append((begin, end + draw.randrange(22, 30)))
    return tape[: spans[-1][1]], spans


def photographed(tape: bytes, span: tuple[int, int], seed: int) -> list[Frame]:
    """Return what is read of a photograph of a part of the tape, which goes on beyond the picture."""
    draw = random.Random(seed)
    shot = Shot(
        draw.uniform(8, 9), draw.uniform(-3, 3), draw.uniform(0, 0.06), fall=0.3, noise=4, jpeg=70, seed=seed
    )
    first, last = max(0, span[0] - 3), min(len(tape), span[1] + 3)
    light, places = camera.picture(tape[first:last], shot), camera.places(last - first, shot)[:, :, 0]
    left = int(places[span[0] - first].min() - shot.row / 2) if span[0] else 0
    right = int(places[span[1] - first - 1].max() + shot.row / 2) if span[1] < len(tape) else light.shape[1]
    (strip,) = photograph.strips(camera.develop(light[:, left:right], shot))
    return strip.frames


@pytest.mark.slow("30 photographs, 15 s; 250 by WHOLE=1")
@pytest.mark.parametrize(
    "seed", [*range(6), *(pytest.param(n, marks=pytest.mark.rare("2 s each")) for n in range(6, 50))]
)
def test_photographs_of_a_long_tape_are_stitched(seed: int) -> None:
    """Without the third, or with three frames of it in common with the second, they are refused."""
    tape, spans = long_tape(seed)
    strips = {number: photographed(tape, span, 100 * seed + number) for number, span in enumerate(spans, 1)}
    order = random.Random(seed).sample([*strips], 5)
    found = stitch.join({number: strips[number] for number in order})
    assert [
        number
        for number, (frame, _) in enumerate(found.frames)
        if frame.holes != tape[number] and not frame.doubtful
    ] == []
    assert len(found.frames) == len(tape)
    if spans[3][0] >= spans[1][1]:
        short = strips | {3: strips[3][spans[1][1] - spans[2][0] - 3 :]}
        for less in (short, {number: strips[number] for number in order if number != 3}):
            with pytest.raises(TapeError, match="cannot be joined: two have to have 30 frames in common"):
                stitch.join(less)


@pytest.mark.parametrize("stitched", [False, True])
@pytest.mark.parametrize("way", [1, -1])
@pytest.mark.parametrize("off", [(False, False), (False, True), (True, False), (True, True)])
def test_where_strips_are_is_said_and_which_ends_leave_their_pictures(
    off: tuple[bool, bool], way: int, stitched: bool
) -> None:
    """A stitched tape only at its own ends; strips seen from below at their other ends."""
    tape = survey.some_tape(5, 150)
    pictures = [
        correction.Picture(f"{number}.jpg", b"", [photograph.Strip(frames, off)])
        for number, frames in parts(tape, (0, 80), (40, 120), (80, 150)).items()
    ]
    read = correction.Reading(pictures, (1, 2, 3) if way == 1 else (-3, -2, -1), stitched)
    assert read.tape == tape[::way] or not stitched
    assert [strip for strip, _ in read.runs] == [1, 2, 3][::way]
    places = {
        (True, 1): ((0, 79), (40, 119), (80, 149)),
        (True, -1): ((0, 69), (30, 109), (70, 149)),
        (False, 1): ((0, 79), (80, 159), (160, 229)),
        (False, -1): ((0, 69), (70, 149), (150, 229)),
    }[stitched, way]
    before, after = off[::way]
    expected = []
    for number, (begin, end) in zip([1, 2, 3][::way], places, strict=True):
        expected.append(f"frames {begin} to {end}: strip {number}")
        expected += [f"before frame {begin}"] * (before and not (stitched and begin))
        expected += [f"after frame {end}"] * (after and not (stitched and end != places[-1][1]))
    said = re.findall(
        r"frames \d+ to \d+: strip \d|(?<=may go on )\w+ frame \d+", "\n".join(read.report(False))
    )
    assert said == expected
