"""Why a tape is refused: the frames that are named are those that are wrong, and without them it is cut."""

import re

import pytest

import nc
from nc.blocks import BlockError
from nc.diagnosis import explain
from tests.nc.tapes_1971 import FOUR_HOLES, tape

WHOLE = tape(*FOUR_HOLES)
FIRST = next(at for at, frame in enumerate(WHOLE) if frame)


@pytest.mark.parametrize("place", [0, 1, 19, 20, 27])
@pytest.mark.parametrize(
    ("extra", "why"),
    [(bytes(6), "6 blank frames"), (b"\x7f", "rubouts"), (b"\x80", "an end of block without")],
)
def test_what_is_too_much_is_named_and_left_out(extra: bytes, why: str, place: int) -> None:
    at = FIRST + place
    frames = WHOLE[:at] + extra + WHOLE[at:]
    try:
        nc.cut(frames)
    except BlockError as error:
        said = explain(frames, error)
    else:
        return  # the reader passes over it
    if why in said:
        first, last = re.findall(r"--without (\d+)(?:-(\d+))?`", said)[0]
        assert frames[: int(first)] + frames[int(last or first) + 1 :] == WHOLE
    else:
        assert extra == b"\x80", said
