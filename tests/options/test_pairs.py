"""Options alone and in pairs: a tenth of what `make options` tries, by a fixed seed."""

import random

from tests.options.pairs import ACT, HIDDEN, REFUSED, pairs, tried


def test_an_option_acts_or_is_refused_alone_and_beside_another() -> None:
    every = list(pairs())
    found = {pair: tried(pair) for pair in random.Random(41).sample(every, len(every) // 10)}
    assert {pair: how for pair, how in found.items() if how not in (ACT, REFUSED, HIDDEN)} == {}
    assert REFUSED in found.values()
