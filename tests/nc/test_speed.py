"""100,000 blocks in seconds, in time that grows with the blocks."""

import time
from functools import cache

import pytest

import nc
from nc.curves import Ellipse
from nc.inspection import inspect
from nc.listing import lines
from tests.nc.tapes_1971 import HEADER, milling, staircase, tape

SIZES = (25_000, 50_000, 100_000)
BOTH_FEEDS = ("007 0 02250 04000 0 01 84", "008 0 02250 04000 0 01 85")


@cache
def rings() -> bytes:
    """Return circles one inside the other in steps of .001, no two blocks alike."""
    corners: list[tuple[int, int]] = []
    radius = 1750
    while len(corners) < max(SIZES):
        corners += staircase(radius, 1)
        radius -= 1
    return tape(*HEADER, *BOTH_FEEDS, *milling(corners, (2250, 4000)))


@pytest.mark.parametrize("what", ["cut", "list", "inspect"])
def test_100_000_blocks_take_seconds_and_the_time_grows_linearly(what: str) -> None:
    took = [_seconds(what, blocks) for blocks in SIZES]
    assert took[2] < 15, took
    assert took[2] < 6 * took[0] + 1, took


@cache
def path_of(blocks: int) -> nc.Path:
    return nc.cut(rings()[: 1 + 20 * blocks])


def _seconds(what: str, blocks: int) -> float:
    frames, path = rings()[: 1 + 20 * blocks], path_of(blocks)
    start = time.process_time()
    if what == "cut":
        assert len(nc.cut(frames)) == blocks
    elif what == "list":
        assert sum(1 for _ in lines(path, modes=True)) == len(path) + 1
    else:
        inspect(path, curve=Ellipse(4000, 4000, 1750, 1750))
    return time.process_time() - start
