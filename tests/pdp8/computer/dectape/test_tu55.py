"""A transport by itself: with another reel, and what was written on one."""

import pytest

from pdp8.computer.dectape.tc08 import GO, TC08
from pdp8.computer.dectape.tu55 import MOVING, STOPPING, Transport
from tapes.dectape import BLOCKS, WORDS
from tests.pdp8.computer.dectape.reel import reel


def test_a_transport_with_another_reel_is_as_a_fresh_one() -> None:
    used, fresh = Transport(), Transport()
    used.mount(reel(), locked=True)
    used.go(1, 100)
    used.go(0, 50_000_000)
    used.write(5, 0, 0o1234)
    for each in (used, fresh):
        each.mount(reel())
    names = [*Transport.fields]
    names.remove("image")
    assert [getattr(used, name) for name in names] == [getattr(fresh, name) for name in names]


def test_what_was_written_is_in_the_order_of_blocks_and_not_on_the_reel_that_was_mounted() -> None:
    one, other = Transport(), Transport()
    for each, blocks in ((one, (7, 3, BLOCKS - 1)), (other, (3, BLOCKS - 1, 7))):
        each.mount(reel())
        for block in blocks:
            each.write(block, 128, 0o7070)
    assert one.changed == other.changed
    before = one.image
    assert before is not None
    written = one.written()
    assert written is not None
    assert (written.words[WORDS * 3 + 128], before.words[WORDS * 3 + 128]) == (0o7070, 3)
    other.mount(reel())
    other.changed = one.changed
    assert other.read(BLOCKS - 1, 128) == 0o7070
    high = bytes([BLOCKS >> 8, BLOCKS & 0o377])
    wide = one.changed[:-2] + b"\x10\0"
    for wrong in (one.changed[:-1], one.changed[:-262] + high + one.changed[-260:], wide):
        with pytest.raises(ValueError, match="blocks of a DECtape"):
            other.changed = wrong


def test_backwards_a_tape_moves_as_forwards() -> None:
    """Start, stop, start before it rests, stop, turn, stop."""
    moves = [(0, 0), (4_000_000, None), (5_000_000, 0), (8_000_000, None), (8_000_001, 1), (30_000_000, None)]
    ways: list[list[int]] = []
    for back in (0, 1):
        drive = Transport()
        drive.mount(reel())
        drive.go(0, 0)
        drive.stop(400_000_000)
        middle, began = drive.position(500_000_000), 500_000_000
        ways.append([])
        for tick, way in moves:
            if way is None:
                drive.stop(began + tick)
            else:
                drive.go(way ^ back, began + tick)
            ways[-1] += [
                abs(drive.position(began + tick + after) - middle) for after in (0, 100_000, 900_000)
            ]
    assert ways[0] == ways[1]
    assert Transport().written() is None


@pytest.mark.parametrize("stop", ["INITIALIZE", "DTXA of GO", "DTXA of function 7"])
def test_of_eight_tapes_in_motion_the_selected_one_is_stopped(stop: str) -> None:
    image, now = reel(), 10_000_000
    for unit in range(8):
        control = TC08()
        for drive in control.drives:
            drive.mount(image)
            drive.go(0, 0)
        control.a = unit << 9 | GO
        if stop == "INITIALIZE":
            control.initialize(now)
        else:
            control.pulse(4, GO if stop == "DTXA of GO" else 0o70, now)
        assert [drive.phase for drive in control.drives] == [
            STOPPING if number == unit else MOVING for number in range(8)
        ]
