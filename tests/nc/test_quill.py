"""Where the quill is after a block: up for a tool change and for indexing, else as it was."""

import pytest

import nc
from tests.nc.tapes_1971 import tape

DOWN = ("900 9 03000 03500 0 01 89", "001 6 00000 00000 0 02 84", "002 6 01000 00000 0 01 85")


@pytest.mark.parametrize(
    ("function", "tool", "depth"),
    [
        ("83", "00", 0),  # index
        ("86", "02", 0),  # tool change
        ("06", "02", 0),  # manual tool change
        ("80", "00", 3500),  # no change
        ("07", "00", 3500),  # flood coolant
        ("00", "00", 3500),  # program stop
    ],
)
def test_the_quill_after_a_block_that_mills(function: str, tool: str, depth: int) -> None:
    path = nc.cut(tape(*DOWN, f"003 6 02000 00000 0 {tool} {function}"))
    assert path.steps[-1].at == (2000, 0, depth)
