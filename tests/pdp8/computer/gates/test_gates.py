"""The Teletype and DEC's flip-flops differ in nothing; with free clocks in no more than a turn of the clock."""

import pytest

from tests.pdp8.computer.gates.beside import Beside, Difference
from tests.pdp8.computer.gates.scenes import Scenes
from tests.reference.gates import UNIT
from tests.reference.model import compiler

pytestmark = pytest.mark.skipif(compiler() is None, reason="the modules are compiled from C")


def play(beside: Beside, seed: int, characters: int) -> None:
    """Play the scenes of `seed`; say what was done before the first difference."""
    scenes = Scenes(beside, seed)
    try:
        scenes.play(characters)
    except Difference as difference:
        pytest.fail("\n".join([f"seed {seed}:", *scenes.acts, str(difference)]), pytrace=False)


@pytest.mark.parametrize("seed", range(20))
def test_by_our_conventions_nothing_differs(seed: int) -> None:
    play(Beside(), seed, 100)


@pytest.mark.parametrize("eighths", (0.1, 1.7, 2.5, 3.9))
def test_with_free_clocks_a_time_differs_by_a_turn_of_the_clock(eighths: float) -> None:
    play(Beside(phase=round(eighths * UNIT / 8)), round(10 * eighths), 60)


@pytest.mark.slow(reason="100,000 characters")
@pytest.mark.parametrize("seed", range(1000, 1100))
def test_by_our_conventions_nothing_ever_differs(seed: int) -> None:
    play(Beside(), seed, 1000)
