"""Random tapes here and on the second Hydra-Point, tests/reference/hydrapoint.py: moves, times, refusals."""

import random
from collections.abc import Iterator
from fractions import Fraction

import pytest

import nc
from nc.blocks import BlockError
from nc.machine import Settings
from nc.path import MoveKind, Path, Step
from tests.nc.tapes_1971 import tape
from tests.reference.hydrapoint import HydraPoint, Leg, RefusedError, blocks

RAPID = (MoveKind.POSITION, MoveKind.APPROACH, MoveKind.RETRACT)
CODES = {
    84: range(1, 19),
    85: range(1, 19),
    86: range(25),
    88: (*range(1, 19), *range(21, 39)),
    89: range(1, 19),
}
MISCELLANEOUS = (0, 2, 6, 7, 8, 9, 80, 81, 82, 83, 84, 85, 86, 88, 89)
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
        tool = draw.choice(CODES.get(code, (0, 0, 1, 24, 38)))
        yield f"{number:03} {function} {x:05} {y:05} 0 {tool:02} {code:02}"


def damaged(draw: random.Random, frames: bytes) -> bytes:
    """Return a tape with one digit of another value, or a hole more or less, or a row more or less."""
    at = draw.randrange(1, len(frames))
    row = frames[at : at + 1]
    other = draw.choice(
        (tape(str(draw.randrange(10)))[1:2], bytes([row[0] ^ 1 << draw.randrange(8)]), row * 2, b"")
    )
    return frames[:at] + other + frames[at + 1 :]


def legs(step: Step) -> list[tuple[tuple[float, ...], bool, float]]:
    return [((*move.end,), move.kind in RAPID, move.seconds) for move in step.moves]


def approximately(leg: Leg) -> tuple[object, bool, object]:
    return pytest.approx([float(at) for at in leg.end]), leg.rapid, pytest.approx(float(leg.seconds))


def in_force(step: Step) -> list[object]:
    modes = step.modes
    feeds = (modes.x_feed, modes.y_feed, modes.z_feed)
    quill = (modes.partial_retract, modes.feed_point, modes.final_depth)
    return [*feeds, modes.spindle, modes.tool, modes.coolant, *quill]


def settings(draw: random.Random) -> tuple[Settings, HydraPoint]:
    """Return how this machine is set, and the second one set alike."""
    errors = [Fraction(draw.choice((-20, -7, 0, 0, 13, 20)), 100) for _ in "XYZ"]
    peck = draw.choice((1000, 367, 100))
    x, y, z = map(float, errors)
    return Settings(feed_error=(x, y, z), peck=peck, tool_change_seconds=8), HydraPoint(peck, errors)


def judge(frames: bytes, seed: int) -> Path:
    """Run a tape on both machines; compare every block that is carried out, and the one that is not."""
    set_to, second = settings(random.Random(seed))
    states, refused, error = [], None, None
    try:
        for block in blocks(frames):
            second.obey(block)
            states.append((tuple(block), tuple(second.at), second.state))
    except RefusedError as caught:
        refused = caught
    try:
        path: Path = nc.cut(frames, settings=set_to)
    except nc.CutError as caught:
        path, error = caught.path, caught
    for step, expected, (digits, at, state) in zip(path.steps, second.done, states, strict=False):
        here = f"seed {seed}, block {step.number}"
        assert tuple(step.block) == digits, here
        assert legs(step) == [approximately(leg) for leg in expected], here
        assert [*step.at] == pytest.approx([float(place) for place in at]), here
        assert in_force(step) == [
            value if isinstance(value, str | None) else pytest.approx(value) for value in state
        ]
    assert len(path) == len(second.done), f"seed {seed}: {error}, {refused}"
    assert [step.number for step in path.steps if step.stop] == second.stops, seed
    changes = sum(step.block.miscellaneous == 86 for step in path.steps)
    assert path.times.total == pytest.approx(float(second.seconds) + 8 * changes), seed
    assert [0.0, *path.clock()][-1] == pytest.approx(path.times.total), seed
    assert_same_refusal(error, refused, f"seed {seed}")
    return path


def assert_same_refusal(error: BlockError | None, refused: RefusedError | None, where: str) -> None:
    assert (error and error.block) == (refused and refused.block), where
    if error and refused:
        assert error.row in refused.rows, f"{where}: {error}"
        assert error.frame is not None


def without_parity(draw: random.Random, frames: bytes) -> bytes:
    """Return the tape after a leader of any length, one in three without parity: there a zero is blank."""
    body = bytes(frame & 0o217 for frame in frames) if draw.random() < 0.3 else frames
    return bytes(draw.randrange(30)) + body[1:] + bytes(draw.randrange(30))


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
