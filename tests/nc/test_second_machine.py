"""Random tapes here and on the second Hydra-Point, tests/reference/hydrapoint.py: moves, times, refusals."""

import random
from collections.abc import Iterator
from fractions import Fraction

import pytest

import nc
from nc.machine import Settings
from nc.path import MoveKind, Path, Step
from tests.conftest import case
from tests.nc.tapes_1971 import tape
from tests.reference.hydrapoint import MISCELLANEOUS, SELECTS, HydraPoint, Leg, RefusedError, blocks

RAPID = (MoveKind.POSITION, MoveKind.APPROACH, MoveKind.RETRACT)
ALL_SET = ("001 9 00500 01234 0 03 89", "002 0 00000 00000 0 04 84", "003 0 00000 00000 0 01 85")


def program(draw: random.Random) -> Iterator[str]:
    """Yield random blocks, most of them good: every function, near and far places, all codes."""
    if draw.random() < 0.8:
        yield from ALL_SET
    place = [2000, 2000]
    for number in range(draw.randrange(25)):
        function = draw.choice((0, 1, 4, 5, 6, 6, 6, 7, 8, 9))
        if function == 9:
            x, y = sorted(draw.choice((0, 100, 500, 1000, 1234, 5000)) for _ in "xy")
        else:
            for axis, most in ((0, 20000), (1, 10000)):
                by = draw.choice((0, 0, 1, -1, 17, -100, 1000))
                place[axis] = draw.choice((0, most)) if draw.random() < 0.1 else place[axis] + by
                place[axis] = min(max(place[axis], 0), most)
            x, y = place
        code = draw.choice(MISCELLANEOUS)
        tool = draw.choice(SELECTS.get(code, (0, 0, 1, 24, 38)))
        yield f"{number:03} {function} {x:05} {y:05} 0 {tool:02} {code:02}"


def damaged(draw: random.Random, frames: bytes) -> bytes:
    """Return a tape with one digit of another value, or a hole more or less, or a row more or less."""
    at = draw.randrange(1, len(frames))
    row = frames[at : at + 1]
    other = draw.choice(
        (tape(str(draw.randrange(10)))[1:2], bytes([row[0] ^ 1 << draw.randrange(8)]), row * 2, b"")
    )
    return frames[:at] + other + frames[at + 1 :]


def approximately(leg: Leg) -> tuple[object, bool, object]:
    return pytest.approx([*map(float, leg.end)]), leg.rapid, pytest.approx(float(leg.seconds))


def in_force(step: Step) -> list[object]:
    modes = step.modes
    feeds = (modes.x_feed, modes.y_feed, modes.z_feed)
    quill = (modes.partial_retract, modes.feed_point, modes.final_depth)
    return [*feeds, modes.spindle, modes.tool, modes.coolant, *quill]


def judge(frames: bytes, seed: int) -> Path:
    """Run a tape on both machines, set alike; compare every block, and the one that is refused."""
    draw = random.Random(seed)
    errors = [Fraction(draw.choice((-20, -7, 0, 0, 13, 20)), 100) for _ in "XYZ"]
    second = HydraPoint(draw.choice((1000, 367, 100)), errors)
    states, refused, error = [], None, None
    try:
        for block in blocks(frames):
            second.obey(block)
            states.append((tuple(block), tuple(second.at), second.state))
    except RefusedError as caught:
        refused = caught
    x, y, z = map(float, errors)
    try:
        path = nc.cut(frames, settings=Settings((x, y, z), peck=second.peck, tool_change_seconds=8))
    except nc.CutError as caught:
        path, error = caught.path, caught
    for step, expected, (digits, at, state) in zip(path.steps, second.done, states, strict=False):
        with case(seed, step.number):
            assert (step.frame, *step.block) == digits
            legs = [((*move.end,), move.kind in RAPID, move.seconds) for move in step.moves]
            assert legs == [*map(approximately, expected)]
            assert [*step.at] == pytest.approx([*map(float, at)])
            for ours, theirs in zip(in_force(step), state, strict=True):
                assert ours == (theirs if isinstance(theirs, str | None) else pytest.approx(theirs))
    with case(seed, error, refused):
        assert len(path) == len(second.done)
        assert [step.number for step in path.steps if step.stop] == second.stops
        changes = sum(step.block.miscellaneous == 86 for step in path.steps)
        assert path.times.total == pytest.approx(float(second.seconds) + 8 * changes)
        assert [0.0, *path.clock()][-1] == pytest.approx(path.times.total)
        assert (error is None) == (refused is None)
        if error and refused:
            assert (error.block, error.row, error.frame) in refused.places
    return path


def without_parity(draw: random.Random, frames: bytes) -> bytes:
    """Return the tape after a leader of any length, one in three without parity: there a zero is blank."""
    body = bytes(frame & 0o217 for frame in frames) if draw.random() < 0.3 else frames
    return bytes(draw.randrange(30)) + body[1:] + bytes(draw.randrange(30))


@pytest.mark.parametrize("row", [1, 9, 20])
def test_every_frame_of_256_is_a_digit_or_refused(row: int) -> None:
    """As the first row, where the tape begins, within a block, and as its end, where the tape ends."""
    for frame in range(0o400):
        rows = bytearray(tape("001 0 00000 00000 0 00 80"))
        rows[row] = frame
        judge(bytes(rows), frame)


def test_random_programs_move_both_machines_alike() -> None:
    seen = set()
    for seed in range(300):
        draw = random.Random(seed)
        frames = tape(*program(draw), "999 0 00000 00000 0 00 80")
        path = judge(without_parity(draw, frames), seed)
        seen |= {(step.block.preparatory, step.block.miscellaneous) for step in path.steps}
    assert len(seen) == 8 * len(MISCELLANEOUS)


def test_damaged_tapes_stop_both_machines_at_one_block() -> None:
    refused = 0
    for seed in range(300):
        draw = random.Random(seed)
        frames = damaged(draw, tape(*ALL_SET, *program(draw)))
        path = judge(without_parity(draw, frames), seed)
        refused += len(path) < (len(frames) - 1) // 20
    assert refused > 100
