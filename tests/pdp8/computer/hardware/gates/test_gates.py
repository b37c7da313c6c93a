"""The Teletype and DEC's flip-flops differ in nothing."""

import pytest

from tests.pdp8.computer.hardware.gates.beside import Beside, Difference
from tests.pdp8.computer.hardware.gates.scenes import Scenes
from tests.reference.compiling import compiler
from tests.reference.gates import PARTS, UNIT

pytestmark = pytest.mark.skipif(compiler() is None, reason="the modules are compiled from C")


def play(seed: int, characters: int) -> None:
    """Play the scenes of `seed`; say what was done before the first difference."""
    scenes = Scenes(Beside(), seed)
    try:
        scenes.play(characters)
    except Difference as difference:
        pytest.fail("\n".join([f"seed {seed}:", *scenes.acts, str(difference)]), pytrace=False)


@pytest.mark.parametrize("seed", range(4))
def test_nothing_differs_by_a_tick(seed: int) -> None:
    play(seed, 500)


@pytest.mark.slow("100,000 characters")
@pytest.mark.parametrize("first", range(1000, 1100, 10))
def test_nothing_differs_by_a_tick_in_100_000_characters(first: int) -> None:
    for seed in range(first, first + 10):
        play(seed, 1000)


@pytest.mark.parametrize("unit", range(4))
@pytest.mark.parametrize("aside", range(-1, 3))
def test_a_line_that_changes_within_a_tick_of_a_shift(unit: int, aside: int) -> None:
    """INITIALIZE in a character makes the receiver begin a false one, and a key's units meet its shifts."""
    beside = Beside()
    beside.type(b"\x00")
    beside.run(1_200_000)
    beside.initialize()
    ninth_shift = 15 * UNIT
    beside.run((ninth_shift - unit * UNIT) // PARTS + aside)
    beside.type(b"\x55")
    beside.run(ninth_shift // PARTS + 10)
    beside.iot(0o6034, 0)
    beside.run(6_000_000)


@pytest.mark.parametrize("eighth", range(17, 25))
def test_a_false_start_clears_reader_run_but_once(eighth: int) -> None:
    """INITIALIZE in a space makes the receiver begin a false character; KCC comes before its first shift."""
    beside = Beside()
    beside.type(b"\x55")
    beside.run(eighth * UNIT // 8 // PARTS - 10)
    beside.initialize()
    beside.run((eighth + 1) * UNIT // 8 // PARTS)
    beside.iot(0o6032, 0)
    beside.run(6_000_000)
