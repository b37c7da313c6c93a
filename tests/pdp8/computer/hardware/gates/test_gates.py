"""The Teletype and DEC's flip-flops differ in nothing; with free clocks, by a turn of the clock."""

import pytest

from tests.pdp8.computer.hardware.gates.beside import Beside, Difference
from tests.pdp8.computer.hardware.gates.scenes import Scenes
from tests.reference.compiling import compiler
from tests.reference.gates import PARTS, UNIT

pytestmark = pytest.mark.skipif(compiler() is None, reason="the modules are compiled from C")


def play(beside: Beside, seed: int, characters: int) -> None:
    """Play the scenes of `seed`; say what was done before the first difference."""
    scenes = Scenes(beside, seed)
    try:
        scenes.play(characters)
    except Difference as difference:
        pytest.fail("\n".join([f"seed {seed}:", *scenes.acts, str(difference)]), pytrace=False)


@pytest.mark.parametrize("seed", range(4))
def test_nothing_differs_by_a_tick(seed: int) -> None:
    play(Beside(), seed, 500)


@pytest.mark.parametrize("eighths", [0.1, 1.7, 2.5, 3.9])
def test_with_free_clocks_no_time_differs_by_more_than_a_turn_of_the_clock(eighths: float) -> None:
    play(Beside(phase=round(eighths * UNIT / 8)), round(10 * eighths), 100)


@pytest.mark.slow("100,000 characters")
@pytest.mark.parametrize("first", range(1000, 1100, 10))
def test_nothing_differs_by_a_tick_in_100_000_characters(first: int) -> None:
    for seed in range(first, first + 10):
        play(Beside(), seed, 1000)


@pytest.mark.slow("20,000 characters, a run of the clocks' phase")
@pytest.mark.parametrize("first", range(0, 32, 8))
def test_with_free_clocks_in_20_000_characters(first: int) -> None:
    for phase in range(first, first + 8):
        play(Beside(phase=round((phase + 0.01) * UNIT / 64)), phase, 625)


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
