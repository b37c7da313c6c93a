"""The Hydra-Point in the page and the package's: the same moves and times, and the same refusals."""

import random
from typing import Any

import pytest

import nc
from nc.inspection import inspect
from nc.machine import CutError
from tapes import shelf
from tapes.errors import TapeError
from tests.pdp8.web.node import in_node, needs_node

pytestmark = needs_node

_CUT = """async (tapes) => {
  const { cut, pictured } = await import("@/mill/machine.mjs");
  return tapes.map((frames) => {
    const path = cut(Uint8Array.from(frames));
    const { circle } = pictured(path, 1, 500);
    return {
      steps: path.steps.map(({ at, seconds, moves }) => [at.x, at.y, at.z, seconds, moves.length]),
      error: path.error && path.error.message,
      circle: circle && [circle.x, circle.y, circle.radius, circle.lowest, circle.highest],
    };
  });
}"""


def _in_the_page(tapes: list[bytes]) -> list[dict[str, Any]]:
    found: list[dict[str, Any]] = in_node(_CUT, [list(tape) for tape in tapes])
    return found


def _here(tape: bytes) -> tuple[list[list[float]], str | None]:
    error = None
    try:
        path: nc.Path = nc.cut(tape)
    except CutError as refused:
        path, error = refused.path, str(refused)
    except TapeError as refused:
        return [], str(refused)
    steps = [
        [*step.at, sum((move.seconds for move in step.moves), path.read_seconds), len(step.moves)]
        for step in path.steps
    ]
    return steps, error


def _damaged(draw: random.Random, tape: bytes) -> bytes:
    """Return the tape with a frame lost, doubled or with other holes."""
    frame = draw.randrange(len(tape))
    middle = draw.choice([b"", tape[frame : frame + 1] * 2, draw.randbytes(1)])
    return tape[:frame] + middle + tape[frame + 1 :]


def test_tapes_good_and_damaged() -> None:
    """The circle, the ellipse, 60 damaged ones, a blank one and an empty one."""
    draw = random.Random(1971)
    whole = [shelf.read_bundled(name) for name in ("circle.eia", "ellipse.eia")]
    tapes = [*whole, *(_damaged(draw, draw.choice(whole)) for _ in range(60)), b"\0\0", b""]
    for tape, shown in zip(tapes, _in_the_page(tapes), strict=True):
        steps, error = _here(tape)
        assert shown["error"] == error
        assert len(shown["steps"]) == len(steps)
        for number, (one, other) in enumerate(zip(shown["steps"], steps, strict=True), 1):
            assert one == pytest.approx(other), f"block {number}"


def test_the_circle_is_found() -> None:
    """Centre 4.000, 4.000, radius 1.750; the cutter's centre inside and outside as inspection has it."""
    tape = shelf.read_bundled("circle.eia")
    (shown,) = _in_the_page([tape])
    x, y, radius, lowest, highest = shown["circle"]
    assert (x, y, radius) == (4000, 4000, 1750)
    assert (lowest, highest) == pytest.approx(inspect(nc.cut(tape)).centre)
