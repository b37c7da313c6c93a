"""Why a tape is refused: the frames that are named are those that are wrong, and without them it is cut."""

import re

import pytest

import nc
from nc.blocks import BlockError
from nc.diagnosis import explain
from tapes import ascii
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


TITLE = bytes([0o174, 0o022, 0o021, 0o022, 0o174]) * 2 + bytes(20) + WHOLE[FIRST:]
TEXT = ascii.encode("A LETTER TO THE SHOP\n" * 20)


@pytest.mark.parametrize(
    ("frames", "strict", "said"),
    [
        (TITLE, False, "frame 0: a title of 10 frames before the program; `pdp8 tape cut --from 10`"),
        (TITLE[:93] + b"\x3f" + TITLE[94:], True, "frame 93: block 3, row 4: wrong parity: 077 has 6 holes"),
        (TEXT, False, "frame 0: block 1, row 1: an end of block with digit holes beside it: 301"),
        (WHOLE[FIRST : FIRST + 20] + TEXT, False, "frame 20: block 2, row 1: an end of block with digit"),
        (
            WHOLE[: FIRST + 5] + b"\x7f" + WHOLE[FIRST + 5 : FIRST + 47] + bytes(30) + WHOLE[FIRST + 47 :],
            False, f"frame {FIRST + 5}: block 1: rubouts",
        ),
        (
            WHOLE[: FIRST + 5] + b"\x7f" + WHOLE[FIRST + 5 : FIRST + 9] + b"\x7f\x7f" + WHOLE[FIRST + 9 :],
            False, f"frame {FIRST + 5}: block 1: rubouts (DEL), which the Hydra-Point reads as 15; "
            f"`pdp8 tape cut --without {FIRST + 5}` leaves",
        ),
        (
            WHOLE[: FIRST + 25] + b"\x7f" + WHOLE[FIRST + 25 : FIRST + 30] + b"\3" + WHOLE[FIRST + 31 :],
            True, f"frame {FIRST + 31}: block 1, row 11: wrong parity: 003 has 2 holes",
        ),
        (bytes([1, 2, 0o200]), False, "frame 2: block 1, row 3: the block ends in row 3"),
    ],
)  # fmt: skip
def test_what_is_wrong_is_named_where_it_is(frames: bytes, strict: bool, said: str) -> None:
    with pytest.raises(BlockError) as refused:
        nc.cut(frames, strict=strict)
    explained = explain(frames, refused.value)
    assert explained.startswith(said)
    assert ("seems to be ASCII" in explained) == (frames == TEXT)
