"""The machine beside the reference in some situations; `make lockstep N=...` runs more."""

import pytest

from tests.pdp8.computer.lockstep.play import play
from tests.pdp8.computer.lockstep.shrink import shrink
from tests.pdp8.computer.lockstep.sides import ReferenceSide
from tests.pdp8.computer.lockstep.situations import Act, Situation, put, situation
from tests.pdp8.web.node import needs_node
from tests.reference.compiling import compiler

pytestmark = pytest.mark.skipif(compiler() is None, reason="the reference needs a C compiler")

SEEDS = 40
"""Situations of one test: about a second."""
LONGEST = {"compiled": 100_000, "plain": 3_000, "javascript": 3_000}


@pytest.mark.parametrize("first", range(0, 3 * SEEDS, SEEDS))
@pytest.mark.parametrize(
    "form", [form if form != "javascript" else pytest.param(form, marks=needs_node) for form in LONGEST]
)
def test_all_forms_and_the_reference_differ_in_nothing(form: str, first: int) -> None:
    for seed in range(first, first + SEEDS):
        played = play(situation(seed, LONGEST[form]), [form])
        assert not played.difference, f"seed {seed}: {played.difference}"


def test_a_difference_is_shrunk_to_what_makes_it() -> None:
    """Whatever stores AC at 0300 is taken for wrong: five words and one piece of a run are left."""
    words = dict.fromkeys(range(0o200, 0o240), 0o7000) | {0o204: 0o7001, 0o210: 0o3300, 0o211: 0o7402}
    acts = (put("pc", 0o200), Act("run", (None, 100)), put("sr", 5), Act("run", (9, 2000)))
    shrunk = shrink(Situation(True, words, acts), _stores)
    assert shrunk.acts == (put("pc", 0o200), Act("run", (None, 100)))
    assert shrunk.words == {0o204: 0o7001, 0o205: 0o7000, 0o206: 0o7000, 0o207: 0o7000, 0o210: 0o3300}


def _stores(situation: Situation) -> bool:
    side = ReferenceSide(situation)
    for act in situation.acts:
        side.do(act)
    return bool(side.reference.core[0o300] == 1)
