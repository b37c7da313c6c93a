"""Photographs of tape are read without a wrong frame, or with the wrong ones said to be doubtful."""

import random
from pathlib import Path
from typing import Any

import numpy as np
import pytest

cv2 = pytest.importorskip("cv2", reason="OpenCV is not installed")

from tapes import photograph  # noqa: E402
from tapes.errors import TapeError  # noqa: E402
from tests.conftest import Shell  # noqa: E402
from tests.tapes import photographs  # noqa: E402


def some_tape(seed: int, length: int = 50) -> bytes:
    draw = random.Random(seed)
    return bytes(
        draw.choice([0, 0o377, 0o200, draw.randrange(256), draw.randrange(256)]) for _ in range(length)
    )


def decoded(picture: bytes) -> Any:
    return cv2.imdecode(np.frombuffer(picture, np.uint8), cv2.IMREAD_GRAYSCALE)


CLEAR: list[dict[str, Any]] = [
    {},
    {"angle": 7},
    {"angle": -30},
    {"angle": 90},
    {"angle": 180},
    {"bright": False},
    {"pitch": 6},
    {"blur": 0.1},
    {"noise": 50},
    {"noise": 40, "blur": 0.1, "angle": 8},
    {"noise": 30, "blur": 0.1, "angle": -94, "bright": False},
]


@pytest.mark.parametrize("how", CLEAR, ids=str)
@pytest.mark.parametrize("seed", [1, 2])
def test_every_frame_is_right_up_to_this_noise_and_blur(how: dict[str, Any], seed: int) -> None:
    tape = some_tape(seed)
    found = photograph.read(photographs.photograph(tape, seed=seed, **how))
    assert bytes(frame.holes for frame in found) == tape
    assert sum(frame.doubtful for frame in found) <= 1


@pytest.mark.parametrize("seed", range(8))
def test_at_a_torn_edge_no_frame_is_wrong_that_is_not_doubtful(seed: int) -> None:
    tape = some_tape(seed, 80)
    found = photograph.read(photographs.photograph(tape, torn=8, noise=25, blur=0.08, angle=5, seed=seed))
    assert len(found) == len(tape)
    assert [
        number for number, frame in enumerate(found) if not frame.doubtful and frame.holes != tape[number]
    ] == []
    assert 0 < sum(frame.doubtful for frame in found) < 40


@pytest.mark.parametrize("seed", range(6))
def test_beyond_that_a_frame_is_right_or_doubtful_or_the_picture_refused(seed: int) -> None:
    tape = some_tape(seed)
    try:
        found = photograph.read(photographs.photograph(tape, noise=40, blur=0.16, seed=seed))
    except TapeError:
        return
    if len(found) == len(tape):
        assert all(frame.doubtful or frame.holes == right for frame, right in zip(found, tape, strict=True))
    else:
        assert found[0].doubtful or found[-1].doubtful


def test_a_sprocket_hole_that_is_filled_makes_its_frame_doubtful() -> None:
    tape = some_tape(3, 30)
    picture = decoded(photographs.photograph(tape))
    x, y = 16 * 4 + 16 * 12 + 8, round(16 * 7.92)
    cv2.circle(picture, (x, y), 5, 205, -1)
    found = photograph.read(bytes(cv2.imencode(".png", picture)[1]))
    assert bytes(frame.holes for frame in found) == tape
    assert [number for number, frame in enumerate(found) if frame.doubtful] == [12]
    assert (abs(found[12].x - x) <= 1, abs(found[12].y - y) <= 1) == (True, True)


def test_a_tape_seen_from_below_has_to_be_said() -> None:
    tape = some_tape(4)
    picture = decoded(photographs.photograph(tape))
    mirrored = bytes(cv2.imencode(".png", picture[:, ::-1])[1])
    assert bytes(frame.holes for frame in photograph.read(mirrored, underside=True)) == tape
    assert bytes(frame.holes for frame in photograph.read(mirrored)) == tape[::-1]


def test_strips_are_read_from_top_to_bottom() -> None:
    pictures = [photographs.photograph(some_tape(seed), seed=seed) for seed in (1, 2)]
    shown = [decoded(one) for one in pictures]
    both = bytes(cv2.imencode(".png", cv2.vconcat(shown))[1])
    assert bytes(frame.holes for frame in photograph.read(both)) == some_tape(1) + some_tape(2)


@pytest.mark.parametrize(
    ("content", "complaint"),
    [
        (b"", "no picture that can be read"),
        (b"\x89PNG\r\n", "no picture that can be read"),
        (bytes(cv2.imencode(".png", np.zeros((100, 100), np.uint8))[1]), "no tape in the picture"),
    ],
    ids=["empty", "cut off", "blank"],
)
def test_what_is_no_picture_of_a_tape_is_refused(content: bytes, complaint: str) -> None:
    with pytest.raises(TapeError, match=complaint):
        photograph.read(content)


def test_the_command_writes_the_tape_and_says_what_it_is(shell: Shell, tmp_path: Path) -> None:
    tape = bytes([0o261, 0o262, 0o263, 0o215, 0o212, 0o377] * 8)
    (tmp_path / "photo.png").write_bytes(photographs.photograph(tape, angle=3))
    done = shell("pdp8 tape read photo.png -o found.asc")
    assert (done.returncode, done.stderr) == (0, b"48 frames: ASCII\n")
    assert (tmp_path / "found.asc").read_bytes() == tape
