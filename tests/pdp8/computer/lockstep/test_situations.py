"""The machine beside the reference in some situations; `make lockstep N=...` runs more."""

from collections.abc import Sequence

import pytest

from tests.pdp8.computer.lockstep.play import play
from tests.pdp8.computer.lockstep.sides import FORMS
from tests.pdp8.computer.lockstep.situations import (
    Situation,
    at_the_panel,
    at_the_teletype,
    in_the_rack,
    situation,
)
from tests.reference.compiling import compiler
from tests.sampling import some

Forms = tuple[str, ...]
LONGEST: dict[Forms, int] = {FORMS[:1]: 100_000, FORMS[1:]: 3_000}
pytestmark = [
    pytest.mark.skipif(compiler() is None, reason="the reference needs a C compiler"),
    pytest.mark.parametrize("forms", LONGEST, ids=", ".join),
]
SEEDS = 20
"""Situations of one test."""


def same(forms: Forms, seed: int, situation: Situation) -> None:
    played = play(situation, forms)
    assert not played.difference, f"seed {seed}: {played.difference}"


@pytest.mark.parametrize(
    "first",
    [0, *(pytest.param(n * SEEDS, marks=pytest.mark.slow("100 situations more")) for n in range(1, 6))],
)
def test_all_forms_and_the_reference_differ_in_nothing(forms: Forms, first: int) -> None:
    for seed in range(first, first + SEEDS):
        same(forms, seed, situation(seed, LONGEST[forms]))


@pytest.mark.parametrize(
    "seeds",
    [range(4), pytest.param(range(4, 4 + some(20)), marks=pytest.mark.slow("16,000 acts by WHOLE=1"))],
)
def test_nor_does_the_teletype_beside_its_flip_flops(forms: Forms, seeds: range) -> None:
    for seed in seeds:
        same(forms, seed, at_the_teletype(seed))


@pytest.mark.parametrize(
    "seeds",
    [
        range(4),
        pytest.param(range(4, 10 + some(250)), marks=pytest.mark.slow("50,000 keys and switches by WHOLE=1")),
    ],
)
def test_nor_does_the_panel_between_any_two_cycles(forms: Forms, seeds: range) -> None:
    for seed in seeds:
        same(forms, seed, at_the_panel(seed))


@pytest.mark.parametrize(
    "seeds",
    [
        [0, 1, 52, 135],  # CDF, JMP .-1; a field that waits after START
        pytest.param(range(2, 6 + some(200)), marks=pytest.mark.slow("2 million instructions by WHOLE=1")),
    ],
)
def test_nor_do_fields_and_data_breaks(forms: Forms, seeds: Sequence[int]) -> None:
    for seed in seeds:
        same(forms, seed, in_the_rack(seed, LONGEST[forms]))
