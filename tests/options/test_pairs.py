"""Options alone and in pairs: a tenth of what `make options` tries, the same whatever others there are.

`make test` tries a quarter of it.
"""

from zlib import crc32

import pytest

from tests.conftest import case
from tests.options import inputs
from tests.options.pairs import ACT, HIDDEN, REFUSED, Pair, declared, pairs, tried
from tests.options.trial import outcome

OF_EVERY_PART = frozenset(declared()["part circle"])


@pytest.mark.parametrize("part", [0, *(pytest.param(n, marks=pytest.mark.slow("10 s")) for n in (1, 2, 3))])
def test_an_option_acts_or_is_refused_alone_and_beside_another(part: int) -> None:
    some = [pair for pair in pairs() if crc32(repr(pair).encode()) % 40 == part]
    found = {pair: tried(pair) for pair in some if not of_the_circle_too(pair)}
    assert {pair: how for pair, how in found.items() if how not in (ACT, REFUSED, HIDDEN)} == {}
    assert REFUSED in found.values()


@pytest.mark.slow("10 s")
def test_an_empty_value_is_no_fault_of_ours() -> None:
    """As a script's unset variable gives it: an exception that is no message is raised here."""
    for command in inputs.CALLS:
        for option in (each for each in declared()[command] if each.startswith("--")):
            if not of_the_circle_too(Pair(command, (option,))):
                with case(command, option):
                    line = f"{command} {inputs.CALLS[command][0]} {option}="
                    outcome(line, inputs.FILES, inputs.STDIN.get(command, b""))


def of_the_circle_too(pair: Pair) -> bool:
    """Whether `part circle` has these options, declared once for all parts."""
    part = pair.command.startswith("part ") and pair.command != "part circle"
    return part and OF_EVERY_PART.issuperset(pair.options)
