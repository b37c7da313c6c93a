"""The block under a head: its fields, the digits that are read and those to come."""

import pytest

from pdp8.web.passing import passing
from tapes import ascii, codes, eia
from tapes.code import Code

_BLOCK = "  76 2250 4133  185"
_READ = ["007", "", "6", "", "02", "250", "", "04133", "", "0", "", "01", "", "85", "", "↵"]
_TO_COME = ["", "···", "", "·", "", "·····", "", "·····", "", "·", "", "··", "", "··", "", "·"]


@pytest.mark.parametrize(
    ("frames", "head", "code", "texts"),
    [
        (ascii.encode(f"1\n{_BLOCK}\n", fill=6), 14, codes.ASCII, _READ),
        (eia.encode(f"1\n{_BLOCK}\n".replace(" ", "0")), 7, codes.EIA, _READ),
        (eia.encode("1\n"), 1, codes.EIA, ["1↵", "·", *_TO_COME[2:]]),
        (b"", -1, codes.EIA, _TO_COME),
        (eia.encode("12X"), 1, codes.EIA, []),
        (b"\x80\x80", 1, "bin", []),
    ],
)
def test_what_of_a_block_is_read(frames: bytes, head: int, code: Code, texts: list[str]) -> None:
    assert passing(frames, head, code) == texts
