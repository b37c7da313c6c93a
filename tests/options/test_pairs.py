"""Options alone and in pairs: a sample of what `make options` tries, and the table that it wrote."""

import random

import pytest

from tests.options.pairs import ACT, BEGIN, HIDDEN, PAGE, REFUSED, declared, pairs, tried

SAMPLE = 150


@pytest.mark.slow("each option and pair is three calls of a command")
def test_an_option_acts_or_is_refused_alone_and_beside_another() -> None:
    sample = random.Random(41).sample(list(pairs()), SAMPLE)
    found = {pair: tried(pair) for pair in sample}
    assert {pair: how for pair, how in found.items() if how not in (ACT, REFUSED, HIDDEN)} == {}
    assert REFUSED in found.values()


def test_the_table_has_the_options_that_there_are() -> None:
    rows = PAGE.read_text().partition(BEGIN)[2].split("\n")
    counted = {row.split("|")[1].strip(): int(row.split("|")[2]) for row in rows if row.startswith("| `")}
    assert counted == {f"`{name}`": len(options) for name, options in declared().items() if options}


def test_there_are_no_more_commands_and_options_than_a_reader_bears() -> None:
    assert len(declared()) <= 38
    assert sum(map(len, declared().values())) <= 320
